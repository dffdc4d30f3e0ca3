// SPDX-License-Identifier: Apache-2.0
// What the contact kernel works in: queues of contacts, and a block of eight laid out in columns.
#ifndef QN_STEP_CPU_BLOCK_H
#define QN_STEP_CPU_BLOCK_H

#include "step/cpu/kernel.h"

enum { W = QN_LANES };

// Eight contacts of one pair of classes waiting for each other.
typedef struct queue {
    int count;
    int a[W], b[W];      // indices; b unused for a wall
    int64_t slot[W];     // pair of the share, or its wall contact of this step
    qn_wall_hit hit[W];  // walls only
} queue;

// One number of each of eight contacts; a vector of each.
typedef double column[W];
typedef struct columns3 {
    column x, y, z;
} columns3;

// A block as the law sees it: what goes in and what comes out, lane by lane.
typedef struct block {
    columns3 between, velocity, kick, spin_a, spin_b, spin_kick_a, spin_kick_b, slip;
    columns3 force, torque_a, torque_b, rolling, normal, next_slip;
    column depth, energy[QN_TALLY_COUNT];
    int64_t load[2][6][W];
} block;

// What the kernel needs beside a share's lists: one block, the queues behind it.
typedef struct workspace {
    block block;
    queue *pairs;  // [class_a * class_count + class_b]
    queue *walls;  // [surface * class_count + class]
} workspace;

#endif
