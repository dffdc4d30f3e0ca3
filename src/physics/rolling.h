// SPDX-License-Identifier: Apache-2.0
// What every model of rolling resistance is given and gives back. One model is one file,
// rolling_<name>.h, with
//
//     qn_<name>_rolling_pair(sides, pair)             its coefficients, at set-up
//     qn_<name>_rolling(pair, approach, elastic)      its torque, in the inner loop
//
// and one row in laws.h, which also says whether it keeps a moment from step to step. elastic (N) is
// the spring's part of the normal force.
//
// A torque that only opposes the present rolling is capped at a sixteenth of what would stop it within
// one step: a ball has up to twelve contacts, and together they must not turn its spin round, or a
// bed at rest chatters for ever.
#ifndef QN_PHYSICS_ROLLING_H
#define QN_PHYSICS_ROLLING_H

#include "physics/approach.h"

typedef struct qn_rolling {
    qn_vec3 torque;  // N m  on side a; -it on side b
    qn_vec3 kept;    // N m  moment of the spring, for the next step
} qn_rolling;

/// Sets the cap, qn_pair.rolling_limit: from the inertia of solid spheres, 2/5 m R^2.
static inline void qn_rolling_cap(const qn_sides *s, qn_pair *p)
{
    double inverse_inertia = 0;  // 1/(kg m2)
    for (int i = 0; i < 2; i++)
        if (!s->fixed[i]) inverse_inertia += 1 / (0.4 * s->mass[i] * s->radius[i] * s->radius[i]);
    p->rolling_limit = inverse_inertia > 0 ? 1 / (16 * inverse_inertia * s->dt) : 0;
}

/// A torque of this size (N m) against the rolling of now, capped.
QN_FN qn_rolling qn_rolling_against(const qn_pair *p, const qn_approach *a, double size)
{
    double rate = qn_norm(a->rolling);
    double torque = qn_min(size, p->rolling_limit * rate);
    qn_rolling r;
    r.torque = qn_scale(-torque / (rate > 0 ? rate : 1), a->rolling);
    r.kept = qn_v3(0, 0, 0);
    return r;
}

#endif
