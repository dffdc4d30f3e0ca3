// SPDX-License-Identifier: Apache-2.0
// The sizes of a world's particles, as `quern check` tells them.
#ifndef QN_CLI_SIZES_H
#define QN_CLI_SIZES_H

#include "record/json.h"
#include "world/world.h"

/// Prints a table of the groups that have more than one size: diameter, number, share of the group's
/// mass, share of its mass that is not larger. Nothing where there is none.
void cli_sizes_print(const qn_world *world);

/// Adds the same to a JSON document, for all groups.
void cli_sizes_put(qn_json *json, const qn_world *world);

#endif
