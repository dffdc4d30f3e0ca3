// SPDX-License-Identifier: Apache-2.0
// The contact laws: a normal spring, a damping, a cohesion, a tangential and a rolling model each.
//
// To add a model, write its file and add its row here; the scene reader, `quern help scene`, `quern
// check`, the inner loops and the generic tests follow. A law is any five that make sense together
// (qn_..._fits); the usual ones have names.
#ifndef QN_PHYSICS_LAWS_H
#define QN_PHYSICS_LAWS_H

#include "physics/cohesion_dmt.h"
#include "physics/cohesion_none.h"
#include "physics/damping_hunt_crossley.h"
#include "physics/damping_none.h"
#include "physics/damping_thesis.h"
#include "physics/damping_tsuji.h"
#include "physics/damping_viscous.h"
#include "physics/normal_hertz.h"
#include "physics/normal_linear.h"
#include "physics/normal_thesis.h"
#include "physics/normal_young.h"
#include "physics/rolling_constant.h"
#include "physics/rolling_epsd.h"
#include "physics/rolling_none.h"
#include "physics/rolling_thesis.h"
#include "physics/rolling_viscous.h"
#include "physics/tangential_linear.h"
#include "physics/tangential_mindlin.h"
#include "physics/tangential_none.h"
#include "physics/tangential_thesis.h"
#include "physics/tangential_thornton.h"
#include "physics/tangential_viscous.h"

// clang-format off
//    NAME      model    in scenes   power  unit of k    meaning
#define QN_NORMALS(N)                                                                                    \
    N(LINEAR,   linear,  "linear",   1,     "N/m",       "linear spring")                                \
    N(HERTZ,    hertz,   "hertz",    1.5,   "N/m^1.5",   "Hertz's spring between elastic spheres")       \
    N(YOUNG,    young,   "young",    2,     "Pa",        "the reference thesis's compressed columns (4.1)") \
    N(THESIS,   thesis,  "thesis",   1.5,   "N/m^1.5",   "the reference thesis's spring and convention")

//    NAME           model           in scenes         goes with                unit of c       meaning
#define QN_DAMPINGS(D)                                                                                   \
    D(NONE,          none,           "none",           QN_ANY_NORMAL,           "",             "none: restitution 1") \
    D(VISCOUS,       viscous,        "viscous",        1 << QN_NORMAL_LINEAR,   "N s/m",        "constant coefficient, exact restitution") \
    D(TSUJI,         tsuji,          "tsuji",          1 << QN_NORMAL_HERTZ,    "N s/m^1.25",   "Tsuji's form, exact restitution") \
    D(HUNT_CROSSLEY, hunt_crossley,  "hunt-crossley",  QN_ANY_NORMAL,           "s/m",          "in proportion to the spring's force; exact restitution at impact_speed") \
    D(THESIS,        thesis,         "thesis",         1 << QN_NORMAL_THESIS,   "N s/m^1.25",   "the reference thesis's dashpot")

//    NAME      model    in scenes   goes with               meaning
#define QN_COHESIONS(C)                                                                                  \
    C(NONE,     none,    "none",     QN_ANY_NORMAL,          "none")                                     \
    C(DMT,      dmt,     "dmt",      1 << QN_NORMAL_HERTZ,   "constant pull of surface_energy while touching (DMT)")

//    NAME       model     in scenes            goes with               meaning
#define QN_TANGENTIALS(T)                                                                                \
    T(NONE,      none,     "none",              QN_ANY_NORMAL,          "none: smooth")                  \
    T(VISCOUS,   viscous,  "viscous",           QN_ANY_NORMAL,          "tangential_damping times the sliding speed") \
    T(LINEAR,    linear,   "linear",            1 << QN_NORMAL_LINEAR,  "linear spring with history")    \
    T(MINDLIN,   mindlin,  "mindlin",           1 << QN_NORMAL_HERTZ,   "Mindlin's spring with displacement history") \
    T(THORNTON,  thornton, "mindlin-thornton",  1 << QN_NORMAL_HERTZ,   "Mindlin's spring with force history, Thornton's unloading") \
    T(THESIS,    thesis,   "thesis",            1 << QN_NORMAL_THESIS,  "the reference thesis's, without memory")

