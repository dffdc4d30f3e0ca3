// SPDX-License-Identifier: Apache-2.0
// The checkpoints of a folder: their names, which there are, and how many are kept.
#include "base/array.h"
#include "record/checkpoint.h"

#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *qn_checkpoint_path(char path[QN_FILE_NAME_MAX], const char *folder, int64_t step)
{
    snprintf(path, QN_FILE_NAME_MAX, "%s/checkpoint_%012" PRId64 ".h5", folder, step);
    return path;
}

static int newest_first(const void *a, const void *b)
{
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x < y) - (x > y);
}

qn_status qn_checkpoint_list(const char *folder, int64_t **steps, int *count)
{
    int64_t room = 0, step;
    qn_status status = QN_OK;
    DIR *entries = opendir(folder);
    *steps = NULL;
    *count = 0;
    if (!entries && errno == ENOENT) return QN_OK;
    if (!entries) return qn_fail(QN_IO, "%s could not be read: %s", folder, strerror(errno));
    for (struct dirent *e; status == QN_OK && (e = readdir(entries));) {
        int end = 0;
        if (sscanf(e->d_name, "checkpoint_%" SCNd64 ".h5%n", &step, &end) != 1 || !end) continue;
        if (e->d_name[end]) continue;
        status = QN_RESERVE(*steps, room, *count + 1);
        if (status == QN_OK) (*steps)[(*count)++] = step;
    }
    closedir(entries);
    if (*count > 0) qsort(*steps, (size_t)*count, sizeof **steps, newest_first);
    return status;
}

qn_status qn_checkpoint_rotate(const char *folder, int keep)
{
    char path[QN_FILE_NAME_MAX];
    int64_t *steps;
    int count;
    qn_status status = qn_checkpoint_list(folder, &steps, &count);
    for (int i = keep > 1 ? keep : 1; i < count && status == QN_OK; i++)
        status = qn_file_remove(qn_checkpoint_path(path, folder, steps[i]));
    free(steps);
    return status;
}
