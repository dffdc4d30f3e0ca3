// SPDX-License-Identifier: Apache-2.0
// One contact, from the motion of its two sides to forces, torques, history and energies.
//
// The same function serves sphere against sphere and sphere against wall, on CPU and GPU; a law is
// its row in laws.h. It is evaluated once per touching pair and step, always from the side with the
// lower id (side a) to the other (side b): the normal n points from b to a.
//
// Positions are those of step n. Each velocity comes twice: `half` is v(n-1/2), which moved the
// particles and so advances the history; `kick` is the change a(n-1) dt/2 that predicts v(n), and
// dissipative forces use their sum (second order; algorithms of Vyas et al. 2024, arXiv 2410.14798,
// show what asynchronous velocities do at large size ratios). The history advances in the contact plane
// of step n - 1/2, whose normal m is that of step n less half a step's swing: with the normal of step n
// a pair that turns as one body would drift by r dt/2 (W.n) W per second (a wall's normal stays its own).
#ifndef QN_PHYSICS_CONTACT_H
#define QN_PHYSICS_CONTACT_H

#include "physics/laws.h"
#include "physics/rolling.h"

/// What the contact loop knows of all contacts of one pair of classes.
typedef struct qn_reach {
    double reach;         // m   distance of the centres (or from the wall) at which contact begins
    double arm_a, arm_b;  // m   centre to contact point at zero overlap
    double give_a, give_b;  // 1   how much of the overlap shortens each arm
} qn_reach;

typedef struct qn_touch {
    qn_vec3 between;         // m      from b's centre, or the nearest wall point, to a's centre
    qn_vec3 velocity, kick;  // m/s    of a relative to b's centre or the wall point
    qn_vec3 spin_a, spin_b;  // rad/s  half-step
    qn_vec3 spin_kick_a, spin_kick_b;  // rad/s
    qn_vec3 slip;                      // m      history of the previous step
} qn_touch;

typedef struct qn_reply {
    double depth;                // m
    qn_vec3 normal;              // 1
    double elastic, damping;     // N    parts of the normal force, before the clip
    double push;                 // N    normal force on a along the normal, after the clip
    qn_vec3 tangential;          // N    on a
    qn_vec3 torque_a, torque_b;  // N m
    qn_vec3 rolling;             // N m  the part of torque_a that resists rolling; -it in torque_b
    qn_vec3 slip;                // m    history for the next step
    double stored_normal, stored_tangential;                                   // J
    double lost_normal, lost_tangential, lost_sliding, lost_rolling, residue;  // J   in this step
} qn_reply;

/// Shared part of the contact of one law: everything but the two models, which come in as macros so
/// that each law compiles to one straight-line function.
#define QN_CONTACT_BODY(NORMAL, TANGENTIAL, RESIDUE)                                             \
    double distance = qn_norm(t->between);                                                       \
    qn_vec3 n = qn_scale(1 / distance, t->between);                                              \
    double depth = qn_max(g->reach - distance, 0);                                               \
    double arm_a = g->arm_a - g->give_a * depth, arm_b = g->arm_b - g->give_b * depth;           \
    qn_vec3 spin_b = qn_scale(arm_b, t->spin_b), kick_b = qn_scale(arm_b, t->spin_kick_b);       \
    qn_vec3 moved = qn_sub(t->velocity, qn_cross(qn_madd(spin_b, arm_a, t->spin_a), n));         \
    qn_vec3 kick = qn_sub(t->kick, qn_cross(qn_madd(kick_b, arm_a, t->spin_kick_a), n));         \
    qn_vec3 now = qn_add(moved, kick);                                                           \
    double rate = -qn_dot(now, n);                                                               \
    qn_vec3 slide = qn_madd(now, rate, n);                                                       \
    double lag = g->arm_b > 0 ? 0.5 * p->dt / distance : 0;                                      \
    qn_vec3 m = qn_madd(n, -lag, qn_madd(t->velocity, -qn_dot(t->velocity, n), n));              \
    qn_vec3 past = qn_sub(t->velocity, qn_cross(qn_madd(spin_b, arm_a, t->spin_a), m));          \
    qn_vec3 advance = qn_madd(past, -qn_dot(past, m), m);                                        \
    double twist = 0.5 * p->dt * (qn_dot(t->spin_a, n) + qn_dot(t->spin_b, n));                  \
    qn_vec3 held = qn_slip_turned(t->slip, n, twist);                                            \
    qn_vec3 slip = qn_madd(held, p->dt, advance);                                                \
    qn_normal f = NORMAL(p, depth, rate);                                                        \
    double push = qn_max(f.elastic + f.damping, p->floor);                                       \
    qn_tangential s = TANGENTIAL(p, depth, p->friction * fabs(push), held, slip, slide);         \
    qn_vec3 spin = qn_add(qn_sub(t->spin_a, t->spin_b), qn_sub(t->spin_kick_a, t->spin_kick_b)); \
    qn_vec3 rolling = qn_rolling_torque(p, f.elastic, n, spin);                                  \
    qn_vec3 lever = qn_cross(n, s.force);                                                        \
    r->depth = depth;                                                                            \
    r->normal = n;                                                                               \
    r->elastic = f.elastic;                                                                      \
    r->damping = f.damping;                                                                      \
    r->push = push;                                                                              \
    r->tangential = s.force;                                                                     \
    r->torque_a = qn_madd(rolling, -arm_a, lever);                                               \
    r->torque_b = qn_sub(qn_scale(-arm_b, lever), rolling);                                      \
    r->rolling = rolling;                                                                        \
    r->slip = s.slip;                                                                            \
    r->stored_normal = f.energy;                                                                 \
    r->stored_tangential = s.energy;                                                             \
    r->lost_normal = (push - f.elastic) * rate * p->dt;                                          \
    r->lost_tangential = s.lost_dashpot;                                                         \
    r->lost_sliding = s.lost_sliding;                                                            \
    r->lost_rolling = -qn_dot(rolling, spin) * p->dt;                                            \
    r->residue = RESIDUE(s.energy, depth, rate, p->dt);

// clang-format off
#define L(NAME, text, normal, tangential, clips, stiffness, damping, meaning)                               \
    QN_FN void qn_contact_##NAME(const qn_pair *p, const qn_reach *g, const qn_touch *t, qn_reply *r)       \
    {                                                                                                       \
        QN_CONTACT_BODY(qn_##normal##_normal, qn_##tangential##_tangential, qn_##tangential##_residue)      \
    }
QN_LAWS(L)
#undef L
// clang-format on

#endif
