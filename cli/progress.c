// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

#define ON_TERMINAL 0.25  // s   between lines
#define ELSEWHERE 15.0    // s

double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

progress progress_begin(const qn_world *w, int64_t end_step, bool quiet)
{
    double now = clock_now();
    return (progress){quiet, isatty(STDERR_FILENO) != 0, w->step, end_step, now, now, w->step};
}

// "3 h 05 min", "4 min 10 s" or "12 s".
static void print_left(double seconds)
{
    int64_t s = (int64_t)(seconds + 0.5);
    if (s >= 3600)
        fprintf(stderr, "%lld h %02lld min", (long long)(s / 3600), (long long)(s / 60 % 60));
    else if (s >= 60)
        fprintf(stderr, "%lld min %02lld s", (long long)(s / 60), (long long)(s % 60));
    else
        fprintf(stderr, "%lld s", (long long)s);
}

void progress_show(progress *p, const qn_world *w)
{
    double now = clock_now();
    bool last = w->step == p->end_step;
    if (p->quiet || (now - p->shown < (p->terminal ? ON_TERMINAL : ELSEWHERE) && !last)) return;
    double rate = (double)(w->step - p->shown_step) / (now - p->shown);
    double mean = (double)(w->step - p->first_step) / (now - p->started);
    fprintf(stderr, "%s%5.1f %%  %.4f s  %.3g particle-steps/s  ", p->terminal ? "\r" : "",
            100.0 * (double)w->step / (double)(p->end_step > 0 ? p->end_step : 1), qn_world_time(w),
            rate * qn_world_particles(w));
    print_left((double)(p->end_step - w->step) / (mean > 0 ? mean : 1));
    fprintf(stderr, " left%s", p->terminal ? "   " : "\n");
    p->shown = now, p->shown_step = w->step;
    if (last) progress_break(p);
}

void progress_break(progress *p)
{
    if (!p->quiet && p->terminal) fputc('\n', stderr);
}