//    NAME      model     in scenes    remembers  meaning
#define QN_ROLLINGS(R)                                                                                   \
    R(NONE,     none,     "none",      false,     "none")                                                \
    R(CONSTANT, constant, "constant",  false,     "constant torque (A)")                                 \
    R(VISCOUS,  viscous,  "viscous",   false,     "rolling_viscosity times the rolling speed (B)")       \
    R(EPSD,     epsd,     "epsd",      true,      "elastic-plastic spring and dashpot (C)")              \
    R(THESIS,   thesis,   "thesis",    false,     "the reference thesis's (4.5)")

//    NAME           in scenes        normal  damping  tangential  clips   meaning
#define QN_LAWS(L)                                                                                       \
    L(HERTZ_MINDLIN, "hertz-mindlin", HERTZ,  TSUJI,   MINDLIN,    true,                                 \
      "Hertz spring, Mindlin tangential spring with history, exact restitution")                         \
    L(LINEAR,        "linear",        LINEAR, VISCOUS, LINEAR,     true,                                 \
      "linear springs with history, exact restitution; needs a stiffness or an impact speed")            \
    L(THESIS,        "thesis",        THESIS, THESIS,  THESIS,     false,                                \
      "the reference thesis's law and convention, as its Algorithms 5.5 and 5.7")

typedef enum qn_normal_model {
#define N(NAME, model, text, power, unit, meaning) QN_NORMAL_##NAME,
    QN_NORMALS(N)
#undef N
    QN_NORMAL_COUNT
} qn_normal_model;

enum { QN_ANY_NORMAL = (1 << QN_NORMAL_COUNT) - 1 };

typedef enum qn_damping_model {
#define D(NAME, model, text, with, unit, meaning) QN_DAMPING_##NAME,
    QN_DAMPINGS(D)
#undef D
    QN_DAMPING_COUNT
} qn_damping_model;

typedef enum qn_cohesion_model {
#define C(NAME, model, text, with, meaning) QN_COHESION_##NAME,
    QN_COHESIONS(C)
#undef C
    QN_COHESION_COUNT
} qn_cohesion_model;

typedef enum qn_tangential_model {
#define T(NAME, model, text, with, meaning) QN_TANGENTIAL_##NAME,
    QN_TANGENTIALS(T)
#undef T
    QN_TANGENTIAL_COUNT
} qn_tangential_model;

typedef enum qn_rolling_model {
#define R(NAME, model, text, remembers, meaning) QN_ROLLING_##NAME,
    QN_ROLLINGS(R)
#undef R
    QN_ROLLING_COUNT
} qn_rolling_model;

typedef enum qn_law_name {
#define L(NAME, text, normal, damping, tangential, clips, meaning) QN_LAW_##NAME,
    QN_LAWS(L)
#undef L
    QN_LAW_COUNT
} qn_law_name;
// clang-format on

/// The models of a contact.
typedef struct qn_law {
    qn_normal_model normal;
    qn_damping_model damping;
    qn_cohesion_model cohesion;
    qn_tangential_model tangential;
    qn_rolling_model rolling;
} qn_law;

/// The law of a name, without cohesion and rolling resistance.
static inline qn_law qn_law_named(qn_law_name name)
{
    qn_law law = {QN_NORMAL_HERTZ, QN_DAMPING_NONE, QN_COHESION_NONE, QN_TANGENTIAL_NONE,
                  QN_ROLLING_NONE};
    switch (name) {
#define L(NAME, text, n, d, t, clips, meaning) \
    case QN_LAW_##NAME:                        \
        law.normal = QN_NORMAL_##n;            \
        law.damping = QN_DAMPING_##d;          \
        law.tangential = QN_TANGENTIAL_##t;    \
        break;
        QN_LAWS(L)
#undef L
    case QN_LAW_COUNT: break;
    }
    return law;
}

/// The power p of a spring whose force goes as depth^p.
static inline double qn_normal_power(qn_normal_model model)
{
    static const double powers[] = {
#define N(NAME, model, text, power, unit, meaning) power,
        QN_NORMALS(N)
#undef N
    };
    return powers[model];
}

