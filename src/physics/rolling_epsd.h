// SPDX-License-Identifier: Apache-2.0
// Rolling resistance: elastic-plastic spring and dashpot (model C, EPSD).
//
//     M = M_k + M_d                                                                   [N m]
//     M_k -= k_r d(angle), |M_k| <= mu_r R* F_el;   k_r = 9/4 (F_el/depth) (mu_r R*)^2
//     M_d = -2 eta_r sqrt(I_r k_r) w_t, only while |M_k| is below its limit
//     1/I_r = 1/(I_a + m_a R_a^2) + 1/(I_b + m_b R_b^2)                              [kg m2]
//
// M_k is turned with the contact plane and about its normal, as the tangential displacement is. What
// the spring holds counts as lost to rolling, and comes back from there.
// Source: Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206, 269, doi:10.1016/j.powtec.2010.09.030
//         (Jiang, Yu & Harris 2005 for k_r, in its three-dimensional form).
// Holds:  at rest and rolling; a ball stands on a slope up to tan(angle) = mu_r.
#ifndef QN_PHYSICS_ROLLING_EPSD_H
#define QN_PHYSICS_ROLLING_EPSD_H

#include "physics/rolling.h"

static inline void qn_epsd_rolling_pair(const qn_sides *s, qn_pair *p)
{
    double inverse = 0;  // 1/(kg m2)
    for (int i = 0; i < 2; i++)
        if (!s->fixed[i]) inverse += 1 / (1.4 * s->mass[i] * s->radius[i] * s->radius[i]);
    p->rolling_arm = s->rolling_friction * qn_effective_radius(s);
    p->rolling_damping = inverse > 0 ? 2 * s->rolling_damping / sqrt(inverse) : 0;
}

QN_FN qn_rolling qn_epsd_rolling(const qn_pair *p, const qn_approach *a, double elastic)
{
    double limit = p->rolling_arm * elastic;
    double k = 2.25 * p->rolling_arm * limit / qn_max(a->depth, 1e-300);
    qn_vec3 moment = qn_madd(a->roll, -k, a->turn);
    double size = qn_norm(moment);
    bool yields = size > limit;
    qn_rolling r;
    r.kept = qn_scale(yields ? limit / size : 1, moment);
    r.torque = qn_madd(r.kept, yields ? 0 : -p->rolling_damping * sqrt(k), a->rolling);
    return r;
}

#endif
