// SPDX-License-Identifier: Apache-2.0
#include "world/state.h"
#include "base/hash.h"
#include "world/bodies.h"
#include "world/neighbours.h"
#include "world/population.h"

#include <stdlib.h>
#include <string.h>

// The tables of a state, each with its count.
#define QN_STATE_TABLES(T)                        \
    T(QN_PARTICLE_FIELDS, count)                  \
    T(QN_CONTACT_FIELDS, contact_count)           \
    T(QN_WALL_CONTACT_FIELDS, wall_contact_count) \
    T(QN_BODY_FIELDS, body_count)

static qn_status allocate(qn_state *s)
{
    int64_t rows;
#define F(type, name, width, unit, meaning) QN_TRY(QN_ALLOCATE(s->name, rows *(width)));
#define T(FIELDS, number) \
    rows = s->number;     \
    FIELDS(F)
    QN_STATE_TABLES(T)
#undef T
#undef F
    return QN_OK;
}

qn_status qn_state_allocate(qn_state *state)
{
#define F(type, name, width, unit, meaning) state->name = NULL;
#define T(FIELDS, number) FIELDS(F)
    QN_STATE_TABLES(T)
#undef T
#undef F
    qn_status status = allocate(state);
    if (status != QN_OK) qn_state_free(state);
    return status;
}

void qn_state_free(qn_state *state)
{
#define F(type, name, width, unit, meaning) free(state->name);
#define T(FIELDS, number) FIELDS(F)
    QN_STATE_TABLES(T)
#undef T
#undef F
    memset(state, 0, sizeof *state);
}

uint64_t qn_state_hash(const qn_state *s)
{
    uint64_t hash = qn_hash(QN_HASH_START, &s->step, sizeof s->step);
#define F(type, name, width, unit, meaning) \
    hash = qn_hash(hash, s->name, (size_t)rows * (width) * sizeof(type));
#define T(FIELDS, number)                         \
    {                                             \
        int64_t rows = s->number;                 \
        hash = qn_hash(hash, &rows, sizeof rows); \
        FIELDS(F)                                 \
    }
    QN_STATE_TABLES(T)
#undef T
#undef F
    return hash;
}

typedef struct ranked {
    int64_t id;
    int index;
} ranked;

static int by_id(const void *a, const void *b)
{
    int64_t x = ((const ranked *)a)->id, y = ((const ranked *)b)->id;
    return (x > y) - (x < y);
}

static int by_pair(const void *a, const void *b)
{
    const qn_contact *x = a, *y = b;
    if (x->low != y->low) return x->low < y->low ? -1 : 1;
    return (x->high > y->high) - (x->high < y->high);
}

static int by_wall(const void *a, const void *b)
{
    const qn_wall_contact *x = a, *y = b;
    if (x->id != y->id) return x->id < y->id ? -1 : 1;
    return (x->feature > y->feature) - (x->feature < y->feature);
}

static void put(double *out, int64_t row, qn_vec3 v)
{
    out[3 * row] = v.x, out[3 * row + 1] = v.y, out[3 * row + 2] = v.z;
}

static qn_vec3 take(const double *in, int64_t row)
{
    return qn_v3(in[3 * row], in[3 * row + 1], in[3 * row + 2]);
}

static qn_status export_particles(const qn_world *w, qn_state *s)
{
    ranked *order;
    QN_TRY(QN_ALLOCATE(order, w->count));
    for (int i = 0; i < w->count; i++) order[i] = (ranked){w->id[i], i};
    qsort(order, (size_t)w->count, sizeof *order, by_id);
    for (int k = 0; k < w->count; k++) {
        int i = order[k].index;
        const qn_motion *m = &w->motion[i];
        s->id[k] = w->id[i];
        s->klass[k] = w->place[i].klass;
        put(s->position, k, qn_world_position(w, i));
        put(s->velocity, k, m->velocity);
        put(s->spin, k, m->spin);
        put(s->kick, k, m->kick);
        put(s->spin_kick, k, m->spin_kick);
    }
    free(order);
    return QN_OK;
}

static void export_bodies(const qn_world *w, qn_state *s)
{
    for (int k = 0; k < w->body_count; k++) {
        const qn_body *b = &w->bodies[k];
        const qn_quat q = b->orientation;
        s->body_id[k] = b->id;
        s->body_grain[k] = b->grain;
        put(s->body_position, k, qn_body_position(w, b));
        memcpy(s->body_orientation + 4 * k, (const double[4]){q.w, q.x, q.y, q.z}, 4 * sizeof q.w);
        put(s->body_velocity, k, b->velocity);
        put(s->body_spin, k, b->spin);
        put(s->body_momentum, k, b->momentum);
        put(s->body_kick, k, b->kick);
        put(s->body_spin_kick, k, b->spin_kick);
        put(s->body_momentum_kick, k, b->momentum_kick);
    }
}

