// SPDX-License-Identifier: Apache-2.0
// Stands in for load_assimp.c in a build without assimp: says that such meshes can't be read.
#include "scene/load_datafile.h"

qn_status qn_load_mesh_library(const char *path, double unit, double **vertices, int *vertex_count,
                               int **triangles, int *triangle_count)
{
    (void)unit, (void)vertices, (void)vertex_count, (void)triangles, (void)triangle_count;
    return qn_fail(QN_INPUT,
                   "%s: this program was built without assimp, which reads STL, OBJ and PLY; "
                   "the text format of meshes works without",
                   path);
}
