// SPDX-License-Identifier: Apache-2.0
// The grid of a mesh: which triangles a sphere with its centre in a cell may touch.
//
// A triangle is listed where a centre may lie in its own region, or in that of an edge or corner that it
// reports, no further from it than the reach: what does not own a touch there is not asked. Cells are as
// fine as the triangles, so that a cell lists but a few, and cubes of cells are looked at before cells.
#include "world/mesh.h"

#include <stdlib.h>

static const double FINEST = 0.1;                       // 1   of the reach: the smallest grid cell
static const double CELLS_MAX = 2e6, LISTED_MAX = 2e7;  // 1   bounds on the grid

/// Cells that a triangle's box, widened by `near`, overlaps along one axis.
static void span(const qn_mesh *m, int t, int axis, double near, int *low, int *high)
{
    double least = INFINITY, most = -INFINITY;
    for (int k = 0; k < 3; k++) {
        const qn_vec3 *v = &m->vertices[m->triangles[3 * t + k]];
        double x = axis == 0   ? v->x - m->origin.x
                   : axis == 1 ? v->y - m->origin.y
                               : v->z - m->origin.z;
        least = qn_min(least, x);
        most = qn_max(most, x);
    }
    *low = (int)qn_max(0, floor((least - near) / m->cell));
    *high = (int)qn_min(m->cells[axis] - 1, floor((most + near) / m->cell));
}

static bool has_border(const qn_mesh *m, int t)
{
    for (int k = 0; k < 3; k++)
        if (m->edges[m->triangle_edges[3 * t + k]].count == 1) return true;
    return false;
}

/// Whether edge e may own a centre within `half` of `middle`; distances as for spheres up to `near`.
static bool edge_may_own(const qn_mesh *m, int index, qn_vec3 middle, double half, double near)
{
    const qn_mesh_edge *e = &m->edges[index];
    qn_vec3 from_a = qn_sub(middle, m->vertices[e->a]), from_b = qn_sub(middle, m->vertices[e->b]);
    double along = qn_dot(from_a, e->along);
    if (along < -half || qn_dot(from_b, e->along) > half) return false;
    for (int k = e->first; k < e->first + e->count; k++)
        if (qn_dot(from_a, m->wedges[k]) < -half) return false;
    return qn_dot(from_a, from_a) - along * along <= near * near;
}

static bool vertex_may_own(const qn_mesh *m, int vertex, qn_vec3 middle, double half, double near)
{
    qn_vec3 d = qn_sub(middle, m->vertices[vertex]);
    if (qn_dot(d, d) > near * near) return false;
    for (int k = m->fan_start[vertex]; k < m->fan_start[vertex + 1]; k++) {
        const qn_mesh_edge *e = &m->edges[m->fan[k]];
        double away = qn_dot(d, e->along);
        if (e->a == vertex ? away > half : away < -half) return false;
    }
    return true;
}

/// Whether a sphere whose centre is within `half` of `middle` may touch triangle t, or an edge or corner
/// that t reports: whether the centre may lie in one of their regions. Triangles at a border count as far
/// as they reach, as the corners of others may stand on their sides.
static bool may_own(const qn_mesh *m, int t, qn_vec3 middle, double half, double near)
{
    qn_vec3 from = qn_sub(middle, m->vertices[m->triangles[3 * t]]);
    if (fabs(qn_dot(from, m->normals[t])) > near) return false;
    int within = 0;
    for (int k = 0; k < 3; k++) {
        const qn_mesh_edge *e = &m->edges[m->triangle_edges[3 * t + k]];
        within += qn_dot(qn_sub(middle, m->vertices[e->a]), m->sides[3 * t + k]) <= half;
    }
    if (within == 3) return true;
    for (int k = 0; k < 3; k++) {
        int edge = m->triangle_edges[3 * t + k], vertex = m->triangles[3 * t + k];
        if (m->edges[edge].owner == t && edge_may_own(m, edge, middle, half, near)) return true;
        if (m->vertex_owner[vertex] == t && vertex_may_own(m, vertex, middle, half, near))
            return true;
    }
    if (!has_border(m, t)) return false;
    qn_vec3 d = qn_sub(qn_triangle_nearest(m, t, middle).point, middle);
    return qn_dot(d, d) <= near * near;
}

