// SPDX-License-Identifier: Apache-2.0
#include "record/recorder.h"

#include "record/fields_file.h"
#include "record/frames.h"
#include "record/series_h5.h"
#include "record/summary.h"
#include "step/step.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double qn_recorder_wall(const qn_recorder *rec)
{
    return rec->wall_before + clock_now() - rec->opened;
}

static const char *in_folder(const qn_recorder *rec, char path[QN_FILE_NAME_MAX], const char *name)
{
    return qn_path_join(path, rec->folder.path, name);
}

// ---- Opening -------------------------------------------------------------------------------------

/// The scene is kept beside what it made; that of a run that goes on may differ from the one before in
/// what neither motion nor checkpoints depend on.
static qn_status keep_scene(qn_recorder *rec, const qn_recorded_scene *scene)
{
    char path[QN_FILE_NAME_MAX];
    QN_TRY(qn_atomic_text(in_folder(rec, path, "scene.yaml"), scene->text));
    return qn_atomic_text(in_folder(rec, path, "resolved.yaml"), scene->resolved);
}

/// Tries the checkpoints, newest first; damaged ones get another name.
static qn_status load_newest(qn_recorder *rec, qn_world *world, qn_measure *measure)
{
    char folder[QN_FILE_NAME_MAX], path[QN_FILE_NAME_MAX], aside[QN_FILE_NAME_MAX + 16];
    int64_t *steps;
    int count, tried = 0;
    in_folder(rec, folder, "checkpoints");
    qn_status status = qn_checkpoint_list(folder, &steps, &count);
    for (; status == QN_OK && tried < count; tried++) {
        qn_checkpoint_path(path, folder, steps[tried]);
        status = qn_checkpoint_read(path, world, measure, &rec->progress);
        if (status == QN_OK) {
            rec->resumed_step = rec->checkpoint_step = world->step;
            break;
        }
        if (status != QN_IO || tried + 1 == count) break;
        snprintf(rec->note, sizeof rec->note, "%s; an older checkpoint is used", qn_error());
        snprintf(aside, sizeof aside, "%s.damaged", path);
        if (rename(path, aside) == 0) status = QN_OK;
    }
    free(steps);
    return status;
}

static qn_status open_files(qn_recorder *rec, const qn_world *world, const qn_measure *measure)
{
    char path[QN_FILE_NAME_MAX], *header;
    int64_t cut = world->step;
    QN_TRY(QN_ALLOCATE(rec->row, measure->series.column_count));
    QN_TRY(qn_series_header(&measure->series, &header));
    qn_status status =
        qn_series_file_open(&rec->series, in_folder(rec, path, "series.csv"), header, cut);
    free(header);
    if (status != QN_OK) return status;
    QN_TRY(qn_traces_open(&rec->traces, rec->folder.path, &measure->def, cut));
    return qn_frames_cut(in_folder(rec, path, "frames"), rec->progress.frame_count);
}

static qn_status prepare(qn_recorder *rec, qn_run_mode mode, const qn_recorded_scene *scene,
                         qn_world *world, qn_measure *measure)
{
    qn_span every = world->def.output.frames_every;
    rec->progress.scene_hash = scene->hash;
    if (mode == QN_RESUME) QN_TRY(load_newest(rec, world, measure));
    QN_TRY(keep_scene(rec, scene));
    QN_TRY(open_files(rec, world, measure));
    rec->frame_stride = every.value > 0 ? qn_span_steps(world, every) : 0;
    rec->frames_synced = rec->progress.frame_count;  // a checkpoint counts only such frames
    rec->wall_before = rec->progress.wall;
    if (*rec->note) qn_recorder_log(rec, "%s", rec->note);
    qn_recorder_log(rec, "quern " QN_VERSION ", %d particles, %s at step %" PRId64,
                    qn_world_particles(world), rec->resumed_step >= 0 ? "going on" : "starting",
                    world->step);
    return QN_OK;
}

qn_status qn_recorder_open(qn_recorder *rec, const char *folder, qn_run_mode mode,
                           const qn_recorded_scene *scene, qn_world *world, qn_measure *measure)
{
    *rec = (qn_recorder){.checkpoint_step = -1, .resumed_step = -1, .series_step = -1};
    QN_TRY(qn_run_folder_open(&rec->folder, folder, mode));
    rec->opened = rec->checkpointed = clock_now();
    qn_status status = prepare(rec, mode, scene, world, measure);
    if (status != QN_OK) qn_recorder_close(rec);
    return status;
}

void qn_recorder_close(qn_recorder *rec)
{
    qn_series_file_close(&rec->series);
    qn_traces_close(&rec->traces);
    qn_run_folder_close(&rec->folder);
    free(rec->progress.frame_steps);
    free(rec->row);
    *rec = (qn_recorder){.folder.lock = -1};
}

// ---- Each step -----------------------------------------------------------------------------------

static qn_status write_frame(qn_recorder *rec, const qn_world *world)
{
    char folder[QN_FILE_NAME_MAX];
    qn_progress *p = &rec->progress;
    QN_TRY(QN_RESERVE(p->frame_steps, p->frame_room, p->frame_count + 1));
    QN_TRY(qn_frames_write(in_folder(rec, folder, "frames"), p->frame_count, world));
    p->frame_steps[p->frame_count++] = world->step;
    return qn_frames_list(folder, p->frame_steps, p->frame_count, world);
}

