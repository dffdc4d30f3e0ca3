// SPDX-License-Identifier: Apache-2.0
#include "world/neighbours.h"
#include "world/bodies.h"
#include "world/history.h"
#include "world/sorter.h"

#include <stdlib.h>
#include <string.h>

#define SKIN_SHARE 0.5    // 1   of the smallest radius: the automatic skin (0.2 to 0.6 tried)
#define LEAST_SHARE 256   // 1   particles: fewer are not worth a thread
#define SLACK (1 + 1e-9)  // 1   of a listing distance, for the rounding of cells

double qn_neighbours_skin(const qn_world *w)
{
    return (w->def.skin > 0 ? w->def.skin : SKIN_SHARE) * w->smallest_radius;
}

static int share_count(const qn_world *w)
{
    int wanted = 1 + w->count / LEAST_SHARE;
    return wanted < w->neighbours->share_room ? wanted : w->neighbours->share_room;
}

qn_status qn_neighbours_create(qn_world *w)
{
    qn_neighbours *nb;
    int n = w->class_count;
    QN_TRY(QN_ALLOCATE(nb, 1));
    w->neighbours = nb;
    QN_TRY(QN_ALLOCATE(nb->sorter, 1));
    QN_TRY(qn_sorter_plan(nb->sorter, w));
    nb->share_room = w->threads;
    QN_TRY(QN_ALLOCATE(nb->shares, nb->share_room));
    nb->share_count = share_count(w);
    QN_TRY(QN_ALLOCATE(nb->reach2, n * n));
    QN_TRY(QN_ALLOCATE(nb->touch2, n * n));
    nb->skin = qn_neighbours_skin(w);
    for (int k = 0; k < n * n; k++) {
        double touch = w->reaches[k].reach;
        bool never = w->classes[k / n].inverse_mass <= 0 && w->classes[k % n].inverse_mass <= 0;
        nb->reach2[k] = never ? 0 : (touch + nb->skin) * (touch + nb->skin);
        nb->touch2[k] = touch * touch;
    }
    nb->stale = true;
    return QN_OK;
}

void qn_neighbours_destroy(qn_neighbours *nb)
{
    if (!nb) return;
    for (int t = 0; nb->shares && t < nb->share_room; t++) {
        qn_share *s = &nb->shares[t];
        free(s->row), free(s->partner), free(s->touching), free(s->slip), free(s->roll);
        free(s->spill), free(s->foreign), free(s->walls), free(s->walls_next);
        free(s->sums), free(s->workspace);
    }
    free(nb->shares), free(nb->anchor), free(nb->reach2), free(nb->touch2);
    qn_sorter_free(nb->sorter);
    free(nb);
}

// Lists the particles [from, to) as partners of i where they are near enough.
static void list_run(const qn_world *w, qn_share *share, int i, int from, int to)
{
    const qn_neighbours *nb = w->neighbours;
    const qn_place p = w->place[i];
    const double *reach2 = nb->reach2 + (int64_t)p.klass * w->class_count;
    for (int j = from; j < to; j++) {
        const qn_place q = w->place[j];
        double x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
        if (!(x * x + y * y + z * z < reach2[q.klass])) continue;
        if (w->body_of && w->body_of[i] >= 0 && w->body_of[i] == w->body_of[q.home]) continue;
        bool lower = w->id[q.home] < w->id[i];
        int64_t k = share->pair_count++;
        share->partner[k] = (uint32_t)j << 1 | lower;
        qn_memory memory = {{0, 0, 0}, {0, 0, 0}};
        share->touching[k] = qn_history_find(w, i, q.home, &memory);
        qn_memory_set(share, k, memory);
    }
}

// Room for the pairs one particle can add: all that stand in the cells around it. And one more: the kernel
// reads vectors of three as four numbers.
static qn_status room_for(const qn_world *w, qn_share *share, int64_t more)
{
    int64_t wanted = share->pair_count + more + 1, had = share->pair_room, room = had;
    if (wanted <= had) return QN_OK;
    QN_TRY(qn_reserve((void **)&share->partner, &room, wanted, sizeof *share->partner));
    room = had;
    QN_TRY(qn_reserve((void **)&share->touching, &room, wanted, sizeof *share->touching));
    room = had;
    QN_TRY(qn_reserve((void **)&share->slip, &room, wanted, sizeof *share->slip));
    if (w->rolls) {
        room = had;
        QN_TRY(qn_reserve((void **)&share->roll, &room, wanted, sizeof *share->roll));
    }
    share->pair_room = room;
    return QN_OK;
}

