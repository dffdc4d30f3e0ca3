// SPDX-License-Identifier: Apache-2.0
// The recorder: a run that is stopped, killed or cut short by its disk goes on as if it had not been.
#include "check.h"
#include "mill.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { END = 2000 };  // steps of the whole run

static const char *const grown[] = {"series.csv",
                                    "traces.csv",
                                    "trace_contacts.csv",
                                    "series.h5",
                                    "fields.h5",
                                    "frames/frames.hdf.series",
                                    "frames/frame_000010.hdf",
                                    "frames/liner_000010.hdf"};

static uint64_t whole_hash;  // of the uninterrupted run in "whole"

/// The uninterrupted run that the others are compared with; made once.
static qn_status run_whole(void)
{
    if (whole_hash) return QN_OK;
    remove_folder("whole");
    return mill_run_through("whole", QN_NEW, END, 0, &whole_hash);
}

/// What differs between a folder and the uninterrupted run; "" for nothing.
static const char *difference(const char *folder)
{
    for (size_t i = 0; i < sizeof grown / sizeof *grown; i++)
        if (!same_file("whole", folder, grown[i])) return grown[i];
    return "";
}

static void a_run_leaves_its_files(void)
{
    static const char *const names[] = {"scene.yaml", "resolved.yaml", "log.txt", "summary.json",
                                        "checkpoints/checkpoint_000000002000.h5"};
    char path[QN_FILE_NAME_MAX];
    CHECK_STATUS(run_whole());
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        CHECK(qn_file_exists(qn_path_join(path, "whole", names[i])));
    for (size_t i = 0; i < sizeof grown / sizeof *grown; i++)
        CHECK(qn_file_exists(qn_path_join(path, "whole", grown[i])));
}

static void a_stopped_run_goes_on_bit_for_bit(void)
{
    uint64_t hash;
    CHECK_STATUS(run_whole());
    remove_folder("stopped");
    CHECK_STATUS(mill_run_through("stopped", QN_NEW, 733, 0, NULL));
    CHECK_STATUS(mill_run_through("stopped", QN_RESUME, 1200, 100, NULL));
    CHECK_STATUS(mill_run_through("stopped", QN_RESUME, END, 0, &hash));
    CHECK(hash == whole_hash);
    CHECK(!strcmp(difference("stopped"), ""));
}

/// Runs in a child that is killed after `microseconds`; true if it came to its end before.
static bool run_and_kill(const char *folder, int microseconds)
{
    int told;
    pid_t child = fork();
    if (child == 0) _exit(mill_run_through(folder, QN_RESUME, END, 37, NULL) != QN_OK);
    usleep((useconds_t)microseconds);
    kill(child, SIGKILL);
    waitpid(child, &told, 0);
    return WIFEXITED(told) && WEXITSTATUS(told) == 0;
}

static void a_run_killed_at_twenty_moments_has_neither_gap_nor_repeat(void)
{
    uint64_t hash;
    int killed = 0;
    CHECK_STATUS(run_whole());
    remove_folder("killed");
    srand(7);
    for (int i = 0; i < 20; i++) killed += !run_and_kill("killed", 5000 + rand() % 60000);
    CHECK(killed > 3);
    CHECK_STATUS(mill_run_through("killed", QN_RESUME, END, 0, &hash));
    CHECK(hash == whole_hash);
    CHECK(!strcmp(difference("killed"), ""));
}

static void spoil(const char *path, double where)
{
    struct stat about;
    int file = open(path, O_RDWR);
    if (file < 0 || fstat(file, &about) != 0) return;
    unsigned char byte = 0;
    off_t place = (off_t)(where * (double)about.st_size);
    if (pread(file, &byte, 1, place) == 1) byte ^= 0x10;
    if (pwrite(file, &byte, 1, place) != 1) perror(path);
    close(file);
}

static void a_damaged_checkpoint_is_set_aside_for_an_older_one(void)
{
    mill m;
    remove_folder("damaged");
    CHECK_STATUS(mill_run_through("damaged", QN_NEW, 600, 200, NULL));
    CHECK(truncate("damaged/checkpoints/checkpoint_000000000600.h5", 5000) == 0);
    CHECK_STATUS(mill_open(&m, mill_scene, "damaged", QN_RESUME));
    int64_t step = m.world->step;
    bool told = strstr(m.recorder.note, "checkpoint_000000000600.h5") != NULL;
    mill_close(&m);
    CHECK(step == 400);
    CHECK(told);
}

static void one_wrong_bit_is_noticed_wherever_numbers_stand(void)
{
    const char *path = "damaged/checkpoints/checkpoint_000000000600.h5";
    char *text;
    int64_t length;
    uint64_t hash;
    int refused = 0;
    remove_folder("damaged");
    CHECK_STATUS(mill_run_through("damaged", QN_NEW, 600, 0, &hash));
    CHECK_STATUS(qn_file_read(path, &text, &length));
    for (int i = 0; i < 20; i++) {
        mill m;
        spoil(path, (i + 0.5) / 20);
        if (mill_open(&m, mill_scene, "damaged", QN_RESUME) == QN_OK) {
            CHECK(m.recorder.progress.state_hash == hash);
            mill_close(&m);
        } else
            refused++;
        CHECK_STATUS(qn_atomic_write(path, text, (size_t)length));
    }
    free(text);
    CHECK(refused >= 12);  // the rest hits padding and unused space between the tables
}

static void another_scene_is_refused(void)
{
    mill m;
    char *text;
    int64_t length;
    CHECK_STATUS(run_whole());
    CHECK(mill_open(&m, mill_other_scene, "whole", QN_RESUME) == QN_INPUT);
    CHECK(strstr(qn_error(), "it is of another scene"));
    CHECK_STATUS(qn_file_read("whole/scene.yaml", &text, &length));
    bool untouched = !strcmp(text, mill_scene);
    free(text);
    CHECK(untouched);
}

