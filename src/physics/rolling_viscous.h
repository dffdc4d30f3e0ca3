// SPDX-License-Identifier: Apache-2.0
// Rolling resistance in proportion to the rolling speed (model B).
//
//     M = -b R* F_el (R* |w_t|) w_t / |w_t|                                           [N m]
//
// R* |w_t| is the speed at which the contact point runs over the two surfaces, b (s/m) the coefficient.
// (|w_a x R_a n + w_b x R_b n|, printed in its place at times, vanishes for two equal spheres that roll
// on each other; for a ball on a wall both are R w.)
// Source: Zhou, Wright, Yang, Xu & Yu (1999), Physica A 269, 536, doi:10.1016/S0378-4371(99)00183-1;
//         model B of Ai et al. (2011), Powder Technol. 206, 269; Luding (2008), Granular Matter 10,
//         235 (the rolling speed that does not depend on the frame).
// Holds:  while rolling; nothing holds a ball at rest on a slope.
#ifndef QN_PHYSICS_ROLLING_VISCOUS_H
#define QN_PHYSICS_ROLLING_VISCOUS_H

#include "physics/rolling.h"

static inline void qn_viscous_rolling_pair(const qn_sides *s, qn_pair *p)
{
    double radius = qn_effective_radius(s);
    p->rolling_arm = s->rolling_viscosity * radius * radius;
    qn_rolling_cap(s, p);
}

QN_FN qn_rolling qn_viscous_rolling(const qn_pair *p, const qn_approach *a, double elastic)
{
    return qn_rolling_against(p, a, p->rolling_arm * elastic * qn_norm(a->rolling));
}

#endif
