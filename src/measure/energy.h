// SPDX-License-Identifier: Apache-2.0
// The energy balance of one step, and what else takes one pass over the particles.
//
// Everything is told of step n itself: velocities from qn_velocity_now(), half of this step's losses
// and work on top of the ledger's totals. Sums over particles are 128-bit integer sums with quanta
// derived from the world, so they do not depend on order or threads. Particles that are fixed do
// not count, except as partners of contacts.
#ifndef QN_MEASURE_ENERGY_H
#define QN_MEASURE_ENERGY_H

#include "world/world.h"

typedef struct qn_balance {
    double kinetic_translation, kinetic_rotation, gravity;  // J
    double elastic_normal, elastic_tangential;              // J
    double stored;                                          // J     the five together
    double work;                   // J     done by the walls on the particles, up to step n
    double lost;                   // J     all losses up to step n, the Mindlin residue included
    double brought, taken;         // J     by particles that feeds gave and outlets took
    double mean_speed, max_speed;  // m/s   0 without particles that move
    qn_vec3 centre;                // m     centre of mass of what moves; 0 without
} qn_balance;

/// Work (J) a part has done on the particles, its torque times time (N m s), and its force along an axis
/// (0 to 2) times time (N s), up to step n.
double qn_part_work(const qn_world *world, int part);
double qn_part_impulse(const qn_world *world, int part);
double qn_part_push(const qn_world *world, int part, int axis);

/// Work (J) of all parts that turn with the drum.
double qn_drive_work(const qn_world *world);

/// The balance of the present step. QN_UNSTABLE where a velocity or position is not finite or beyond
/// what the sums hold. Cost: O(particles).
QN_NODISCARD qn_status qn_balance_now(const qn_world *world, qn_balance *balance);

/// Joules unaccounted for since a first balance: work + brought - taken - change of stored - lost.
double qn_balance_residual(const qn_balance *now, const qn_balance *first);

/// Turnover (J) that a residual is compared with: the largest of work, losses, change of gravity's
/// energy, and what was kinetic and elastic at first and is now.
double qn_balance_turnover(const qn_balance *now, const qn_balance *first);

#endif
