// SPDX-License-Identifier: Apache-2.0
// Triangle surfaces with exact ownership of faces, edges and corners.
//
// A sphere touches at most one feature of a smooth stretch: the face over which its centre lies, or
// an edge only from within that edge's Voronoi wedge, or a corner only from within its cone. A ball
// rolling over the joint of two coplanar triangles therefore feels one wall, to rounding. Both sides
// act and winding has no meaning; an edge may have any number of triangles. Triangles are found
// through a grid over the mesh's own frame, built once.
//
// Source: Ericson (2005), Real-Time Collision Detection, 5.1.5 (Voronoi regions of a triangle).
#ifndef QN_WORLD_MESH_H
#define QN_WORLD_MESH_H

#include "base/array.h"
#include "physics/vec3.h"
#include "world/def.h"

/// A touch of a sphere and a mesh, in the mesh's frame.
typedef struct qn_mesh_hit {
    int32_t feature;  //    0 .. feature_count-1: faces first, then edges, then corners
    qn_vec3 point;    // m  nearest point of the feature
} qn_mesh_hit;

/// An edge and the wedge from which it is felt.
typedef struct qn_mesh_edge {
    int a, b;          //    vertices, a < b
    int owner;         //    lowest triangle at it: the one that reports it
    int first, count;  //    of its wedge in qn_mesh.wedges
    qn_vec3 along;     // 1  unit direction from a to b
} qn_mesh_edge;

/// A disc that holds a triangle, about its centroid: what tells most triangles off at the cost of one
/// cache line.
typedef struct qn_mesh_disc {
    qn_vec3 middle, normal;  // m, 1
    double radius;           // m
    double unused;
} qn_mesh_disc;

// clang-format off
//    NAME      singular, plural, whether the mesh was mended
#define QN_MESH_FLAWS(F)                                                                            \
    F(APART,    "vertex lies",          "vertices lie",       "a hair's breadth from another: joined with it") \
    F(FLAT,     "triangle has",         "triangles have",     "no area: left out")             \
    F(TWICE,    "triangle is given",    "triangles are given", "more than once and used once")              \
    F(BORDER,   "edge belongs",         "edges belong",       "to one triangle only: a border, or a hole") \
    F(GAP,      "border edge runs",     "border edges run",   "close to another one: a seam that is not joined, through which edges are felt") \
    F(CROWDED,  "edge belongs",         "edges belong",       "to three triangles or more")
// clang-format on

enum {
#define F(NAME, one, many, what) QN_MESH_##NAME,
    QN_MESH_FLAWS(F)
#undef F
        QN_MESH_FLAW_COUNT
};

/// What is odd about a mesh, of one kind.
typedef struct qn_mesh_flaw {
    int count;
    int first;      //    number of the first in the file, from 1: a vertex, or a triangle
    qn_vec3 where;  // m  of the first
} qn_mesh_flaw;

typedef struct qn_mesh {
    char name[QN_NAME_MAX];
    int material;
    int surface, part, body;             //    set by walls.c
    int32_t first_feature, first_facet;  //    set by walls.c: numbers of all walls are one range
    int vertex_count, triangle_count, edge_count;
    qn_vec3 *vertices;     // m  owned; coincident vertices welded
    int *triangles;        //    3 x triangle_count, owned
    int *source;           //    number of each triangle in the file, from 1; owned
    qn_mesh_edge *edges;   //    owned
    int *triangle_edges;   //    3 x triangle_count, owned; edge k runs from corner k to k + 1
    qn_vec3 *normals;      // 1  of each triangle, owned
    qn_mesh_disc *discs;   //    around each triangle, owned
    qn_vec3 *sides;        // 1  3 x triangle_count, owned: in the triangle's plane, out over edge k
    qn_vec3 *wedges;       // 1  owned; the sides of the triangles at each edge
    int *vertex_owner;     //    lowest triangle at each vertex, owned
    int *fan_start, *fan;  //    edges at each vertex (CSR), owned
    qn_mesh_flaw flaws[QN_MESH_FLAW_COUNT];
    qn_vec3 low, high;  // m  bounding box
    double reach;       // m  largest radius of a sphere that may ask
    qn_vec3 origin;     // m  low corner of the grid, the box widened by the reach
    double cell;        // m  side of a grid cell
    int cells[3];
    int *cell_start, *cell_items;  //  triangles near each cell (CSR), owned
} qn_mesh;

