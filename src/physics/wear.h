// SPDX-License-Identifier: Apache-2.0
// What one contact does to the wall it touches, in one step: the inputs of wear models.
//
//     normal  F_n max(v_n, 0) dt     J   work of the normal force while the particle presses in
//     shear   |F_t| |v_t| dt         J   tangential force times the slip speed
//     finnie  |F| |v| E(g) dt        J   while it presses in; g is the angle between v and the face,
//             E = cos^2 g / 3 where 3 sin g > cos g, else sin 2g - 3 sin^2 g
//
// F acts between particle and wall, v is the velocity of the particle's contact point relative to the
// wall's, v_n the speed at which the overlap grows. With a wear coefficient C (m3/J) the volume worn off is
// C times the shear work by Archard, C times the last by Finnie.
//
// Source: Archard (1953), J. Appl. Phys. 24, 981, doi:10.1063/1.1721448; Finnie (1960), Wear 3, 87,
//         doi:10.1016/0043-1648(60)90055-7, with K = 2, where the two branches meet.
// Holds:  where the wall keeps its shape. A contact that sticks slips a little as its spring loads.
#ifndef QN_PHYSICS_WEAR_H
#define QN_PHYSICS_WEAR_H

#include "physics/vec3.h"

// clang-format off
//    NAME     name          unit  meaning
#define QN_WEARS(W)                                                                                \
    W(NORMAL,  normal_work,  "J",  "work of the normal force while particles press in")            \
    W(SHEAR,   shear_work,   "J",  "tangential force times slip, Archard's input")                 \
    W(FINNIE,  finnie_work,  "J",  "force times way times Finnie's function of the impact angle")
// clang-format on

enum {
#define W(NAME, name, unit, meaning) QN_WEAR_##NAME,
    QN_WEARS(W)
#undef W
        QN_WEAR_COUNT
};

/// Finnie's function of the impact angle, from the parts of a speed normal to the face and along it.
QN_FN double qn_finnie(double normal, double along)
{
    double square = normal * normal + along * along;
    double steep = along * along / 3, shallow = 2 * normal * along - 3 * normal * normal;
    return square > 0 ? (3 * normal > along ? steep : shallow) / square : 0;
}

/// The three works (J) of a force (N) on the particle at a contact whose normal points to
/// it, velocity (m/s) being that of its contact point relative to the wall's.
QN_FN void qn_wear_of(qn_vec3 force, qn_vec3 normal, qn_vec3 velocity, double dt,
                      double work[QN_WEAR_COUNT])
{
    double push = qn_dot(force, normal), rate = qn_max(-qn_dot(velocity, normal), 0);
    qn_vec3 slide = qn_madd(velocity, -qn_dot(velocity, normal), normal);
    double drag = qn_norm(qn_madd(force, -push, normal)), slip = qn_norm(slide);
    double speed = qn_norm(velocity);
    work[QN_WEAR_NORMAL] = qn_max(push, 0) * rate * dt;
    work[QN_WEAR_SHEAR] = drag * slip * dt;
    work[QN_WEAR_FINNIE] = rate > 0 ? qn_norm(force) * speed * qn_finnie(rate, slip) * dt : 0;
}

#endif
