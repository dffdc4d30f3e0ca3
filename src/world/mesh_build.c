// SPDX-License-Identifier: Apache-2.0
// Set-up of a mesh: welding, edges with their wedges, corners with their fans, and the grid.
#include "world/mesh.h"

#include <stdlib.h>
#include <string.h>

static const double WELD = 1e-9;      // 1   of the mesh's size: vertices nearer are the same
static const double COPLANAR = 1e-9;  // 1   in-plane normals that cancel to this run on smoothly
static const double SLIVER = 1e-12;   // 1   of the longest side squared: triangles of less area go
static const double FINEST = 0.1;     // 1   of the reach: the smallest grid cell
static const double CELLS_MAX = 2e6, LISTED_MAX = 2e7;  // 1   bounds on the grid

static qn_status check(const qn_mesh_def *def, double reach)
{
    if (!(reach > 0 && isfinite(reach)))
        return qn_fail(QN_INPUT, "the largest particle has a radius of %g m; it must be above 0",
                       reach);
    for (int i = 0; i < 3 * def->vertex_count; i++)
        if (!isfinite(def->vertices[i]))
            return qn_fail(QN_INPUT, "mesh '%s': %c of vertex %d is not finite", def->name,
                           "xyz"[i % 3], i / 3 + 1);
    for (int i = 0; i < 3 * def->triangle_count; i++)
        if (def->triangles[i] < 0 || def->triangles[i] >= def->vertex_count)
            return qn_fail(QN_INPUT, "mesh '%s': triangle %d names vertex %d of %d", def->name,
                           i / 3 + 1, def->triangles[i] + 1, def->vertex_count);
    return QN_OK;
}

typedef struct spot {
    int64_t key[3];
    int index;
} spot;

static int by_spot(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p->key[k] != q->key[k]) return p->key[k] < q->key[k] ? -1 : 1;
    return (p->index > q->index) - (p->index < q->index);
}

/// Makes each vertex stand for itself or for the first one at the same place: first[v] <= v.
static qn_status find_same(const qn_mesh_def *def, double size, int *first)
{
    spot *spots;
    QN_TRY(QN_ALLOCATE(spots, def->vertex_count));
    double unit = size > 0 ? WELD * size : 1;
    for (int v = 0; v < def->vertex_count; v++) {
        spots[v].index = v;
        for (int k = 0; k < 3; k++)
            spots[v].key[k] = llround((def->vertices[3 * v + k] - def->vertices[k]) / unit);
    }
    qsort(spots, (size_t)def->vertex_count, sizeof *spots, by_spot);
    for (int i = 0; i < def->vertex_count; i++) {
        bool same = i > 0 && memcmp(spots[i].key, spots[i - 1].key, sizeof spots[i].key) == 0;
        first[spots[i].index] = same ? first[spots[i - 1].index] : spots[i].index;
    }
    free(spots);
    return QN_OK;
}

static double extent(const qn_mesh_def *def)
{
    double size2 = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (int v = 0; v < def->vertex_count; v++) {
            low = qn_min(low, def->vertices[3 * v + k]);
            high = qn_max(high, def->vertices[3 * v + k]);
        }
        if (high > low) size2 += (high - low) * (high - low);
    }
    return sqrt(size2);
}

/// Adds triangle (a, b, c) of vertices that exist, unless it has no area.
static void add_triangle(qn_mesh *m, const int at[3])
{
    qn_vec3 a = m->vertices[at[0]], b = m->vertices[at[1]], c = m->vertices[at[2]];
    qn_vec3 ab = qn_sub(b, a), ac = qn_sub(c, a), bc = qn_sub(c, b);
    qn_vec3 normal = qn_cross(ab, ac);
    double twice_area = qn_norm(normal);
    double longest2 = qn_max(qn_dot(ab, ab), qn_max(qn_dot(ac, ac), qn_dot(bc, bc)));
    if (!(twice_area > SLIVER * longest2)) return;
    m->normals[m->triangle_count] = qn_scale(1 / twice_area, normal);
    memcpy(m->triangles + (ptrdiff_t)3 * m->triangle_count++, at, 3 * sizeof *at);
}