/// Number of features of a mesh: faces, edges and corners.
static inline int32_t qn_mesh_feature_count(const qn_mesh *mesh)
{
    return mesh->triangle_count + mesh->edge_count + mesh->vertex_count;
}

/// The triangle a feature is, or the lowest of those that meet there.
static inline int qn_mesh_facet(const qn_mesh *mesh, int32_t feature)
{
    int32_t edge = feature - mesh->triangle_count, vertex = edge - mesh->edge_count;
    if (edge < 0) return feature;
    return vertex < 0 ? mesh->edges[edge].owner : mesh->vertex_owner[vertex];
}

/// Area (m2) of a triangle.
static inline double qn_mesh_area(const qn_mesh *mesh, int triangle)
{
    const int *at = mesh->triangles + (ptrdiff_t)3 * triangle;
    qn_vec3 a = mesh->vertices[at[0]];
    qn_vec3 ab = qn_sub(mesh->vertices[at[1]], a), ac = qn_sub(mesh->vertices[at[2]], a);
    return 0.5 * qn_norm(qn_cross(ab, ac));
}

/// Builds a mesh for spheres up to `reach` (m): joins coincident vertices, drops triangles without area and
/// those given twice, finds edges, flags coplanar joints, fills the grid; notes in `flaws` what was odd. QN_INPUT names what is wrong (an index
/// out of range, a coordinate that is not finite, no triangle at all).
QN_NODISCARD qn_status qn_mesh_build(const qn_mesh_def *def, double reach, qn_mesh *mesh);

void qn_mesh_free(qn_mesh *mesh);

/// What is odd about a mesh as a sentence: how many of a kind, and where the first is. Lengths are told in
/// `unit` (m) and named so; empty where there is nothing to say of that kind.
void qn_mesh_flaw_text(const qn_mesh *mesh, int kind, double unit, const char *unit_name,
                       char *text, size_t size);

/// Fills the grid of a mesh that has its edges and fans; part of qn_mesh_build().
QN_NODISCARD qn_status qn_mesh_grid(qn_mesh *mesh);

/// Rows of lists in one block, begun at start[row]: from the counts at start[row + 1] to where each row
/// begins, and, after filling has moved the beginnings on, back again.
static inline void qn_rows_begin(int *start, int rows)
{
    for (int i = 0; i < rows; i++) start[i + 1] += start[i];
}

static inline void qn_rows_end(int *start, int rows)
{
    for (int i = rows; i > 0; i--) start[i] = start[i - 1];
    start[0] = 0;
}

/// The features a sphere at `centre` with `radius` touches, in order of feature number; at most
/// `room`. Returns how many there are, also when more than `room`.
int qn_mesh_touch(const qn_mesh *mesh, qn_vec3 centre, double radius, qn_mesh_hit *hits, int room);

/// Nearest point of triangle t, and where it lies.
typedef struct qn_triangle_foot {
    qn_vec3 point;  // m
    int region;     //    0 the face, 1 + k edge k, 4 + k corner k
} qn_triangle_foot;

qn_triangle_foot qn_triangle_nearest(const qn_mesh *mesh, int t, qn_vec3 point);

/// The grid cell of a point, or -1 off the grid.
static inline int qn_mesh_cell(const qn_mesh *mesh, qn_vec3 point)
{
    double x = floor((point.x - mesh->origin.x) / mesh->cell);
    double y = floor((point.y - mesh->origin.y) / mesh->cell);
    double z = floor((point.z - mesh->origin.z) / mesh->cell);
    if (!(x >= 0 && y >= 0 && z >= 0)) return -1;
    if (!(x < mesh->cells[0] && y < mesh->cells[1] && z < mesh->cells[2])) return -1;
    return ((int)z * mesh->cells[1] + (int)y) * mesh->cells[0] + (int)x;
}

/// Distance (m) from a point to the mesh if below `limit`, else `limit`. Cost: O(cells within it).
double qn_mesh_distance(const qn_mesh *mesh, qn_vec3 point, double limit);

#endif
