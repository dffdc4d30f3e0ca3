// SPDX-License-Identifier: Apache-2.0
#include "world/sorter.h"
#include "world/population.h"

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

// Classes by falling radius; fixed ones among them, as any.
static int next_smaller(const qn_world *w, double below)
{
    int found = -1;
    for (int c = 0; c < w->class_count; c++)
        if (w->classes[c].radius < below
            && (found < 0 || w->classes[c].radius > w->classes[found].radius))
            found = c;
    return found;
}

qn_status qn_sorter_plan(qn_sorter *s, const qn_world *w)
{
    double radius[QN_LEVELS_MAX];
    int n = 0;
    QN_TRY(QN_ALLOCATE(s->level, w->class_count));
    for (int c = next_smaller(w, INFINITY); c >= 0; c = next_smaller(w, w->classes[c].radius)) {
        double r = w->classes[c].radius;
        if (n == 0 || (n < QN_LEVELS_MAX && r * QN_LEVEL_RATIO < radius[n - 1])) radius[n++] = r;
        for (int other = 0; other < w->class_count; other++)
            if (w->classes[other].radius == r) s->level[other] = n - 1;
    }
    for (int c = 0; c < w->class_count; c++) s->level[c] = n - 1 - s->level[c];
    for (int l = 0; l < n; l++) s->grids[l].radius = radius[n - 1 - l];
    s->level_count = n;
    return QN_OK;
}

// Cells of at least `cell` for `count` particles within low and high.
static qn_status lay(qn_grid *grid, int64_t count, double cell)
{
    double wanted = 4.0 * (double)count + 4096;
    for (;; cell *= 1.26) {
        double cells = 1;
        bool small = true;
        for (int axis = 0; axis < 3; axis++) {
            double n = floor((grid->high[axis] - grid->low[axis]) / cell) + 1;
            small &= n <= (1 << BITS_MAX);
            cells *= n;
            grid->cells[axis] = small ? (int)n : 0;
        }
        if (small && cells <= wanted) break;
    }
    grid->inverse_cell = 1 / cell;
    return fill_codes(grid);
}

qn_status qn_grids_lay(qn_sorter *s, const qn_world *w, double skin)
{
    int64_t count[QN_LEVELS_MAX] = {0};
    for (int l = 0; l < s->level_count; l++)
        for (int axis = 0; axis < 3; axis++)
            s->grids[l].low[axis] = INFINITY, s->grids[l].high[axis] = -INFINITY;
    for (int i = 0; i < w->count; i++) {
        int l = s->level[w->place[i].klass];
        qn_grid *g = &s->grids[l];
        const double x[3] = {w->place[i].x, w->place[i].y, w->place[i].z};
        count[l]++;
        for (int axis = 0; axis < 3; axis++) {
            g->low[axis] = qn_min(g->low[axis], x[axis]);
            g->high[axis] = qn_max(g->high[axis], x[axis]);
        }
    }
    s->keys = 0;
    for (int l = 0; l < s->level_count; l++) {
        qn_grid *g = &s->grids[l];
        double cell = 2 * g->radius + skin;
        if (count[l] == 0) memset(g->low, 0, sizeof g->low), memset(g->high, 0, sizeof g->high);
        if (w->period > 0) {  // room for the images
            g->low[2] = l > 0 ? -cell : 0;
            g->high[2] = w->period + cell;
        }
        QN_TRY(lay(g, count[l], cell));
        g->first_key = s->keys;
        s->keys += g->keys;
    }
    return QN_OK;
}

// Turns counts per key, kept one place on in start[], into first indices.
static void accumulate(int32_t *start, int64_t keys)
{
    for (int64_t k = 0; k < keys; k++) start[k + 1] += start[k];
}

static qn_status reserve(qn_sorter *s, const qn_world *w)
{
    QN_TRY(QN_RESERVE(s->start, s->start_room, s->keys + 2));
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
    memset(s->start, 0, (size_t)(s->keys + 2) * sizeof *s->start);
    for (int i = 0; i < w->count; i++) {
        const qn_place *p = &w->place[i];
        s->key[i] = (uint32_t)qn_grid_key_at(&s->grids[s->level[p->klass]], p);
        s->start[s->key[i] + 2]++;
    }
    accumulate(s->start + 1, s->keys);
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

// Adds the image of a particle at `rise` (m) above it, for the keys from `first` on.
static qn_status add_image(qn_sorter *s, const qn_place *p, double rise, int64_t first, int *n)
{
    QN_TRY(QN_RESERVE(s->images, s->image_room, *n + 1));
    qn_place *image = &s->images[(*n)++];
    *image = *p;
    image->z += rise;
    s->image_start[first + qn_grid_key_at(&s->grids[s->level[p->klass]], image) + 2]++;
    return QN_OK;
}

qn_status qn_sort_images(qn_sorter *s, qn_world *w, double skin, int *rising, int *count)
{
    int64_t keys = 2 * s->keys;
    int n = 0;
    QN_TRY(QN_RESERVE(s->image_start, s->image_start_room, keys + 2));
    memset(s->image_start, 0, (size_t)(keys + 2) * sizeof *s->image_start);
    *rising = *count = 0;
    if (w->period <= 0) return QN_OK;
    for (int i = 0; i < w->count; i++) {
        const qn_place *p = &w->place[i];
        double reach = w->classes[p->klass].radius + s->grids[s->level[p->klass]].radius + skin;
        if (p->z < reach) QN_TRY(add_image(s, p, w->period, 0, &n));
    }
    *rising = n;
    for (int i = 0; i < w->count; i++) {
        const qn_place *p = &w->place[i];
        int level = s->level[p->klass];
        if (level == 0) continue;
        double reach = w->classes[p->klass].radius + s->grids[level - 1].radius + skin;
        if (p->z >= w->period - reach) QN_TRY(add_image(s, p, -w->period, s->keys, &n));
    }
    QN_TRY(qn_population_reserve(w, w->count + n));
    accumulate(s->image_start + 1, keys);
    for (int k = 0; k < n; k++) {
        const qn_place *image = &s->images[k];
        int64_t key =
            qn_grid_key_at(&s->grids[s->level[image->klass]], image) + (k < *rising ? 0 : s->keys);
        w->place[w->count + s->image_start[key + 1]++] = *image;
    }
    *count = n;
    return QN_OK;
}

void qn_sorter_free(qn_sorter *s)
{
    if (!s) return;
    for (int l = 0; l < QN_LEVELS_MAX; l++)
        for (int axis = 0; axis < 3; axis++) free(s->grids[l].code[axis]);
    free(s->level);
    free(s->start), free(s->image_start), free(s->key), free(s->from), free(s->to);
    free(s->place), free(s->images), free(s->motion), free(s->id);
    free(s->carried), free(s->carried_row), free(s->gathered), free(s->gathered_owner);
    free(s->touches);
    free(s);
}
