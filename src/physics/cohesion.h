// SPDX-License-Identifier: Apache-2.0
// What every model of cohesion gives back. One model is one file, cohesion_<name>.h, with
//
//     qn_<name>_cohesion_pair(sides, pair)     its coefficient, at set-up
//     qn_<name>_cohesion(pair, approach)       its pull, in the inner loop
//
// and one row in laws.h. The pull comes on top of spring and damping, after their clip, and friction goes by
// what presses: the clipped force without the pull.
#ifndef QN_PHYSICS_COHESION_H
#define QN_PHYSICS_COHESION_H

#include "physics/approach.h"

typedef struct qn_cohesion {
    double pull;    // N   towards each other, >= 0
    double energy;  // J   its potential, <= 0 and 0 at no overlap
} qn_cohesion;

#endif
