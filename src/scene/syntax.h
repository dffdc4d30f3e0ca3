// SPDX-License-Identifier: Apache-2.0
// Mistakes in YAML, in plain words.
#ifndef QN_SCENE_SYNTAX_H
#define QN_SCENE_SYNTAX_H

#include "scene/messages.h"

/// Says what is probably wrong with a text that libyaml could not read, and where.
///
/// @param problem  libyaml's own words
/// @param mark     where it was noticed
/// @param context  where what it was reading began; line 0 if it does not say
qn_mark qn_syntax_explain(const qn_source *source, const char *problem, qn_mark mark,
                          qn_mark context, char *sentence, size_t size);

#endif
