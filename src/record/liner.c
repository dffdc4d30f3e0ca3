// SPDX-License-Identifier: Apache-2.0
#include "record/liner.h"

#include <stdlib.h>

#define PI 3.14159265358979323846

enum { ARC_PIECES = 120 };  // pieces a full circle is cut into

void qn_liner_free(qn_liner *liner)
{
    free(liner->points);
    free(liner->corners);
    free(liner->offsets);
    free(liner->lifter);
    free(liner->part);
    free(liner->facet);
    free(liner->area);
    *liner = (qn_liner){0};
}

static double arc_sweep(const qn_element *e)
{
    double sweep = atan2(e->ax * e->by - e->ay * e->bx, e->ax * e->bx + e->ay * e->by);
    return sweep > 0 ? sweep : sweep + 2 * PI;
}

static int pieces_of(const qn_element *e)
{
    return e->arc ? 1 + (int)(arc_sweep(e) * ARC_PIECES / (2 * PI)) : 1;
}

static qn_status allocate(const qn_walls *walls, qn_liner *l)
{
    int64_t quads = 0, triangles = 0;
    for (int i = 0; walls->has_drum && i < walls->profile.count; i++)
        quads += pieces_of(&walls->profile.elements[i]);
    for (int i = 0; i < walls->mesh_count; i++) triangles += walls->meshes[i].triangle_count;
    int64_t corners = 4 * quads + 3 * triangles, cells = quads + triangles;
    QN_TRY(QN_ALLOCATE(l->points, 3 * corners));
    QN_TRY(QN_ALLOCATE(l->corners, corners));
    QN_TRY(QN_ALLOCATE(l->offsets, cells + 1));
    QN_TRY(QN_ALLOCATE(l->lifter, cells));
    QN_TRY(QN_ALLOCATE(l->part, cells));
    QN_TRY(QN_ALLOCATE(l->area, cells));
    return QN_ALLOCATE(l->facet, cells);
}

static void add_corner(qn_liner *l, const qn_frame *frame, qn_vec3 p)
{
    qn_vec3 at = qn_frame_leave(frame, p);
    float *out = l->points + 3 * l->point_count;
    out[0] = (float)at.x;
    out[1] = (float)at.y;
    out[2] = (float)at.z;
    l->corners[l->corner_count++] = l->point_count++;
}

static void end_cell(qn_liner *l, int lifter, int part, int facet, double area)
{
    l->area[l->cell_count] = area;
    l->lifter[l->cell_count] = lifter;
    l->part[l->cell_count] = part;
    l->facet[l->cell_count++] = facet;
    l->offsets[l->cell_count] = l->corner_count;
}

/// One stretch of the profile, from z = 0 to z = length.
static void draw_element(qn_liner *l, const qn_frame *frame, const qn_profile *profile, int which,
                         double length)
{
    const qn_element *e = &profile->elements[which];
    int pieces = pieces_of(e);
    double area = length * (e->arc ? profile->radius * arc_sweep(e) : e->length);
    double piece = e->arc ? arc_sweep(e) / pieces : 0, x = e->ax, y = e->ay;
    for (int k = 1; k <= pieces; k++) {
        double c = cos(k * piece), s = sin(k * piece);
        double next_x = k < pieces ? c * e->ax - s * e->ay : e->bx;
        double next_y = k < pieces ? s * e->ax + c * e->ay : e->by;
        add_corner(l, frame, qn_v3(x, y, 0));
        add_corner(l, frame, qn_v3(next_x, next_y, 0));
        add_corner(l, frame, qn_v3(next_x, next_y, length));
        add_corner(l, frame, qn_v3(x, y, length));
        end_cell(l, e->lifter + 1, e->lifter + 1, which, area);
        x = next_x, y = next_y;
    }
}

static void draw_mesh(qn_liner *l, const qn_frame *frame, const qn_mesh *mesh)
{
    for (int i = 0; i < mesh->triangle_count; i++) {
        for (int k = 0; k < 3; k++)
            add_corner(l, frame, mesh->vertices[mesh->triangles[3 * i + k]]);
        end_cell(l, 0, mesh->part, mesh->first_facet + i, qn_mesh_area(mesh, i));
    }
}

qn_status qn_liner_draw(const qn_walls *walls, double t, qn_liner *liner)
{
    *liner = (qn_liner){0};
    qn_status status = allocate(walls, liner);
    if (status != QN_OK) {
        qn_liner_free(liner);
        return status;
    }
    if (walls->has_drum) {
        qn_frame frame = qn_walls_frame(walls, walls->drum_body, t);
        for (int i = 0; i < walls->profile.count; i++)
            draw_element(liner, &frame, &walls->profile, i, walls->drum.length);
    }
    for (int i = 0; i < walls->mesh_count; i++) {
        qn_frame frame = qn_walls_frame(walls, walls->meshes[i].body, t);
        draw_mesh(liner, &frame, &walls->meshes[i]);
    }
    return QN_OK;
}
