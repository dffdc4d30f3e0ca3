// SPDX-License-Identifier: Apache-2.0
// One time step, as a short list of named operations.
//
//     forces    rebuild the list if some particle may have left its skin; contacts and walls -> loads
//     (what observes looks here: positions, velocities and forces of step n are all at hand)
//     advance   kick, drift, settle the ledger, n -> n + 1; outlets take, feeds give (flow.h)
//
// Leapfrog: v(n+1/2) = v(n-1/2) + a(n) dt, x(n+1) = x(n) + v(n+1/2) dt; other schemes: physics/scheme.h.
#ifndef QN_STEP_STEP_H
#define QN_STEP_STEP_H

#include "world/world.h"

/// Puts a new world's velocities half a step back, from v(0) to v(-1/2), where the leapfrog wants them.
/// Once for a new world, before anything is stepped or written; nothing for one that has begun.
QN_NODISCARD qn_status qn_step_begin(qn_world *world);

/// Whether the evaluation of forces also moves the contacts' history on.
typedef enum qn_mode {
    QN_COMMIT,  // as part of a step
    QN_PROBE,  // only to look: the state stays as it is, so that a run can end here and go on later
} qn_mode;

/// Loads of the present step from contacts and walls. QN_UNSTABLE if a guard speaks (overlap, a value
/// that is not finite, a particle outside): the sentence names particle, time, cause and remedy.
QN_NODISCARD qn_status qn_step_forces(qn_world *world, qn_mode mode);

/// Moves the world one step on with the loads of qn_step_forces(world, QN_COMMIT).
QN_NODISCARD qn_status qn_step_advance(qn_world *world);

/// Visits every contact of one particle at the present step, with all its parts, for traces; between
/// qn_step_forces() and qn_step_advance(). The reply's normal points towards that particle and its
/// tangential force acts on it; `partner` is an id, or -1 - part for a wall; energies lost in the step
/// are not told. Cost: O(pairs).
typedef void qn_contact_visit(void *user, int64_t id, int64_t partner, const qn_reply *reply,
                              qn_vec3 point);
QN_NODISCARD qn_status qn_step_visit(qn_world *world, int64_t id, qn_contact_visit *visit,
                                     void *user);

#endif
