// SPDX-License-Identifier: Apache-2.0
// `quern new`: prints a commented scene that runs.
#include "cli/cli.h"

#include "scene/scene.h"

#include <stdio.h>
#include <string.h>

int cli_new(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "mill";
    const char *text = argc <= 2 ? qn_scene_template(name) : NULL;
    if (text) {
        fputs(text, stdout);
        return qn_status_exit(QN_OK);
    }
    char nearest[64];
    if (argc > 2)
        fprintf(stderr, "quern new: '%s' is one word too many\n", argv[2]);
    else if (qn_nearest_word(name, qn_scene_template_names(), nearest, sizeof nearest))
        fprintf(stderr, "quern new: there is no template '%s'; did you mean '%s'?\n", name,
                nearest);
    else
        fprintf(stderr, "quern new: there is no template '%s'\n", name);
    cli_usage("new", true);
    return qn_status_exit(QN_INPUT);
}
