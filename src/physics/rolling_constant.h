// SPDX-License-Identifier: Apache-2.0
// Rolling resistance: constant torque (model A).
//
//     M = -mu_r R* F_el w_t / |w_t|                                                   [N m]
//
// Source: Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206, 269, doi:10.1016/j.powtec.2010.09.030.
// Holds:  while rolling; a ball on a slope creeps below the angle where it should stand.
#ifndef QN_PHYSICS_ROLLING_CONSTANT_H
#define QN_PHYSICS_ROLLING_CONSTANT_H

#include "physics/rolling.h"

static inline void qn_constant_rolling_pair(const qn_sides *s, qn_pair *p)
{
    p->rolling_arm = s->rolling_friction * qn_effective_radius(s);
    qn_rolling_cap(s, p);
}

QN_FN qn_rolling qn_constant_rolling(const qn_pair *p, const qn_approach *a, double elastic)
{
    return qn_rolling_against(p, a, p->rolling_arm * elastic);
}

#endif
