// SPDX-License-Identifier: Apache-2.0
// The commands of the program. Each gets its own name as argv[0], prints what it has to say, and
// returns the exit code.
#ifndef QN_CLI_CLI_H
#define QN_CLI_CLI_H

#include "base/error.h"

#include <stdbool.h>

/// The name the program was called by, for lines a person may copy.
extern const char *cli_program;

int cli_run(int argc, char **argv);
int cli_check(int argc, char **argv);
int cli_new(int argc, char **argv);
int cli_plot(int argc, char **argv);
int cli_info(int argc, char **argv);
int cli_help(int argc, char **argv);

/// Draws the pictures of a run folder at the end of a run; the exit code of the script.
int cli_plot_run(const char *folder);

/// Says that there is no such command, or word of `more`, with the nearest there is; the exit code.
int cli_unknown(const char *who, const char *word, const char *more);

/// Prints the help of a command (or of all, for NULL or an unknown one) to stdout or stderr.
void cli_usage(const char *command, bool is_error);

#endif
