// SPDX-License-Identifier: Apache-2.0
// The shape of a clump: overlapping spheres that move as one rigid body.
//
// A shape is kept free of size: lengths in units of the radius of the sphere of equal volume, moments
// of inertia in units of mass times that radius squared; its diameter is that of the sphere of equal
// volume. Centre and axes are those of the solid (solid.h): the centre of mass, the principal axes.
#ifndef QN_WORLD_SHAPE_H
#define QN_WORLD_SHAPE_H

#include "physics/rigid.h"
#include "world/solid.h"

typedef struct qn_shape {
    int count;                          //    spheres
    double centre[3 * QN_SPHERES_MAX];  // 1  in the body's frame
    double radius[QN_SPHERES_MAX];      // 1
    qn_vec3 moment;                     // 1   principal moments of inertia; 2/5 each for a ball
    bool is_round;                      //     all three are equal: the body turns as a ball does
    double bound;                       // 1   largest distance of the surface from the centre
    double arm;                         // 1   largest distance of a sphere's centre from it
    double overlap;                     // 1   volume of the union by that of its spheres
    double error;  // 1   bound of the relative error of volume, centre and moments
    qn_quat axes;  //     from the body's frame to that in which the spheres were given
} qn_shape;

/// The shape of 1 to QN_SPHERES_MAX spheres at centres (m, 3 x count) with radii (m), and the radius (m)
/// of the sphere of equal volume. QN_INPUT where a number is not finite or a radius not above 0.
QN_NODISCARD qn_status qn_shape_of(const double *centres, const double *radii, int count,
                                   qn_shape *shape, double *radius);

/// Four equal spheres at the corners of a tetrahedron, `spacing` of their radii between the centres.
/// Writes 12 and 4 numbers.
void qn_shape_tetrahedron(double spacing, double *centres, double *radii);

#endif
