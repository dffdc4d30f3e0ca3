// SPDX-License-Identifier: Apache-2.0
// Particles that come and go between two steps.
#ifndef QN_WORLD_POPULATION_H
#define QN_WORLD_POPULATION_H

#include "world/pack.h"

/// Takes the particles out for which gone[index] holds (NULL for none) and adds `fresh_count` others with
/// ids from `first_id`. Clumps can neither come nor go. The others keep their contacts' history, the
/// pair list is rebuilt before the next step. Indices change.
QN_NODISCARD qn_status qn_population_change(qn_world *world, const bool *gone,
                                            const qn_seedling *fresh, int fresh_count,
                                            int64_t first_id);

/// Makes room for `wanted` particles and images in the world's records.
QN_NODISCARD qn_status qn_population_reserve(qn_world *world, int64_t wanted);

#endif
