// SPDX-License-Identifier: Apache-2.0
// The ring along the shell: shoulder and toe of a charge whose ends are known.
#include "check.h"
#include "fake_mill.h"
#include "measure/ring.h"

static const double RADIUS = 0.0005;  // m

/// Balls on a fine polar grid from `toe` to `shoulder` degrees from straight down, seen with the
/// sense of rotation.
static void edges_of(double toe, double shoulder, double speed, double *found_toe,
                     double *found_shoulder)
{
    qn_world *w = fake_mill(0, speed, RADIUS, RADIUS);
    for (double rho = 0.0485; rho < 0.05; rho += 0.0003)
        for (double angle = toe; angle < shoulder; angle += 0.1) {
            double a = -QN_PI / 2 + (speed < 0 ? -1 : 1) * angle * QN_PI / 180;
            fake_add(w, rho * cos(a), rho * sin(a), 0.01, qn_v3(0, 0, 0));
        }
    qn_ring ring;
    if (qn_ring_create(w, &ring) != QN_OK) abort();
    for (int n = 0; n < 5; n++) qn_ring_sample(&ring, w);
    double bulk = qn_ring_solidity(&ring, (int)(0.5 * (toe + shoulder)) + 180);
    qn_ring_edges(&ring, bulk, found_shoulder, found_toe);
    qn_ring_free(&ring), fake_free(w);
}

static void shoulder_and_toe_are_where_the_charge_ends(void)
{
    double toe, shoulder;
    edges_of(-30.25, 77.25, 3, &toe, &shoulder);
    CHECK_NEAR(toe, -30.25, 0.6);
    CHECK_NEAR(shoulder, 77.25, 0.6);
    edges_of(-30.25, 77.25, -3, &toe, &shoulder);
    CHECK_NEAR(toe, -30.25, 0.6);
    CHECK_NEAR(shoulder, 77.25, 0.6);
    edges_of(-100, 200, 3, &toe, &shoulder);
    CHECK_NEAR(toe, -100, 0.6);
    CHECK_NEAR(shoulder, 200 - 360, 0.6);
    edges_of(-180, 180, 3, &toe, &shoulder);
    CHECK(isnan(toe) && isnan(shoulder));
}

int main(int argc, char **argv)
{
    TEST(shoulder_and_toe_are_where_the_charge_ends);
    DONE;
}
