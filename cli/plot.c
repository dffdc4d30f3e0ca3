// SPDX-License-Identifier: Apache-2.0
// `quern plot`: runs the plotting script of this build or installation with Python.
//
// The script is looked for beside the program: in the source tree for a program that was built and
// not installed, in share/quern of the prefix for an installed one. Python is Debian's, which has
// the modules, or else whatever `python3` is on PATH. Pictures are a service: nothing that goes
// wrong here makes a run fail.
#include <errno.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/cli.h"

extern char **environ;

enum {
    PATH_ROOM = 4096,
    ARGUMENTS_MAX = 32,  // what is handed on to the script
    NO_PLOT = 3,         // exit code where the script or Python is missing; that of QN_IO
};

static const char *const script_places[] = {
    "/../share/quern/quern_plot.py",
    "/plot/quern_plot.py",
    "/../plot/quern_plot.py",
};

/// The folder this program is in; false where the system does not tell.
static bool program_folder(char *folder, size_t room)
{
    ssize_t length = readlink("/proc/self/exe", folder, room - 1);
    if (length <= 0) return false;
    folder[length] = 0;
    char *last = strrchr(folder, '/');
    if (!last) return false;
    *last = 0;
    return true;
}

static bool find_script(char *script, size_t room)
{
    char folder[PATH_ROOM];
    if (!program_folder(folder, sizeof folder)) return false;
    for (size_t i = 0; i < sizeof script_places / sizeof *script_places; i++) {
        int length = snprintf(script, room, "%s%s", folder, script_places[i]);
        if (length > 0 && (size_t)length < room && access(script, R_OK) == 0) return true;
    }
    return false;
}

/// Starts Python; 0, or the reason (errno) why there is none.
static int start_python(char **arguments, pid_t *child)
{
    int error = posix_spawn(child, "/usr/bin/python3", NULL, NULL, arguments, environ);
    if (error == ENOENT) error = posix_spawnp(child, "python3", NULL, NULL, arguments, environ);
    return error;
}

static int wait_for(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return NO_PLOT;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs the script with `count` arguments and returns its exit code.
static int run_script(int count, char **given)
{
    char script[PATH_ROOM];
    char python[] = "python3", no_bytecode[] = "-B";
    char *arguments[ARGUMENTS_MAX + 4] = {python, no_bytecode, script};
    if (count > ARGUMENTS_MAX) {
        fprintf(stderr, "quern plot: %d arguments are too many, at most %d\n", count,
                ARGUMENTS_MAX);
        return 2;
    }
    if (!find_script(script, sizeof script)) {
        fprintf(stderr,
                "quern plot: the plotting script quern_plot.py is neither in share/quern of "
                "this installation nor in the plot folder beside this build\n");
        return NO_PLOT;
    }
    for (int i = 0; i < count; i++) arguments[3 + i] = given[i];
    fflush(NULL);
    pid_t child;
    int error = start_python(arguments, &child);
    if (error) {
        fprintf(stderr,
                "quern plot: Python can't be started (%s); on Debian: apt install python3 "
                "python3-numpy python3-matplotlib python3-h5py\n",
                strerror(error));
        return NO_PLOT;
    }
    return wait_for(child);
}

int cli_plot(int argc, char **argv)
{
    return run_script(argc - 1, argv + 1);
}

int cli_plot_run(const char *folder)
{
    char copy[PATH_ROOM];
    int length = snprintf(copy, sizeof copy, "%s", folder);
    if (length < 0 || (size_t)length >= sizeof copy) return NO_PLOT;
    char *given[] = {copy};
    return run_script(1, given);
}
