// SPDX-License-Identifier: Apache-2.0
// Where the particles start: hexagonal close packing, a cubic grid, or a list.
//
// Groups packed by hcp or grid are put together. Sizes within a quarter of each other share a lattice,
// sizes and groups dealt to its sites at random by the seed, in exact proportions. If that is all of them,
// the lattice is filled layer by layer from low y upwards. Otherwise each such bin has a lattice of its
// own and takes sites of it at random, largest first, where no larger sphere is in the way; all below a
// height that is raised until they fit, so that the sizes are mixed and lie low. A site is used only
// where a padded sphere clears every wall and listed sphere.
#ifndef QN_WORLD_PACK_H
#define QN_WORLD_PACK_H

#include "world/world.h"

/// One ball or clump before it has a record.
typedef struct qn_seedling {
    qn_vec3 position, velocity, spin;  // m, m/s, rad/s
    int32_t klass;
} qn_seedling;

/// All particles of a definition in the order of their ids. *seedlings is owned by the caller.
/// QN_INPUT where a count does not fit (the sentence says how many do) or a listed sphere stands in
/// a wall. Cost: O(sites tried x wall elements).
QN_NODISCARD qn_status qn_pack(const qn_def *def, const qn_class *classes, int class_count,
                               const qn_walls *walls, qn_seedling **seedlings, int *count);

#endif
