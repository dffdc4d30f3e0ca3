// SPDX-License-Identifier: Apache-2.0
// The contact laws: each is a normal model and a tangential model under one name.
//
// To add a model, write normal_<name>.h or tangential_<name>.h; to add a law, add its row here. The
// scene reader, `quern help scene`, `quern check`, the inner loops and the generic tests follow.
#ifndef QN_PHYSICS_LAWS_H
#define QN_PHYSICS_LAWS_H

#include "physics/normal_hertz.h"
#include "physics/normal_linear.h"
#include "physics/normal_thesis.h"
#include "physics/tangential_linear.h"
#include "physics/tangential_mindlin.h"
#include "physics/tangential_thesis.h"

// clang-format off
//    NAME           in scenes        normal  tangential  clips   stiffness unit, damping unit, meaning
#define QN_LAWS(L)                                                                                        \
    L(HERTZ_MINDLIN, "hertz-mindlin", hertz,  mindlin,    true,  "N/m^1.5", "N s/m^1.25",                 \
      "Hertz spring, Mindlin tangential spring with history, exact restitution")                          \
    L(LINEAR,        "linear",        linear, linear,     true,  "N/m",     "N s/m",                      \
      "linear springs with history, exact restitution; needs a stiffness")                                \
    L(THESIS,        "thesis",        thesis, thesis,     false, "N/m^1.5", "N s/m^1.25",                 \
      "the reference thesis's law and convention, as its Algorithms 5.5 and 5.7")
// clang-format on

typedef enum qn_law {
#define L(NAME, text, normal, tangential, clips, stiffness, damping, meaning) QN_LAW_##NAME,
    QN_LAWS(L)
#undef L
        QN_LAW_COUNT
} qn_law;

/// The coefficients of a pair under a law. Host, once per pair of classes.
static inline qn_pair qn_law_pair(qn_law law, const qn_sides *s)
{
    qn_pair p = {0};
    p.depth_scale = 1;
    switch (law) {
#define L(NAME, text, normal, tangential, clips, stiffness, damping, meaning) \
    case QN_LAW_##NAME:                                                       \
        qn_##normal##_normal_pair(s, &p);                                     \
        qn_##tangential##_tangential_pair(s, &p);                             \
        break;
        QN_LAWS(L)
#undef L
    case QN_LAW_COUNT: break;
    }
    double inverse_inertia = 0;  // 1/(kg m2)   of a solid sphere, 2/5 m R^2
    for (int i = 0; i < 2; i++)
        if (!s->fixed[i]) inverse_inertia += 1 / (0.4 * s->mass[i] * s->radius[i] * s->radius[i]);
    p.friction = s->friction;
    p.floor = s->clip ? 0 : -INFINITY;
    p.rolling_arm = s->rolling_friction * qn_effective_radius(s);
    p.rolling_limit = inverse_inertia > 0 ? 1 / (16 * inverse_inertia * s->dt) : 0;
    p.dt = s->dt;
    return p;
}

#endif
