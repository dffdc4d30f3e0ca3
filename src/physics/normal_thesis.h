// SPDX-License-Identifier: Apache-2.0
// The normal spring of the reference thesis (Algorithms 5.5 and 5.7), with its own convention.
//
//     F = k d^(3/2),  d = depth / 2 between two spheres, depth against a wall            [N]
//     k = 4/3 E sqrt(R*),  E = 2 (1 + nu) G, not E*                             [N/m^1.5]
//     R* = R/2 and M* = m/2 for equal spheres and for a wall alike
//
// A pair of unlike materials takes the softer one's E and nu: the document's particle-wall set is
// that of its wall.
// Source: the thesis, Algorithms 5.5 and 5.7, Figs 5.23 and 5.24.
// Holds:  as a means to reproduce that document; the spring of choice is Hertz.
#ifndef QN_PHYSICS_NORMAL_THESIS_H
#define QN_PHYSICS_NORMAL_THESIS_H

#include "physics/normal.h"

/// The side whose elasticity counts: the softer.
static inline int qn_thesis_soft_side(const qn_sides *s)
{
    return s->young[1] < s->young[0];
}

static inline double qn_thesis_radius(const qn_sides *s)
{
    return s->wall ? s->radius[0] / 2 : qn_effective_radius(s);
}

static inline double qn_thesis_mass(const qn_sides *s)
{
    return s->wall ? s->mass[0] / 2 : s->mass[0] * s->mass[1] / (s->mass[0] + s->mass[1]);
}

static inline void qn_thesis_normal_pair(const qn_sides *s, qn_pair *p)
{
    p->depth_scale = s->wall ? 1 : 0.5;
    p->normal_stiffness = 4.0 / 3 * s->young[qn_thesis_soft_side(s)] * sqrt(qn_thesis_radius(s));
}

QN_FN qn_normal qn_thesis_normal(const qn_pair *p, const qn_approach *a)
{
    double d = p->depth_scale * a->depth;
    qn_normal f;
    f.elastic = p->normal_stiffness * sqrt(d) * d;
    f.energy = 0.4 * f.elastic * a->depth;
    return f;
}

#endif
