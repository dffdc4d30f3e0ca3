// SPDX-License-Identifier: Apache-2.0
// From a block's numbers to sums that do not depend on their order: loads as integers, energies in two
// exact parts.
#ifndef QN_STEP_CPU_LANES_SUMS_H
#define QN_STEP_CPU_LANES_SUMS_H

#include "step/cpu/lanes/block.h"

// Forces and torques as integers: side 0 feels the force, side 1 its opposite.
static inline void quantise(block *b, const qn_class *a, const qn_class *other)
{
    const double *force[3] = {b->force.x, b->force.y, b->force.z};
    const double *torque[2][3] = {{b->torque_a.x, b->torque_a.y, b->torque_a.z},
                                  {b->torque_b.x, b->torque_b.y, b->torque_b.z}};
    const qn_class *side[2] = {a, other};
    for (int s = 0; s < 2 && side[s]; s++) {
        double per_force = (s ? -1 : 1) / side[s]->force_unit;
        double per_torque = 1 / side[s]->torque_unit;
        for (int axis = 0; axis < 3; axis++)
            for (int l = 0; l < W; l++) {
                b->load[s][axis][l] = (int64_t)(force[axis][l] * per_force);
                b->load[s][3 + axis][l] = (int64_t)(torque[s][axis][l] * per_torque);
            }
    }
}

static inline void add_load(qn_load *to, const block *b, int side, int l)
{
    for (int axis = 0; axis < 3; axis++) {
        to->force[axis] += b->load[side][axis][l];
        to->torque[axis] += b->load[side][3 + axis][l];
    }
}

// Adds the first `count` lanes' energies, split into multiples of two units: adding and taking off a
// number so large that no smaller bits survive rounds to a multiple, hence these are sums of integers.
static inline void tally(const qn_world *w, qn_tally_sums *sums, const block *b, int count,
                         double radius)
{
    double coarse = 1.5 * 0x1p52 * w->energy_unit, fine = coarse * 0x1p-26, deepest = 0;
    for (int e = 0; e < QN_TALLY_COUNT; e++)
        for (int l = 0; l < count; l++) {
            double units = (b->energy[e][l] + coarse) - coarse;
            sums->energy[e][l] += units;
            sums->remainder[e][l] += ((b->energy[e][l] - units) + fine) - fine;
        }
    for (int l = 0; l < count; l++) deepest = qn_max(deepest, b->depth[l]);
    sums->deepest = qn_max(sums->deepest, deepest / radius);
}

#endif
