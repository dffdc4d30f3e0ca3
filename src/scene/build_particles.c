// SPDX-License-Identifier: Apache-2.0
// Groups of spheres: sizes, amount, and where they are put.
#include "base/array.h"
#include "base/sizes.h"
#include "scene/build.h"
#include "scene/load.h"
#include "world/lining.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FILL_HCP, FILL_GRID, FILL_FILE, FILL_AT, FILL_FEED, FILL_LINING };

/// Fractions by mass become fractions by number, fraction / diameter^3; then they add up to 1.
static void finish_fractions(qn_group_def *g, bool by_mass)
{
    double sum = 0;
    for (int i = 0; i < g->size_count; i++) {
        double ratio = g->diameter[0] / g->diameter[i];
        if (by_mass) g->fraction[i] *= ratio * ratio * ratio;
        sum += g->fraction[i];
    }
    for (int i = 0; i < g->size_count; i++) g->fraction[i] /= sum;
}

static void read_sizes(qn_reader *r, const qn_group_keys *k, qn_group_def *g)
{
    bool good = true;
    for (const qn_node *c = k->sizes.node->first; c && good; c = c->next) {
        if (g->size_count == QN_SIZES_MAX) {
            qn_complain(r, &k->sizes, "has more than %d sizes", QN_SIZES_MAX);
            return;
        }
        char path[QN_NAME_MAX + 32];
        snprintf(path, sizeof path, "%s.sizes", k->sizes.path);
        qn_size_keys s;
        qn_section_read(r, QN_SECTION_SIZE, qn_section_entry(r, path, c, g->size_count), &s);
        good = s.diameter.set && s.fraction.set;
        g->diameter[g->size_count] = s.diameter.number;
        g->fraction[g->size_count++] = s.fraction.number;
    }
    if (g->size_count == 0)
        qn_complain(r, &k->sizes, "has no size");
    else if (good)
        finish_fractions(g, k->fractions_by.choice == 1);
}

/// The parameters of a formula: those of its kind are needed, others are mistakes.
static bool read_parameters(qn_reader *r, const qn_distribution_keys *k, qn_mark mark,
                            qn_size_def *d)
{
    static const char *const texts[] = {
#define K(NAME, text, first, second, meaning) text,
        QN_SIZE_KINDS(K)
#undef K
    };
    const qn_value *parameters[][2] = {
#define K(NAME, text, first, second, meaning) {&k->first, &k->second},
        QN_SIZE_KINDS(K)
#undef K
    };
    bool good = true;
    for (int kind = 0; kind < (int)(sizeof texts / sizeof *texts); kind++)
        for (int i = 0; i < 2; i++) {
            const qn_value *v = parameters[kind][i];
            bool wanted = kind == (int)d->kind;
            if (wanted && !v->node)
                qn_complain_at(r, mark, "%s lacks the key '%s' of a %s distribution: %s", v->path,
                               v->key->name, texts[kind], v->key->meaning);
            else if (!wanted && v->node)
                qn_complain(r, v, "means nothing where kind is %s", texts[d->kind]);
            good &= wanted == v->set && wanted == !!v->node;
        }
    d->first = parameters[d->kind][0]->number;
    d->second = parameters[d->kind][1]->number;
    return good;
}

static void read_distribution(qn_reader *r, const qn_group_keys *group, qn_group_def *g)
{
    qn_distribution_keys k;
    qn_section_from from = qn_section_under(r, &group->distribution);
    qn_section_read(r, QN_SECTION_DISTRIBUTION, from, &k);
    if (!k.kind.set) return;
    qn_size_def d = {.kind = (qn_size_kind)k.kind.choice,
                     .by_mass = k.by.choice == 0,
                     .min = k.min.number,
                     .max = k.max.number,
                     .classes = (int)k.classes.number};
    bool good = read_parameters(r, &k, from.mark, &d);
    if (!good || !k.by.set || !k.min.set || !k.max.set || !k.classes.set) return;
    if (!(d.min < d.max))
        qn_complain(r, &k.max, "must be above min, %g m", d.min);
    else if (qn_size_classes(&d, g->diameter, g->fraction, &g->size_count) != QN_OK)
        qn_complain_at(r, from.mark, "%s: %s", from.path, qn_error());
}

