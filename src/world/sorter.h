// SPDX-License-Identifier: Apache-2.0
// The cell grids of a list rebuild: one for each level of sizes, cells along a Morton curve, particles
// sorted by level, finest first, and by cell.
//
// A level holds the classes down to 1 / QN_LEVEL_RATIO of its largest radius; its cells are as wide as
// the largest listing distance in it. A particle looks for partners in its own level and in all coarser
// ones (small looks for large), so the work stays proportional to the number of pairs however wide the
// sizes are spread. Used once per rebuild.
//
// Sources: Morton (1966), IBM Ltd, A computer oriented geodetic data base; Ogarko & Luding (2012),
// Comput. Phys. Commun. 183, 931, doi:10.1016/j.cpc.2011.12.019, for the levels.
#ifndef QN_WORLD_SORTER_H
#define QN_WORLD_SORTER_H

#include "world/world.h"

#define QN_LEVEL_RATIO 3.0   // 1   between the radii of two levels (1.5, 2 and 3 tried)
enum { QN_LEVELS_MAX = 8 };  //     the finest level takes all that is smaller still

typedef struct qn_grid {
    double radius;                         // m   the largest in the level
    double low[3], high[3], inverse_cell;  // m, 1/m   of the centres in it
    int cells[3];
    uint32_t *code[3];  //  owned; Morton bits of each coordinate: a cell's key is their sum
    int64_t code_room[3];
    int64_t keys;       //  1 + the largest key of one cell
    int64_t first_key;  //  of this level among those of all
} qn_grid;

typedef struct qn_sorter {
    int level_count;
    qn_grid grids[QN_LEVELS_MAX];  //  finest first
    int *level;                    //  of each class; owned
    int64_t keys;                  //  of all levels together
    int32_t *start;                //  first particle of each key, and one past; owned
    int32_t *image_start;  //  the same of images from the low end, then from the high; owned
    int64_t start_room, image_start_room;
    uint32_t *key;  //  of each particle, among those of all levels; owned
    int64_t key_room;
    int32_t *from;  //  old index of each new one; owned
    int32_t *to;    //  new index of each old one; owned
    int64_t from_room, to_room;
    qn_place *place, *images;  //  owned
    qn_motion *motion;         //  owned
    int64_t *id;               //  owned
    int64_t room, image_room;
    qn_contact
        *carried;  //  history to carry over, in rows by the old index of the owner (history.h)
    int64_t *carried_row;  //  owned, both
    int64_t carried_room, carried_row_room;
    qn_contact *gathered;     //  the same on the way there, and the index of each owner
    int32_t *gathered_owner;  //  owned, both
    int64_t gathered_room, gathered_owner_room;
    qn_wall_contact *touches;  //  wall contacts to carry over; owned
    int64_t touch_count, touch_room;
} qn_sorter;

/// Puts the classes into levels, once.
QN_NODISCARD qn_status qn_sorter_plan(qn_sorter *sorter, const qn_world *world);

/// Lays each level's grid over its particles, for pairs up to `skin` (m) apart; at most some four cells
/// per particle, by wider cells where the particles are sparse.
QN_NODISCARD qn_status qn_grids_lay(qn_sorter *sorter, const qn_world *world, double skin);

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

static inline int64_t qn_grid_key_at(const qn_grid *grid, const qn_place *p)
{
    return grid->first_key
           + qn_grid_key(grid, qn_grid_cell(grid, 0, p->x), qn_grid_cell(grid, 1, p->y),
                         qn_grid_cell(grid, 2, p->z));
}

/// Sorts the world's particles by cell and permutes their records; fills from, to and start.
QN_NODISCARD qn_status qn_sort_particles(qn_sorter *sorter, qn_world *world);

/// Makes the periodic images behind the particles in world->place, sorted by cell, and fills
/// image_start. *rising is how many there are of particles near the low end, one period up; *count is
/// these and those of coarser particles near the high end, one period down, which only finer ones look
/// for.
QN_NODISCARD qn_status qn_sort_images(qn_sorter *sorter, qn_world *world, double skin, int *rising,
                                      int *count);

void qn_sorter_free(qn_sorter *sorter);

#endif
