// SPDX-License-Identifier: Apache-2.0
// From restitution to damping ratio, exactly. Used at set-up only.
//
// In u = sqrt(2/(p+1)) depth^((p+1)/2) a contact with elastic force k depth^p and the dashpot
//     F_d = sqrt(2 (p+1)) zeta sqrt(m* k) depth^((p-1)/2) rate
// is a linear damped oscillator of damping ratio zeta, for p = 1 (linear) and p = 3/2 (Hertz) alike:
// restitution is then independent of the impact speed.
//
// Source: Antypov & Elliott (2011), EPL 94, 50004, doi:10.1209/0295-5075/94/50004 (no clip);
//         Schwager & Poeschel (2007), Granular Matter 9, 465, doi:10.1007/s10035-007-0065-z and (2008),
//         Phys. Rev. E 78, 051304, doi:10.1103/PhysRevE.78.051304 (linear and viscoelastic; the
//         contact ends where the force would turn attractive).
// Holds:  one undisturbed collision; under a lasting load restitution has no meaning.
#ifndef QN_PHYSICS_RESTITUTION_H
#define QN_PHYSICS_RESTITUTION_H

#include "physics/real.h"

/// Damping ratio for restitution e in ]0, 1] when the dashpot may pull.
static inline double qn_damping_ratio(double e)
{
    double l = log(e);
    return -l / sqrt(QN_PI * QN_PI + l * l);
}

/// Restitution of a contact of damping ratio zeta whose force never pulls:
/// exp(-2 zeta arccos(zeta) / sqrt(1 - zeta^2)), continued analytically past zeta = 1.
static inline double qn_clipped_restitution(double zeta)
{
    double q = 1 - zeta * zeta;
    if (q > 1e-12) return exp(-2 * zeta * acos(zeta) / sqrt(q));
    if (q < -1e-12) return exp(-2 * zeta * acosh(zeta) / sqrt(-q));
    return exp(-2);
}

/// Damping ratio for restitution e in ]0, 1] when the force is clipped at zero; by bisection.
static inline double qn_clipped_damping_ratio(double e)
{
    double low = 0, high = 1;
    if (e >= 1) return 0;
    while (qn_clipped_restitution(high) > e && high < 1e30) high *= 2;
    for (int i = 0; i < 200; i++) {
        double middle = (low + high) / 2;
        if (qn_clipped_restitution(middle) > e)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}

#endif
