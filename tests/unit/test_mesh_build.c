// SPDX-License-Identifier: Apache-2.0
// Building a mesh: what is welded, shared, dropped or refused.
#include "check.h"
#include "sheet.h"

static void a_vertex_in_the_middle_of_an_edge_is_not_felt(void)
{
    // One large triangle beside two small ones that share its side.
    double vertices[] = {0, 0, 0, 1, 0, 0, 0.5, 1, 0, 0.4, 0, 0, 0.4, -1, 0};
    int triangles[] = {0, 1, 2, 0, 3, 4, 3, 1, 4};
    qn_mesh_def def = sheet_of(vertices, 5, triangles, 3);
    qn_mesh mesh;
    CHECK_STATUS(qn_mesh_build(&def, 0.1, &mesh));
    for (int i = 0; i < 2000; i++) {
        qn_vec3 centre = qn_v3(sheet_uniform(0.2, 0.7), sheet_uniform(-0.1, 0.1), 0.05);
        if (i % 2) centre.y = 0;
        qn_mesh_hit hits[SHEET_ROOM];
        CHECK(qn_mesh_touch(&mesh, centre, 0.1, hits, SHEET_ROOM) == 1);
        CHECK(sheet_distance(hits[0].point, qn_v3(centre.x, centre.y, 0)) < 1e-15);
    }
    qn_mesh_free(&mesh);
}

static void three_faces_may_share_an_edge(void)
{
    // A floor of two triangles and a fin that stands on their joint.
    double vertices[] = {0, 0, 0, 1, 0, 0, 0.5, 1, 0, 0.5, -1, 0, 0.5, 0, 1};
    int triangles[] = {0, 1, 2, 1, 0, 3, 0, 4, 1};
    qn_mesh_def def = sheet_of(vertices, 5, triangles, 3);
    qn_mesh mesh;
    qn_mesh_hit hits[SHEET_ROOM];
    CHECK_STATUS(qn_mesh_build(&def, 0.1, &mesh));
    CHECK(mesh.edge_count == 7);
    CHECK(qn_mesh_touch(&mesh, qn_v3(0.5, 0.05, 0.06), 0.1, hits, SHEET_ROOM) == 2);
    CHECK(qn_mesh_touch(&mesh, qn_v3(0.5, -0.05, 0.06), 0.1, hits, SHEET_ROOM) == 2);
    CHECK(qn_mesh_touch(&mesh, qn_v3(0.5, 0, -0.06), 0.1, hits, SHEET_ROOM) == 1);
    CHECK(qn_mesh_touch(&mesh, qn_v3(0.5, 0.001, -0.06), 0.1, hits, SHEET_ROOM) == 1);
    qn_mesh_free(&mesh);
}

static void copies_and_slivers_change_nothing(void)
{
    // Every triangle with vertices of its own, one twice, one without area, one vertex twice.
    double vertices[30] = {0, 0, 0, 1, 0, 0, 1, 1, 0,     0, 0, 0,
                           1, 1, 0, 0, 1, 0, 1, 1, 1e-12, 0, 0, 0};
    int triangles[15] = {0, 1, 2, 3, 4, 5, 3, 6, 5, 0, 1, 1, 0, 4, 7};
    qn_mesh_def def = sheet_of(vertices, 10, triangles, 5);
    qn_mesh mesh;
    CHECK_STATUS(qn_mesh_build(&def, 0.1, &mesh));
    CHECK(mesh.vertex_count == 4 && mesh.triangle_count == 3 && mesh.edge_count == 5);
    for (int i = 0; i < 2000; i++) {
        qn_vec3 centre = qn_v3(sheet_uniform(0.1, 0.9), sheet_uniform(0.1, 0.9), 0.05);
        if (i % 2) centre.y = centre.x;
        qn_mesh_hit hits[SHEET_ROOM];
        CHECK(qn_mesh_touch(&mesh, centre, 0.1, hits, SHEET_ROOM) == 1);
        CHECK(sheet_distance(hits[0].point, qn_v3(centre.x, centre.y, 0)) < 1e-15);
    }
    qn_mesh_free(&mesh);
}

static void impossible_meshes_are_refused(void)
{
    double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0}, odd[] = {0, 0, 0, 1, 0, 0, 0, NAN, 0};
    int good[] = {0, 1, 2}, beyond[] = {0, 1, 4}, before[] = {0, -1, 2}, flat[] = {0, 1, 3};
    const qn_mesh_def bad[] = {sheet_of(vertices, 4, beyond, 1), sheet_of(vertices, 4, before, 1),
                               sheet_of(vertices, 4, flat, 1), sheet_of(odd, 3, good, 1),
                               sheet_of(NULL, 0, NULL, 0)};
    qn_mesh mesh;
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        CHECK(qn_mesh_build(&bad[k], 0.1, &mesh) == QN_INPUT);
        CHECK(strstr(qn_error(), "'sheet'") != NULL && mesh.vertices == NULL);
    }
    qn_mesh_def def = sheet_of(vertices, 4, good, 1);
    CHECK(qn_mesh_build(&def, 0, &mesh) == QN_INPUT);
    CHECK_STATUS(qn_mesh_build(&def, 1e-4, &mesh));  // would be 1e8 cells
    CHECK((double)mesh.cells[0] * mesh.cells[1] * mesh.cells[2] <= 2e6);
    qn_mesh_free(&mesh);
}

int main(int argc, char **argv)
{
    TEST(a_vertex_in_the_middle_of_an_edge_is_not_felt);
    TEST(three_faces_may_share_an_edge);
    TEST(copies_and_slivers_change_nothing);
    TEST(impossible_meshes_are_refused);
    DONE;
}