/// Welded vertices and triangles with area, in the order given.
static qn_status take_over(const qn_mesh_def *def, const int *first, int *number, qn_mesh *m)
{
    for (int v = 0; v < def->vertex_count; v++) {
        const double *x = def->vertices + (ptrdiff_t)3 * v;
        if (first[v] == v) m->vertices[m->vertex_count] = qn_v3(x[0], x[1], x[2]);
        number[v] = first[v] == v ? m->vertex_count++ : number[first[v]];
    }
    for (int t = 0; t < def->triangle_count; t++) {
        const int *at = def->triangles + (ptrdiff_t)3 * t;
        const int welded[3] = {number[at[0]], number[at[1]], number[at[2]]};
        add_triangle(m, welded);
    }
    if (m->triangle_count == 0)
        return qn_fail(QN_INPUT, "mesh '%s' has no triangle with area; it has %d triangles in all",
                       def->name, def->triangle_count);
    m->low = m->high = m->vertices[m->triangles[0]];
    for (int i = 0; i < 3 * m->triangle_count; i++) {
        qn_vec3 v = m->vertices[m->triangles[i]];
        m->low = qn_v3(qn_min(m->low.x, v.x), qn_min(m->low.y, v.y), qn_min(m->low.z, v.z));
        m->high = qn_v3(qn_max(m->high.x, v.x), qn_max(m->high.y, v.y), qn_max(m->high.z, v.z));
    }
    return QN_OK;
}

static qn_status weld(const qn_mesh_def *def, qn_mesh *m)
{
    int *first, *number = NULL;
    QN_TRY(QN_ALLOCATE(m->vertices, def->vertex_count));
    QN_TRY(QN_ALLOCATE(m->triangles, 3 * (int64_t)def->triangle_count));
    QN_TRY(QN_ALLOCATE(m->normals, def->triangle_count));
    QN_TRY(QN_ALLOCATE(first, def->vertex_count));
    qn_status status = find_same(def, extent(def), first);
    if (status == QN_OK) status = QN_ALLOCATE(number, def->vertex_count);
    if (status == QN_OK) status = take_over(def, first, number, m);
    free(first);
    free(number);
    return status;
}

typedef struct half_edge {
    int a, b;   // vertices, a < b
    int index;  // 3 x triangle + k
} half_edge;

static int by_edge(const void *p, const void *q)
{
    const half_edge *a = p, *b = q;
    if (a->a != b->a) return a->a < b->a ? -1 : 1;
    if (a->b != b->b) return a->b < b->b ? -1 : 1;
    return (a->index > b->index) - (a->index < b->index);
}

static qn_vec3 unit(qn_vec3 v)
{
    return qn_scale(1 / qn_norm(v), v);
}

/// Makes the in-plane normals of coplanar neighbours exactly opposite and copies them to the wedge.
static void settle_wedge(qn_mesh *m, const half_edge *at, const qn_mesh_edge *e)
{
    for (int i = 0; i < e->count; i++)
        for (int j = i + 1; j < e->count; j++) {
            qn_vec3 *a = &m->sides[at[i].index], *b = &m->sides[at[j].index];
            if (qn_norm(qn_add(*a, *b)) < COPLANAR) *b = qn_scale(-1, *a);
        }
    for (int i = 0; i < e->count; i++) m->wedges[e->first + i] = m->sides[at[i].index];
}

static void number_edges(qn_mesh *m, half_edge *halves, int n)
{
    qsort(halves, (size_t)n, sizeof *halves, by_edge);
    for (int i = 0; i < n;) {
        const half_edge *h = &halves[i];
        qn_mesh_edge *e = &m->edges[m->edge_count];
        *e = (qn_mesh_edge){.a = h->a, .b = h->b, .owner = h->index / 3, .first = i};
        e->along = unit(qn_sub(m->vertices[h->b], m->vertices[h->a]));
        for (; i < n && halves[i].a == h->a && halves[i].b == h->b; i++, e->count++) {
            int t = halves[i].index / 3, k = halves[i].index % 3;
            m->triangle_edges[halves[i].index] = m->edge_count;
            qn_vec3 side = unit(qn_cross(e->along, m->normals[t]));
            qn_vec3 third = m->vertices[m->triangles[3 * t + (k + 2) % 3]];
            bool inwards = qn_dot(side, qn_sub(third, m->vertices[h->a])) > 0;
            m->sides[halves[i].index] = inwards ? qn_scale(-1, side) : side;
        }
        settle_wedge(m, h, e);
        m->edge_count++;
    }
}

