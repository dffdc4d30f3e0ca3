// SPDX-License-Identifier: Apache-2.0
// The progress of a run: one line that is rewritten on a terminal, a plain line now and then elsewhere.
#ifndef QN_CLI_PROGRESS_H
#define QN_CLI_PROGRESS_H

#include "world/world.h"

typedef struct progress {
    bool quiet, terminal;
    int64_t first_step, end_step;
    double started, shown;  // s   clock
    int64_t shown_step;
} progress;

/// Seconds of a clock that never jumps.
double clock_now(void);

progress progress_begin(const qn_world *world, int64_t end_step, bool quiet);

/// Shows percent, simulated time, particle-steps per second and time left, if it is time to.
void progress_show(progress *p, const qn_world *world);

/// Ends the line that is being rewritten, so that something else can be printed.
void progress_break(progress *p);

#endif
