// SPDX-License-Identifier: Apache-2.0
// No normal damping: what comes in goes out, restitution 1. Holds always.
#ifndef QN_PHYSICS_DAMPING_NONE_H
#define QN_PHYSICS_DAMPING_NONE_H

#include "physics/damping.h"

static inline void qn_none_damping_pair(const qn_sides *s, qn_pair *p)
{
    (void)s;
    p->normal_damping = 0;
}

QN_FN double qn_none_damping(const qn_pair *p, const qn_approach *a, double elastic)
{
    (void)p, (void)a, (void)elastic;
    return 0;
}

#endif
