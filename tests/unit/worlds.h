// SPDX-License-Identifier: Apache-2.0
// Small worlds made by hand for the core's tests.
#ifndef QN_TESTS_WORLDS_H
#define QN_TESTS_WORLDS_H

#include "step/step.h"
#include "world/classes.h"
#include "world/neighbours.h"
#include "world/state.h"
#include "world/timestep.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// Glass (0) and a liner (1), softened, with one law for all pairs.
static inline qn_def def_of_materials(qn_law_name law, double friction, double restitution)
{
    qn_def def = qn_def_default();
    def.gravity = qn_v3(0, -9.81, 0);
    def.seed = 1;
    def.material_count = 2;
    def.materials = calloc(2, sizeof *def.materials);
    def.materials[0] = (qn_material_def){"glass", 64e6, 0.23, 2500};
    def.materials[1] = (qn_material_def){"liner", 64e6, 0.42, 950};
    def.contact_count = 3;
    def.contacts = calloc(3, sizeof *def.contacts);
    for (int i = 0; i < 3; i++)
        def.contacts[i] = (qn_contact_def){.material_a = i / 2,
                                           .material_b = (i + 1) / 2,
                                           .law = qn_law_named(law),
                                           .friction = friction,
                                           .restitution = restitution,
                                           .stiffness = 1e4,
                                           .impact_speed = 1,
                                           .tangential_ratio = 2.0 / 7,
                                           .rolling_friction = 0.1,
                                           .rolling_damping = 0.3,
                                           .clip = true};
    return def;
}

/// Adds a group of one size; returns it to be completed.
static inline qn_group_def *add_group(qn_def *def, const char *name, double diameter)
{
    size_t n = (size_t)def->group_count++;
    def->groups = realloc(def->groups, (n + 1) * sizeof *def->groups);
    qn_group_def *g = &def->groups[n];
    memset(g, 0, sizeof *g);
    snprintf(g->name, sizeof g->name, "%s", name);
    g->size_count = 1;
    g->diameter[0] = diameter;
    g->fraction[0] = 1;
    g->padding = 0.02;
    return g;
}

/// Adds one ball at a place; returns its group.
static inline qn_group_def *add_ball(qn_def *def, double diameter, qn_vec3 at, qn_vec3 velocity)
{
    qn_group_def *g = add_group(def, "ball", diameter);
    g->packing = QN_PACK_LIST;
    g->list_count = 1;
    g->list_position = malloc(3 * sizeof(double));
    g->list_position[0] = at.x, g->list_position[1] = at.y, g->list_position[2] = at.z;
    g->velocity = velocity;
    return g;
}

/// Adds a clump's shape; returns its number, for a group's `shape`.
static inline int add_shape(qn_def *def, const double *centres, const double *radii, int count)
{
    double radius;
    size_t n = (size_t)def->shape_count++;
    def->shapes = realloc(def->shapes, (n + 1) * sizeof *def->shapes);
    if (qn_shape_of(centres, radii, count, &def->shapes[n], &radius) != QN_OK)
        printf("  %s\n", qn_error());
    return (int)n + 1;
}

/// Adds a plane of liner through a point.
static inline void add_plane(qn_def *def, const char *name, qn_vec3 point, qn_vec3 normal)
{
    size_t n = (size_t)def->plane_count++;
    def->planes = realloc(def->planes, (n + 1) * sizeof *def->planes);
    def->planes[n] = (qn_plane_def){.material = 1, .point = point, .normal = normal};
    snprintf(def->planes[n].name, sizeof def->planes[n].name, "%s", name);
}

/// A closed box of side `side` (m) with a corner at the origin.
static inline void add_box(qn_def *def, double side)
{
    add_plane(def, "x0", qn_v3(0, 0, 0), qn_v3(1, 0, 0));
    add_plane(def, "x1", qn_v3(side, 0, 0), qn_v3(-1, 0, 0));
    add_plane(def, "y0", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_plane(def, "y1", qn_v3(0, side, 0), qn_v3(0, -1, 0));
    add_plane(def, "z0", qn_v3(0, 0, 0), qn_v3(0, 0, 1));
    add_plane(def, "z1", qn_v3(0, 0, side), qn_v3(0, 0, -1));
}

/// A drum of liner, periodic or closed by ends of liner; it stands still, without lifters.
static inline qn_drum_def drum_of(double diameter, double length, qn_ends ends)
{
    return (qn_drum_def){.present = true,
                         .name = "drum",
                         .diameter = diameter,
                         .length = length,
                         .ends = ends,
                         .material = 1,
                         .end_material = 1};
}

/// Puts `count` lifters of a height and widths at top and base (m) into a drum.
static inline void add_lifters(qn_drum_def *drum, int count, double height, double top, double base)
{
    drum->lifter_count = count;
    drum->lifter_height = height;
    drum->lifter_top = top;
    drum->lifter_base = base;
}

/// Lets a drum turn at `speed` (rad/s), at once and for ever.
static inline void turn_at(qn_drum_def *drum, double speed)
{
    drum->leg_count = 1;
    drum->legs[0] = (qn_leg){INFINITY, speed, speed};
}

/// A slice of a 60 mm mill with lifters, turning at once at 12 rad/s, with `count` balls of 3 mm, under
/// ten times gravity so that the loose packing is a bed within a few hundred steps.
static inline qn_def def_of_mill(int count, qn_ends ends)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    def.contacts[0].law.rolling = QN_ROLLING_CONSTANT, def.contacts[0].rolling_friction = 0.01;
    qn_group_def *g = add_group(&def, "balls", 0.003);
    g->amount = count;
    g->jitter = 0.5;
    def.gravity = qn_v3(0, -98.1, 0);
    def.drum = drum_of(0.06, 0.0125, ends);
    add_lifters(&def.drum, 8, 0.003, 0.003, 0.004);
    turn_at(&def.drum, 12);
    def.step = 1e-5;
    return def;
}

/// `steps` whole steps; QN_OK or what stopped them.
static inline qn_status take_steps(qn_world *world, int steps)
{
    for (int i = 0; i < steps; i++) {
        QN_TRY(qn_step_forces(world, QN_COMMIT));
        QN_TRY(qn_step_advance(world));
    }
    return QN_OK;
}

/// Hash of the state, or 0 on failure.
static inline uint64_t hash_of(const qn_world *world)
{
    qn_state state;
    if (qn_world_export(world, &state) != QN_OK) return 0;
    uint64_t hash = qn_state_hash(&state);
    qn_state_free(&state);
    return hash;
}

/// Work of all walls, and all losses, up to the last whole step (J).
static inline double work_of(const qn_world *world)
{
    double work = 0;
    for (int p = 0; p < world->ledger.part_count; p++) work += world->ledger.work[p];
    return work;
}

static inline double lost_of(const qn_world *world)
{
    double lost = 0;
    for (int e = 0; e < QN_LOSS_COUNT; e++) lost += world->ledger.lost[e];
    return lost;
}

#endif