static void write_row(qn_recorder *rec, const qn_world *world, const qn_measure *measure,
                      const double *row)
{
    int columns = measure->series.column_count;
    memcpy(rec->row, row, (size_t)columns * sizeof *row);
    for (int c = 0; c < columns; c++) qn_series_file_number(&rec->series, row[c]);
    qn_series_file_end_row(&rec->series);
    rec->series_step = world->step;
}

/// Frames and traces of the present step where they are due.
static qn_status write_pictures(qn_recorder *rec, qn_world *world, const qn_measure *measure)
{
    if (rec->frame_stride > 0 && world->step % rec->frame_stride == 0)
        QN_TRY(write_frame(rec, world));
    if (!qn_measure_traces_due(measure, world->step)) return QN_OK;
    return qn_traces_write(&rec->traces, world, &measure->def);
}

qn_status qn_recorder_sample(qn_recorder *rec, qn_world *world, const qn_measure *measure)
{
    if (qn_measure_series_due(measure, world->step))
        write_row(rec, world, measure, measure->series.row);
    return write_pictures(rec, world, measure);
}

// ---- Checkpoints and the end ---------------------------------------------------------------------

bool qn_recorder_checkpoint_due(const qn_recorder *rec, const qn_world *world)
{
    double every = world->def.output.checkpoint_every;
    return every > 0 && clock_now() - rec->checkpointed >= every;
}

static qn_status sync_files(qn_recorder *rec)
{
    char path[QN_FILE_NAME_MAX];
    QN_TRY(qn_series_file_sync(&rec->series));
    QN_TRY(qn_traces_sync(&rec->traces));
    in_folder(rec, path, "frames");
    QN_TRY(qn_frames_sync(path, rec->frames_synced, rec->progress.frame_count));
    rec->frames_synced = rec->progress.frame_count;
    return QN_OK;
}

/// What is made from the rest: series.h5, fields.h5, summary.json.
static qn_status write_results(qn_recorder *rec, const qn_world *world, const qn_measure *measure,
                               bool finished)
{
    char path[QN_FILE_NAME_MAX];
    const double *row = rec->series_step >= 0 ? rec->row : NULL;
    QN_TRY(qn_series_h5_write(rec->folder.path, &measure->series));
    QN_TRY(qn_fields_write(in_folder(rec, path, "fields.h5"), measure, world));
    return qn_summary_write(in_folder(rec, path, "summary.json"), world, measure, &rec->progress,
                            row, finished);
}

static qn_status write_checkpoint(qn_recorder *rec, qn_world *world, qn_measure *measure)
{
    char folder[QN_FILE_NAME_MAX], path[QN_FILE_NAME_MAX];
    in_folder(rec, folder, "checkpoints");
    rec->progress.wall = qn_recorder_wall(rec);
    QN_TRY(sync_files(rec));
    QN_TRY(qn_checkpoint_write(qn_checkpoint_path(path, folder, world->step), world, measure,
                               &rec->progress));
    rec->checkpoint_step = world->step;
    return qn_checkpoint_rotate(folder, world->def.output.checkpoint_keep);
}

qn_status qn_recorder_checkpoint(qn_recorder *rec, qn_world *world, qn_measure *measure)
{
    QN_TRY(write_checkpoint(rec, world, measure));
    QN_TRY(write_results(rec, world, measure, false));
    rec->checkpointed = clock_now();  // else a slow disk would leave no time for steps between
    return QN_OK;
}

/// The lines that a terminal shows of the result.
static void log_result(qn_recorder *rec, const qn_measure *measure)
{
    char text[512], *line = text, *next;
    qn_summary_text(measure, rec->row, text, sizeof text);
    for (; (next = strchr(line, '\n')) != NULL; line = next + 1)
        qn_recorder_log(rec, "%.*s", (int)(next - line), line);
}

qn_status qn_recorder_finish(qn_recorder *rec, qn_world *world, qn_measure *measure, bool finished)
{
    QN_TRY(write_checkpoint(rec, world, measure));
    QN_TRY(qn_step_forces(world, QN_PROBE));
    double *row = measure->series.row;
    QN_TRY(qn_measure_row(measure, world, row));
    QN_TRY(qn_measure_sample(measure, world));  // a window may end on the last step
    write_row(rec, world, measure, row);
    QN_TRY(write_pictures(rec, world, measure));
    QN_TRY(sync_files(rec));
    QN_TRY(write_results(rec, world, measure, finished));
    char lack[160];
    qn_measure_lack(measure, lack, sizeof lack);
    if (*lack) qn_recorder_log(rec, "%s", lack);
    log_result(rec, measure);
    qn_recorder_log(rec, "%s at step %" PRId64 ", %.3g s of wall time, state_hash %016" PRIx64,
                    finished ? "finished" : "stopped", world->step, rec->progress.wall,
                    rec->progress.state_hash);
    return QN_OK;
}

qn_status qn_recorder_fail(qn_recorder *rec, qn_world *world, qn_measure *measure)
{
    char path[QN_FILE_NAME_MAX], name[64];
    qn_recorder_log(rec, "failed at step %" PRId64 ": %s", world->step, qn_error());
    snprintf(name, sizeof name, "failed_%012" PRId64 ".h5", world->step);
    rec->progress.wall = qn_recorder_wall(rec);
    QN_TRY(sync_files(rec));
    return qn_checkpoint_write(in_folder(rec, path, name), world, measure, &rec->progress);
}
