// SPDX-License-Identifier: Apache-2.0
// The verification cases of MFIX-DEM: bounces, stacked balls and oblique impacts on linear springs.
//
// Setup      DEM01: a ball of R = 0.1 m, 2600 kg/m3 falls from 0.5 m on a plane; k = 2e5 and 8e5 N/m, e = 0.6 to
//            1 (MFIX takes 1e4 to 1e5: its ball goes in by up to 0.9 R, the guard here allows 0.3 R). DEM02: the
//            same for five bounces, e = 0.8, k = 5e5, 5e6, 5e7. DEM03: two balls of R = 0.5 mm, 20 000 and
//            10 000 kg/m3, pressed between plates 1.8 mm apart, k = 1e3, e = 0.5 to 1. DEM05: r = 2.5 mm at 3.9
//            m/s on a plane, k = 1.72e7, k_t = 1.48e7, e = 0.98, mu = 0.092, where it slides (where it grips:
//            Chung & Ooi's test 4, the same experiment on Hertz's spring). DEM04 is the ball that slides and rolls.
// Formula    DEM01: free fall, damped oscillator y = R - g/w0^2 + ..., free flight. DEM02: height of bounce n
//            above the plane (h0 - R) e^(2n) for a hard ball. DEM03: Newton's equations by Runge-Kutta.
//            DEM05: e_t = 1 - mu (1 + e)/tan(th), w' = -2.5 mu (1 + e) v cos(th)/r.
// Source     Garg, Galvin, Li & Pannala (2012), Documentation of open-source MFIX-DEM software, NETL.
// Tolerance  DEM01: 1e-4 of the height: the dashpot's force sets in at once, a part of a step (2e-6 s) late,
//            up to 2 zeta w0 V dt = 1.7e-4 m/s of the rebound. DEM02: gravity acts during a soft contact, 2.5 g t/V of
//            the height at the stiffest; tenfold stiffness has to bring it sqrt(10) nearer, to 25 %. DEM03:
//            1e-5 of R, ten times what a contact that opens between two steps makes. DEM05: 1e-4 of the
//            speed; 5e-3 of the spin, the overlap over r, as the arm is r less the overlap.
#include "evidence.h"
#include "worlds.h"

static const double G = 9.81, R = 0.1, H0 = 0.5;  // m/s2, m, m

// A ball over the plane y = 0 with linear springs.
static qn_status falling(double k, double e, double dt, qn_world **w)
{
    qn_def def = def_of_materials(QN_LAW_LINEAR, 0, e);
    def.materials[0].density = 2600;
    for (int i = 0; i < 3; i++) def.contacts[i].stiffness = k, def.contacts[i].clip = false;
    def.step = dt;
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_ball(&def, 2 * R, qn_v3(0, H0, 0), qn_v3(0, 0, 0));
    qn_status status = qn_world_create(&def, 1, w);
    qn_def_free(&def);
    QN_TRY(status);
    return qn_step_begin(*w);
}

// Height (m) of the centre at a time until the second touch, for stiffness k, restitution e and mass m.
static double height_at(double t, double k, double e, double m)
{
    double zeta = -log(e) / hypot(QN_PI, log(e)), w0 = sqrt(k / m), wd = w0 * sqrt(1 - zeta * zeta);
    double fall = sqrt(2 * (H0 - R) / G), v = sqrt(2 * G * (H0 - R)), c = G / (w0 * w0);
    if (t < fall) return H0 - G * t * t / 2;
    // y - (R - c) = e^(-zeta w0 s) (c cos wd s + b sin wd s) with the speed -v at first
    double b = (zeta * w0 * c - v) / wd, s = 0, low = QN_PI / (2 * wd), high = 1.5 * QN_PI / wd;
    for (int i = 0; i < 100; i++) {
        s = (low + high) / 2;
        double y = exp(-zeta * w0 * s) * (c * cos(wd * s) + b * sin(wd * s)) - c;
        if (y < 0)
            low = s;
        else
            high = s;
    }
    double end = fall + s, u = qn_min(t, end) - fall, decay = exp(-zeta * w0 * u);
    double swing = c * cos(wd * u) + b * sin(wd * u);
    double y = R - c + decay * swing;
    double rate = decay * (-zeta * w0 * swing + wd * (b * cos(wd * u) - c * sin(wd * u)));
    return t < end ? y : y + rate * (t - end) - G * (t - end) * (t - end) / 2;
}

