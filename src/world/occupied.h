// SPDX-License-Identifier: Apache-2.0
// Space that spheres already take, for putting further ones beside them.
//
// Cells by levels of size, as in the sorter: each level has cells as wide as its largest sphere, and a
// new sphere looks in all levels. With a period, images are looked for across both ends.
#ifndef QN_WORLD_OCCUPIED_H
#define QN_WORLD_OCCUPIED_H

#include "base/array.h"
#include "physics/vec3.h"

enum { QN_OCCUPIED_LEVELS = 8 };

typedef struct qn_occupied_level {
    double radius,
        inverse_cell;  // m, 1/m   largest sphere, at least; cells are twice as wide or more
    int cells[3];
    int32_t *first;  //  of each cell, -1 for none; owned
} qn_occupied_level;

typedef struct qn_occupied {
    qn_vec3 low, high;                             // m
    double period;                                 // m   along z; 0 for none
    double largest;                                // m   radius
    qn_occupied_level levels[QN_OCCUPIED_LEVELS];  //  largest first
    int32_t count;
    int64_t room, next_room;
    struct {
        qn_vec3 centre;
        double radius;
    } * spheres;    //  owned
    int32_t *next;  //  in the same cell, -1 for none; owned
} qn_occupied;

/// Empty space between low and high for up to `expected` spheres (more may come; they are only found
/// more slowly) with radii up to `largest`. `period` is that along z from low.z, or 0. Its arrays are
/// owned by it; release with qn_occupied_free(), also after a failure.
QN_NODISCARD qn_status qn_occupied_create(qn_occupied *o, qn_vec3 low, qn_vec3 high, double period,
                                          double largest, int64_t expected);
void qn_occupied_free(qn_occupied *o);

/// Removes all spheres, keeping the memory.
void qn_occupied_clear(qn_occupied *o);

/// Adds a sphere, wherever it is.
QN_NODISCARD qn_status qn_occupied_add(qn_occupied *o, qn_vec3 centre, double radius);

/// Whether a sphere would touch none. Cost: that of the cells around it.
bool qn_occupied_is_free(const qn_occupied *o, qn_vec3 centre, double radius);

#endif
