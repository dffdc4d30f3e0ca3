// SPDX-License-Identifier: Apache-2.0
// The drum with its lifters and its speed, and the other walls.
#include "base/array.h"
#include "scene/build.h"
#include "scene/load.h"

#include <stdio.h>
#include <string.h>

/// A speed in rad/s; %critical is of the speed at which gravity just holds a point mass to the shell,
/// sqrt(2 g / D), D being the diameter inside the shell. Where speed or diameter could not be read it
/// is 1, so that no more is said about a drum at rest.
static double speed_of(qn_reader *r, const qn_value *v, int unused)
{
    (void)unused;
    double diameter = r->def->drum.diameter;
    if (!v->set) return 1;
    if (v->dimension != QN_DIMENSION_CRITICAL) return v->number;
    return diameter > 0 ? v->number * sqrt(2 * qn_norm(r->def->gravity) / diameter) : 1;
}

static void read_speed(qn_reader *r, const qn_drum_keys *k, qn_mark mark)
{
    qn_drum_def *d = &r->def->drum;
    if (k->schedule.node) {
        const qn_value *besides[] = {&k->speed, &k->settle, &k->ramp};
        for (int i = 0; i < 3; i++)
            if (besides[i]->node)
                qn_complain(r, besides[i],
                            "cannot stand beside drum.schedule, which gives all speeds");
        if (k->schedule.set)
            qn_build_schedule(r, &k->schedule, QN_SECTION_LEG, speed_of, 0, d->legs, &d->leg_count);
        return;
    }
    if (!k->speed.set && !k->speed.node)
        qn_complain_at(r, mark,
                       "drum lacks the key 'speed' (or 'schedule'), such as speed: 70 "
                       "%%critical");
    qn_build_legs(k->settle.number, k->ramp.number, speed_of(r, &k->speed, 0), d->legs,
                  &d->leg_count);
}

/// Bars that are as wide as the shell allows, and no higher.
static void check_lifters(qn_reader *r, const qn_lifters_keys *k)
{
    const qn_drum_def *d = &r->def->drum;
    double shell = QN_PI * d->diameter, inner = QN_PI * (d->diameter - 2 * d->lifter_height);
    if (!(d->diameter > 0)) return;
    if (k->height.set && 2 * d->lifter_height >= d->diameter)
        qn_complain(r, &k->height, "reaches the axis of a drum of %g mm", d->diameter * 1e3);
    else if (d->lifter_count * d->lifter_base >= shell)
        qn_complain(r, &k->count, "lifters with a base of %g mm do not fit on a shell %g mm around",
                    d->lifter_base * 1e3, shell * 1e3);
    else if (d->lifter_count * d->lifter_top >= inner)
        qn_complain(r, &k->count, "lifters with a top of %g mm touch each other there",
                    d->lifter_top * 1e3);
}

static void read_lifters(qn_reader *r, const qn_value *lifters)
{
    qn_drum_def *d = &r->def->drum;
    qn_lifters_keys k;
    qn_section_read(r, QN_SECTION_LIFTERS, qn_section_under(r, lifters), &k);
    d->lifter_count = (int)k.count.number;
    d->lifter_height = k.height.number;
    d->lifter_top = d->lifter_base = k.top.number;
    if (k.base.node && k.face_angle.node)
        qn_complain(r, &k.face_angle,
                    "is given besides base; one follows from the other, give one");
    else if (k.base.set) {
        d->lifter_base = k.base.number;
        if (k.top.set && d->lifter_base < d->lifter_top)
            qn_complain(r, &k.base, "is narrower than the top, %g mm", d->lifter_top * 1e3);
    } else if (k.face_angle.set)
        d->lifter_base += 2 * d->lifter_height / tan(k.face_angle.number);
    if (k.count.set && k.height.set && k.top.set) check_lifters(r, &k);
}

static void read_profile(qn_reader *r, const qn_drum_keys *k)
{
    qn_drum_def *d = &r->def->drum;
    char path[QN_PATH_MAX];
    if (k->lifters.node)
        qn_complain(r, &k->profile, "replaces shell and lifters: leave out drum.lifters");
    if (!qn_file_of(r, &k->profile, path)) return;
    if (qn_load_points(path, k->profile_unit.number, &d->profile, &d->profile_count) != QN_OK)
        qn_complain(r, &k->profile, "cannot be used: %s", qn_error());
}

qn_status qn_build_drum(qn_reader *r, const qn_scene_keys *scene)
{
    qn_drum_def *d = &r->def->drum;
    if (!scene->drum.set && scene->drum.node) {  // so that nobody misses the drum or its turning
        d->present = true;
        d->material = d->end_material = -1;
        qn_build_legs(0, 0, 1, d->legs, &d->leg_count);
    }
    if (!scene->drum.set) return QN_OK;
    qn_section_from from = qn_section_under(r, &scene->drum);
    qn_drum_keys k;
    qn_section_read(r, QN_SECTION_DRUM, from, &k);
    d->present = true;
    if (k.name.set && strlen(k.name.text) >= QN_NAME_MAX)
        qn_complain(r, &k.name, "is longer than %d letters", QN_NAME_MAX - 1);
    snprintf(d->name, sizeof d->name, "%.*s", QN_NAME_MAX - 1, k.name.text);
    d->diameter = k.diameter.number;
    d->length = k.length.number;
    d->ends = (qn_ends)k.ends.choice;
    d->corners = (qn_corners)k.corner.choice;
    d->material = qn_material_of(&k.material);
    d->end_material = k.end_material.node ? qn_material_of(&k.end_material) : d->material;
    if (k.end_material.node && d->ends == QN_ENDS_PERIODIC)
        qn_complain(r, &k.end_material, "means nothing: periodic ends have no wall");
    if (d->ends == QN_ENDS_PERIODIC && r->def->gravity.z != 0)
        qn_complain_at(
            r, scene->gravity.node ? scene->gravity.mark : from.mark,
            "gravity acts along z, the axis of a drum with periodic ends; use ends: fixed");
    read_speed(r, &k, from.mark);
    if (k.lifters.set && k.lifters.node) read_lifters(r, &k.lifters);
    if (k.profile.set && k.profile.node) read_profile(r, &k);
    return QN_OK;
}

