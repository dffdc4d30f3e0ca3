// SPDX-License-Identifier: Apache-2.0
// Dashpot of constant coefficient, beside a linear spring.
//
//     F = c rate,  c = 2 zeta sqrt(m* k)                                      [N], [N s/m]
//
// Source: Cundall & Strack (1979), Geotechnique 29, 47-65, doi:10.1680/geot.1979.29.1.47;
//         restitution.h (zeta from the restitution).
// Holds:  restitution does not depend on the impact speed; beside any other spring it would.
#ifndef QN_PHYSICS_DAMPING_VISCOUS_H
#define QN_PHYSICS_DAMPING_VISCOUS_H

#include "physics/damping.h"

static inline void qn_viscous_damping_pair(const qn_sides *s, qn_pair *p)
{
    p->normal_damping =
        2 * qn_sides_damping_ratio(s) * sqrt(qn_effective_mass(s) * p->normal_stiffness);
}

QN_FN double qn_viscous_damping(const qn_pair *p, const qn_approach *a, double elastic)
{
    (void)elastic;
    return p->normal_damping * a->rate;
}

#endif