// Lists the partners of i in the cells of one level, its own or a coarser one. Of its own level, those
// behind it and images one period up; so every pair is listed once.
static qn_status list_level(const qn_world *w, qn_share *share, int i, int level)
{
    const qn_sorter *s = w->neighbours->sorter;
    const qn_grid *g = &s->grids[level];
    const qn_place *p = &w->place[i];
    const double x[3] = {p->x, p->y, p->z};
    const double reach = (w->classes[p->klass].radius + g->radius + w->neighbours->skin) * SLACK;
    bool own = level == s->level[p->klass];
    int low[3], high[3];
    for (int axis = 0; axis < 3; axis++) {
        if (x[axis] + reach < g->low[axis] || x[axis] - reach > g->high[axis]) return QN_OK;
        low[axis] = qn_grid_cell(g, axis, x[axis] - reach);
        high[axis] = qn_grid_cell(g, axis, x[axis] + reach);
    }
    for (int cz = low[2]; cz <= high[2]; cz++)
        for (int cy = low[1]; cy <= high[1]; cy++)
            for (int cx = low[0]; cx <= high[0]; cx++) {
                int64_t key = g->first_key + qn_grid_key(g, cx, cy, cz);
                const int32_t *rise = s->image_start + key, *fall = rise + s->keys;
                int from = s->start[key], to = s->start[key + 1];
                if (from <= i) from = i + 1;  // coarser levels stand behind
                int images = rise[1] - rise[0] + (own ? 0 : fall[1] - fall[0]);
                if (to <= from && images == 0) continue;
                QN_TRY(room_for(w, share, (to > from ? to - from : 0) + images));
                list_run(w, share, i, from, to);
                list_run(w, share, i, w->count + rise[0], w->count + rise[1]);
                if (!own) list_run(w, share, i, w->count + fall[0], w->count + fall[1]);
            }
    return QN_OK;
}

static qn_status list_particle(const qn_world *w, qn_share *share, int i)
{
    const qn_sorter *s = w->neighbours->sorter;
    for (int level = s->level[w->place[i].klass]; level < s->level_count; level++)
        QN_TRY(list_level(w, share, i, level));
    return QN_OK;
}

// Which particles outside its range a share writes loads for.
static qn_status list_foreign(const qn_world *w, qn_share *share)
{
    QN_TRY(QN_RESERVE(share->spill, share->spill_room, w->count));
    share->foreign_count = 0;
    for (int64_t k = 0; k < share->pair_count; k++) {
        int j = w->place[share->partner[k] >> 1].home;
        if ((j >= share->first && j < share->last) || share->spill[j].force[0]) continue;
        QN_TRY(QN_RESERVE(share->foreign, share->foreign_room, share->foreign_count + 1));
        share->foreign[share->foreign_count++] = j;
        share->spill[j].force[0] = 1;  // a mark; the step clears it
    }
    for (int k = 0; k < share->foreign_count; k++) share->spill[share->foreign[k]].force[0] = 0;
    return QN_OK;
}

// Takes the carried wall contacts of the share's particles, in their order.
static qn_status list_walls(const qn_world *w, qn_share *share)
{
    const qn_sorter *s = w->neighbours->sorter;
    share->wall_count = 0;
    for (int64_t k = 0; k < s->touch_count; k++) {
        int i = s->touches[k].index;
        if (i < share->first || i >= share->last) continue;
        QN_TRY(QN_RESERVE(share->walls, share->wall_room, share->wall_count + 1));
        share->walls[share->wall_count++] = s->touches[k];
    }
    return QN_OK;
}

