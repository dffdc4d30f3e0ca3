// SPDX-License-Identifier: Apache-2.0
// The reference thesis's spring from first principles (its section 4.1): the part of each sphere that
// would lie beyond the plane between them is taken as a bundle of independent compressed columns.
//
//     F = 2 pi E d^2,  d = depth / 2 between two spheres, depth against a wall           [N]
//     U = F depth / 3                                                                   [J]
//     E = 2 E_a E_b / (E_a + E_b), the columns of the two sides being in series        [Pa]
//
// The document has equal spheres; the wall is their mirror plane, and unlike sides are ours.
// Source: the thesis, section 4.1 (the cubic term it drops is dropped here).
// Holds:  depth below a tenth of the radius; as a comparison: it knows no Poisson's ratio, and its
//         force does not depend on the radius.
#ifndef QN_PHYSICS_NORMAL_YOUNG_H
#define QN_PHYSICS_NORMAL_YOUNG_H

#include "physics/normal.h"

static inline void qn_young_normal_pair(const qn_sides *s, qn_pair *p)
{
    double young = 2 / (1 / s->young[0] + 1 / s->young[1]);
    p->depth_scale = s->wall ? 1 : 0.5;
    p->normal_stiffness = 2 * QN_PI * young;
}

QN_FN qn_normal qn_young_normal(const qn_pair *p, const qn_approach *a)
{
    double d = p->depth_scale * a->depth;
    qn_normal f;
    f.elastic = p->normal_stiffness * d * d;
    f.energy = f.elastic * a->depth / 3;
    return f;
}

#endif
