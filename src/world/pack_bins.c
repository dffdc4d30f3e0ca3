// SPDX-License-Identifier: Apache-2.0
#include "base/random.h"
#include "world/lattice.h"
#include "world/pack_plan.h"

#include <stdlib.h>

#define BIN_RATIO 1.25  // 1   between the radii of two bins (1.25 to 2 tried: packs closest)
#define SCARCE 64       // 1   sites for each sphere: from here on some are drawn, not all looked at

#define MOST_SITES 100000000000  // 1   that are gone through from the bottom up

enum { STREAM_DEAL = 1, STREAM_SITES = 16 };

// Classes of a bin's spheres, dealt at random.
static void deal(const qn_pack_plan *p, qn_pack_bin *b, int number, const int32_t *members,
                 int member_count)
{
    int64_t at = 0;
    for (int m = 0; m < member_count; m++)
        for (int64_t n = 0; n < p->counts[members[m]]; n++) b->labels[at++] = members[m];
    uint64_t seed = p->def->seed + (uint64_t)number;
    for (int64_t i = b->count - 1; i > 0; i--) {  // Fisher & Yates, by Durstenfeld (1964)
        uint64_t bits = qn_random_bits(seed, STREAM_DEAL, (uint64_t)i);
        int64_t j = (int64_t)(bits % (uint64_t)(i + 1));
        int32_t label = b->labels[i];
        b->labels[i] = b->labels[j], b->labels[j] = label;
    }
}

qn_status qn_pack_sort(qn_pack_plan *p, int32_t *members)
{
    int n = 0;
    for (int32_t c = 0; c < p->class_count; c++)
        if (p->counts[c] > 0) members[n++] = c;
    for (int i = 1; i < n; i++)  // by falling size; those of one size stay in order
        for (int j = i;
             j > 0 && qn_padded_radius(p, members[j - 1]) < qn_padded_radius(p, members[j]); j--) {
            int32_t c = members[j];
            members[j] = members[j - 1], members[j - 1] = c;
        }
    QN_TRY(QN_ALLOCATE(p->bins, n));
    for (int from = 0, to; from < n; from = to) {
        qn_pack_bin *b = &p->bins[p->bin_count];
        b->radius = qn_padded_radius(p, members[from]);
        for (to = from; to < n && qn_padded_radius(p, members[to]) * BIN_RATIO > b->radius; to++)
            b->count += p->counts[members[to]];
        QN_TRY(QN_ALLOCATE(b->labels, b->count));
        deal(p, b, p->bin_count++, members + from, to - from);
    }
    return QN_OK;
}

// A lattice of a bin, and whether a site of it can be used.
typedef struct sites {
    qn_lattice lattice;
    qn_pose pose;
    int64_t count;
} sites;

static bool is_free(const qn_pack_plan *p, const sites *s, int64_t number, qn_vec3 *centre)
{
    double radius = s->lattice.radius;
    return qn_lattice_site(&s->lattice, number, centre)
           && qn_occupied_is_free(&p->occupied, *centre, radius)
           && qn_walls_clearance(p->walls, &s->pose, *centre) >= radius * (1 - 1e-12);
}

static void put(qn_pack_plan *p, int64_t at, qn_vec3 centre, int32_t klass)
{
    p->out[at] = (qn_seedling){.position = centre, .klass = klass};
}

// Takes free sites in a random order until there are `wanted`. Good where few of many are wanted.
static int64_t take_at_random(qn_pack_plan *p, int number, const sites *s, int64_t wanted,
                              int64_t first)
{
    int64_t done = 0;
    for (int64_t k = 0; k < s->count && done < wanted; k++) {
        qn_vec3 centre;
        int64_t site = qn_shuffled(p->def->seed, STREAM_SITES + (uint64_t)number, k, s->count);
        if (!is_free(p, s, site, &centre)) continue;
        put(p, first + done, centre, p->bins[number].labels[done]);
        done++;
    }
    return done;
}

// Looks at all sites from the bottom up and takes `wanted` of the free ones, each choice of them as
// likely as any. Source: Knuth (1997), The Art of Computer Programming 2, 3.4.2, algorithm S.
static qn_status take_share(qn_pack_plan *p, int number, const sites *s, int64_t wanted,
                            int64_t first, int64_t *done)
{
    unsigned char *usable;
    int64_t left = 0;
    QN_TRY(QN_ALLOCATE(usable, s->count));
#pragma omp parallel for schedule(static) reduction(+ : left)
    for (int64_t k = 0; k < s->count; k++) {
        qn_vec3 centre;
        usable[k] = is_free(p, s, k, &centre);
        left += usable[k];
    }
    *done = 0;
    for (int64_t k = 0; k < s->count && *done < wanted; k++) {
        qn_vec3 centre;
        if (!usable[k]) continue;
        double u = qn_random(p->def->seed, STREAM_SITES + (uint64_t)number, (uint64_t)k);
        if (u * (double)left-- >= (double)(wanted - *done)) continue;
        qn_lattice_site(&s->lattice, k, &centre);
        put(p, first + *done, centre, p->bins[number].labels[*done]);
        ++*done;
    }
    free(usable);
    return QN_OK;
}

