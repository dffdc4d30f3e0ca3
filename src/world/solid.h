// SPDX-License-Identifier: Apache-2.0
// The solid that overlapping spheres make: volume, centre and moments of their union, no part of it
// counted twice.
//
// Method: the union is cut by planes z = const. A cut is a union of discs, whose area, first and second
// moments are sums over the arcs of its rim (Green's theorem), in closed form. They are smooth
// functions of z but for square roots where a sphere, the circle two spheres share or the corner of
// three begins or ends; between two such heights z = a + (b - a) (3 t^2 - 2 t^3), which makes square
// roots smooth, and Gauss-Legendre in t. The error is the difference between 32 and 64 nodes, which
// converge geometrically; rounding leaves some 1e-14.
#ifndef QN_WORLD_SOLID_H
#define QN_WORLD_SOLID_H

#include "base/array.h"
#include "physics/vec3.h"

enum { QN_SPHERES_MAX = 64 };  // spheres of one solid

typedef struct qn_solid {
    double volume;         // m3
    qn_vec3 centre;        // m
    double inertia[3][3];  // m5   moments of inertia about the centre, for a density of 1
    double error;          // 1    bound of what is wrong with these, of the largest of their kind
} qn_solid;

/// Of 1 to QN_SPHERES_MAX spheres at centres (m, 3 x count) with radii (m, > 0). Cost: milliseconds for
/// a few spheres.
QN_NODISCARD qn_status qn_solid_of(const double *centres, const double *radii, int count,
                                   qn_solid *solid);

#endif
