// SPDX-License-Identifier: Apache-2.0
// Where the walls are at a time, and the drum's motion: its angle is the integral of a speed that is
// linear leg by leg. Without legs the drum is at rest.
#include "world/walls.h"

double qn_drum_angle(const qn_drum_def *drum, double t)
{
    return qn_legs_total(drum->legs, drum->leg_count, t);
}

double qn_drum_speed(const qn_drum_def *drum, double t)
{
    return qn_legs_speed(drum->legs, drum->leg_count, t);
}

double qn_drum_sense(const qn_drum_def *drum)
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
    double sense = qn_drum_sense(drum), start = 0, wanted = angle, last = 0;
    for (int i = 0; i < drum->leg_count; i++) {
        const qn_leg *leg = &drum->legs[i];
        if (wanted <= 0) return start;
        double t = leg->duration > 0 ? time_within(leg, sense, wanted) : -1;
        if (t >= 0 && isfinite(t) && t <= leg->duration * (1 + 1e-12)) return start + t;
        if (isinf(leg->duration)) return INFINITY;
        wanted -= sense * 0.5 * (leg->from + leg->to) * leg->duration;
        start += leg->duration;
        last = sense * leg->to;
    }
    if (wanted <= 0) return start;
    if (last <= 0) return INFINITY;
    return start + wanted / last;
}

qn_frame qn_walls_frame(const qn_walls *walls, int body, double t)
{
    if (body == walls->drum_body) return qn_drum_frame(&walls->drum, t);
    return qn_drive_frame(&walls->drives[body], t);
}

qn_pose qn_walls_pose(const qn_walls *walls, double t)
{
    qn_pose pose;
    for (int k = 0; k < walls->body_count; k++) pose.frames[k] = qn_walls_frame(walls, k, t);
    return pose;
}
