// SPDX-License-Identifier: Apache-2.0
// What two touching classes share: the coefficients a contact law reads, computed once at set-up.
//
// A law turns the two sides of a contact (qn_sides: elasticity, radius, mass, what the scene says
// of the pair) into these few numbers; the inner loop then needs no material, radius or mass.
#ifndef QN_PHYSICS_PAIR_H
#define QN_PHYSICS_PAIR_H

#include "physics/real.h"

// The numbers a scene gives a pair of materials, beside its law. A condition on `law` says whether a law
// needs it, in words behind; what each means is its row in scene/keys.h and in its model's file.
// clang-format off
//    name                unit     goes with
#define QN_CONTACT_NUMBERS(C)                                                                            \
    C(friction,           "1",     law.tangential != QN_TANGENTIAL_NONE,                         "a tangential model")          \
    C(restitution,        "1",     law.damping != QN_DAMPING_NONE,                               "a damping model")             \
    C(stiffness,          "N/m",   law.normal == QN_NORMAL_LINEAR,                               "normal linear")               \
    C(impact_speed,       "m/s",   law.normal == QN_NORMAL_LINEAR || law.damping == QN_DAMPING_HUNT_CROSSLEY, "normal linear and damping hunt-crossley") \
    C(surface_energy,     "J/m2",  law.cohesion == QN_COHESION_DMT,                              "cohesion dmt")                \
    C(tangential_ratio,   "1",     law.tangential == QN_TANGENTIAL_LINEAR,                       "tangential linear")           \
    C(tangential_damping, "N s/m", law.tangential == QN_TANGENTIAL_VISCOUS,                      "tangential viscous")          \
    C(rolling_friction,   "1",     law.rolling != QN_ROLLING_NONE && law.rolling != QN_ROLLING_VISCOUS, "rolling constant, epsd and thesis") \
    C(rolling_viscosity,  "s/m",   law.rolling == QN_ROLLING_VISCOUS,                            "rolling viscous")             \
    C(rolling_damping,    "1",     law.rolling == QN_ROLLING_EPSD,                               "rolling epsd")                \
    C(rolling_slope,      "N s",   law.rolling == QN_ROLLING_THESIS,                             "rolling thesis")
// clang-format on

/// Both sides of a contact before it happens. A wall has infinite mass, and infinite radius where
/// it is flat; where it is curved its radius is negative seen from inside (a concave shell).
typedef struct qn_sides {
    double young[2], poisson[2];  // Pa, 1
    double radius[2], mass[2];    // m, kg
    bool fixed[2];                //        never moves: counts as infinite mass where the law asks
    bool wall;                    //        side 1 is a wall
    bool clip;                    //        no attraction before separation
    double dt;                    // s
#define C(name, unit, used, with) double name;  // in `unit`
    QN_CONTACT_NUMBERS(C)
#undef C
} qn_sides;

/// Coefficients of one pair of classes. The units of the first four depend on the models; their list
/// rows (laws.h) name them.
typedef struct qn_pair {
    double normal_stiffness, normal_damping;
    double tangential_stiffness, tangential_damping;
    double friction;         // 1      Coulomb coefficient mu
    double floor;            // N      least normal force: 0, or minus infinity where it may pull
    double pull;             // N      as the cohesion model needs it
    double depth_scale;      // 1      what the normal model calls overlap, in true overlaps
    double rolling_arm;      // m      rolling torque per newton
    double rolling_limit;    // kg m2/s  torque per rad/s: a sixteenth of what stops it in a step
    double rolling_damping;  //        as the rolling model needs it
    double dt;               // s
} qn_pair;

/// 1/R* = 1/R_a + 1/R_b.
QN_FN double qn_effective_radius(const qn_sides *s)
{
    return 1 / (1 / s->radius[0] + 1 / s->radius[1]);
}

/// 1/m* = 1/m_a + 1/m_b, a side that never moves counting as infinitely heavy.
QN_FN double qn_effective_mass(const qn_sides *s)
{
    double inverse = (s->fixed[0] ? 0 : 1 / s->mass[0]) + (s->fixed[1] ? 0 : 1 / s->mass[1]);
    return 1 / inverse;
}

/// 1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b. Johnson (1985), Contact Mechanics, eq. 4.25.
QN_FN double qn_effective_young(const qn_sides *s)
{
    double compliance = 0;
    for (int i = 0; i < 2; i++) compliance += (1 - s->poisson[i] * s->poisson[i]) / s->young[i];
    return 1 / compliance;
}

/// 1/G* = (2 - nu_a)/G_a + (2 - nu_b)/G_b with G = E / (2 (1 + nu)). Mindlin (1949).
QN_FN double qn_effective_shear(const qn_sides *s)
{
    double compliance = 0;
    for (int i = 0; i < 2; i++)
        compliance += (2 - s->poisson[i]) * 2 * (1 + s->poisson[i]) / s->young[i];
    return 1 / compliance;
}

#endif
