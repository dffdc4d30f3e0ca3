// SPDX-License-Identifier: Apache-2.0
// The rolling resistance of the reference thesis (its section 4.5), in dimensionally right form.
//
//     M = -mu_r R min(F_el, c |w_t|) w_t / |w_t|,  R = 2 R* between spheres            [N m]
//
// The document prints mu_R min(|F_n|, w), newtons against rad/s and no arm: c is its 1 N s, the default, and
// the radius is put in to make a torque of it, so its mu_R is ours times 1 m/R. Capped like model A.
// Source: the thesis, section 4.5.
// Holds:  while rolling; below F_el / c it is viscous and nothing stands on a slope.
#ifndef QN_PHYSICS_ROLLING_THESIS_H
#define QN_PHYSICS_ROLLING_THESIS_H

#include "physics/rolling.h"

static inline void qn_thesis_rolling_pair(const qn_sides *s, qn_pair *p)
{
    p->rolling_arm = s->rolling_friction * (s->wall ? s->radius[0] : 2 * qn_effective_radius(s));
    p->rolling_damping = s->rolling_slope;
    qn_rolling_cap(s, p);
}

QN_FN qn_rolling qn_thesis_rolling(const qn_pair *p, const qn_approach *a, double elastic)
{
    double force = qn_min(elastic, p->rolling_damping * qn_norm(a->rolling));
    return qn_rolling_against(p, a, p->rolling_arm * force);
}

#endif
