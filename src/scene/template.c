// SPDX-License-Identifier: Apache-2.0
// The commented scenes that `quern new` prints; each is a file template_<name>.yaml, embedded by the
// build as qn_template_<name>.
#include "scene/scene.h"

#include <string.h>

#define TEMPLATES(T) T(mill) T(drop)

#define T(name) extern const char qn_template_##name[];
TEMPLATES(T)
#undef T

const char *qn_scene_template(const char *name)
{
#define T(known) \
    if (!strcmp(name, #known)) return qn_template_##known;
    TEMPLATES(T)
#undef T
    return NULL;
}

const char *qn_scene_template_names(void)
{
#define T(name) #name " "
    return TEMPLATES(T);
#undef T
}
