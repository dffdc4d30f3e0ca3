// SPDX-License-Identifier: Apache-2.0
// A world put together by hand, for tests of what only looks at one: a drum of 100 mm, 20 mm long,
// around balls that lie and move as the test says. Nothing in it can be stepped.
#ifndef QN_TESTS_FAKE_MILL_H
#define QN_TESTS_FAKE_MILL_H

#include "world/world.h"

#include <stdlib.h>
#include <string.h>

enum { FAKE_ROOM = 1 << 18 };

static inline double fake_uniform(uint64_t *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) * 0x1p-53;
}

/// One class of `radius`; voxels and ring are laid out for balls of `largest`.
static inline qn_world *fake_mill(int lifters, double speed, double radius, double largest)
{
    qn_world *w = calloc(1, sizeof *w);
    w->def.drum = (qn_drum_def){.present = true,
                                .name = "drum",
                                .diameter = 0.1,
                                .length = 0.02,
                                .ends = QN_ENDS_FIXED,
                                .lifter_count = lifters,
                                .lifter_height = 0.004,
                                .lifter_top = 0.004,
                                .lifter_base = 0.004,
                                .leg_count = 1,
                                .legs = {{INFINITY, speed, speed}}};
    if (lifters == 0) w->def.drum.lifter_height = 0;
    if (qn_walls_build(&w->def, radius, &w->walls) != QN_OK) abort();
    w->dt = 1e-3;
    w->gravity = qn_v3(0, -9.81, 0);
    w->class_count = 1;
    w->classes = calloc(1, sizeof *w->classes);
    double mass = 2500 * 4.0 / 3 * QN_PI * radius * radius * radius;
    w->classes[0] = (qn_class){.grain = -1,
                               .radius = radius,
                               .bound = radius,
                               .volume = mass / 2500,
                               .least_mass = mass,
                               .mass = mass,
                               .inertia = 0.4 * mass * radius * radius,
                               .inverse_mass = 1 / mass,
                               .inverse_inertia = 1 / (0.4 * mass * radius * radius),
                               .force_unit = 0x1p-60,
                               .torque_unit = 0x1p-70};
    w->largest_radius = largest;
    w->smallest_radius = radius;
    w->energy_unit = 0x1p-50;
    w->threads = 2;
    w->place = calloc(FAKE_ROOM, sizeof *w->place);
    w->motion = calloc(FAKE_ROOM, sizeof *w->motion);
    w->load = calloc(FAKE_ROOM, sizeof *w->load);
    w->ledger.part_count = w->walls.part_count;
    w->ledger.work = calloc((size_t)w->walls.part_count, sizeof(double));
    w->ledger.impulse = calloc((size_t)w->walls.part_count, sizeof(double));
    w->ledger.torque_now = calloc((size_t)w->walls.part_count, sizeof(double));
    w->ledger.power_now = calloc((size_t)w->walls.part_count, sizeof(double));
    w->ledger.push = calloc((size_t)(3 * w->walls.part_count), sizeof(double));
    w->ledger.force_now = calloc((size_t)(3 * w->walls.part_count), sizeof(double));
    return w;
}

static inline void fake_free(qn_world *w)
{
    qn_walls_free(&w->walls);
    free(w->classes), free(w->place), free(w->motion), free(w->load);
    free(w->ledger.work), free(w->ledger.impulse), free(w->ledger.torque_now);
    free(w->ledger.power_now), free(w->ledger.push), free(w->ledger.force_now);
    free(w);
}

/// Adds a ball with `velocity` at the present step.
static inline void fake_add(qn_world *w, double x, double y, double z, qn_vec3 velocity)
{
    int i = w->count++;
    w->place[i] = (qn_place){x, y, z, 0, i};
    w->motion[i].velocity = qn_madd(velocity, -0.5 * w->dt, w->gravity);
}

/// Random balls anywhere in the drum, with random velocities and spins.
static inline void fake_fill(qn_world *w, int count)
{
    uint64_t s = 7;
    while (w->count < count) {
        double x = fake_uniform(&s, -0.05, 0.05), y = fake_uniform(&s, -0.05, 0.05);
        double z = fake_uniform(&s, 0, 0.02);
        if (hypot(x, y) > 0.049) continue;
        w->motion[w->count].spin = qn_v3(fake_uniform(&s, -9, 9), 3, fake_uniform(&s, -9, 9));
        double u = fake_uniform(&s, -1, 1), v = fake_uniform(&s, -1, 1);
        fake_add(w, x, y, z, qn_v3(u, v, fake_uniform(&s, -1, 1)));
    }
}

/// Turns the order of the balls around.
static inline void fake_reverse(qn_world *w)
{
    for (int i = 0, j = w->count - 1; i < j; i++, j--) {
        qn_place place = w->place[i];
        qn_motion motion = w->motion[i];
        w->place[i] = w->place[j], w->place[j] = place;
        w->motion[i] = w->motion[j], w->motion[j] = motion;
    }
}

#endif
