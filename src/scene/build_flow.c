// SPDX-License-Identifier: Apache-2.0
// Feeds and outlets: where particles come in and leave while running.
#include "base/array.h"
#include "scene/build.h"
#include "scene/units.h"

#include <string.h>

/// A box or a piece of a plane: exactly one of them, whole. False with a message.
static bool read_region(qn_reader *r, qn_mark mark, const qn_value *const box[2],
                        const qn_value *const plane[2], bool *is_box)
{
    *is_box = box[0]->node || box[1]->node;
    const qn_value *const *mine = *is_box ? box : plane, *const *other = *is_box ? plane : box;
    bool good = true;
    for (int i = 0; i < 2; i++) {
        if (other[i]->node) qn_complain(r, other[i], "cannot stand beside %s", mine[0]->key->name);
        if (!mine[i]->node)
            qn_complain_at(r, mark, "%s needs either the keys '%s' and '%s' or '%s' and '%s'",
                           box[0]->path, box[0]->key->name, box[1]->key->name, plane[0]->key->name,
                           plane[1]->key->name);
        good = good && !other[i]->node && mine[i]->set && mine[i]->node;
        if (!mine[i]->node) break;
    }
    return good;
}

static void check_box(qn_reader *r, const qn_value *low, const qn_value *high)
{
    for (int i = 0; i < 3; i++)
        if (!(low->vector[i] < high->vector[i])) {
            qn_complain(r, high, "must be above low, %s, in each coordinate", low->text);
            return;
        }
}

/// A direction as a unit vector; 0 0 0 with a message where there is none.
static qn_vec3 direction_of(qn_reader *r, const qn_value *v)
{
    qn_vec3 n = qn_vector_of(v);
    double length = qn_norm(n);
    if (length > 0) return qn_scale(1 / length, n);
    qn_complain(r, v, "has no direction");
    return qn_v3(0, 0, 0);
}

/// Index of the group a feed gives, or -1 with a message.
static int find_group(qn_reader *r, const qn_value *v)
{
    char known[QN_NAMES_MAX * 16] = "", nearest[64];
    for (int i = 0; i < r->def->group_count; i++) {
        const char *name = r->def->groups[i].name;
        if (!strcmp(name, v->text)) return i;
        if (strlen(known) + QN_NAME_MAX + 2 < sizeof known)
            strcat(strcat(known, i > 0 ? " " : ""), name);
    }
    if (qn_nearest_word(v->text, known, nearest, sizeof nearest))
        qn_complain(r, v, "is not a group of particles; did you mean '%s'?", nearest);
    else
        qn_complain(r, v, "is not a group of particles; known are: %.400s", known);
    return -1;
}

static void read_feed(qn_reader *r, const qn_node *node)
{
    qn_feed_def *f = &r->def->feeds[r->def->feed_count];
    if (!qn_name_read(r, node, "feed", f->name)) return;
    qn_section_from from = qn_section_entry(r, "feeds", node, -1);
    qn_feed_keys k;
    qn_section_read(r, QN_SECTION_FEED, from, &k);
    bool is_box;
    const qn_value *const box[] = {&k.low, &k.high}, *const disc[] = {&k.centre, &k.radius};
    if (!read_region(r, from.mark, box, disc, &is_box)) return;
    if (is_box) check_box(r, &k.low, &k.high);
    if (is_box && k.normal.node) qn_complain(r, &k.normal, "means nothing for a box");
    if (!k.particles.set) return;
    f->group = find_group(r, &k.particles);
    if (f->group < 0) return;
    const qn_group_def *fed = &r->def->groups[f->group];
    if (fed->size_count == 0 || fed->fixed || fed->turning)
        qn_complain(r, &k.particles, "cannot be fed: its particles are held or have no size");
    f->by_mass = k.rate.dimension == QN_DIMENSION_MASS_FLOW;
    f->rate = k.rate.number;
    f->is_disc = !is_box;
    f->low = qn_vector_of(&k.low), f->high = qn_vector_of(&k.high);
    f->centre = qn_vector_of(&k.centre), f->radius = k.radius.number;
    f->velocity = qn_vector_of(&k.velocity);
    f->start = k.start.number;
    f->stop = k.stop.is_word ? (double)INFINITY : k.stop.number;
    if (k.start.set && k.stop.set && !(f->stop > f->start))
        qn_complain(r, &k.stop, "must be after start, %s", k.start.text);
    if (f->is_disc) f->normal = direction_of(r, &k.normal);
    r->def->feed_count++;
}

static void read_outlet(qn_reader *r, const qn_node *node)
{
    qn_outlet_def *o = &r->def->outlets[r->def->outlet_count];
    if (!qn_name_read(r, node, "outlet", o->name)) return;
    qn_section_from from = qn_section_entry(r, "outlets", node, -1);
    qn_outlet_keys k;
    qn_section_read(r, QN_SECTION_OUTLET, from, &k);
    const qn_value *const box[] = {&k.low, &k.high}, *const plane[] = {&k.point, &k.normal};
    if (!read_region(r, from.mark, box, plane, &o->is_box)) return;
    const qn_value *only_plane[] = {&k.radius, &k.aperture};
    for (int i = 0; i < 2 && o->is_box; i++)
        if (only_plane[i]->node) qn_complain(r, only_plane[i], "means nothing for a box");
    if (o->is_box) check_box(r, &k.low, &k.high);
    o->low = qn_vector_of(&k.low), o->high = qn_vector_of(&k.high);
    o->point = qn_vector_of(&k.point);
    if (!o->is_box) o->normal = direction_of(r, &k.normal);
    o->radius = k.radius.is_word ? (double)INFINITY : k.radius.number;
    o->aperture = k.aperture.is_word ? (double)INFINITY : k.aperture.number;
    r->def->outlet_count++;
}

qn_status qn_build_flow(qn_reader *r, const qn_scene_keys *scene)
{
    const qn_node *nodes[QN_NAMES_MAX];
    int count = qn_names_read(r, &scene->feeds, nodes);
    QN_TRY(QN_ALLOCATE(r->def->feeds, count));
    for (int i = 0; i < count; i++) read_feed(r, nodes[i]);
    count = qn_names_read(r, &scene->outlets, nodes);
    QN_TRY(QN_ALLOCATE(r->def->outlets, count));
    for (int i = 0; i < count; i++) read_outlet(r, nodes[i]);
    return QN_OK;
}
