// SPDX-License-Identifier: Apache-2.0
// Voxel fields: what is where in the drum on average, and how it moves.
//
// A grid of voxels covers the drum's cross-section, symmetric about the axis, in layers along it. A
// sample adds every particle to the voxel of its centre, and its volume to the voxels it extends
// over: QN_BALL_POINTS points of equal weight inside each ball, so that solidity is right at the rim
// too. A clump counts once, where its centre is; its volume is spread over its spheres in proportion
// to theirs. Sums are integers, so they do not depend on order or threads. What is open of a voxel is
// computed from the walls: inside the drum, lifters taken off on average over a revolution.
#ifndef QN_MEASURE_FIELDS_H
#define QN_MEASURE_FIELDS_H

#include "base/array.h"
#include "base/column.h"
#include "world/world.h"

enum {
    QN_BALL_POINTS = 56,  // points that stand for a ball's volume
};

#define QN_SPEED_QUANTUM 0x1p-32  // m/s, and m2/s2 for squares: quantum of the sums
#define QN_OPEN_LEAST 0.02        // 1   open share of a voxel below which it tells nothing

// clang-format off
//    name                   unit      meaning
#define QN_FIELD_SUMS(F)                                                                          \
    F(count,                 "1",      "centres in the voxel, summed over samples")               \
    F(centre_volume,         "m3",     "volume of the particles whose centres these are")             \
    F(solid_volume,          "m3",     "solid volume inside the voxel, summed over samples")      \
    F(velocity_sum_x,        "m/s",    "velocities of the centres, along x")                      \
    F(velocity_sum_y,        "m/s",    "along y")                                                 \
    F(velocity_sum_z,        "m/s",    "along z")                                                 \
    F(speed_sum,             "m/s",    "their speeds")                                            \
    F(velocity_square_sum_x, "m2/s2",  "squares of the velocities, along x")                      \
    F(velocity_square_sum_y, "m2/s2",  "along y")                                                 \
    F(velocity_square_sum_z, "m2/s2",  "along z")
//    name                   unit      meaning; not a number where outside or empty
#define QN_FIELD_MEANS(F)                                                                         \
    F(solidity,              "1",      "solid volume in the open volume")                         \
    F(porosity,              "1",      "what is left of the open volume")                         \
    F(solidity_raw,          "1",      "volume of the particles centred in the voxel by its whole volume") \
    F(velocity_x,            "m/s",    "mean velocity of the centres, along x")                   \
    F(velocity_y,            "m/s",    "along y")                                                 \
    F(velocity_z,            "m/s",    "along z")                                                 \
    F(speed,                 "m/s",    "mean speed")                                              \
    F(granular_temperature,  "m2/s2",  "a third of the variance of the velocity")
// clang-format on

typedef enum qn_field_sum {
#define F(name, unit, meaning) QN_FIELD_##name,
    QN_FIELD_SUMS(F)
#undef F
        QN_FIELD_SUM_COUNT,
    QN_FIELD_COLUMN_COUNT = QN_FIELD_SUM_COUNT + 4,
} qn_field_sum;

typedef struct qn_field {
    double cell;                       //     side as asked for, in radii of the largest particle
    int nx, ny, nz;                    // 1
    double side, layer;                // m   of a voxel, in x and y; in z
    double x0, y0, z0;                 // m   lower corner of the grid
    double radius, length;             // m   of the drum
    double volume_unit;                // m3  quantum of the volume sums
    int64_t *ball_weight;              // 1   quanta per ball point, by class; owned
    double *open_volume;               // m3  by voxel; owned
    int64_t *sum[QN_FIELD_SUM_COUNT];  //  in quanta, by voxel: [(iz ny + iy) nx + ix]; owned
    int64_t samples, first_step, last_step;  //  how many there are, the first and the latest
    int64_t crowd;                           // 1   centres a voxel can hold at most
    double filled;                           // 1   how much of the sums' range may be used, at most
} qn_field;

/// What a voxel says after its samples, in the units of QN_FIELD_MEANS.
typedef struct qn_voxel {
#define F(name, unit, meaning) double name;
    QN_FIELD_MEANS(F)
#undef F
} qn_voxel;

/// Lays out a grid for a world with a drum: voxels of `cell` radii of the largest particle, `layers`
/// along the axis. QN_INPUT where it would be too large to number.
QN_NODISCARD qn_status qn_field_create(const qn_world *world, double cell, int layers,
                                       qn_field *field);
void qn_field_free(qn_field *field);

/// Adds the present step. QN_UNSTABLE, with nothing added, once the sums could overflow.
QN_NODISCARD qn_status qn_field_sample(qn_field *field, const qn_world *world);

static inline int64_t qn_field_voxel_count(const qn_field *field)
{
    return (int64_t)field->nx * field->ny * field->nz;
}

/// Size of one quantum of a sum, in its unit.
double qn_field_unit(const qn_field *field, qn_field_sum sum);

/// Means of one voxel.
qn_voxel qn_field_voxel(const qn_field *field, int64_t voxel);

/// Median solidity (1) over the voxels above 0.4 that lie wholly inside the shell; NaN if there are
/// none. Returns QN_MEMORY if it can't sort.
QN_NODISCARD qn_status qn_field_bulk_solidity(const qn_field *field, double *bulk);

/// What of a field must survive a checkpoint; as qn_measure_columns().
int qn_field_columns(qn_field *field, qn_column *columns, int room);

#endif
