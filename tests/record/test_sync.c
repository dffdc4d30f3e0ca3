// SPDX-License-Identifier: Apache-2.0
// What is on the disk when a checkpoint takes its name. The program's calls of fsync and rename come
// by here: a file that was not synced since it got its name may be lost when the power fails.
#include "check.h"
#include "mill.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { ROOM = 1 << 12 };

static ino_t synced[ROOM];  // files and folders with nothing left to sync
static int synced_count;
static int checkpoints;       // that took their name
static char unsafe[80] = "";  // the first file that was not synced then

static double last_sync;  // s   clock at the last fsync

static int find(ino_t number)
{
    int i = 0;
    while (i < synced_count && synced[i] != number) i++;
    return i;
}

static void forget(const char *path)
{
    struct stat about;
    int i = stat(path, &about) == 0 ? find(about.st_ino) : synced_count;
    if (i < synced_count) synced[i] = synced[--synced_count];
}

/// Notes the first thing in a folder, or the folder itself, that is not synced.
static void look_through(const char *folder)
{
    char path[QN_FILE_NAME_MAX];
    struct stat about;
    DIR *entries = opendir(folder);
    for (struct dirent *e; entries && (e = readdir(entries));) {
        bool counts = !*unsafe && strcmp(e->d_name, "..") != 0;
        if (counts && stat(qn_path_join(path, folder, e->d_name), &about) == 0
            && find(about.st_ino) == synced_count)
            snprintf(unsafe, sizeof unsafe, "%.70s", e->d_name);
    }
    if (entries) closedir(entries);
}

int fsync(int file)
{
    struct stat about;
    if (fstat(file, &about) == 0 && find(about.st_ino) == synced_count && synced_count < ROOM)
        synced[synced_count++] = about.st_ino;
    int done = (int)syscall(SYS_fsync, file);
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    last_sync = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    return done;
}

int rename(const char *from, const char *to)
{
    if (strstr(to, "/checkpoint_")) {
        checkpoints++;
        look_through("synced/frames");
    }
    if (strstr(to, "/frames/")) {
        forget(from);
        forget("synced/frames");
    }
    return (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}

static void frames_are_on_the_disk_before_a_checkpoint_counts_them(void)
{
    remove_folder("synced");
    CHECK_STATUS(mill_run_through("synced", QN_NEW, 900, 250, NULL));
    CHECK_STATUS(mill_run_through("synced", QN_RESUME, 1700, 250, NULL));
    if (*unsafe) printf("  not synced: %s\n", unsafe);
    CHECK(checkpoints == 8);
    CHECK(!*unsafe);
}

static void the_time_between_checkpoints_begins_when_one_is_all_written(void)
{
    mill m;
    remove_folder("timed");
    CHECK_STATUS(mill_open(&m, mill_scene, "timed", QN_NEW));
    qn_status status = mill_run(&m, 100, 100);
    bool after = m.recorder.checkpointed >= last_sync;
    mill_close(&m);
    CHECK_STATUS(status);
    CHECK(after);
}

int main(int argc, char **argv)
{
    TEST(frames_are_on_the_disk_before_a_checkpoint_counts_them);
    TEST(the_time_between_checkpoints_begins_when_one_is_all_written);
    DONE;
}
