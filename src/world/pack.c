// SPDX-License-Identifier: Apache-2.0
#include "world/pack.h"
#include "base/random.h"
#include "world/classes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The sites of a lattice and what is put on them.
typedef struct lattice {
    qn_vec3 low, high;  // m   the box it fills
    bool periodic;      //     along z
    double pad;         // m   padded radius of the largest particle
    bool cubic;
    int64_t count, room;
    qn_vec3 *sites;  //     owned, bottom first
} lattice;

enum { STREAM_DEAL = 1, STREAM_JITTER = 2 };

// Number of particles a group asks for.
static int64_t wanted(const qn_def *def, const qn_group_def *group, const qn_walls *walls)
{
    double volume = 0;  // m3   of a mean particle
    for (int s = 0; s < group->size_count; s++)
        volume += group->fraction[s] * QN_PI / 6 * pow(group->diameter[s], 3);
    double amount = group->amount;
    if (group->amount_kind == QN_AMOUNT_FILLING)
        amount *= qn_walls_volume(walls) * def->bed_solidity / volume;
    if (group->amount_kind == QN_AMOUNT_MASS)
        amount /= def->materials[group->material].density * volume;
    return (int64_t)floor(amount + 0.5);
}

// The box that walls leave for packing: the drum's, or that of planes along the axes.
static qn_status box_of(const qn_def *def, const qn_walls *walls, lattice *lat)
{
    lat->low = qn_v3(-INFINITY, -INFINITY, -INFINITY);
    lat->high = qn_v3(INFINITY, INFINITY, INFINITY);
    if (def->drum.present) {
        double r = def->drum.diameter / 2;
        lat->low = qn_v3(-r, -r, 0);
        lat->high = qn_v3(r, r, def->drum.length);
        lat->periodic = def->drum.ends == QN_ENDS_PERIODIC;
    }
    for (int i = 0; i < walls->plane_count; i++) {
        const qn_plane_def *p = &walls->planes[i];
        if (p->normal.x == 1) lat->low.x = qn_max(lat->low.x, p->point.x);
        if (p->normal.y == 1) lat->low.y = qn_max(lat->low.y, p->point.y);
        if (p->normal.z == 1) lat->low.z = qn_max(lat->low.z, p->point.z);
        if (p->normal.x == -1) lat->high.x = qn_min(lat->high.x, p->point.x);
        if (p->normal.y == -1) lat->high.y = qn_min(lat->high.y, p->point.y);
        if (p->normal.z == -1) lat->high.z = qn_min(lat->high.z, p->point.z);
    }
    qn_vec3 size = qn_sub(lat->high, lat->low);
    if (!(isfinite(size.x) && isfinite(size.y) && isfinite(size.z)))
        return qn_fail(QN_INPUT, "particles: packing needs a drum or a closed box of walls; place "
                                 "single particles with 'at' or a file");
    return QN_OK;
}

static qn_status add_site(lattice *lat, qn_vec3 site)
{
    QN_TRY(QN_RESERVE(lat->sites, lat->room, lat->count + 1));
    lat->sites[lat->count++] = site;
    return QN_OK;
}

// Hexagonal close packing: triangular layers in x-z, rows along z, layers ABAB upwards. A periodic
// row is stretched to close on itself. Conway & Sloane (1999), Sphere Packings, 1.3.
static qn_status fill_hcp(lattice *lat)
{
    double r = lat->pad, length = lat->high.z - lat->low.z;
    double pitch = 2 * r, layer = 2 * r * sqrt(6.0) / 3, row = r * sqrt(3.0);
    int per_row = (int)floor(length / pitch * (1 + 1e-12));
    if (lat->periodic && per_row > 0) pitch = length / per_row;
    for (int j = 0; lat->low.y + r + j * layer <= lat->high.y - r; j++)
        for (int i = 0; lat->low.x + r + i * row <= lat->high.x - r; i++)
            for (int k = 0; k < per_row; k++) {
                bool shifted = (i + j) % 2 != 0;  // rows of B layers lie between those of A
                double z = lat->low.z + r + (k + (shifted ? 0.5 : 0)) * pitch;
                double x = lat->low.x + r + i * row + (j % 2 ? row / 3 : 0);
                if (!lat->periodic && z > lat->high.z - r * (1 - 1e-12)) continue;
                QN_TRY(add_site(lat, qn_v3(x, lat->low.y + r + j * layer, z)));
            }
    return QN_OK;
}

static qn_status fill_cubic(lattice *lat)
{
    double r = lat->pad, pitch = 2 * r, along = pitch;
    int per_row = (int)floor((lat->high.z - lat->low.z) / pitch * (1 + 1e-12));
    if (lat->periodic && per_row > 0) along = (lat->high.z - lat->low.z) / per_row;
    for (double y = lat->low.y + r; y <= lat->high.y - r; y += pitch)
        for (double x = lat->low.x + r; x <= lat->high.x - r; x += pitch)
            for (int k = 0; k < per_row; k++)
                QN_TRY(add_site(lat, qn_v3(x, y, lat->low.z + r + k * along)));
    return QN_OK;
}

// Drops the sites that do not clear walls and the spheres already placed.
static void keep_clear(lattice *lat, const qn_walls *walls, const qn_class *classes,
                       const qn_seedling *placed, int placed_count)
{
    qn_pose pose = qn_walls_pose(walls, 0);
    int64_t kept = 0;
    for (int64_t i = 0; i < lat->count; i++) {
        bool clear = qn_walls_clearance(walls, &pose, lat->sites[i]) >= lat->pad * (1 - 1e-12);
        for (int k = 0; clear && k < placed_count; k++) {
            qn_vec3 d = qn_sub(lat->sites[i], placed[k].position);
            double length = lat->high.z - lat->low.z;
            if (lat->periodic) d.z -= length * floor(d.z / length + 0.5);
            double apart = qn_norm(d);
            clear = apart >= lat->pad + classes[placed[k].klass].bound;
        }
        if (clear) lat->sites[kept++] = lat->sites[i];
    }
    lat->count = kept;
}

