// SPDX-License-Identifier: Apache-2.0
// No tangential force: perfectly smooth contacts. Holds as an idealisation.
#ifndef QN_PHYSICS_TANGENTIAL_NONE_H
#define QN_PHYSICS_TANGENTIAL_NONE_H

#include "physics/tangential.h"

static inline void qn_none_tangential_pair(const qn_sides *s, qn_pair *p)
{
    (void)s;
    p->tangential_stiffness = p->tangential_damping = 0;
}

QN_FN qn_tangential qn_none_tangential(const qn_pair *p, const qn_approach *a, double limit)
{
    qn_tangential t;
    (void)p, (void)a, (void)limit;
    t.force = t.slip = qn_v3(0, 0, 0);
    t.energy = t.lost_dashpot = t.lost_sliding = t.residue = 0;
    return t;
}

#endif
