// SPDX-License-Identifier: Apache-2.0
#include "world/bodies.h"
#include "base/random.h"
#include "world/classes.h"

#include <stdio.h>

enum { STREAM_TURN = 3 };

static qn_vec3 inverse(qn_vec3 v)
{
    return qn_v3(1 / v.x, 1 / v.y, 1 / v.z);
}

// A grain of a class, the first of its size; `others`: the first of the classes of its other radii.
static void build_grain(const qn_world *w, int klass, int others, qn_grain *g)
{
    const qn_class *c = &w->classes[klass];
    const qn_group_def *group = &w->def.groups[c->group];
    const qn_shape *s = &w->def.shapes[group->shape - 1];
    double r = group->diameter[c->size] / 2;
    int which[QN_SPHERES_MAX];
    qn_radii_of(&w->def, group, which);
    g->shape = group->shape - 1;
    g->count = s->count;
    g->radius = r;
    g->bound = c->bound;
    g->mass = c->mass;
    g->inverse_mass = c->inverse_mass;
    g->moments = qn_scale(r, qn_scale(r, qn_scale(c->mass, s->moment)));
    if (g->inverse_mass > 0) g->inverse_moments = inverse(g->moments);
    g->is_round = s->is_round;
    for (int k = 0; k < s->count; k++) {
        g->klass[k] = which[k] == 0 ? klass : others + which[k] - 1;
        g->lever[k] =
            qn_scale(r, qn_v3(s->centre[3 * k], s->centre[3 * k + 1], s->centre[3 * k + 2]));
    }
}

qn_status qn_grains_build(qn_world *w)
{
    int firsts = 0, klass = 0;  // classes that are a size of a group
    for (int k = 0; k < w->def.group_count; k++) {
        firsts += w->def.groups[k].size_count;
        if (w->def.groups[k].shape) w->grain_count += w->def.groups[k].size_count;
    }
    QN_TRY(QN_ALLOCATE(w->grains, w->grain_count));
    int others = firsts;
    for (; klass < firsts; klass++) {
        const qn_class *c = &w->classes[klass];
        if (c->grain < 0) continue;
        build_grain(w, klass, others, &w->grains[c->grain]);
        others += qn_radii_of(&w->def, &w->def.groups[c->group], NULL) - 1;
    }
    return QN_OK;
}

qn_status qn_bodies_allocate(qn_world *w, const qn_seedling *seedlings, int count)
{
    int64_t total = 0;
    for (int k = 0; k < count; k++) {
        int grain = w->classes[seedlings[k].klass].grain;
        total += grain < 0 ? 1 : w->grains[grain].count;
        if (grain < 0) continue;
        w->body_count++;
        w->member_count += w->grains[grain].count;
    }
    if (total > INT32_MAX / 4)
        return qn_fail(QN_INPUT, "particles: %lld spheres are too many, at most %d fit one machine",
                       (long long)total, INT32_MAX / 4);
    w->count = (int)total;
    if (w->body_count == 0) return QN_OK;
    QN_TRY(QN_ALLOCATE(w->bodies, w->body_count));
    QN_TRY(QN_ALLOCATE(w->members, w->member_count));
    QN_TRY(QN_ALLOCATE(w->shift, w->member_count));
    QN_TRY(QN_ALLOCATE(w->body_of, w->count));
    for (int i = 0; i < w->count; i++) w->body_of[i] = -1;
    w->body_count = w->member_count = 0;  // counted again as they are added
    return QN_OK;
}

// An orientation at random, all alike. Shoemake (1992), Graphics Gems III, 124.
static qn_quat random_turn(uint64_t seed, uint64_t number)
{
    double u = qn_random(seed, STREAM_TURN, 3 * number), s1, c1, s2, c2;
    qn_sincos(2 * QN_PI * qn_random(seed, STREAM_TURN, 3 * number + 1), &s1, &c1);
    qn_sincos(2 * QN_PI * qn_random(seed, STREAM_TURN, 3 * number + 2), &s2, &c2);
    return qn_quat_of(sqrt(u) * c2, sqrt(1 - u) * s1, sqrt(1 - u) * c1, sqrt(u) * s2);
}

