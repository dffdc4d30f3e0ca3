// SPDX-License-Identifier: Apache-2.0
// Cost of a contact in beds of spheres of one size, of 1:3 and of 1:10, on one thread.
//
// Each bed has classes a quarter apart in diameter and equal in mass, settled in a closed box. Rounds of
// steps of each bed are timed in turn, then rebuilds of the pair list; the medians are told. Machines are
// noisy: compare ratios taken in one run.
//
//     build/bench_sizes [SPHERES] [SKIN]      one CSV table on stdout; skin in radii of the smallest
#include "step/cpu/kernel.h"
#include "step/step.h"
#include "world/neighbours.h"
#include "world/sorter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define GRAVITY 50.0  // m/s2   so that beds settle within a minute

enum { BEDS = 3, ROUNDS = 9, STEPS = 60, REBUILDS = 4 };

static const double ratios[BEDS] = {1, 3, 10};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Sizes from 1 mm to `ratio` mm. Returns the volume (m3) of a mean sphere.
static double fill_sizes(qn_group_def *g, double ratio)
{
    double sum = 0, volume = 0;
    g->size_count = 1 + (int)ceil(log(ratio) / log(1.25) - 1e-9);
    for (int s = 0; s < g->size_count; s++) {
        g->diameter[s] = 1e-3 * (s > 0 ? pow(ratio, (double)s / (g->size_count - 1)) : 1);
        sum += g->fraction[s] = pow(g->diameter[s], -3);
    }
    for (int s = 0; s < g->size_count; s++) {
        g->fraction[s] /= sum;
        volume += g->fraction[s] * qn_ball_volume(g->diameter[s] / 2);
    }
    return volume;
}

static void add_wall(qn_def *def, qn_vec3 point, qn_vec3 normal)
{
    def->planes[def->plane_count++] =
        (qn_plane_def){.name = "wall", .point = point, .normal = normal};
}

// A column of spheres, half again as high as it is wide, loose at first.
static qn_status define(qn_def *def, int spheres, double ratio, double skin)
{
    *def = qn_def_default();
    def->material_count = def->contact_count = def->group_count = 1;
    QN_TRY(QN_ALLOCATE(def->materials, 1));
    QN_TRY(QN_ALLOCATE(def->contacts, 1));
    QN_TRY(QN_ALLOCATE(def->groups, 1));
    QN_TRY(QN_ALLOCATE(def->planes, 6));
    def->materials[0] = (qn_material_def){"glass", 256e6, 0.23, 2500};
    def->contacts[0] = (qn_contact_def){.law = qn_law_named(QN_LAW_HERTZ_MINDLIN),
                                        .friction = 0.3,
                                        .restitution = 0.3,
                                        .clip = true};
    def->gravity = qn_v3(0, -GRAVITY, 0);
    def->skin = skin, def->step = 1.6e-6;
    qn_group_def *g = &def->groups[0];
    *g = (qn_group_def){.name = "spheres", .amount = spheres, .padding = 0.02, .jitter = 0.5};
    double solid = spheres * fill_sizes(g, ratio), side = cbrt(solid / 0.6 / 1.5);
    add_wall(def, qn_v3(0, 0, 0), qn_v3(1, 0, 0));
    add_wall(def, qn_v3(side, 0, 0), qn_v3(-1, 0, 0));
    add_wall(def, qn_v3(0, 0, 0), qn_v3(0, 0, 1));
    add_wall(def, qn_v3(0, 0, side), qn_v3(0, 0, -1));
    add_wall(def, qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_wall(def, qn_v3(0, 6 * side, 0), qn_v3(0, -1, 0));
    return QN_OK;
}

static qn_status steps(qn_world *world, int count)
{
    for (int i = 0; i < count; i++) {
        QN_TRY(qn_step_forces(world, QN_COMMIT));
        QN_TRY(qn_step_advance(world));
    }
    return QN_OK;
}

// A bed at rest: the time that twice its height takes to fall through.
static qn_status settle(int spheres, double ratio, double skin, qn_world **world)
{
    qn_def def;
    QN_TRY(define(&def, spheres, ratio, skin));
    double height = 2 * def.planes[1].point.x;
    QN_TRY(qn_world_create(&def, 1, world));
    QN_TRY(qn_step_begin(*world));
    return steps(*world, (int)(sqrt(2 * height / GRAVITY) / (*world)->dt));
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static qn_status measure(int spheres, double skin)
{
    qn_world *world[BEDS];
    double step[BEDS][ROUNDS], rebuild[BEDS][ROUNDS];  // s
    for (int b = 0; b < BEDS; b++) QN_TRY(settle(spheres, ratios[b], skin, &world[b]));
    for (int round = 0; round < ROUNDS; round++)
        for (int b = 0; b < BEDS; b++) {
            double start = now();
            QN_TRY(steps(world[b], STEPS));
            step[b][round] = (now() - start) / STEPS;
            start = now();
            for (int k = 0; k < REBUILDS; k++) QN_TRY(qn_neighbours_rebuild(world[b]));
            rebuild[b][round] = (now() - start) / REBUILDS;
        }
    printf("ratio,classes,levels,particles,contacts_per_particle,pairs_per_contact,skin,isa,rounds,"
           "step_ns_per_contact_fastest,step_ns_per_contact,rebuild_ns_per_contact\n");
    for (int b = 0; b < BEDS; b++) {
        const qn_world *w = world[b];
        double contacts = (double)(w->ledger.contacts_now + w->ledger.wall_contacts_now);
        qsort(step[b], ROUNDS, sizeof(double), by_size);
        qsort(rebuild[b], ROUNDS, sizeof(double), by_size);
        printf("%g,%d,%d,%d,%.2f,%.2f,%g,%s,%d,%.1f,%.1f,%.1f\n", ratios[b], w->class_count,
               w->neighbours->sorter->level_count, w->count, contacts / w->count,
               (double)w->neighbours->shares[0].pair_count / (double)w->ledger.contacts_now,
               w->neighbours->skin / w->smallest_radius, qn_kernel_isa(), ROUNDS,
               1e9 * step[b][0] / contacts, 1e9 * step[b][ROUNDS / 2] / contacts,
               1e9 * rebuild[b][ROUNDS / 2] / contacts);
        qn_world_destroy(world[b]);
    }
    return QN_OK;
}

int main(int argc, char **argv)
{
    int spheres = argc > 1 ? atoi(argv[1]) : 4000;
    qn_status status = measure(spheres, argc > 2 ? atof(argv[2]) : 0);
    if (status != QN_OK) fprintf(stderr, "bench_sizes: %s\n", qn_error());
    return qn_status_exit(status);
}
