// SPDX-License-Identifier: Apache-2.0
// The drum's cross-section: straight and circular stretches with exact ownership of their corners.
//
// A closed chain of elements in the drum's own frame, inside to the left as one walks along it. A
// sphere touches an element when the foot of its centre lies within it, and a corner only from
// within the corner's wedge, beyond both neighbours. Where two elements run on smoothly their end
// directions are made exactly opposite, so that a joint in a straight line is felt by nothing.
// Where corners are shared instead, every stretch whose part of the sphere's chord is not nothing acts as
// if its line went on for ever, with a share of the force.
// Only the inner side acts: a centre that has gone through the wall is felt no more. Elements and
// corners near each cell of a plane grid are listed once, at set-up.
//
// Lifter k is centred at the angle k 2 pi / count, counter-clockwise from straight down (-y). Its
// side faces run from the shell to the corners of its top face, whose middle is at D/2 - height.
#ifndef QN_WORLD_PROFILE_H
#define QN_WORLD_PROFILE_H

#include "base/array.h"
#include "physics/vec3.h"
#include "world/def.h"

/// How the chain turns where an element begins.
typedef enum qn_corner {
    QN_CORNER_CONCAVE,    // to the left: both elements touch there, the corner never does
    QN_CORNER_SMOOTH,     // not at all: the corner owns the exact tie
    QN_CORNER_PROTRUDING  // to the right, into the drum: the corner owns the wedge between them
} qn_corner;

/// One stretch from point a to point b: straight, or on the shell's circle about the axis,
/// counter-clockwise from a to b and less than half a turn.
typedef struct qn_element {
    double ax, ay, bx, by;      // m
    double start_x, start_y;    // 1   unit direction at a that leads out of the element, backwards
    double end_x, end_y;        // 1   unit direction at b that leads out of the element, forwards
    double normal_x, normal_y;  // 1   into the drum, of a straight one
    double length;              // m   of a straight one
    bool arc;
    qn_corner corner;  //     at a
    int lifter;        //     which lifter it belongs to, -1 for the shell
} qn_element;

/// A touch in the drum's frame.
typedef struct qn_profile_hit {
    int32_t feature;  //     elements first, then the corner at the start of each element
    int element;      //     the element, or that whose start the corner is
    double x, y;      // m   nearest point; where corners are shared, of the whole line
    double share;     // 1   of the force; 1 but where corners are shared
    double beyond;    // m   how far that point lies beyond the element's end; 0 but there
} qn_profile_hit;

/// Which side of the profile all of a grid cell is on.
typedef enum qn_side { QN_SIDE_OUTSIDE, QN_SIDE_INSIDE, QN_SIDE_MIXED } qn_side;

typedef struct qn_profile {
    double radius;  // m   of the circle that encloses it; the shell's for a drum
    double clear;   // m   of the largest open circle about the axis; 0 if it is not inside
    double reach;   // m   largest radius of a disc that may ask
    bool shared;    //     corners
    int count;
    qn_element *elements;          //     owned
    double cell;                   // m
    int cells;                     //     per side; the grid is centred on the axis
    int *cell_start, *cell_items;  //  features near each cell (CSR), ascending; owned
    unsigned char *cell_side;      //     qn_side of each cell; owned
} qn_profile;

/// Circular shell with lifters, or the drum's points if it has any; for spheres up to `reach` (m).
/// QN_INPUT where lifters do not fit or points do not make a simple closed line.
QN_NODISCARD qn_status qn_profile_build(const qn_drum_def *drum, double reach, qn_profile *profile);

void qn_profile_free(qn_profile *profile);

/// Features a disc at (x, y) with `radius` touches, in order of feature; at most `room`. Returns how
/// many there are, also when more than `room`.
int qn_profile_touch(const qn_profile *profile, double x, double y, double radius,
                     qn_profile_hit *hits, int room);

/// The element before one in the closed chain.
static inline int qn_profile_before(const qn_profile *profile, int element)
{
    return element > 0 ? element - 1 : profile->count - 1;
}

/// Which side a point is on. Cost: a grid lookup, O(elements) in a cell the wall passes through.
qn_side qn_profile_side(const qn_profile *profile, double x, double y);

/// Distance (m) from a point to one element, never negative.
double qn_element_distance(const qn_element *element, double radius, double x, double y);

/// Signed distance (m) to the profile, positive inside. Cost: O(elements).
double qn_profile_distance(const qn_profile *profile, double x, double y);

/// Share of the circle of radius rho (m) that lies inside the profile. Cost: O(elements).
double qn_profile_open_share(const qn_profile *profile, double rho);

/// Area enclosed (m2), exact.
double qn_profile_area(const qn_profile *profile);

#endif
