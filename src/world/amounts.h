// SPDX-License-Identifier: Apache-2.0
// How many spheres of each size a group has.
#ifndef QN_WORLD_AMOUNTS_H
#define QN_WORLD_AMOUNTS_H

#include "world/walls.h"

/// Numbers of each size of a packed group. By count: in the proportions of its fractions, each rounded,
/// adding up to the count. By mass or filling: from the largest size to the smallest, each takes up
/// what rounding has left over, so that the mass is met to half a sphere of the smallest size.
/// counts: group->size_count, filled here.
void qn_amounts_of(const qn_def *def, const qn_group_def *group, const qn_walls *walls,
                   int64_t *counts);

#endif
