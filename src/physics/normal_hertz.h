// SPDX-License-Identifier: Apache-2.0
// Hertz spring.
//
//     F = k depth^(3/2),  k = 4/3 E* sqrt(R*)                                 [N], [N/m^1.5]
//     U = 2/5 k depth^(5/2)                                                             [J]
//
// Source: Hertz (1882), J. reine angew. Math. 92, 156-171.
// Holds:  depth << R*; no adhesion, no plasticity.
#ifndef QN_PHYSICS_NORMAL_HERTZ_H
#define QN_PHYSICS_NORMAL_HERTZ_H

#include "physics/normal.h"

static inline void qn_hertz_normal_pair(const qn_sides *s, qn_pair *p)
{
    p->normal_stiffness = 4.0 / 3 * qn_effective_young(s) * sqrt(qn_effective_radius(s));
}

QN_FN qn_normal qn_hertz_normal(const qn_pair *p, const qn_approach *a)
{
    qn_normal f;
    f.elastic = p->normal_stiffness * a->root * a->depth;
    f.energy = 0.4 * f.elastic * a->depth;
    return f;
}

#endif
