// SPDX-License-Identifier: Apache-2.0
// Touching a mesh: one contact wherever it is smooth, all of them where it is not.
#include "check.h"
#include "sheet.h"

#include <stdlib.h>

/// A rotation that leaves no axis where it was.
static qn_vec3 tilted(qn_vec3 v)
{
    const double a = 0.7, b = 0.4;
    qn_vec3 u = qn_v3(cos(a) * v.x - sin(a) * v.y, sin(a) * v.x + cos(a) * v.y, v.z);
    return qn_v3(u.x, cos(b) * u.y - sin(b) * u.z, sin(b) * u.y + cos(b) * u.z);
}

static void tilt(double *vertices, int count)
{
    for (int i = 0; i < count; i++) {
        qn_vec3 v = tilted(qn_v3(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]));
        vertices[3 * i] = v.x;
        vertices[3 * i + 1] = v.y;
        vertices[3 * i + 2] = v.z;
    }
}

/// Sides of the unit cube at the origin, each two triangles: z = 0, y = 0, x = 0, then opposite.
static const double cube_vertices[24] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                         0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
static const int cube_triangles[36] = {0, 1, 2, 0, 2, 3, 0, 1, 5, 0, 5, 4, 0, 3, 7, 0, 7, 4,
                                       4, 5, 6, 4, 6, 7, 3, 2, 6, 3, 6, 7, 1, 2, 6, 1, 6, 5};

static qn_status build_cube(int sides, bool is_tilted, double reach, qn_mesh *mesh)
{
    double vertices[24];
    int triangles[36];
    memcpy(vertices, cube_vertices, sizeof vertices);
    memcpy(triangles, cube_triangles, sizeof triangles);
    if (is_tilted) tilt(vertices, 8);
    qn_mesh_def def = sheet_of(vertices, 8, triangles, 2 * sides);
    return qn_mesh_build(&def, reach, mesh);
}

static void a_diagonal_is_not_felt_on_either_side(void)
{
    for (int is_tilted = 0; is_tilted < 2; is_tilted++) {
        qn_mesh mesh;
        CHECK_STATUS(build_cube(1, is_tilted, 0.1, &mesh));
        for (int i = 0; i <= 1000; i++)
            for (int side = -1; side <= 1; side += 2) {
                double along = 0.1 + 0.0008 * i, across = (i - 500) * 1e-3 * 0.05;
                if (i % 3 == 0) across = 0;
                qn_vec3 foot = qn_v3(along + across, along - across, 0);
                qn_vec3 centre = qn_v3(foot.x, foot.y, 0.09 * side);
                if (is_tilted) foot = tilted(foot), centre = tilted(centre);
                qn_mesh_hit hits[SHEET_ROOM];
                CHECK(qn_mesh_touch(&mesh, centre, 0.1, hits, SHEET_ROOM) == 1);
                CHECK(sheet_distance(hits[0].point, foot) < 1e-15);
                if (!is_tilted && across == 0) CHECK(hits[0].feature >= mesh.triangle_count);
            }
        qn_mesh_free(&mesh);
    }
}

static qn_status build_plane(int cells, qn_mesh *mesh)
{
    int n = cells + 1, count = 0;
    double *vertices = calloc((size_t)(3 * n * n), sizeof *vertices);
    int *triangles = calloc((size_t)(6 * cells * cells), sizeof *triangles);
    for (int i = 0; i < n * n; i++) {
        vertices[3 * i] = (double)(i % n) / cells;
        vertices[3 * i + 1] = (double)i / n / cells;  // sheared
    }
    for (int y = 0; y < cells; y++)
        for (int x = 0; x < cells; x++) {
            const int corners[6] = {0, 1, n + 1, n, n + 1, 0};
            for (int k = 0; k < 6; k++) triangles[count++] = y * n + x + corners[k];
        }
    tilt(vertices, n * n);
    qn_mesh_def def = sheet_of(vertices, n * n, triangles, 2 * cells * cells);
    qn_status status = qn_mesh_build(&def, 0.05, mesh);
    free(vertices);
    free(triangles);
    return status;
}

static void a_plane_of_many_triangles_is_one_plane(void)
{
    qn_mesh mesh;
    CHECK_STATUS(build_plane(71, &mesh));
    CHECK(mesh.triangle_count == 2 * 71 * 71);
    for (int i = 0; i < 20000; i++) {
        // Any place; on the line of vertices y = const; exactly over a vertex.
        qn_vec3 foot = qn_v3(sheet_uniform(0.1, 0.9), sheet_uniform(0.1, 0.9), 0), centre = foot;
        centre.z = sheet_uniform(-0.05, 0.05);
        foot = tilted(foot);
        centre = tilted(centre);
        if (i % 4 == 0) {
            qn_vec3 normal = tilted(qn_v3(0, 0, 1));
            foot = mesh.vertices[72 * (10 + i % 50) + 10 + i % 43];
            if (i % 8 == 0) foot = qn_scale(0.5, qn_add(foot, mesh.vertices[72 * 30 + 30]));
            centre = qn_madd(foot, sheet_uniform(-0.05, 0.05), normal);
        }
        qn_mesh_hit hits[SHEET_ROOM];
        CHECK(qn_mesh_touch(&mesh, centre, 0.05, hits, SHEET_ROOM) == 1);
        CHECK(sheet_distance(hits[0].point, foot) < 1e-12);
    }
    qn_mesh_free(&mesh);
}

