// SPDX-License-Identifier: Apache-2.0
#include "mill.h"

#include "base/hash.h"

#include "scene/scene.h"
#include "step/step.h"

#include <ftw.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// clang-format off
#define SCENE                                                                           \
    "format: quern-scene/1\n"                                                           \
    "title: A very small mill\n"                                                        \
    "time: {end: 2000 steps, step: 20 us}\n"                                            \
    "materials:\n"                                                                      \
    "  glass: {young: 5 MPa, poisson: 0.23, density: 2500 kg/m3}\n"                     \
    "contacts:\n"                                                                       \
    "  glass-glass: {friction: 0.2, restitution: 0.66}\n"                               \
    "drum:\n"                                                                           \
    "  diameter: 40 mm\n"                                                               \
    "  length: 12 mm\n"                                                                 \
    "  ends: periodic\n"                                                                \
    "  material: glass\n"                                                               \
    "  speed: 20 rad/s\n"                                                               \
    "  lifters: {count: 4, height: 3 mm, top: 3 mm, face_angle: 75 deg}\n"              \
    "particles:\n"                                                                      \
    "  balls: {material: glass, diameter: 4 mm, count: 80}\n"                           \
    "measure:\n"                                                                        \
    "  series: 20 steps\n"                                                              \
    "  fields: {start: 400 steps, duration: 1500 steps, every: 10 steps, cells: 1 2}\n" \
    "  traces: {ids: 1 7, every: 50 steps}\n"                                           \
    "output: {frames: 200 steps, checkpoint: 1000 s}\n"
// clang-format on

const char mill_scene[] = SCENE;
const char mill_other_scene[] = "# another\n" SCENE;

static qn_status make_world(mill *m, const char *scene)
{
    qn_def def;
    qn_messages messages = {0};
    qn_status status = qn_scene_read_text(scene, strlen(scene), "mill", NULL, &def, &messages);
    qn_messages_free(&messages);
    if (status != QN_OK) return status;
    status = qn_world_create(&def, 1, &m->world);
    qn_def_free(&def);
    if (status != QN_OK) return status;
    QN_TRY(qn_step_begin(m->world));
    return qn_measure_create(m->world, &m->measure);
}

qn_status mill_open(mill *m, const char *scene, const char *folder, qn_run_mode mode)
{
    *m = (mill){0};
    qn_recorded_scene kept = {scene, "resolved: true\n",
                              qn_hash(QN_HASH_START, scene, strlen(scene))};
    qn_status status = make_world(m, scene);
    if (status == QN_OK)
        status = qn_recorder_open(&m->recorder, folder, mode, &kept, m->world, &m->measure);
    if (status != QN_OK) mill_close(m);
    return status;
}

qn_status mill_run(mill *m, int64_t until, int64_t stride)
{
    while (m->world->step < until) {
        QN_TRY(qn_step_forces(m->world, QN_COMMIT));
        QN_TRY(qn_measure_sample(&m->measure, m->world));
        QN_TRY(qn_recorder_sample(&m->recorder, m->world, &m->measure));
        QN_TRY(qn_step_advance(m->world));
        if (stride && m->world->step % stride == 0)
            QN_TRY(qn_recorder_checkpoint(&m->recorder, m->world, &m->measure));
    }
    return QN_OK;
}

qn_status mill_run_through(const char *folder, qn_run_mode mode, int64_t until, int64_t stride,
                           uint64_t *hash)
{
    mill m;
    QN_TRY(mill_open(&m, mill_scene, folder, mode));
    qn_status status = mill_run(&m, until, stride);
    if (status == QN_OK) status = qn_recorder_finish(&m.recorder, m.world, &m.measure, true);
    if (hash) *hash = m.recorder.progress.state_hash;
    mill_close(&m);
    return status;
}

void mill_close(mill *m)
{
    qn_recorder_close(&m->recorder);
    qn_measure_free(&m->measure);
    qn_world_destroy(m->world);
    *m = (mill){0};
}

static int remove_one(const char *path, const struct stat *about, int kind, struct FTW *place)
{
    (void)about, (void)kind, (void)place;
    return remove(path);
}

void remove_folder(const char *folder)
{
    nftw(folder, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

bool same_file(const char *folder_a, const char *folder_b, const char *name)
{
    char path[QN_FILE_NAME_MAX], *a = NULL, *b = NULL;
    int64_t length_a = 0, length_b = 1;
    bool same = qn_file_read(qn_path_join(path, folder_a, name), &a, &length_a) == QN_OK
                && qn_file_read(qn_path_join(path, folder_b, name), &b, &length_b) == QN_OK
                && length_a == length_b && memcmp(a, b, (size_t)length_a) == 0;
    free(a);
    free(b);
    return same;
}