static void a_ball_falls_and_bounces_as_a_damped_oscillator(void)
{
    for (double k = 2e5; k < 1e6; k *= 4)
        for (double e = 0.6; e < 1.05; e += 0.1) {
            qn_world *w;
            double most = 0;
            CHECK_STATUS(falling(k, qn_min(e, 1), 2e-6, &w));
            while (qn_world_time(w) < 0.6) {
                CHECK_STATUS(take_steps(w, 250));
                double y = qn_world_position(w, 0).y, t = qn_world_time(w);
                double theory = height_at(t, k, qn_min(e, 1), w->classes[0].mass);
                most = qn_max(most, fabs(y - theory));
                if (k < 3e5 && (e < 0.65 || e > 0.95))
                    CURVE(e < 0.65 ? "soft06" : "soft10", "time (s),height (m),theory (m)", t, y,
                          theory);
            }
            MEASURE("DEM01: furthest from theory (m)", where("k = %g N/m, e = %.1f", k, e), most, 0,
                    1e-4 * H0);
            qn_world_destroy(w);
        }
}

static void a_stiff_ball_bounces_to_the_heights_of_a_hard_one(void)
{
    const double e = 0.8;
    double before = 0;
    for (double k = 5e5; k < 6e7; k *= 10) {
        qn_world *w;
        double most = 0, peak = 0;
        int bounce = 0;
        bool touched = false;
        CHECK_STATUS(falling(k, e, 1e-2 / sqrt(k), &w));
        while (bounce < 5) {
            CHECK_STATUS(take_steps(w, 1));
            bool touches = w->ledger.wall_contacts_now > 0;
            double y = qn_world_position(w, 0).y;
            if (touches && !touched && peak > 0) {
                bounce++;
                double theory = (H0 - R) * pow(e, 2 * bounce);
                CURVE(k < 1e6   ? "soft"
                      : k < 1e7 ? "medium"
                                : "stiff",
                      "bounce (1),height (m)", bounce, peak - R);
                most = qn_max(most, fabs((peak - R) / theory - 1));
            }
            if (touches) peak = R;
            if (touches || peak > 0) peak = qn_max(peak, y);
            touched = touches;
        }
        double duration = QN_PI * sqrt(w->classes[0].mass / k), v = sqrt(2 * G * (H0 - R));
        if (k > 1e7)
            MEASURE("DEM02: height of five bounces off by", where("k = %g N/m", k), most, 0,
                    2.5 * G * duration / v);
        if (before > 0)
            MEASURE("DEM02: nearer at tenfold stiffness, by sqrt(10)", where("k = %g N/m", k),
                    before / most / sqrt(10), 1, 0.25);
        before = most;
        qn_world_destroy(w);
    }
}

static const double RADIUS = 5e-4, GAP = 1.8e-3, STIFF = 1e3;  // m, m, N/m   DEM03

// Accelerations of the two balls at y with speeds v, masses m.
static void pressed(const double *y, const double *v, const double *m, double zeta, double *a)
{
    double depth[3] = {RADIUS - y[0], 2 * RADIUS - (y[1] - y[0]), RADIUS - (GAP - y[1])};
    double rate[3] = {-v[0], v[0] - v[1], v[1]}, force[3];
    double mass[3] = {m[0], m[0] * m[1] / (m[0] + m[1]), m[1]};
    for (int i = 0; i < 3; i++)
        force[i] = depth[i] > 0 ? STIFF * depth[i] + 2 * zeta * sqrt(STIFF * mass[i]) * rate[i] : 0;
    a[0] = (force[0] - force[1]) / m[0] - G;
    a[1] = (force[1] - force[2]) / m[1] - G;
}

static void runge_kutta(double *s, const double *m, double zeta, double dt)
{
    double k[4][4], at[4];
    const double part[4] = {0, 0.5, 0.5, 1};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) at[j] = s[j] + (i > 0 ? part[i] * dt * k[i - 1][j] : 0);
        k[i][0] = at[2], k[i][1] = at[3];
        pressed(at, at + 2, m, zeta, &k[i][2]);
    }
    for (int j = 0; j < 4; j++) s[j] += dt / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
}

