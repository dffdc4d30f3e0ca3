// SPDX-License-Identifier: Apache-2.0
// Tsuji's dashpot, which makes the restitution of a Hertz spring independent of the impact speed.
//
//     F = c depth^(1/4) rate,  c = sqrt(5) zeta sqrt(m* k)            [N], [N s/m^1.25]
//
// Source: Tsuji, Tanaka & Ishida (1992), Powder Technol. 71, 239, doi:10.1016/0032-5910(92)88030-L
//         (the form; their curve for the coefficient is a fit, zeta here is exact: restitution.h).
// Holds:  beside a Hertz spring.
#ifndef QN_PHYSICS_DAMPING_TSUJI_H
#define QN_PHYSICS_DAMPING_TSUJI_H

#include "physics/damping.h"

static inline void qn_tsuji_damping_pair(const qn_sides *s, qn_pair *p)
{
    p->normal_damping =
        sqrt(5.0) * qn_sides_damping_ratio(s) * sqrt(qn_effective_mass(s) * p->normal_stiffness);
}

QN_FN double qn_tsuji_damping(const qn_pair *p, const qn_approach *a, double elastic)
{
    (void)elastic;
    return p->normal_damping * a->fourth * a->rate;
}

#endif
