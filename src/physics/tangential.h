// SPDX-License-Identifier: Apache-2.0
// What every tangential model is given and gives back, and the steps they share.
//
// One model is one file, tangential_<name>.h, with
//
//     qn_<name>_tangential_pair(sides, pair)                 its two coefficients, at set-up
//     qn_<name>_tangential(pair, depth, limit, held, slip, slide)  its force, in the inner loop
//
// held (m) is the tangential displacement of side a against side b kept from the step before, turned
// into the present contact plane; slip (m) the same advanced by this step; slide (m/s) its rate;
// limit (N) the Coulomb limit.
#ifndef QN_PHYSICS_TANGENTIAL_H
#define QN_PHYSICS_TANGENTIAL_H

#include "physics/pair.h"
#include "physics/vec3.h"

typedef struct qn_tangential {
    qn_vec3 force;        // N   on side a
    qn_vec3 slip;         // m   displacement kept for the next step
    double energy;        // J   stored in the spring
    double lost_dashpot;  // J   during this step
    double lost_sliding;  // J   during this step
} qn_tangential;

/// The displacement carried into the new contact plane with its length kept, and turned about the
/// normal by `twist` (rad), the rotation the two sides share.
/// Source: Luding (2008), Granular Matter 10, 235, doi:10.1007/s10035-008-0099-x, eq. 17.
QN_FN qn_vec3 qn_slip_turned(qn_vec3 slip, qn_vec3 normal, double twist)
{
    qn_vec3 flat = qn_madd(slip, -qn_dot(slip, normal), normal);
    qn_vec3 turned = qn_madd(flat, twist, qn_cross(normal, flat));
    double before = qn_dot(slip, slip), after = qn_dot(turned, turned);
    double stretch = sqrt(before / (after > 0 ? after : 1));
    return qn_scale(stretch, turned);
}

/// A spring of stiffness k and a dashpot c in parallel, in series with a Coulomb slider. While the
/// slider moves the force is the limit and the spring keeps its stretch, cut to what the limit holds:
/// the dashpot then moves only as fast as the slider lets it, and nothing is pushed the wrong way (as
/// happens where the spring is set to the limit less c times the full sliding speed). What sliding
/// loses is the work done against the force less what the spring has gained since the last step.
QN_FN qn_tangential qn_slider(double k, double c, double limit, qn_vec3 held, qn_vec3 slip,
                              qn_vec3 slide, double dt)
{
    qn_vec3 trial = qn_madd(qn_scale(-k, slip), -c, slide);
    double size = qn_norm(trial), stretch = k * qn_norm(slip);
    bool slides = size > limit;
    double share = slides ? limit / size : 1;
    double kept = slides && stretch > limit ? limit / stretch : 1;
    qn_tangential t;
    t.force = qn_scale(share, trial);
    t.slip = qn_scale(kept, slip);
    t.energy = 0.5 * k * qn_dot(t.slip, t.slip);
    double lost = 0.5 * k * qn_dot(held, held) - t.energy - qn_dot(t.force, slide) * dt;
    t.lost_dashpot = slides ? 0 : c * qn_dot(slide, slide) * dt;
    t.lost_sliding = slides ? lost : 0;
    return t;
}

#endif
