// SPDX-License-Identifier: Apache-2.0
// One contact, from the motion of its two sides to forces, torques, history and energies.
//
// The same function serves sphere against sphere and sphere against wall, on CPU and GPU; a law is
// its row in laws.h. It is evaluated once per touching pair and step, always from the side with the
// lower id (side a) to the other (side b): the normal n points from b to a.
//
// Positions are those of step n. Velocities are v(n-1/2), which moved the particles and so advances the
// history; `kick` beside them is the change a(n-1) dt/2 that predicts v(n), and dissipative forces use
// the sum: second order, and in step with the positions (what half a step of delay does at large size
// ratios: Vyas et al. 2024, arXiv 2410.14798). The history advances in the contact plane of n - 1/2,
// whose normal m is that of step n less half a step's swing: with the normal of step n a pair that
// turns as one body with spin W would drift by r dt/2 (W.n) W every second. A wall's normal stays.
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

/// How the two sides move against each other: what the models of a law are given.
typedef struct qn_approach {
    qn_vec3 normal;             // 1
    double depth, rate;         // m, m/s   overlap, and how fast it grows
    double arm_a, arm_b;        // m        from each centre to the contact point
    qn_vec3 held, slip, slide;  // m, m, m/s   tangential.h
    qn_vec3 spin;               // rad/s    of a relative to b
} qn_approach;

/// Velocity of a's contact point relative to b's (m/s), from the relative velocity of the centres and
/// arm_a spin_a + arm_b spin_b (m/s).
QN_FN qn_vec3 qn_contact_velocity(qn_vec3 velocity, qn_vec3 arms_spin, qn_vec3 normal)
{
    return qn_sub(velocity, qn_cross(arms_spin, normal));
}

QN_FN qn_approach qn_approach_of(const qn_pair *p, const qn_reach *g, const qn_touch *t)
{
    double distance = qn_norm(t->between);
    qn_vec3 n = qn_scale(1 / distance, t->between);
    qn_approach a;
    a.normal = n;
    a.depth = qn_max(g->reach - distance, 0);
    a.arm_a = g->arm_a - g->give_a * a.depth;
    a.arm_b = g->arm_b - g->give_b * a.depth;
    qn_vec3 spins = qn_madd(qn_scale(a.arm_b, t->spin_b), a.arm_a, t->spin_a);
    qn_vec3 kicks = qn_madd(qn_scale(a.arm_b, t->spin_kick_b), a.arm_a, t->spin_kick_a);
    qn_vec3 now =
        qn_add(qn_contact_velocity(t->velocity, spins, n), qn_contact_velocity(t->kick, kicks, n));
    a.rate = -qn_dot(now, n);
    a.slide = qn_madd(now, a.rate, n);

    double lag = g->arm_b > 0 ? 0.5 * p->dt / distance : 0;
    qn_vec3 m = qn_madd(n, -lag, qn_madd(t->velocity, -qn_dot(t->velocity, n), n));
    qn_vec3 past = qn_contact_velocity(t->velocity, spins, m);
    double twist = 0.5 * p->dt * (qn_dot(t->spin_a, n) + qn_dot(t->spin_b, n));
    a.held = qn_slip_turned(t->slip, n, twist);
    a.slip = qn_madd(a.held, p->dt, qn_madd(past, -qn_dot(past, m), m));
    a.spin = qn_add(qn_sub(t->spin_a, t->spin_b), qn_sub(t->spin_kick_a, t->spin_kick_b));
    return a;
}

/// Forces, torques and energies from what the models gave back.
QN_FN void qn_reply_of(const qn_pair *p, const qn_approach *a, const qn_normal *f, double push,
                       const qn_tangential *s, double residue, qn_reply *r)
{
    qn_vec3 rolling = qn_rolling_torque(p, f->elastic, a->normal, a->spin);
    qn_vec3 lever = qn_cross(a->normal, s->force);
    r->depth = a->depth;
    r->normal = a->normal;
    r->elastic = f->elastic;
    r->damping = f->damping;
    r->push = push;
    r->tangential = s->force;
    r->torque_a = qn_madd(rolling, -a->arm_a, lever);
    r->torque_b = qn_sub(qn_scale(-a->arm_b, lever), rolling);
    r->rolling = rolling;
    r->slip = s->slip;
    r->stored_normal = f->energy;
    r->stored_tangential = s->energy;
    r->lost_normal = (push - f->elastic) * a->rate * p->dt;
    r->lost_tangential = s->lost_dashpot;
    r->lost_sliding = s->lost_sliding;
    r->lost_rolling = -qn_dot(rolling, a->spin) * p->dt;
    r->residue = residue;
}

// qn_contact_NAME: one contact under one law, without a branch.
// clang-format off
#define L(NAME, text, normal_model, tangential_model, clips, stiffness, damping_unit, meaning)          \
    QN_FN void qn_contact_##NAME(const qn_pair *p, const qn_reach *g, const qn_touch *t, qn_reply *r)   \
    {                                                                                                   \
        qn_approach a = qn_approach_of(p, g, t);                                                        \
        qn_normal f = qn_##normal_model##_normal(p, a.depth, a.rate);                                   \
        double push = qn_max(f.elastic + f.damping, p->floor);                                          \
        qn_tangential s = qn_##tangential_model##_tangential(p, a.depth, p->friction * fabs(push),      \
                                                             a.held, a.slip, a.slide);                  \
        double residue = qn_##tangential_model##_residue(s.energy, a.depth, a.rate, p->dt);             \
        qn_reply_of(p, &a, &f, push, &s, residue, r);                                                   \
    }
QN_LAWS(L)
#undef L

/// One contact under any law, for those who are not in a hurry.
QN_FN void qn_contact_evaluate(qn_law law, const qn_pair *p, const qn_reach *g, const qn_touch *t,
                               qn_reply *r)
{
    switch (law) {
#define L(NAME, text, normal, tangential, clips, stiffness, damping, meaning) \
    case QN_LAW_##NAME: qn_contact_##NAME(p, g, t, r); break;
        QN_LAWS(L)
#undef L
    case QN_LAW_COUNT: break;
    }
}
// clang-format on

#endif
