// SPDX-License-Identifier: Apache-2.0
// The normal dashpot of the reference thesis (Algorithms 5.5 and 5.7).
//
//     F = c d^(1/4) d(depth)/dt                                                         [N]
//     c = 2 sqrt(5/6) b sqrt(2 E sqrt(R*) M*),  b = -ln e / sqrt(ln^2 e + pi^2)  [N s/m^1.25]
//
// d, E, R* and M*: normal_thesis.h. e is not the restitution that comes out (0.6577 on a flat wall
// for its 0.55).
// Source: the thesis, Algorithms 5.5 and 5.7, Fig 5.23.
// Holds:  beside its spring, as a means to reproduce that document.
#ifndef QN_PHYSICS_DAMPING_THESIS_H
#define QN_PHYSICS_DAMPING_THESIS_H

#include "physics/damping.h"
#include "physics/normal_thesis.h"

static inline void qn_thesis_damping_pair(const qn_sides *s, qn_pair *p)
{
    double young = s->young[qn_thesis_soft_side(s)];
    p->normal_damping = 2 * sqrt(5.0 / 6) * qn_damping_ratio(s->restitution)
                        * sqrt(2 * young * sqrt(qn_thesis_radius(s)) * qn_thesis_mass(s));
}

QN_FN double qn_thesis_damping(const qn_pair *p, const qn_approach *a, double elastic)
{
    (void)elastic;
    return p->normal_damping * sqrt(sqrt(p->depth_scale * a->depth)) * a->rate;
}

#endif
