// SPDX-License-Identifier: Apache-2.0
// Contacts between the particles of one share, eight at a time. Compiled once per instruction set, with
// QN_ISA naming it.
//
// Touching pairs are queued by their pair of classes, so that a block of eight shares one law and one
// set of coefficients; a full queue is gathered into columns, evaluated side by side (block.c), and
// added to the loads as integers.
#include "step/cpu/lanes/sums.h"
#include "step/cpu/lanes/turn.h"

#include <string.h>

static qn_load *load_of(qn_world *w, qn_share *share, int home)
{
    return home >= share->first && home < share->last ? &w->load[home] : &share->spill[home];
}

// Three columns of a block, of one side or of side a less side b.
static void put_columns(columns3 *to, double (*from)[W])
{
    memcpy(to->x, from[0], sizeof to->x);
    memcpy(to->y, from[1], sizeof to->y);
    memcpy(to->z, from[2], sizeof to->z);
}

static void put_difference(columns3 *to, double (*a)[W], double (*b)[W])
{
    for (int l = 0; l < W; l++) to->x[l] = a[0][l] - b[0][l];
    for (int l = 0; l < W; l++) to->y[l] = a[1][l] - b[1][l];
    for (int l = 0; l < W; l++) to->z[l] = a[2][l] - b[2][l];
}

// Lays the pairs of a queue out in the columns of a block; a lane without a pair repeats the first.
static void gather_pairs(const qn_world *w, const qn_share *share, const queue *q, block *b)
{
    const double *place[2][W], *motion[2][W], *slip[W];
    double x[2][4][W], v[2][12][W], kept[4][W];
    for (int l = 0; l < W; l++) {
        int from = l < q->count ? l : 0;
        const qn_place *pa = &w->place[q->a[from]], *pb = &w->place[q->b[from]];
        place[0][l] = &pa->x, place[1][l] = &pb->x;
        motion[0][l] = (const double *)&w->motion[pa->home];
        motion[1][l] = (const double *)&w->motion[pb->home];
        slip[l] = &share->slip[q->slot[from]].x;
    }
    for (int side = 0; side < 2; side++) {
        qn_turn(place[side], x[side]);
        for (int part = 0; part < 3; part++) {
            qn_turn(motion[side], v[side] + 4 * part);
            for (int l = 0; l < W; l++) motion[side][l] += 4;
        }
    }
    qn_turn(slip, kept);
    put_difference(&b->between, x[0], x[1]);
    put_difference(&b->velocity, v[0], v[1]);
    put_columns(&b->spin_a, v[0] + 3);
    put_columns(&b->spin_b, v[1] + 3);
    put_difference(&b->kick, v[0] + 6, v[1] + 6);
    put_columns(&b->spin_kick_a, v[0] + 9);
    put_columns(&b->spin_kick_b, v[1] + 9);
    put_columns(&b->slip, kept);
    memset(&b->last, 0, sizeof b->last);
    if (!share->roll) return;
    for (int l = 0; l < W; l++) slip[l] = &share->roll[q->slot[l < q->count ? l : 0]].x;
    qn_turn(slip, kept);
    put_columns(&b->roll, kept);
}

// Evaluates the pairs queued for classes (a, b); a lane without a pair repeats the first.
static void flush_pairs(qn_world *w, qn_share *share, int classes, qn_mode mode)
{
    workspace *work = share->workspace;
    queue *q = &work->pairs[classes];
    block *b = &work->block;
    const qn_class *ca = &w->classes[classes / w->class_count];
    const qn_class *cb = &w->classes[classes % w->class_count];
    if (q->count == 0) return;
    gather_pairs(w, share, q, b);
    JOIN(qn_block_evaluate, QN_ISA)(w->laws[classes], &w->pairs[classes], &w->reaches[classes], b);
    quantise(b, ca, cb);
    for (int l = 0; l < q->count; l++) {
        add_load(load_of(w, share, w->place[q->a[l]].home), b, 0, l);
        add_load(load_of(w, share, w->place[q->b[l]].home), b, 1, l);
    }
    if (mode == QN_COMMIT)
        for (int l = 0; l < q->count; l++) {
            qn_memory_set(share, q->slot[l],
                          (qn_memory){GET(b->next_slip, l), GET(b->next_roll, l)});
            share->touching[q->slot[l]] = 1;
        }
    tally(w, share->sums, b, q->count, qn_min(ca->radius, cb->radius));
    share->sums->contacts += q->count;
    q->count = 0;
}

// Puts the pairs found to touch into their queues.
static void queue_pairs(qn_world *w, qn_share *share, int count, qn_mode mode)
{
    workspace *work = share->workspace;
    for (int t = 0; t < count; t++) {
        const found_pair *found = &work->found[t];
        int classes = w->place[found->a].klass * w->class_count + w->place[found->b].klass;
        queue *waiting = &work->pairs[classes];
        int c = waiting->count++;
        waiting->a[c] = found->a, waiting->b[c] = found->b, waiting->slot[c] = found->slot;
        if (c == W - 1) flush_pairs(w, share, classes, mode);
    }
}

static void part(qn_share *share, int64_t k)
{
    share->touching[k] = 0;
    qn_memory_set(share, k, (qn_memory){{0, 0, 0}, {0, 0, 0}});
}

// The distance check of the whole list: pairs that touch are noted without a branch, as whether one does
// can't be foretold, and worked on some hundred at a time; those that no longer do forget.
void JOIN(qn_lanes_pairs, QN_ISA)(qn_world *w, qn_share *share, qn_mode mode)
{
    workspace *work = share->workspace;
    const qn_place *place = w->place;
    const double *touch2 = w->neighbours->touch2;
    int n = w->class_count, found = 0;
    for (int i = share->first; i < share->last; i++) {
        const qn_place p = place[i];
        const double *reach2 = touch2 + (int64_t)p.klass * n;
        int64_t end = share->row[i - share->first + 1];
        for (int64_t k = share->row[i - share->first]; k < end; k++) {
            bool lower;
            int j = qn_partner(share, k, &lower);
            const qn_place *q = &place[j];
            double x = p.x - q->x, y = p.y - q->y, z = p.z - q->z;
            bool touches = x * x + y * y + z * z < reach2[q->klass];
            work->found[found] = (found_pair){lower ? j : i, lower ? i : j, k};
            found += touches;
            if (share->touching[k] > touches && mode == QN_COMMIT) part(share, k);
            if (found == FOUND) queue_pairs(w, share, found, mode), found = 0;
        }
    }
    queue_pairs(w, share, found, mode);
    for (int c = 0; c < n * n; c++) flush_pairs(w, share, c, mode);
}
