// SPDX-License-Identifier: Apache-2.0
// Which share of a wall's force a stretch of it takes, where a sphere lies over its end.
//
//     p = a^2 (3 - 2 a)
//
// a is the part of the sphere's chord in the stretch's line that lies on the stretch, 0 to 1. p is the part
// that a takes of the area between chord and circle, for a shallow overlap (R much larger than the chord).
// The shares of two stretches of one line add up to 1.
//
// Source: the reference document, 5.2.1, Figs 5.19 and 5.20.
#ifndef QN_PHYSICS_SHARING_H
#define QN_PHYSICS_SHARING_H

#include "physics/real.h"

/// The share (1) that a part a (1) of the chord takes.
QN_FN double qn_corner_share(double a)
{
    return a * a * (3 - 2 * a);
}

#endif
