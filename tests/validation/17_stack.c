// SPDX-License-Identifier: Apache-2.0
// A column of balls at rest: overlap and energy of every contact, and where the energy went.
//
// Setup      Ten balls of 3 mm (64 MPa, 0.23, 2500 kg/m3), one on the other on a plane of liner, let go where
//            they just touch; e = 0.5; 0.8 s.
// Formula    The contact under k balls bears k m g: depth (k m g/k_h)^(2/3), k_h = 4/3 E* sqrt(R*), energy 2/5 F
//            depth. Gravity's energy has gone into these springs and, the rest, into the dashpots.
// Source     Hertz (1882), J. reine angew. Math. 92, 156; conservation of energy.
// Tolerance  1e-6 of depth and energy: what still swings, as the slowest swing loses a factor e^-40. 1e-3 of
//            the losses: they are summed over steps of a twentieth of a contact.
#include "evidence.h"
#include "worlds.h"

#include "measure/energy.h"

enum { N = 10 };
static const double R = 0.0015, G = 9.81;  // m, m/s2

static void a_column_of_balls_comes_to_rest_as_hertz_says(void)
{
    qn_world *w;
    qn_balance first, last;
    double y[N + 1] = {0}, mass = 4.0 / 3 * QN_PI * R * R * R * 2500, elastic = 0;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.5);
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    for (int i = 0; i < N; i++) add_ball(&def, 2 * R, qn_v3(0, (2 * i + 1) * R, 0), qn_v3(0, 0, 0));
    def.step = 1e-5;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    qn_def_free(&def);
    CHECK_STATUS(qn_step_begin(w));
    CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
    CHECK_STATUS(qn_balance_now(w, &first));
    CHECK_STATUS(qn_step_advance(w));
    CHECK_STATUS(take_steps(w, 80000));
    CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
    CHECK_STATUS(qn_balance_now(w, &last));
    for (int i = 0; i < N; i++) y[w->id[i]] = qn_world_position(w, i).y;
    for (int i = 1; i <= N; i++) {  // the contact under ball i
        double soft = (1 - 0.23 * 0.23) / 64e6, below = i == 1 ? (1 - 0.42 * 0.42) / 64e6 : soft;
        double k = 4.0 / 3 / (soft + below) * sqrt(i == 1 ? R : R / 2);
        double force = (N + 1 - i) * mass * G, depth = pow(force / k, 2.0 / 3);
        double measured = i == 1 ? R - y[1] : 2 * R - (y[i] - y[i - 1]);
        elastic += 0.4 * force * depth;
        MEASURE("overlap (nm)", where("under %d balls", N + 1 - i), 1e9 * measured, 1e9 * depth,
                1e3 * depth);
        CURVE("depth", "balls above (1),overlap (um),theory (um)", N + 1 - i, 1e6 * measured,
              1e6 * depth);
    }
    double sunk = first.gravity - last.gravity;
    MEASURE("elastic energy (nJ)", "all springs", 1e9 * last.elastic_normal, 1e9 * elastic,
            1e3 * elastic);
    MEASURE("lost in dashpots (nJ)", "by the ledger", 1e9 * (last.lost - first.lost),
            1e9 * (sunk - elastic), 1e6 * sunk);
    MEASURE("speed left (m/s)", "any ball", last.max_speed, 0, 1e-9);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(a_column_of_balls_comes_to_rest_as_hertz_says);
    DONE;
}
