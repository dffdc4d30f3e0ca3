// SPDX-License-Identifier: Apache-2.0
// A ball carried round by a radial lifter: it stays on the shell above a speed and leaves it below.
//
// Setup      A drum of D = 100 mm turning at a constant speed; a ball of d = 6 mm between two straight
//            lifters whose facing sides are parallel and 20 um further apart than the ball is wide, so
//            that it is carried over the top too; no friction. Three turns, the first one not counted.
// Formula    w_c = sqrt(2 g/(D - d)): at the top the weight is just what bends the path of the ball's
//            centre, a circle of (D - d)/2. Below w_c the ball is thrown along a parabola from where
//            cos(angle from the top) = (w/w_c)^2, and comes off the shell.
// Source     Rigid mechanics; the usual critical speed of mills with the ball's size taken off the
//            drum's (Wills & Finch 2015, Wills' Mineral Processing Technology, sect. 7.3).
// Tolerance  The speed is found to 0.2 %: at 1.002 w_c the ball never leaves the shell; at 0.998 w_c it is
//            off it for longer than it takes to turn through that angle once, by more than 1 um, at
//            0.95 w_c by more than its radius. The soft contact lets the ball outwards by less than 1e-4
//            of (D - d)/2, which would shift the speed by half of that.
#include "evidence.h"
#include "worlds.h"

static const double D = 0.1, BALL = 0.006, SLACK = 2e-5;  // m

// The ball stands in its pocket at the bottom, all turning at `speed`.
static qn_world *carried(double speed)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 0.3);
    double r = (D - BALL) / 2 - 1e-6, height = 0.004, pitch = 2 * QN_PI / 40;
    double half = sin(pitch / 2), base = D * half - BALL - SLACK;
    def.drum = drum_of(D, 0.02, QN_ENDS_PERIODIC);
    add_lifters(&def.drum, 40, height, base - 2 * height * half, base);
    turn_at(&def.drum, speed);
    double x = r * half, y = -r * cos(pitch / 2);
    add_ball(&def, BALL, qn_v3(x, y, 0.01), qn_v3(-speed * y, speed * x, 0));
    def.step = 2e-5;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

// How far (m) the ball comes off the shell during two turns, and for how long (s).
static qn_status furthest_off(double share, double *off, double *time_off)
{
    double speed = share * sqrt(2 * 9.81 / (D - BALL));
    double turn = 2 * QN_PI / speed;  // s
    qn_world *w = carried(speed);
    if (!w) return QN_INPUT;
    *off = 0, *time_off = 0;
    while (qn_world_time(w) < 3 * turn) {
        QN_TRY(take_steps(w, 1));
        double gap = (D - BALL) / 2 - hypot(w->place[0].x, w->place[0].y);
        if (qn_world_time(w) < turn) continue;
        *off = qn_max(*off, gap);
        *time_off += gap > 0 ? w->dt : 0;
    }
    qn_world_destroy(w);
    return QN_OK;
}

static void a_carried_ball_stays_on_the_shell_just_above_the_critical_speed(void)
{
    const double above[] = {1.002, 1.01, 1.05};
    for (int k = 0; k < 3; k++) {
        double off, time_off;
        CHECK_STATUS(furthest_off(above[k], &off, &time_off));
        MEASURE("off the shell above critical speed (um)", where("%g of it", above[k]), 1e6 * off,
                0, 0);
        CHECK(time_off == 0);
    }
}

static void a_carried_ball_leaves_the_shell_just_below_the_critical_speed(void)
{
    const double below[] = {0.998, 0.99, 0.95}, at_least[] = {1e-6, 2e-5, 3e-3};  // 1, m
    for (int k = 0; k < 3; k++) {
        double off, time_off, thrown = acos(below[k] * below[k]) / (below[k] * 14.4);  // s
        CHECK_STATUS(furthest_off(below[k], &off, &time_off));
        double turn = 2 * QN_PI / (below[k] * 14.4);  // s
        MEASURE("off the shell below critical speed, share of the time",
                where("%g of it", below[k]), time_off / (2 * turn), 0.5 + thrown / (4 * turn),
                0.5 - thrown / (4 * turn));
        CHECK(off > at_least[k]);
        CHECK(time_off > thrown);
    }
}

int main(int argc, char **argv)
{
    TEST(a_carried_ball_stays_on_the_shell_just_above_the_critical_speed);
    TEST(a_carried_ball_leaves_the_shell_just_below_the_critical_speed);
    DONE;
}