static void read_diameters(qn_reader *r, const qn_group_keys *k, qn_group_def *g, qn_mark mark,
                           bool from_file)
{
    const qn_value *ways[] = {&k->diameter, &k->sizes, &k->distribution}, *chosen = NULL;
    for (int i = 0; i < 3; i++) {
        if (!ways[i]->node) continue;
        if (chosen)
            qn_complain(r, ways[i], "cannot stand beside %s", chosen->key->name);
        else
            chosen = ways[i];
    }
    if (!chosen && !from_file)
        qn_complain_at(r, mark, "%s lacks the key 'diameter' (or 'sizes' or 'distribution'): %s",
                       k->diameter.path, k->diameter.key->meaning);
    else if (chosen == &k->sizes && k->sizes.set)
        read_sizes(r, k, g);
    else if (chosen == &k->distribution && k->distribution.set)
        read_distribution(r, k, g);
    else if (chosen == &k->diameter && k->diameter.set) {
        g->size_count = 1;
        g->diameter[0] = k->diameter.number;
        g->fraction[0] = 1;
    }
}

/// The way to fill: as written, or as the keys `at` and `file` imply; -1 where it could not be read.
static int fill_of(const qn_group_keys *k)
{
    if (k->fill.node) return k->fill.set ? k->fill.choice : -1;
    return k->at.node ? FILL_AT : k->file.node ? FILL_FILE : FILL_HCP;
}

/// Keys that only mean something for other ways to fill are mistakes.
static void check_fill(qn_reader *r, const qn_group_keys *k, int fill, qn_mark mark)
{
    static const char *const names[] = {"hcp", "grid", "file", "at", "feed", "lining"};
    const struct {
        const qn_value *value;
        unsigned fills;  // bits
    } only[] = {
        {&k->count, 3},  {&k->filling, 3},       {&k->mass, 3}, {&k->padding, 19},
        {&k->jitter, 3}, {&k->sizes, 19},        {&k->file, 4}, {&k->file_unit, 4},
        {&k->at, 8},     {&k->distribution, 19},
    };
    for (size_t i = 0; i < sizeof only / sizeof *only; i++)
        if (only[i].value->node && !(only[i].fills >> fill & 1))
            qn_complain(r, only[i].value, "means nothing where fill is %s", names[fill]);
    const qn_value *needed = fill == FILL_FILE ? &k->file : &k->at;
    if ((fill == FILL_FILE || fill == FILL_AT) && !needed->node)
        qn_complain_at(r, mark, "%s lacks the key '%s': %s", needed->path, needed->key->name,
                       needed->key->meaning);
}

static void read_amount(qn_reader *r, const qn_group_keys *k, qn_group_def *g, qn_mark mark)
{
    const qn_value *amounts[] = {&k->count, &k->filling, &k->mass};
    const qn_value *chosen = NULL;
    for (int i = 0; i < 3; i++) {
        if (!amounts[i]->node) continue;
        if (chosen)
            qn_complain(r, amounts[i], "is given besides %s; give one of count, filling, mass",
                        chosen->key->name);
        else {
            g->amount_kind = (qn_amount)i;
            g->amount = amounts[i]->number;
        }
        chosen = amounts[i];
    }
    if (!chosen)
        qn_complain_at(r, mark, "%s lacks an amount: one of the keys count, filling, mass",
                       k->count.path);
    if (k->filling.node && !r->def->drum.present)
        qn_complain(r, &k->filling,
                    "is a share of the drum, but there is no drum; use count or mass");
}

/// Index of a diameter among the sizes of the group, which grows by it if it is new; -1 if there are
/// too many.
static int size_index(qn_group_def *g, double diameter)
{
    for (int i = 0; i < g->size_count; i++)
        if (g->diameter[i] == diameter) return i;
    if (g->size_count == QN_SIZES_MAX) return -1;
    g->diameter[g->size_count] = diameter;
    return g->size_count++;
}

