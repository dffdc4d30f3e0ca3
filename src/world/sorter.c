// SPDX-License-Identifier: Apache-2.0
#include "world/sorter.h"

#include <stdlib.h>
#include <string.h>

enum { BITS_MAX = 10 };  // per axis: at most 1024 cells

// Bits needed for `cells` values.
static int bits_for(int cells)
{
    int bits = 0;
    while ((1 << bits) < cells) bits++;
    return bits;
}

// Interleaves the axes' bits from the lowest up, an axis dropping out once its bits are used.
static qn_status fill_codes(qn_grid *grid)
{
    int bits[3], at[3][BITS_MAX], next = 0;
    for (int axis = 0; axis < 3; axis++) bits[axis] = bits_for(grid->cells[axis]);
    for (int bit = 0; bit < BITS_MAX; bit++)
        for (int axis = 0; axis < 3; axis++)
            if (bit < bits[axis]) at[axis][bit] = next++;
    for (int axis = 0; axis < 3; axis++) {
        QN_TRY(QN_RESERVE(grid->code[axis], grid->code_room[axis], grid->cells[axis]));
        for (int c = 0; c < grid->cells[axis]; c++) {
            uint32_t code = 0;
            for (int bit = 0; bit < bits[axis]; bit++)
                code |= (uint32_t)(c >> bit & 1) << at[axis][bit];
            grid->code[axis][c] = code;
        }
    }
    grid->keys = (int64_t)1 << next;
    return QN_OK;
}

qn_status qn_grid_lay(qn_grid *grid, const qn_world *w, double cell)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < w->count; i++) {
        const double x[3] = {w->place[i].x, w->place[i].y, w->place[i].z};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = qn_min(low[axis], x[axis]);
            high[axis] = qn_max(high[axis], x[axis]);
        }
    }
    if (w->period > 0) high[2] = qn_max(high[2], w->period + cell);  // room for the images
    double wanted = 4.0 * w->count + 4096;
    for (;; cell *= 1.26) {
        double cells = 1;
        bool small = true;
        for (int axis = 0; axis < 3; axis++) {
            double n = floor((high[axis] - low[axis]) / cell) + 1;
            small &= n <= (1 << BITS_MAX);
            cells *= n;
            grid->low[axis] = low[axis];
            grid->cells[axis] = small ? (int)n : 0;
        }
        if (small && cells <= wanted) break;
    }
    grid->inverse_cell = 1 / cell;
    return fill_codes(grid);
}

// Turns counts per key, kept one place on in start[], into first indices.
static void accumulate(int32_t *start, int64_t keys)
{
    for (int64_t k = 0; k < keys; k++) start[k + 1] += start[k];
}

static qn_status reserve(qn_sorter *s, const qn_world *w)
{
    QN_TRY(QN_RESERVE(s->start, s->start_room, s->grid.keys + 2));
    QN_TRY(QN_RESERVE(s->key, s->key_room, w->count));
    QN_TRY(QN_RESERVE(s->from, s->from_room, w->count));
    return QN_RESERVE(s->to, s->to_room, w->count);
}

// Second set of records, as large as the world's, to permute into.
static qn_status reserve_records(qn_sorter *s, const qn_world *w)
{
    if (s->room >= w->room) return QN_OK;
    free(s->place), free(s->motion), free(s->id);
    s->place = NULL, s->motion = NULL, s->id = NULL, s->room = 0;
    QN_TRY(QN_ALLOCATE(s->place, w->room));
    QN_TRY(QN_ALLOCATE(s->motion, w->room));
    QN_TRY(QN_ALLOCATE(s->id, w->room));
    s->room = w->room;
    return QN_OK;
}

#define SWAP(type, a, b)  \
    do {                  \
        type swap_ = (a); \
        (a) = (b);        \
        (b) = swap_;      \
    } while (0)

qn_status qn_sort_particles(qn_sorter *s, qn_world *w)
{
    QN_TRY(reserve(s, w));
    QN_TRY(reserve_records(s, w));
    memset(s->start, 0, (size_t)(s->grid.keys + 2) * sizeof *s->start);
    for (int i = 0; i < w->count; i++) {
        s->key[i] = qn_grid_key_at(&s->grid, &w->place[i]);
        s->start[s->key[i] + 2]++;
    }
    accumulate(s->start + 1, s->grid.keys);
    for (int i = 0; i < w->count; i++) {
        int32_t at = s->start[s->key[i] + 1]++;
        s->from[at] = i;
        s->to[i] = at;
    }
#pragma omp parallel for schedule(static) num_threads(w->threads)
    for (int i = 0; i < w->count; i++) {
        int old = s->from[i];
        s->place[i] = w->place[old];
        s->place[i].home = i;
        s->motion[i] = w->motion[old];
        s->id[i] = w->id[old];
    }
    SWAP(qn_place *, s->place, w->place);
    SWAP(qn_motion *, s->motion, w->motion);
    SWAP(int64_t *, s->id, w->id);
    return QN_OK;
}

// As many records as the world has particles and images; the loads and ids of images stay unused.
static qn_status make_room(qn_world *w, int64_t wanted)
{
    int64_t room = w->room;
    if (wanted <= room) return QN_OK;
    QN_TRY(qn_reserve((void **)&w->place, &room, wanted, sizeof *w->place));
    room = w->room;
    QN_TRY(qn_reserve((void **)&w->motion, &room, wanted, sizeof *w->motion));
    room = w->room;
    QN_TRY(qn_reserve((void **)&w->load, &room, wanted, sizeof *w->load));
    room = w->room;
    QN_TRY(qn_reserve((void **)&w->id, &room, wanted, sizeof *w->id));
    w->room = room;
    return QN_OK;
}

qn_status qn_sort_images(qn_sorter *s, qn_world *w, double reach, int *count)
{
    int n = 0;
    QN_TRY(QN_RESERVE(s->image_start, s->image_start_room, s->grid.keys + 2));
    memset(s->image_start, 0, (size_t)(s->grid.keys + 2) * sizeof *s->image_start);
    *count = 0;
    if (w->period <= 0) return QN_OK;
    for (int i = 0; i < w->count; i++) {
        if (w->place[i].z >= reach) continue;
        QN_TRY(QN_RESERVE(s->images, s->image_room, n + 1));
        s->images[n] = w->place[i];
        s->images[n].z += w->period;
        s->image_start[qn_grid_key_at(&s->grid, &s->images[n]) + 2]++;
        n++;
    }
    QN_TRY(make_room(w, w->count + n));
    accumulate(s->image_start + 1, s->grid.keys);
    for (int k = 0; k < n; k++) {
        uint32_t key = qn_grid_key_at(&s->grid, &s->images[k]);
        w->place[w->count + s->image_start[key + 1]++] = s->images[k];
    }
    *count = n;
    return QN_OK;
}

void qn_sorter_free(qn_sorter *s)
{
    if (!s) return;
    for (int axis = 0; axis < 3; axis++) free(s->grid.code[axis]);
    free(s->start), free(s->image_start), free(s->key), free(s->from), free(s->to);
    free(s->place), free(s->images), free(s->motion), free(s->id);
    free(s->carried), free(s->carried_row), free(s->gathered), free(s->gathered_low);
    free(s->touches);
    free(s);
}
