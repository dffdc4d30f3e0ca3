// SPDX-License-Identifier: Apache-2.0
// Speed of the step: particle-steps per second of the pilot mill's bed, on one thread and on all.
//
// The bed settles first, so that contacts are those of a charge; then rounds on one thread and on all
// processors are timed in turn, and the median of each is told with what was measured. Machines are
// noisy: compare ratios taken in one run.
//
//     build/bench_mill_step [SCENE]      one CSV table on stdout
#include "scene/scene.h"
#include "step/cpu/kernel.h"
#include "step/step.h"
#include "world/state.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { SETTLE = 20000, ROUNDS = 9, STEPS = 400 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static qn_status steps(qn_world *world, int count)
{
    for (int i = 0; i < count; i++) {
        QN_TRY(qn_step_forces(world, QN_COMMIT));
        QN_TRY(qn_step_advance(world));
    }
    return QN_OK;
}

static qn_status make(const char *path, int threads, qn_world **world)
{
    qn_def def;
    qn_messages messages = {0};
    qn_status status = qn_scene_read(path, &def, NULL, &messages);
    qn_messages_free(&messages);
    QN_TRY(status);
    QN_TRY(qn_world_create(&def, threads, world));
    return qn_step_begin(*world);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void report(const qn_world *w, double *rates, int64_t rebuilds)
{
    qsort(rates, ROUNDS, sizeof *rates, by_size);
    printf("%d,%.2f,%.3f,%g,%s,%s,%d,%.1f,%d,%.4g,%.4g,%.4g\n", w->count,
           2.0 * (double)w->ledger.contacts_now / w->count,
           (double)w->ledger.wall_contacts_now / w->count, w->dt,
           w->laws[0].tangential == QN_TANGENTIAL_MINDLIN ? "hertz-mindlin" : "other",
           qn_kernel_isa(), w->threads,
           (double)ROUNDS * STEPS / (double)(rebuilds > 0 ? rebuilds : 1), ROUNDS, rates[0],
           rates[ROUNDS / 2], rates[ROUNDS - 1]);
}

static qn_status measure(const char *path)
{
    qn_world *world[2];
    double rates[2][ROUNDS];
    int64_t rebuilds[2];
    qn_state state;
    QN_TRY(make(path, 0, &world[1]));
    QN_TRY(make(path, 1, &world[0]));
    QN_TRY(steps(world[1], SETTLE));
    QN_TRY(qn_world_export(world[1], &state));
    QN_TRY(qn_world_import(world[0], &state));
    qn_state_free(&state);
    for (int k = 0; k < 2; k++) QN_TRY(steps(world[k], STEPS));
    for (int k = 0; k < 2; k++) rebuilds[k] = world[k]->neighbours->rebuilds;
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < 2; k++) {
            double start = now();
            QN_TRY(steps(world[k], STEPS));
            rates[k][round] = (double)world[k]->count * STEPS / (now() - start);
        }
    printf("particles,contacts_per_particle,wall_contacts_per_particle,dt_s,law,isa,threads,"
           "steps_per_rebuild,rounds,slowest,median,fastest\n");
    for (int k = 0; k < 2; k++) {
        report(world[k], rates[k], world[k]->neighbours->rebuilds - rebuilds[k]);
        qn_world_destroy(world[k]);
    }
    return QN_OK;
}

int main(int argc, char **argv)
{
    qn_status status = measure(argc > 1 ? argv[1] : "scenes/pilot-mill.yaml");
    if (status != QN_OK) fprintf(stderr, "bench_mill_step: %s\n", qn_error());
    return qn_status_exit(status);
}
