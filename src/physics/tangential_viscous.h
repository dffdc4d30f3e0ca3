// SPDX-License-Identifier: Apache-2.0
// Friction by viscous damping alone.
//
//     F_t = -c slide, |F_t| <= mu F_n,  c given                               [N], [N s/m]
//
// Source: the thesis, section 4.2 (the two cases of its limit are swapped there).
// Holds:  while things slide: there is no static friction, a heap spreads for ever.
#ifndef QN_PHYSICS_TANGENTIAL_VISCOUS_H
#define QN_PHYSICS_TANGENTIAL_VISCOUS_H

#include "physics/tangential.h"

static inline void qn_viscous_tangential_pair(const qn_sides *s, qn_pair *p)
{
    p->tangential_stiffness = 0;
    p->tangential_damping = s->tangential_damping;
}

QN_FN qn_tangential qn_viscous_tangential(const qn_pair *p, const qn_approach *a, double limit)
{
    return qn_drag(p->tangential_damping, limit, a, p->dt);
}

#endif
