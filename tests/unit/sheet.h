// SPDX-License-Identifier: Apache-2.0
// What the tests of meshes share: sheets of triangles, random places, distances.
#ifndef QN_TESTS_SHEET_H
#define QN_TESTS_SHEET_H

#include "world/mesh.h"

enum { SHEET_ROOM = 16 };  // hits a test makes room for

static inline double sheet_uniform(double low, double high)
{
    static uint64_t seed = 1;
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

static inline qn_mesh_def sheet_of(double *vertices, int vertex_count, int *triangles,
                                   int triangle_count)
{
    return (qn_mesh_def){.name = "sheet",
                         .vertex_count = vertex_count,
                         .triangle_count = triangle_count,
                         .vertices = vertices,
                         .triangles = triangles};
}

static inline double sheet_distance(qn_vec3 a, qn_vec3 b)
{
    return qn_norm(qn_sub(a, b));
}

#endif
