// SPDX-License-Identifier: Apache-2.0
// The tangential force of the reference thesis (Algorithms 5.5 and 5.7): no memory.
//
//     F_t = -k sqrt(d) slide - c d^(1/4) slide, |F_t| <= mu |F_n|                       [N]
//     k = 8 G sqrt(R*) dt: the displacement of one step, dt folded in        [N s/m^1.5]
//     c = 2 sqrt(5/6) b sqrt(8 G sqrt(R*) M*)                              [N s/m^1.25]
//
// d, R*, M*, b and the choice of the material: normal_thesis.h. Nothing is stored: what is not
// sliding is lost as in a dashpot.
// Source: the thesis, Algorithms 5.5 and 5.7, Fig 5.23.
// Holds:  beside its spring, as a means to reproduce that document; a heap does not stay at rest on
//         such friction.
#ifndef QN_PHYSICS_TANGENTIAL_THESIS_H
#define QN_PHYSICS_TANGENTIAL_THESIS_H

#include "physics/normal_thesis.h"
#include "physics/tangential.h"

static inline void qn_thesis_tangential_pair(const qn_sides *s, qn_pair *p)
{
    int soft = qn_thesis_soft_side(s);
    double shear = s->young[soft] / (2 * (1 + s->poisson[soft]));
    double k = 8 * shear * sqrt(qn_thesis_radius(s));
    p->tangential_stiffness = k * s->dt;
    p->tangential_damping =
        2 * sqrt(5.0 / 6) * qn_damping_ratio(s->restitution) * sqrt(k * qn_thesis_mass(s));
}

QN_FN qn_tangential qn_thesis_tangential(const qn_pair *p, const qn_approach *a, double limit)
{
    double root = sqrt(p->depth_scale * a->depth);
    return qn_drag(p->tangential_stiffness * root + p->tangential_damping * sqrt(root), limit, a,
                   p->dt);
}

#endif
