// SPDX-License-Identifier: Apache-2.0
// Walls: the drum's profile, its ends, planes and triangle meshes, and how they move.
//
// Every wall is rigid and belongs to a body: the one at rest, the drum, or one with a drive of its
// own (drive.h). A wall is searched in its body's own frame, where its grid is built once; a particle
// is brought into it. A feature is the smallest thing a particle can touch (a face, an edge, a corner);
// exactly one feature of a smooth stretch of wall touches at a time (profile.h, mesh.h), so a joint is
// never felt. A surface is a material and a curvature, and picks the contact coefficients; a part is
// what forces, torque and work are told apart by; a facet (a stretch of the profile, an end, a plane, a
// triangle) is what wear is told apart by.
//
// Features are numbered in one range: the profile's elements and corners, both ends, planes, meshes.
// Parts: shell and lifter_01, lifter_02, ... (or profile), end_low and end_high, planes and meshes
// by their names, then groups of spheres that turn with the drum. Drum, ends and planes act on the side where particles belong, meshes on both.
#ifndef QN_WORLD_WALLS_H
#define QN_WORLD_WALLS_H

#include "physics/vec3.h"
#include "world/def.h"
#include "world/drive.h"
#include "world/mesh.h"
#include "world/profile.h"

/// What particles feel of a wall: material and curvature.
typedef struct qn_surface {
    int material;
    double radius;  // m   of curvature: INFINITY where flat, minus the drum's radius on its shell
} qn_surface;

typedef struct qn_part {
    char name[QN_NAME_MAX + 16];
    int body;
    bool turning;  // with the drum
} qn_part;

enum { QN_BODIES_MAX = 64 };  // most bodies: rest, drum, and walls with a drive of their own

/// One touch of a particle and a wall, as the search finds it.
typedef struct qn_wall_hit {
    int32_t feature;
    int32_t surface, part;
    int32_t facet;  //     the facet it is, or the first of those that meet there
    int32_t body;
    qn_vec3 point;  // m   nearest point of the wall, in the lab frame
    // 1, m   the share of its force that acts, and how far the point lies beyond the wall's end: 1 and 0 but
    // where corners are shared (profile.h)
    double share, beyond;
} qn_wall_hit;

typedef struct qn_walls {
    bool has_drum, has_profile_file;
    qn_drum_def drum;    //     legs and sizes; its arrays are not owned here
    qn_profile profile;  //     the drum's cross-section, in its own frame; owned
    int plane_count, mesh_count;
    qn_plane_def *planes;  //     owned
    qn_mesh *meshes;       //     owned
    int surface_count, part_count, facet_count;
    qn_surface *surfaces;             //     owned
    qn_part *parts;                   //     owned
    int shell_surface, flat_surface;  //  of the profile's circular and straight elements
    int end_surface, end_part[2];
    int plane_surface, plane_part;  //     of plane 0; the others follow, then the meshes
    int group_part;                 //     of the first group of spheres that turns with the drum
    int32_t end_feature, plane_feature;  //  first feature number of each kind
    int32_t end_facet, plane_facet;      //  likewise; the profile's are its elements
    int body_count, drum_body;           //  -1 without a drum; body 0 never moves
    qn_drive_def drives[QN_BODIES_MAX];
} qn_walls;

/// Builds the walls of a definition for particles up to `largest_radius` (m). Takes over its planes
/// and meshes. QN_INPUT where a wall makes no sense.
QN_NODISCARD qn_status qn_walls_build(qn_def *def, double largest_radius, qn_walls *walls);

void qn_walls_free(qn_walls *walls);

/// Total angle (rad) and speed (rad/s) of the drum at time t (s), in closed form from its legs.
double qn_drum_angle(const qn_drum_def *drum, double t);
double qn_drum_speed(const qn_drum_def *drum, double t);

/// Sense of rotation (+1, -1): that of the last speed that is not zero.
double qn_drum_sense(const qn_drum_def *drum);

/// The time (s) at which the drum has turned by `angle` (rad, >= 0 in the sense of its final speed);
/// INFINITY if it never does.
double qn_drum_time(const qn_drum_def *drum, double angle);

/// What a wall search needs to know of the moment: the frame of each body.
typedef struct qn_pose {
    qn_frame frames[QN_BODIES_MAX];
} qn_pose;

qn_pose qn_walls_pose(const qn_walls *walls, double t);
qn_frame qn_walls_frame(const qn_walls *walls, int body, double t);

/// All touches of a sphere at `centre` with `radius` (both m); at most `room`, in order of feature.
/// Returns how many there are, also when more than `room`.
int qn_walls_touch(const qn_walls *walls, const qn_pose *pose, qn_vec3 centre, double radius,
                   qn_wall_hit *hits, int room);

/// Whether a centre is where no particle can be: outside the drum, or inside a lifter.
bool qn_walls_outside(const qn_walls *walls, const qn_pose *pose, qn_vec3 centre);

/// Clear distance (m) from `centre` to the nearest wall, negative outside; for packing. Meshes count
/// where they are nearer than 12 largest radii.
double qn_walls_clearance(const qn_walls *walls, const qn_pose *pose, qn_vec3 centre);

/// Share of the circle of radius rho (m) about the drum's axis that lies in the open, 0 to 1: what is
/// open there on average over one revolution.
double qn_walls_open_share(const qn_walls *walls, double rho);

/// Volume (m3) inside the drum, lifters taken off; 0 without a drum.
double qn_walls_volume(const qn_walls *walls);

#endif
