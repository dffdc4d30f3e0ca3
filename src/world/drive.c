// SPDX-License-Identifier: Apache-2.0
#include "world/drive.h"
#include "physics/angle.h"

/// Angle or path within a leg after `t` (s), at most its duration.
static double covered(const qn_leg *leg, double t)
{
    if (t >= leg->duration) return 0.5 * (leg->from + leg->to) * leg->duration;
    double slope = leg->from == leg->to ? 0 : (leg->to - leg->from) / leg->duration;
    return t * (leg->from + 0.5 * slope * t);
}

double qn_legs_total(const qn_leg *legs, int count, double t)
{
    double total = 0, last = 0;
    for (int i = 0; i < count && t > 0; i++) {
        total += covered(&legs[i], t);
        t -= legs[i].duration;
        last = legs[i].to;
    }
    return t > 0 ? total + last * t : total;
}

double qn_legs_speed(const qn_leg *legs, int count, double t)
{
    double last = 0;
    for (int i = 0; i < count; i++) {
        const qn_leg *leg = &legs[i];
        if (t < leg->duration) {
            if (leg->from == leg->to || t <= 0) return leg->from;
            return leg->from + (leg->to - leg->from) / leg->duration * t;
        }
        t -= leg->duration;
        last = leg->to;
    }
    return last;
}

double qn_legs_slope(const qn_leg *legs, int count, double t)
{
    for (int i = 0; i < count; i++) {
        const qn_leg *leg = &legs[i];
        if (t < leg->duration)
            return leg->from == leg->to ? 0 : (leg->to - leg->from) / leg->duration;
        t -= leg->duration;
    }
    return 0;
}

static qn_frame at_rest(void)
{
    return (qn_frame){.column = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .axis = {0, 0, 1}};
}

/// Turns a frame by an angle (rad) about its axis a: x -> x + sin K x + (1 - cos) K K x, K x = a x x
/// (Rodrigues 1840). About z it is written out, which is exact where that would round.
static void turn(qn_frame *f, double angle)
{
    double s, c;
    qn_sincos(angle, &s, &c);
    qn_vec3 a = f->axis;
    if (a.x == 0 && a.y == 0) {
        s = a.z < 0 ? -s : s;
        f->column[0] = qn_v3(c, s, 0);
        f->column[1] = qn_v3(-s, c, 0);
        return;
    }
    for (int k = 0; k < 3; k++) {
        qn_vec3 once = qn_cross(a, f->column[k]);
        f->column[k] = qn_madd(qn_madd(f->column[k], s, once), 1 - c, qn_cross(a, once));
    }
}

/// How far, how fast and with what change of speed a drive has gone.
typedef struct course {
    double way, speed, slope;
} course;

static course course_of(const qn_drive_def *d, double t)
{
    if (d->kind == QN_DRIVE_ROTATE || d->kind == QN_DRIVE_TRANSLATE)
        return (course){qn_legs_total(d->legs, d->leg_count, t),
                        qn_legs_speed(d->legs, d->leg_count, t),
                        qn_legs_slope(d->legs, d->leg_count, t)};
    if (t < d->start) return (course){0, 0, 0};
    double s, c, first, unused, omega = 2 * QN_PI * d->frequency;
    double turns = d->frequency * (t - d->start);
    qn_sincos(2 * QN_PI * (turns - floor(turns)) + d->phase, &s, &c);
    qn_sincos(d->phase, &first, &unused);
    return (course){d->amplitude * (s - first), d->amplitude * omega * c,
                    -d->amplitude * omega * omega * s};
}

qn_frame qn_drive_frame(const qn_drive_def *d, double t)
{
    qn_frame f = at_rest();
    if (d->kind == QN_DRIVE_REST || d->kind == QN_DRIVE_DRUM) return f;
    course now = course_of(d, t);
    f.moves = true;
    if (d->kind == QN_DRIVE_TRANSLATE || d->kind == QN_DRIVE_OSCILLATE) {
        f.shift = qn_scale(now.way, d->axis);
        f.velocity = qn_scale(now.speed, d->axis);
        f.accelerate = qn_scale(now.slope, d->axis);
        return f;
    }
    f.axis = d->axis;
    f.pivot = d->through;
    f.speed = now.speed;
    f.slope = now.slope;
    turn(&f, now.way);
    return f;
}

qn_frame qn_drum_frame(const qn_drum_def *drum, double t)
{
    qn_frame f = at_rest();
    f.moves = true;
    f.speed = qn_legs_speed(drum->legs, drum->leg_count, t);
    f.slope = qn_legs_slope(drum->legs, drum->leg_count, t);
    turn(&f, qn_legs_total(drum->legs, drum->leg_count, t));
    return f;
}

static qn_status check_legs(const qn_drive_def *d, const char *wall)
{
    if (d->leg_count < 1 || d->leg_count > QN_LEGS_MAX)
        return qn_fail(QN_INPUT, "wall '%s' has %d legs of speed; 1 to %d are allowed", wall,
                       d->leg_count, QN_LEGS_MAX);
    for (int i = 0; i < d->leg_count; i++) {
        const qn_leg *leg = &d->legs[i];
        bool endless = isinf(leg->duration) && leg->from != leg->to;
        if (leg->duration >= 0 && isfinite(leg->from) && isfinite(leg->to) && !endless) continue;
        return qn_fail(QN_INPUT,
                       "wall '%s': leg %d lasts %g s and goes from %g to %g; the duration must not "
                       "be negative, the speeds finite, and what lasts for ever constant",
                       wall, i + 1, leg->duration, leg->from, leg->to);
    }
    return QN_OK;
}

qn_status qn_drive_check(const qn_drive_def *d, const char *wall)
{
    if (d->kind == QN_DRIVE_REST || d->kind == QN_DRIVE_DRUM) return QN_OK;
    if (!(fabs(qn_norm(d->axis) - 1) < 1e-12) || !isfinite(qn_norm(d->through)))
        return qn_fail(QN_INPUT,
                       "wall '%s' moves along or about (%g, %g, %g) through (%g, %g, %g) m; the "
                       "first must be a unit vector, the second finite",
                       wall, d->axis.x, d->axis.y, d->axis.z, d->through.x, d->through.y,
                       d->through.z);
    if (d->kind == QN_DRIVE_ROTATE || d->kind == QN_DRIVE_TRANSLATE) return check_legs(d, wall);
    if (isfinite(d->amplitude) && d->frequency > 0 && isfinite(d->frequency) && isfinite(d->phase)
        && d->start >= 0 && isfinite(d->start))
        return QN_OK;
    return qn_fail(
        QN_INPUT,
        "wall '%s' goes to and fro by %g at %g Hz with phase %g rad from %g s on; all must "
        "be finite, the frequency above 0 and the start not negative",
        wall, d->amplitude, d->frequency, d->phase, d->start);
}

double qn_drive_fastest(const qn_drive_def *d, double far)
{
    double most = 0;
    for (int i = 0; i < d->leg_count; i++)
        most = qn_max(most, qn_max(fabs(d->legs[i].from), fabs(d->legs[i].to)));
    if (d->kind == QN_DRIVE_SWING || d->kind == QN_DRIVE_OSCILLATE)
        most = 2 * QN_PI * d->frequency * fabs(d->amplitude);
    if (d->kind == QN_DRIVE_REST || d->kind == QN_DRIVE_DRUM) return 0;
    return d->kind == QN_DRIVE_ROTATE || d->kind == QN_DRIVE_SWING ? most * far : most;
}