static void two_pressed_balls_swing_as_newton_says(void)
{
    for (double e = 0.5; e < 1.05; e += 0.1) {
        qn_world *w;
        qn_def def = def_of_materials(QN_LAW_LINEAR, 0, qn_min(e, 1));
        for (int i = 0; i < 3; i++) def.contacts[i].stiffness = STIFF, def.contacts[i].clip = false;
        def.materials[0].density = 20000, def.materials[1].density = 10000;
        def.step = 1e-7;
        add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
        add_plane(&def, "lid", qn_v3(0, GAP, 0), qn_v3(0, -1, 0));
        // Placed into each other a scene is refused, so they are put there afterwards.
        add_ball(&def, 2 * RADIUS, qn_v3(0, 9e-4, 0), qn_v3(0, 0, 0));
        add_ball(&def, 2 * RADIUS, qn_v3(1.1e-3, 9e-4, 0), qn_v3(0, 0, 0))->material = 1;
        CHECK_STATUS(qn_world_create(&def, 1, &w));
        for (int i = 0; i < 2; i++) {
            w->place[i].x = 0;
            w->place[i].y = w->id[i] == 1 ? 4.5e-4 : 1.35e-3;
        }
        CHECK_STATUS(qn_step_begin(w));
        double volume = 4.0 / 3 * QN_PI * RADIUS * RADIUS * RADIUS;
        double m[2] = {20000 * volume, 10000 * volume}, s[4] = {4.5e-4, 1.35e-3, 0, 0}, most = 0;
        double zeta = e < 1 ? -log(e) / hypot(QN_PI, log(e)) : 0;
        for (int n = 1; n <= 50000; n++) {
            CHECK_STATUS(take_steps(w, 1));
            runge_kutta(s, m, zeta, w->dt);
            for (int i = 0; i < 2; i++) {
                double y = qn_world_position(w, i).y;
                most = qn_max(most, fabs(y - s[w->id[i] - 1]) / RADIUS);
            }
        }
        MEASURE("DEM03: furthest from Newton's equations, by R", where("e = %.1f", e), most, 0,
                1e-5);
        qn_world_destroy(w);
        qn_def_free(&def);
    }
}

static void a_ball_that_slides_on_linear_springs_rebounds_as_rigid_bodies(void)
{
    const double mu = 0.092, e = 0.98, v = 3.9, r = 0.0025;
    for (double degrees = 40; degrees < 86; degrees += 5) {
        qn_world *w;
        double th = degrees * QN_PI / 180;
        qn_def def = def_of_materials(QN_LAW_LINEAR, mu, e);
        def.gravity = qn_v3(0, 0, 0);
        def.materials[0].density = 4000;
        def.contacts[1].stiffness = 1.72e7, def.contacts[1].tangential_ratio = 1.48 / 1.72;
        def.step = 5e-9;
        add_plane(&def, "plate", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
        add_ball(&def, 2 * r, qn_v3(0, r + 1e-7, 0), qn_v3(v * sin(th), -v * cos(th), 0));
        CHECK_STATUS(qn_world_create(&def, 1, &w));
        for (int n = 0; n < 100 || w->ledger.wall_contacts_now > 0; n++)
            CHECK_STATUS(take_steps(w, 1));
        const char *which = where("%g deg", degrees);
        MEASURE("DEM05, sliding: tangential restitution", which,
                w->motion[0].velocity.x / (v * sin(th)), 1 - mu * (1 + e) / tan(th), 1e-4);
        MEASURE("DEM05, sliding: spin, by theory", which,
                w->motion[0].spin.z / (-2.5 * mu * (1 + e) * v * cos(th) / r), 1, 5e-3);
        qn_world_destroy(w);
        qn_def_free(&def);
    }
}

int main(int argc, char **argv)
{
    TEST(a_ball_falls_and_bounces_as_a_damped_oscillator);
    TEST(a_stiff_ball_bounces_to_the_heights_of_a_hard_one);
    TEST(two_pressed_balls_swing_as_newton_says);
    TEST(a_ball_that_slides_on_linear_springs_rebounds_as_rigid_bodies);
    DONE;
}
