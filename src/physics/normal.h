// SPDX-License-Identifier: Apache-2.0
// What every normal-force model gives back. One model is one file, normal_<name>.h, with
//
//     qn_<name>_normal_pair(sides, pair)     its two coefficients, at set-up
//     qn_<name>_normal(pair, depth, rate)    its force and energy, in the inner loop
//
// depth (m) is the overlap as the model defines it, > 0; rate (m/s) its time derivative, > 0 while
// approaching.
#ifndef QN_PHYSICS_NORMAL_H
#define QN_PHYSICS_NORMAL_H

#include "physics/damping.h"
#include "physics/pair.h"

typedef struct qn_normal {
    double elastic;  // N   spring, >= 0
    double damping;  // N   dashpot, > 0 while approaching
    double energy;   // J   stored in the spring
} qn_normal;

/// Damping ratio of a pair, with or without the clip.
static inline double qn_sides_damping_ratio(const qn_sides *s)
{
    return s->clip ? qn_clipped_damping_ratio(s->restitution) : qn_damping_ratio(s->restitution);
}

#endif
