// SPDX-License-Identifier: Apache-2.0
// A sliding ball comes to roll; a rolling ball comes to rest.
//
// Setup      A ball of 3 mm standing on a plane at its equilibrium depth: (a) thrown along it at u0 = 0.1
//            m/s without spin, mu = 0.2, 0.5, 1; (b) rolling at v0 = 0.1 m/s with rolling friction; (c)
//            the same with viscous resistance; (d) let go on a slope with a rolling spring (epsd).
// Formula    (a) It slides for t = 2 u0/(7 mu g) and then rolls at u = w R = 5 u0/7.
//            (b) It slows by (5/7) mu_r g and stops after v0^2 7/(10 mu_r g); sideways nothing happens.
//            (c) v = v0 exp(-5/7 b g t) with the coefficient b.
//            (d) It stays where tan(slope) < mu_r, and rolls with 5/7 g (sin - mu_r cos) where it is more.
// Source     (a) MFIX-DEM verification, case DEM04 (Garg, Galvin, Li & Pannala 2012, NETL).
//            (b) to (d) Newton's law with the torque mu_r R F of Ai et al. (2011), doi:10.1016/j.powtec.2010.09.030.
// Tolerance  0.001 in speeds and distances: the arm is R less the overlap, 2.3e-4 of R, and the
//            tangential spring swings about the rolling speed until its dashpot has calmed it. 0.005 in
//            the time of sliding, whose end is smeared by that spring. 0.01 in the acceleration of (d),
//            which begins with the winding up of the spring; that takes some 2 um.
#include "evidence.h"
#include "worlds.h"

static const double R = 0.0015, G = 9.81;  // m, m/s2

static qn_world *on_floor(qn_rolling_model model, double friction, double rolling, double v,
                          double spin, double slope)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, friction, 0.5);
    double mass = 4.0 / 3 * QN_PI * R * R * R * 2500;
    double young = 64e6 / (1 - 0.23 * 0.23 + 1 - 0.42 * 0.42);  // Pa   effective
    double depth = pow(mass * G / (4.0 / 3 * young * sqrt(R)), 2.0 / 3);
    for (int i = 0; i < 3; i++) {
        def.contacts[i].law.rolling = model;
        def.contacts[i].rolling_friction = def.contacts[i].rolling_viscosity = rolling;
    }
    def.gravity = qn_v3(G * sin(slope), -G * cos(slope), 0);
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_ball(&def, 2 * R, qn_v3(0, R - depth, 0), qn_v3(v, 0, 0))->spin.z = spin;
    def.step = 1e-5;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

static qn_world *standing(double friction, double rolling, double v, double spin)
{
    return on_floor(QN_ROLLING_CONSTANT, friction, rolling, v, spin, 0);
}

static void a_sliding_ball_comes_to_roll_at_five_sevenths_of_its_speed(void)
{
    const double friction[] = {0.2, 0.5, 1};
    for (int k = 0; k < 3; k++) {
        double u0 = 0.1, mu = friction[k], slides = 2 * u0 / (7 * mu * G), rolls_from = 0;
        qn_world *w = standing(mu, 0, u0, 0);
        CHECK(w);
        while (qn_world_time(w) < 3 * slides) {
            CHECK_STATUS(take_steps(w, 1));
            if (w->step % 20 == 0)
                CURVE(k == 0   ? "slip0"
                      : k == 1 ? "slip1"
                               : "slip2",
                      "time (ms),speed (m/s),rim (m/s)", 1e3 * qn_world_time(w),
                      w->motion[0].velocity.x, -w->motion[0].spin.z * R);
            double surface = w->motion[0].velocity.x + w->motion[0].spin.z * R;
            if (surface < 0 && rolls_from == 0) rolls_from = qn_world_time(w);
        }
        const char *which = where("mu = %g", mu);
        MEASURE("(a) time of sliding (ms)", which, 1e3 * rolls_from, 1e3 * slides, 5 * slides);
        MEASURE("(a) speed, by the first", which, w->motion[0].velocity.x / u0, 5.0 / 7, 1e-3);
        MEASURE("(a) w R, by the first speed", which, -w->motion[0].spin.z * R / u0, 5.0 / 7, 1e-3);
        qn_world_destroy(w);
    }
}

