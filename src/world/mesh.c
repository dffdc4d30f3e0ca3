// SPDX-License-Identifier: Apache-2.0
// Questions to a mesh: what a sphere touches and how far a point is.
//
// Ownership is decided by products that neighbours share, so that one stretch of surface answers
// once. Rounding can still leave a sphere that stands exactly over a corner of a tilted plane with no
// owner or with several: feet that lie together are joined, and where nothing answers the nearest
// point does. An edge or corner whose foot lies on another triangle that is nearer (a vertex in the
// middle of a neighbour's edge) is no nearest point of the surface and is passed over.
#include "world/mesh.h"
#include "world/touch.h"

#include <stdlib.h>

enum { HITS = 64 };  // most features one sphere is taken to touch; further ones are passed over

void qn_mesh_free(qn_mesh *mesh)
{
    free(mesh->vertices);
    free(mesh->triangles);
    free(mesh->source);
    free(mesh->edges);
    free(mesh->triangle_edges);
    free(mesh->normals);
    free(mesh->discs);
    free(mesh->sides);
    free(mesh->wedges);
    free(mesh->vertex_owner);
    free(mesh->fan_start);
    free(mesh->fan);
    free(mesh->cell_start);
    free(mesh->cell_items);
    *mesh = (qn_mesh){0};
}

static qn_vec3 corner(const qn_mesh *m, int t, int k)
{
    return m->vertices[m->triangles[3 * t + k]];
}

static double square_between(qn_vec3 a, qn_vec3 b)
{
    qn_vec3 d = qn_sub(a, b);
    return qn_dot(d, d);
}

/// Barycentric regions; Ericson (2005), 5.1.5.
qn_triangle_foot qn_triangle_nearest(const qn_mesh *mesh, int t, qn_vec3 point)
{
    qn_vec3 a = corner(mesh, t, 0), b = corner(mesh, t, 1), c = corner(mesh, t, 2);
    qn_vec3 ab = qn_sub(b, a), ac = qn_sub(c, a), bc = qn_sub(c, b);
    qn_vec3 ap = qn_sub(point, a), bp = qn_sub(point, b), cp = qn_sub(point, c);
    double d1 = qn_dot(ab, ap), d2 = qn_dot(ac, ap), d3 = qn_dot(ab, bp);
    double d4 = qn_dot(ac, bp), d5 = qn_dot(ab, cp), d6 = qn_dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return (qn_triangle_foot){a, 4};
    if (d3 >= 0 && d4 <= d3) return (qn_triangle_foot){b, 5};
    if (d6 >= 0 && d5 <= d6) return (qn_triangle_foot){c, 6};
    double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (qn_triangle_foot){qn_madd(a, d1 / (d1 - d3), ab), 1};
    if (va <= 0 && d4 >= d3 && d5 >= d6)
        return (qn_triangle_foot){qn_madd(b, (d4 - d3) / ((d4 - d3) + (d5 - d6)), bc), 2};
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (qn_triangle_foot){qn_madd(a, d2 / (d2 - d6), ac), 3};
    double scale = 1 / (va + vb + vc);
    return (qn_triangle_foot){qn_madd(qn_madd(a, vb * scale, ab), vc * scale, ac), 0};
}

typedef struct search {
    const qn_mesh *mesh;
    qn_vec3 centre;
    double radius;               // m
    const int *triangles, *end;  //    those near the centre's cell
    int count;
    qn_mesh_hit hits[HITS];
} search;

static void keep(search *s, int32_t feature, qn_vec3 point)
{
    if (s->count < HITS) s->hits[s->count++] = (qn_mesh_hit){feature, point};
}

static void try_face(search *s, int t)
{
    const qn_mesh *m = s->mesh;
    for (int k = 0; k < 3; k++) {
        const qn_mesh_edge *e = &m->edges[m->triangle_edges[3 * t + k]];
        if (!(qn_dot(qn_sub(s->centre, m->vertices[e->a]), m->sides[3 * t + k]) < 0)) return;
    }
    double height = qn_dot(qn_sub(s->centre, corner(m, t, 0)), m->normals[t]);
    keep(s, t, qn_madd(s->centre, -height, m->normals[t]));
}

