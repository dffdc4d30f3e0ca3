// SPDX-License-Identifier: Apache-2.0
// How the two sides of a contact move against each other: what every model of a law is given.
//
// Positions are those of step n. Velocities are v(n-1/2), which moved the particles and so advances the
// history; `kick` beside them is the change a(n-1) dt/2 that predicts v(n), and dissipative forces use
// the sum: second order, and in step with the positions (what half a step of delay does at large size
// ratios: Vyas et al. 2024, arXiv 2410.14798). The history advances in the contact plane of n - 1/2,
// whose normal m is that of step n less half a step's swing: with the normal of step n a pair that
// turns as one body with spin W would drift by r dt/2 (W.n) W every second. A wall may be curved or turn, so
// its touch keeps the normal of step n - 1, and m lies half way; at the first touch m is that of step n.
#ifndef QN_PHYSICS_APPROACH_H
#define QN_PHYSICS_APPROACH_H

#include "physics/pair.h"
#include "physics/vec3.h"

/// What the contact loop knows of all contacts of one pair of classes.
typedef struct qn_reach {
    double reach;         // m   distance of the centres (or from the wall) at which contact begins
    double arm_a, arm_b;  // m   centre to contact point at zero overlap
    double give_a, give_b;  // 1   how much of the overlap shortens each arm
} qn_reach;

/// What a contact remembers from one step to the next, acting on side a.
typedef struct qn_memory {
    qn_vec3 slip;  // m    tangential displacement of a against b
    qn_vec3
        roll;  // N m  moment of the rolling spring; zero unless the law's rolling model keeps one
} qn_memory;

typedef struct qn_touch {
    qn_vec3 between;         // m      from b's centre, or the nearest wall point, to a's centre
    qn_vec3 velocity, kick;  // m/s    of a relative to b's centre or the wall point
    qn_vec3 spin_a, spin_b;  // rad/s  half-step
    qn_vec3 spin_kick_a, spin_kick_b;  // rad/s
    qn_memory memory;                  //        of the previous step
    qn_vec3 last;                      // 1      a wall's normal at the previous step; else 0
} qn_touch;

typedef struct qn_approach {
    qn_vec3 normal;        // 1      from b to a
    double depth, before;  // m      overlap now, and a step ago
    double root, fourth;   // m^1/2, m^1/4   square and fourth root of the depth
    double rate;           // m/s    how fast the overlap grows
    double arm_a, arm_b;   // m      from each centre to the contact point
    qn_vec3 held,
        advance;      // m      displacement kept from the step before, turned into the present
                      //        contact plane; what this step adds to it
    qn_vec3 slide;    // m/s    rate of the displacement
    qn_vec3 roll;     // N m    moment kept from the step before, turned likewise
    qn_vec3 turn;     // rad    by how much a has rolled against b in this step
    qn_vec3 rolling;  // rad/s  spin of a relative to b without its part along the normal
} qn_approach;

/// A tangential vector carried into the new contact plane with its length kept, and turned about the
/// normal by `twist` (rad), the rotation the two sides share.
/// Source: Luding (2008), Granular Matter 10, 235, doi:10.1007/s10035-008-0099-x, eq. 17.
QN_FN qn_vec3 qn_slip_turned(qn_vec3 slip, qn_vec3 normal, double twist)
{
    qn_vec3 flat = qn_madd(slip, -qn_dot(slip, normal), normal);
    qn_vec3 turned = qn_madd(flat, twist, qn_cross(normal, flat));
    double before = qn_dot(slip, slip), after = qn_dot(turned, turned);
    double stretch = sqrt(before / (after > 0 ? after : 1));
    return qn_scale(stretch, turned);
}

/// v without its part along the unit vector n.
QN_FN qn_vec3 qn_across(qn_vec3 v, qn_vec3 n)
{
    return qn_madd(v, -qn_dot(v, n), n);
}

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
    a.root = sqrt(a.depth);
    a.fourth = sqrt(a.root);
    a.arm_a = g->arm_a - g->give_a * a.depth;
    a.arm_b = g->arm_b - g->give_b * a.depth;
    qn_vec3 spins = qn_madd(qn_scale(a.arm_b, t->spin_b), a.arm_a, t->spin_a);
    qn_vec3 kicks = qn_madd(qn_scale(a.arm_b, t->spin_kick_b), a.arm_a, t->spin_kick_a);
    qn_vec3 now =
        qn_add(qn_contact_velocity(t->velocity, spins, n), qn_contact_velocity(t->kick, kicks, n));
    a.rate = -qn_dot(now, n);
    a.slide = qn_madd(now, a.rate, n);

    double lag = g->arm_b > 0 ? 0.5 * p->dt / distance : 0;
    qn_vec3 m = qn_madd(n, -lag, qn_across(t->velocity, n));
    double kept = qn_dot(t->last, t->last) > 0 ? 0.5 : 0;
    m = qn_madd(m, kept, qn_sub(t->last, n));
    qn_vec3 past = qn_contact_velocity(t->velocity, spins, m);
    double parting = qn_dot(past, m);
    double twist = 0.5 * p->dt * (qn_dot(t->spin_a, n) + qn_dot(t->spin_b, n));
    a.before = qn_max(a.depth + p->dt * parting, 0);
    a.held = qn_slip_turned(t->memory.slip, n, twist);
    a.advance = qn_scale(p->dt, qn_madd(past, -parting, m));

    qn_vec3 spin = qn_sub(t->spin_a, t->spin_b);
    qn_vec3 spin_now = qn_add(spin, qn_sub(t->spin_kick_a, t->spin_kick_b));
    a.roll = qn_slip_turned(t->memory.roll, n, twist);
    a.turn = qn_scale(p->dt, qn_across(spin, n));
    a.rolling = qn_across(spin_now, n);
    return a;
}

#endif
