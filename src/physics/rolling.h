// SPDX-License-Identifier: Apache-2.0
// Rolling resistance: constant torque (model A).
//
//     M = -mu_r R* F_el w_t / |w_t|                                                   [N m]
//
// w_t is the relative spin without its part along the normal. The torque is capped at a sixteenth of
// what would stop the relative rolling within one step: a ball has up to twelve contacts, and together
// they must not turn its spin round, or a bed at rest chatters for ever.
//
// Source: Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206, 269, doi:10.1016/j.powtec.2010.09.030.
// Holds:  while rolling; a ball on a slope creeps below the angle where it should stand.
#ifndef QN_PHYSICS_ROLLING_H
#define QN_PHYSICS_ROLLING_H

#include "physics/pair.h"
#include "physics/vec3.h"

/// Torque on side a (N m). elastic: N, the spring's part of the normal force; spin: rad/s, of a
/// relative to b.
QN_FN qn_vec3 qn_rolling_torque(const qn_pair *p, double elastic, qn_vec3 normal, qn_vec3 spin)
{
    qn_vec3 rolling = qn_madd(spin, -qn_dot(spin, normal), normal);
    double rate = qn_norm(rolling);
    double torque = qn_min(p->rolling_arm * elastic, p->rolling_limit * rate);
    return qn_scale(-torque / (rate > 0 ? rate : 1), rolling);
}

#endif
