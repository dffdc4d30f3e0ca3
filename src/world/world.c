// SPDX-License-Identifier: Apache-2.0
#include "world/world.h"
#include "world/bodies.h"
#include "world/classes.h"
#include "world/flow.h"
#include "world/neighbours.h"
#include "world/pack.h"
#include "world/timestep.h"
#include "world/turning.h"

#include <stdlib.h>
#include <unistd.h>

// Rounds the periodic length to the lattice that positions along it live on, so that adding or taking
// off a period is exact and a result does not depend on when a particle is wrapped.
static void choose_lattice(qn_world *w)
{
    if (!w->def.drum.present || w->def.drum.ends != QN_ENDS_PERIODIC) return;
    w->lattice = ldexp(1, ilogb(w->def.drum.length) + 1 - 50);
    w->period = floor(w->def.drum.length / w->lattice + 0.5) * w->lattice;
    w->def.drum.length = w->period;
}

static qn_status choose_step(qn_world *w)
{
    qn_timestep t = qn_timestep_of(&w->def, w->classes, w->class_count);
    w->dt = w->def.step > 0 ? w->def.step : t.suggested;
    if (!(w->dt > 0 && isfinite(w->dt)))
        return qn_fail(QN_INPUT, "time.step: none can be derived, as nothing can move; give one");
    if (w->dt > QN_RAYLEIGH_REFUSE * t.rayleigh)
        return qn_fail(QN_INPUT,
                       "time.step = %g s is %.2f of the Rayleigh time (%g s); allowed is up to %g",
                       w->dt, w->dt / t.rayleigh, t.rayleigh, QN_RAYLEIGH_REFUSE);
    return QN_OK;
}

static qn_status check_period(const qn_world *w)
{
    double least = 2 * (2 * w->largest_radius + qn_neighbours_skin(w));  // m   two reaches
    if (w->period > 0 && w->period < least)
        return qn_fail(QN_INPUT,
                       "drum.length = %g m is too short for periodic ends: a particle would meet "
                       "its own image; at least %g m",
                       w->period, least);
    for (int c = 0; c < w->class_count; c++)
        least = qn_max(least, 2 * w->classes[c].bound + qn_neighbours_skin(w));
    if (w->period > 0 && w->period < least)
        return qn_fail(QN_INPUT,
                       "drum.length = %g m is too short for periodic ends: a clump would meet "
                       "its own image; at least %g m",
                       w->period, least);
    if (w->period > 0 && w->walls.mesh_count > 0)
        return qn_fail(QN_INPUT, "walls: a mesh does not continue through periodic ends; use fixed "
                                 "or turning ends");
    return QN_OK;
}

static qn_status ledger_create(qn_world *w)
{
    w->ledger.part_count = w->walls.part_count;
    QN_TRY(QN_ALLOCATE(w->ledger.work, w->walls.part_count));
    QN_TRY(QN_ALLOCATE(w->ledger.impulse, w->walls.part_count));
    QN_TRY(QN_ALLOCATE(w->ledger.push, 3 * w->walls.part_count));
    QN_TRY(QN_ALLOCATE(w->ledger.torque_now, w->walls.part_count));
    QN_TRY(QN_ALLOCATE(w->ledger.force_now, 3 * w->walls.part_count));
    QN_TRY(QN_ALLOCATE(w->ledger.power_now, w->walls.part_count));
    w->wear.facet_count = w->walls.facet_count;
    return QN_ALLOCATE(w->wear.facets, w->walls.facet_count);
}

// Puts packed particles into the world's records, the spheres of a clump one after the other.
static qn_status settle_in(qn_world *w, const qn_seedling *seedlings, int count)
{
    QN_TRY(qn_bodies_allocate(w, seedlings, count));
    w->room = w->count;
    QN_TRY(QN_ALLOCATE(w->place, w->count));
    QN_TRY(QN_ALLOCATE(w->motion, w->count));
    QN_TRY(QN_ALLOCATE(w->load, w->count));
    QN_TRY(QN_ALLOCATE(w->id, w->count));
    int i = 0;
    for (int k = 0; k < count; k++) {
        const qn_seedling *s = &seedlings[k];
        qn_vec3 at = s->position;
        if (w->period > 0) at.z = floor(at.z / w->lattice + 0.5) * w->lattice;
        if (w->classes[s->klass].grain >= 0) {
            qn_bodies_add(w, s, k, at, &i);
            continue;
        }
        w->place[i] = (qn_place){at.x, at.y, at.z, s->klass, i};
        w->motion[i].velocity = s->velocity;
        w->motion[i].spin = s->spin;
        w->id[i] = i + 1;
        i++;
    }
    return qn_bodies_check(w);
}