static qn_status list_share(const qn_world *w, qn_share *share)
{
    for (int k = 0; k < share->foreign_count; k++)
        memset(&share->spill[share->foreign[k]], 0, sizeof *share->spill);
    QN_TRY(QN_RESERVE(share->row, share->row_room, share->last - share->first + 1));
    share->pair_count = 0;
    for (int i = share->first; i < share->last; i++) {
        share->row[i - share->first] = share->pair_count;
        QN_TRY(list_particle(w, share, i));
    }
    share->row[share->last - share->first] = share->pair_count;
    QN_TRY(list_foreign(w, share));
    return list_walls(w, share);
}

static int by_index(const void *a, const void *b)
{
    const qn_wall_contact *x = a, *y = b;
    if (x->index != y->index) return x->index < y->index ? -1 : 1;
    return (x->feature > y->feature) - (x->feature < y->feature);
}

static qn_status list_all(qn_world *w)
{
    qn_neighbours *nb = w->neighbours;
    qn_status worst = QN_OK;
#pragma omp parallel for schedule(static, 1) num_threads(nb->share_count)
    for (int t = 0; t < nb->share_count; t++) {
        nb->shares[t].first = (int)((int64_t)w->count * t / nb->share_count);
        nb->shares[t].last = (int)((int64_t)w->count * (t + 1) / nb->share_count);
        qn_status status = list_share(w, &nb->shares[t]);
#pragma omp critical
        if (status != QN_OK) worst = status;
    }
    return worst == QN_OK ? QN_OK : qn_fail(worst, "no memory for the pair list");
}

// Wraps particles into the period and finds those that are lost, before they are sorted.
static qn_status check_all(qn_world *w)
{
    qn_pose pose = qn_walls_pose(&w->walls, qn_world_time(w));
    int64_t lost = INT64_MAX;
    int which = -1;
    for (int i = 0; i < w->count; i++) {
        qn_vec3 x = qn_world_position(w, i);
        w->place[i].z = x.z;
        bool finite = isfinite(x.x) && isfinite(x.y) && isfinite(x.z);
        bool gone = !finite
                    || (w->classes[w->place[i].klass].inverse_mass > 0
                        && qn_walls_outside(&w->walls, &pose, x));
        if (gone && w->id[i] < lost) lost = w->id[i], which = i;
    }
    if (which < 0) return QN_OK;
    const qn_place *p = &w->place[which];
    const qn_motion *m = &w->motion[which];
    bool finite = isfinite(p->x) && isfinite(p->y) && isfinite(p->z);
    char name[QN_PARTICLE_NAME];
    return qn_fail(QN_UNSTABLE,
                   "%s %s at (%g, %g, %g) m with speed %g m/s, at %g s (step %lld); "
                   "take a smaller time step (now %g s) or stiffer materials",
                   qn_particle_name(w, which, name),
                   finite ? "has left through a wall" : "is not a number", p->x, p->y, p->z,
                   qn_norm(m->velocity), qn_world_time(w), (long long)w->step, w->dt);
}

qn_status qn_neighbours_rebuild(qn_world *w)
{
    qn_neighbours *nb = w->neighbours;
    qn_sorter *s = nb->sorter;
    QN_TRY(check_all(w));
    QN_TRY(qn_history_collect(w));
    QN_TRY(QN_RESERVE(nb->anchor, nb->anchor_room, w->count));
    nb->share_count = share_count(w);
    QN_TRY(qn_grids_lay(s, w, nb->skin));
    QN_TRY(qn_sort_particles(s, w));
    qn_bodies_follow(w, s->to);
    QN_TRY(qn_sort_images(s, w, nb->skin, &nb->rising_count, &nb->image_count));
    for (int64_t k = 0; k < s->touch_count; k++) s->touches[k].index = s->to[s->touches[k].index];
    if (s->touch_count > 0) qsort(s->touches, (size_t)s->touch_count, sizeof *s->touches, by_index);
    for (int i = 0; i < w->count; i++)
        nb->anchor[i] = (qn_anchor){w->place[i].x, w->place[i].y, w->place[i].z};
    QN_TRY(list_all(w));
    nb->rebuilds++;
    nb->stale = false;
    nb->built = true;
    return QN_OK;
}
