// SPDX-License-Identifier: Apache-2.0
// A lining: spheres side by side along a drum's smooth shell, in rings about its axis.
//
// A ring has as many spheres as go around at the distance R - r from the axis, evenly spaced; the rings
// stand r sqrt(3) apart, every other one turned by half a sphere, as in a hexagonal sheet. R and r
// are the radii of drum and spheres. Where the ends are periodic there is an even number of rings, the
// nearest, so that the sheet goes on through the ends; else the outer rings touch the ends. The
// rings are moved together or apart a little for that.
//
// Source: the reference document, Algorithm 5.2 and Fig 5.16.
#ifndef QN_WORLD_LINING_H
#define QN_WORLD_LINING_H

#include "world/def.h"

/// Spheres in one ring, and rings; either is below its least (3, and 2 or 1) where the spheres are too
/// large for the drum.
typedef struct qn_lining {
    int64_t around, rings;
} qn_lining;

qn_lining qn_lining_of(const qn_drum_def *drum, double diameter);

/// Centre (m) of sphere k of a ring, both from 0.
qn_vec3 qn_lining_centre(const qn_lining *lining, const qn_drum_def *drum, double diameter,
                         int64_t ring, int64_t k);

#endif
