// SPDX-License-Identifier: Apache-2.0
// Three-component vectors.
#ifndef QN_PHYSICS_VEC3_H
#define QN_PHYSICS_VEC3_H

#include "physics/real.h"

typedef struct qn_vec3 {
    double x, y, z;
} qn_vec3;

QN_FN qn_vec3 qn_v3(double x, double y, double z)
{
    qn_vec3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

QN_FN qn_vec3 qn_add(qn_vec3 a, qn_vec3 b)
{
    return qn_v3(a.x + b.x, a.y + b.y, a.z + b.z);
}

QN_FN qn_vec3 qn_sub(qn_vec3 a, qn_vec3 b)
{
    return qn_v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

QN_FN qn_vec3 qn_scale(double s, qn_vec3 a)
{
    return qn_v3(s * a.x, s * a.y, s * a.z);
}

/// a + s b
QN_FN qn_vec3 qn_madd(qn_vec3 a, double s, qn_vec3 b)
{
    return qn_v3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

QN_FN double qn_dot(qn_vec3 a, qn_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

QN_FN qn_vec3 qn_cross(qn_vec3 a, qn_vec3 b)
{
    return qn_v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

QN_FN double qn_norm(qn_vec3 a)
{
    return sqrt(qn_dot(a, a));
}

/// Volume (m3) of a ball.
QN_FN double qn_ball_volume(double radius)
{
    return 4.0 / 3.0 * QN_PI * radius * radius * radius;
}

#endif
