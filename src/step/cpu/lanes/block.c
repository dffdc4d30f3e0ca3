// SPDX-License-Identifier: Apache-2.0
// The operations of a contact (physics/contact.h) over a block of eight, each in a loop of its own
// that the compiler runs side by side. Compiled once per instruction set, with QN_ISA naming it.
//
// One loop per model: whatever models the scene puts together, each runs as fast as any. (A lane is a
// function of its own so that its structures stay in registers: inside an omp simd loop they would
// become arrays.)
#include "step/cpu/lanes/block.h"

static inline __attribute__((always_inline)) qn_approach approach_at(const block *b, int l)
{
    qn_approach a;
    a.normal = GET(b->normal, l);
    a.depth = b->depth[l], a.before = b->before[l];
    a.root = b->root[l], a.fourth = b->fourth[l];
    a.rate = b->rate[l];
    a.arm_a = b->arm_a[l], a.arm_b = b->arm_b[l];
    a.held = GET(b->held, l), a.advance = GET(b->advance, l);
    a.slide = GET(b->slide, l);
    a.roll = GET(b->held_roll, l);
    a.turn = GET(b->turn, l);
    a.rolling = GET(b->rolling, l);
    return a;
}

QN_FN qn_approach lane_approach(const qn_pair *p, const qn_reach *g, block *b, int l)
{
    qn_touch t;
    t.between = GET(b->between, l);
    t.velocity = GET(b->velocity, l);
    t.kick = GET(b->kick, l);
    t.spin_a = GET(b->spin_a, l);
    t.spin_b = GET(b->spin_b, l);
    t.spin_kick_a = GET(b->spin_kick_a, l);
    t.spin_kick_b = GET(b->spin_kick_b, l);
    t.memory.slip = GET(b->slip, l);
    t.memory.roll = GET(b->roll, l);
    t.last = GET(b->last, l);
    qn_approach a = qn_approach_of(p, g, &t);
    PUT(b->normal, l, a.normal);
    b->depth[l] = a.depth, b->before[l] = a.before;
    b->root[l] = a.root, b->fourth[l] = a.fourth;
    b->rate[l] = a.rate;
    b->arm_a[l] = a.arm_a, b->arm_b[l] = a.arm_b;
    PUT(b->held, l, a.held);
    PUT(b->advance, l, a.advance);
    PUT(b->slide, l, a.slide);
    PUT(b->rolling, l, a.rolling);
    return a;
}

// Where no rolling model remembers, what only they read is left out by the compiler.
static __attribute__((noinline)) void block_approach(const qn_pair *pair, const qn_reach *reach,
                                                     block *b)
{
    const qn_pair p = *pair;
    const qn_reach g = *reach;
#pragma omp simd
    for (int l = 0; l < W; l++) (void)lane_approach(&p, &g, b, l);
}

static __attribute__((noinline)) void block_approach_rolling(const qn_pair *pair,
                                                             const qn_reach *reach, block *b)
{
    const qn_pair p = *pair;
    const qn_reach g = *reach;
#pragma omp simd
    for (int l = 0; l < W; l++) {
        qn_approach a = lane_approach(&p, &g, b, l);
        PUT(b->held_roll, l, a.roll);
        PUT(b->turn, l, a.turn);
    }
}

// block_KIND_MODEL: one model's loop, made of lane_KIND_MODEL.
#define BLOCK(kind, model)                                                                      \
    static __attribute__((noinline)) void block_##kind##_##model(const qn_pair *pair, block *b) \
    {                                                                                           \
        const qn_pair p = *pair;                                                                \
        _Pragma("omp simd") for (int l = 0; l < W; l++) lane_##kind##_##model(&p, b, l);        \
    }

// clang-format off
#define N(NAME, model, text, power, unit, meaning)                              \
    QN_FN void lane_normal_##model(const qn_pair *p, block *b, int l)           \
    {                                                                           \
        qn_approach a = approach_at(b, l);                                      \
        qn_normal f = qn_##model##_normal(p, &a);                               \
        b->elastic[l] = f.elastic;                                              \
        b->stored[l] = f.energy;                                                \
    }                                                                           \
    BLOCK(normal, model)
QN_NORMALS(N)
#undef N

#define D(NAME, model, text, with, unit, meaning)                               \
    QN_FN void lane_damping_##model(const qn_pair *p, block *b, int l)          \
    {                                                                           \
        qn_approach a = approach_at(b, l);                                      \
        double damping = qn_##model##_damping(p, &a, b->elastic[l]);            \
        b->damping[l] = damping;                                                \
        b->push[l] = qn_contact_push(p, b->elastic[l], damping);                \
    }                                                                           \
    BLOCK(damping, model)
QN_DAMPINGS(D)
#undef D

#define C(NAME, model, text, with, meaning)                                     \
    QN_FN void lane_cohesion_##model(const qn_pair *p, block *b, int l)         \
    {                                                                           \
        qn_approach a = approach_at(b, l);                                      \
        qn_cohesion c = qn_##model##_cohesion(p, &a);                           \
        b->pull[l] = c.pull;                                                    \
        b->stored_pull[l] = c.energy;                                           \
    }                                                                           \
    BLOCK(cohesion, model)
