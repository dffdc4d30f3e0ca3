// SPDX-License-Identifier: Apache-2.0
// Bodies: clumps of spheres that move as one.
//
// A ball is its own body and stands in the particles' table alone. A clump is a row here, and its
// spheres are particles like any others, of the clump's material, with consecutive ids; a body's id is
// that of its first sphere. The body moves; its spheres' places and motions follow from it, so that
// whatever looks at contacts needs to know no bodies. A contact sees the mass of the whole body.
#ifndef QN_WORLD_BODY_H
#define QN_WORLD_BODY_H

#include "world/shape.h"

/// A shape in one size and material.
typedef struct qn_grain {
    int shape;                         //       index in the definition
    int count;                         //       spheres
    double radius;                     // m     of the sphere of equal volume
    double bound;                      // m     of the sphere around all of it, about its centre
    double mass, inverse_mass;         // kg, 1/kg         0 where fixed
    qn_vec3 moments, inverse_moments;  // kg m2, 1/(kg m2)   principal; 0 where fixed
    bool is_round;                     //       the moments are equal
    int32_t klass[QN_SPHERES_MAX];     //       of each sphere
    qn_vec3 lever[QN_SPHERES_MAX];     // m     to each sphere's centre, in the body's frame
} qn_grain;

typedef struct qn_body {
    int64_t id;                       //     of its first sphere; the others' follow
    int32_t grain;                    //     index
    int32_t first;                    //     of its spheres in world->members
    qn_vec3 position;                 // m   centre of mass, at step n
    qn_quat orientation;              //     at step n
    qn_vec3 velocity, kick;           // m/s    what moved it, what predicts step n, as in qn_motion
    qn_vec3 spin, spin_kick;          // rad/s  the same, as its spheres have it
    qn_vec3 momentum, momentum_kick;  // N m s  angular; what a body that is not round keeps
    qn_vec3 force, torque;  // N, N m   of step n, about the centre: after qn_step_forces()
} qn_body;

#endif