/// Six triangles around a middle, in a plane of any direction; the normal is returned too.
static qn_status build_fan(qn_vec3 *middle, qn_vec3 *normal, qn_mesh *mesh)
{
    double vertices[21];
    int triangles[18];
    qn_vec3 n = qn_v3(sheet_uniform(-1, 1), sheet_uniform(-1, 1), sheet_uniform(0.1, 1));
    qn_vec3 u = qn_cross(n, qn_v3(0.3, 0.5, 0.1)), w = qn_cross(n, u);
    qn_vec3 o = qn_v3(sheet_uniform(-1, 1), sheet_uniform(-1, 1), sheet_uniform(-1, 1));
    *middle = o;
    *normal = qn_scale(1 / qn_norm(n), n);
    memcpy(vertices, &o, sizeof o);
    for (int i = 0; i < 6; i++) {
        qn_vec3 rim = qn_madd(qn_madd(o, cos(i * QN_PI / 3) / qn_norm(u), u),
                              sin(i * QN_PI / 3) / qn_norm(w), w);
        memcpy(vertices + 3 + (ptrdiff_t)3 * i, &rim, sizeof rim);
        triangles[3 * i] = 0;
        triangles[3 * i + 1] = 1 + i;
        triangles[3 * i + 2] = 1 + (i + 1) % 6;
    }
    qn_mesh_def def = sheet_of(vertices, 7, triangles, 6);
    return qn_mesh_build(&def, 0.8, mesh);
}

static void exactly_over_a_corner_of_a_plane_there_is_one_contact(void)
{
    for (int i = 0; i < 600; i++) {
        qn_mesh mesh;
        qn_vec3 middle, normal;
        CHECK_STATUS(build_fan(&middle, &normal, &mesh));
        for (int e = 0; e < mesh.edge_count; e++) {
            const qn_vec3 *side = &mesh.wedges[mesh.edges[e].first];
            if (mesh.edges[e].count == 2) CHECK(qn_norm(qn_add(side[0], side[1])) == 0);
        }
        for (int k = 0; k < 20; k++) {
            qn_mesh_hit hits[SHEET_ROOM];
            qn_vec3 centre = qn_madd(middle, sheet_uniform(-0.7, 0.7), normal);
            CHECK(qn_mesh_touch(&mesh, centre, 0.8, hits, SHEET_ROOM) == 1);
            CHECK(sheet_distance(hits[0].point, middle) < 1e-15);
        }
        qn_mesh_free(&mesh);
    }
}

static void an_edge_and_a_corner_that_stand_out_are_felt_once(void)
{
    qn_mesh mesh;
    CHECK_STATUS(build_cube(6, true, 0.1, &mesh));
    for (int i = 0; i <= 900; i++) {
        // Around the edge x = y = 0 from one face to the other, all at the same distance.
        double angle = QN_PI * (0.4 + 1.2 * i / 900 + 0.25), r = 0.08;
        double x = r * cos(angle), y = r * sin(angle);
        qn_vec3 foot = qn_v3(qn_max(x, 0), qn_max(y, 0), 0.5);
        double near = hypot(x - foot.x, y - foot.y);
        qn_mesh_hit hits[SHEET_ROOM];
        int n = qn_mesh_touch(&mesh, tilted(qn_v3(x, y, 0.5)), 0.1, hits, SHEET_ROOM);
        CHECK(n == 1);
        CHECK(sheet_distance(hits[0].point, tilted(foot)) < 1e-15 && near <= 0.0800001);
    }
    qn_mesh_hit hits[SHEET_ROOM];
    CHECK(qn_mesh_touch(&mesh, tilted(qn_v3(-0.03, -0.02, -0.05)), 0.1, hits, SHEET_ROOM) == 1);
    CHECK(hits[0].feature == mesh.triangle_count + mesh.edge_count);
    qn_mesh_free(&mesh);
}