static void import_bodies(qn_world *w, const qn_state *s)
{
    for (int k = 0; k < w->body_count; k++) {
        qn_body *b = &w->bodies[k];
        const double *q = &s->body_orientation[4 * k];
        b->position = take(s->body_position, k);
        b->orientation = qn_quat_of(q[0], q[1], q[2], q[3]);
        b->velocity = take(s->body_velocity, k);
        b->spin = take(s->body_spin, k);
        b->momentum = take(s->body_momentum, k);
        b->kick = take(s->body_kick, k);
        b->spin_kick = take(s->body_spin_kick, k);
        b->momentum_kick = take(s->body_momentum_kick, k);
    }
    qn_bodies_find(w);
}

qn_status qn_world_export(const qn_world *w, qn_state *s)
{
    qn_contact *contacts = NULL;
    qn_wall_contact *touches = NULL;
    qn_state out = {.step = w->step, .count = w->count, .body_count = w->body_count};
    QN_TRY(qn_neighbours_contacts(w, &contacts, &out.contact_count));
    qn_status status = qn_neighbours_wall_contacts(w, &touches, &out.wall_contact_count);
    if (status == QN_OK) status = qn_state_allocate(&out);
    if (status == QN_OK) status = export_particles(w, &out);
    if (status == QN_OK) {
        qsort(contacts, (size_t)out.contact_count, sizeof *contacts, by_pair);
        qsort(touches, (size_t)out.wall_contact_count, sizeof *touches, by_wall);
        for (int64_t k = 0; k < out.contact_count; k++) {
            out.low[k] = contacts[k].low, out.high[k] = contacts[k].high;
            put(out.slip, k, contacts[k].memory.slip);
            put(out.roll, k, contacts[k].memory.roll);
        }
        for (int64_t k = 0; k < out.wall_contact_count; k++) {
            out.wall_id[k] = touches[k].id, out.wall_feature[k] = touches[k].feature;
            put(out.wall_slip, k, touches[k].memory.slip);
            put(out.wall_roll, k, touches[k].memory.roll);
            put(out.wall_normal, k, touches[k].normal);
        }
        export_bodies(w, &out);
        *s = out;
    }
    free(contacts);
    free(touches);
    return status;
}

static qn_status check(const qn_world *w, const qn_state *s)
{
    if (s->count != w->count && !w->flow)
        return qn_fail(QN_INPUT, "the state holds %lld particles, the scene makes %d",
                       (long long)s->count, w->count);
    for (int64_t k = 0; k < s->count; k++) {
        if (k > 0 && s->id[k] <= s->id[k - 1])
            return qn_fail(QN_INPUT, "the state's particle %lld is out of order",
                           (long long)s->id[k]);
        if (s->klass[k] < 0 || s->klass[k] >= w->class_count)
            return qn_fail(QN_INPUT, "the state's particle %lld is of class %d; there are %d",
                           (long long)s->id[k], s->klass[k], w->class_count);
    }
    if (s->body_count != w->body_count)
        return qn_fail(QN_INPUT, "the state holds %lld clumps, the scene makes %d",
                       (long long)s->body_count, w->body_count);
    for (int64_t k = 0, i = 0; k < s->body_count; k++) {
        const qn_body *b = &w->bodies[k];
        const qn_grain *g = &w->grains[b->grain];
        while (i < s->count && s->id[i] < b->id) i++;
        bool same =
            s->body_id[k] == b->id && s->body_grain[k] == b->grain && i + g->count <= s->count;
        for (int m = 0; m < g->count && same; m++)
            same = s->id[i + m] == b->id + m && s->klass[i + m] == g->klass[m];
        if (!same)
            return qn_fail(QN_INPUT, "the state's clump %lld is not one of the scene's",
                           (long long)s->body_id[k]);
    }
    return QN_OK;
}

qn_status qn_world_import(qn_world *w, const qn_state *s)
{
    qn_contact *contacts = NULL;
    qn_wall_contact *touches = NULL;
    QN_TRY(check(w, s));
    QN_TRY(QN_ALLOCATE(contacts, s->contact_count));
    qn_status status = QN_ALLOCATE(touches, s->wall_contact_count);
    if (status == QN_OK) status = qn_population_reserve(w, s->count);
    if (status == QN_OK) {
        w->count = (int)s->count;
        for (int k = 0; k < w->count; k++) {
            qn_vec3 x = take(s->position, k);
            w->place[k] = (qn_place){x.x, x.y, x.z, s->klass[k], k};
            w->motion[k] = (qn_motion){take(s->velocity, k), take(s->spin, k), take(s->kick, k),
                                       take(s->spin_kick, k)};
            w->id[k] = s->id[k];
        }
        import_bodies(w, s);
        for (int64_t k = 0; k < s->contact_count; k++)
            contacts[k] = (qn_contact){s->low[k], s->high[k], {take(s->slip, k), take(s->roll, k)}};
        for (int64_t k = 0; k < s->wall_contact_count; k++)
            touches[k] = (qn_wall_contact){s->wall_id[k],
                                           s->wall_feature[k],
                                           0,
                                           {take(s->wall_slip, k), take(s->wall_roll, k)},
                                           take(s->wall_normal, k)};
        w->step = s->step;
        w->started = true;
        status =
            qn_neighbours_restore(w, contacts, s->contact_count, touches, s->wall_contact_count);
    }
    free(contacts);
    free(touches);
    return status;
}
