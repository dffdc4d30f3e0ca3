// SPDX-License-Identifier: Apache-2.0
// A gas of smooth inelastic balls cools as Haff's law says.
//
// Setup      512 balls of 3 mm, e = 0.9, no friction, no gravity, random velocities, in a box with elastic
//            walls at a solidity of 0.03; some 25 collisions a ball, two of Haff's times.
// Formula    T(t) = T0 / (1 + t/tau)^2,  1/tau = (1 - e^2)/6 w,  w = 24 phi g/(sqrt(pi) d) sqrt(T0), the rate
//            of collisions of a ball; T = <v^2>/3, g = (1 - phi/2)/(1 - phi)^3 at contact. phi counts the
//            volume V centres can reach, and a ball within d of a wall can't be hit from all sides: a
//            share A d/(4 V) of all contact directions lies beyond, A being the walls' area.
// Source     Haff (1983), J. Fluid Mech. 134, 401, doi:10.1017/S0022112083003419; Carnahan & Starling
//            (1969), J. Chem. Phys. 51, 635, doi:10.1063/1.1672048.
// Tolerance  5 % of 1/tau: 500 balls scatter by 2 to 3 % from seed to seed; the duration of a contact is
//            below 1 % of the time between two.
#include "evidence.h"
#include "worlds.h"

#include "base/random.h"

static const double D = 0.003, E = 0.9, SOLIDITY = 0.03;  // m, 1, 1
enum { SIDE = 8, N = SIDE * SIDE * SIDE };

static double box_side(void)
{
    return cbrt(N * QN_PI / 6 * D * D * D / SOLIDITY);
}

static qn_world *gas(void)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, E);
    def.gravity = qn_v3(0, 0, 0);
    for (int i = 1; i < 3; i++) def.contacts[i].restitution = 1;
    add_box(&def, box_side());
    qn_group_def *g = add_ball(&def, D, qn_v3(0, 0, 0), qn_v3(0, 0, 0));
    g->list_count = N;
    g->list_position = realloc(g->list_position, 3 * N * sizeof(double));
    g->list_velocity = malloc(3 * N * sizeof(double));
    double pitch = box_side() / SIDE;
    for (int i = 0; i < N; i++) {
        const int at[3] = {i % SIDE, i / SIDE % SIDE, i / SIDE / SIDE};
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;  // of twelve: nearly a normal deviate
            for (uint64_t k = 0; k < 12; k++)
                sum += qn_random(1, (uint64_t)axis * 12 + k, (uint64_t)i) - 0.5;
            g->list_position[3 * i + axis] = (at[axis] + 0.5) * pitch;
            g->list_velocity[3 * i + axis] = 0.15 * sum;
        }
    }
    def.step = 1.8e-5;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

static double temperature(const qn_world *w)
{
    double sum = 0;
    for (int i = 0; i < w->count; i++) sum += qn_dot(w->motion[i].velocity, w->motion[i].velocity);
    return sum / (3 * w->count);
}

// tau (s) by Haff, for a gas that has temperature T (m2/s2) at the start.
static double haff_time(double t)
{
    double reach = box_side() - D;  // m
    double phi = N * QN_PI / 6 * D * D * D / (reach * reach * reach);
    double g = (1 - phi / 2) / pow(1 - phi, 3);
    double shaded = 1 - 6 * D / (4 * reach);  // 1   of all contact directions, within the box
    return 6 / ((1 - E * E) * shaded * 24 * phi * g / (sqrt(QN_PI) * D) * sqrt(t));
}

static void a_granular_gas_cools_by_haffs_law(void)
{
    qn_world *w = gas();
    CHECK(w);
    CHECK_STATUS(take_steps(w, 5000));  // about a collision a ball: places and velocities of a gas
    double t0 = temperature(w), tau = haff_time(t0), start = qn_world_time(w);
    for (int k = 0; k < 8; k++) {
        CHECK_STATUS(take_steps(w, (int)(tau / 4 / w->dt)));
        double t = qn_world_time(w) - start;
        double rate = (sqrt(t0 / temperature(w)) - 1) / t;  // 1/s
        CURVE("temperature", "time / tau (1),T / T0 (1)", t / tau, temperature(w) / t0);
        if (k > 0)
            MEASURE("rate of cooling, by Haff's", where("t = %.2f tau", t / tau), rate * tau, 1,
                    0.05);
    }
    CHECK(temperature(w) < t0 / 8);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(a_granular_gas_cools_by_haffs_law);
    DONE;
}
