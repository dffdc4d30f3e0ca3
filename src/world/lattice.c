// SPDX-License-Identifier: Apache-2.0
#include "world/lattice.h"
#include "base/random.h"

// Sites along a length, ends included.
static int64_t along(double length, double pitch)
{
    return length < 0 ? 0 : (int64_t)floor(qn_min(length / pitch * (1 + 1e-12), 0x1p60)) + 1;
}

qn_lattice qn_lattice_lay(qn_vec3 low, qn_vec3 high, bool periodic, bool cubic, double radius)
{
    qn_lattice l = {low, high, periodic, cubic, .radius = radius, .pitch = 2 * radius};
    double length = high.z - low.z;
    l.row = cubic ? 2 * radius : radius * sqrt(3.0);
    l.layer = cubic ? 2 * radius : 2 * radius * sqrt(6.0) / 3;
    l.per_row = (int64_t)floor(qn_min(length / l.pitch * (1 + 1e-12), 0x1p60));
    if (periodic && l.per_row > 0) l.pitch = length / (double)l.per_row;
    l.rows = along(high.x - low.x - 2 * radius, l.row);
    l.layers = along(high.y - low.y - 2 * radius, l.layer);
    return l;
}

int64_t qn_lattice_below(const qn_lattice *l, double top)
{
    int64_t layers = along(top - l->low.y - 2 * l->radius, l->layer);
    if (layers > l->layers) layers = l->layers;
    double sites = (double)layers * (double)l->rows * (double)l->per_row;
    return sites < 0x1p60 ? layers * l->rows * l->per_row : (int64_t)1 << 60;
}

bool qn_lattice_site(const qn_lattice *l, int64_t number, qn_vec3 *centre)
{
    int64_t k = number % l->per_row, i = number / l->per_row % l->rows;
    int64_t j = number / l->per_row / l->rows;
    bool shifted = !l->cubic && (i + j) % 2 != 0;  // rows of B layers lie between those of A
    centre->x = l->low.x + l->radius + (double)i * l->row + (!l->cubic && j % 2 ? l->row / 3 : 0);
    centre->y = l->low.y + l->radius + (double)j * l->layer;
    centre->z = l->low.z + l->radius + ((double)k + (shifted ? 0.5 : 0)) * l->pitch;
    return l->periodic || centre->z <= l->high.z - l->radius * (1 - 1e-12);
}

int64_t qn_shuffled(uint64_t seed, uint64_t stream, int64_t k, int64_t count)
{
    int half = 1;
    while (half < 31 && (int64_t)1 << (2 * half) < count) half++;
    uint64_t mask = ((uint64_t)1 << half) - 1, x = (uint64_t)k;
    do {
        uint64_t left = x >> half, right = x & mask;
        for (uint64_t round = 0; round < 4; round++) {
            uint64_t next = left ^ (qn_random_bits(seed, 4 * stream + round, right) & mask);
            left = right, right = next;
        }
        x = left << half | right;
    } while (x >= (uint64_t)count);
    return (int64_t)x;
}