// clang-format off
/// The word of a model in scenes.
static inline const char *qn_normal_text(qn_normal_model model)
{
#define N(NAME, name, text, power, unit, meaning) text,
    static const char *const texts[] = {QN_NORMALS(N)};
#undef N
    return texts[model];
}

static inline const char *qn_damping_text(qn_damping_model model)
{
#define D(NAME, name, text, with, unit, meaning) text,
    static const char *const texts[] = {QN_DAMPINGS(D)};
#undef D
    return texts[model];
}

static inline const char *qn_cohesion_text(qn_cohesion_model model)
{
#define C(NAME, name, text, with, meaning) text,
    static const char *const texts[] = {QN_COHESIONS(C)};
#undef C
    return texts[model];
}

static inline const char *qn_tangential_text(qn_tangential_model model)
{
#define T(NAME, name, text, with, meaning) text,
    static const char *const texts[] = {QN_TANGENTIALS(T)};
#undef T
    return texts[model];
}

static inline const char *qn_rolling_text(qn_rolling_model model)
{
#define R(NAME, name, text, remembers, meaning) text,
    static const char *const texts[] = {QN_ROLLINGS(R)};
#undef R
    return texts[model];
}
// clang-format on

/// Whether a law's damping, its cohesion and its tangential model make sense with its spring.
static inline bool qn_damping_fits(qn_law law)
{
    static const int with[] = {
#define D(NAME, model, text, springs, unit, meaning) springs,
        QN_DAMPINGS(D)
#undef D
    };
    return with[law.damping] >> law.normal & 1;
}

static inline bool qn_cohesion_fits(qn_law law)
{
    static const int with[] = {
#define C(NAME, model, text, springs, meaning) springs,
        QN_COHESIONS(C)
#undef C
    };
    return with[law.cohesion] >> law.normal & 1;
}

static inline bool qn_tangential_fits(qn_law law)
{
    static const int with[] = {
#define T(NAME, model, text, springs, meaning) springs,
        QN_TANGENTIALS(T)
#undef T
    };
    return with[law.tangential] >> law.normal & 1;
}

/// Whether a law's rolling model keeps a moment from step to step.
static inline bool qn_law_remembers_rolling(qn_law law)
{
    static const bool remembers[] = {
#define R(NAME, model, text, keeps, meaning) keeps,
        QN_ROLLINGS(R)
#undef R
    };
    return remembers[law.rolling];
}

/// The coefficients of a pair under a law. Host, once per pair of classes.
static inline qn_pair qn_law_pair(qn_law law, const qn_sides *sides)
{
    qn_pair p = {0};
    qn_sides given = *sides;
    const qn_sides *s = &given;
    p.depth_scale = 1;
    p.friction = s->friction;
    p.floor = s->clip ? 0 : -INFINITY;
    p.dt = s->dt;
    if (law.damping == QN_DAMPING_NONE) given.restitution = 1;
    switch (law.normal) {
#define N(NAME, model, text, power, unit, meaning) \
    case QN_NORMAL_##NAME: qn_##model##_normal_pair(s, &p); break;
        QN_NORMALS(N)
#undef N
    case QN_NORMAL_COUNT: break;
    }
    switch (law.damping) {
#define D(NAME, model, text, with, unit, meaning) \
    case QN_DAMPING_##NAME: qn_##model##_damping_pair(s, &p); break;
        QN_DAMPINGS(D)
#undef D
    case QN_DAMPING_COUNT: break;
    }
    switch (law.cohesion) {
#define C(NAME, model, text, with, meaning) \
    case QN_COHESION_##NAME: qn_##model##_cohesion_pair(s, &p); break;
        QN_COHESIONS(C)
#undef C
    case QN_COHESION_COUNT: break;
    }
    switch (law.tangential) {
#define T(NAME, model, text, with, meaning) \
    case QN_TANGENTIAL_##NAME: qn_##model##_tangential_pair(s, &p); break;
        QN_TANGENTIALS(T)
#undef T
    case QN_TANGENTIAL_COUNT: break;
    }
    switch (law.rolling) {
#define R(NAME, model, text, remembers, meaning) \
    case QN_ROLLING_##NAME: qn_##model##_rolling_pair(s, &p); break;
        QN_ROLLINGS(R)
#undef R
    case QN_ROLLING_COUNT: break;
    }
    return p;
}

#endif