/// Where the cells go that a sphere may touch a triangle from: counted, or the triangle listed there.
typedef struct listing {
    const qn_mesh *mesh;
    int triangle, low[3], high[3];  //  the cells looked at
    int *counts, *items;            //  items NULL to count only
} listing;

/// Looks at a cube of `size` cells a side, a power of two, and where it is not too far at its eighths.
static void look_at_cube(const listing *l, int x, int y, int z, int size)
{
    const qn_mesh *m = l->mesh;
    if (x > l->high[0] || y > l->high[1] || z > l->high[2]) return;
    double half = 0.8661 * size * m->cell;  // m   half the cube's diagonal
    qn_vec3 middle = qn_v3(x + 0.5 * size, y + 0.5 * size, z + 0.5 * size);
    middle = qn_madd(m->origin, m->cell, middle);
    if (!may_own(m, l->triangle, middle, half, m->reach * (1 + 1e-9) + half)) return;
    if (size > 1) {
        for (int k = 0, part = size / 2; k < 8; k++)
            look_at_cube(l, x + (k & 1) * part, y + (k >> 1 & 1) * part, z + (k >> 2) * part, part);
        return;
    }
    int cell = (z * m->cells[1] + y) * m->cells[0] + x;
    if (l->items)
        l->items[l->counts[cell]++] = l->triangle;
    else
        l->counts[cell]++;
}

/// Visits the cells from which a sphere may touch triangle t: counts them, or lists it there.
static void cover(const qn_mesh *m, int t, int *counts, int *items)
{
    enum { CUBE = 8 };
    listing l = {.mesh = m, .triangle = t, .counts = counts, .items = items};
    for (int k = 0; k < 3; k++)
        span(m, t, k, m->reach * (1 + 1e-9) + 0.8661 * m->cell, &l.low[k], &l.high[k]);
    for (int z = l.low[2]; z <= l.high[2]; z += CUBE)
        for (int y = l.low[1]; y <= l.high[1]; y += CUBE)
            for (int x = l.low[0]; x <= l.high[0]; x += CUBE) look_at_cube(&l, x, y, z, CUBE);
}

/// About how many cells list a triangle: those of the column over it, as far as the reach on both sides.
static double listings(const qn_mesh *m, int t)
{
    double half = 0.8661 * m->cell, side = sqrt(qn_mesh_area(m, t)) + 2 * half;
    return (1 + side * side / (m->cell * m->cell)) * (1 + 2 * (m->reach + half) / m->cell);
}

/// Cells as large as the reach, or as the triangles where these are smaller, so that a cell lists but a
/// few; larger where there would be too many cells, or too much to list.
static void choose_cells(qn_mesh *m)
{
    qn_vec3 size = qn_sub(m->high, m->low);
    double area = 0;
    for (int t = 0; t < m->triangle_count; t++) area += qn_mesh_area(m, t);
    double fine = 0.5 * sqrt(2 * area / m->triangle_count);  // m   half a square of two triangles
    m->origin = qn_sub(m->low, qn_v3(m->reach, m->reach, m->reach));
    for (m->cell = qn_max(FINEST * m->reach, qn_min(fine, m->reach));; m->cell *= 1.25) {
        double sides[3] = {size.x, size.y, size.z}, total = 1, listed = 0;
        for (int k = 0; k < 3; k++)
            total *= sides[k] = ceil((sides[k] + 2 * m->reach) / m->cell) + 1;
        if (total > CELLS_MAX) continue;
        for (int k = 0; k < 3; k++) m->cells[k] = (int)sides[k];
        for (int t = 0; t < m->triangle_count; t++) listed += listings(m, t);
        if (listed <= LISTED_MAX || total <= 8) return;
    }
}

qn_status qn_mesh_grid(qn_mesh *m)
{
    choose_cells(m);
    int total = m->cells[0] * m->cells[1] * m->cells[2];
    QN_TRY(QN_ALLOCATE(m->cell_start, total + 1));
    for (int t = 0; t < m->triangle_count; t++) cover(m, t, m->cell_start + 1, NULL);
    qn_rows_begin(m->cell_start, total);
    QN_TRY(QN_ALLOCATE(m->cell_items, m->cell_start[total]));
    for (int t = 0; t < m->triangle_count; t++) cover(m, t, m->cell_start, m->cell_items);
    qn_rows_end(m->cell_start, total);
    return QN_OK;
}
