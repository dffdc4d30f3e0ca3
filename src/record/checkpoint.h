// SPDX-License-Identifier: Apache-2.0
// Checkpoints: everything a run needs to go on bit for bit, in one HDF5 file.
//
// Groups: /particles, /contacts, /wall_contacts (world/state.h), /classes, /ledger,
// /flow where there are feeds or outlets, /measure, /run. Every column carries a hash and the state has one of its own; a file that is not what was
// written is refused when read. Written atomically between two steps; docs/recording.md has the
// layout.
#ifndef QN_RECORD_CHECKPOINT_H
#define QN_RECORD_CHECKPOINT_H

#include "measure/measure.h"
#include "record/atomic_file.h"
#include "world/state.h"

#define QN_CHECKPOINT_FORMAT "quern-checkpoint/1"

/// What a run remembers besides world and measures.
typedef struct qn_progress {
    uint64_t scene_hash;  //     of the keys of the scene that the run depends on
    uint64_t state_hash;  //     of the state last written or read
    double wall;          // s   spent computing so far
    int64_t frame_count, frame_room;
    int64_t *frame_steps;  //     step of each frame written; owned
} qn_progress;

/// Writes world, measures and progress to a file. QN_IO (disk full, ...) leaves the old file there.
QN_NODISCARD qn_status qn_checkpoint_write(const char *path, const qn_world *world,
                                           qn_measure *measure, qn_progress *progress);

/// Puts what a file holds into a world and measures made from the same scene. QN_INPUT if it is of
/// another scene or time step, QN_IO if it can't be read or is damaged; world and measures may then
/// be half changed, and are only good for reading another checkpoint into.
QN_NODISCARD qn_status qn_checkpoint_read(const char *path, qn_world *world, qn_measure *measure,
                                          qn_progress *progress);

/// folder/checkpoint_000000012345.h5
const char *qn_checkpoint_path(char path[QN_FILE_NAME_MAX], const char *folder, int64_t step);

/// Steps of the checkpoints in a folder, newest first; release with free(). None without a folder.
QN_NODISCARD qn_status qn_checkpoint_list(const char *folder, int64_t **steps, int *count);

/// Removes all but the newest `keep` (at least one).
QN_NODISCARD qn_status qn_checkpoint_rotate(const char *folder, int keep);

#endif
