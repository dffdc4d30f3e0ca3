// SPDX-License-Identifier: Apache-2.0
#include "record/run_folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define LOCK_NAME "quern.lock"

/// What is at a path before a run writes there.
typedef enum content { NOTHING, EMPTY, RUN, OTHER } content;

// What a run makes: single files, and families of them by how their names begin and end.
static const char *const our_files[] = {
    "scene.yaml",
    "resolved.yaml",
    "log.txt",
    "series.csv",
    "series.h5",
    "fields.h5",
    "traces.csv",
    "summary.json",
    "frames/frames.hdf.series",
    "trace_contacts.csv",
    "frames/liner.hdf.series",
};
static const char *const our_families[][3] = {
    {"", "failed_", ".h5"},
    {"frames", "frame_", ".hdf"},
    {"frames", "liner_", ".hdf"},
    {"checkpoints", "checkpoint_", ".h5"},
    {"checkpoints", "checkpoint_", ".h5.damaged"},
    {"pictures", "", ".png"},
};

static content look(const char *path)
{
    char lock[QN_FILE_NAME_MAX];
    bool any = false;
    DIR *entries = opendir(path);
    if (!entries) return errno == ENOENT ? NOTHING : OTHER;
    for (struct dirent *e; (e = readdir(entries));)
        any |= strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0
               && strcmp(e->d_name, LOCK_NAME) != 0;
    closedir(entries);
    if (!any) return EMPTY;
    return qn_file_exists(qn_path_join(lock, path, LOCK_NAME)) ? RUN : OTHER;
}

static qn_status check_allowed(const char *path, qn_run_mode mode)
{
    struct stat about;
    if (stat(path, &about) == 0 && !S_ISDIR(about.st_mode))
        return qn_fail(QN_INPUT, "%s is a file; a run needs a folder of its own", path);
    content there = look(path);
    if (there == OTHER)
        return qn_fail(QN_INPUT,
                       "the folder %s is not empty and was not made by a run (it has no " LOCK_NAME
                       "), so nothing is written there; choose another with -o",
                       path);
    if (there == RUN && mode == QN_NEW)
        return qn_fail(QN_INPUT,
                       "the folder %s holds a run already; go on with it (--resume), write over it "
                       "(--force) or choose another (-o)",
                       path);
    return QN_OK;
}

static qn_status take_lock(qn_run_folder *folder)
{
    char path[QN_FILE_NAME_MAX];
    folder->lock =
        open(qn_path_join(path, folder->path, LOCK_NAME), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (folder->lock < 0)
        return qn_fail(QN_IO, "%s could not be written: %s", path, strerror(errno));
    if (flock(folder->lock, LOCK_EX | LOCK_NB) == 0) return QN_OK;
    int trouble = errno;
    close(folder->lock);
    folder->lock = -1;
    if (trouble != EWOULDBLOCK) return QN_OK;  // a file system without locks
    return qn_fail(QN_INPUT, "another program is writing to %s at this moment", folder->path);
}

static qn_status remove_run(const char *path)
{
    char inner[QN_FILE_NAME_MAX];
    for (size_t i = 0; i < sizeof our_files / sizeof *our_files; i++)
        QN_TRY(qn_file_remove(qn_path_join(inner, path, our_files[i])));
    for (size_t i = 0; i < sizeof our_families / sizeof *our_families; i++) {
        const char *const *family = our_families[i];
        qn_path_join(inner, path, family[0]);
        QN_TRY(qn_file_sweep(inner, family[1], family[2]));
    }
    return QN_OK;
}

/// Removes what a killed run had begun to write.
static qn_status sweep_partials(const char *path)
{
    char inner[QN_FILE_NAME_MAX];
    QN_TRY(qn_file_sweep(path, "", ".partial"));
    QN_TRY(qn_file_sweep(qn_path_join(inner, path, "frames"), "", ".partial"));
    return qn_file_sweep(qn_path_join(inner, path, "checkpoints"), "", ".partial");
}

static qn_status make_folders(const char *path)
{
    char inner[QN_FILE_NAME_MAX];
    QN_TRY(qn_folder_make(path));
    QN_TRY(qn_folder_make(qn_path_join(inner, path, "checkpoints")));
    return qn_folder_make(qn_path_join(inner, path, "frames"));
}

static qn_status prepare(qn_run_folder *folder, qn_run_mode mode)
{
    char path[QN_FILE_NAME_MAX];
    QN_TRY(take_lock(folder));
    if (mode == QN_FORCE) QN_TRY(remove_run(folder->path));
    QN_TRY(sweep_partials(folder->path));
    QN_TRY(make_folders(folder->path));
    folder->log = fopen(qn_path_join(path, folder->path, "log.txt"), "a");
    if (!folder->log) return qn_fail(QN_IO, "%s could not be written: %s", path, strerror(errno));
    if (ftell(folder->log) == 0) fprintf(folder->log, "# " QN_RECORDING_FORMAT "\n");
    return QN_OK;
}

qn_status qn_run_folder_open(qn_run_folder *folder, const char *path, qn_run_mode mode)
{
    *folder = (qn_run_folder){.lock = -1};
    snprintf(folder->path, sizeof folder->path, "%s", path);
    if (strlen(path) > sizeof folder->path - 64)
        return qn_fail(QN_INPUT, "the name of the folder is too long (%zu bytes)", strlen(path));
    QN_TRY(check_allowed(path, mode));
    QN_TRY(qn_folder_make(path));
    qn_status status = prepare(folder, mode);
    if (status != QN_OK) qn_run_folder_close(folder);
    return status;
}

void qn_run_folder_log(qn_run_folder *folder, const char *format, ...)
{
    char when[32];
    time_t now = time(NULL);
    struct tm parts;
    va_list args;
    if (!folder->log) return;
    strftime(when, sizeof when, "%Y-%m-%d %H:%M:%S", gmtime_r(&now, &parts));
    fprintf(folder->log, "%s  ", when);
    va_start(args, format);
    vfprintf(folder->log, format, args);
    va_end(args);
    fputc('\n', folder->log);
    fflush(folder->log);
}

void qn_run_folder_close(qn_run_folder *folder)
{
    if (folder->log) fclose(folder->log);
    if (folder->path[0] && folder->lock >= 0) close(folder->lock);
    *folder = (qn_run_folder){.lock = -1};
}