static void try_edge(search *s, int index)
{
    const qn_mesh *m = s->mesh;
    const qn_mesh_edge *e = &m->edges[index];
    qn_vec3 from_a = qn_sub(s->centre, m->vertices[e->a]);
    double along = qn_dot(from_a, e->along);
    if (!(along > 0 && qn_dot(qn_sub(s->centre, m->vertices[e->b]), e->along) < 0)) return;
    for (int k = e->first; k < e->first + e->count; k++)
        if (!(qn_dot(from_a, m->wedges[k]) >= 0)) return;
    qn_vec3 foot = qn_madd(m->vertices[e->a], along, e->along);
    if (square_between(s->centre, foot) < s->radius * s->radius)
        keep(s, m->triangle_count + index, foot);
}

static void try_vertex(search *s, int vertex)
{
    const qn_mesh *m = s->mesh;
    qn_vec3 d = qn_sub(s->centre, m->vertices[vertex]);
    if (!(qn_dot(d, d) < s->radius * s->radius)) return;
    for (int k = m->fan_start[vertex]; k < m->fan_start[vertex + 1]; k++) {
        const qn_mesh_edge *e = &m->edges[m->fan[k]];
        double away = qn_dot(d, e->along);
        if (!(e->a == vertex ? away <= 0 : away >= 0)) return;
    }
    keep(s, m->triangle_count + m->edge_count + vertex, m->vertices[vertex]);
}

/// Whether a foot lies on a triangle that has a point nearer to the centre than the foot is.
static bool is_passed_over(const search *s, qn_vec3 foot)
{
    double size = qn_norm(qn_sub(s->mesh->high, s->mesh->low)), slack = 1e-7 * size;
    double distance2 = square_between(s->centre, foot);
    for (const int *t = s->triangles; t < s->end; t++) {
        qn_vec3 from = qn_sub(foot, corner(s->mesh, *t, 0));
        if (fabs(qn_dot(from, s->mesh->normals[*t])) > slack) continue;
        qn_vec3 on = qn_triangle_nearest(s->mesh, *t, foot).point;
        if (square_between(on, foot) > slack * slack) continue;
        qn_vec3 nearest = qn_triangle_nearest(s->mesh, *t, s->centre).point;
        if (square_between(nearest, s->centre) < distance2 * (1 - 1e-6)) return true;
    }
    return false;
}

static void take_out(search *s, int out)
{
    for (int k = out; k + 1 < s->count; k++) s->hits[k] = s->hits[k + 1];
    s->count--;
}

static void sort_by_feature(search *s)
{
    for (int i = 1; i < s->count; i++) {
        qn_mesh_hit hit = s->hits[i];
        int j = i;
        for (; j > 0 && s->hits[j - 1].feature > hit.feature; j--) s->hits[j] = s->hits[j - 1];
        s->hits[j] = hit;
    }
}

/// Leaves one of several hits that are the same contact.
static void settle_several(search *s)
{
    double near = QN_ONE_CONTACT * s->radius;
    sort_by_feature(s);
    for (int i = s->count - 1; i >= 0; i--)
        if (s->hits[i].feature >= s->mesh->triangle_count && is_passed_over(s, s->hits[i].point))
            take_out(s, i);
    for (int i = 0; i < s->count; i++)
        for (int j = i + 1; j < s->count; j++) {
            if (square_between(s->hits[i].point, s->hits[j].point) >= near * near) continue;
            bool keep_i = square_between(s->hits[i].point, s->centre)
                          <= square_between(s->hits[j].point, s->centre);
            take_out(s, keep_i ? j : i);
            j = i;
        }
}

/// The nearest point of all, where rounding has left a sphere that overlaps without an owner.
static void settle_none(search *s)
{
    const qn_mesh *m = s->mesh;
    double best = s->radius * s->radius;
    for (const int *t = s->triangles; t < s->end; t++) {
        qn_triangle_foot foot = qn_triangle_nearest(m, *t, s->centre);
        double distance2 = square_between(foot.point, s->centre);
        if (!(distance2 < best)) continue;
        best = distance2;
        int32_t feature = *t;
        if (foot.region >= 4)
            feature = m->triangle_count + m->edge_count + m->triangles[3 * *t + foot.region - 4];
        else if (foot.region >= 1)
            feature = m->triangle_count + m->triangle_edges[3 * *t + foot.region - 1];
        s->hits[0] = (qn_mesh_hit){feature, foot.point};
        s->count = 1;
    }
}

