// SPDX-License-Identifier: Apache-2.0
// Cost of mesh walls: the same layer of balls on floors of more and more triangles.
//
// A layer of balls of 3 mm rests in a box of 120 mm whose floor is a plane, or a mesh: of the box's own
// size, cut finer and finer, or of triangles of one size, reaching further and further beyond the box.
// Rounds on all floors are timed in turn on one thread; medians are told. Machines are noisy: compare
// ratios taken in one run.
//
//     build/bench_mesh_step      one CSV table on stdout
#include "step/cpu/kernel.h"
#include "step/step.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SETTLE = 3000, ROUNDS = 9, STEPS = 300, FLOORS = 7, ROWS = 38 };

static const double SIDE = 0.12;  // m   of the box

static const struct {
    const char *kind;
    int cells;      // squares along a side; 0 for a plane
    double extent;  // m   of the floor
} floors[FLOORS] = {{"plane", 0, 0.12},       {"refined", 1, 0.12},   {"refined", 22, 0.12},
                    {"refined", 71, 0.12},    {"refined", 224, 0.12}, {"extended", 22, 0.12},
                    {"extended", 224, 1.2218}};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void add_plane(qn_def *def, const char *name, qn_vec3 point, qn_vec3 normal)
{
    qn_plane_def *p = &def->planes[def->plane_count++];
    *p = (qn_plane_def){.material = 0, .point = point, .normal = normal};
    snprintf(p->name, sizeof p->name, "%s", name);
}

/// A sheet of n x n squares in y = 0 around the middle of the box, each cut in two.
static void add_sheet(qn_def *def, int n, double extent)
{
    int side = n + 1;
    double low = 0.5 * (SIDE - extent);
    qn_mesh_def *m = &def->meshes[def->mesh_count++];
    *m = (qn_mesh_def){.name = "floor", .vertex_count = side * side, .triangle_count = 2 * n * n};
    m->vertices = calloc((size_t)(3 * side * side), sizeof(double));
    m->triangles = calloc((size_t)(6 * n * n), sizeof(int));
    for (int i = 0; i < side * side; i++) {
        m->vertices[3 * i] = low + extent * (i % side) / n;
        m->vertices[3 * i + 2] = low + extent * (double)(i / side) / n;
    }
    for (int k = 0; k < n * n; k++) {
        int a = k / n * side + k % n, *t = &m->triangles[6 * k];
        const int at[6] = {a, a + 1, a + side + 1, a + side + 1, a + side, a};
        memcpy(t, at, sizeof at);
    }
}

static qn_status make(int which, qn_world **world)
{
    qn_def def = qn_def_default();
    def.material_count = def.contact_count = def.group_count = 1;
    def.materials = calloc(1, sizeof *def.materials);
    def.materials[0] = (qn_material_def){"glass", 64e6, 0.23, 2500};
    def.contacts = calloc(1, sizeof *def.contacts);
    def.contacts[0] = (qn_contact_def){.law = qn_law_named(QN_LAW_HERTZ_MINDLIN),
                                       .friction = 0.3,
                                       .restitution = 0.5,
                                       .clip = true};
    def.planes = calloc(6, sizeof *def.planes);
    def.meshes = calloc(1, sizeof *def.meshes);
    add_plane(&def, "x0", qn_v3(0, 0, 0), qn_v3(1, 0, 0));
    add_plane(&def, "x1", qn_v3(SIDE, 0, 0), qn_v3(-1, 0, 0));
    add_plane(&def, "z0", qn_v3(0, 0, 0), qn_v3(0, 0, 1));
    add_plane(&def, "z1", qn_v3(0, 0, SIDE), qn_v3(0, 0, -1));
    add_plane(&def, "top", qn_v3(0, 0.0032, 0), qn_v3(0, -1, 0));
    if (floors[which].cells > 0)
        add_sheet(&def, floors[which].cells, floors[which].extent);
    else
        add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    def.groups = calloc(1, sizeof *def.groups);
    def.groups[0] = (qn_group_def){.name = "balls",
                                   .size_count = 1,
                                   .diameter = {0.003},
                                   .fraction = {1},
                                   .packing = QN_PACK_LIST,
                                   .list_count = ROWS * ROWS,
                                   .list_position = calloc(3 * ROWS * ROWS, sizeof(double))};
    for (int i = 0; i < ROWS * ROWS; i++) {
        double *x = &def.groups[0].list_position[3 * i], pitch = SIDE / ROWS;
        x[0] = (i % ROWS + 0.5) * pitch, x[1] = 0.0015, x[2] = (i / ROWS + 0.5) * pitch;
    }
    def.step = 1e-5;
    QN_TRY(qn_world_create(&def, 1, world));
    return qn_step_begin(*world);
}

static qn_status steps(qn_world *world, int count)
{
    for (int i = 0; i < count; i++) {
        QN_TRY(qn_step_forces(world, QN_COMMIT));
        QN_TRY(qn_step_advance(world));
    }
    return QN_OK;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static qn_status measure(void)
{
    static double cost[FLOORS][ROUNDS];  // ns   per particle and step
    qn_world *world[FLOORS];
    double built[FLOORS];  // s
    for (int k = 0; k < FLOORS; k++) {
        double start = now();
        QN_TRY(make(k, &world[k]));
        built[k] = now() - start;
        QN_TRY(steps(world[k], SETTLE));
    }
    for (int r = 0; r < ROUNDS; r++)
        for (int k = 0; k < FLOORS; k++) {
            double start = now();
            QN_TRY(steps(world[k], STEPS));
            cost[k][r] = 1e9 * (now() - start) / STEPS / world[k]->count;
        }
    printf("floor,triangles,cells,listed,particles,wall_contacts_per_particle,isa,built_s,rounds,"
           "min_ns,median_ns,max_ns\n");
    for (int k = 0; k < FLOORS; k++) {
        const qn_world *w = world[k];
        qsort(cost[k], ROUNDS, sizeof *cost[k], by_size);
        const qn_mesh *m = w->walls.mesh_count ? &w->walls.meshes[0] : NULL;
        int cells = m ? m->cells[0] * m->cells[1] * m->cells[2] : 0;
        printf("%s,%d,%d,%d,%d,%.2f,%s,%.2f,%d,%.4g,%.4g,%.4g\n", floors[k].kind,
               m ? m->triangle_count : 0, cells, m ? m->cell_start[cells] : 0, w->count,
               (double)w->ledger.wall_contacts_now / w->count, qn_kernel_isa(), built[k], ROUNDS,
               cost[k][0], cost[k][ROUNDS / 2], cost[k][ROUNDS - 1]);
        qn_world_destroy(world[k]);
    }
    return QN_OK;
}

int main(void)
{
    if (measure() == QN_OK) return 0;
    fprintf(stderr, "bench_mesh_step: %s\n", qn_error());
    return 1;
}