QN_COHESIONS(C)
#undef C

#define T(NAME, model, text, with, meaning)                                     \
    QN_FN void lane_tangential_##model(const qn_pair *p, block *b, int l)       \
    {                                                                           \
        qn_approach a = approach_at(b, l);                                      \
        double limit = p->friction * fabs(b->push[l]);                          \
        qn_tangential s = qn_##model##_tangential(p, &a, limit);                \
        PUT(b->friction, l, s.force);                                           \
        PUT(b->next_slip, l, s.slip);                                           \
        b->stored_tangential[l] = s.energy;                                     \
        b->lost_dashpot[l] = s.lost_dashpot;                                    \
        b->lost_sliding[l] = s.lost_sliding;                                    \
        b->residue[l] = s.residue;                                              \
    }                                                                           \
    BLOCK(tangential, model)
QN_TANGENTIALS(T)
#undef T

#define R(NAME, model, text, remembers, meaning)                                \
    QN_FN void lane_rolling_##model(const qn_pair *p, block *b, int l)          \
    {                                                                           \
        qn_approach a = approach_at(b, l);                                      \
        qn_rolling m = qn_##model##_rolling(p, &a, b->elastic[l]);              \
        PUT(b->torque, l, m.torque);                                            \
        PUT(b->next_roll, l, m.kept);                                           \
    }                                                                           \
    BLOCK(rolling, model)
QN_ROLLINGS(R)
#undef R
// clang-format on

QN_FN void lane_reply(const qn_pair *p, block *b, int l)
{
    qn_approach a = approach_at(b, l);
    qn_normal f;
    qn_cohesion c;
    qn_tangential s;
    qn_rolling m;
    qn_reply r;
    f.elastic = b->elastic[l], f.energy = b->stored[l];
    c.pull = b->pull[l], c.energy = b->stored_pull[l];
    s.force = GET(b->friction, l), s.slip = GET(b->next_slip, l);
    s.energy = b->stored_tangential[l];
    s.lost_dashpot = b->lost_dashpot[l], s.lost_sliding = b->lost_sliding[l];
    s.residue = b->residue[l];
    m.torque = GET(b->torque, l), m.kept = GET(b->next_roll, l);
    qn_contact_reply(p, &a, f, b->damping[l], b->push[l], c, s, m, &r);
    PUT(b->force, l, qn_madd(r.tangential, r.push, r.normal));
    PUT(b->torque_a, l, r.torque_a);
    PUT(b->torque_b, l, r.torque_b);
    b->energy[QN_TALLY_NORMAL][l] = r.lost_normal;
    b->energy[QN_TALLY_TANGENTIAL][l] = r.lost_tangential;
    b->energy[QN_TALLY_SLIDING][l] = r.lost_sliding;
    b->energy[QN_TALLY_ROLLING][l] = r.lost_rolling;
    b->energy[QN_TALLY_RESIDUE][l] = r.residue;
    b->energy[QN_TALLY_ELASTIC_NORMAL][l] = r.stored_normal;
    b->energy[QN_TALLY_ELASTIC_TANGENTIAL][l] = r.stored_tangential;
}

static __attribute__((noinline)) void block_reply(const qn_pair *pair, block *b)
{
    const qn_pair p = *pair;
#pragma omp simd
    for (int l = 0; l < W; l++) lane_reply(&p, b, l);
}

// clang-format off
void JOIN(qn_block_evaluate, QN_ISA)(qn_law law, const qn_pair *pair, const qn_reach *reach, block *b)
{
    if (qn_law_remembers_rolling(law))
        block_approach_rolling(pair, reach, b);
    else
        block_approach(pair, reach, b);
    switch (law.normal) {
#define N(NAME, model, text, power, unit, meaning) case QN_NORMAL_##NAME: block_normal_##model(pair, b); break;
        QN_NORMALS(N)
#undef N
    case QN_NORMAL_COUNT: break;
    }
    switch (law.damping) {
#define D(NAME, model, text, with, unit, meaning) case QN_DAMPING_##NAME: block_damping_##model(pair, b); break;
        QN_DAMPINGS(D)
#undef D
    case QN_DAMPING_COUNT: break;
    }
    switch (law.cohesion) {
#define C(NAME, model, text, with, meaning) case QN_COHESION_##NAME: block_cohesion_##model(pair, b); break;
        QN_COHESIONS(C)
#undef C
    case QN_COHESION_COUNT: break;
    }
    switch (law.tangential) {
#define T(NAME, model, text, with, meaning) case QN_TANGENTIAL_##NAME: block_tangential_##model(pair, b); break;
        QN_TANGENTIALS(T)
#undef T
    case QN_TANGENTIAL_COUNT: break;
    }
    switch (law.rolling) {
#define R(NAME, model, text, remembers, meaning) case QN_ROLLING_##NAME: block_rolling_##model(pair, b); break;
        QN_ROLLINGS(R)
#undef R
    case QN_ROLLING_COUNT: break;
    }
    block_reply(pair, b);
}
// clang-format on