static void faces_that_meet_inwards_are_all_felt(void)
{
    qn_mesh mesh;
    qn_mesh_hit hits[SHEET_ROOM];
    CHECK_STATUS(build_cube(3, true, 0.1, &mesh));
    CHECK(qn_mesh_touch(&mesh, tilted(qn_v3(0.5, 0.09, 0.08)), 0.1, hits, SHEET_ROOM) == 2);
    CHECK(sheet_distance(hits[0].point, tilted(qn_v3(0.5, 0.09, 0))) < 1e-15);
    CHECK(sheet_distance(hits[1].point, tilted(qn_v3(0.5, 0, 0.08))) < 1e-15);
    CHECK(qn_mesh_touch(&mesh, tilted(qn_v3(0.07, 0.09, 0.08)), 0.1, hits, SHEET_ROOM) == 3);
    CHECK(hits[0].feature < hits[1].feature && hits[1].feature < hits[2].feature);
    CHECK(qn_mesh_touch(&mesh, tilted(qn_v3(0.07, 0.09, 0.08)), 0.1, hits, 1) == 3);
    qn_mesh_free(&mesh);
}

static void a_border_is_felt_from_outside(void)
{
    qn_mesh mesh;
    qn_mesh_hit hits[SHEET_ROOM];
    CHECK_STATUS(build_cube(1, false, 0.1, &mesh));
    CHECK(qn_mesh_touch(&mesh, qn_v3(0.5, -0.06, 0.05), 0.1, hits, SHEET_ROOM) == 1);
    CHECK(sheet_distance(hits[0].point, qn_v3(0.5, 0, 0)) < 1e-16);
    CHECK(qn_mesh_touch(&mesh, qn_v3(-0.05, -0.05, -0.05), 0.1, hits, SHEET_ROOM) == 1);
    CHECK(sheet_distance(hits[0].point, qn_v3(0, 0, 0)) < 1e-16);
    CHECK(qn_mesh_touch(&mesh, qn_v3(-0.06, -0.06, -0.06), 0.1, hits, SHEET_ROOM) == 0);
    CHECK(qn_mesh_touch(&mesh, qn_v3(0.5, -0.06, 0.09), 0.1, hits, SHEET_ROOM) == 0);
    CHECK(qn_mesh_touch(&mesh, qn_v3(5, 5, 5), 0.1, hits, SHEET_ROOM) == 0);
    qn_mesh_free(&mesh);
}

/// A rough surface of random heights, with two triangles over each cell.
static qn_status build_rough(int cells, double height, double reach, qn_mesh *mesh)
{
    double vertices[3 * 400];
    int triangles[6 * 400], n = cells + 1, count = 0;
    for (int i = 0; i < n * n; i++) {
        vertices[3 * i] = (double)(i % n) / cells;
        vertices[3 * i + 1] = floor((double)i / n) / cells;
        vertices[3 * i + 2] = sheet_uniform(-height, height);
    }
    for (int y = 0; y < cells; y++)
        for (int x = 0; x < cells; x++) {
            const int corners[6] = {0, 1, n + 1, n, n + 1, 0};
            for (int k = 0; k < 6; k++) triangles[count++] = y * n + x + corners[k];
        }
    qn_mesh_def def = sheet_of(vertices, n * n, triangles, 2 * cells * cells);
    return qn_mesh_build(&def, reach, mesh);
}

static void any_sphere_that_overlaps_feels_the_nearest_point(void)
{
    const double reach = 0.05;
    qn_mesh mesh;
    CHECK_STATUS(build_rough(10, 0.05, reach, &mesh));
    int touches = 0;
    for (int i = 0; i < 15000; i++) {
        qn_vec3 centre =
            qn_v3(sheet_uniform(-0.1, 1.1), sheet_uniform(-0.1, 1.1), sheet_uniform(-0.1, 0.1));
        double nearest = INFINITY, best = INFINITY;
        for (int t = 0; t < mesh.triangle_count; t++)
            nearest = qn_min(nearest,
                             sheet_distance(centre, qn_triangle_nearest(&mesh, t, centre).point));
        CHECK_NEAR(qn_mesh_distance(&mesh, centre, 0.04), qn_min(nearest, 0.04), 1e-16);
        CHECK_NEAR(qn_mesh_distance(&mesh, centre, 9), nearest, 1e-16);
        qn_mesh_hit hits[SHEET_ROOM];
        int n = qn_mesh_touch(&mesh, centre, reach, hits, SHEET_ROOM);
        CHECK((n > 0) == (nearest < reach));
        for (int k = 0; k < n; k++) best = qn_min(best, sheet_distance(centre, hits[k].point));
        if (n > 0) CHECK_NEAR(best, nearest, 1e-14);
        touches += n;
    }
    CHECK(touches > 5000);
    qn_mesh_free(&mesh);
}

int main(int argc, char **argv)
{
    TEST(a_diagonal_is_not_felt_on_either_side);
    TEST(a_plane_of_many_triangles_is_one_plane);
    TEST(exactly_over_a_corner_of_a_plane_there_is_one_contact);
    TEST(an_edge_and_a_corner_that_stand_out_are_felt_once);
    TEST(faces_that_meet_inwards_are_all_felt);
    TEST(a_border_is_felt_from_outside);
    TEST(any_sphere_that_overlaps_feels_the_nearest_point);
    DONE;
}
