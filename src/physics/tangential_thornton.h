// SPDX-License-Identifier: Apache-2.0
// Mindlin's spring with force history: the tangential force stays as it is while the contact is
// pressed on, and falls with the contact radius while it is unloaded.
//
//     F_t += -k sqrt(depth) d(slip),  and F_t *= a/a_before where the contact radius a falls     [N]
//     k, c: tangential_mindlin.h;  |F_t| <= mu F_n
//
// Kept as the displacement F_t / (k sqrt(depth)): constant while unloading, and times a_before/a while
// loading. So nothing is gained on either way, and the Mindlin residue is never negative.
//
// Source: Thornton, Cummins & Cleary (2013), Powder Technol. 233, 30,
//         doi:10.1016/j.powtec.2012.08.012 (eq. 18).
// Holds:  as tangential_mindlin.h, under changing load too.
#ifndef QN_PHYSICS_TANGENTIAL_THORNTON_H
#define QN_PHYSICS_TANGENTIAL_THORNTON_H

#include "physics/tangential_mindlin.h"

static inline void qn_thornton_tangential_pair(const qn_sides *s, qn_pair *p)
{
    qn_mindlin_tangential_pair(s, p);
}

QN_FN qn_tangential qn_thornton_tangential(const qn_pair *p, const qn_approach *a, double limit)
{
    double shrink = sqrt(qn_min(a->before / qn_max(a->depth, 1e-300), 1));
    qn_vec3 held = qn_scale(shrink, a->held);
    qn_tangential t = qn_slider(p->tangential_stiffness * a->root,
                                p->tangential_damping * a->fourth, limit, held, a, p->dt);
    t.residue = fabs(qn_mindlin_residue(t.energy, a->depth, a->rate, p->dt));
    return t;
}

#endif
