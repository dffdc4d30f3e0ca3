// SPDX-License-Identifier: Apache-2.0
// What is open of the drum's cross-section, lifters taken off on average over a revolution.
//
// The share of each circle about the axis that lies in the open is tabulated once; areas are then
// sums over small pieces.
#ifndef QN_MEASURE_OPEN_H
#define QN_MEASURE_OPEN_H

#include "world/world.h"

enum { QN_OPEN_STEPS = 8192 };  // circles from the axis to the shell

typedef struct qn_open {
    double radius;                // m   of the shell, or of the circle that encloses the profile
    double clear;                 // m   within this distance of the axis all is open
    double share[QN_OPEN_STEPS];  // 1   of the circle in the middle of each step
} qn_open;

void qn_open_build(const qn_walls *walls, qn_open *open);

/// Open area (m2) of the square with lower corner (x, y).
double qn_open_square(const qn_open *open, double x, double y, double side);

/// Open area (m2) between the circle of radius `inner` (m) and the shell.
double qn_open_ring(const qn_open *open, double inner);

/// Largest volume (m3) of which the smallest ball is a whole multiple, `parts` times a power of two
/// at least, that 2^62 of are enough for 2^24 samples of `volume` (m3) filled twice over.
double qn_volume_quantum(const qn_world *world, double volume, int parts);

#endif
