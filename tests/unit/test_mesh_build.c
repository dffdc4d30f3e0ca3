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
    CHECK(mesh.vertex_count == 4 && mesh.triangle_count == 2 && mesh.edge_count == 5);
    for (int i = 0; i < 2000; i++) {
        qn_vec3 centre = qn_v3(sheet_uniform(0.1, 0.9), sheet_uniform(0.1, 0.9), 0.05);
        if (i % 2) centre.y = centre.x;
        qn_mesh_hit hits[SHEET_ROOM];
        CHECK(qn_mesh_touch(&mesh, centre, 0.1, hits, SHEET_ROOM) == 1);
        CHECK(sheet_distance(hits[0].point, qn_v3(centre.x, centre.y, 0)) < 1e-15);
    }
    qn_mesh_free(&mesh);
}

static void what_is_odd_is_told_with_its_place(void)
{
    // A floor of two triangles with a fin on its diagonal; one triangle again, wound the other way, one flat,
    // one more whose corners are a hair's breadth and whose side is a seam away.
    double vertices[] = {0, 0, 0, 1,    0, 0, 1,    1, 0,   0, 1,    0, 0.5, 0.5,
                         1, 1, 0, 5e-5, 1, 1, 5e-5, 2, 0.5, 0, 3e-9, 1, 0};
    int triangles[] = {0, 1, 2, 0, 2, 3, 2, 0, 4, 1, 0, 2, 0, 1, 1, 5, 6, 7, 8, 2, 0};
    qn_mesh_def def = sheet_of(vertices, 9, triangles, 7);
    qn_mesh mesh;
    char text[512];
    CHECK_STATUS(qn_mesh_build(&def, 0.1, &mesh));
    static const int counts[QN_MESH_FLAW_COUNT] = {1, 1, 2, 9, 2, 1};
    static const int firsts[QN_MESH_FLAW_COUNT] = {9, 5, 4, 1, 1, 1};
    for (int k = 0; k < QN_MESH_FLAW_COUNT; k++) {
        CHECK(mesh.flaws[k].count == counts[k]);
        CHECK(mesh.flaws[k].first == firsts[k]);
    }
    qn_mesh_flaw_text(&mesh, QN_MESH_TWICE, 1e-3, "mm", text, sizeof text);
    CHECK(!strcmp(text,
                  "mesh 'sheet': 2 triangles are given more than once and used once; the first "
                  "is triangle 4 at 1000 0 0 mm"));
    qn_mesh_flaw_text(&mesh, QN_MESH_CROWDED, 1, "", text, sizeof text);
    CHECK(!strcmp(text,
                  "mesh 'sheet': 1 edge belongs to three triangles or more; it is at triangle 1 "
                  "at 0.5 0.5 0"));
    qn_mesh_free(&mesh);
}

static void a_closed_mesh_has_nothing_odd(void)
{
    double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    int triangles[] = {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};
    qn_mesh_def def = sheet_of(vertices, 4, triangles, 4);
    qn_mesh mesh;
    char text[512];
    CHECK_STATUS(qn_mesh_build(&def, 0.1, &mesh));
    for (int k = 0; k < QN_MESH_FLAW_COUNT; k++) {
        qn_mesh_flaw_text(&mesh, k, 1, "", text, sizeof text);
        CHECK(mesh.flaws[k].count == 0 && !*text);
    }
    qn_mesh_free(&mesh);
}

static void vertices_as_far_apart_as_single_precision_leaves_them_are_joined(void)
{
    // Two squares far from the origin whose common side is rounded differently, wherever that lies.
    for (int i = 0; i < 500; i++) {
        double x = sheet_uniform(3, 4), left = x - sheet_uniform(0.5, 1), off = 1.5e-7;
        double vertices[] = {left,    0, 0,    x,       0, 0,   x,     1, 0,
                             x + off, 0, -off, x + off, 1, off, x + 1, 0, 0};
        int triangles[] = {0, 1, 2, 3, 5, 4};
        qn_mesh_def def = sheet_of(vertices, 6, triangles, 2);
        qn_mesh mesh;
        CHECK_STATUS(qn_mesh_build(&def, 0.1, &mesh));
        CHECK(mesh.vertex_count == 4 && mesh.edge_count == 5);
        CHECK(mesh.flaws[QN_MESH_APART].count == 2 && mesh.flaws[QN_MESH_BORDER].count == 4);
        qn_mesh_free(&mesh);
    }
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
    TEST(what_is_odd_is_told_with_its_place);
    TEST(a_closed_mesh_has_nothing_odd);
    TEST(vertices_as_far_apart_as_single_precision_leaves_them_are_joined);
    TEST(impossible_meshes_are_refused);
    DONE;
}
