// SPDX-License-Identifier: Apache-2.0
// `quern help`: what the commands do, and the reference of scenes.
#include "cli/cli.h"

#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// clang-format off
//    name     arguments                          in one line
#define COMMANDS(C)                                                                                          \
    C("new",   "[mill|drop]",                     "print a commented scene that runs",                       \
      "  quern new mill > my-mill.yaml\n")                                                                   \
    C("check", "SCENE [--json]",                  "say what a scene will do, before a single step",          \
      "  --json   the same numbers as JSON\n\n"                                                              \
      "Derived numbers, time step, coefficients of each pair, and estimates of wall time, memory and disk.\n" \
      "What is wrong with the scene comes with line and column; the exit code is then 2.\n")                 \
    C("run",   "SCENE [-o DIR] [--threads N] [--until SPAN] [--steps N] [--resume] [--force] [--quiet] [--no-pictures]", \
                                                  "run a scene into a folder",                               \
      "  -o DIR        run folder, instead of the scene's own\n"                                             \
      "  --threads N   as many threads; all processors if not given\n"                                       \
      "  --until SPAN  end of the run, from its start, such as '2 s' or '3 rev'\n"                           \
      "  --steps N     the same in time steps\n"                                                             \
      "  --resume      go on from the last checkpoint in the folder\n"                                       \
      "  --force       replace what is in the folder\n"                                                      \
      "  --quiet       no progress line\n"                                                                   \
      "  --no-pictures draw none at the end; 'quern plot' can do so later\n\n"                               \
      "Ctrl-C finishes the step and writes a checkpoint. A finished run can be resumed for longer.\n")       \
    C("plot",  "DIR [--format KIND] [--dpi N] [-o FOLDER] [--quiet]",                                        \
                                                  "draw pictures from the recordings of a run",              \
      "  --format KIND  png, pdf or svg; png if not given\n"                                                 \
      "  --dpi N        pixels per inch of a png; 300 if not given\n"                                        \
      "  -o FOLDER      where to put the pictures, instead of DIR/pictures\n"                                \
      "  --quiet        say nothing but errors\n")                                                           \
    C("info",  "DIR|FILE",                        "say what is in a run folder, checkpoint, frame or mesh",  \
      "")                                                                                                    \
    C("help",  "[COMMAND|PART|scene [--markdown]]", "explain a command, a part of a scene such as drum, or every key", \
      "")
// clang-format on

static const struct {
    const char *name, *arguments, *line, *more;
} commands[] = {
#define C(name, arguments, line, more) {name, arguments, line, more},
    COMMANDS(C)
#undef C
};

enum { COMMAND_COUNT = sizeof commands / sizeof *commands };

void cli_usage(const char *command, bool is_error)
{
    FILE *out = is_error ? stderr : stdout;
    for (int i = 0; command && i < COMMAND_COUNT; i++)
        if (!strcmp(commands[i].name, command)) {
            fprintf(out, "usage: quern %s %s\n", commands[i].name, commands[i].arguments);
            if (!is_error) fprintf(out, "\n%s.\n\n%s", commands[i].line, commands[i].more);
            return;
        }
    fprintf(out, "Quern " QN_VERSION ", a simulator of tumbling mills\n\n");
    for (int i = 0; i < COMMAND_COUNT; i++)
        fprintf(out, "  quern %-6s %s\n", commands[i].name, commands[i].line);
    fprintf(out,
            "\n'quern help COMMAND' says more; 'quern help scene' lists every key of a scene,\n"
            "'quern help drum' and the like those of a part.\n");
}

static int print_reference(const char *part, bool markdown)
{
    char *text;
    qn_status status = qn_scene_reference(part, markdown, &text);
    if (status != QN_OK) {
        fprintf(stderr, "quern help: %s\n", qn_error());
        return qn_status_exit(status);
    }
    fputs(text, stdout);
    free(text);
    return qn_status_exit(QN_OK);
}

static bool is_command(const char *name)
{
    for (int i = 0; i < COMMAND_COUNT; i++)
        if (!strcmp(commands[i].name, name)) return true;
    return false;
}

int cli_unknown(const char *who, const char *word, const char *more)
{
    char nearest[64], names[512] = "";
    for (int i = 0; i < COMMAND_COUNT; i++)
        strcat(strcat(names, " "), commands[i].name);  // the list above: it fits
    size_t used = strlen(names);
    snprintf(names + used, sizeof names - used, " %s", more);
    bool like = qn_nearest_word(word, names, nearest, sizeof nearest);
    fprintf(stderr, "%s: there is no command '%s'%s%s%s\n", who, word,
            like ? "; did you mean '" : "", like ? nearest : "", like ? "'?" : "");
    cli_usage(NULL, true);
    return qn_status_exit(QN_INPUT);
}

int cli_help(int argc, char **argv)
{
    const char *topic = argc > 1 ? argv[1] : NULL;
    bool scene = topic && !strcmp(topic, "scene");
    bool markdown = scene && argc > 2 && !strcmp(argv[2], "--markdown");
    if (argc > 2 + markdown) {
        fprintf(stderr, "quern help: '%s' is one word too many\n", argv[2 + markdown]);
        cli_usage("help", true);
        return qn_status_exit(QN_INPUT);
    }
    if (scene) return print_reference(NULL, markdown);
    if (topic && !is_command(topic) && qn_scene_has_part(topic))
        return print_reference(topic, false);
    if (topic && !is_command(topic)) return cli_unknown("quern help", topic, qn_scene_parts());
    cli_usage(topic, false);
    return qn_status_exit(QN_OK);
}
