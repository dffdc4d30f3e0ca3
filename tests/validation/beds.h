// SPDX-License-Identifier: Apache-2.0
// Beds of a few hundred to a few thousand balls between two smooth panes, for silo and heap.
#ifndef QN_TESTS_BEDS_H
#define QN_TESTS_BEDS_H

#include "worlds.h"

#include "base/random.h"

/// Balls (material 0) between panes (material 2, smooth) at z = 0 and `thickness` (m); walls of material 1.
/// All are soft, so that a step is long.
static inline qn_def bed_def(double friction, double wall_friction, double thickness)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, friction, 0.5);
    def.material_count = 3;
    def.materials = realloc(def.materials, 3 * sizeof *def.materials);
    def.materials[0].youngs_modulus = def.materials[1].youngs_modulus = 5e6;
    def.materials[2] = def.materials[1];
    snprintf(def.materials[2].name, sizeof def.materials[2].name, "pane");
    def.contacts[1].friction = wall_friction;
    def.contacts[2].material_a = 0, def.contacts[2].material_b = 2, def.contacts[2].friction = 0;
    add_plane(&def, "front", qn_v3(0, 0, 0), qn_v3(0, 0, 1));
    add_plane(&def, "back", qn_v3(0, 0, thickness), qn_v3(0, 0, -1));
    def.planes[0].material = def.planes[1].material = 2;
    return def;
}

/// Adds `count` balls of diameter d in a grid that is a little loose and disturbed, from x = 0 to `width`, from z =
/// 0 to `thickness`, layer on layer from y = `low`.
static inline void bed_fill(qn_def *def, double d, int count, double width, double thickness,
                            double low)
{
    int nx = (int)(width / (1.08 * d)), nz = (int)(thickness / (1.08 * d));
    qn_group_def *g = add_ball(def, d, qn_v3(0, 0, 0), qn_v3(0, -0.2, 0));
    g->list_count = count;
    g->list_position = realloc(g->list_position, (size_t)(3 * count) * sizeof(double));
    for (int i = 0; i < count; i++) {
        const int cell[3] = {i % nx, i / nx / nz, i / nx % nz};
        const double pitch[3] = {width / nx, 1.08 * d, thickness / nz};
        for (int axis = 0; axis < 3; axis++) {
            double jitter = qn_random(1, (uint64_t)axis, (uint64_t)i) - 0.5;
            g->list_position[3 * i + axis] =
                (axis == 1 ? low : 0) + (cell[axis] + 0.5) * pitch[axis] + 0.06 * d * jitter;
        }
    }
}

#endif
