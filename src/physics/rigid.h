// SPDX-License-Identifier: Apache-2.0
// Rotation of a rigid body: quaternions, and the free turn of one step.
//
// An orientation q takes vectors from the body's frame, whose axes are its principal axes, to space:
// x = R(q) r. Torques change the angular momentum L in space, L(n+1/2) = L(n-1/2) + T(n) dt; between
// kicks L stands still and the body turns freely,
//
//     R' = R A1(dt/2) A2(dt/2) A3(dt) A2(dt/2) A1(dt/2),
//
// where Ak(t) turns about principal axis k by the angle t p_k / I_k, and takes p = R^T L along. Each of
// the five is the exact motion under one term of the energy p1^2/(2 I1) + p2^2/(2 I2) + p3^2/(2 I3), so
// L in space stays as it is, to the bit as it is a stored number; the turn is symplectic and
// reversible, and the energy is right to second order without drift.
//
// Source: Dullweber, Leimkuhler & McLachlan (1997), J. Chem. Phys. 107, 5840, doi:10.1063/1.474310,
//         eq. 24; the same with quaternions: Miller et al. (2002), J. Chem. Phys. 116, 8649,
//         doi:10.1063/1.1473654 (NO_SQUISH).
// Holds:  |w| dt << 1; angles above 1e5 rad a step are beyond angle.h.
#ifndef QN_PHYSICS_RIGID_H
#define QN_PHYSICS_RIGID_H

#include "physics/angle.h"
#include "physics/vec3.h"

/// A unit quaternion; w is the cosine of half the angle.
typedef struct qn_quat {
    double w, x, y, z;
} qn_quat;

QN_FN qn_quat qn_quat_of(double w, double x, double y, double z)
{
    qn_quat q;
    q.w = w;
    q.x = x;
    q.y = y;
    q.z = z;
    return q;
}

/// First b, then a: R(a b) = R(a) R(b).
QN_FN qn_quat qn_quat_mul(qn_quat a, qn_quat b)
{
    return qn_quat_of(a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w);
}

/// Scaled to length 1, which rounding takes it away from.
QN_FN qn_quat qn_quat_unit(qn_quat q)
{
    double s = 1 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return qn_quat_of(s * q.w, s * q.x, s * q.y, s * q.z);
}

/// From the body's frame to space: v + 2 u x (u x v + w v), u the vector part.
QN_FN qn_vec3 qn_turned(qn_quat q, qn_vec3 v)
{
    qn_vec3 u = qn_v3(q.x, q.y, q.z);
    return qn_madd(v, 2, qn_cross(u, qn_madd(qn_cross(u, v), q.w, v)));
}

/// From space to the body's frame.
QN_FN qn_vec3 qn_turned_back(qn_quat q, qn_vec3 v)
{
    return qn_turned(qn_quat_of(q.w, -q.x, -q.y, -q.z), v);
}

/// The turn by a rotation vector (rad): about it, by its length.
QN_FN qn_quat qn_quat_of_vector(qn_vec3 angle)
{
    double size = qn_norm(angle), sine, cosine;
    qn_sincos(0.5 * size, &sine, &cosine);
    double s = size > 0 ? sine / size : 0.5;
    return qn_quat_of(cosine, s * angle.x, s * angle.y, s * angle.z);
}

/// A tensor that is diagonal in the body's frame, times a vector in space: R diag R^T v. The inverse
/// moments (1/(kg m2)) make a spin (rad/s) of an angular momentum (N m s), the moments do the reverse.
QN_FN qn_vec3 qn_tensor_times(qn_quat q, qn_vec3 diagonal, qn_vec3 v)
{
    qn_vec3 p = qn_turned_back(q, v);
    return qn_turned(q, qn_v3(diagonal.x * p.x, diagonal.y * p.y, diagonal.z * p.z));
}

// A turn by `angle` about one principal axis: q q(axis), and p turned the other way.
#define QN_AXIS_TURN(q, p, angle, axis, a, b)                \
    do {                                                     \
        double sine_, cosine_, half_sine_, half_cosine_;     \
        double angle_ = (angle), pa_ = (p).a, pb_ = (p).b;   \
        qn_quat turn_ = qn_quat_of(0, 0, 0, 0);              \
        qn_sincos(0.5 * angle_, &half_sine_, &half_cosine_); \
        sine_ = 2 * half_sine_ * half_cosine_;               \
        cosine_ = 1 - 2 * half_sine_ * half_sine_;           \
        turn_.w = half_cosine_;                              \
        turn_.axis = half_sine_;                             \
        (q) = qn_quat_mul((q), turn_);                       \
        (p).a = cosine_ * pa_ + sine_ * pb_;                 \
        (p).b = cosine_ * pb_ - sine_ * pa_;                 \
    } while (0)

/// Orientation after turning freely for a time dt (s, of either sign).
QN_FN qn_quat qn_free_turn(qn_quat q, qn_vec3 momentum, qn_vec3 inverse_moments, double dt)
{
    qn_vec3 p = qn_turned_back(q, momentum), rate = qn_scale(dt, inverse_moments);
    QN_AXIS_TURN(q, p, 0.5 * rate.x * p.x, x, y, z);
    QN_AXIS_TURN(q, p, 0.5 * rate.y * p.y, y, z, x);
    QN_AXIS_TURN(q, p, rate.z * p.z, z, x, y);
    QN_AXIS_TURN(q, p, 0.5 * rate.y * p.y, y, z, x);
    QN_AXIS_TURN(q, p, 0.5 * rate.x * p.x, x, y, z);
    return qn_quat_unit(q);
}

/// The same for a body whose three moments are equal: its spin (rad/s) stands still.
QN_FN qn_quat qn_round_turn(qn_quat q, qn_vec3 spin, double dt)
{
    return qn_quat_unit(qn_quat_mul(qn_quat_of_vector(qn_scale(dt, spin)), q));
}

#endif
