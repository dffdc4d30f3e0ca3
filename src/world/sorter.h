// SPDX-License-Identifier: Apache-2.0
// The cell grid of a list rebuild: cells along a Morton curve, particles sorted by cell.
//
// A cell is at least the largest listing distance wide, so that neighbours are in the 27 cells around.
// Used once per rebuild.
//
// Source: Morton (1966), IBM Ltd, A computer oriented geodetic data base.
#ifndef QN_WORLD_SORTER_H
#define QN_WORLD_SORTER_H

#include "world/world.h"

typedef struct qn_grid {
    double low[3], inverse_cell;  // m, 1/m
    int cells[3];
    uint32_t *code[3];  //  owned; Morton bits of each coordinate: a cell's key is their sum
    int64_t code_room[3];
    int64_t keys;  //  1 + the largest key
} qn_grid;

typedef struct qn_sorter {
    qn_grid grid;
    int32_t *start, *image_start;  //  first particle (image) of each key, and one past; owned
    int64_t start_room, image_start_room;
    uint32_t *key;  //  of each particle; owned
    int64_t key_room;
    int32_t *from;  //  old index of each new one; owned
    int32_t *to;    //  new index of each old one; owned
    int64_t from_room, to_room;
    qn_place *place, *images;  //  owned
    qn_motion *motion;         //  owned
    int64_t *id;               //  owned
    int64_t room, image_room;
    qn_contact *carried;   //  history to carry over, in rows by the old index of the lower id
    int64_t *carried_row;  //  owned, both
    int64_t carried_room, carried_row_room;
    qn_contact *gathered;   //  the same on the way there, and the index of each lower id
    int32_t *gathered_low;  //  owned, both
    int64_t gathered_room, gathered_low_room;
    qn_wall_contact *touches;  //  wall contacts to carry over; owned
    int64_t touch_count, touch_room;
} qn_sorter;

/// Lays the grid over all particles with cells of at least `cell` (m); at most some four cells per
/// particle, by wider cells where the particles are sparse.
QN_NODISCARD qn_status qn_grid_lay(qn_grid *grid, const qn_world *world, double cell);

/// Coordinate of the cell along an axis (0 to 2), inside the grid always.
static inline int qn_grid_cell(const qn_grid *grid, int axis, double x)
{
    int c = (int)((x - grid->low[axis]) * grid->inverse_cell);
    return c < 0 ? 0 : c >= grid->cells[axis] ? grid->cells[axis] - 1 : c;
}

static inline uint32_t qn_grid_key(const qn_grid *grid, int x, int y, int z)
{
    return grid->code[0][x] | grid->code[1][y] | grid->code[2][z];
}

static inline uint32_t qn_grid_key_at(const qn_grid *grid, const qn_place *p)
{
    return qn_grid_key(grid, qn_grid_cell(grid, 0, p->x), qn_grid_cell(grid, 1, p->y),
                       qn_grid_cell(grid, 2, p->z));
}

/// Sorts the world's particles by cell and permutes their records; fills from, to and start.
QN_NODISCARD qn_status qn_sort_particles(qn_sorter *sorter, qn_world *world);

/// Makes the periodic images of particles within `reach` (m) of the low end, sorted by cell, behind
/// the particles in world->place; fills image_start. *count is how many there are.
QN_NODISCARD qn_status qn_sort_images(qn_sorter *sorter, qn_world *world, double reach, int *count);

void qn_sorter_free(qn_sorter *sorter);

#endif
