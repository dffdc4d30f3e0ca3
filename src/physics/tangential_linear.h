// SPDX-License-Identifier: Apache-2.0
// Linear tangential spring with displacement history.
//
//     F_t = -k slip - c slide, |F_t| <= mu F_n                                          [N]
//     k = (k_t/k_n) k_n                                                               [N/m]
//     c = 2 zeta sqrt(m* k)                                                         [N s/m]
//
// k_t/k_n = 2/7 gives solid spheres equal normal and tangential half periods. The slip follows
// Fazekas's recurrence (the thesis, section 4.2), with its length kept as the contact plane turns.
// Source: Cundall & Strack (1979), Geotechnique 29, 47-65, doi:10.1680/geot.1979.29.1.47;
//         Schaefer, Dippel & Wolf (1996), J. Phys. I France 6, 5, doi:10.1051/jp1:1996129.
// Holds:  any slip; beside a linear spring.
#ifndef QN_PHYSICS_TANGENTIAL_LINEAR_H
#define QN_PHYSICS_TANGENTIAL_LINEAR_H

#include "physics/tangential.h"

static inline void qn_linear_tangential_pair(const qn_sides *s, qn_pair *p)
{
    double k = s->tangential_ratio * p->normal_stiffness;
    p->tangential_stiffness = k;
    p->tangential_damping = 2 * qn_sides_damping_ratio(s) * sqrt(qn_effective_mass(s) * k);
}

QN_FN qn_tangential qn_linear_tangential(const qn_pair *p, const qn_approach *a, double limit)
{
    return qn_slider(p->tangential_stiffness, p->tangential_damping, limit, a->held, a, p->dt);
}

#endif
