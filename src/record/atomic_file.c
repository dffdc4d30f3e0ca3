// SPDX-License-Identifier: Apache-2.0
#include "record/atomic_file.h"

#include "base/array.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define PARTIAL ".partial"

const char *qn_path_join(char path[QN_FILE_NAME_MAX], const char *folder, const char *name)
{
    snprintf(path, QN_FILE_NAME_MAX, "%s/%s", folder, name);
    return path;
}

/// Returns 0 or an errno.
static int write_all(int file, const char *data, size_t bytes)
{
    while (bytes > 0) {
        ssize_t done = write(file, data, bytes);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return errno;
        data += done;
        bytes -= (size_t)done;
    }
    return 0;
}

/// Syncs the folder a file lies in; returns 0 or an errno.
static int sync_folder_of(const char *path)
{
    char copy[QN_FILE_NAME_MAX];
    snprintf(copy, sizeof copy, "%s", path);
    int folder = open(dirname(copy), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return errno;
    int trouble = fsync(folder) == 0 || errno == EINVAL ? 0 : errno;
    close(folder);
    return trouble;
}

static qn_status replace(const char *path, const void *data, size_t bytes, bool sync)
{
    char partial[QN_FILE_NAME_MAX + sizeof PARTIAL];
    snprintf(partial, sizeof partial, "%s" PARTIAL, path);
    int file = open(partial, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) return qn_fail(QN_IO, "%s could not be written: %s", partial, strerror(errno));
    int trouble = write_all(file, data, bytes);
    if (!trouble && sync && fsync(file) != 0) trouble = errno;
    if (close(file) != 0 && !trouble) trouble = errno;
    if (!trouble && rename(partial, path) != 0) trouble = errno;
    if (!trouble && sync) trouble = sync_folder_of(path);
    if (!trouble) return QN_OK;
    unlink(partial);
    return qn_fail(QN_IO, "%s (%zu bytes) could not be written: %s", path, bytes,
                   strerror(trouble));
}

qn_status qn_atomic_write(const char *path, const void *data, size_t bytes)
{
    return replace(path, data, bytes, true);
}

qn_status qn_atomic_write_lazily(const char *path, const void *data, size_t bytes)
{
    return replace(path, data, bytes, false);
}

qn_status qn_file_sync(const char *path)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0 && errno == ENOENT) return QN_OK;
    int trouble = file < 0 || fsync(file) != 0 ? errno : 0;
    if (file >= 0) close(file);
    if (!trouble) return QN_OK;
    return qn_fail(QN_IO, "%s could not be synced: %s", path, strerror(trouble));
}

qn_status qn_atomic_text(const char *path, const char *text)
{
    return qn_atomic_write(path, text, strlen(text));
}

qn_status qn_file_read(const char *path, char **text, int64_t *length)
{
    char *fresh;
    struct stat about;
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return qn_fail(QN_IO, "%s could not be read: %s", path, strerror(errno));
    int64_t size = fstat(file, &about) == 0 ? (int64_t)about.st_size : 0, have = 0;
    qn_status status = QN_ALLOCATE(fresh, size + 1);
    while (status == QN_OK && have < size) {
        ssize_t done = read(file, fresh + have, (size_t)(size - have));
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) status = qn_fail(QN_IO, "%s could not be read: %s", path, strerror(errno));
        if (done <= 0) break;
        have += done;
    }
    close(file);
    if (status != QN_OK) return status;
    fresh[have] = 0;
    *text = fresh;
    *length = have;
    return QN_OK;
}

qn_status qn_file_sync_name(const char *path)
{
    int trouble = sync_folder_of(path);
    if (!trouble) return QN_OK;
    return qn_fail(QN_IO, "the folder of %s could not be synced: %s", path, strerror(trouble));
}

bool qn_file_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

qn_status qn_file_remove(const char *path)
{
    if (unlink(path) == 0 || errno == ENOENT) return QN_OK;
    return qn_fail(QN_IO, "%s could not be removed: %s", path, strerror(errno));
}

static bool has_ends(const char *name, const char *head, const char *tail)
{
    size_t n = strlen(name), h = strlen(head), t = strlen(tail);
    return n >= h + t && !strncmp(name, head, h) && !strcmp(name + n - t, tail);
}

qn_status qn_file_sweep(const char *folder, const char *head, const char *tail)
{
    qn_status status = QN_OK;
    DIR *entries = opendir(folder);
    if (!entries && errno == ENOENT) return QN_OK;
    if (!entries) return qn_fail(QN_IO, "%s could not be read: %s", folder, strerror(errno));
    for (struct dirent *e; status == QN_OK && (e = readdir(entries));) {
        char path[QN_FILE_NAME_MAX];
        if (has_ends(e->d_name, head, tail))
            status = qn_file_remove(qn_path_join(path, folder, e->d_name));
    }
    closedir(entries);
    return status;
}

qn_status qn_folder_make(const char *path)
{
    char part[QN_FILE_NAME_MAX];
    struct stat about;
    snprintf(part, sizeof part, "%s", path);
    for (char *c = part + 1; *c; c++)
        if (*c == '/') {
            *c = 0;
            mkdir(part, 0777);
            *c = '/';
        }
    if (mkdir(part, 0777) == 0) return qn_file_sync_name(path);
    int trouble = errno;
    if (trouble == EEXIST && stat(part, &about) == 0 && S_ISDIR(about.st_mode)) return QN_OK;
    return qn_fail(QN_IO, "the folder %s could not be made: %s", path, strerror(trouble));
}
