// SPDX-License-Identifier: Apache-2.0
// The history of contacts on its way from one pair list to the next, and to and from a checkpoint.
//
// Between rebuilds history lives beside the pairs (neighbours.h). At a rebuild it is collected by the
// lower id of each touching pair, the particles are sorted, and every new pair takes its own back.
// qn_neighbours_contacts(), _wall_contacts() and _restore() are here too.
#ifndef QN_WORLD_HISTORY_H
#define QN_WORLD_HISTORY_H

#include "world/world.h"

/// Collects the history of the list in use, in rows by the present index of the lower id. What a
/// restore has left waiting stays as it is.
QN_NODISCARD qn_status qn_history_collect(qn_world *world);

/// What a pair remembers, as collected, by the new index of its lower id and the higher id; false
/// if the pair was not touching.
bool qn_history_find(const qn_world *world, int low, int64_t high_id, qn_memory *memory);

#endif
