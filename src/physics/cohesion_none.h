// SPDX-License-Identifier: Apache-2.0
// No cohesion. Holds for dry grains that weigh more than their contacts pull: mm and above.
#ifndef QN_PHYSICS_COHESION_NONE_H
#define QN_PHYSICS_COHESION_NONE_H

#include "physics/cohesion.h"

static inline void qn_none_cohesion_pair(const qn_sides *s, qn_pair *p)
{
    (void)s;
    p->pull = 0;
}

QN_FN qn_cohesion qn_none_cohesion(const qn_pair *p, const qn_approach *a)
{
    qn_cohesion c;
    (void)p, (void)a;
    c.pull = c.energy = 0;
    return c;
}

#endif
