// SPDX-License-Identifier: Apache-2.0
// Questions to the walls: what a sphere touches, whether and how far a point is inside.
//
// Touches are asked for by every particle in every step; most particles are far from any wall, and
// for those a distance from the axis and a lookup in a grid must do.
#include "world/walls.h"

static const double FAR = 12;  // 1   in largest radii: how far around a point meshes are looked for

enum { ROOM = 32 };  // most touches of a sphere with the profile or one mesh; further ones pass

typedef struct list {
    qn_wall_hit *hits;
    int room, count;
} list;

static void put(list *l, qn_wall_hit hit)
{
    if (l->count < l->room) l->hits[l->count] = hit;
    l->count++;
}

static void touch_profile(const qn_walls *w, const qn_pose *pose, qn_vec3 centre, double radius,
                          list *found)
{
    const qn_profile *p = &w->profile;
    const qn_frame *frame = &pose->frames[w->drum_body];
    qn_vec3 c = qn_frame_enter(frame, centre);
    qn_profile_hit hits[ROOM];
    int n = qn_profile_touch(p, c.x, c.y, radius, hits, ROOM);
    for (int k = 0; k < n && k < ROOM; k++) {
        const qn_element *e = &p->elements[hits[k].element];
        const qn_element *other = e;  // at a corner, the element that ends there
        if (hits[k].feature >= p->count)
            other = &p->elements[qn_profile_before(p, hits[k].element)];
        int lifter = e->lifter > other->lifter ? e->lifter : other->lifter;
        qn_vec3 at = qn_frame_leave(frame, qn_v3(hits[k].x, hits[k].y, c.z));
        put(found,
            (qn_wall_hit){.feature = hits[k].feature,
                          .surface = e->arc && other->arc ? w->shell_surface : w->flat_surface,
                          .part = lifter + 1,
                          .facet = hits[k].element,
                          .body = w->drum_body,
                          .point = at,
                          .share = hits[k].share,
                          .beyond = hits[k].beyond});
    }
}

static void touch_ends(const qn_walls *w, qn_vec3 centre, double radius, list *found)
{
    const double at[2] = {0, w->drum.length};
    for (int k = 0; k < 2; k++) {
        double height = k ? at[1] - centre.z : centre.z;
        if (!(height >= 0 && height < radius)) continue;
        put(found, (qn_wall_hit){.feature = w->end_feature + k,
                                 .surface = w->end_surface,
                                 .part = w->end_part[k],
                                 .facet = w->end_facet + k,
                                 .body = w->parts[w->end_part[k]].body,
                                 .point = qn_v3(centre.x, centre.y, at[k]),
                                 .share = 1});
    }
}

/// Height (m) of a point over a plane, and the plane's normal, both where the plane is now.
static double height_over(const qn_plane_def *p, const qn_frame *frame, qn_vec3 x, qn_vec3 *normal)
{
    *normal = frame->moves ? qn_frame_turn(frame, p->normal) : p->normal;
    return qn_dot(qn_sub(x, qn_frame_leave(frame, p->point)), *normal);
}

static void touch_planes(const qn_walls *w, const qn_pose *pose, qn_vec3 centre, double radius,
                         list *found)
{
    for (int i = 0; i < w->plane_count; i++) {
        int body = w->parts[w->plane_part + i].body;
        qn_vec3 normal;
        double height = height_over(&w->planes[i], &pose->frames[body], centre, &normal);
        if (!(height >= 0 && height < radius)) continue;
        put(found, (qn_wall_hit){.feature = w->plane_feature + i,
                                 .surface = w->plane_surface + i,
                                 .part = w->plane_part + i,
                                 .facet = w->plane_facet + i,
                                 .body = body,
                                 .point = qn_madd(centre, -height, normal),
                                 .share = 1});
    }
}

