// SPDX-License-Identifier: Apache-2.0
// The order of each time integration.
//
// Setup      A ball of 3 mm on a plane, on a linear spring of 10 kN/m under gravity, let go from half its
//            equilibrium depth above it, so that the contact never opens; 1.3 periods, in steps of 1/20,
//            1/40, ... 1/320 of a period; without a dashpot (e = 1) and with one (e = 0.7, no clip).
// Formula    Deviation from equilibrium A exp(-zeta w t) (cos(q t) + zeta w/q sin(q t)), w = sqrt(k/m),
//            q = w sqrt(1 - zeta^2). Order: log2 of the ratio of the errors when the step is halved.
// Source     The damped harmonic oscillator.
// Tolerance  0.1 in the order at the finest pair of steps: the next term of the error is a factor dt
//            smaller. Leapfrog and velocity Verlet are the same but for rounding: 1e-9 of the amplitude.
#include "check.h"
#include "worlds.h"

static const double R = 0.0015, G = 9.81, K = 1e4;  // m, m/s2, N/m

// Deviation from equilibrium at the end over the amplitude, and what it should be.
static double deviation(qn_scheme scheme, double e, int steps_per_period, double *wanted)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_LINEAR, 0, e);
    double mass = 4.0 / 3 * QN_PI * R * R * R * 2500, w = sqrt(K / mass), depth = mass * G / K;
    double zeta = qn_damping_ratio(e), q = w * sqrt(1 - zeta * zeta);
    int steps = 13 * steps_per_period / 10;
    for (int i = 0; i < 3; i++) def.contacts[i].stiffness = K, def.contacts[i].clip = false;
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_ball(&def, 2 * R, qn_v3(0, R - depth / 2, 0), qn_v3(0, 0, 0));
    double dt = def.step = 2 * QN_PI / w / steps_per_period;
    def.scheme = scheme;
    if (qn_world_create(&def, 1, &world) != QN_OK || take_steps(world, steps) != QN_OK) {
        printf("  %s\n", qn_error());
        return NAN;
    }
    double t = steps * dt, found = (world->place[0].y - (R - depth)) / (depth / 2);
    *wanted = exp(-zeta * w * t) * (cos(q * t) + zeta * w / q * sin(q * t));
    qn_world_destroy(world);
    qn_def_free(&def);
    return found;
}

static double order(qn_scheme scheme, double e)
{
    double before = 0, found = 0;
    for (int n = 20; n <= 320; n *= 2) {
        double wanted, error = fabs(deviation(scheme, e, n, &wanted) - wanted);
        found = log2(before / error), before = error;
    }
    return found;
}

static void every_scheme_has_its_order(void)
{
    const double orders[QN_SCHEME_COUNT] = {2, 2, 1};
    const double restitution[] = {1, 0.7};
    for (int s = 0; s < QN_SCHEME_COUNT; s++)
        for (int k = 0; k < 2; k++) {
            double found = order((qn_scheme)s, restitution[k]);
            printf("  scheme %d, e = %g: order %.3f\n", s, restitution[k], found);
            CHECK_NEAR(found, orders[s], 0.1);
        }
}

static void velocity_verlet_is_the_leapfrog_but_for_rounding(void)
{
    double wanted, one = deviation(QN_SCHEME_LEAPFROG, 0.7, 40, &wanted);
    CHECK_NEAR(deviation(QN_SCHEME_VERLET, 0.7, 40, &wanted), one, 1e-9);
}

static void forward_euler_gains_energy_and_leapfrog_does_not(void)
{
    // Two spheres meet head-on without losses, 40 steps in the contact, at 32 phases of the first step.
    const double gain[QN_SCHEME_COUNT] = {0, 0, 0.15};
    for (int s = 0; s < QN_SCHEME_COUNT; s++) {
        double sum = 0;
        for (int phase = 0; phase < 32; phase++) {
            qn_world *w = NULL;
            qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 1);
            double mass = 4.0 / 3 * QN_PI * R * R * R * 2500, v = 0.5;
            double young = 64e6 / (2 * (1 - 0.23 * 0.23));  // Pa   effective
            double k = 4.0 / 3 * young * sqrt(R / 2);
            def.step = qn_impact_time(k, 1.5, mass / 2, 2 * v, NULL) / 40;
            double away = R + v * def.step * (1 + phase / 32.0);
            def.gravity = qn_v3(0, 0, 0);
            def.scheme = (qn_scheme)s;
            add_ball(&def, 2 * R, qn_v3(-away, 0, 0), qn_v3(v, 0, 0));
            add_ball(&def, 2 * R, qn_v3(away, 0, 0), qn_v3(-v, 0, 0));
            CHECK_STATUS(qn_world_create(&def, 1, &w));
            CHECK_STATUS(take_steps(w, 60));
            sum += fabs(w->motion[0].velocity.x) / v - 1;
            qn_world_destroy(w);
            qn_def_free(&def);
        }
        printf("  scheme %d: mean gain of speed %.4f\n", s, sum / 32);
        CHECK_NEAR(sum / 32, gain[s], 0.01);
    }
}

int main(int argc, char **argv)
{
    TEST(every_scheme_has_its_order);
    TEST(velocity_verlet_is_the_leapfrog_but_for_rounding);
    TEST(forward_euler_gains_energy_and_leapfrog_does_not);
    DONE;
}
