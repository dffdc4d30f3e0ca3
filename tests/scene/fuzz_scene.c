// SPDX-License-Identifier: Apache-2.0
// libFuzzer target of the scene reader: any text gives a definition or messages, never a crash. What
// it accepts must also be read again from its own resolved form. Files that a scene names are not
// read here.
#include "scene/scene.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static bool is_whole(const qn_def *def)
{
    for (int i = 0; i < def->group_count; i++)
        if (def->groups[i].list_count > 1) return false;
    return def->mesh_count == 0 && def->drum.profile_count == 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    qn_def def;
    qn_messages messages = {0};
    qn_status status =
        qn_scene_read_text((const char *)data, size, "fuzz.yaml", NULL, &def, &messages);
    if ((status == QN_OK) != (messages.errors == 0)) abort();
    if (status != QN_OK && !messages.text) abort();
    qn_messages_free(&messages);
    if (status != QN_OK) return 0;
    char *text;
    if (qn_scene_resolved(&def, &text) != QN_OK) abort();
    bool whole = is_whole(&def);
    qn_def_free(&def);
    status = qn_scene_read_text(text, strlen(text), "resolved.yaml", NULL, &def, &messages);
    if (whole && status != QN_OK) abort();
    qn_def_free(&def);
    qn_messages_free(&messages);
    free(text);
    return 0;
}
