// SPDX-License-Identifier: Apache-2.0
// Hertz spring with a dashpot that makes restitution independent of impact speed.
//
//     F = k depth^(3/2) + c depth^(1/4) rate                                            [N]
//     k = 4/3 E* sqrt(R*)                                                       [N/m^1.5]
//     c = sqrt(5) zeta sqrt(m* k)                                          [N s/m^1.25]
//     U = 2/5 k depth^(5/2)                                                             [J]
//
// Source: Hertz (1882), J. reine angew. Math. 92, 156-171 (the spring); Tsuji, Tanaka & Ishida
//         (1992), Powder Technol. 71, 239, doi:10.1016/0032-5910(92)88030-L (the dashpot's form);
//         damping.h (zeta from the restitution).
// Holds:  depth << R*; no adhesion, no plasticity.
#ifndef QN_PHYSICS_NORMAL_HERTZ_H
#define QN_PHYSICS_NORMAL_HERTZ_H

#include "physics/normal.h"

static inline void qn_hertz_normal_pair(const qn_sides *s, qn_pair *p)
{
    double k = 4.0 / 3 * qn_effective_young(s) * sqrt(qn_effective_radius(s));
    p->normal_stiffness = k;
    p->normal_damping = sqrt(5.0) * qn_sides_damping_ratio(s) * sqrt(qn_effective_mass(s) * k);
}

QN_FN qn_normal qn_hertz_normal(const qn_pair *p, double depth, double rate)
{
    double root = sqrt(depth);
    qn_normal f;
    f.elastic = p->normal_stiffness * root * depth;
    f.damping = p->normal_damping * sqrt(root) * rate;
    f.energy = 0.4 * f.elastic * depth;
    return f;
}

#endif
