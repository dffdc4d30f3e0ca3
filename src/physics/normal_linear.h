// SPDX-License-Identifier: Apache-2.0
// Linear spring-dashpot.
//
//     F = k depth + c rate                                                              [N]
//     c = 2 zeta sqrt(m* k)                                                         [N s/m]
//     U = 1/2 k depth^2                                                                 [J]
//
// Source: Cundall & Strack (1979), Geotechnique 29, 47-65, doi:10.1680/geot.1979.29.1.47.
// Holds:  any depth; contact time pi sqrt(m*/k)/sqrt(1 - zeta^2) and restitution do not depend on the
//         impact speed. k is given in the scene, not derived from the elasticity.
#ifndef QN_PHYSICS_NORMAL_LINEAR_H
#define QN_PHYSICS_NORMAL_LINEAR_H

#include "physics/normal.h"

static inline void qn_linear_normal_pair(const qn_sides *s, qn_pair *p)
{
    p->normal_stiffness = s->stiffness;
    p->normal_damping = 2 * qn_sides_damping_ratio(s) * sqrt(qn_effective_mass(s) * s->stiffness);
}

QN_FN qn_normal qn_linear_normal(const qn_pair *p, double depth, double rate)
{
    qn_normal f;
    f.elastic = p->normal_stiffness * depth;
    f.damping = p->normal_damping * rate;
    f.energy = 0.5 * f.elastic * depth;
    return f;
}

#endif
