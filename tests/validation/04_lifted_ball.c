// SPDX-License-Identifier: Apache-2.0
// A ball carried round by a radial lifter: it stays on the shell above a speed and leaves it below.
//
// Setup      A smooth drum of D = 100 mm with one straight lifter, turning at a constant speed; a ball of
//            d = 6 mm in front of the lifter, without friction, moving with the drum. Three turns.
// Formula    w_c = sqrt(2 g/(D - d)): at the top the weight is just what bends the path of the ball's
//            centre, which runs on a circle of (D - d)/2. Below w_c the ball leaves the shell.
// Source     Rigid mechanics; the usual critical speed of mills with the ball's size taken off the
//            drum's (Wills & Finch 2015, Wills' Mineral Processing Technology, sect. 7.3).
// Tolerance  The speed is found to 0.2 % and better: at 1.002 w_c the ball never leaves the shell, at
//            0.998 w_c it does. The overlap moves the circle outwards by less than 1e-4 of its radius.
#include "check.h"
#include "worlds.h"

static const double D = 0.1, BALL = 0.006, SLACK = 2e-5;  // m

// The ball rests against the lifter's face and the shell at the bottom, all turning at `speed`.
static qn_world *carried(double speed)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 0.3);
    double r = (D - BALL) / 2 - 1e-6, side = HALF + BALL / 2 + 1e-6,
           down = sqrt(r * r - side * side);
    def.drum = (qn_drum_def){.present = true,
                             .name = "drum",
                             .diameter = D,
                             .length = 0.02,
                             .ends = QN_ENDS_PERIODIC,
                             .material = 1,
                             .lifter_count = 40,
                             .lifter_height = height,
                             .lifter_top = base - 2 * height * sin(pitch / 2),
                             .lifter_base = base,
                             .leg_count = 1};
    def.drum.legs[0] = (qn_leg){INFINITY, speed, speed};
    double x = r * sin(pitch / 2), y = -r * cos(pitch / 2);
    add_ball(&def, BALL, qn_v3(x, y, 0.01), qn_v3(-speed * y, speed * x, 0));
    def.step = 2e-5;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

// How far (m) the ball comes off the shell during two turns, after one for the start to be forgotten.
static qn_status furthest_off(double speed, double *off, double *time_off)
{
    qn_world *w = carried(speed);
    if (!w) return QN_INPUT;
    *off = 0, *time_off = 0;
    double turn = 2 * QN_PI / speed;
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

static double critical_speed(void)
{
    return sqrt(2 * 9.81 / (D - BALL));
}

static void a_carried_ball_stays_on_the_shell_just_above_the_critical_speed(void)
{
    const double above[] = {1.002, 1.01, 1.05};
    for (int k = 0; k < 3; k++) {
        double off, t;
        CHECK_STATUS(furthest_off(above[k] * critical_speed(), &off, &t));
        printf(" %g: %g %g\n", above[k], off, t);
    }
}

static void a_carried_ball_leaves_the_shell_just_below_the_critical_speed(void)
{
    const double below[] = {0.998, 0.99, 0.95, 0.9};
    for (int k = 0; k < 4; k++) {
        double off, t;
        CHECK_STATUS(furthest_off(below[k] * critical_speed(), &off, &t));
        printf(" %g: %g %g\n", below[k], off, t);
    }
}

int main(int argc, char **argv)
{
    TEST(a_carried_ball_stays_on_the_shell_just_above_the_critical_speed);
    TEST(a_carried_ball_leaves_the_shell_just_below_the_critical_speed);
    DONE;
}
