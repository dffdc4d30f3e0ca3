// SPDX-License-Identifier: Apache-2.0
// From materials and sizes to classes, pair coefficients and the quanta of the integer sums.
#ifndef QN_WORLD_CLASSES_H
#define QN_WORLD_CLASSES_H

#include "world/world.h"

#define QN_OVERLAP_WARN 0.05  // 1   overlap in radii of the smaller sphere: above it, a warning
#define QN_OVERLAP_STOP 0.30  // 1   above it, the run stops

/// The classes of a definition: every size of every group, in their order, then those of clumps' spheres
/// that are not as large as the first. *classes is owned by the caller.
QN_NODISCARD qn_status qn_classes_build(const qn_def *def, qn_class **classes, int *count);

/// How many radii the spheres of a group of clumps have; which[] gets the number of each sphere's, from
/// 0 in the order in which they come, unless NULL.
int qn_radii_of(const qn_def *def, const qn_group_def *group, int *which);

/// The two sides of a contact between classes, or of a class and a wall, with time step dt (s).
qn_sides qn_sides_of_classes(const qn_def *def, const qn_contact_def *contact, const qn_class *a,
                             const qn_class *b, double dt);
qn_sides qn_sides_of_wall(const qn_def *def, const qn_contact_def *contact, const qn_class *a,
                          const qn_surface *surface, double dt);

/// Whether particles of two classes can meet: not where neither can move, nor where there is but one.
bool qn_classes_can_meet(const qn_def *def, const qn_class *a, const qn_class *b);

/// Whether some wall is made of a material.
bool qn_def_is_wall(const qn_def *def, int material);

/// Fills the world's pair tables from its classes, surfaces and time step. QN_INPUT where two materials that can touch have no law.
QN_NODISCARD qn_status qn_pairs_build(qn_world *world);

/// Quanta for sums over `count` particles, once the pair tables are there; `lever` (m) is the largest
/// distance of a wall contact from the axis.
void qn_units_choose(qn_world *world, int64_t count, double lever);

#endif
