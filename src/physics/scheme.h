// SPDX-License-Identifier: Apache-2.0
// Time integration: how a velocity and its position go from step n to step n + 1. The same functions
// move spins.
//
// A scheme keeps two things: `velocity`, which moved the particle over the last step, and `kick`, which
// added to it predicts the velocity of step n (what dashpots and friction want to know). Of a scheme
// there are three functions,
//
//     qn_<name>_begin(v, a, dt)          from the velocity of step 0 to what is kept then
//     qn_<name>_now(kept, a, dt)         velocity of step n, with the acceleration of step n
//     qn_<name>_advance(kept, a, dt)     what is kept at step n + 1; position += dt velocity follows
//
// and one row below.
//
// leapfrog   v(n+1/2) = v(n-1/2) + a(n) dt,  x(n+1) = x(n) + v(n+1/2) dt. Second order, symplectic.
// verlet     v(n) = v(n-1/2) + a(n) dt/2,  v(n+1/2) = v(n) + a(n) dt/2: with the same prediction
//            v(n) ~ v(n-1/2) + a(n-1) dt/2 it is the leapfrog, apart from rounding. It is here for
//            those who look for it by name.
// euler      x(n+1) = x(n) + v(n) dt,  v(n+1) = v(n) + a(n) dt. First order; every elastic contact
//            gains energy (15 % of its speed at 40 steps). It is what the reference thesis prints in its
//            section 4.6, to show what it does.
//
// Source: Verlet (1967), Phys. Rev. 159, 98, doi:10.1103/PhysRev.159.98; Swope, Andersen, Berens &
//         Wilson (1982), J. Chem. Phys. 76, 637, doi:10.1063/1.442716 (velocity form).
#ifndef QN_PHYSICS_SCHEME_H
#define QN_PHYSICS_SCHEME_H

#include "physics/vec3.h"

// clang-format off
//    NAME      name      in scenes          meaning
#define QN_SCHEMES(S)                                                                             \
    S(LEAPFROG, leapfrog, "leapfrog",        "second order, symplectic")                          \
    S(VERLET,   verlet,   "velocity-verlet", "the same but for rounding")                         \
    S(EULER,    euler,    "forward-euler",   "first order; gains energy in every contact: only to show it")

typedef enum qn_scheme {
#define S(NAME, name, text, meaning) QN_SCHEME_##NAME,
    QN_SCHEMES(S)
#undef S
    QN_SCHEME_COUNT
} qn_scheme;
// clang-format on

typedef struct qn_kept {
    qn_vec3 velocity, kick;  // m/s, or rad/s
} qn_kept;

QN_FN qn_kept qn_leapfrog_begin(qn_vec3 v, qn_vec3 a, double dt)
{
    qn_kept k;
    k.kick = qn_scale(0.5 * dt, a);
    k.velocity = qn_sub(v, k.kick);
    return k;
}

QN_FN qn_vec3 qn_leapfrog_now(qn_kept k, qn_vec3 a, double dt)
{
    return qn_madd(k.velocity, 0.5 * dt, a);
}

QN_FN qn_kept qn_leapfrog_advance(qn_kept k, qn_vec3 a, double dt)
{
    qn_kept next;
    next.velocity = qn_madd(k.velocity, dt, a);
    next.kick = qn_scale(0.5 * dt, a);
    return next;
}

QN_FN qn_kept qn_verlet_begin(qn_vec3 v, qn_vec3 a, double dt)
{
    return qn_leapfrog_begin(v, a, dt);
}

QN_FN qn_vec3 qn_verlet_now(qn_kept k, qn_vec3 a, double dt)
{
    return qn_leapfrog_now(k, a, dt);
}

QN_FN qn_kept qn_verlet_advance(qn_kept k, qn_vec3 a, double dt)
{
    qn_kept next;
    next.kick = qn_scale(0.5 * dt, a);
    next.velocity = qn_add(qn_verlet_now(k, a, dt), next.kick);
    return next;
}

QN_FN qn_kept qn_euler_begin(qn_vec3 v, qn_vec3 a, double dt)
{
    qn_kept k;
    (void)a, (void)dt;
    k.velocity = v;
    k.kick = qn_v3(0, 0, 0);
    return k;
}

QN_FN qn_vec3 qn_euler_now(qn_kept k, qn_vec3 a, double dt)
{
    (void)a, (void)dt;
    return qn_add(k.velocity, k.kick);
}

QN_FN qn_kept qn_euler_advance(qn_kept k, qn_vec3 a, double dt)
{
    qn_kept next;
    next.velocity = qn_euler_now(k, a, dt);
    next.kick = qn_scale(dt, a);
    return next;
}

QN_FN qn_kept qn_scheme_begin(qn_scheme scheme, qn_vec3 v, qn_vec3 a, double dt)
{
    switch (scheme) {
#define S(NAME, name, text, meaning) \
    case QN_SCHEME_##NAME: return qn_##name##_begin(v, a, dt);
        QN_SCHEMES(S)
#undef S
    default: return qn_leapfrog_begin(v, a, dt);
    }
}

QN_FN qn_vec3 qn_scheme_now(qn_scheme scheme, qn_kept k, qn_vec3 a, double dt)
{
    switch (scheme) {
#define S(NAME, name, text, meaning) \
    case QN_SCHEME_##NAME: return qn_##name##_now(k, a, dt);
        QN_SCHEMES(S)
#undef S
    default: return qn_leapfrog_now(k, a, dt);
    }
}

QN_FN qn_kept qn_scheme_advance(qn_scheme scheme, qn_kept k, qn_vec3 a, double dt)
{
    switch (scheme) {
#define S(NAME, name, text, meaning) \
    case QN_SCHEME_##NAME: return qn_##name##_advance(k, a, dt);
        QN_SCHEMES(S)
#undef S
    default: return qn_leapfrog_advance(k, a, dt);
    }
}

#endif
