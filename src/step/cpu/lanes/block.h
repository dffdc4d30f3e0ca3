// SPDX-License-Identifier: Apache-2.0
// What the contact kernel works in: queues of contacts, and a block of eight laid out in columns.
//
// This folder is compiled once per instruction set; public names end with QN_ISA, and dispatch.c picks one
// when the program starts.
#ifndef QN_STEP_CPU_LANES_BLOCK_H
#define QN_STEP_CPU_LANES_BLOCK_H

#include "step/cpu/kernel.h"

#define JOIN_(a, b) a##_##b
#define JOIN(a, b) JOIN_(a, b)
#ifndef QN_ISA
#define QN_ISA base
#endif

#define GET(columns, l) qn_v3((columns).x[l], (columns).y[l], (columns).z[l])
#define PUT(columns, l, v)       \
    do {                         \
        qn_vec3 put_ = (v);      \
        (columns).x[l] = put_.x; \
        (columns).y[l] = put_.y; \
        (columns).z[l] = put_.z; \
    } while (0)

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

// A block as the operations of a contact (contact.h) see it, lane by lane: what goes in, what each
// hands to the next, what comes out.
typedef struct block {
    columns3 between, velocity, kick, spin_a, spin_b, spin_kick_a, spin_kick_b, slip, roll, last;

    columns3 normal, held, advance, slide, held_roll, turn, rolling;  // qn_approach
    column depth, before, root, fourth, rate, arm_a, arm_b;
    column elastic, stored, damping, push, pull, stored_pull;
    columns3 friction, next_slip, torque, next_roll;  // qn_tangential, qn_rolling
    column stored_tangential, lost_dashpot, lost_sliding, residue;

    columns3 force, torque_a, torque_b;
    column energy[QN_TALLY_COUNT];
    int64_t load[2][6][W];
} block;

// Evaluates the eight contacts of a block, one operation after the other.
void JOIN(qn_block_evaluate, QN_ISA)(qn_law law, const qn_pair *pair, const qn_reach *reach,
                                     block *b);

// A pair found to touch, side a the one with the lower id.
typedef struct found_pair {
    int32_t a, b;
    int64_t slot;  // pair of the share
} found_pair;

enum { FOUND = 1024 };  // found before they are worked on

// What the kernel needs beside a share's lists: one block, the queues behind it.
typedef struct workspace {
    block block;
    found_pair found[FOUND + 1];
    queue *pairs;  // [class_a * class_count + class_b]
    queue *walls;  // [surface * class_count + class]
} workspace;

// The contacts of a share between particles, and with walls, added to its loads and sums (kernel.h).
void JOIN(qn_lanes_pairs, QN_ISA)(qn_world *world, qn_share *share, qn_mode mode);
qn_status JOIN(qn_lanes_touches, QN_ISA)(qn_world *world, qn_share *share, const qn_pose *pose,
                                         qn_mode mode);

#endif
