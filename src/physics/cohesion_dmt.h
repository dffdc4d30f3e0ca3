// SPDX-License-Identifier: Apache-2.0
// Derjaguin, Muller and Toporov's cohesion: a constant pull while the spheres touch.
//
//     F = 4 pi gamma R*                                                                 [N]
//
// gamma (J/m2) is the energy of each of the two surfaces, 2 gamma the work of adhesion. The pull is taken
// as acting from overlap 0 on, with no reach beyond, so its potential is -F depth.
// Source: Derjaguin, Muller & Toporov (1975), J. Colloid Interface Sci. 53, 314,
//         doi:10.1016/0021-9797(75)90018-1.
// Holds:  hard, small, weakly sticking spheres (Tabor number below 0.1); beside a Hertz spring.
#ifndef QN_PHYSICS_COHESION_DMT_H
#define QN_PHYSICS_COHESION_DMT_H

#include "physics/cohesion.h"

static inline void qn_dmt_cohesion_pair(const qn_sides *s, qn_pair *p)
{
    p->pull = 4 * QN_PI * s->surface_energy * qn_effective_radius(s);
}

QN_FN qn_cohesion qn_dmt_cohesion(const qn_pair *p, const qn_approach *a)
{
    qn_cohesion c;
    c.pull = p->pull;
    c.energy = -p->pull * a->depth;
    return c;
}

#endif
