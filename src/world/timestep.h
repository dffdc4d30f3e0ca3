// SPDX-License-Identifier: Apache-2.0
// The time step: what limits it, and what it should be.
//
// Rayleigh time, of a sphere's surface wave:  t_R = pi R sqrt(rho/G) / (0.1631 nu + 0.8766)
// Contact time, Hertz at impact speed v:      t_c = 2.94328 d/v,  d = (5 m* v^2 / (4 k))^(2/5)
// Contact time, linear:                       t_c = -ln(e)/zeta sqrt(m*/k), pi sqrt(m*/k) for e = 1
// Automatic step: the smaller of rayleigh_fraction t_R and t_c / 40 over all pairs; a contact then
// has at least 40 steps, and restitution is right to about 0.1 %.
//
// Source: Li, Xu & Thornton (2005), Powder Technol. 160, 219, doi:10.1016/j.powtec.2005.09.002 (t_R);
//         Hertz (1882), 2.94328 = 2 sqrt(pi) Gamma(7/5)/Gamma(9/10) (t_c).
#ifndef QN_WORLD_TIMESTEP_H
#define QN_WORLD_TIMESTEP_H

#include "world/world.h"

#define QN_RAYLEIGH_WARN 0.3    // 1   of the Rayleigh time: above it, a warning
#define QN_RAYLEIGH_REFUSE 1.0  // 1   above it, no run
#define QN_STEPS_PER_CONTACT 40.0

typedef struct qn_timestep {
    double impact_speed;     // m/s  fastest impact to expect, of both sides together
    double rayleigh;         // s    shortest over the classes
    double contact;          // s    shortest over the pairs, at the impact speed
    double largest_overlap;  // 1  at the impact speed, in radii of the smaller sphere
    double suggested;        // s
} qn_timestep;

/// Rayleigh time (s) of a sphere of radius (m) and material.
double qn_rayleigh_time(const qn_material_def *material, double radius);

/// Duration (s) of a Hertz contact of stiffness k (N/m^1.5) and mass m* (kg) at speed v (m/s), and its
/// largest overlap (m) through `depth` unless NULL.
double qn_hertz_time(double k, double effective_mass, double speed, double *depth);

/// The same of a contact under any law, as if nothing were lost in it. Not for the sides of walls
/// without a particle: one side has a mass.
double qn_contact_time(const qn_contact_def *contact, const qn_sides *sides, double speed,
                       double *depth);

/// All of it for a definition whose classes are known. Cost: O(classes^2).
qn_timestep qn_timestep_of(const qn_def *def, const qn_class *classes, int class_count);

#endif
