// SPDX-License-Identifier: Apache-2.0
#include "world/history.h"
#include "world/neighbours.h"
#include "world/sorter.h"

#include <stdlib.h>
#include <string.h>

static void copy(qn_wall_contact *to, const qn_wall_contact *from, int64_t count)
{
    for (int64_t k = 0; k < count; k++) to[k] = from[k];
}

// Which of two particles a pair's history is kept with.
static int owner_of(const qn_world *w, int a, int b)
{
    double ra = w->classes[w->place[a].klass].radius, rb = w->classes[w->place[b].klass].radius;
    bool first = ra != rb ? ra < rb : w->id[a] < w->id[b];
    return first ? a : b;
}

// Copies out all touching pairs of the list, with the present index of each owner; only counts them
// where `out` is NULL. Returns how many there are.
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
                out[n] = (qn_contact){w->id[low], w->id[high], qn_memory_of(share, k)};
                index[n] = owner_of(w, low, high);
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
    if (!nb->built) {  // what is waiting for the next list
        int64_t waiting = sorter->carried_row ? sorter->carried_row[w->count] : 0;
        QN_TRY(QN_ALLOCATE(*contacts, waiting));
        for (int64_t k = 0; k < waiting; k++) (*contacts)[k] = sorter->carried[k];
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

qn_status qn_neighbours_wall_contacts(const qn_world *w, qn_wall_contact **contacts, int64_t *count)
{
    const qn_neighbours *nb = w->neighbours;
    const qn_sorter *sorter = nb->sorter;
    int64_t n = 0;
    if (!nb->built) n = sorter->touch_count;
    for (int t = 0; nb->built && t < nb->share_count; t++) n += nb->shares[t].wall_count;
    QN_TRY(QN_ALLOCATE(*contacts, n));
    *count = n;
    if (!nb->built) {
        copy(*contacts, sorter->touches, n);
        return QN_OK;
    }
    n = 0;
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *s = &nb->shares[t];
        copy(*contacts + n, s->walls, s->wall_count);
        n += s->wall_count;
    }
    return QN_OK;
}

// Lays contacts out in rows by the present index of their owner; order within a row is free.
static qn_status lay_rows(qn_sorter *s, const qn_contact *contacts, const int32_t *index,
                          int64_t count, int64_t rows)
{
    QN_TRY(QN_RESERVE(s->carried, s->carried_room, count));
    QN_TRY(QN_RESERVE(s->carried_row, s->carried_row_room, rows + 2));
    memset(s->carried_row, 0, (size_t)(rows + 2) * sizeof *s->carried_row);
    for (int64_t k = 0; k < count; k++) s->carried_row[index[k] + 2]++;
    for (int64_t i = 0; i < rows; i++) s->carried_row[i + 2] += s->carried_row[i + 1];
    for (int64_t k = 0; k < count; k++) s->carried[s->carried_row[index[k] + 1]++] = contacts[k];
    return QN_OK;
}

qn_status qn_history_collect(qn_world *w)
{
    qn_neighbours *nb = w->neighbours;
    qn_sorter *s = nb->sorter;
    if (!nb->built) return s->carried_row ? QN_OK : lay_rows(s, NULL, NULL, 0, w->count);
    int64_t n = gather(w, NULL, NULL);
    QN_TRY(QN_RESERVE(s->gathered, s->gathered_room, n));
    QN_TRY(QN_RESERVE(s->gathered_owner, s->gathered_owner_room, n));
    gather(w, s->gathered, s->gathered_owner);
    QN_TRY(lay_rows(s, s->gathered, s->gathered_owner, n, w->count));
    s->touch_count = 0;
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *share = &nb->shares[t];
        QN_TRY(QN_RESERVE(s->touches, s->touch_room, s->touch_count + share->wall_count));
        if (share->wall_count == 0) continue;
        copy(s->touches + s->touch_count, share->walls, share->wall_count);
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
        if (w->id[middle] < id)
            low = middle + 1;
        else
            high = middle - 1;
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
            return qn_fail(QN_INPUT,
                           "the state has a wall contact of particle %lld, which it lacks",
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
        int low = index_of(w, contacts[k].low), high = index_of(w, contacts[k].high);
        if (low >= 0 && high >= 0)
            index[k] = owner_of(w, low, high);
        else
            status = qn_fail(QN_INPUT, "the state has a contact %lld-%lld of a particle it lacks",
                             (long long)contacts[k].low, (long long)contacts[k].high);
    }
    if (status == QN_OK) status = lay_rows(nb->sorter, contacts, index, contact_count, w->count);
    free(index);
    QN_TRY(status);
    nb->built = false;
    nb->stale = true;
    return take_touches(w, touches, touch_count);
}

static int by_number(const void *a, const void *b)
{
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

// The ids of those that go, sorted. Returns how many.
static qn_status ids_gone(const qn_world *w, const int32_t *to, int64_t **ids, size_t *count)
{
    *count = 0;
    QN_TRY(QN_ALLOCATE(*ids, w->count));
    for (int i = 0; i < w->count; i++)
        if (to[i] < 0) (*ids)[(*count)++] = w->id[i];
    qsort(*ids, *count, sizeof **ids, by_number);
    return QN_OK;
}

// Collected contacts of those that stay, in `gathered` with the new index of their owner.
static qn_status gather_kept(const qn_world *w, const int32_t *to, int64_t *kept)
{
    qn_sorter *s = w->neighbours->sorter;
    int64_t all = s->carried_row[w->count], *gone;
    size_t n;
    QN_TRY(QN_RESERVE(s->gathered, s->gathered_room, all));
    QN_TRY(QN_RESERVE(s->gathered_owner, s->gathered_owner_room, all));
    QN_TRY(ids_gone(w, to, &gone, &n));
    *kept = 0;
    for (int i = 0; i < w->count; i++)
        for (int64_t k = s->carried_row[i]; k < s->carried_row[i + 1]; k++) {
            const qn_contact *c = &s->carried[k];
            if (to[i] < 0 || bsearch(&c->low, gone, n, sizeof *gone, by_number)
                || bsearch(&c->high, gone, n, sizeof *gone, by_number))
                continue;
            s->gathered[*kept] = *c;
            s->gathered_owner[(*kept)++] = to[i];
        }
    free(gone);
    return QN_OK;
}

qn_status qn_history_move(qn_world *w, const int32_t *to, int64_t count)
{
    qn_neighbours *nb = w->neighbours;
    qn_sorter *s = nb->sorter;
    int64_t kept, touches = 0;
    QN_TRY(qn_history_collect(w));
    QN_TRY(gather_kept(w, to, &kept));
    QN_TRY(lay_rows(s, s->gathered, s->gathered_owner, kept, count));
    for (int64_t k = 0; k < s->touch_count; k++) {
        qn_wall_contact touch = s->touches[k];
        touch.index = to[touch.index];
        if (touch.index >= 0) s->touches[touches++] = touch;
    }
    s->touch_count = touches;
    nb->built = false;
    nb->image_count = 0;
    return QN_OK;
}

bool qn_history_find(const qn_world *w, int a, int b, qn_memory *memory)
{
    const qn_sorter *s = w->neighbours->sorter;
    int old = s->from[owner_of(w, a, b)];
    int64_t low = w->id[a] < w->id[b] ? w->id[a] : w->id[b], high = w->id[a] + w->id[b] - low;
    for (int64_t k = s->carried_row[old]; k < s->carried_row[old + 1]; k++)
        if (s->carried[k].low == low && s->carried[k].high == high) {
            *memory = s->carried[k].memory;
            return true;
        }
    return false;
}
