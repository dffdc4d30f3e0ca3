// SPDX-License-Identifier: Apache-2.0
// The energy ledger: where energy comes from, where it is, where it went.
//
//     work = change of (kinetic + rotational + gravity + elastic) + losses + residue
//
// Losses and work are running totals since step 0, added every step; stored energies are counted
// when asked for. Each step's sums are sums of integers (multiples of a quantum), so they do not
// depend on threads or list order; the totals add them in the order of the steps.
#ifndef QN_WORLD_LEDGER_H
#define QN_WORLD_LEDGER_H

#include "base/array.h"

// clang-format off
//    NAME           name             unit  meaning
#define QN_LOSSES(C)                                                                          \
    C(NORMAL,        lost_normal,     "J",  "lost to normal dashpots, the clip included")     \
    C(TANGENTIAL,    lost_tangential, "J",  "lost to tangential dashpots")                    \
    C(SLIDING,       lost_sliding,    "J",  "lost to sliding friction")                       \
    C(ROLLING,       lost_rolling,    "J",  "lost to rolling resistance")                     \
    C(RESIDUE,       mindlin_residue, "J",  "lost by the Mindlin spring as its stiffness changes")
#define QN_STORED(C)                                                                          \
    C(ELASTIC_NORMAL,     elastic_normal,     "J", "stored in normal springs")                \
    C(ELASTIC_TANGENTIAL, elastic_tangential, "J", "stored in tangential springs")
// clang-format on

// clang-format off
typedef enum qn_tally {
#define C(NAME, name, unit, meaning) QN_TALLY_##NAME,
    QN_LOSSES(C)
    QN_STORED(C)
#undef C
    QN_TALLY_COUNT,
    QN_LOSS_COUNT = QN_TALLY_ELASTIC_NORMAL,
} qn_tally;
// clang-format on

/// Energies and work of the run so far. A part is a piece of wall whose work is told separately
/// (shell, each lifter, each end, each mesh; walls.h).
typedef struct qn_ledger {
    double lost[QN_LOSS_COUNT];  // J     up to step n - 1/2
    double now[QN_TALLY_COUNT];  // J     this step's losses, and what is stored at step n
    int part_count;
    // Of each part on the particles; torques about the line its body turns about, else about z. The
    // first three are totals up to n - 1/2, the others of step n; all owned.
    double *work;                             // J
    double *impulse;                          // N m s torque times time
    double *push;                             // N s   force times time, x y z of each part
    double *torque_now;                       // N m
    double *force_now;                        // N     x y z of each part
    double *power_now;                        // W
    int64_t contacts_now, wall_contacts_now;  // touching at step n
    double deepest_now;  // 1     largest overlap at step n, in radii of the smaller sphere
    double deepest;      // 1     largest overlap so far
    int64_t deepest_step;
} qn_ledger;

/// The total of a loss up to step n itself: half of this step's is counted, as velocities of step n
/// are half way through its kick.
static inline double qn_ledger_lost(const qn_ledger *ledger, int loss)
{
    return ledger->lost[loss] + 0.5 * ledger->now[loss];
}

#endif
