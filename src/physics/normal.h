// SPDX-License-Identifier: Apache-2.0
// What every normal spring gives back. One model is one file, normal_<name>.h, with
//
//     qn_<name>_normal_pair(sides, pair)     its stiffness, at set-up
//     qn_<name>_normal(pair, approach)       its force and energy, in the inner loop
//
// and one row in laws.h. Its energy is a potential: the force is its gradient.
#ifndef QN_PHYSICS_NORMAL_H
#define QN_PHYSICS_NORMAL_H

#include "physics/approach.h"

typedef struct qn_normal {
    double elastic;  // N   >= 0
    double energy;   // J   stored
} qn_normal;

#endif