void qn_bodies_add(qn_world *w, const qn_seedling *s, int number, qn_vec3 at, int *next)
{
    const qn_class *c = &w->classes[s->klass];
    const qn_group_def *group = &w->def.groups[c->group];
    const qn_grain *g = &w->grains[c->grain];
    qn_body *b = &w->bodies[w->body_count];
    qn_vec3 levers[QN_SPHERES_MAX];
    qn_quat turn = group->turned_at_random ? random_turn(w->def.seed, (uint64_t)number)
                                           : qn_quat_of_vector(group->turned);
    *b = (qn_body){.id = *next + 1,
                   .grain = c->grain,
                   .first = w->member_count,
                   .position = at,
                   .orientation = qn_quat_unit(qn_quat_mul(turn, w->def.shapes[g->shape].axes)),
                   .velocity = s->velocity,
                   .spin = s->spin};
    b->momentum = qn_tensor_times(b->orientation, g->moments, s->spin);
    for (int k = 0; k < g->count; k++) {
        int i = *next + k;
        w->members[b->first + k] = i;
        w->body_of[i] = w->body_count;
        w->place[i] = (qn_place){0, 0, 0, g->klass[k], i};
        w->id[i] = i + 1;
    }
    qn_body_place(w, b, levers);
    for (int k = 0; k < g->count; k++) {
        w->motion[*next + k].velocity = qn_add(s->velocity, qn_cross(s->spin, levers[k]));
        w->motion[*next + k].spin = s->spin;
    }
    *next += g->count;
    w->member_count += g->count;
    w->body_count++;
}

qn_status qn_bodies_check(const qn_world *w)
{
    qn_pose pose = qn_walls_pose(&w->walls, 0);
    for (int i = 0; w->body_of && i < w->count; i++) {
        const qn_class *c = &w->classes[w->place[i].klass];
        if (c->grain < 0 || c->inverse_mass <= 0) continue;
        qn_vec3 x = qn_world_position(w, i);
        double clear = qn_walls_clearance(&w->walls, &pose, x);
        if (clear >= c->radius * (1 - QN_OVERLAP_WARN)) continue;
        return qn_fail(
            QN_INPUT,
            "particles.%s: a sphere of a clump at (%g, %g, %g) m with radius %g m stands "
            "%g m deep in a wall",
            w->def.groups[c->group].name, x.x, x.y, x.z, c->radius, c->radius - clear);
    }
    return QN_OK;
}

const char *qn_particle_name(const qn_world *w, int i, char name[QN_PARTICLE_NAME])
{
    int body = qn_body_of(w, i);
    long long id = w->id[i], of = body < 0 ? id : w->bodies[body].id;
    if (body < 0)
        snprintf(name, QN_PARTICLE_NAME, "particle %lld", id);
    else
        snprintf(name, QN_PARTICLE_NAME, "particle %lld (sphere %lld of clump %lld)", id,
                 id - of + 1, of);
    return name;
}

// Which body each sphere belongs to, from the bodies' indices of their spheres.
static void mark_spheres(qn_world *w)
{
    for (int i = 0; i < w->count; i++) w->body_of[i] = -1;
    for (int b = 0; b < w->body_count; b++)
        for (int k = 0; k < w->grains[w->bodies[b].grain].count; k++)
            w->body_of[w->members[w->bodies[b].first + k]] = b;
}

// A body is wrapped as its centre, its spheres each on their own: what lies between is a whole number of
// periods, and exact, as everything along the axis is a multiple of the lattice.
static void wrap(qn_world *w, qn_body *b)
{
    b->position.z = qn_body_position(w, b).z;
    for (int k = 0; k < w->grains[b->grain].count; k++) {
        double along = qn_lattice_round(w, qn_body_lever(w, b, k).z);
        double z = w->place[w->members[b->first + k]].z;
        w->shift[b->first + k] = z - (b->position.z + along);
    }
}

void qn_bodies_follow(qn_world *w, const int32_t *to)
{
    if (!w->body_of) return;
    for (int k = 0; k < w->member_count; k++) w->members[k] = to[w->members[k]];
    mark_spheres(w);
    for (int b = 0; b < w->body_count && w->period > 0; b++) wrap(w, &w->bodies[b]);
}

void qn_bodies_find(qn_world *w)
{
    int i = 0;
    for (int b = 0; b < w->body_count; b++) {
        while (w->id[i] != w->bodies[b].id) i++;
        for (int k = 0; k < w->grains[w->bodies[b].grain].count; k++)
            w->members[w->bodies[b].first + k] = i + k;
    }
    if (w->body_of) mark_spheres(w);
}
