// SPDX-License-Identifier: Apache-2.0
// Set-up of a mesh: welding, what is wrong with it, edges with their wedges, corners with their fans.
#include "world/mesh_flaws.h"

#include <stdlib.h>
#include <string.h>

static const double WELD = 1e-7;      // 1   of the mesh's size: vertices nearer are the same; what
                                      //     single precision leaves of it in an STL file
static const double COPLANAR = 1e-9;  // 1   in-plane normals that cancel to this run on smoothly
static const double SLIVER = 1e-12;   // 1   of the longest side squared: triangles of less area go

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

/// Adds triangle `number` of the file, of vertices that exist, unless it has no area.
static void add_triangle(qn_mesh *m, const int at[3], int number)
{
    qn_vec3 a = m->vertices[at[0]], b = m->vertices[at[1]], c = m->vertices[at[2]];
    qn_vec3 ab = qn_sub(b, a), ac = qn_sub(c, a), bc = qn_sub(c, b);
    qn_vec3 normal = qn_cross(ab, ac);
    double twice_area = qn_norm(normal);
    double longest2 = qn_max(qn_dot(ab, ab), qn_max(qn_dot(ac, ac), qn_dot(bc, bc)));
    if (!(twice_area > SLIVER * longest2)) {
        qn_mesh_note(m, QN_MESH_FLAT, number, a);
        return;
    }
    m->normals[m->triangle_count] = qn_scale(1 / twice_area, normal);
    m->source[m->triangle_count] = number;
    memcpy(m->triangles + (ptrdiff_t)3 * m->triangle_count++, at, 3 * sizeof *at);
}

/// Joined vertices, in the order given. A vertex that is moved by joining is told; copies are no flaw.
static void join_vertices(const qn_mesh_def *def, const qn_vec3 *points, const int *first,
                          int *number, qn_mesh *m)
{
    for (int v = 0; v < def->vertex_count; v++) {
        if (first[v] == v) m->vertices[m->vertex_count] = points[v];
        number[v] = first[v] == v ? m->vertex_count++ : number[first[v]];
        qn_vec3 moved = qn_sub(points[v], points[first[v]]);
        if (qn_dot(moved, moved) > 0) qn_mesh_note(m, QN_MESH_APART, v + 1, points[v]);
    }
}

typedef struct trio {
    int vertex[3];  // ascending
    int index;
} trio;

static int by_vertices(const void *a, const void *b)
{
    const trio *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p->vertex[k] != q->vertex[k]) return p->vertex[k] < q->vertex[k] ? -1 : 1;
    return (p->index > q->index) - (p->index < q->index);
}

static trio trio_of(const int *at, int index)
{
    int low = at[0] < at[1] ? at[0] : at[1], high = at[0] < at[1] ? at[1] : at[0];
    if (at[2] < low) return (trio){{at[2], low, high}, index};
    if (at[2] < high) return (trio){{low, at[2], high}, index};
    return (trio){{low, high, at[2]}, index};
}

/// Takes out triangles whose vertices are those of an earlier one.
static qn_status drop_copies(qn_mesh *m)
{
    trio *trios;
    int kept = 0;
    QN_TRY(QN_ALLOCATE(trios, m->triangle_count));
    for (int t = 0; t < m->triangle_count; t++)
        trios[t] = trio_of(m->triangles + (ptrdiff_t)3 * t, t);
    qsort(trios, (size_t)m->triangle_count, sizeof *trios, by_vertices);
    for (int i = 1; i < m->triangle_count; i++) {
        if (memcmp(trios[i].vertex, trios[i - 1].vertex, sizeof trios[i].vertex) != 0) continue;
        int t = trios[i].index;
        qn_mesh_note(m, QN_MESH_TWICE, m->source[t], m->vertices[m->triangles[3 * t]]);
        m->source[t] = 0;
    }
    free(trios);
    for (int t = 0; t < m->triangle_count; t++) {
        if (m->source[t] == 0) continue;
        memmove(m->triangles + (ptrdiff_t)3 * kept, m->triangles + (ptrdiff_t)3 * t,
                3 * sizeof(int));
        m->normals[kept] = m->normals[t];
        m->source[kept++] = m->source[t];
    }
    m->triangle_count = kept;
    return QN_OK;
}

static void find_box(qn_mesh *m)
{
    m->low = m->high = m->vertices[m->triangles[0]];
    for (int i = 0; i < 3 * m->triangle_count; i++) {
        qn_vec3 v = m->vertices[m->triangles[i]];
        m->low = qn_v3(qn_min(m->low.x, v.x), qn_min(m->low.y, v.y), qn_min(m->low.z, v.z));
        m->high = qn_v3(qn_max(m->high.x, v.x), qn_max(m->high.y, v.y), qn_max(m->high.z, v.z));
    }
}

/// Vertices and triangles as they are used. points, first, number: room for each vertex.
static qn_status take_over(const qn_mesh_def *def, qn_vec3 *points, int *first, int *number,
                           qn_mesh *m)
{
    for (int v = 0; v < def->vertex_count; v++) {
        const double *x = def->vertices + (ptrdiff_t)3 * v;
        points[v] = qn_v3(x[0], x[1], x[2]);
    }
    QN_TRY(qn_same_places(points, def->vertex_count, WELD * extent(def), first));
    join_vertices(def, points, first, number, m);
    for (int t = 0; t < def->triangle_count; t++) {
        const int *at = def->triangles + (ptrdiff_t)3 * t;
        const int joined[3] = {number[at[0]], number[at[1]], number[at[2]]};
        add_triangle(m, joined, t + 1);
    }
    if (m->triangle_count == 0)
        return qn_fail(QN_INPUT, "mesh '%s' has no triangle with area; it has %d triangles in all",
                       def->name, def->triangle_count);
    QN_TRY(drop_copies(m));
    find_box(m);
    return QN_OK;
}

static qn_status weld(const qn_mesh_def *def, qn_mesh *m)
{
    int *first = NULL, *number = NULL;
    qn_vec3 *points = NULL;
    QN_TRY(QN_ALLOCATE(m->vertices, def->vertex_count));
    QN_TRY(QN_ALLOCATE(m->triangles, 3 * (int64_t)def->triangle_count));
    QN_TRY(QN_ALLOCATE(m->normals, def->triangle_count));
    QN_TRY(QN_ALLOCATE(m->source, def->triangle_count));
    qn_status status = QN_ALLOCATE(points, def->vertex_count);
    if (status == QN_OK) status = QN_ALLOCATE(first, def->vertex_count);
    if (status == QN_OK) status = QN_ALLOCATE(number, def->vertex_count);
    if (status == QN_OK) status = take_over(def, points, first, number, m);
    free(points);
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
    qn_rows_begin(m->fan_start, n);
    for (int e = 0; e < m->edge_count; e++) {
        m->fan[m->fan_start[m->edges[e].a]++] = e;
        m->fan[m->fan_start[m->edges[e].b]++] = e;
    }
    qn_rows_end(m->fan_start, n);
    return QN_OK;
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
    QN_TRY(qn_mesh_find_flaws(m));
    return qn_mesh_grid(m);
}

qn_status qn_mesh_build(const qn_mesh_def *def, double reach, qn_mesh *mesh)
{
    *mesh = (qn_mesh){0};
    qn_status status = build(def, reach, mesh);
    if (status != QN_OK) qn_mesh_free(mesh);
    return status;
}
