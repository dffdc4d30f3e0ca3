// SPDX-License-Identifier: Apache-2.0
// The ring along the shell: how full it is by angle, hence where shoulder and toe are.
//
// Angles are in degrees from straight down, positive in the sense of rotation, in bins of one
// degree. A sample adds each sphere's volume to the bin of its centre if that lies within one
// lifter height plus two diameters of the largest particle from the shell. Sums are integers.
#ifndef QN_MEASURE_RING_H
#define QN_MEASURE_RING_H

#include "base/column.h"
#include "world/world.h"

enum {
    QN_RING_BINS = 360,
    QN_RING_VISITS = 400,  // balls counted make a solidity that scatters by 1/sqrt(400) = 5 %
};

typedef struct qn_ring {
    double inner_radius;  // m      of the ring; the outer one is the shell's
    double down;          // rad    direction of straight down, from the x axis
    int sense;            // 1      of rotation about z: 1 or -1
    double volume_unit;   // m3     quantum of the sums
    int64_t *weight;      // 1      quanta per ball, by class; owned
    double open_volume;   // m3     of one bin, lifters taken off on average
    int64_t samples;
    int64_t sum[QN_RING_BINS];  // quanta   bin i spans i - 180 to i - 179 degrees
} qn_ring;

QN_NODISCARD qn_status qn_ring_create(const qn_world *world, qn_ring *ring);
void qn_ring_free(qn_ring *ring);

/// Adds the present step.
void qn_ring_sample(qn_ring *ring, const qn_world *world);

/// Middle of a bin (degrees) and its mean solidity (1); NaN before the first sample.
double qn_ring_angle(int bin);
double qn_ring_solidity(const qn_ring *ring, int bin);

/// Where the ring's solidity, averaged over five bins, falls to half of `bulk`, looking from the
/// angle of its mass centre forwards (shoulder) and backwards (toe); degrees, linear between bins.
/// NaN where it never does or never was above.
void qn_ring_edges(const qn_ring *ring, double bulk, double *shoulder, double *toe);

/// Samples after which the edges scatter little by chance: until QN_RING_VISITS of the largest balls
/// have been counted in the five bins of an edge.
int64_t qn_ring_least_samples(const qn_ring *ring, const qn_world *world);

/// What must survive a checkpoint; as qn_measure_columns().
int qn_ring_columns(qn_ring *ring, qn_column *columns, int room);

#endif
