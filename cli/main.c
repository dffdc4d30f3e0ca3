// SPDX-License-Identifier: Apache-2.0
// `quern`: picks the command.
#include "cli/cli.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *cli_program = "quern";

static const struct {
    const char *name;
    int (*command)(int argc, char **argv);
} commands[] = {
    {"new", cli_new},   {"check", cli_check}, {"run", cli_run},
    {"plot", cli_plot}, {"info", cli_info},   {"help", cli_help},
};

// Threads that wait for each other spin for a while before they sleep. libgomp's while is so long that
// a run whose processors are shared with anything else crawls (two threads and one busy neighbour on
// two processors: 26 s instead of 1.4 s; alone there is no difference). It reads the setting before
// main() runs, hence the program starts itself once more.
static void wait_politely(char **argv)
{
    if (getenv("GOMP_SPINCOUNT") || getenv("OMP_WAIT_POLICY")) return;
    if (setenv("GOMP_SPINCOUNT", "1000", 1) == 0) execv("/proc/self/exe", argv);
}

int main(int argc, char **argv)
{
    wait_politely(argv);
    if (argc > 0 && *argv[0]) cli_program = argv[0];
    const char *name = argc > 1 ? argv[1] : "help";
    if (!strcmp(name, "--version") || !strcmp(name, "-V")) {
        printf("quern " QN_VERSION "\n");
        return 0;
    }
    if (!strcmp(name, "--help") || !strcmp(name, "-h")) name = "help";
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        if (strcmp(commands[i].name, name)) continue;
        bool asks = argc > 2 && (!strcmp(argv[2], "--help") || !strcmp(argv[2], "-h"));
        if (asks) return cli_usage(name, false), 0;
        return argc > 1 ? commands[i].command(argc - 1, argv + 1) : cli_help(1, argv);
    }
    return cli_unknown("quern", name, "");
}
