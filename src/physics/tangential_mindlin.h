// SPDX-License-Identifier: Apache-2.0
// Mindlin's no-slip tangential spring with displacement history.
//
//     F_t = -k sqrt(depth) slip - c depth^(1/4) slide, |F_t| <= mu F_n                  [N]
//     k = 8 G* sqrt(R*)                                                         [N/m^1.5]
//     c = 2 sqrt(5/6) zeta sqrt(m* k)                                      [N s/m^1.25]
//
// The stiffness follows the contact radius at constant slip. That spring is not conservative: its
// stored energy changes with the depth without work being done; the difference is the Mindlin residue.
//
// Source: Mindlin (1949), J. Appl. Mech. 16, 259; Di Renzo & Di Maio (2004), Chem. Eng. Sci. 59, 525,
//         doi:10.1016/j.ces.2003.09.037 (no-slip form).
// Holds:  no partial slip inside the contact (Mindlin & Deresiewicz); small slip. A loaded contact
//         that is pressed on further gains tangential force without moving (tangential_thornton.h).
#ifndef QN_PHYSICS_TANGENTIAL_MINDLIN_H
#define QN_PHYSICS_TANGENTIAL_MINDLIN_H

#include "physics/tangential.h"

static inline void qn_mindlin_tangential_pair(const qn_sides *s, qn_pair *p)
{
    double k = 8 * qn_effective_shear(s) * sqrt(qn_effective_radius(s));
    p->tangential_stiffness = k;
    p->tangential_damping =
        2 * sqrt(5.0 / 6) * qn_sides_damping_ratio(s) * sqrt(qn_effective_mass(s) * k);
}

/// Energy the spring loses in the kick of one step because its stiffness k ~ sqrt(depth) changes at
/// constant slip (J; a gain while the depth grows): 1/2 slip^2 (k(n - 1/2) - k(n + 1/2)).
QN_FN double qn_mindlin_residue(double energy, double depth, double rate, double dt)
{
    double half = 0.5 * rate * dt;
    double before = sqrt(qn_max(depth - half, 0)), after = sqrt(qn_max(depth + half, 0));
    return energy * (before - after) / sqrt(qn_max(depth, 1e-300));
}

QN_FN qn_tangential qn_mindlin_tangential(const qn_pair *p, const qn_approach *a, double limit)
{
    qn_tangential t = qn_slider(p->tangential_stiffness * a->root,
                                p->tangential_damping * a->fourth, limit, a->held, a, p->dt);
    t.residue = qn_mindlin_residue(t.energy, a->depth, a->rate, p->dt);
    return t;
}

#endif