/// Sizes of spheres from a file become the sizes of the group.
static qn_status take_sizes(qn_reader *r, const qn_group_keys *k, qn_group_def *g,
                            const qn_particle_list *list)
{
    g->size_count = 0;
    QN_TRY(QN_ALLOCATE(g->list_size, list->count));
    for (int64_t i = 0; i < list->count; i++) {
        double d = list->diameter[i];
        g->list_size[i] = d > 0 ? size_index(g, d) : -1;
        if (g->list_size[i] < 0) {
            if (d > 0)
                qn_complain(r, &k->file, "holds more than %d different diameters", QN_SIZES_MAX);
            else
                qn_complain(r, &k->file, "holds a diameter of %g m; it must be above 0", d);
            return QN_OK;
        }
        g->fraction[g->list_size[i]] += 1 / (double)list->count;
    }
    return QN_OK;
}

static qn_status read_list(qn_reader *r, const qn_group_keys *k, qn_group_def *g, qn_mark mark)
{
    char path[QN_PATH_MAX];
    if (!k->file.set || !qn_file_of(r, &k->file, path)) return QN_OK;
    qn_particle_list list;
    if (qn_load_particles(path, k->file_unit.number, &list) != QN_OK) {
        qn_complain(r, &k->file, "cannot be used: %s", qn_error());
        return QN_OK;
    }
    g->list_count = list.count < INT32_MAX ? (int)list.count : 0;
    g->list_position = list.position;
    g->list_velocity = list.velocity;
    g->list_spin = list.spin;
    list.position = list.velocity = list.spin = NULL;
    qn_status status = QN_OK;
    if (g->list_count == 0)
        qn_complain(r, &k->file,
                    "holds %lld spheres; at least one is needed and at most 2147483647",
                    (long long)list.count);
    else if (!k->diameter.node && list.diameter)
        status = take_sizes(r, k, g, &list);
    else if (!k->diameter.node)
        qn_complain_at(r, mark, "%s lacks the key 'diameter', which is not in its file either",
                       k->file.path);
    qn_particle_list_free(&list);
    return status;
}

/// Spheres along the shell become a list.
static qn_status read_lining(qn_reader *r, const qn_group_keys *k, qn_group_def *g)
{
    const qn_drum_def *d = &r->def->drum;
    if (!d->present)
        qn_complain(r, &k->fill, "goes along the shell of a drum, but there is no drum");
    else if (d->lifter_count > 0 || d->profile_count > 0)
        qn_complain(r, &k->fill, "goes along a smooth shell: leave out drum.%s",
                    d->lifter_count > 0 ? "lifters" : "profile");
    else if (k->shape.choice != 0)
        qn_complain(r, &k->fill, "is for spheres, not for clumps");
    if (r->messages->errors > 0 || g->size_count != 1) return QN_OK;
    double diameter = g->diameter[0];
    qn_lining lining = qn_lining_of(d, diameter);
    int least = d->ends == QN_ENDS_PERIODIC ? 2 : 1;
    if (lining.around < 3 || lining.rings < least || lining.rings > INT32_MAX / 4 / lining.around) {
        qn_complain(r, &k->diameter,
                    "makes a lining of %lld spheres around and %lld rings; at "
                    "least 3 and %d are needed, at most %d spheres",
                    (long long)lining.around, (long long)lining.rings, least, INT32_MAX / 4);
        return QN_OK;
    }
    g->lining = true;
    QN_TRY(QN_ALLOCATE(g->list_position, 3 * lining.around * lining.rings));
    for (int64_t ring = 0; ring < lining.rings; ring++)
        for (int64_t i = 0; i < lining.around; i++) {
            qn_vec3 x = qn_lining_centre(&lining, d, diameter, ring, i);
            double *out = &g->list_position[3 * g->list_count++];
            out[0] = x.x, out[1] = x.y, out[2] = x.z;
        }
    return QN_OK;
}

