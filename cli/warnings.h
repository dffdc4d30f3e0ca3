// SPDX-License-Identifier: Apache-2.0
// What `quern check` and `quern run` both say of a scene that can run but perhaps should not.
#ifndef QN_CLI_WARNINGS_H
#define QN_CLI_WARNINGS_H

#include "scene/forecast.h"

/// Writes the warnings, a line each, to `text`; returns it. Empty where there is nothing to say.
const char *cli_warnings(const qn_world *world, const qn_forecast *forecast, char *text,
                         size_t room);

/// Prints what qn_world_create() said of a scene, with the place in the scene it points to; returns
/// `status`.
qn_status cli_blame(const char *path, qn_status status);

#endif