// Takes the lowest free sites.
static int64_t take_lowest(qn_pack_plan *p, const sites *s, int64_t wanted, int64_t first)
{
    int64_t done = 0;
    for (int64_t k = 0; k < s->count && done < wanted; k++) {
        qn_vec3 centre;
        if (!is_free(p, s, k, &centre)) continue;
        put(p, first + done, centre, p->bins[0].labels[done]);
        done++;
    }
    return done;
}

// Puts up to `wanted` spheres of a bin on free sites of its lattice below y = top (m): from the bottom
// up if it is the only bin, else at random. *done is how many found room.
static qn_status fill_bin(qn_pack_plan *p, int number, double top, int64_t wanted, int64_t first,
                          int64_t *done)
{
    const qn_pack_bin *b = &p->bins[number];
    sites s = {qn_lattice_lay(p->low, p->high, p->periodic, p->cubic, b->radius),
               qn_walls_pose(p->walls, 0), 0};
    s.count = qn_lattice_below(&s.lattice, top);
    if (p->bin_count == 1 && s.count > MOST_SITES)
        return qn_fail(QN_INPUT,
                       "particles: spheres of radius %g m are too small to be packed in a region "
                       "of %g x %g x %g m",
                       b->radius, p->high.x - p->low.x, p->high.y - p->low.y, p->high.z - p->low.z);
    if (p->bin_count > 1 && s.count < SCARCE * wanted)
        return take_share(p, number, &s, wanted, first, done);
    *done = p->bin_count > 1 ? take_at_random(p, number, &s, wanted, first)
                             : take_lowest(p, &s, wanted, first);
    return QN_OK;
}

// Spheres that are in the way: the listed ones, then those of the bins before.
static qn_status occupy(qn_pack_plan *p, int64_t from, int64_t to)
{
    for (int64_t i = from; i < to; i++) {
        const qn_seedling *s = &p->out[i];
        double radius = i < p->listed ? p->classes[s->klass].bound : qn_padded_radius(p, s->klass);
        QN_TRY(qn_occupied_add(&p->occupied, s->position, radius));
    }
    return QN_OK;
}

// Packs a share of every bin below y = top. *placed is the number that found room, *solid their share
// of the volume wanted.
static qn_status try_packing(qn_pack_plan *p, double share, double top, int64_t *placed,
                             double *solid)
{
    double volume = 0, filled = 0;  // m3
    bool full = false;
    *placed = 0;
    qn_occupied_clear(&p->occupied);
    QN_TRY(occupy(p, 0, p->listed));
    for (int k = 0; k < p->bin_count; k++) {
        const qn_pack_bin *b = &p->bins[k];
        int64_t wanted = (int64_t)floor(share * (double)b->count + 0.5),
                first = p->listed + *placed;
        double ball = qn_ball_volume(b->radius);
        int64_t done = 0;
        if (!full) QN_TRY(fill_bin(p, k, top, wanted, first, &done));
        full |= done < wanted;
        if (k + 1 < p->bin_count) QN_TRY(occupy(p, first, first + done));
        volume += (double)wanted * ball, filled += (double)done * ball;
        *placed += done;
    }
    *solid = full ? filled / volume : 1;
    return QN_OK;
}

// Volume (m3) of the box, or of the drum in it, up to a height (m) above its bottom.
static double volume_below(const qn_pack_plan *p, double height)
{
    double r = p->def->drum.diameter / 2, length = p->high.z - p->low.z;
    double c = qn_max(-1, qn_min(1, 1 - height / r));
    if (!p->def->drum.present) return height * (p->high.x - p->low.x) * length;
    return r * r * (acos(c) - c * sqrt(1 - c * c)) * length;
}

// The height that the bins take at first: they pack to 0.32 of the space where they differ little and
// 0.48 at 1:10 (measured on equal masses).
static double first_height(const qn_pack_plan *p)
{
    double solid = 0, low = 0, high = p->high.y - p->low.y;
    for (int k = 0; k < p->bin_count; k++)
        solid += (double)p->bins[k].count * qn_ball_volume(p->bins[k].radius);
    double spread = p->bins[0].radius / p->bins[p->bin_count - 1].radius;
    double space = solid / (0.32 + 0.16 * qn_min(1, log10(spread)));
    for (int k = 0; k < 50; k++) {
        double middle = 0.5 * (low + high);
        if (volume_below(p, middle) < space)
            low = middle;
        else
            high = middle;
    }
    return high + 2 * p->bins[0].radius;
}

qn_status qn_pack_bins(qn_pack_plan *p, int64_t *fit)
{
    double height = p->high.y - p->low.y, share;
    double top = p->bin_count == 1 ? height : first_height(p);
    for (;; top *= qn_max(1.05, 1.02 / share)) {
        if (!(top < height)) top = height;
        QN_TRY(try_packing(p, 1, p->low.y + top, fit, &share));
        if (share >= 1 || top >= height) break;
    }
    if (share >= 1 || p->bin_count == 1) return QN_OK;
    double low = 0, high = 1;  // shares of all that fit, and do not
    *fit = 0;
    for (int k = 0; k < 6; k++) {
        double middle = 0.5 * (low + high);
        int64_t placed;
        QN_TRY(try_packing(p, middle, p->high.y, &placed, &share));
        if (share >= 1)
            low = middle, *fit = placed;
        else
            high = middle;
    }
    return QN_OK;
}
