// SPDX-License-Identifier: Apache-2.0
#include "world/neighbours.h"
#include "world/sorter.h"

#include <stdlib.h>
#include <string.h>

#define SKIN_SHARE 0.30  // 1   of the smallest radius: the automatic skin, by measurement (bench/)
#define LEAST_SHARE 256  // 1   particles: fewer are not worth a thread

qn_status qn_neighbours_create(qn_world *w)
{
    qn_neighbours *nb;
    int n = w->class_count;
    QN_TRY(QN_ALLOCATE(nb, 1));
    w->neighbours = nb;
    QN_TRY(QN_ALLOCATE(nb->sorter, 1));
    nb->share_count = w->threads < 1 + w->count / LEAST_SHARE ? w->threads : 1 + w->count / LEAST_SHARE;
    QN_TRY(QN_ALLOCATE(nb->shares, nb->share_count));
    QN_TRY(QN_ALLOCATE(nb->anchor, w->count));
    QN_TRY(QN_ALLOCATE(nb->reach2, n * n));
    QN_TRY(QN_ALLOCATE(nb->touch2, n * n));
    nb->skin = (w->def.skin > 0 ? w->def.skin : SKIN_SHARE) * w->smallest_radius;
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
    for (int t = 0; nb->shares && t < nb->share_count; t++) {
        qn_share *s = &nb->shares[t];
        free(s->row), free(s->partner), free(s->touching), free(s->slip);
        free(s->spill), free(s->foreign), free(s->walls), free(s->walls_next);
        free(s->sums), free(s->workspace);
    }
    free(nb->shares), free(nb->anchor), free(nb->reach2), free(nb->touch2);
    qn_sorter_free(nb->sorter);
    free(nb);
}

// Copies out all touching pairs of the list, with the present index of each lower id; only counts
// them where `out` is NULL. Returns how many there are.
static int64_t gather(const qn_world *w, qn_contact *out, int32_t *index)
{
    const qn_neighbours *nb = w->neighbours;
    int64_t n = 0;
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *share = &nb->shares[t];
        for (int64_t k = 0, i = share->first; k < share->pair_count; k++) {
            while (k >= share->row[i - share->first + 1]) i++;
            if (!share->touching[k]) continue;
            if (out) {
                bool lower;
                int home = w->place[qn_partner(share, k, &lower)].home, mine = (int)i;
                int low = lower ? home : mine, high = lower ? mine : home;
                out[n] = (qn_contact){w->id[low], w->id[high], share->slip[k]};
                index[n] = low;
            }
            n++;
        }
    }
    return n;
}

qn_status qn_neighbours_contacts(const qn_world *w, qn_contact **contacts, int64_t *count)
{
    const qn_neighbours *nb = w->neighbours;
    const qn_sorter *sorter = nb->sorter;
    int64_t n = 0;
    if (nb->rebuilds == 0) {  // nothing built yet: what a restore has left waiting
        int64_t waiting = sorter->carried_row ? sorter->carried_row[w->count] : 0;
        QN_TRY(QN_ALLOCATE(*contacts, waiting));
        memcpy(*contacts, sorter->carried, (size_t)waiting * sizeof **contacts);
        *count = waiting;
        return QN_OK;
    }
    int32_t *index = NULL;
    n = gather(w, NULL, NULL);
    QN_TRY(QN_ALLOCATE(*contacts, n));
    QN_TRY(QN_ALLOCATE(index, n));
    *count = gather(w, *contacts, index);
    free(index);
    return QN_OK;
}

qn_status qn_neighbours_wall_contacts(const qn_world *w, qn_wall_contact **contacts,
                                      int64_t *count)
{
    const qn_neighbours *nb = w->neighbours;
    const qn_sorter *sorter = nb->sorter;
    int64_t n = 0;
    if (nb->rebuilds == 0) n = sorter->touch_count;
    for (int t = 0; nb->rebuilds > 0 && t < nb->share_count; t++) n += nb->shares[t].wall_count;
    QN_TRY(QN_ALLOCATE(*contacts, n));
    *count = n;
    if (nb->rebuilds == 0) {
        memcpy(*contacts, sorter->touches, (size_t)n * sizeof **contacts);
        return QN_OK;
    }
    n = 0;
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *s = &nb->shares[t];
        memcpy(*contacts + n, s->walls, (size_t)s->wall_count * sizeof **contacts);
        n += s->wall_count;
    }
    return QN_OK;
}

