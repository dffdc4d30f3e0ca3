// SPDX-License-Identifier: Apache-2.0
// One contact, from the motion of its two sides to forces, torques, history and energies.
//
// The same functions serve sphere against sphere and sphere against wall, on CPU and GPU:
//
//     approach    how the two sides move against each other (approach.h)
//     normal      spring, then damping, then the clip: the push
//     cohesion    what pulls against it
//     tangential  friction, up to mu times the push
//     rolling     resistance
//     reply       forces, torques, energies
//
// A contact is evaluated once per touching pair and step, always from the side with the lower id (side
// a) to the other (side b). The inner loops run each operation over a block of contacts in turn;
// qn_contact_evaluate() runs them all for one contact, with the same bits.
#ifndef QN_PHYSICS_CONTACT_H
#define QN_PHYSICS_CONTACT_H

#include "physics/laws.h"

typedef struct qn_reply {
    double depth;                // m
    qn_vec3 normal;              // 1
    double elastic, damping;     // N    parts of the normal force, before the clip
    double pull;                 // N    of cohesion
    double push;                 // N    normal force on a along the normal, after clip and pull
    qn_vec3 tangential;          // N    on a
    qn_vec3 torque_a, torque_b;  // N m
    qn_vec3 rolling;             // N m  the part of torque_a that resists rolling; -it in torque_b
    qn_memory memory;            //      for the next step
    double stored_normal, stored_tangential;                                   // J
    double lost_normal, lost_tangential, lost_sliding, lost_rolling, residue;  // J   in this step
} qn_reply;

/// The normal force (N) of spring and damping after the clip.
QN_FN double qn_contact_push(const qn_pair *p, double elastic, double damping)
{
    return qn_max(elastic + damping, p->floor);
}

/// Forces, torques and energies from what the models gave back. push: N, before the pull.
QN_FN void qn_contact_reply(const qn_pair *p, const qn_approach *a, qn_normal f, double damping,
                            double push, qn_cohesion c, qn_tangential s, qn_rolling m, qn_reply *r)
{
    qn_vec3 lever = qn_cross(a->normal, s.force);
    r->depth = a->depth;
    r->normal = a->normal;
    r->elastic = f.elastic;
    r->damping = damping;
    r->pull = c.pull;
    r->push = push - c.pull;
    r->tangential = s.force;
    r->torque_a = qn_madd(m.torque, -a->arm_a, lever);
    r->torque_b = qn_sub(qn_scale(-a->arm_b, lever), m.torque);
    r->rolling = m.torque;
    r->memory.slip = s.slip;
    r->memory.roll = m.kept;
    r->stored_normal = f.energy + c.energy;
    r->stored_tangential = s.energy;
    r->lost_normal = (push - f.elastic) * a->rate * p->dt;
    r->lost_tangential = s.lost_dashpot;
    r->lost_sliding = s.lost_sliding;
    r->lost_rolling = -qn_dot(m.torque, a->rolling) * p->dt;
    r->residue = s.residue;
}

// clang-format off
QN_FN qn_normal qn_normal_of(qn_normal_model model, const qn_pair *p, const qn_approach *a)
{
    switch (model) {
#define N(NAME, name, text, power, unit, meaning) case QN_NORMAL_##NAME: return qn_##name##_normal(p, a);
        QN_NORMALS(N)
#undef N
    default: return qn_hertz_normal(p, a);
    }
}

/// The spring of a pair at an overlap (m), at rest.
static inline qn_normal qn_normal_at(qn_normal_model model, const qn_pair *p, double depth)
{
    qn_approach a = {0};
    a.depth = depth;
    a.root = sqrt(depth);
    a.fourth = sqrt(a.root);
    return qn_normal_of(model, p, &a);
}

QN_FN double qn_damping_of(qn_damping_model model, const qn_pair *p, const qn_approach *a, double elastic)
{
    switch (model) {
#define D(NAME, name, text, with, unit, meaning) case QN_DAMPING_##NAME: return qn_##name##_damping(p, a, elastic);
        QN_DAMPINGS(D)
#undef D
    default: return 0;
    }
}

QN_FN qn_cohesion qn_cohesion_of(qn_cohesion_model model, const qn_pair *p, const qn_approach *a)
{
    switch (model) {
#define C(NAME, name, text, with, meaning) case QN_COHESION_##NAME: return qn_##name##_cohesion(p, a);
        QN_COHESIONS(C)
#undef C
    default: return qn_none_cohesion(p, a);
    }
}

QN_FN qn_tangential qn_tangential_of(qn_tangential_model model, const qn_pair *p, const qn_approach *a, double limit)
{
    switch (model) {
#define T(NAME, name, text, with, meaning) case QN_TANGENTIAL_##NAME: return qn_##name##_tangential(p, a, limit);
        QN_TANGENTIALS(T)
#undef T
    default: return qn_none_tangential(p, a, limit);
    }
}

QN_FN qn_rolling qn_rolling_of(qn_rolling_model model, const qn_pair *p, const qn_approach *a, double elastic)
{
    switch (model) {
#define R(NAME, name, text, remembers, meaning) case QN_ROLLING_##NAME: return qn_##name##_rolling(p, a, elastic);
        QN_ROLLINGS(R)
#undef R
    default: return qn_none_rolling(p, a, elastic);
    }
}
// clang-format on

/// One contact under any law.
QN_FN void qn_contact_evaluate(qn_law law, const qn_pair *p, const qn_reach *g, const qn_touch *t,
                               qn_reply *r)
{
    qn_approach a = qn_approach_of(p, g, t);
    qn_normal f = qn_normal_of(law.normal, p, &a);
    double damping = qn_damping_of(law.damping, p, &a, f.elastic);
    double push = qn_contact_push(p, f.elastic, damping);
    qn_cohesion c = qn_cohesion_of(law.cohesion, p, &a);
    qn_tangential s = qn_tangential_of(law.tangential, p, &a, p->friction * fabs(push));
    qn_rolling m = qn_rolling_of(law.rolling, p, &a, f.elastic);
    qn_contact_reply(p, &a, f, damping, push, c, s, m, r);
}

#endif
