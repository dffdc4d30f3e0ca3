// SPDX-License-Identifier: Apache-2.0
// The state of a world in the order of its ids: what is written to a checkpoint and hashed.
//
// One list of fields names every array with its type, width, unit and meaning; files and their
// documentation are made from it. Nothing here depends on how a backend sorts or packs.
#ifndef QN_WORLD_STATE_H
#define QN_WORLD_STATE_H

#include "world/world.h"

// clang-format off
//    type     name        width unit     meaning
#define QN_PARTICLE_FIELDS(F)                                                                  \
    F(int64_t, id,         1,    "1",     "persistent number of the particle, from 1")         \
    F(int32_t, klass,      1,    "1",     "index of its class")                                \
    F(double,  position,   3,    "m",     "centre, at step n")                                 \
    F(double,  velocity,   3,    "m/s",   "of the centre, at step n - 1/2")                    \
    F(double,  spin,       3,    "rad/s", "at step n - 1/2")                                   \
    F(double,  kick,       3,    "m/s",   "half the velocity change of the last step")         \
    F(double,  spin_kick,  3,    "rad/s", "half the spin change of the last step")
#define QN_CONTACT_FIELDS(F)                                                                   \
    F(int64_t, low,        1,    "1",     "id of the particle with the lower id")              \
    F(int64_t, high,       1,    "1",     "id of the other")                                   \
    F(double,  slip,       3,    "m",     "tangential displacement of the lower against the other") \
    F(double,  roll,       3,    "N m",   "moment of the rolling spring on the lower")
#define QN_WALL_CONTACT_FIELDS(F)                                                              \
    F(int64_t, wall_id,      1,  "1",     "id of the particle")                                \
    F(int32_t, wall_feature, 1,  "1",     "number of the wall feature it touches")             \
    F(double,  wall_slip,    3,  "m",     "tangential displacement against the wall")          \
    F(double,  wall_roll,    3,  "N m",   "moment of the rolling spring")                      \
    F(double,  wall_normal,  3,  "1",     "from the wall to the particle, at the last step")
#define QN_BODY_FIELDS(F)                                                                      \
    F(int64_t, body_id,          1, "1",     "of a clump: that of its first sphere")           \
    F(int32_t, body_grain,       1, "1",     "index of its grain, a shape in one size")        \
    F(double,  body_position,    3, "m",     "centre of mass, at step n")                      \
    F(double,  body_orientation, 4, "1",     "quaternion w x y z from principal axes to space, at step n") \
    F(double,  body_velocity,    3, "m/s",   "of the centre of mass, at step n - 1/2")         \
    F(double,  body_spin,        3, "rad/s", "at step n - 1/2")                                \
    F(double,  body_momentum,    3, "N m s", "angular momentum about the centre, at step n - 1/2") \
    F(double,  body_kick,        3, "m/s",   "half the velocity change of the last step")      \
    F(double,  body_spin_kick,   3, "rad/s", "from spin to the spin predicted for step n")      \
    F(double,  body_momentum_kick, 3, "N m s", "half the change of the last step")
// clang-format on

typedef struct qn_state {
    int64_t step;
    int64_t count, contact_count, wall_contact_count, body_count;
#define F(type, name, width, unit, meaning) type *name;  // owned
    QN_PARTICLE_FIELDS(F) QN_CONTACT_FIELDS(F) QN_WALL_CONTACT_FIELDS(F) QN_BODY_FIELDS(F)
#undef F
} qn_state;

/// Allocates the arrays of a state for the counts already in it.
QN_NODISCARD qn_status qn_state_allocate(qn_state *state);
void qn_state_free(qn_state *state);

/// Copies the world's state out, sorted by id (contacts by low, then high; wall contacts by id, then
/// feature). Valid between steps. Cost: O(n log n).
QN_NODISCARD qn_status qn_world_export(const qn_world *world, qn_state *state);

/// Puts a state, which must belong to the same definition, in place of the world's own: the world
/// then goes on bit for bit as the one it was exported from. The ledger's totals are restored
/// separately (they are plain numbers). QN_INPUT where ids repeat or a class does not exist.
QN_NODISCARD qn_status qn_world_import(qn_world *world, const qn_state *state);

/// 64-bit hash of a state: every bit of every field, contact history included.
uint64_t qn_state_hash(const qn_state *state);

#endif
