// SPDX-License-Identifier: Apache-2.0
// What every tangential model is given and gives back, and the slider they share.
//
// One model is one file, tangential_<name>.h, with
//
//     qn_<name>_tangential_pair(sides, pair)          its coefficients, at set-up, after the spring's
//     qn_<name>_tangential(pair, approach, limit)     its force, in the inner loop
//
// and one row in laws.h. limit (N) is Coulomb's: mu times the normal force.
#ifndef QN_PHYSICS_TANGENTIAL_H
#define QN_PHYSICS_TANGENTIAL_H

#include "physics/approach.h"
#include "physics/damping.h"

typedef struct qn_tangential {
    qn_vec3 force;        // N   on side a
    qn_vec3 slip;         // m   displacement kept for the next step
    double energy;        // J   stored in the spring
    double lost_dashpot;  // J   during this step
    double lost_sliding;  // J   during this step
    double residue;       // J   lost in this step because the spring's stiffness changes
} qn_tangential;

/// A spring of stiffness k and a dashpot c in parallel, in series with a Coulomb slider. While the
/// slider moves the force is the limit and the spring keeps its stretch, cut to what the limit holds:
/// the dashpot then moves only as fast as the slider lets it, and nothing is pushed the wrong way (as
/// happens where the spring is set to the limit less c times the full sliding speed). What sliding
/// loses is the work done against the force less what the spring has gained since the last step.
/// held: m, the displacement of the step before in the present contact plane.
QN_FN qn_tangential qn_slider(double k, double c, double limit, qn_vec3 held, const qn_approach *a,
                              double dt)
{
    qn_vec3 slip = qn_add(held, a->advance);
    qn_vec3 trial = qn_madd(qn_scale(-k, slip), -c, a->slide);
    double size = qn_norm(trial), stretch = k * qn_norm(slip);
    bool slides = size > limit;
    double share = slides ? limit / size : 1;
    double kept = slides && stretch > limit ? limit / stretch : 1;
    qn_tangential t;
    t.force = qn_scale(share, trial);
    t.slip = qn_scale(kept, slip);
    t.energy = 0.5 * k * qn_dot(t.slip, t.slip);
    double lost = 0.5 * k * qn_dot(held, held) - t.energy - qn_dot(t.force, a->slide) * dt;
    t.lost_dashpot = slides ? 0 : c * qn_dot(a->slide, a->slide) * dt;
    t.lost_sliding = slides ? lost : 0;
    t.residue = 0;
    return t;
}

/// A dashpot c in series with a Coulomb slider: nothing is kept.
QN_FN qn_tangential qn_drag(double c, double limit, const qn_approach *a, double dt)
{
    double speed2 = qn_dot(a->slide, a->slide);
    double size = c * sqrt(speed2);
    bool slides = size > limit;
    double share = slides ? limit / size : 1;
    double lost = share * c * speed2 * dt;
    qn_tangential t;
    t.force = qn_scale(-share * c, a->slide);
    t.slip = qn_v3(0, 0, 0);
    t.energy = 0;
    t.lost_dashpot = slides ? 0 : lost;
    t.lost_sliding = slides ? lost : 0;
    t.residue = 0;
    return t;
}

#endif