/// Whether a sphere cuts a triangle's plane, and in a circle that comes as near as the triangle's disc.
static bool reaches_disc(const qn_mesh_disc *disc, qn_vec3 centre, double radius)
{
    qn_vec3 from = qn_sub(centre, disc->middle);
    double height = qn_dot(from, disc->normal);
    double circle2 = radius * radius - height * height;
    if (!(circle2 > 0)) return false;
    double along2 = qn_max(qn_dot(from, from) - height * height, 0);
    return sqrt(along2) < sqrt(circle2) + disc->radius;
}

int qn_mesh_touch(const qn_mesh *mesh, qn_vec3 centre, double radius, qn_mesh_hit *hits, int room)
{
    int cell = qn_mesh_cell(mesh, centre);
    if (cell < 0 || mesh->cell_start[cell] == mesh->cell_start[cell + 1]) return 0;
    search s;
    s.mesh = mesh;
    s.centre = centre;
    s.radius = radius;
    s.triangles = mesh->cell_items + mesh->cell_start[cell];
    s.end = mesh->cell_items + mesh->cell_start[cell + 1];
    s.count = 0;
    bool near = false;
    for (const int *t = s.triangles; t < s.end; t++) {
        if (!reaches_disc(&mesh->discs[*t], centre, radius)) continue;
        near = true;
        try_face(&s, *t);
        for (int k = 0; k < 3; k++) {
            int edge = mesh->triangle_edges[3 * *t + k], vertex = mesh->triangles[3 * *t + k];
            if (mesh->edges[edge].owner == *t) try_edge(&s, edge);
            if (mesh->vertex_owner[vertex] == *t) try_vertex(&s, vertex);
        }
    }
    if (s.count > 1) settle_several(&s);
    if (s.count == 0 && near) settle_none(&s);
    for (int k = 0; k < s.count && k < room; k++) hits[k] = s.hits[k];
    return s.count;
}

/// Lowers the squared distance `best` to that of the triangles listed in one cell.
static double nearest_in_cell(const qn_mesh *m, int cell, qn_vec3 point, double best)
{
    for (int k = m->cell_start[cell]; k < m->cell_start[cell + 1]; k++) {
        qn_vec3 nearest = qn_triangle_nearest(m, m->cell_items[k], point).point;
        best = qn_min(best, square_between(nearest, point));
    }
    return best;
}

static int clamped_cell(double offset, double cell, int cells)
{
    return (int)qn_max(0, qn_min(cells - 1, floor(offset / cell)));
}

/// Looks through boxes of cells around the point, one layer after the other, until no cell further
/// out can hold anything nearer. A triangle is listed in every cell it passes through.
double qn_mesh_distance(const qn_mesh *mesh, qn_vec3 point, double limit)
{
    qn_vec3 offset = qn_sub(point, mesh->origin);
    const int *n = mesh->cells;
    const int at[3] = {clamped_cell(offset.x, mesh->cell, n[0]),
                       clamped_cell(offset.y, mesh->cell, n[1]),
                       clamped_cell(offset.z, mesh->cell, n[2])};
    int layers = n[0] > n[1] ? n[0] : n[1];
    if (n[2] > layers) layers = n[2];
    double best = limit * limit;
    for (int k = 0; k < layers; k++) {
        double least = (k - 1) * mesh->cell;  // m   from the point to anything in this layer
        if (k > 0 && least * least >= best) break;
        for (int z = at[2] - k; z <= at[2] + k; z++)
            for (int y = at[1] - k; y <= at[1] + k; y++) {
                bool whole_row = abs(z - at[2]) == k || abs(y - at[1]) == k;
                int stride = whole_row || k == 0 ? 1 : 2 * k;
                if (z < 0 || y < 0 || z >= n[2] || y >= n[1]) continue;
                for (int x = at[0] - k; x <= at[0] + k; x += stride)
                    if (x >= 0 && x < n[0])
                        best = nearest_in_cell(mesh, (z * n[1] + y) * n[0] + x, point, best);
            }
    }
    return sqrt(best);
}
