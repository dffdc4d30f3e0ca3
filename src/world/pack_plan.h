// SPDX-License-Identifier: Apache-2.0
// Inside packing: what pack.c plans and pack_bins.c puts on lattices.
#ifndef QN_WORLD_PACK_PLAN_H
#define QN_WORLD_PACK_PLAN_H

#include "world/occupied.h"
#include "world/pack.h"

/// Spheres of nearly one size, which share a lattice.
typedef struct qn_pack_bin {
    double radius;    // m   padded, of the largest
    int64_t count;    //     spheres
    int32_t *labels;  //     the class of each, shuffled; owned
} qn_pack_bin;

/// What is to be packed, and where.
typedef struct qn_pack_plan {
    const qn_def *def;
    const qn_class *classes;
    int class_count;
    const qn_walls *walls;
    qn_vec3 low, high;  // m   the box that is filled
    bool periodic;      //     along z
    bool cubic;
    int64_t *counts;  //     of each class; 0 for listed ones; owned
    int64_t total;    //     of all packed classes
    int bin_count;
    qn_pack_bin *bins;  //     owned; largest first
    qn_occupied occupied;
    qn_seedling *out;  //     owned by the caller
    int listed;        //     of them come from lists
} qn_pack_plan;

/// Radius (m) of the sphere around a body of a class, with its padding.
static inline double qn_padded_radius(const qn_pack_plan *p, int32_t klass)
{
    return p->classes[klass].bound * (1 + p->def->groups[p->classes[klass].group].padding);
}

/// Sorts the classes to be packed into bins of nearly one size, largest first. members: room for all
/// classes, used here.
QN_NODISCARD qn_status qn_pack_sort(qn_pack_plan *plan, int32_t *members);

/// Packs all bins: one bin from the bottom of the box up; several up to a height that is raised until
/// they fit, so that they lie low and mixed. *fit is how many found room, in the end.
QN_NODISCARD qn_status qn_pack_bins(qn_pack_plan *plan, int64_t *fit);

#endif
