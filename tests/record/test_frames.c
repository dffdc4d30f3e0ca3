// SPDX-License-Identifier: Apache-2.0
// Frames and fields as another program reads them: h5py, by read_recordings.py; ParaView where there
// is one.
#include "check.h"
#include "mill.h"

#include "scene/load.h"

#include <stdlib.h>

#define PYTHON "/usr/bin/python3 "

/// Runs a script of this folder on a recorded run; false if it finds fault.
static bool agrees(const char *program, const char *script, const char *folder)
{
    char command[2 * QN_FILE_NAME_MAX];
    snprintf(command, sizeof command, "%s" QUERN_SOURCE_DIR "/tests/record/%s %s", program, script,
             folder);
    fflush(stdout);
    return system(command) == 0;
}

static void another_program_reads_what_a_run_has_written(void)
{
    if (system(PYTHON "-c 'import h5py' 2>/dev/null") != 0) {
        printf("  (no h5py here: skipped)\n");
        return;
    }
    remove_folder("frames");
    CHECK_STATUS(mill_run_through("frames", QN_NEW, 2000, 0, NULL));
    CHECK(agrees(PYTHON, "read_recordings.py", "frames"));
}

static void paraview_opens_the_frames_as_a_time_series(void)
{
    if (system("command -v pvpython >/dev/null 2>&1") != 0) {
        printf("  (no ParaView here: skipped)\n");
        return;
    }
    remove_folder("frames");
    CHECK_STATUS(mill_run_through("frames", QN_NEW, 2000, 0, NULL));
    CHECK(agrees("pvpython ", "read_in_paraview.py", "frames"));
}

/// The same particles out of a frame and out of a checkpoint of one step.
static bool same_particles(const qn_particle_list *a, const qn_particle_list *b)
{
    bool same = a->count == b->count && a->count == 80 && a->diameter && b->diameter;
    for (int64_t i = 0; same && i < 3 * a->count; i++)
        same = fabs(a->position[i] - b->position[i]) < 1e-8
               && fabs(a->diameter[i / 3] - b->diameter[i / 3]) < 1e-9;
    return same;
}

static void frames_and_checkpoints_can_start_another_run(void)
{
    qn_particle_list frame, checkpoint;
    remove_folder("again");
    CHECK_STATUS(mill_run_through("again", QN_NEW, 400, 0, NULL));
    CHECK_STATUS(qn_load_particles("again/frames/frame_000002.hdf", 1, &frame));
    qn_status status =
        qn_load_particles("again/checkpoints/checkpoint_000000000400.h5", 1, &checkpoint);
    bool same = status == QN_OK && same_particles(&frame, &checkpoint);
    qn_particle_list_free(&frame);
    if (status == QN_OK) qn_particle_list_free(&checkpoint);
    CHECK_STATUS(status);
    CHECK(same);
}

int main(int argc, char **argv)
{
    TEST(another_program_reads_what_a_run_has_written);
    TEST(frames_and_checkpoints_can_start_another_run);
    TEST(paraview_opens_the_frames_as_a_time_series);
    DONE;
}
