// SPDX-License-Identifier: Apache-2.0
// Spheres out of our own recordings: the frames of a run and its checkpoints, both HDF5.
//
// A frame has /VTKHDF/Points and /VTKHDF/PointData, where velocity, spin and radius may be missing.
// A checkpoint has /particles and /classes; its velocities belong to half a step before its
// positions, and half the last step's change (kick) brings them up to date.
#include "base/array.h"
#include "scene/load_datafile.h"

#include <hdf5.h>

#include <limits.h>
#include <math.h>
#include <stdlib.h>

enum {
    ROOM = INT_MAX / 3,   // spheres in one file
    DEFLATE_BEST = 1032,  // 1   deflate never makes data smaller than by this factor
};

typedef struct recording {
    const char *path;
    hid_t file;
    int64_t bytes;  // size of the file
} recording;

/// Rows of a dataset of `width` numbers a row; 0 where there is no such dataset.
static qn_status find_rows(const recording *from, const char *name, int width, int64_t *rows)
{
    *rows = 0;
    hid_t data = H5Dopen2(from->file, name, H5P_DEFAULT);
    if (data < 0) return QN_OK;
    hid_t space = H5Dget_space(data);
    hsize_t size[2] = {0, 1};
    int rank = H5Sget_simple_extent_ndims(space);
    if (rank == 1 || rank == 2)
        H5Sget_simple_extent_dims(space, size, NULL);
    else
        size[1] = 0;
    H5Sclose(space);
    H5Dclose(data);
    if (size[1] != (hsize_t)width || size[0] < 1 || size[0] > ROOM)
        return qn_fail(QN_INPUT, "%s: %s has %llu rows of %llu; 1 to %d rows of %d are allowed",
                       from->path, name, (unsigned long long)size[0], (unsigned long long)size[1],
                       ROOM, width);
    if ((int64_t)size[0] * width > from->bytes * DEFLATE_BEST)
        return qn_fail(QN_INPUT,
                       "%s: %s announces %llu rows, more than a file of %lld bytes can "
                       "hold",
                       from->path, name, (unsigned long long)size[0], (long long)from->bytes);
    *rows = (int64_t)size[0];
    return QN_OK;
}

static qn_status read_numbers(const recording *from, const char *name, int64_t count,
                              double *numbers)
{
    hid_t data = H5Dopen2(from->file, name, H5P_DEFAULT);
    herr_t failed =
        data < 0 ? -1 : H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers);
    if (data >= 0) H5Dclose(data);
    if (failed < 0) return qn_fail(QN_INPUT, "%s: %s cannot be read", from->path, name);
    for (int64_t i = 0; i < count; i++)
        if (!(fabs(numbers[i]) <= QN_LOAD_FARTHEST))
            return qn_fail(QN_INPUT, "%s: %s holds %g; finite numbers up to %g are allowed",
                           from->path, name, numbers[i], QN_LOAD_FARTHEST);
    return QN_OK;
}

/// A dataset of `rows` x `width` numbers; *numbers stays NULL where the file has none.
static qn_status read_rows(const recording *from, const char *name, int64_t rows, int width,
                           double **numbers)
{
    int64_t found;
    QN_TRY(find_rows(from, name, width, &found));
    if (found == 0) return QN_OK;
    if (found != rows)
        return qn_fail(QN_INPUT, "%s: %s has %lld rows for %lld particles", from->path, name,
                       (long long)found, (long long)rows);
    QN_TRY(qn_allocate((void **)numbers, rows * width, sizeof **numbers));
    return read_numbers(from, name, rows * width, *numbers);
}

static qn_status check_diameters(const recording *from, const qn_particle_list *list)
{
    for (int64_t i = 0; list->diameter && i < list->count; i++)
        if (!(list->diameter[i] > 0))
            return qn_fail(QN_INPUT, "%s: particle %lld has diameter %g m; a size is above 0",
                           from->path, (long long)i + 1, list->diameter[i]);
    return QN_OK;
}