static void a_rolling_ball_stops_after_the_distance_rolling_friction_gives(void)
{
    const double rolling[] = {0.05, 0.1};
    for (int k = 0; k < 2; k++) {
        double v0 = 0.1, distance = 7 * v0 * v0 / (10 * rolling[k] * G);
        double stops = 7 * v0 / (5 * rolling[k] * G);
        qn_world *w = standing(0.5, rolling[k], v0, -v0 / R);
        CHECK(w);
        while (qn_world_time(w) < stops / 2) CHECK_STATUS(take_steps(w, 1));
        const char *which = where("mu_r = %g", rolling[k]);
        MEASURE("(b) speed half way in time, by the first", which, w->motion[0].velocity.x / v0,
                0.5, 1e-3);
        while (qn_world_time(w) < 1.5 * stops) CHECK_STATUS(take_steps(w, 1));
        MEASURE("(b) distance rolled (mm)", where("mu_r = %g", rolling[k]), 1e3 * w->place[0].x,
                1e3 * distance, 2 * distance);
        CHECK_NEAR(w->motion[0].velocity.x / v0, 0, 1e-3);
        CHECK(w->place[0].z == 0);
        qn_world_destroy(w);
    }
}

static void a_ball_under_viscous_rolling_resistance_slows_exponentially(void)
{
    const double b = 2, v0 = 0.1;  // s/m, m/s
    qn_world *w = on_floor(QN_ROLLING_VISCOUS, 0.5, b, v0, -v0 / R, 0);
    CHECK(w);
    while (qn_world_time(w) < 0.1) CHECK_STATUS(take_steps(w, 1));
    double wanted = v0 * exp(-5.0 / 7 * b * G * qn_world_time(w));
    MEASURE("(c) speed after 0.1 s (mm/s)", "b = 2 s/m", 1e3 * w->motion[0].velocity.x,
            1e3 * wanted, 2 * wanted);
    qn_world_destroy(w);
}

static void a_rolling_spring_holds_a_ball_on_a_slope_up_to_its_angle(void)
{
    const double rolling = 0.1, slopes[] = {0.09, 0.15};  // 1, tangent
    for (int k = 0; k < 2; k++) {
        double slope = atan(slopes[k]);
        qn_world *w = on_floor(QN_ROLLING_EPSD, 0.5, rolling, 0, 0, slope);
        CHECK(w);
        while (qn_world_time(w) < 0.25) CHECK_STATUS(take_steps(w, 1));
        double from = w->place[0].x, v = w->motion[0].velocity.x;
        while (qn_world_time(w) < 0.5) CHECK_STATUS(take_steps(w, 1));
        const char *which = where("tan(slope) = %g, mu_r = %g", slopes[k], rolling);
        if (k == 0) {
            MEASURE("(d) creep in the second quarter second (m)", which, w->place[0].x - from, 0,
                    0);
            CHECK(fabs(w->place[0].x) < 0.01 * R);
        }
        double wanted = 5.0 / 7 * G * (sin(slope) - rolling * cos(slope));
        if (k == 1)
            MEASURE("(d) acceleration (m/s2)", which, (w->motion[0].velocity.x - v) / 0.25, wanted,
                    0.01 * wanted);
        qn_world_destroy(w);
    }
}

int main(int argc, char **argv)
{
    TEST(a_sliding_ball_comes_to_roll_at_five_sevenths_of_its_speed);
    TEST(a_rolling_ball_stops_after_the_distance_rolling_friction_gives);
    TEST(a_ball_under_viscous_rolling_resistance_slows_exponentially);
    TEST(a_rolling_spring_holds_a_ball_on_a_slope_up_to_its_angle);
    DONE;
}
