// SPDX-License-Identifier: Apache-2.0
// Geometry and particles from files: profiles, triangle meshes and lists of spheres.
//
// Every loader reads one local file of at most 2 GB, checks what the file announces against its
// size before it asks for memory, and refuses numbers that are not finite or lie further than
// 1000 km out. What comes back is in SI units and owned by the caller; release it with free(). On
// failure nothing is handed back, and the sentence says file, line, what is wrong, what is allowed.
#ifndef QN_SCENE_LOAD_H
#define QN_SCENE_LOAD_H

#include "base/error.h"

#include <stdint.h>

/// A 2-D profile: two numbers a line, apart by blanks or a comma; # starts a comment. A point equal
/// to the one before it is dropped, and so is a last one equal to the first; at least 3 must remain.
///
/// @param unit   m    length of one unit of the file
/// @param xy     m    2 x count
QN_NODISCARD qn_status qn_load_points(const char *path, double unit, double **xy, int *count);

/// A triangle mesh: .stl (text or binary), .obj and .ply; any other name is the plain text format
///
///     Nv Nt
///     x y z         Nv times
///     i j k         Nt times, numbers of vertices from 1
///
/// whose triangles may wind either way and need not close.
///
/// @param unit       m    length of one unit of the file
/// @param vertices   m    3 x vertex_count
/// @param triangles  1    3 x triangle_count, indices from 0
QN_NODISCARD qn_status qn_load_mesh(const char *path, double unit, double **vertices,
                                    int *vertex_count, int **triangles, int *triangle_count);

/// Spheres as a file gives them; arrays a file says nothing about are NULL.
typedef struct qn_particle_list {
    int64_t count;
    double *position;  // m      3 x count, owned
    double *velocity;  // m/s    3 x count, owned, or NULL
    double *spin;      // rad/s  3 x count, owned, or NULL
    double *diameter;  // m      count, owned, or NULL
} qn_particle_list;

/// Spheres from a file of one of three kinds:
///
///     .csv .txt    a line of column names (x y z; vx vy vz; wx wy wz; diameter or radius; id, which
///                  is passed over), then one sphere a line; commas, semicolons or blanks between
///     .bin .raw    four little-endian doubles a sphere: x y z and 0 for a free sphere; spheres
///                  with 1 there are part of a wall built of spheres and are left out
///     .hdf .h5     a frame or a checkpoint of a run
///
/// @param unit   m    length of one unit of the file, for positions and sizes; velocities are in m/s
///                    and rad/s as they stand. Frames and checkpoints are in metres: 1 for them.
QN_NODISCARD qn_status qn_load_particles(const char *path, double unit, qn_particle_list *list);

/// Releases the arrays and empties the list; accepts an empty one.
void qn_particle_list_free(qn_particle_list *list);

#endif
