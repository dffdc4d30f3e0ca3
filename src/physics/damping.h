// SPDX-License-Identifier: Apache-2.0
// What every damping model is given and gives back. One model is one file, damping_<name>.h, with
//
//     qn_<name>_damping_pair(sides, pair)             its coefficient, at set-up, after the spring's
//     qn_<name>_damping(pair, approach, elastic)      its force (N), > 0 while approaching
//
// and one row in laws.h, which also names the springs it goes with.
#ifndef QN_PHYSICS_DAMPING_H
#define QN_PHYSICS_DAMPING_H

#include "physics/approach.h"
#include "physics/restitution.h"

/// Damping ratio of a pair, with or without the clip.
static inline double qn_sides_damping_ratio(const qn_sides *s)
{
    return s->clip ? qn_clipped_damping_ratio(s->restitution) : qn_damping_ratio(s->restitution);
}

#endif