static void add_plane(qn_def *def, const char *name, const char *suffix, int material,
                      qn_vec3 point, qn_vec3 normal, const qn_drive_def *drive)
{
    qn_plane_def *p = &def->planes[def->plane_count++];
    p->drive = *drive;
    snprintf(p->name, sizeof p->name, "%.*s%s", QN_NAME_MAX - 4, name, suffix);
    p->material = material;
    p->point = point;
    p->normal = normal;
}

static void read_plane(qn_reader *r, qn_section_from from, const char *name)
{
    qn_plane_keys k;
    qn_section_read(r, QN_SECTION_PLANE, from, &k);
    qn_vec3 normal = qn_vector_of(&k.normal);
    qn_drive_def drive = {0};
    double length = qn_norm(normal);
    qn_build_motion(r, &k.motion, &drive);
    if (k.normal.set && !(length > 0 && isfinite(length)))
        qn_complain(r, &k.normal,
                    "has no direction; give a vector to the side where particles live");
    add_plane(r->def, name, "", qn_material_of(&k.material), qn_vector_of(&k.point),
              length > 0 ? qn_scale(1 / length, normal) : normal, &drive);
}

static void read_box(qn_reader *r, qn_section_from from, const char *name)
{
    qn_box_keys k;
    qn_section_read(r, QN_SECTION_BOX, from, &k);
    qn_vec3 low = qn_vector_of(&k.low), high = qn_vector_of(&k.high);
    qn_drive_def drive = {0};
    qn_build_motion(r, &k.motion, &drive);
    if (k.low.set && k.high.set && !(low.x < high.x && low.y < high.y && low.z < high.z))
        qn_complain(r, &k.high, "must be above low, %s, in each coordinate", k.low.text);
    static const char *const suffixes[] = {"_x0", "_x1", "_y0", "_y1", "_z0", "_z1"};
    for (int i = 0; i < 6; i++) {
        double side = i % 2 ? -1 : 1;
        qn_vec3 normal = qn_v3(i / 2 == 0 ? side : 0, i / 2 == 1 ? side : 0, i / 2 == 2 ? side : 0);
        add_plane(r->def, name, suffixes[i], qn_material_of(&k.material), i % 2 ? high : low,
                  normal, &drive);
    }
}

static void read_mesh(qn_reader *r, qn_section_from from, const char *name)
{
    qn_mesh_keys k;
    qn_section_read(r, QN_SECTION_MESH, from, &k);
    qn_mesh_def *m = &r->def->meshes[r->def->mesh_count++];
    snprintf(m->name, sizeof m->name, "%s", name);
    m->material = qn_material_of(&k.material);
    qn_build_motion(r, &k.motion, &m->drive);
    if (k.turning.choice == 1) {
        if (!r->def->drum.present) qn_complain(r, &k.turning, "needs a drum to turn with");
        if (k.motion.node)
            qn_complain(r, &k.turning, "cannot stand beside a motion of the wall's own");
        m->drive = (qn_drive_def){.kind = QN_DRIVE_DRUM};
    }
    char path[QN_PATH_MAX];
    if (!k.file.set || !qn_file_of(r, &k.file, path)) return;
    if (qn_load_mesh(path, k.unit.number, &m->vertices, &m->vertex_count, &m->triangles,
                     &m->triangle_count)
        != QN_OK)
        qn_complain(r, &k.file, "cannot be used: %s", qn_error());
}

static void read_wall(qn_reader *r, const qn_node *node)
{
    char name[QN_NAME_MAX];
    if (!qn_name_read(r, node, "wall", name)) return;
    qn_section_from from = qn_section_entry(r, "walls", node, -1);
    const qn_node *shape = qn_node_child(node, "shape");
    const char *text = shape ? shape->text : "";
    if (!strcmp(text, "plane"))
        read_plane(r, from, name);
    else if (!strcmp(text, "box"))
        read_box(r, from, name);
    else if (!strcmp(text, "mesh"))
        read_mesh(r, from, name);
    else if (shape) {
        char nearest[16];
        bool like = qn_nearest_word(text, "plane box mesh", nearest, sizeof nearest);
        qn_complain_at(r, shape->mark, "%s.shape = %.40s is unknown%s%s%s; allowed: plane box mesh",
                       from.path, text, like ? "; did you mean '" : "", like ? nearest : "",
                       like ? "'?" : "");
    } else
        qn_complain_at(r, from.mark, "%s lacks the key 'shape': plane, box or mesh", from.path);
}

qn_status qn_build_walls(qn_reader *r, const qn_scene_keys *scene)
{
    const qn_node *nodes[QN_NAMES_MAX];
    int count = qn_names_read(r, &scene->walls, nodes);
    QN_TRY(QN_ALLOCATE(r->def->planes, 6 * count));
    QN_TRY(QN_ALLOCATE(r->def->meshes, count));
    for (int i = 0; i < count; i++) read_wall(r, nodes[i]);
    return QN_OK;
}
