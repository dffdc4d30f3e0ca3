// SPDX-License-Identifier: Apache-2.0
// Set-up of the walls from a definition: surfaces, parts and the numbers of features.
#include "world/walls.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LIFTERS_MAX = 10000 };

void qn_walls_free(qn_walls *walls)
{
    qn_profile_free(&walls->profile);
    for (int i = 0; i < walls->mesh_count; i++) qn_mesh_free(&walls->meshes[i]);
    free(walls->meshes);
    free(walls->planes);
    free(walls->surfaces);
    free(walls->parts);
    *walls = (qn_walls){0};
}

static int add_surface(qn_walls *w, int material, double radius)
{
    w->surfaces[w->surface_count] = (qn_surface){material, radius};
    return w->surface_count++;
}

__attribute__((format(printf, 3, 4))) static int add_part(qn_walls *w, int body, const char *format,
                                                          ...)
{
    qn_part *part = &w->parts[w->part_count];
    part->body = body;
    part->turning = body == w->drum_body;
    va_list args;
    va_start(args, format);
    vsnprintf(part->name, sizeof part->name, format, args);
    va_end(args);
    return w->part_count++;
}

/// The body of a wall: rest, the drum, that of an earlier wall with the same drive, or a new one.
static qn_status body_of(qn_walls *w, const qn_drive_def *drive, const char *wall, int *body)
{
    *body = 0;
    if (drive->kind == QN_DRIVE_REST) return QN_OK;
    *body = w->drum_body;
    if (drive->kind == QN_DRIVE_DRUM && w->has_drum) return QN_OK;
    if (drive->kind == QN_DRIVE_DRUM)
        return qn_fail(QN_INPUT, "wall '%s' turns with the drum, but there is none", wall);
    QN_TRY(qn_drive_check(drive, wall));
    for (*body = 1; *body < w->body_count; ++*body)
        if (memcmp(&w->drives[*body], drive, sizeof *drive) == 0) return QN_OK;
    if (w->body_count == QN_BODIES_MAX)
        return qn_fail(QN_INPUT, "wall '%s' has a motion of its own; at most %d walls may", wall,
                       QN_BODIES_MAX - 2);
    w->drives[w->body_count++] = *drive;
    return QN_OK;
}

static qn_status check_legs(const qn_drum_def *d)
{
    if (d->leg_count < 0 || d->leg_count > QN_LEGS_MAX)
        return qn_fail(QN_INPUT, "drum '%s' has %d legs of speed; at most %d are allowed", d->name,
                       d->leg_count, QN_LEGS_MAX);
    for (int i = 0; i < d->leg_count; i++) {
        const qn_leg *leg = &d->legs[i];
        if (!(leg->duration >= 0 && isfinite(leg->from) && isfinite(leg->to)))
            return qn_fail(
                QN_INPUT,
                "drum '%s': leg %d lasts %g s from %g to %g rad/s; the duration must not "
                "be negative and the speeds finite",
                d->name, i + 1, leg->duration, leg->from, leg->to);
        if (isinf(leg->duration) && leg->from != leg->to)
            return qn_fail(
                QN_INPUT,
                "drum '%s': leg %d lasts for ever but goes from %g to %g rad/s; give it a "
                "duration",
                d->name, i + 1, leg->from, leg->to);
    }
    return QN_OK;
}

static qn_status build_drum(const qn_def *def, double reach, qn_walls *w)
{
    const qn_drum_def *d = &def->drum;
    w->has_drum = d->present;
    if (!d->present) return QN_OK;
    w->drum = *d;
    w->drum_body = w->body_count++;
    w->drives[w->drum_body].kind = QN_DRIVE_DRUM;
    w->has_profile_file = d->profile_count > 0;
    if (!(d->length > 0 && isfinite(d->length)))
        return qn_fail(QN_INPUT, "drum '%s' is %g m long; its length must be above 0", d->name,
                       d->length);
    QN_TRY(check_legs(d));
    QN_TRY(qn_profile_build(d, reach, &w->profile));
    w->shell_surface = w->flat_surface = add_surface(w, d->material, INFINITY);
    if (w->has_profile_file) {
        add_part(w, w->drum_body, "profile");
    } else {
        w->shell_surface = add_surface(w, d->material, -w->profile.radius);
        add_part(w, w->drum_body, "shell");
        for (int k = 0; k < d->lifter_count; k++) add_part(w, w->drum_body, "lifter_%02d", k + 1);
    }
    if (d->ends == QN_ENDS_PERIODIC) return QN_OK;
    w->end_surface = add_surface(w, d->end_material, INFINITY);
    int body = d->ends == QN_ENDS_TURNING ? w->drum_body : 0;
    w->end_part[0] = add_part(w, body, "end_low");
    w->end_part[1] = add_part(w, body, "end_high");
    return QN_OK;
}

