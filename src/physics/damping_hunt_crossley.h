// SPDX-License-Identifier: Apache-2.0
// Hunt and Crossley's damping: in proportion to the spring's own force.
//
//     F = c F_el rate,  c = x / v                                              [N], [s/m]
//
// x solves x - ln(1 + x) = -e x - ln(1 - e x): then a collision at the impact speed v has the
// restitution e. At another speed u it has that of x u / v: gentle collisions lose less, as real ones
// do. (From m w dw = -F_el (1 + c w) d(depth): both halves of the collision give the same integral of
// F_el.) Its force does not pull in a free collision, clip or not.
// Source: Hunt & Crossley (1975), J. Appl. Mech. 42, 440, doi:10.1115/1.3423596 (the form; the thesis
//         names it in section 4.3).
// Holds:  beside any spring, with restitution < 1.
#ifndef QN_PHYSICS_DAMPING_HUNT_CROSSLEY_H
#define QN_PHYSICS_DAMPING_HUNT_CROSSLEY_H

#include "physics/damping.h"

/// What the first half of the collision takes less what the second gives; 0 where x and e belong together.
static inline double qn_hunt_crossley_excess(double x, double e)
{
    return x - log1p(x) + e * x + log1p(-e * x);
}

/// x of restitution e in ]0, 1]; by bisection.
static inline double qn_hunt_crossley_number(double e)
{
    double low = 0, high = 1 / e;
    if (e >= 1) return 0;
    for (int i = 0; i < 200; i++) {
        double x = (low + high) / 2;
        if (qn_hunt_crossley_excess(x, e) > 0)
            low = x;
        else
            high = x;
    }
    return (low + high) / 2;
}

/// Restitution at x; the inverse of qn_hunt_crossley_number().
static inline double qn_hunt_crossley_restitution(double x)
{
    double low = 0, high = x > 0 ? qn_min(1, 1 / x) : 0;
    if (!(x > 0)) return 1;
    for (int i = 0; i < 200; i++) {
        double e = (low + high) / 2;
        if (qn_hunt_crossley_excess(x, e) > 0)
            low = e;
        else
            high = e;
    }
    return (low + high) / 2;
}

static inline void qn_hunt_crossley_damping_pair(const qn_sides *s, qn_pair *p)
{
    p->normal_damping = qn_hunt_crossley_number(s->restitution) / s->impact_speed;
}

QN_FN double qn_hunt_crossley_damping(const qn_pair *p, const qn_approach *a, double elastic)
{
    return p->normal_damping * elastic * a->rate;
}

#endif