// Largest distance (m) from an axis at which a wall may be touched, with room to spare.
static double lever(const qn_world *w, const qn_seedling *seedlings, int count)
{
    double far = w->def.drum.present ? w->def.drum.diameter / 2 : 0;
    for (int i = 0; i < count; i++)
        far = qn_max(far, hypot(seedlings[i].position.x, seedlings[i].position.y));
    for (int b = 1; b < w->walls.body_count; b++) {
        if (b == w->walls.drum_body) continue;
        qn_vec3 through = w->walls.drives[b].through;
        for (int i = 0; i < count; i++)
            far = qn_max(far, qn_norm(qn_sub(seedlings[i].position, through)));
    }
    double bound = 0;
    for (int c = 0; c < w->class_count; c++) bound = qn_max(bound, w->classes[c].bound);
    return 4 * (far + bound);
}

static qn_status build(qn_world *w)
{
    qn_seedling *seedlings = NULL;
    int count;
    choose_lattice(w);
    QN_TRY(qn_classes_build(&w->def, &w->classes, &w->class_count));
    QN_TRY(qn_grains_build(w));
    w->smallest_radius = INFINITY;
    for (int i = 0; i < w->class_count; i++) {
        w->largest_radius = qn_max(w->largest_radius, w->classes[i].radius);
        w->smallest_radius = qn_min(w->smallest_radius, w->classes[i].radius);
    }
    QN_TRY(choose_step(w));
    QN_TRY(qn_walls_build(&w->def, w->largest_radius, &w->walls));
    w->surface_count = w->walls.surface_count;
    QN_TRY(check_period(w));
    QN_TRY(qn_pairs_build(w));
    QN_TRY(ledger_create(w));
    QN_TRY(qn_pack(&w->def, w->classes, w->class_count, &w->walls, &seedlings, &count));
    double reach = lever(w, seedlings, count);
    qn_status status = settle_in(w, seedlings, count);
    free(seedlings);
    QN_TRY(status);
    QN_TRY(qn_flow_create(w));
    qn_units_choose(w, qn_flow_most(w), reach);
    QN_TRY(qn_turning_create(w));
    return qn_neighbours_create(w);
}

qn_status qn_world_create(qn_def *def, int threads, qn_world **world)
{
    qn_world *w;
    QN_TRY(QN_ALLOCATE(w, 1));
    w->def = *def;
    *def = qn_def_default();
    w->gravity = w->def.gravity;
    w->threads = threads > 0 ? threads : (int)sysconf(_SC_NPROCESSORS_ONLN);
    qn_status status = build(w);
    if (status != QN_OK) {
        qn_world_destroy(w);
        return status;
    }
    *world = w;
    return QN_OK;
}

double qn_walls_worn(const qn_world *w, int part, int which)
{
    const qn_walls *walls = &w->walls;
    int drum_parts = walls->has_drum ? walls->profile.count : 0;
    double sum = 0;
    for (int f = 0; f < drum_parts; f++)
        if (walls->profile.elements[f].lifter + 1 == part) sum += qn_wear_value(&w->wear, f, which);
    for (int k = 0; k < 2 && walls->has_drum && walls->drum.ends != QN_ENDS_PERIODIC; k++)
        if (walls->end_part[k] == part) sum += qn_wear_value(&w->wear, walls->end_facet + k, which);
    for (int i = 0; i < walls->plane_count; i++)
        if (walls->plane_part + i == part)
            sum += qn_wear_value(&w->wear, walls->plane_facet + i, which);
    for (int m = 0; m < walls->mesh_count; m++)
        for (int t = 0; walls->meshes[m].part == part && t < walls->meshes[m].triangle_count; t++)
            sum += qn_wear_value(&w->wear, walls->meshes[m].first_facet + t, which);
    return sum;
}

void qn_world_destroy(qn_world *w)
{
    if (!w) return;
    qn_neighbours_destroy(w->neighbours);
    qn_flow_destroy(w->flow);
    qn_walls_free(&w->walls);
    qn_def_free(&w->def);
    free(w->classes);
    free(w->laws);
    free(w->pairs);
    free(w->reaches);
    free(w->wall_laws);
    free(w->wall_pairs);
    free(w->place);
    free(w->motion);
    free(w->load);
    free(w->id);
    free(w->grains);
    free(w->bodies);
    free(w->members);
    free(w->shift);
    free(w->body_of);
    free(w->rest);
    free(w->ledger.work);
    free(w->ledger.impulse);
    free(w->ledger.push);
    free(w->ledger.torque_now);
    free(w->ledger.force_now);
    free(w->ledger.power_now);
    free(w->wear.facets);
    free(w);
}
