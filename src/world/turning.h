// SPDX-License-Identifier: Apache-2.0
// Spheres that turn with the drum, whatever touches them: a lining, a lifter made of spheres.
//
// They are particles like all others to those that touch them, but of infinite mass and with a motion
// in closed form: at each step a sphere is put where it was at rest turned by the drum's total angle,
// never moved on from where it was, so it does not drift and a resumed run finds the same bits. What
// they do to the others is told as a part of the walls, one for each group.
//
// Source: the reference document, 5.2.1 ("temporarily rotate them into the correct position based on
//         the total angle").
#ifndef QN_WORLD_TURNING_H
#define QN_WORLD_TURNING_H

#include "world/world.h"

/// Notes where the spheres of turning groups stand and gives them their motion at time 0; for a
/// new world whose particles stand.
QN_NODISCARD qn_status qn_turning_create(qn_world *world);

/// Puts particle i, of a turning group, where the drum's frame has it, with the velocities that a leapfrog
/// keeps.
void qn_turning_put(qn_world *world, const qn_frame *drum, int i);

/// Force (N), and torque (N m) about the axis, of particle i, of a turning group, on what touches it.
qn_vec3 qn_turning_force(const qn_world *world, int i);
double qn_turning_torque(const qn_world *world, int i);

#endif
