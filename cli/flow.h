// SPDX-License-Identifier: Apache-2.0
// Feeds and outlets in `quern check`: what will come in, and what may leave.
#ifndef QN_CLI_FLOW_H
#define QN_CLI_FLOW_H

#include "record/json.h"
#include "world/world.h"

/// "feeds" and "outlets", one entry by name for each.
void cli_flow_put(qn_json *json, const qn_world *world);

/// A line for each.
void cli_flow_print(const qn_world *world);

#endif