static void a_folder_is_never_written_over_unasked(void)
{
    mill m;
    CHECK_STATUS(run_whole());
    CHECK(mill_open(&m, mill_scene, "whole", QN_NEW) == QN_INPUT);
    CHECK(strstr(qn_error(), "--resume"));
    remove_folder("strange");
    CHECK(mkdir("strange", 0777) == 0);
    CHECK_STATUS(qn_atomic_text("strange/scene.yaml", "mine\n"));
    for (int mode = QN_NEW; mode <= QN_FORCE; mode++)
        CHECK(mill_open(&m, mill_scene, "strange", (qn_run_mode)mode) == QN_INPUT);
    CHECK(mill_open(&m, mill_scene, "strange/scene.yaml", QN_NEW) == QN_INPUT);
    CHECK(same_file("strange", "strange", "scene.yaml"));
    CHECK(!qn_file_exists("strange/quern.lock"));
}

static void force_removes_the_run_and_nothing_else(void)
{
    remove_folder("forced");
    CHECK_STATUS(mill_run_through("forced", QN_NEW, 400, 100, NULL));
    CHECK_STATUS(qn_atomic_text("forced/notes.txt", "keep me\n"));
    CHECK_STATUS(mill_run_through("forced", QN_FORCE, 20, 0, NULL));
    CHECK(qn_file_exists("forced/notes.txt"));
    CHECK(!qn_file_exists("forced/frames/frame_000001.hdf"));
    CHECK(!qn_file_exists("forced/checkpoints/checkpoint_000000000400.h5"));
    CHECK(!qn_file_exists("forced/fields.h5"));
}

static void two_programs_do_not_share_a_folder(void)
{
    mill first, second;
    remove_folder("shared");
    CHECK_STATUS(mill_open(&first, mill_scene, "shared", QN_NEW));
    qn_status status = mill_open(&second, mill_scene, "shared", QN_RESUME);
    mill_close(&first);
    CHECK(status == QN_INPUT);
    CHECK(strstr(qn_error(), "another program"));
}

static void the_newest_three_checkpoints_are_kept(void)
{
    int64_t *steps;
    int count;
    remove_folder("kept");
    CHECK_STATUS(mill_run_through("kept", QN_NEW, 100, 10, NULL));
    CHECK_STATUS(qn_checkpoint_list("kept/checkpoints", &steps, &count));
    CHECK(count == 3);
    CHECK(steps[0] == 100 && steps[1] == 90 && steps[2] == 80);
    free(steps);
}

static void a_failed_state_stays_out_of_the_rotation(void)
{
    mill m;
    int64_t *steps;
    int count;
    remove_folder("failed");
    CHECK_STATUS(mill_open(&m, mill_scene, "failed", QN_NEW));
    CHECK_STATUS(mill_run(&m, 55, 50));
    CHECK_STATUS(qn_recorder_fail(&m.recorder, m.world, &m.measure));
    mill_close(&m);
    CHECK(qn_file_exists("failed/failed_000000000055.h5"));
    CHECK_STATUS(qn_checkpoint_list("failed/checkpoints", &steps, &count));
    CHECK(count == 1 && steps[0] == 50);
    free(steps);
}

/// On a disk of 600 kB: runs until it is full, then makes room and goes on.
static void full_disk(void)
{
    mill m;
    CHECK_STATUS(mill_open(&m, mill_scene, "small/run", QN_NEW));
    CHECK_STATUS(mill_run(&m, 300, 100));
    int ballast = open("small/ballast", O_CREAT | O_WRONLY, 0666);
    char block[4096] = {1};
    while (write(ballast, block, sizeof block) > 0) continue;
    close(ballast);
    qn_status status = mill_run(&m, END, 100);
    bool told = strstr(qn_error(), "No space left on device") != NULL;
    mill_close(&m);
    CHECK(status == QN_IO);
    CHECK(told);
    CHECK(qn_file_exists("small/run/checkpoints/checkpoint_000000000300.h5"));
    CHECK(unlink("small/ballast") == 0);
    CHECK_STATUS(mill_run_through("small/run", QN_RESUME, END, 500, NULL));
    CHECK(!strcmp(difference("small/run"), ""));
}

static void a_full_disk_leaves_the_previous_checkpoint_and_a_run_that_goes_on(void)
{
    CHECK_STATUS(run_whole());
    mkdir("small", 0777);
    if (mount("none", "small", "tmpfs", 0, "size=6m") != 0) {
        printf("  (not allowed to mount a small disk here: skipped)\n");
        return;
    }
    full_disk();
    umount("small");
}

int main(int argc, char **argv)
{
    TEST(a_run_leaves_its_files);
    TEST(a_stopped_run_goes_on_bit_for_bit);
    TEST(a_run_killed_at_twenty_moments_has_neither_gap_nor_repeat);
    TEST(a_damaged_checkpoint_is_set_aside_for_an_older_one);
    TEST(one_wrong_bit_is_noticed_wherever_numbers_stand);
    TEST(another_scene_is_refused);
    TEST(a_folder_is_never_written_over_unasked);
    TEST(force_removes_the_run_and_nothing_else);
    TEST(two_programs_do_not_share_a_folder);
    TEST(the_newest_three_checkpoints_are_kept);
    TEST(a_failed_state_stays_out_of_the_rotation);
    TEST(a_full_disk_leaves_the_previous_checkpoint_and_a_run_that_goes_on);
    DONE;
}