static qn_status build_planes(const qn_def *def, qn_walls *w)
{
    w->plane_surface = w->surface_count;
    w->plane_part = w->part_count;
    for (int i = 0; i < def->plane_count; i++) {
        const qn_plane_def *p = &def->planes[i];
        double length = qn_norm(p->normal);
        if (!(length > 0 && isfinite(length) && isfinite(qn_norm(p->point))))
            return qn_fail(QN_INPUT,
                           "plane '%s' has the normal (%g, %g, %g) at (%g, %g, %g) m; both must be "
                           "finite and the normal not zero",
                           p->name, p->normal.x, p->normal.y, p->normal.z, p->point.x, p->point.y,
                           p->point.z);
        w->planes[i] = *p;
        if (fabs(length - 1) > 1e-15) w->planes[i].normal = qn_scale(1 / length, p->normal);
        w->plane_count++;
        int body;
        QN_TRY(body_of(w, &p->drive, p->name, &body));
        add_surface(w, p->material, INFINITY);
        add_part(w, body, "%s", p->name);
    }
    return QN_OK;
}

static qn_status build_meshes(const qn_def *def, double reach, qn_walls *w)
{
    int64_t feature = w->plane_feature + (int64_t)def->plane_count;
    w->facet_count = w->plane_facet + def->plane_count;
    for (int i = 0; i < def->mesh_count; i++) {
        qn_mesh *mesh = &w->meshes[i];
        QN_TRY(qn_mesh_build(&def->meshes[i], reach, mesh));
        w->mesh_count++;
        mesh->surface = add_surface(w, mesh->material, INFINITY);
        QN_TRY(body_of(w, &def->meshes[i].drive, mesh->name, &mesh->body));
        mesh->part = add_part(w, mesh->body, "%s", mesh->name);
        mesh->first_feature = (int32_t)feature;
        mesh->first_facet = w->facet_count;
        w->facet_count += mesh->triangle_count;
        feature += qn_mesh_feature_count(mesh);
        if (feature > INT32_MAX)
            return qn_fail(
                QN_INPUT,
                "mesh '%s' brings the walls to %lld faces, edges and corners; at most %d "
                "are allowed",
                mesh->name, (long long)feature, INT32_MAX);
    }
    return QN_OK;
}

static qn_status build_groups(const qn_def *def, qn_walls *w)
{
    w->group_part = w->part_count;
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *g = &def->groups[k];
        if (!g->turning) continue;
        if (!def->drum.present)
            return qn_fail(QN_INPUT, "particles.%s.turning needs a drum to turn with", g->name);
        for (int p = 0; p < w->part_count; p++)
            if (!strcmp(w->parts[p].name, g->name))
                return qn_fail(QN_INPUT,
                               "particles.%s: a part of the walls has this name already, and one "
                               "that turns needs its own",
                               g->name);
        add_part(w, w->drum_body, "%s", g->name);
    }
    return QN_OK;
}

static qn_status build(const qn_def *def, double reach, qn_walls *w)
{
    if (def->drum.lifter_count < 0 || def->drum.lifter_count > LIFTERS_MAX)
        return qn_fail(QN_INPUT, "drum '%s' has %d lifters; 0 to %d are allowed", def->drum.name,
                       def->drum.lifter_count, LIFTERS_MAX);
    int64_t own = 5 + (def->drum.present ? (int64_t)def->drum.lifter_count : 0);
    int64_t most = own + def->plane_count + def->mesh_count + def->group_count;
    QN_TRY(QN_ALLOCATE(w->surfaces, most));
    QN_TRY(QN_ALLOCATE(w->parts, most));
    QN_TRY(QN_ALLOCATE(w->planes, def->plane_count));
    QN_TRY(QN_ALLOCATE(w->meshes, def->mesh_count));
    w->drum_body = -1;
    w->body_count = 1;
    QN_TRY(build_drum(def, reach, w));
    w->end_feature = 2 * w->profile.count;
    w->plane_feature = w->end_feature + 2;
    w->end_facet = w->profile.count;
    w->plane_facet = w->end_facet + 2;
    QN_TRY(build_planes(def, w));
    QN_TRY(build_meshes(def, reach, w));
    return build_groups(def, w);
}

/// Releases the planes and meshes of a definition, now that the walls have them.
static void clear_taken(qn_def *def)
{
    for (int i = 0; i < def->mesh_count; i++) {
        free(def->meshes[i].vertices);
        free(def->meshes[i].triangles);
    }
    free(def->meshes);
    free(def->planes);
    def->meshes = NULL;
    def->planes = NULL;
    def->mesh_count = def->plane_count = 0;
}

qn_status qn_walls_build(qn_def *def, double largest_radius, qn_walls *walls)
{
    *walls = (qn_walls){0};
    qn_status status = build(def, largest_radius, walls);
    if (status == QN_OK)
        clear_taken(def);
    else
        qn_walls_free(walls);
    return status;
}