static qn_status find_edges(qn_mesh *m)
{
    int n = 3 * m->triangle_count;
    half_edge *halves;
    QN_TRY(QN_ALLOCATE(m->edges, n));
    QN_TRY(QN_ALLOCATE(m->triangle_edges, n));
    QN_TRY(QN_ALLOCATE(m->sides, n));
    QN_TRY(QN_ALLOCATE(m->wedges, n));
    QN_TRY(QN_ALLOCATE(halves, n));
    for (int i = 0; i < n; i++) {
        int p = m->triangles[i], q = m->triangles[i - i % 3 + (i + 1) % 3];
        halves[i] = (half_edge){p < q ? p : q, p < q ? q : p, i};
    }
    number_edges(m, halves, n);
    free(halves);
    return QN_OK;
}

/// Turns counts at start[1 + i] into the places where the lists begin.
static void sum_up(int *start, int n)
{
    for (int i = 0; i < n; i++) start[i + 1] += start[i];
}

/// Undoes the advance of the beginnings while the lists were filled.
static void move_back(int *start, int n)
{
    for (int i = n; i > 0; i--) start[i] = start[i - 1];
    start[0] = 0;
}

static qn_status find_fans(qn_mesh *m)
{
    int n = m->vertex_count;
    QN_TRY(QN_ALLOCATE(m->vertex_owner, n));
    QN_TRY(QN_ALLOCATE(m->fan_start, n + 1));
    QN_TRY(QN_ALLOCATE(m->fan, 2 * (int64_t)m->edge_count));
    for (int i = 3 * m->triangle_count - 1; i >= 0; i--) m->vertex_owner[m->triangles[i]] = i / 3;
    for (int e = 0; e < m->edge_count; e++) {
        m->fan_start[m->edges[e].a + 1]++;
        m->fan_start[m->edges[e].b + 1]++;
    }
    sum_up(m->fan_start, n);
    for (int e = 0; e < m->edge_count; e++) {
        m->fan[m->fan_start[m->edges[e].a]++] = e;
        m->fan[m->fan_start[m->edges[e].b]++] = e;
    }
    move_back(m->fan_start, n);
    return QN_OK;
}

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
    double fine =
        0.7 * sqrt(2 * area / m->triangle_count);  // m   half a square of two triangles, about
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

static qn_status find_discs(qn_mesh *m)
{
    QN_TRY(QN_ALLOCATE(m->discs, m->triangle_count));
    for (int t = 0; t < m->triangle_count; t++) {
        const int *at = m->triangles + (ptrdiff_t)3 * t;
        qn_vec3 sum = qn_add(qn_add(m->vertices[at[0]], m->vertices[at[1]]), m->vertices[at[2]]);
        qn_mesh_disc *disc = &m->discs[t];
        *disc = (qn_mesh_disc){.middle = qn_scale(1.0 / 3, sum), .normal = m->normals[t]};
        for (int k = 0; k < 3; k++) {
            double far = qn_norm(qn_sub(m->vertices[at[k]], disc->middle));
            disc->radius = qn_max(disc->radius, far * (1 + 1e-6));
        }
    }
    return QN_OK;
}

static qn_status build_grid(qn_mesh *m)
{
    choose_cells(m);
    int total = m->cells[0] * m->cells[1] * m->cells[2];
    QN_TRY(QN_ALLOCATE(m->cell_start, total + 1));
    for (int t = 0; t < m->triangle_count; t++) cover(m, t, m->cell_start + 1, NULL);
    sum_up(m->cell_start, total);
    QN_TRY(QN_ALLOCATE(m->cell_items, m->cell_start[total]));
    for (int t = 0; t < m->triangle_count; t++) cover(m, t, m->cell_start, m->cell_items);
    move_back(m->cell_start, total);
    return QN_OK;
}

static qn_status build(const qn_mesh_def *def, double reach, qn_mesh *m)
{
    QN_TRY(check(def, reach));
    memcpy(m->name, def->name, sizeof m->name);
    m->material = def->material;
    m->reach = reach;
    QN_TRY(weld(def, m));
    QN_TRY(find_edges(m));
    QN_TRY(find_fans(m));
    QN_TRY(find_discs(m));
    return build_grid(m);
}

qn_status qn_mesh_build(const qn_mesh_def *def, double reach, qn_mesh *mesh)
{
    *mesh = (qn_mesh){0};
    qn_status status = build(def, reach, mesh);
    if (status != QN_OK) qn_mesh_free(mesh);
    return status;
}