/// Fixed, turning with the drum, or free.
static void read_motion(qn_reader *r, const qn_group_keys *k, qn_group_def *g)
{
    g->fixed = k->fixed.choice == 1;
    g->turning = k->turning.choice == 1;
    g->velocity = qn_vector_of(&k->velocity);
    g->spin = qn_vector_of(&k->spin);
    if (g->fixed && g->turning)
        qn_complain(r, &k->turning, "cannot stand beside fixed: yes");
    else if (g->turning && !r->def->drum.present)
        qn_complain(r, &k->turning, "needs a drum to turn with");
    else if (g->turning && k->shape.choice != 0)
        qn_complain(r, &k->turning, "is for spheres, not for clumps");
    const char *why = g->fixed ? "are fixed" : "turn with the drum";
    if ((g->fixed || g->turning) && k->velocity.node && qn_norm(g->velocity) > 0)
        qn_complain(r, &k->velocity, "means nothing for particles that %s", why);
    if ((g->fixed || g->turning) && k->spin.node && qn_norm(g->spin) > 0)
        qn_complain(r, &k->spin, "means nothing for particles that %s", why);
}

/// A list from a file; what is held has no velocity of its own, whatever a recording says.
static qn_status read_file(qn_reader *r, const qn_group_keys *k, qn_group_def *g, qn_mark mark)
{
    QN_TRY(read_list(r, k, g, mark));
    if (!g->fixed && !g->turning) return QN_OK;
    free(g->list_velocity), free(g->list_spin);
    g->list_velocity = g->list_spin = NULL;
    return QN_OK;
}

static qn_status read_group(qn_reader *r, const qn_node *node)
{
    qn_group_def *g = &r->def->groups[r->def->group_count];
    if (!qn_name_read(r, node, "group of particles", g->name)) return QN_OK;
    r->def->group_count++;
    qn_section_from from = qn_section_entry(r, "particles", node, -1);
    qn_group_keys k;
    qn_section_read(r, QN_SECTION_GROUP, from, &k);
    g->material = qn_material_of(&k.material);
    g->padding = k.padding.number;
    g->jitter = k.jitter.number;
    read_motion(r, &k, g);
    int fill = fill_of(&k);
    if (fill < 0) return QN_OK;
    check_fill(r, &k, fill, from.mark);
    read_diameters(r, &k, g, from.mark, fill == FILL_FILE);
    g->packing = fill == FILL_HCP    ? QN_PACK_HCP
                 : fill == FILL_GRID ? QN_PACK_GRID
                 : fill == FILL_FEED ? QN_PACK_FEED
                                     : QN_PACK_LIST;
    QN_TRY(qn_build_shape(r, &k, from.mark, g));
    if (fill <= FILL_GRID) {
        read_amount(r, &k, g, from.mark);
        return QN_OK;
    }
    if (fill == FILL_FEED) return QN_OK;
    if (fill == FILL_FILE)
        QN_TRY(read_file(r, &k, g, from.mark));
    else if (fill == FILL_LINING)
        QN_TRY(read_lining(r, &k, g));
    else {
        QN_TRY(QN_ALLOCATE(g->list_position, 3));
        memcpy(g->list_position, k.at.vector, sizeof k.at.vector);
        g->list_count = 1;
    }
    g->amount_kind = QN_AMOUNT_COUNT;
    g->amount = g->list_count;
    return QN_OK;
}

qn_status qn_build_particles(qn_reader *r, const qn_scene_keys *scene)
{
    const qn_node *nodes[QN_NAMES_MAX];
    int count = qn_names_read(r, &scene->particles, nodes);
    QN_TRY(QN_ALLOCATE(r->def->groups, count));
    QN_TRY(QN_ALLOCATE(r->def->shapes, count));
    for (int i = 0; i < count; i++) QN_TRY(read_group(r, nodes[i]));
    if (count == 0 && scene->particles.set)
        qn_complain_at(r, scene->particles.mark, "particles has no entry; at least one is needed");
    return QN_OK;
}
