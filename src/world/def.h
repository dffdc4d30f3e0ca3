// SPDX-License-Identifier: Apache-2.0
// The definition of a world: what a person asked for, checked, complete and in SI units.
//
// A scene file is read into one of these (scene/), a test can fill one by hand, and
// qn_world_create() builds the world from it. Plain data: it knows no file and no solver. Arrays are
// owned by the definition and released by qn_def_free().
#ifndef QN_WORLD_DEF_H
#define QN_WORLD_DEF_H

#include "base/error.h"
#include "physics/laws.h"
#include "physics/scheme.h"
#include "physics/vec3.h"
#include "world/shape.h"

enum {
    QN_NAME_MAX = 48,     // longest name of a material, group or wall, with its final zero
    QN_PATH_MAX = 1024,   // longest file name
    QN_SIZES_MAX = 64,    // sizes in one group of particles
    QN_LEGS_MAX = 32,     // legs of a drum's speed schedule
    QN_GRIDS_MAX = 8,     // voxel grids
    QN_TRACED_MAX = 256,  // traced particles
};

/// A time, written as seconds, as revolutions of the drum or as steps. Revolutions count from the
/// start of the run; qn_span_steps() (measure/measure.h) turns one into steps.
typedef enum qn_span_unit { QN_SECONDS, QN_REVOLUTIONS, QN_STEPS } qn_span_unit;
typedef struct qn_span {
    double value;
    qn_span_unit unit;
} qn_span;

typedef struct qn_material_def {
    char name[QN_NAME_MAX];
    double youngs_modulus;  // Pa      always set; from the shear modulus where that was given
    double poisson_ratio;   // 1
    double density;         // kg/m3
} qn_material_def;

/// The law between two materials, in either order.
typedef struct qn_contact_def {
    int material_a, material_b;
    qn_law law;
    bool clip;  // no attraction before separation
#define C(name, unit, used, with) double name;
    QN_CONTACT_NUMBERS(C)  // physics/pair.h
#undef C
} qn_contact_def;

/// One leg of a speed schedule: the speed goes linearly from `from` to `to` within `duration`.
typedef struct qn_leg {
    double duration;  // s             INFINITY for the last
    double from, to;  // rad/s, m/s    rad/s by the right-hand rule; of a drum about +z
} qn_leg;

// clang-format off
//    NAME        text          meaning
#define QN_DRIVES(D)                                                     \
    D(REST,       "rest",       "never moves")                           \
    D(DRUM,       "drum",       "turns with the drum")                   \
    D(ROTATE,     "rotate",     "turns about an axis, at a speed")       \
    D(SWING,      "swing",      "turns about an axis, to and fro")       \
    D(TRANSLATE,  "translate",  "moves along a direction, at a speed")   \
    D(OSCILLATE,  "oscillate",  "moves along a direction, to and fro")
// clang-format on

typedef enum qn_drive {
#define D(NAME, text, meaning) QN_DRIVE_##NAME,
    QN_DRIVES(D)
#undef D
} qn_drive;

/// How a wall moves, from where it is defined. The angle (rad) or path (m) after a time t is the integral
/// of the legs' speed, or, to and fro, amplitude (sin(2 pi frequency (t - start) + phase) - sin phase)
/// from `start` on.
typedef struct qn_drive_def {
    qn_drive kind;
    qn_vec3 axis;      // 1        unit vector: the axis turned about, or the direction
    qn_vec3 through;   // m        a point on the axis turned about
    double amplitude;  // rad, m
    double frequency;  // Hz
    double phase;      // rad
    double start;      // s
    int leg_count;
    qn_leg legs[QN_LEGS_MAX];
} qn_drive_def;

typedef enum qn_ends { QN_ENDS_PERIODIC, QN_ENDS_FIXED, QN_ENDS_TURNING } qn_ends;

/// How the drum's profile is felt where two stretches meet: by exactly one owner, or by both, each with a
/// share of its force (physics/sharing.h).
typedef enum qn_corners { QN_CORNERS_EXACT, QN_CORNERS_SHARED } qn_corners;

/// A drum about the z axis, from z = 0 to z = length; it turns about its axis.
typedef struct qn_drum_def {
    bool present;
    char name[QN_NAME_MAX];
    double diameter, length;  // m      inside the shell
    qn_ends ends;
    qn_corners corners;
    int material, end_material;                     //        indices of materials
    int lifter_count;                               // 1      0 for a smooth shell
    double lifter_height, lifter_top, lifter_base;  // m
    int profile_count;  // 1      points of a profile that replaces shell and lifters; else 0
    double *profile;    // m      2 x profile_count, owned; closed, inside to its left or right
    int leg_count;
    qn_leg legs[QN_LEGS_MAX];
} qn_drum_def;

/// An infinite plane; particles live on the side its normal points to.
typedef struct qn_plane_def {
    char name[QN_NAME_MAX];
    int material;
    qn_vec3 point, normal;  // m, 1   unit normal
    qn_drive_def drive;
} qn_plane_def;

/// A triangle surface; it acts on both sides.
typedef struct qn_mesh_def {
    char name[QN_NAME_MAX];
    int material;
    int vertex_count, triangle_count;
    double *vertices;  // m   3 x vertex_count, owned
    int *triangles;    // 1   3 x triangle_count, indices from 0, owned
    qn_drive_def drive;
} qn_mesh_def;

