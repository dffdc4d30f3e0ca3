// SPDX-License-Identifier: Apache-2.0
// No rolling resistance. Holds for hard, smooth, round balls.
#ifndef QN_PHYSICS_ROLLING_NONE_H
#define QN_PHYSICS_ROLLING_NONE_H

#include "physics/rolling.h"

static inline void qn_none_rolling_pair(const qn_sides *s, qn_pair *p)
{
    (void)s, (void)p;
}

QN_FN qn_rolling qn_none_rolling(const qn_pair *p, const qn_approach *a, double elastic)
{
    qn_rolling r;
    (void)p, (void)a, (void)elastic;
    r.torque = r.kept = qn_v3(0, 0, 0);
    return r;
}

#endif