// Lays contacts out in rows by the present index of their lower id; order within a row is free.
static qn_status lay_rows(qn_world *w, const qn_contact *contacts, const int32_t *index,
                          int64_t count)
{
    qn_sorter *s = w->neighbours->sorter;
    QN_TRY(QN_RESERVE(s->carried, s->carried_room, count));
    QN_TRY(QN_RESERVE(s->carried_row, s->carried_row_room, w->count + 2));
    memset(s->carried_row, 0, (size_t)(w->count + 2) * sizeof *s->carried_row);
    for (int64_t k = 0; k < count; k++) s->carried_row[index[k] + 2]++;
    for (int i = 0; i < w->count; i++) s->carried_row[i + 2] += s->carried_row[i + 1];
    for (int64_t k = 0; k < count; k++) s->carried[s->carried_row[index[k] + 1]++] = contacts[k];
    return QN_OK;
}

// The history of the list in use, as rows by the lower id's index.
static qn_status collect(qn_world *w)
{
    qn_neighbours *nb = w->neighbours;
    qn_sorter *s = nb->sorter;
    int64_t n = gather(w, NULL, NULL);
    QN_TRY(QN_RESERVE(s->gathered, s->gathered_room, n));
    QN_TRY(QN_RESERVE(s->gathered_low, s->gathered_low_room, n));
    gather(w, s->gathered, s->gathered_low);
    QN_TRY(lay_rows(w, s->gathered, s->gathered_low, n));
    s->touch_count = 0;
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *share = &nb->shares[t];
        QN_TRY(QN_RESERVE(s->touches, s->touch_room, s->touch_count + share->wall_count));
        memcpy(s->touches + s->touch_count, share->walls,
               (size_t)share->wall_count * sizeof *s->touches);
        s->touch_count += share->wall_count;
    }
    return QN_OK;
}

// Index of an id in a world whose particles stand in the order of their ids, or -1.
static int index_of(const qn_world *w, int64_t id)
{
    int low = 0, high = w->count - 1;
    while (low <= high) {
        int middle = (low + high) / 2;
        if (w->id[middle] == id) return middle;
        if (w->id[middle] < id) low = middle + 1;
        else high = middle - 1;
    }
    return -1;
}

static qn_status take_touches(qn_world *w, const qn_wall_contact *touches, int64_t count)
{
    qn_sorter *s = w->neighbours->sorter;
    QN_TRY(QN_RESERVE(s->touches, s->touch_room, count));
    for (int64_t k = 0; k < count; k++) {
        s->touches[k] = touches[k];
        s->touches[k].index = index_of(w, touches[k].id);
        if (s->touches[k].index < 0)
            return qn_fail(QN_INPUT, "the state has a wall contact of particle %lld, which it lacks",
                           (long long)touches[k].id);
    }
    s->touch_count = count;
    return QN_OK;
}

qn_status qn_neighbours_restore(qn_world *w, const qn_contact *contacts, int64_t contact_count,
                                const qn_wall_contact *touches, int64_t touch_count)
{
    qn_neighbours *nb = w->neighbours;
    int32_t *index;
    QN_TRY(QN_ALLOCATE(index, contact_count));
    qn_status status = QN_OK;
    for (int64_t k = 0; k < contact_count && status == QN_OK; k++) {
        index[k] = index_of(w, contacts[k].low);
        if (index[k] < 0 || index_of(w, contacts[k].high) < 0)
            status = qn_fail(QN_INPUT, "the state has a contact %lld-%lld of a particle it lacks",
                             (long long)contacts[k].low, (long long)contacts[k].high);
    }
    if (status == QN_OK) status = lay_rows(w, contacts, index, contact_count);
    free(index);
    QN_TRY(status);
    nb->rebuilds = 0;
    nb->stale = true;
    return take_touches(w, touches, touch_count);
}

