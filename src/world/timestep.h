// SPDX-License-Identifier: Apache-2.0
// The time step: what limits it, and what it should be.
//
// Rayleigh time, of a sphere's surface wave:  t_R = pi R sqrt(rho/G) / (0.1631 nu + 0.8766)
// Contact time at impact speed v, of a spring k depth^p, with q = p + 1:
//     t_c = 2 sqrt(pi) Gamma(1 + 1/q) / Gamma(1/2 + 1/q) d/v,  d = (q m* v^2 / (2 k))^(1/q)
//     (Hertz: 2.94328 d/v; linear: pi sqrt(m*/k)); with a viscous dashpot times -ln(e) / (pi zeta)
// Automatic step: the smaller of rayleigh_fraction t_R and t_c / 40 over all pairs; a contact then
// has at least 40 steps, and restitution is right to about 0.1 %.
//
// Source: Li, Xu & Thornton (2005), Powder Technol. 160, 219, doi:10.1016/j.powtec.2005.09.002 (t_R);
//         Hertz (1882) for t_c at p = 3/2; for any p by the same integral of the energy.
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

/// Duration (s) of an undamped contact of force k depth^power (N) and mass m* (kg) at `speed` (m/s), and
/// its largest overlap (m) through `depth` unless NULL.
double qn_impact_time(double k, double power, double effective_mass, double speed, double *depth);

/// The same of a contact under any law, as if nothing were lost in it. Not for the sides of walls
/// without a particle: one side has a mass.
double qn_contact_time(const qn_contact_def *contact, const qn_sides *sides, double speed,
                       double *depth);

/// All of it for a definition whose classes are known. Cost: O(classes^2).
qn_timestep qn_timestep_of(const qn_def *def, const qn_class *classes, int class_count);

#endif
