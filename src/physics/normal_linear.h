// SPDX-License-Identifier: Apache-2.0
// Linear spring.
//
//     F = k depth                                                                       [N]
//     U = 1/2 k depth^2                                                                 [J]
//     k given, or (320/81 m* v^2 E*^4 R*^2)^(1/5) at the impact speed v                [N/m]
//
// The second is the ratio of largest force to largest overlap in a Hertz collision at v.
// Source: Cundall & Strack (1979), Geotechnique 29, 47-65, doi:10.1680/geot.1979.29.1.47 (the spring);
//         Di Maio & Di Renzo (2004), Chem. Eng. Sci. 59, 3461, doi:10.1016/j.ces.2004.05.014 (its
//         stiffness from the impact speed; the thesis, section 4.2).
// Holds:  any depth; the contact time does not depend on the impact speed.
#ifndef QN_PHYSICS_NORMAL_LINEAR_H
#define QN_PHYSICS_NORMAL_LINEAR_H

#include "physics/normal.h"

static inline void qn_linear_normal_pair(const qn_sides *s, qn_pair *p)
{
    double e2 = qn_effective_young(s) * qn_effective_young(s);
    double r = qn_effective_radius(s), v = s->impact_speed;
    p->normal_stiffness =
        s->stiffness > 0 ? s->stiffness
                         : pow(320.0 / 81 * qn_effective_mass(s) * v * v * e2 * e2 * r * r, 0.2);
}

QN_FN qn_normal qn_linear_normal(const qn_pair *p, const qn_approach *a)
{
    qn_normal f;
    f.elastic = p->normal_stiffness * a->depth;
    f.energy = 0.5 * f.elastic * a->depth;
    return f;
}

#endif