// Classes for `total` sites in exact proportions, dealt at random. labels: total, filled here.
static void deal(const qn_def *def, const int64_t *group_wanted, int32_t *labels, int64_t total)
{
    int64_t at = 0;
    int32_t klass = 0;
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *group = &def->groups[k];
        double share = 0;
        int64_t done = 0;
        for (int s = 0; s < group->size_count; s++, klass++) {
            share += group->fraction[s];
            int64_t upto = s + 1 == group->size_count
                               ? group_wanted[k]
                               : (int64_t)floor(share * (double)group_wanted[k] + 0.5);
            for (; done < upto; done++) labels[at++] = klass;
        }
    }
    for (int64_t i = total - 1; i > 0; i--) {  // Fisher & Yates, by Durstenfeld (1964)
        uint64_t bits = qn_random_bits(def->seed, STREAM_DEAL, (uint64_t)i);
        int64_t j = (int64_t)(bits % (uint64_t)(i + 1));
        int32_t label = labels[i];
        labels[i] = labels[j], labels[j] = label;
    }
}

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
            if (!g->fixed && !g->shape && clear < radius * (1 - QN_OVERLAP_WARN))
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

// Puts the packed groups on the lattice's sites, bottom first.
static qn_status place_packed(const qn_def *def, const qn_class *classes, const lattice *lat,
                              const int64_t *group_wanted, int64_t total, qn_seedling *out,
                              int *count)
{
    int32_t *labels;
    QN_TRY(QN_ALLOCATE(labels, total));
    deal(def, group_wanted, labels, total);
    for (int64_t i = 0; i < total; i++) {
        const qn_class *c = &classes[labels[i]];
        const qn_group_def *g = &def->groups[c->group];
        qn_vec3 at = jittered(def, g, lat->sites[i], c->bound, (uint64_t)i);
        out[(*count)++] = (qn_seedling){at, g->velocity, g->spin, labels[i]};
    }
    free(labels);
    return QN_OK;
}

// What the packed groups ask for together, and the padding and lattice they share.
static int64_t plan(const qn_def *def, const qn_walls *walls, lattice *lat, int64_t *group_wanted)
{
    int64_t total = 0;
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *g = &def->groups[k];
        if (g->packing == QN_PACK_LIST) continue;
        group_wanted[k] = wanted(def, g, walls);
        total += group_wanted[k];
        lat->cubic |= g->packing == QN_PACK_GRID;
        double bound = g->shape ? def->shapes[g->shape - 1].bound : 1;
        for (int s = 0; s < g->size_count; s++)
            lat->pad = qn_max(lat->pad, bound * g->diameter[s] / 2 * (1 + g->padding));
    }
    return total;
}

// The key that asks for the particles of the first packed group, as "particles.balls.count".
static const char *amount_path(const qn_def *def, char path[2 * QN_NAME_MAX])
{
    static const char *const keys[] = {"count", "filling", "mass"};
    const qn_group_def *g = def->groups;
    while (g->packing == QN_PACK_LIST) g++;
    snprintf(path, 2 * QN_NAME_MAX, "particles.%s.%s", g->name, keys[g->amount_kind]);
    return path;
}

static qn_status pack_all(const qn_def *def, const qn_class *classes, const qn_walls *walls,
                          lattice *lat, int64_t *group_wanted, qn_seedling **seedlings, int *count)
{
    char path[2 * QN_NAME_MAX];
    int64_t total = plan(def, walls, lat, group_wanted), listed = 0;
    for (int k = 0; k < def->group_count; k++)
        if (def->groups[k].packing == QN_PACK_LIST) listed += def->groups[k].list_count;
    if (total + listed < 1)
        return qn_fail(QN_INPUT,
                       "particles: there are none; give count, filling, mass, at or file");
    if (total + listed > INT32_MAX / 4)
        return qn_fail(QN_INPUT, "particles: %lld are too many, at most %d fit one machine",
                       (long long)(total + listed), INT32_MAX / 4);
    QN_TRY(QN_ALLOCATE(*seedlings, total + listed));
    QN_TRY(place_lists(def, classes, walls, *seedlings, count));
    if (total == 0) return QN_OK;
    QN_TRY(box_of(def, walls, lat));
    QN_TRY(lat->cubic ? fill_cubic(lat) : fill_hcp(lat));
    keep_clear(lat, walls, classes, *seedlings, *count);
    if (lat->count < total)
        return qn_fail(QN_INPUT, "%s: %lld do not fit, at most %lld do (%s, padded radius %g m)",
                       amount_path(def, path), (long long)total, (long long)lat->count,
                       lat->cubic ? "grid" : "hcp", lat->pad);
    return place_packed(def, classes, lat, group_wanted, total, *seedlings, count);
}

qn_status qn_pack(const qn_def *def, const qn_class *classes, const qn_walls *walls,
                  qn_seedling **seedlings, int *count)
{
    lattice lat = {0};
    int64_t *group_wanted;
    *seedlings = NULL, *count = 0;
    QN_TRY(QN_ALLOCATE(group_wanted, def->group_count));
    qn_status status = pack_all(def, classes, walls, &lat, group_wanted, seedlings, count);
    if (status != QN_OK) free(*seedlings), *seedlings = NULL;
    free(group_wanted);
    free(lat.sites);
    return status;
}
