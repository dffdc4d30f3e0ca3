// SPDX-License-Identifier: Apache-2.0
// What `quern check` and `quern run` both say of a scene that can run but perhaps should not.
#ifndef QN_CLI_WARNINGS_H
#define QN_CLI_WARNINGS_H

#include "scene/forecast.h"

enum { CLI_WARNINGS_MAX = 16384 };  // room for the warnings

/// Writes the warnings, and notes on the meshes, a line each, to `text`; returns it. Empty where there is nothing to say.
const char *cli_warnings(const qn_world *world, const qn_forecast *forecast, char *text,
                         size_t room);

/// Prints the error that begins with a key of a scene (qn_world_create(), qn_scene_continues()), with the
/// place of that key in the scene's text; returns `status`.
qn_status cli_blame(const char *path, const char *text, qn_status status);

#endif
