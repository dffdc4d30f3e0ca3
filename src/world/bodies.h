// SPDX-License-Identifier: Apache-2.0
// The table of clumps: how it is made, and how it keeps track of its spheres.
#ifndef QN_WORLD_BODIES_H
#define QN_WORLD_BODIES_H

#include "world/pack.h"
#include "world/world.h"

/// The world's grains: its clumps' shapes in the sizes and materials of its classes.
QN_NODISCARD qn_status qn_grains_build(qn_world *world);

/// Counts the spheres of all seedlings into world->count and makes room for the clumps among them.
QN_NODISCARD qn_status qn_bodies_allocate(qn_world *world, const qn_seedling *seedlings, int count);

/// Puts seedling number `number`, a clump, at a place into the tables, its spheres from index *next on,
/// which is moved on.
void qn_bodies_add(qn_world *world, const qn_seedling *seedling, int number, qn_vec3 at, int *next);

/// QN_INPUT where a sphere of a clump that can move stands in a wall.
QN_NODISCARD qn_status qn_bodies_check(const qn_world *world);

/// How messages name a particle: "particle 7", or "particle 7 (sphere 3 of clump 5)". Returns `name`.
enum { QN_PARTICLE_NAME = 96 };
const char *qn_particle_name(const qn_world *world, int index, char name[QN_PARTICLE_NAME]);

/// Renews the indices after particles have been wrapped into the period and sorted; `to` has the new
/// index of each old one.
void qn_bodies_follow(qn_world *world, const int32_t *to);

/// The same for particles that stand in the order of their ids.
void qn_bodies_find(qn_world *world);

/// z (m) rounded to the lattice of a periodic axis; z itself without one.
static inline double qn_lattice_round(const qn_world *w, double z)
{
    double rounder = 1.5 * 0x1p52 * w->lattice;
    return w->period > 0 ? (z + rounder) - rounder : z;
}

/// Puts the spheres of a body where it is; levers[] gets the way to each from its centre (m).
static inline void qn_body_place(qn_world *w, const qn_body *b, qn_vec3 *levers)
{
    const qn_grain *g = &w->grains[b->grain];
    for (int k = 0; k < g->count; k++) {
        qn_place *p = &w->place[w->members[b->first + k]];
        levers[k] = qn_turned(b->orientation, g->lever[k]);
        p->x = b->position.x + levers[k].x;
        p->y = b->position.y + levers[k].y;
        p->z = b->position.z + qn_lattice_round(w, levers[k].z) + w->shift[b->first + k];
    }
}

#endif
