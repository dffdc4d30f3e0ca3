// SPDX-License-Identifier: Apache-2.0
// What tests of contact laws share: a ball and a wall, contacts of them, every law that makes sense.
#ifndef QN_TESTS_LAWS_H
#define QN_TESTS_LAWS_H

#include "physics/contact.h"

#include <stdio.h>

static const double ball_radius = 0.0015;                                           // m
static const double ball_mass = 4.0 / 3 * QN_PI * 0.0015 * 0.0015 * 0.0015 * 2500;  // kg
static const qn_reach wall_reach = {0.0015, 0.0015, 0, 1, 0};
static const qn_reach pair_reach = {0.003, 0.0015, 0.0015, 0.5, 0.5};

/// Two 3 mm glass balls, softened.
static inline qn_sides two_balls(double restitution, bool clip)
{
    return (qn_sides){.young = {64e6, 64e6},
                      .poisson = {0.23, 0.23},
                      .radius = {ball_radius, ball_radius},
                      .mass = {ball_mass, ball_mass},
                      .clip = clip,
                      .dt = 1e-7,
                      .friction = 0.3,
                      .restitution = restitution,
                      .stiffness = 1e4,
                      .impact_speed = 1,
                      .surface_energy = 0.05,
                      .tangential_ratio = 2.0 / 7,
                      .tangential_damping = 0.01,
                      .rolling_friction = 0.02,
                      .rolling_viscosity = 0.1,
                      .rolling_damping = 0.3,
                      .rolling_slope = 1};
}

/// A ball against a flat wall of the same.
static inline qn_sides ball_and_wall(double restitution, bool clip)
{
    qn_sides s = two_balls(restitution, clip);
    s.radius[1] = s.mass[1] = INFINITY;
    s.fixed[1] = s.wall = true;
    return s;
}

/// A ball pressed `depth` (m) into a wall below it, still but for `rate` (m/s) inwards.
static inline qn_touch pressed(double depth, double rate)
{
    qn_touch t = {0};
    t.between = qn_v3(0, ball_radius - depth, 0);
    t.velocity = qn_v3(0, -rate, 0);
    return t;
}

/// The k-th law that makes sense, in *law; false after the last.
static inline bool sensible_law(int k, qn_law *law)
{
    const int dampings = QN_DAMPING_COUNT, cohesions = QN_COHESION_COUNT;
    const int tangentials = QN_TANGENTIAL_COUNT, rollings = QN_ROLLING_COUNT;
    for (int all = 0; all < QN_NORMAL_COUNT * dampings * cohesions * tangentials * rollings;
         all++) {
        int rest = all / rollings, next = rest / tangentials;
        *law = (qn_law){
            (qn_normal_model)(next / cohesions / dampings),
            (qn_damping_model)(next / cohesions % dampings), (qn_cohesion_model)(next % cohesions),
            (qn_tangential_model)(rest % tangentials), (qn_rolling_model)(all % rollings)};
        bool fits = qn_damping_fits(*law) && qn_cohesion_fits(*law) && qn_tangential_fits(*law);
        if (fits && k-- == 0) return true;
    }
    return false;
}

/// Names a law on stdout, beside a check that failed.
static inline void name_law(qn_law law)
{
    printf("  normal %d, damping %d, cohesion %d, tangential %d, rolling %d\n", law.normal,
           law.damping, law.cohesion, law.tangential, law.rolling);
}

#endif
