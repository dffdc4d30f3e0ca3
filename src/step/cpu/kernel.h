// SPDX-License-Identifier: Apache-2.0
// The inner loops of the CPU: contacts of one share, eight at a time.
//
// The folder lanes/ is compiled once per instruction set; dispatch.c picks one when the program starts.
// Contraction is off everywhere, so all of them give the same bits.
#ifndef QN_STEP_CPU_KERNEL_H
#define QN_STEP_CPU_KERNEL_H

#include "step/step.h"
#include "world/neighbours.h"

enum { QN_LANES = 8 };

/// A share's sums over this step's contacts. Energies are split into a multiple of the world's energy
/// unit and a multiple of a much smaller one before they are added, so the sums are exact and do not
/// depend on their order, and small losses in a large mill are not rounded away. (Demmel & Nguyen 2013,
/// ARITH 21, doi:10.1109/ARITH.2013.9, sum likewise.)
typedef struct qn_tally_sums {
    double energy[QN_TALLY_COUNT][QN_LANES];  // J   multiples of the energy unit
    double remainder[QN_TALLY_COUNT]
                    [QN_LANES];  // J   what that leaves, in units 2^26 times smaller
    double deepest;              // 1   in radii of the smaller sphere
    int64_t contacts, wall_contacts;
    int64_t (
        *part)[4];  //     force and torque of each part, in the world's quanta; behind the sums
} qn_tally_sums;

/// Allocates what a share's contacts are worked on in, once: two blocks that go with the share.
QN_NODISCARD qn_status qn_kernel_prepare(const qn_world *world, qn_share *share);

/// Adds this step's contacts of a share, with particles and with walls, to the loads of its own
/// particles and to its spill; updates histories unless only probing. Runs on one thread. QN_MEMORY
/// if the list of wall contacts cannot grow.
QN_NODISCARD qn_status qn_kernel_contacts(qn_world *world, qn_share *share, const qn_pose *pose,
                                          qn_mode mode);

/// Name of the instruction set in use: "base", "v3" or "v4" (x86-64 levels). The environment
/// variable QUERN_ISA asks for one.
const char *qn_kernel_isa(void);

#endif
