// SPDX-License-Identifier: Apache-2.0
#include "world/pack.h"
#include "base/random.h"
#include "world/amounts.h"
#include "world/classes.h"
#include "world/pack_plan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The box that walls leave for packing: the drum's, or that of planes along the axes.
static qn_status find_box(qn_pack_plan *p)
{
    const qn_def *def = p->def;
    p->low = qn_v3(-INFINITY, -INFINITY, -INFINITY);
    p->high = qn_v3(INFINITY, INFINITY, INFINITY);
    if (def->drum.present) {
        double r = def->drum.diameter / 2;
        p->low = qn_v3(-r, -r, 0);
        p->high = qn_v3(r, r, def->drum.length);
        p->periodic = def->drum.ends == QN_ENDS_PERIODIC;
    }
    for (int i = 0; i < p->walls->plane_count; i++) {
        const qn_plane_def *q = &p->walls->planes[i];
        if (q->normal.x == 1) p->low.x = qn_max(p->low.x, q->point.x);
        if (q->normal.y == 1) p->low.y = qn_max(p->low.y, q->point.y);
        if (q->normal.z == 1) p->low.z = qn_max(p->low.z, q->point.z);
        if (q->normal.x == -1) p->high.x = qn_min(p->high.x, q->point.x);
        if (q->normal.y == -1) p->high.y = qn_min(p->high.y, q->point.y);
        if (q->normal.z == -1) p->high.z = qn_min(p->high.z, q->point.z);
    }
    qn_vec3 size = qn_sub(p->high, p->low);
    if (!(isfinite(size.x) && isfinite(size.y) && isfinite(size.z)))
        return qn_fail(QN_INPUT, "particles: packing needs a drum or a closed box of walls; place "
                                 "single particles with 'at' or a file");
    return QN_OK;
}

enum { STREAM_JITTER = 2 };

static qn_vec3 jittered(const qn_def *def, const qn_group_def *group, qn_vec3 site, double radius,
                        uint64_t index)
{
    double u = 2 * qn_random(def->seed, STREAM_JITTER, 3 * index) - 1;
    double turn = 2 * QN_PI * qn_random(def->seed, STREAM_JITTER, 3 * index + 1);
    double far = cbrt(qn_random(def->seed, STREAM_JITTER, 3 * index + 2));
    double flat = sqrt(1 - u * u);
    double size = group->jitter * group->padding * radius * far;
    return qn_madd(site, size, qn_v3(flat * cos(turn), flat * sin(turn), u));
}

static qn_status place_lists(const qn_def *def, const qn_class *classes, const qn_walls *walls,
                             qn_seedling *out, int *count)
{
    qn_pose pose = qn_walls_pose(walls, 0);
    int32_t first = 0;
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *g = &def->groups[k];
        for (int i = 0; g->packing == QN_PACK_LIST && i < g->list_count; i++) {
            const double *x = &g->list_position[3 * i];
            qn_seedling s = {qn_v3(x[0], x[1], x[2]), g->velocity, g->spin, first};
            if (g->list_size) s.klass += g->list_size[i];
            if (g->list_velocity)
                s.velocity = qn_v3(g->list_velocity[3 * i], g->list_velocity[3 * i + 1],
                                   g->list_velocity[3 * i + 2]);
            if (g->list_spin)
                s.spin =
                    qn_v3(g->list_spin[3 * i], g->list_spin[3 * i + 1], g->list_spin[3 * i + 2]);
            double clear = qn_walls_clearance(walls, &pose, s.position);
            double radius = classes[s.klass].radius;
            if (!g->fixed && !g->turning && !g->shape && clear < radius * (1 - QN_OVERLAP_WARN))
                return qn_fail(QN_INPUT,
                               "particles.%s: particle %d at (%g, %g, %g) m with radius %g m "
                               "stands %g m deep in a wall",
                               g->name, i + 1, x[0], x[1], x[2], radius, radius - clear);
            out[(*count)++] = s;
        }
        first += g->size_count;
    }
    return QN_OK;
}

