// SPDX-License-Identifier: Apache-2.0
// Clumps in a step: loads of their spheres in, motion of their spheres out.
//
//     F = sum F_k,  T = sum T_k + r_k x F_k                                  in the order of the spheres
//     v(n+1/2) = v(n-1/2) + F/m dt,  L(n+1/2) = L(n-1/2) + T dt,  then the free turn (rigid.h);
//     other schemes (scheme.h) likewise
//
// A sphere's velocity at n - 1/2 is what moved it, v + (r_k(n) - r_k(n-1))/dt, and its kick leads from
// there to the predicted v(n) + w(n) x r_k(n), centripetal part included. A body whose moments are
// equal keeps its spin instead of L and is moved by the same sums as a ball, to the bit.
#ifndef QN_STEP_BODIES_H
#define QN_STEP_BODIES_H

#include "world/world.h"

/// Force and torque of each body from the loads of its spheres.
void qn_bodies_load(qn_world *world);

/// Puts velocities half a step back, as qn_step_begin().
void qn_bodies_begin(qn_world *world);

/// Kick, drift and turn of all bodies, and their spheres with them. *spent: whether a sphere has used up
/// half the skin; *unsound: whether one is faster than `fast` (m/s) or not finite.
void qn_bodies_advance(qn_world *world, double fast, int *spent, int *unsound);

#endif
