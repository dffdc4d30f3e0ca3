// SPDX-License-Identifier: Apache-2.0
// Guards: numerical trouble stops the run with the particle, the time, the cause and the remedy.
//
// What is checked every step is one number (the deepest overlap, the fastest particle); who it was
// is looked for only when it is too large.
#ifndef QN_STEP_GUARDS_H
#define QN_STEP_GUARDS_H

#include "world/world.h"

/// QN_UNSTABLE if some overlap of this step is above QN_OVERLAP_STOP; keeps the
/// ledger's deepest overlap.
QN_NODISCARD qn_status qn_guard_overlap(qn_world *world);

/// QN_UNSTABLE, naming the first particle (lowest id) that is faster than `limit` (m/s) or not finite.
QN_NODISCARD qn_status qn_guard_speed(const qn_world *world, double limit);

#endif