static void touch_meshes(const qn_walls *w, const qn_pose *pose, qn_vec3 centre, double radius,
                         list *found)
{
    for (int i = 0; i < w->mesh_count; i++) {
        const qn_mesh *m = &w->meshes[i];
        const qn_frame *frame = &pose->frames[m->body];
        qn_mesh_hit hits[ROOM];
        int n = qn_mesh_touch(m, qn_frame_enter(frame, centre), radius, hits, ROOM);
        for (int k = 0; k < n && k < ROOM; k++)
            put(found, (qn_wall_hit){.feature = m->first_feature + hits[k].feature,
                                     .surface = m->surface,
                                     .part = m->part,
                                     .facet = m->first_facet + qn_mesh_facet(m, hits[k].feature),
                                     .body = m->body,
                                     .point = qn_frame_leave(frame, hits[k].point),
                                     .share = 1});
    }
}

int qn_walls_touch(const qn_walls *walls, const qn_pose *pose, qn_vec3 centre, double radius,
                   qn_wall_hit *hits, int room)
{
    list found = {hits, room, 0};
    if (walls->has_drum) {
        double clear = walls->profile.clear - radius;
        double from_axis2 = centre.x * centre.x + centre.y * centre.y;
        if (clear <= 0 || from_axis2 >= clear * clear)
            touch_profile(walls, pose, centre, radius, &found);
        if (walls->drum.ends != QN_ENDS_PERIODIC) touch_ends(walls, centre, radius, &found);
    }
    if (walls->plane_count) touch_planes(walls, pose, centre, radius, &found);
    if (walls->mesh_count) touch_meshes(walls, pose, centre, radius, &found);
    return found.count;
}

bool qn_walls_outside(const qn_walls *walls, const qn_pose *pose, qn_vec3 centre)
{
    for (int i = 0; i < walls->plane_count; i++) {
        const qn_frame *frame = &pose->frames[walls->parts[walls->plane_part + i].body];
        qn_vec3 normal;
        if (height_over(&walls->planes[i], frame, centre, &normal) < 0) return true;
    }
    if (!walls->has_drum) return false;
    if (walls->drum.ends != QN_ENDS_PERIODIC && !(centre.z >= 0 && centre.z <= walls->drum.length))
        return true;
    double from_axis2 = centre.x * centre.x + centre.y * centre.y;
    if (from_axis2 < walls->profile.clear * walls->profile.clear) return false;
    qn_vec3 c = qn_frame_enter(&pose->frames[walls->drum_body], centre);
    return qn_profile_side(&walls->profile, c.x, c.y) == QN_SIDE_OUTSIDE;
}

double qn_walls_clearance(const qn_walls *walls, const qn_pose *pose, qn_vec3 centre)
{
    double clear = INFINITY;  // m
    if (walls->has_drum) {
        qn_vec3 c = qn_frame_enter(&pose->frames[walls->drum_body], centre);
        clear = qn_profile_distance(&walls->profile, c.x, c.y);
        if (walls->drum.ends != QN_ENDS_PERIODIC)
            clear = qn_min(clear, qn_min(centre.z, walls->drum.length - centre.z));
    }
    for (int i = 0; i < walls->plane_count; i++) {
        const qn_frame *frame = &pose->frames[walls->parts[walls->plane_part + i].body];
        qn_vec3 normal;
        clear = qn_min(clear, height_over(&walls->planes[i], frame, centre, &normal));
    }
    for (int i = 0; i < walls->mesh_count && clear > 0; i++) {
        const qn_mesh *m = &walls->meshes[i];
        double limit = qn_min(clear, FAR * m->reach);
        qn_vec3 c = qn_frame_enter(&pose->frames[m->body], centre);
        double distance = qn_mesh_distance(m, c, limit);
        if (distance < limit) clear = distance;
    }
    return clear;
}

double qn_walls_open_share(const qn_walls *walls, double rho)
{
    return walls->has_drum ? qn_profile_open_share(&walls->profile, rho) : 1;
}

double qn_walls_volume(const qn_walls *walls)
{
    return walls->has_drum ? qn_profile_area(&walls->profile) * walls->drum.length : 0;
}