typedef enum qn_amount { QN_AMOUNT_COUNT, QN_AMOUNT_FILLING, QN_AMOUNT_MASS } qn_amount;
typedef enum qn_packing { QN_PACK_HCP, QN_PACK_GRID, QN_PACK_LIST, QN_PACK_FEED } qn_packing;

/// A group of particles of one material, in one or more sizes; each size is a class.
typedef struct qn_group_def {
    char name[QN_NAME_MAX];
    int material;
    int shape;                      //        1 + the index of a clump's shape; 0 for balls
    bool fixed;                     //        never moves, whatever touches it
    bool turning;                   //        moves with the drum, whatever touches it
    bool lining;                    //        its list is a lining (lining.h)
    int size_count;                 // 1      at least 1
    double diameter[QN_SIZES_MAX];  // m      of a clump: of the sphere of equal volume
    double fraction[QN_SIZES_MAX];  // 1      by number, adding up to 1
    qn_packing packing;
    qn_amount amount_kind;
    double amount;           // 1 | fraction of the drum's volume as a bed | kg
    double padding;          // 1      share of the radius left free around each particle
    double jitter;           // 1      share of that padding used for random displacement
    int list_count;          // 1      QN_PACK_LIST: the centres and, where given, sizes
    double *list_position;   // m      3 x list_count, owned
    double *list_velocity;   // m/s    3 x list_count, owned, or NULL for `velocity`
    double *list_spin;       // rad/s  3 x list_count, owned, or NULL for `spin`
    int *list_size;          // 1      index into diameter[], owned, or NULL for all 0
    qn_vec3 velocity, spin;  // m/s, rad/s   of every particle at the start
    bool turned_at_random;   //        clumps: the orientation at the start, else
    qn_vec3 turned;          // rad    turned by this rotation vector from how the shape was given
} qn_group_def;

/// Particles of a group that enter while running, on places of a region that are free.
typedef struct qn_feed_def {
    char name[QN_NAME_MAX];
    int group;           //        their sizes and material
    bool by_mass;        //        rate in kg/s, else in 1/s
    double rate;         // kg/s | 1/s
    double start, stop;  // s      INFINITY for no stop
    bool is_disc;        //        centre, radius and normal, else low and high
    qn_vec3 low, high;   // m      a box
    qn_vec3 centre, normal;
    double radius;     // m
    qn_vec3 velocity;  // m/s
} qn_feed_def;

/// Where particles leave: a box, or a plane that is passed in the direction of its normal.
typedef struct qn_outlet_def {
    char name[QN_NAME_MAX];
    bool is_box;            //     low and high, else point and normal
    qn_vec3 low, high;      // m
    qn_vec3 point, normal;  // m, 1
    double radius;  // m   of the part of the plane that is open, about point; INFINITY for all
    double
        aperture;  // m   only what is smaller, as soon as it touches the plane; INFINITY for no screen
} qn_outlet_def;

/// What is observed while running.
typedef struct qn_measure_def {
    qn_span series_every;  // between rows of the time series
    qn_span fields_every;  // between samples of the voxel fields
    qn_span fields_start, fields_duration;
    int grid_count;                  // 1   voxel grids; 0 for none
    double grid_cell[QN_GRIDS_MAX];  // 1   voxel side in x and y, in radii of the largest particle
    int grid_layers[QN_GRIDS_MAX];   // 1   voxels along the axis
    int traced_count;
    int64_t traced[QN_TRACED_MAX];  // ids
    qn_span traces_every;
} qn_measure_def;

typedef struct qn_output_def {
    char directory[QN_PATH_MAX];
    qn_span frames_every;     //     0 for none
    double checkpoint_every;  // s   of wall time
    int checkpoint_keep;      // 1
    bool pictures;
} qn_output_def;

typedef struct qn_def {
    char title[256];
    qn_vec3 gravity;  // m/s2
    uint64_t seed;
    qn_span end;               //      of the run, from its start
    double step;               // s    0 for automatic
    double rayleigh_fraction;  // 1    of the automatic step
    qn_scheme scheme;          //      of the time integration
    double skin;          // 1    Verlet skin in radii of the smallest particle; 0 for automatic
    double bed_solidity;  // 1    solid share of a bed at rest, for `filling`
    int material_count, contact_count, plane_count, mesh_count, group_count, shape_count;
    int feed_count, outlet_count;
    qn_material_def *materials;  //      these eight owned
    qn_contact_def *contacts;
    qn_plane_def *planes;
    qn_mesh_def *meshes;
    qn_group_def *groups;
    qn_shape *shapes;
    qn_feed_def *feeds;
    qn_outlet_def *outlets;
    qn_drum_def drum;
    qn_measure_def measure;
    qn_output_def output;
} qn_def;

/// An empty definition with every default set: no material, no wall, no particle.
qn_def qn_def_default(void);

/// Releases what the definition owns and empties it; accepts a definition already empty.
void qn_def_free(qn_def *def);

/// The contact law between two materials in either order, or NULL.
const qn_contact_def *qn_def_contact(const qn_def *def, int material_a, int material_b);

#endif
