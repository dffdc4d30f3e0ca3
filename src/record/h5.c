// SPDX-License-Identifier: Apache-2.0
#include "record/h5.h"

#include "base/array.h"
#include "record/atomic_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { GROWTH = 4 << 20 };  // bytes   by which a file in memory grows

static herr_t keep_innermost(unsigned n, const H5E_error2_t *error, void *text)
{
    if (n == 0) snprintf(text, 200, "%s", error->desc ? error->desc : "unknown");
    return 0;
}

qn_status qn_h5_fail(qn_status status, const char *what, const char *name)
{
    char text[200] = "";
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, text);
    H5Eclear2(H5E_DEFAULT);
    return qn_fail(status, "%s %s%s%s", what, name, *text ? ": HDF5 says: " : "", text);
}

static void silence(void)
{
    H5open();
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
}

qn_status qn_h5_begin(hid_t *file)
{
    silence();
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    herr_t made = H5Pset_fapl_core(access, GROWTH, 0);
    *file = made < 0 ? -1 : H5Fcreate("in-memory", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    return *file < 0 ? qn_h5_fail(QN_MEMORY, "could not begin", "a file in memory") : QN_OK;
}

typedef qn_status writer(const char *path, const void *data, size_t bytes);

static qn_status commit(hid_t file, const char *path, writer *write_file)
{
    void **image = NULL;
    qn_status status;
    ssize_t bytes = H5Fflush(file, H5F_SCOPE_GLOBAL) < 0 ? -1 : H5Fget_file_image(file, NULL, 0);
    if (bytes < 0 || H5Fget_vfd_handle(file, H5P_DEFAULT, (void **)&image) < 0)
        status = qn_h5_fail(QN_MEMORY, "could not put together", path);
    else
        status = write_file(path, *image, (size_t)bytes);
    H5Fclose(file);
    return status;
}

qn_status qn_h5_commit(hid_t file, const char *path)
{
    return commit(file, path, qn_atomic_write);
}

qn_status qn_h5_commit_lazily(hid_t file, const char *path)
{
    return commit(file, path, qn_atomic_write_lazily);
}

qn_status qn_h5_open(const char *path, hid_t *file)
{
    silence();
    *file = -1;
    if (access(path, R_OK) != 0)
        return qn_fail(QN_IO, "%s could not be read: %s", path, strerror(errno));
    if (H5Fis_hdf5(path) <= 0)
        return qn_fail(QN_IO, "%s is no HDF5 file, or the beginning of it is damaged", path);
    *file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    return *file < 0 ? qn_h5_fail(QN_IO, "could not open", path) : QN_OK;
}

void qn_h5_close(hid_t file)
{
    if (file >= 0) H5Fclose(file);
}

bool qn_h5_has(hid_t parent, const char *name)
{
    return H5Lexists(parent, name, H5P_DEFAULT) > 0;
}

qn_status qn_h5_group_open(hid_t parent, const char *name, hid_t *group)
{
    *group = qn_h5_has(parent, name) ? H5Gopen2(parent, name, H5P_DEFAULT) : -1;
    return *group < 0 ? qn_h5_fail(QN_IO, "there is no group", name) : QN_OK;
}

qn_status qn_h5_group(hid_t parent, const char *name, hid_t *group)
{
    if (qn_h5_has(parent, name)) return qn_h5_group_open(parent, name, group);
    *group = H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    return *group < 0 ? qn_h5_fail(QN_MEMORY, "could not make the group", name) : QN_OK;
}

/// An attribute of `type` holding one value (count 0) or a list of them.
static qn_status put(hid_t object, const char *name, hid_t type, const void *values, int count)
{
    hsize_t extent = (hsize_t)count;
    hid_t space = count ? H5Screate_simple(1, &extent, NULL) : H5Screate(H5S_SCALAR);
    hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    herr_t done = attribute < 0 ? -1 : H5Awrite(attribute, type, values);
    if (attribute >= 0) H5Aclose(attribute);
    H5Sclose(space);
    return done < 0 ? qn_h5_fail(QN_MEMORY, "could not write the attribute", name) : QN_OK;
}

static hid_t text_type(size_t length)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, length > 0 ? length : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

qn_status qn_h5_put_text(hid_t object, const char *name, const char *text)
{
    hid_t type = text_type(strlen(text));
    qn_status status = put(object, name, type, text, 0);
    H5Tclose(type);
    return status;
}

qn_status qn_h5_put_names(hid_t object, const char *name, const char *first, size_t stride,
                          int count)
{
    char *names = NULL;
    size_t longest = 1;
    if (count == 0) return QN_OK;
    for (int i = 0; i < count; i++) {
        size_t length = strlen(first + (size_t)i * stride);
        longest = length > longest ? length : longest;
    }
    QN_TRY(qn_allocate((void **)&names, count, longest));
    for (int i = 0; i < count; i++) {
        const char *text = first + (size_t)i * stride;
        memcpy(names + (size_t)i * longest, text, strlen(text));
    }
    hid_t type = text_type(longest);
    qn_status status = put(object, name, type, names, count);
    H5Tclose(type);
    free(names);
    return status;
}

qn_status qn_h5_put_integers(hid_t object, const char *name, const int64_t *values, int count)
{
    return put(object, name, H5T_NATIVE_INT64, values, count);
}

qn_status qn_h5_put_integer(hid_t object, const char *name, int64_t value)
{
    return put(object, name, H5T_NATIVE_INT64, &value, 0);
}

qn_status qn_h5_put_numbers(hid_t object, const char *name, const double *values, int count)
{
    return put(object, name, H5T_NATIVE_DOUBLE, values, count);
}

qn_status qn_h5_put_number(hid_t object, const char *name, double value)
{
    return put(object, name, H5T_NATIVE_DOUBLE, &value, 0);
}

/// Reads a scalar attribute as `type`, if it is of the class of that type.
static qn_status get(hid_t object, const char *name, hid_t type, void *value)
{
    hid_t attribute = H5Aexists(object, name) > 0 ? H5Aopen(object, name, H5P_DEFAULT) : -1;
    if (attribute < 0) return qn_h5_fail(QN_IO, "there is no attribute", name);
    hid_t stored = H5Aget_type(attribute), space = H5Aget_space(attribute);
    bool fits =
        H5Tget_class(stored) == H5Tget_class(type) && H5Sget_simple_extent_npoints(space) == 1;
    herr_t done = fits ? H5Aread(attribute, type, value) : -1;
    H5Sclose(space);
    H5Tclose(stored);
    H5Aclose(attribute);
    return done < 0 ? qn_h5_fail(QN_IO, "could not read the attribute", name) : QN_OK;
}

qn_status qn_h5_get_text(hid_t object, const char *name, char *text, size_t room)
{
    hid_t type = text_type(room - 1);
    memset(text, 0, room);
    qn_status status = get(object, name, type, text);
    H5Tclose(type);
    return status;
}

qn_status qn_h5_get_integer(hid_t object, const char *name, int64_t *value)
{
    return get(object, name, H5T_NATIVE_INT64, value);
}

qn_status qn_h5_get_number(hid_t object, const char *name, double *value)
{
    return get(object, name, H5T_NATIVE_DOUBLE, value);
}
