// SPDX-License-Identifier: Apache-2.0
// How walls move: closed forms, and frames that agree with them.
#include "check.h"
#include "world/walls.h"

#include <stdlib.h>

/// One drive of each kind that moves, with odd axes.
static int all_drives(qn_drive_def *d)
{
    qn_vec3 axis = qn_scale(1.0 / 7, qn_v3(2, -3, 6)), through = qn_v3(0.1, -0.2, 0.05);
    const qn_leg legs[4] = {{0.5, 0, 0}, {1, 0, 3}, {0.7, 3, -1}, {INFINITY, -1, -1}};
    for (int k = 0; k < 4; k++) {
        d[k] = (qn_drive_def){.kind = (qn_drive)(QN_DRIVE_ROTATE + k),
                              .axis = axis,
                              .through = through,
                              .amplitude = 0.4,
                              .frequency = 1.7,
                              .phase = 0.6,
                              .start = 0.25,
                              .leg_count = 4};
        memcpy(d[k].legs, legs, sizeof legs);
    }
    d[4] = d[0];
    d[4].axis = qn_v3(0, 0, -1);
    d[4].through = qn_v3(0, 0, 0);
    return 5;
}

static void a_point_moves_as_its_velocity_and_acceleration_say(void)
{
    qn_drive_def drives[5];
    int count = all_drives(drives);
    const double h = 1e-4;
    for (int k = 0; k < count; k++)
        for (double t = 0.261; t < 4; t += 0.0973) {  // no leg begins within h of these
            qn_frame f = qn_drive_frame(&drives[k], t), before = qn_drive_frame(&drives[k], t - h),
                     after = qn_drive_frame(&drives[k], t + h);
            qn_vec3 own = qn_v3(0.31, 0.12, -0.4), p = qn_frame_leave(&f, own);
            qn_vec3 a = qn_frame_leave(&before, own), b = qn_frame_leave(&after, own);
            qn_vec3 v = qn_scale(0.5 / h, qn_sub(b, a));
            qn_vec3 bend = qn_scale(1 / (h * h), qn_sub(qn_add(a, b), qn_scale(2, p)));
            CHECK_NEAR(qn_norm(qn_sub(v, qn_frame_velocity(&f, p))), 0, 1e-5);
            CHECK_NEAR(qn_norm(qn_sub(bend, qn_frame_acceleration(&f, p))), 0, 1e-4);
            CHECK_NEAR(qn_norm(qn_sub(qn_frame_enter(&f, p), own)), 0, 1e-15);
        }
}

static void every_drive_begins_where_the_wall_is_defined(void)
{
    qn_drive_def drives[5];
    int count = all_drives(drives);
    qn_vec3 own = qn_v3(0.31, 0.12, -0.4);
    for (int k = 0; k < count; k++) {
        qn_frame f = qn_drive_frame(&drives[k], 0);
        CHECK_NEAR(qn_norm(qn_sub(qn_frame_leave(&f, own), own)), 0, 1e-16);
        CHECK_NEAR(qn_norm(qn_frame_velocity(&f, own)), 0, 0);
    }
}

static void ways_and_angles_are_those_of_the_formulas(void)
{
    qn_drive_def drives[5];
    all_drives(drives);
    // 0 for 0.5 s, 1.5 within 1 s, 0.7 within 0.7 s, then -1 a second.
    qn_frame f = qn_drive_frame(&drives[2], 4.2);
    CHECK_NEAR(qn_dot(f.shift, drives[2].axis), 1.5 + 0.7 - 2, 1e-15);
    CHECK_NEAR(qn_dot(f.velocity, drives[2].axis), -1, 1e-15);
    f = qn_drive_frame(&drives[3], 1e5 + 0.25 + 0.1);  // 170 000 periods later: the same
    double angle = 2 * QN_PI * 1.7 * 0.1 + 0.6;
    CHECK_NEAR(qn_dot(f.shift, drives[3].axis), 0.4 * (sin(angle) - sin(0.6)), 1e-10);
    f = qn_drive_frame(&drives[0], 4.2);  // turned by 0.2 rad about the axis
    qn_vec3 a = drives[0].axis, u = qn_v3(3, 2, 0), turned = qn_frame_turn(&f, u);
    CHECK_NEAR(qn_dot(turned, u) / 13, cos(0.2), 1e-15);
    CHECK_NEAR(qn_dot(qn_cross(u, turned), a) / 13, sin(0.2), 1e-15);
    CHECK_NEAR(qn_norm(qn_sub(qn_frame_turn(&f, a), a)), 0, 1e-15);
}

static void the_drum_is_a_body_that_turns_about_z(void)
{
    qn_drum_def drum = {.leg_count = 1, .legs = {{INFINITY, 2, 2}}};
    qn_drive_def same = {.kind = QN_DRIVE_ROTATE, .axis = {0, 0, 1}, .leg_count = 1};
    same.legs[0] = drum.legs[0];
    qn_vec3 own = qn_v3(0.31, 0.12, -0.4);
    for (double t = 0; t < 10; t += 0.37) {
        qn_frame a = qn_drum_frame(&drum, t), b = qn_drive_frame(&same, t);
        qn_vec3 p = qn_frame_leave(&a, own);
        CHECK(qn_norm(qn_sub(p, qn_frame_leave(&b, own))) == 0);
        CHECK_NEAR(p.x, 0.31 * cos(2 * t) - 0.12 * sin(2 * t), 1e-15);
        CHECK_NEAR(p.y, 0.31 * sin(2 * t) + 0.12 * cos(2 * t), 1e-15);
    }
}

static void drives_that_make_no_sense_are_refused(void)
{
    qn_drive_def d[5];
    int count = all_drives(d);
    for (int k = 0; k < count; k++) CHECK_STATUS(qn_drive_check(&d[k], "gate"));
    d[0].axis = qn_v3(0, 2, 0);
    d[1].frequency = 0;
    d[2].legs[1].duration = -1;
    d[3].amplitude = NAN;
    d[4].legs[1].duration = INFINITY;
    for (int k = 0; k < count; k++) {
        CHECK(qn_drive_check(&d[k], "gate") == QN_INPUT);
        CHECK(strstr(qn_error(), "'gate'") != NULL);
    }
    d[2].leg_count = 0;
    CHECK(qn_drive_check(&d[2], "gate") == QN_INPUT && strstr(qn_error(), "0 legs"));
}

int main(int argc, char **argv)
{
    TEST(a_point_moves_as_its_velocity_and_acceleration_say);
    TEST(every_drive_begins_where_the_wall_is_defined);
    TEST(ways_and_angles_are_those_of_the_formulas);
    TEST(the_drum_is_a_body_that_turns_about_z);
    TEST(drives_that_make_no_sense_are_refused);
    DONE;
}
