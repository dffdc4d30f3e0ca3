// SPDX-License-Identifier: Apache-2.0
// The grid of a mesh: it hides nothing, and a cell lists little.
#include "check.h"
#include "sheet.h"

#include <stdlib.h>

/// A sheet of n x n squares of two triangles over the unit square, of random heights.
static qn_status build_rough(int n, uint64_t which, double height, double reach, qn_mesh *mesh)
{
    int side = n + 1, count = 0;
    double *vertices = calloc((size_t)(3 * side * side), sizeof *vertices);
    int *triangles = calloc((size_t)(6 * n * n), sizeof *triangles);
    for (int i = 0; i < side * side; i++) {
        which = which * 6364136223846793005u + 1442695040888963407u;
        vertices[3 * i] = (double)(i % side) / n;
        vertices[3 * i + 1] = floor((double)i / side) / n;
        vertices[3 * i + 2] = height * ((double)(which >> 11) * 0x1p-52 - 1);
    }
    for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++) {
            const int corners[6] = {0, 1, side + 1, side, side + 1, 0};
            for (int k = 0; k < 6; k++) triangles[count++] = y * side + x + corners[k];
        }
    qn_mesh_def def = sheet_of(vertices, side * side, triangles, 2 * n * n);
    qn_status status = qn_mesh_build(&def, reach, mesh);
    free(vertices), free(triangles);
    return status;
}

static void the_grid_hides_nothing_that_a_sphere_touches(void)
{
    // Against a mesh whose cells list everything that far larger spheres may touch.
    const double heights[3] = {1e-4, 0.01, 0.08};
    for (uint64_t k = 0; k < 3; k++) {
        qn_mesh fine, coarse;
        CHECK_STATUS(build_rough(19, k, heights[k], 0.15, &fine));
        CHECK_STATUS(build_rough(19, k, heights[k], 2, &coarse));
        CHECK(fine.cell < 0.1);
        for (int i = 0; i < 1500; i++) {
            qn_vec3 at =
                qn_v3(sheet_uniform(-0.1, 1.1), sheet_uniform(-0.1, 1.1), sheet_uniform(-0.2, 0.2));
            if (i % 5 == 0) at.x = floor(at.x * 19) / 19;
            qn_mesh_hit a[64], b[64];
            double radius = sheet_uniform(0.02, 0.15);
            int n = qn_mesh_touch(&fine, at, radius, a, 64);
            CHECK(qn_mesh_touch(&coarse, at, radius, b, 64) == n);
            for (int h = 0; h < n && h < 64; h++) CHECK(a[h].feature == b[h].feature);
        }
        qn_mesh_free(&fine), qn_mesh_free(&coarse);
    }
}

static void a_cell_lists_a_few_triangles_however_fine_the_mesh(void)
{
    qn_mesh mesh;
    for (int n = 20; n <= 220; n += 50) {  // from triangles as large as the sphere to 240 under it
        CHECK_STATUS(build_rough(n, 1, 1e-5 / n, 0.05, &mesh));
        int most = 0;
        for (int i = 0; i < 2000; i++) {
            qn_vec3 at = qn_v3(sheet_uniform(0.1, 0.9), sheet_uniform(0.1, 0.9), 0.049);
            int cell = qn_mesh_cell(&mesh, at);
            int listed = mesh.cell_start[cell + 1] - mesh.cell_start[cell];
            most = listed > most ? listed : most;
        }
        CHECK(most < 100);
        qn_mesh_free(&mesh);
    }
}

int main(int argc, char **argv)
{
    TEST(the_grid_hides_nothing_that_a_sphere_touches);
    TEST(a_cell_lists_a_few_triangles_however_fine_the_mesh);
    DONE;
}
