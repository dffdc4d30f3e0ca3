// SPDX-License-Identifier: Apache-2.0
// Profiles: a drum's cross-section as a text file of points.
#include "base/array.h"
#include "scene/load_datafile.h"

#include <limits.h>
#include <stdlib.h>

static bool same(const double *a, const double *b)
{
    return a[0] == b[0] && a[1] == b[1];
}

static qn_status read_points(qn_datafile *file, double unit, double *xy, int64_t *count)
{
    qn_line line;
    int64_t n = 0;
    while (qn_datafile_line(file, &line)) {
        double *point = xy + 2 * n;
        QN_TRY(qn_line_numbers(file, line, 2, "x and y of a point", point));
        for (int axis = 0; axis < 2; axis++)
            QN_TRY(qn_datafile_length(file, point[axis], unit, &point[axis]));
        if (n == 0 || !same(point, point - 2)) n++;
    }
    while (n > 1 && same(xy, xy + 2 * (n - 1))) n--;
    *count = n;
    return QN_OK;
}

qn_status qn_load_points(const char *path, double unit, double **xy, int *count)
{
    qn_datafile file;
    QN_TRY(qn_datafile_read_text(path, &file));
    double *points = NULL;
    int64_t n = qn_datafile_lines_left(&file);
    qn_status status = QN_OK;
    if (n > INT_MAX / 2)
        status = qn_fail(QN_INPUT, "%s: %lld points; at most %d are allowed", path, (long long)n,
                         INT_MAX / 2);
    if (status == QN_OK) status = QN_ALLOCATE(points, 2 * n);
    if (status == QN_OK) status = read_points(&file, unit, points, &n);
    if (status == QN_OK && n < 3)
        status = qn_fail(QN_INPUT, "%s: %lld different points; a profile needs at least 3", path,
                         (long long)n);
    qn_datafile_free(&file);
    if (status != QN_OK) {
        free(points);
        return status;
    }
    *xy = points;
    *count = (int)n;
    return QN_OK;
}
