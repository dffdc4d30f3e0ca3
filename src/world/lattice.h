// SPDX-License-Identifier: Apache-2.0
// Lattices of equal spheres in a box, as places by number: none is stored.
#ifndef QN_WORLD_LATTICE_H
#define QN_WORLD_LATTICE_H

#include "physics/vec3.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct qn_lattice {
    qn_vec3 low, high;         // m   the box
    bool periodic, cubic;      //     periodic along z
    double radius;             // m   of its spheres, which touch
    double pitch, row, layer;  // m   along z, x and y
    int64_t per_row, rows, layers;
} qn_lattice;

/// A lattice of spheres of `radius` (m) in a box: hexagonal close packing, with triangular layers in x-z and
/// rows along z, or cubic. A periodic row is stretched to close on itself.
/// Source: Conway & Sloane (1999), Sphere Packings, Lattices and Groups, 1.3.
qn_lattice qn_lattice_lay(qn_vec3 low, qn_vec3 high, bool periodic, bool cubic, double radius);

/// How many sites have a sphere that lies below y = top (m) entirely; they come first. At most 2^60.
int64_t qn_lattice_below(const qn_lattice *lattice, double top);

/// Centre of a site, numbered from the bottom up; false if it does not lie within the box.
bool qn_lattice_site(const qn_lattice *lattice, int64_t number, qn_vec3 *centre);

/// Number k of a random order of 0 .. count - 1, without a list of them.
/// Source: a Feistel network with cycle walking, Black & Rogaway (2002), CT-RSA, LNCS 2271, 114.
int64_t qn_shuffled(uint64_t seed, uint64_t stream, int64_t k, int64_t count);

#endif
