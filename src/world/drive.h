// SPDX-License-Identifier: Apache-2.0
// How rigid walls move: where a body is at a time, and how fast, in closed form from its drive.
//
// A body turns about a fixed axis or moves along a fixed line. Its angle or path is a function of time,
// never added up step by step, so it does not drift and a resumed run finds it to the last bit. A frame is
// the answer for one moment; a wall is searched in the body's own frame, as it is defined, so that what
// is built for the search (grids) is built once.
#ifndef QN_WORLD_DRIVE_H
#define QN_WORLD_DRIVE_H

#include "physics/vec3.h"
#include "world/def.h"

/// Integral of a speed schedule up to time t (s): rad or m. After the last leg the last speed holds.
double qn_legs_total(const qn_leg *legs, int count, double t);

/// Its speed (rad/s or m/s) at time t (s), and how fast that grows (rad/s2 or m/s2).
double qn_legs_speed(const qn_leg *legs, int count, double t);
double qn_legs_slope(const qn_leg *legs, int count, double t);

/// Where a body is at one moment, and how it moves. A point x of the body as it is defined is now at
/// pivot + turn (x - pivot) + shift, the turn being the three columns.
typedef struct qn_frame {
    bool moves;           //         false for a body that never does
    qn_vec3 column[3];    // 1       what the unit vectors along x, y and z have become
    qn_vec3 axis, pivot;  // 1, m    torques are told about this line; z where nothing turns
    qn_vec3 shift;        // m
    double speed, slope;  // rad/s, rad/s2   about the axis
    qn_vec3 velocity, accelerate;  // m/s, m/s2       of the shift
} qn_frame;

/// The frame of a drive at time t (s). A drum's comes from qn_drum_frame().
qn_frame qn_drive_frame(const qn_drive_def *drive, double t);
qn_frame qn_drum_frame(const qn_drum_def *drum, double t);

/// QN_INPUT where a drive makes no sense; `wall` names it.
QN_NODISCARD qn_status qn_drive_check(const qn_drive_def *drive, const char *wall);

/// Largest speed (m/s) of a point at most `far` (m) from the axis.
double qn_drive_fastest(const qn_drive_def *drive, double far);

/// A point of the lab in the body's own frame, and back.
static inline qn_vec3 qn_frame_enter(const qn_frame *f, qn_vec3 x)
{
    if (!f->moves) return x;
    qn_vec3 u = qn_sub(qn_sub(x, f->shift), f->pivot);
    return qn_add(f->pivot,
                  qn_v3(qn_dot(f->column[0], u), qn_dot(f->column[1], u), qn_dot(f->column[2], u)));
}

/// A direction of the body in the lab.
static inline qn_vec3 qn_frame_turn(const qn_frame *f, qn_vec3 u)
{
    return qn_madd(qn_madd(qn_scale(u.x, f->column[0]), u.y, f->column[1]), u.z, f->column[2]);
}

static inline qn_vec3 qn_frame_leave(const qn_frame *f, qn_vec3 x)
{
    if (!f->moves) return x;
    return qn_add(qn_add(qn_frame_turn(f, qn_sub(x, f->pivot)), f->pivot), f->shift);
}

/// Velocity (m/s) and acceleration (m/s2) of the point of the body that is at p in the lab.
static inline qn_vec3 qn_frame_velocity(const qn_frame *f, qn_vec3 p)
{
    return qn_madd(f->velocity, f->speed, qn_cross(f->axis, qn_sub(p, f->pivot)));
}

static inline qn_vec3 qn_frame_acceleration(const qn_frame *f, qn_vec3 p)
{
    qn_vec3 round = qn_cross(f->axis, qn_sub(p, f->pivot));
    qn_vec3 inwards = qn_scale(f->speed * f->speed, qn_cross(f->axis, round));
    return qn_add(f->accelerate, qn_madd(inwards, f->slope, round));
}

#endif
