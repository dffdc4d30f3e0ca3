// SPDX-License-Identifier: Apache-2.0
// Parts of qn_mesh_build() that find what is odd about a mesh (mesh.h, QN_MESH_FLAWS).
#ifndef QN_WORLD_MESH_FLAWS_H
#define QN_WORLD_MESH_FLAWS_H

#include "world/mesh.h"

/// Makes each point stand for itself or for the first of those within `tolerance` (m) of it, or of each
/// other in a chain: first[v] <= v. Cost: O(n log n).
QN_NODISCARD qn_status qn_same_places(const qn_vec3 *points, int count, double tolerance,
                                      int *first);

/// Notes a flaw, and where, if it has the lowest number so far.
void qn_mesh_note(qn_mesh *mesh, int kind, int number, qn_vec3 where);

/// Notes borders, seams and crowded edges of a mesh whose edges are known.
QN_NODISCARD qn_status qn_mesh_find_flaws(qn_mesh *mesh);

#endif
