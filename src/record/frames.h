// SPDX-License-Identifier: Apache-2.0
// Frames: pictures of one step in single precision, as ParaView and h5py open them.
//
// frame_000000.hdf holds the particles, liner_000000.hdf the walls as they stand at that moment: the
// drum's profile drawn out along its axis and the triangle meshes. Both are VTKHDF unstructured
// grids of version 1.0; frames.hdf.series and liner.hdf.series list them with their times. Particles
// are in the order of their ids; velocities are those of the step itself. Frames are written lazily:
// qn_frames_sync() before a checkpoint that counts them.
#ifndef QN_RECORD_FRAMES_H
#define QN_RECORD_FRAMES_H

#include "record/atomic_file.h"
#include "world/world.h"

#define QN_FRAME_FORMAT "quern-frame/1"

/// Writes frame number `number` of the present step into `folder`; the liner where there is one. Valid
/// between qn_step_forces() and qn_step_advance().
QN_NODISCARD qn_status qn_frames_write(const char *folder, int64_t number, const qn_world *world);

/// Writes both lists of frames: frame i shows step steps[i] at the time steps[i] * dt.
QN_NODISCARD qn_status qn_frames_list(const char *folder, const int64_t *steps, int64_t count,
                                      const qn_world *world);

/// Makes sure that the frames from `first` up to `count` and their lists are on the disk.
QN_NODISCARD qn_status qn_frames_sync(const char *folder, int64_t first, int64_t count);

/// Removes frames with a number from `first` on: those a resumed run will write again.
QN_NODISCARD qn_status qn_frames_cut(const char *folder, int64_t first);

#endif
