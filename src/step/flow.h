// SPDX-License-Identifier: Apache-2.0
// Feeds and outlets at work, as parts of qn_step_advance().
//
// An outlet looks at step n, when velocities of n are at hand, and books what leaves with all its energy,
// that of its contacts included; it is gone from step n + 1 on. A feed acts at step n + 1, on the places
// of its region that are free then; what finds none waits. Both look every so many steps, counted from
// step 0, so that a resumed run does the same. Sizes are drawn by the seed and the number of the particle,
// places within a region by the seed and the step.
#ifndef QN_STEP_FLOW_H
#define QN_STEP_FLOW_H

#include "world/flow.h"

/// Marks what leaves at the present step and books it. After qn_step_forces(), before anything moves.
QN_NODISCARD qn_status qn_flow_look(qn_world *world);

/// Takes out what is marked and puts in what is due. At the end of a step.
QN_NODISCARD qn_status qn_flow_act(qn_world *world);

/// Elastic energy (J) of all contacts of the marked particles, in whole multiples of `unit` (J).
int64_t qn_flow_stored(const qn_world *world, const bool *marked, double unit);

#endif