// Finds the history of a new pair among the carried contacts of its lower id.
static bool find_history(const qn_world *w, int low, int64_t high_id, qn_vec3 *slip)
{
    const qn_sorter *s = w->neighbours->sorter;
    int old = s->from[low];
    for (int64_t k = s->carried_row[old]; k < s->carried_row[old + 1]; k++)
        if (s->carried[k].high == high_id) {
            *slip = s->carried[k].slip;
            return true;
        }
    return false;
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
        bool lower = w->id[q.home] < w->id[i];
        int64_t k = share->pair_count++;
        share->partner[k] = (uint32_t)j << 1 | lower;
        share->slip[k] = qn_v3(0, 0, 0);
        share->touching[k] = find_history(w, lower ? q.home : i, w->id[lower ? i : q.home],
                                          &share->slip[k]);
    }
}

// Room for the pairs one particle can add: all that stand in the cells around it.
static qn_status room_for(qn_share *share, int64_t more)
{
    int64_t wanted = share->pair_count + more, room = share->pair_room;
    if (wanted <= room) return QN_OK;
    QN_TRY(qn_reserve((void **)&share->partner, &room, wanted, sizeof *share->partner));
    room = share->pair_room;
    QN_TRY(qn_reserve((void **)&share->touching, &room, wanted, sizeof *share->touching));
    room = share->pair_room;
    QN_TRY(qn_reserve((void **)&share->slip, &room, wanted, sizeof *share->slip));
    share->pair_room = room;
    return QN_OK;
}

static qn_status list_particle(const qn_world *w, qn_share *share, int i)
{
    const qn_sorter *s = w->neighbours->sorter;
    const qn_grid *g = &s->grid;
    int cell[3] = {qn_grid_cell(g, 0, w->place[i].x), qn_grid_cell(g, 1, w->place[i].y),
                   qn_grid_cell(g, 2, w->place[i].z)};
    int low[3], high[3];
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = cell[axis] > 0 ? cell[axis] - 1 : 0;
        high[axis] = cell[axis] + 1 < g->cells[axis] ? cell[axis] + 1 : cell[axis];
    }
    for (int z = low[2]; z <= high[2]; z++)
        for (int y = low[1]; y <= high[1]; y++)
            for (int x = low[0]; x <= high[0]; x++) {
                uint32_t key = qn_grid_key(g, x, y, z);
                int from = s->start[key], to = s->start[key + 1];
                int image_from = s->image_start[key] + w->count;
                int image_to = s->image_start[key + 1] + w->count;
                if (from <= i) from = i + 1;
                if (to > from || image_to > image_from)
                    QN_TRY(room_for(share, (to > from ? to - from : 0) + image_to - image_from));
                list_run(w, share, i, from, to);
                list_run(w, share, i, image_from, image_to);
            }
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
    return qn_fail(QN_UNSTABLE,
                   "particle %lld %s at (%g, %g, %g) m with speed %g m/s, at %g s (step %lld); "
                   "take a smaller time step (now %g s) or stiffer materials",
                   (long long)lost, finite ? "has left through a wall" : "is not a number", p->x,
                   p->y, p->z, qn_norm(m->velocity), qn_world_time(w), (long long)w->step, w->dt);
}

qn_status qn_neighbours_rebuild(qn_world *w)
{
    qn_neighbours *nb = w->neighbours;
    qn_sorter *s = nb->sorter;
    double cell = 2 * w->largest_radius + nb->skin;
    QN_TRY(check_all(w));
    if (nb->rebuilds > 0) QN_TRY(collect(w));
    else if (!s->carried_row) QN_TRY(lay_rows(w, NULL, NULL, 0));
    QN_TRY(qn_grid_lay(&s->grid, w, cell));
    QN_TRY(qn_sort_particles(s, w));
    QN_TRY(qn_sort_images(s, w, cell, &nb->image_count));
    for (int64_t k = 0; k < s->touch_count; k++) s->touches[k].index = s->to[s->touches[k].index];
    qsort(s->touches, (size_t)s->touch_count, sizeof *s->touches, by_index);
    for (int i = 0; i < w->count; i++)
        nb->anchor[i] = (qn_anchor){w->place[i].x, w->place[i].y, w->place[i].z};
    QN_TRY(list_all(w));
    nb->rebuilds++;
    nb->stale = false;
    return QN_OK;
}
