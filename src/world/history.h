// SPDX-License-Identifier: Apache-2.0
// The history of contacts on its way from one pair list to the next, and to and from a checkpoint.
//
// Between rebuilds history lives beside the pairs (neighbours.h). At a rebuild it is collected by the
// owner of each touching pair, the particles are sorted, and every new pair takes its own back. The owner
// is the smaller of the two, of equals the one with the lower id: at most some 14 spheres as large as
// itself can touch a sphere, so its row is short, while a large ball may touch thousands of small ones.
// qn_neighbours_contacts(), _wall_contacts() and _restore() are here too.
#ifndef QN_WORLD_HISTORY_H
#define QN_WORLD_HISTORY_H

#include "world/world.h"

/// Collects the history of the list in use, in rows by the present index of the lower id. What a
/// restore has left waiting stays as it is.
QN_NODISCARD qn_status qn_history_collect(qn_world *world);

/// Collects the history for a world whose particles come and go before the next list: `to` is the new
/// index of each present one, -1 for those that go, `count` how many there will be. Contacts of those
/// that go are dropped.
QN_NODISCARD qn_status qn_history_move(qn_world *world, const int32_t *to, int64_t count);

/// What a pair of particles remembers, as collected, by their new indices in either order; false if it
/// was not touching.
bool qn_history_find(const qn_world *world, int a, int b, qn_memory *memory);

#endif