static qn_status read_frame(const recording *from, qn_particle_list *list)
{
    int64_t n = list->count;
    QN_TRY(read_rows(from, "/VTKHDF/Points", n, 3, &list->position));
    QN_TRY(read_rows(from, "/VTKHDF/PointData/velocity", n, 3, &list->velocity));
    QN_TRY(read_rows(from, "/VTKHDF/PointData/spin", n, 3, &list->spin));
    QN_TRY(read_rows(from, "/VTKHDF/PointData/radius", n, 1, &list->diameter));
    for (int64_t i = 0; list->diameter && i < n; i++) list->diameter[i] *= 2;
    return QN_OK;
}

/// rate += half its last change, where the checkpoint has both.
static qn_status bring_up_to_date(const recording *from, const char *name, int64_t n, double *rate)
{
    double *kick = NULL;
    qn_status status = rate ? read_rows(from, name, n, 3, &kick) : QN_OK;
    for (int64_t i = 0; status == QN_OK && kick && i < 3 * n; i++) rate[i] += kick[i];
    free(kick);
    return status;
}

static qn_status read_sizes(const recording *from, qn_particle_list *list, double **klass,
                            double **radius)
{
    int64_t classes;
    QN_TRY(find_rows(from, "/classes/radius", 1, &classes));
    QN_TRY(read_rows(from, "/particles/klass", list->count, 1, klass));
    if (classes == 0 || !*klass) return QN_OK;
    QN_TRY(read_rows(from, "/classes/radius", classes, 1, radius));
    QN_TRY(qn_allocate((void **)&list->diameter, list->count, sizeof *list->diameter));
    for (int64_t i = 0; i < list->count; i++) {
        double k = (*klass)[i];
        if (!(k >= 0 && k < (double)classes))
            return qn_fail(QN_INPUT, "%s: particle %lld is of class %g; there are %lld, from 0",
                           from->path, (long long)i + 1, k, (long long)classes);
        list->diameter[i] = 2 * (*radius)[(int64_t)k];
    }
    return QN_OK;
}

static qn_status read_checkpoint(const recording *from, qn_particle_list *list)
{
    int64_t n = list->count;
    QN_TRY(read_rows(from, "/particles/position", n, 3, &list->position));
    QN_TRY(read_rows(from, "/particles/velocity", n, 3, &list->velocity));
    QN_TRY(read_rows(from, "/particles/spin", n, 3, &list->spin));
    QN_TRY(bring_up_to_date(from, "/particles/kick", n, list->velocity));
    QN_TRY(bring_up_to_date(from, "/particles/spin_kick", n, list->spin));
    double *klass = NULL, *radius = NULL;
    qn_status status = read_sizes(from, list, &klass, &radius);
    free(klass);
    free(radius);
    return status;
}

static qn_status read_either(const recording *from, qn_particle_list *list)
{
    QN_TRY(find_rows(from, "/particles/position", 3, &list->count));
    bool checkpoint = list->count > 0;
    if (!checkpoint) QN_TRY(find_rows(from, "/VTKHDF/Points", 3, &list->count));
    if (list->count == 0)
        return qn_fail(QN_INPUT,
                       "%s: holds neither /VTKHDF/Points (a frame) nor "
                       "/particles/position (a checkpoint)",
                       from->path);
    QN_TRY((checkpoint ? read_checkpoint : read_frame)(from, list));
    return check_diameters(from, list);
}

static qn_status open_and_read(const char *path, qn_particle_list *list)
{
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);  // whatever a damaged file has left open
    hid_t file = H5Fopen(path, H5F_ACC_RDONLY, access);
    H5Pclose(access);
    hsize_t bytes = 0;
    if (file < 0)
        return qn_fail(QN_INPUT, "%s: is not an HDF5 file, or is damaged or cut short", path);
    H5Fget_filesize(file, &bytes);
    qn_status status = read_either(&(recording){path, file, (int64_t)bytes}, list);
    H5Fclose(file);
    return status;
}

qn_status qn_load_recording(const char *path, qn_particle_list *list)
{
    QN_TRY(qn_datafile_check(path));
    H5E_auto2_t report;
    void *data;
    H5Eget_auto2(H5E_DEFAULT, &report, &data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    qn_status status = open_and_read(path, list);
    H5Eset_auto2(H5E_DEFAULT, report, data);
    return status;
}
