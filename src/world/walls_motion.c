// SPDX-License-Identifier: Apache-2.0
// The drum's motion in closed form: its angle is the integral of a speed that is linear leg by leg.
//
// After the last leg the last speed holds; without legs the drum is at rest.
#include "physics/angle.h"
#include "world/walls.h"

/// Angle (rad) turned within a leg after `t` (s), at most its duration.
static double turned(const qn_leg *leg, double t)
{
    if (t >= leg->duration) return 0.5 * (leg->from + leg->to) * leg->duration;
    double slope = leg->from == leg->to ? 0 : (leg->to - leg->from) / leg->duration;  // rad/s2
    return t * (leg->from + 0.5 * slope * t);
}

double qn_drum_angle(const qn_drum_def *drum, double t)
{
    double angle = 0, last = 0;
    for (int i = 0; i < drum->leg_count && t > 0; i++) {
        const qn_leg *leg = &drum->legs[i];
        angle += turned(leg, t);
        t -= leg->duration;
        last = leg->to;
    }
    return t > 0 ? angle + last * t : angle;
}

double qn_drum_speed(const qn_drum_def *drum, double t)
{
    double last = 0;
    for (int i = 0; i < drum->leg_count; i++) {
        const qn_leg *leg = &drum->legs[i];
        if (t < leg->duration) {
            if (leg->from == leg->to || t <= 0) return leg->from;
            return leg->from + (leg->to - leg->from) / leg->duration * t;
        }
        t -= leg->duration;
        last = leg->to;
    }
    return last;
}

/// Sense of rotation (+1, -1): that of the last speed that is not zero.
static double final_sense(const qn_drum_def *drum)
{
    for (int i = drum->leg_count - 1; i >= 0; i--) {
        if (drum->legs[i].to != 0) return drum->legs[i].to < 0 ? -1 : 1;
        if (drum->legs[i].from != 0) return drum->legs[i].from < 0 ? -1 : 1;
    }
    return 1;
}

/// First time (s) within a leg at which it has turned by `wanted` > 0 (rad) in the sense given;
/// INFINITY if it does not. The root of from t + slope t^2 / 2 = wanted without cancellation.
static double time_within(const qn_leg *leg, double sense, double wanted)
{
    double from = sense * leg->from, to = sense * leg->to;
    double slope = from == to ? 0 : (to - from) / leg->duration;
    double root2 = from * from + 2 * slope * wanted;
    if (root2 < 0) {
        if (root2 < -1e-12 * from * from) return INFINITY;
        root2 = 0;
    }
    double below = from + sqrt(root2);
    if (below <= 0) return INFINITY;
    return 2 * wanted / below;
}

double qn_drum_time(const qn_drum_def *drum, double angle)
{
    double sense = final_sense(drum), start = 0, wanted = angle, last = 0;
    for (int i = 0; i < drum->leg_count; i++) {
        const qn_leg *leg = &drum->legs[i];
        if (wanted <= 0) return start;
        double t = leg->duration > 0 ? time_within(leg, sense, wanted) : -1;
        if (t >= 0 && isfinite(t) && t <= leg->duration * (1 + 1e-12)) return start + t;
        if (isinf(leg->duration)) return INFINITY;
        wanted -= sense * turned(leg, leg->duration);
        start += leg->duration;
        last = sense * leg->to;
    }
    if (wanted <= 0) return start;
    if (last <= 0) return INFINITY;
    return start + wanted / last;
}

qn_pose qn_walls_pose(const qn_walls *walls, double t)
{
    qn_pose pose = {1, 0, 0};
    if (!walls->has_drum) return pose;
    qn_sincos(qn_drum_angle(&walls->drum, t), &pose.sine, &pose.cosine);
    pose.speed = qn_drum_speed(&walls->drum, t);
    return pose;
}