// The key that asks for the particles of the first packed group, as "particles.balls.count".
static const char *amount_path(const qn_def *def, char path[2 * QN_NAME_MAX])
{
    static const char *const keys[] = {"count", "filling", "mass"};
    const qn_group_def *g = def->groups;
    while (g->packing == QN_PACK_LIST || g->packing == QN_PACK_FEED) g++;
    snprintf(path, 2 * QN_NAME_MAX, "particles.%s.%s", g->name, keys[g->amount_kind]);
    return path;
}

// What the groups ask for together. Returns the number of listed spheres.
static int64_t count_all(qn_pack_plan *p)
{
    int64_t *counts = p->counts, listed = 0;
    for (int k = 0; k < p->def->group_count; k++) {
        const qn_group_def *g = &p->def->groups[k];
        if (g->packing == QN_PACK_LIST)
            listed += g->list_count;
        else if (g->packing != QN_PACK_FEED)
            qn_amounts_of(p->def, g, p->walls, counts);
        p->cubic |= g->packing == QN_PACK_GRID;
        counts += g->size_count;
    }
    for (int c = 0; c < p->class_count; c++) p->total += p->counts[c];
    return listed;
}

static qn_status pack_groups(qn_pack_plan *p)
{
    char path[2 * QN_NAME_MAX];
    int32_t *members;
    int64_t fit;
    double largest = 0;
    QN_TRY(find_box(p));
    QN_TRY(QN_ALLOCATE(members, p->class_count));
    qn_status status = qn_pack_sort(p, members);
    free(members);
    QN_TRY(status);
    for (int32_t c = 0; c < p->class_count; c++) largest = qn_max(largest, qn_padded_radius(p, c));
    double period = p->periodic ? p->high.z - p->low.z : 0;
    int64_t before = p->listed + p->total - p->bins[p->bin_count - 1].count;
    QN_TRY(qn_occupied_create(&p->occupied, p->low, p->high, period, largest, before));
    QN_TRY(qn_pack_bins(p, &fit));
    if (fit < p->total)
        return qn_fail(QN_INPUT, "%s: %lld do not fit, at most %lld do (%s, padded radius %g m)",
                       amount_path(p->def, path), (long long)p->total, (long long)fit,
                       p->bin_count > 1 ? "mixed sizes"
                       : p->cubic       ? "grid"
                                        : "hcp",
                       p->bins[0].radius);
    for (int64_t i = 0; i < p->total; i++) {
        qn_seedling *s = &p->out[p->listed + i];
        const qn_class *c = &p->classes[s->klass];
        const qn_group_def *g = &p->def->groups[c->group];
        s->position = jittered(p->def, g, s->position, c->bound, (uint64_t)i);
        s->velocity = g->velocity, s->spin = g->spin;
    }
    return QN_OK;
}

static qn_status pack_all(qn_pack_plan *p, int *count)
{
    QN_TRY(QN_ALLOCATE(p->counts, p->class_count));
    int64_t listed = count_all(p);
    if (p->total + listed < 1 && p->def->feed_count == 0)
        return qn_fail(QN_INPUT,
                       "particles: there are none; give count, filling, mass, at or file");
    if (p->total + listed > INT32_MAX / 4)
        return qn_fail(QN_INPUT, "particles: %lld are too many, at most %d fit one machine",
                       (long long)(p->total + listed), INT32_MAX / 4);
    QN_TRY(QN_ALLOCATE(p->out, p->total + listed));
    QN_TRY(place_lists(p->def, p->classes, p->walls, p->out, &p->listed));
    if (p->total > 0) QN_TRY(pack_groups(p));
    *count = (int)(p->total + listed);
    return QN_OK;
}

qn_status qn_pack(const qn_def *def, const qn_class *classes, int class_count,
                  const qn_walls *walls, qn_seedling **seedlings, int *count)
{
    qn_pack_plan p = {.def = def, .classes = classes, .class_count = class_count, .walls = walls};
    qn_status status = pack_all(&p, count);
    if (status != QN_OK) free(p.out), p.out = NULL, *count = 0;
    *seedlings = p.out;
    for (int k = 0; k < p.bin_count; k++) free(p.bins[k].labels);
    free(p.bins), free(p.counts);
    qn_occupied_free(&p.occupied);
    return status;
}
