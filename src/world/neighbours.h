// SPDX-License-Identifier: Apache-2.0
// Neighbours: which pairs of particles may touch during the next few steps, and what every touching
// pair remembers.
//
// Cell grids, one per level of sizes -> counting sort by level and along a Morton curve -> half pair
// list with a skin, each pair in the row of the smaller. Rebuilt when some
// particle has moved half the skin, about every 20 to 100 steps; a rebuild re-sorts the particles
// and carries every contact's history over by id. The particles are cut into one share per thread,
// each with its own rows, history and wall contacts. Because forces are integer sums and the list
// only has to hold every touching pair, results do not depend on when it is rebuilt, on its order
// or on the shares: a checkpoint needs contacts, not lists.
//
// Periodic images: particles near the low end get an image one period further up, so that each pair
// across the boundary stands in the list once; as the small look for the large, large ones near the high
// end get one further down too, for smaller levels. An image has a place but no motion and no load of
// its own: its `home` is the original.
#ifndef QN_WORLD_NEIGHBOURS_H
#define QN_WORLD_NEIGHBOURS_H

#include "world/world.h"

/// What one thread owns: a range of particles and all pairs whose first index lies in it.
typedef struct qn_share {
    int first, last;  //    particles [first, last)
    int64_t pair_count, pair_room;
    int64_t *row;  //    last - first + 1 offsets into the pairs; owned
    int64_t row_room;
    uint32_t *partner;        //    index of the other << 1 | whether it has the lower id; owned
    unsigned char *touching;  //    whether the pair touched at the last step; owned
    qn_vec3 *slip;   // m    history of a touching pair (qn_memory), acting on the lower id; owned
    qn_vec3 *roll;   // N m  likewise; owned, NULL unless some law of the world needs it
    qn_load *spill;  //    loads of particles outside the range, by index; owned
    int64_t spill_room;
    int *foreign;  //    indices that `spill` is used for; owned
    int foreign_count;
    int64_t foreign_room;
    qn_wall_contact *walls, *walls_next;  // of the last step and of this one, by index; owned
    int wall_count, wall_next_count;
    int64_t wall_room, wall_next_room;
    struct qn_tally_sums *sums;  //    this step's sums (step/cpu/kernel.h); owned
    void *workspace;             //    of the contact kernel; owned
} qn_share;

typedef struct qn_anchor {
    double x, y, z;  // m   where a particle was when the list was built
} qn_anchor;

struct qn_neighbours {
    double skin;  // m
    bool stale;   //     to be rebuilt before it is used again
    bool built;   //     there is a list; else history waits for one (history.h)
    int64_t rebuilds;
    int share_count, share_room;
    qn_share *shares;   //     owned
    qn_anchor *anchor;  //     owned; by particle
    int64_t anchor_room;
    int image_count;           //     periodic images, at place[count..]
    int rising_count;          //     the first of them: one period up; the others are one down
    double *reach2;            // m2  owned; squared distance at which a pair of classes is listed
    double *touch2;            // m2  owned; squared distance at which it touches
    struct qn_sorter *sorter;  //     buffers of the rebuild; owned
};

/// The skin (m) of a world's list: as the scene says, or half the smallest radius.
double qn_neighbours_skin(const qn_world *world);

/// Makes an empty, stale list for a world whose particles stand; decides skin and shares.
QN_NODISCARD qn_status qn_neighbours_create(qn_world *world);
void qn_neighbours_destroy(qn_neighbours *neighbours);

/// Rebuilds the list. QN_UNSTABLE if a particle is outside or not finite; QN_MEMORY on failure.
QN_NODISCARD qn_status qn_neighbours_rebuild(qn_world *world);

/// All touching pairs and wall contacts with their history, in no particular order; each array is
/// owned by the caller.
QN_NODISCARD qn_status qn_neighbours_contacts(const qn_world *world, qn_contact **contacts,
                                              int64_t *count);
QN_NODISCARD qn_status qn_neighbours_wall_contacts(const qn_world *world,
                                                   qn_wall_contact **contacts, int64_t *count);

/// Forgets the list and takes these contacts as the history of the next rebuild.
QN_NODISCARD qn_status qn_neighbours_restore(qn_world *world, const qn_contact *contacts,
                                             int64_t contact_count, const qn_wall_contact *touches,
                                             int64_t touch_count);

/// What pair k of a share remembers.
static inline qn_memory qn_memory_of(const qn_share *share, int64_t k)
{
    qn_memory m = {share->slip[k], share->roll ? share->roll[k] : qn_v3(0, 0, 0)};
    return m;
}

static inline void qn_memory_set(qn_share *share, int64_t k, qn_memory memory)
{
    share->slip[k] = memory.slip;
    if (share->roll) share->roll[k] = memory.roll;
}

/// The other particle of pair k of a share, and whether it has the lower id of the two.
static inline int qn_partner(const qn_share *share, int64_t k, bool *lower)
{
    uint32_t word = share->partner[k];
    *lower = word & 1;
    return (int)(word >> 1);
}

#endif
