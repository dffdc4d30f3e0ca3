// SPDX-License-Identifier: Apache-2.0
// The recorder: everything a run leaves on disk, and how it goes on after any kind of end.
//
//     qn_recorder_open(&rec, folder, mode, &scene, world, measure)
//     each step:  qn_step_forces(world, QN_COMMIT)
//                 qn_measure_sample(measure, world)
//                 qn_recorder_sample(&rec, world, measure)
//                 qn_step_advance(world)
//                 now and then: qn_recorder_checkpoint(&rec, world, measure)
//     qn_recorder_finish(&rec, world, measure, true)
//     qn_recorder_close(&rec)
//
// Whatever grows (series, traces, frames) is on the disk before a checkpoint takes its name, and what
// lies beyond the checkpoint is cut when a run resumes: there is neither gap nor repeat.
#ifndef QN_RECORD_RECORDER_H
#define QN_RECORD_RECORDER_H

#include "record/checkpoint.h"
#include "record/run_folder.h"
#include "record/traces.h"

typedef struct qn_recorder {
    qn_run_folder folder;
    qn_progress progress;
    qn_series_file series;
    qn_traces traces;
    double opened, wall_before;  // s   clock when opened, wall time used before that
    double checkpointed;         // s   clock when the last checkpoint was all written
    int64_t checkpoint_step;     //     step of the newest checkpoint; -1 for none
    int64_t resumed_step;        //     step the run went on from; -1 for a fresh start
    int64_t frame_stride;        //     steps between frames; 0 for none
    int64_t frames_synced;       //     number of frames known to be on the disk
    int64_t series_step;         //     step of the last row; -1 for none
    double *row;                 //     that row; owned
    char note[1024];             //     what a person should know of the opening; "" for nothing
} qn_recorder;

/// What a run folder keeps of its scene; nothing here is owned.
typedef struct qn_recorded_scene {
    const char *text, *resolved;  // scene.yaml and resolved.yaml
    uint64_t hash;                // of the keys that a run can't change when it goes on
} qn_recorded_scene;

/// Opens a run folder. With QN_RESUME the newest checkpoint that can be read is put into world and
/// measures, and all files are cut to its step; damaged ones are set aside (`note` says so). QN_INPUT
/// where the folder may not be written or its checkpoint is of a scene with another hash.
/// On failure the recorder is closed.
QN_NODISCARD qn_status qn_recorder_open(qn_recorder *rec, const char *folder, qn_run_mode mode,
                                        const qn_recorded_scene *scene, qn_world *world,
                                        qn_measure *measure);

/// Writes what is due at the present step. Between qn_measure_sample() and qn_step_advance().
QN_NODISCARD qn_status qn_recorder_sample(qn_recorder *rec, qn_world *world,
                                          const qn_measure *measure);

/// Whether the scene's time between checkpoints has passed.
bool qn_recorder_checkpoint_due(const qn_recorder *rec, const qn_world *world);

/// Writes a checkpoint, keeps the newest, and brings series.h5, fields.h5 and summary.json up to date.
/// Between steps. QN_IO (disk full, ...) leaves the earlier checkpoints as they were.
QN_NODISCARD qn_status qn_recorder_checkpoint(qn_recorder *rec, qn_world *world,
                                              qn_measure *measure);

/// Ends a run between two steps: checkpoint, then the last step's own row (and frame and traces where
/// due), which a later run that goes on writes again, then the summary. `finished` says whether the
/// scene's end was reached.
QN_NODISCARD qn_status qn_recorder_finish(qn_recorder *rec, qn_world *world, qn_measure *measure,
                                          bool finished);

/// Keeps a state that failed a guard in failed_<step>.h5, outside the rotation, and syncs the series.
QN_NODISCARD qn_status qn_recorder_fail(qn_recorder *rec, qn_world *world, qn_measure *measure);

/// Wall time (s) of the run so far, earlier parts included.
double qn_recorder_wall(const qn_recorder *rec);

/// Adds a line to log.txt.
#define qn_recorder_log(rec, ...) qn_run_folder_log(&(rec)->folder, __VA_ARGS__)

/// Closes all files and gives the folder back; a zeroed recorder is fine.
void qn_recorder_close(qn_recorder *rec);

#endif
