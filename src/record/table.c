// SPDX-License-Identifier: Apache-2.0
#include "record/table.h"

#include "base/hash.h"

#include <stdio.h>
#include <string.h>

enum { SMALL = 4096, ROWS_PER_CHUNK = 65536 };  // bytes below which nothing is compressed, 1

// clang-format off
//    type     bytes  in memory           in words
#define TYPES(T)                                                          \
    T(INT32,   4,     H5T_NATIVE_INT32,   "32-bit whole numbers")         \
    T(INT64,   8,     H5T_NATIVE_INT64,   "64-bit whole numbers")         \
    T(FLOAT,   4,     H5T_NATIVE_FLOAT,   "32-bit numbers")               \
    T(DOUBLE,  8,     H5T_NATIVE_DOUBLE,  "64-bit numbers")
// clang-format on

static const struct {
    size_t bytes;
    const char *words;
} types[] = {
#define T(NAME, bytes, native, words) [QN_##NAME] = {bytes, words},
    TYPES(T)
#undef T
};

static hid_t native(qn_type type)
{
    switch (type) {
#define T(NAME, bytes, native, words) \
    case QN_##NAME: return native;
        TYPES(T)
#undef T
    }
    return -1;
}

static size_t bytes_of(const qn_column *c)
{
    return (size_t)c->rows * (size_t)c->width * types[c->type].bytes;
}

static uint64_t hash_column(const qn_column *c)
{
    uint64_t about[3] = {(uint64_t)c->type, (uint64_t)c->width, (uint64_t)c->rows};
    uint64_t hash = qn_hash(QN_HASH_START, c->name, strlen(c->name));
    hash = qn_hash(hash, about, sizeof about);
    return qn_hash(hash, c->data, bytes_of(c));
}

/// Layout of a dataset: plain, or in compressed chunks; no time stamp, so that equal content gives
/// equal bytes.
static hid_t layout(const qn_column *c, bool squeeze)
{
    hid_t how = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(how, 0);
    if (squeeze && bytes_of(c) > SMALL) {
        int64_t rows = c->rows < ROWS_PER_CHUNK ? c->rows : ROWS_PER_CHUNK;
        hsize_t chunk[2] = {(hsize_t)rows, (hsize_t)c->width};
        H5Pset_chunk(how, c->width > 1 ? 2 : 1, chunk);
        H5Pset_shuffle(how);
        H5Pset_deflate(how, 1);
    }
    return how;
}

static qn_status write_column(hid_t group, const qn_column *c, bool squeeze)
{
    hsize_t extent[2] = {(hsize_t)c->rows, (hsize_t)c->width};
    hid_t links = H5Pcreate(H5P_LINK_CREATE), how = layout(c, squeeze);
    hid_t space = H5Screate_simple(c->width > 1 ? 2 : 1, extent, NULL);
    H5Pset_create_intermediate_group(links, 1);
    hid_t set = H5Dcreate2(group, c->name, native(c->type), space, links, how, H5P_DEFAULT);
    herr_t done = set < 0 ? -1 : 0;
    if (done >= 0 && c->rows > 0)
        done = H5Dwrite(set, native(c->type), H5S_ALL, H5S_ALL, H5P_DEFAULT, c->data);
    qn_status status = done < 0 ? qn_h5_fail(QN_MEMORY, "could not put down", c->name) : QN_OK;
    if (status == QN_OK) status = qn_h5_put_text(set, "unit", c->unit);
    if (status == QN_OK) status = qn_h5_put_text(set, "meaning", c->meaning);
    if (status == QN_OK) status = qn_h5_put_integer(set, "hash", (int64_t)hash_column(c));
    if (set >= 0) H5Dclose(set);
    H5Sclose(space);
    H5Pclose(how);
    H5Pclose(links);
    return status;
}

qn_status qn_table_write(hid_t parent, const char *name, const qn_column *columns, int count,
                         bool squeeze)
{
    hid_t group;
    QN_TRY(qn_h5_group(parent, name, &group));
    qn_status status = QN_OK;
    for (int i = 0; i < count && status == QN_OK; i++)
        status = write_column(group, &columns[i], squeeze);
    H5Gclose(group);
    return status;
}

/// Checks what is stored against what is wanted, in words.
static qn_status check_shape(hid_t set, const char *table, const qn_column *c)
{
    hsize_t extent[H5S_MAX_RANK] = {0, 1};
    hid_t type = H5Dget_type(set), space = H5Dget_space(set);
    int rank = H5Sget_simple_extent_ndims(space);
    H5Sget_simple_extent_dims(space, extent, NULL);
    bool same_type = H5Tequal(type, native(c->type)) > 0;
    H5Sclose(space);
    H5Tclose(type);
    if (rank < 2) extent[1] = 1;
    if (!same_type)
        return qn_fail(QN_IO, "%s/%s does not hold %s", table, c->name, types[c->type].words);
    if (rank < 1 || rank > 2 || extent[0] != (hsize_t)c->rows || extent[1] != (hsize_t)c->width)
        return qn_fail(QN_IO, "%s/%s has %lld rows of %lld numbers, expected %lld of %d", table,
                       c->name, (long long)extent[0], (long long)extent[1], (long long)c->rows,
                       c->width);
    return QN_OK;
}

static qn_status read_column(hid_t group, const char *table, const qn_column *c)
{
    int64_t hash = 0;
    hid_t set = H5Oexists_by_name(group, c->name, H5P_DEFAULT) > 0
                    ? H5Dopen2(group, c->name, H5P_DEFAULT)
                    : -1;
    if (set < 0) return qn_fail(QN_IO, "%s has no column %s", table, c->name);
    qn_status status = check_shape(set, table, c);
    if (status == QN_OK && c->rows > 0
        && H5Dread(set, native(c->type), H5S_ALL, H5S_ALL, H5P_DEFAULT, c->data) < 0)
        status = qn_h5_fail(QN_IO, "could not read", c->name);
    if (status == QN_OK) status = qn_h5_get_integer(set, "hash", &hash);
    if (status == QN_OK && (uint64_t)hash != hash_column(c))
        status = qn_fail(QN_IO, "%s/%s is damaged: its numbers are not those that were written",
                         table, c->name);
    H5Dclose(set);
    return status;
}

qn_status qn_table_read(hid_t parent, const char *name, const qn_column *columns, int count)
{
    hid_t group;
    QN_TRY(qn_h5_group_open(parent, name, &group));
    qn_status status = QN_OK;
    for (int i = 0; i < count && status == QN_OK; i++)
        status = read_column(group, name, &columns[i]);
    H5Gclose(group);
    return status;
}

qn_status qn_table_rows(hid_t parent, const char *name, const char *column, int64_t *rows)
{
    hid_t group;
    hsize_t extent[H5S_MAX_RANK] = {0};
    QN_TRY(qn_h5_group_open(parent, name, &group));
    hid_t set = qn_h5_has(group, column) ? H5Dopen2(group, column, H5P_DEFAULT) : -1;
    if (set >= 0) {
        hid_t space = H5Dget_space(set);
        H5Sget_simple_extent_dims(space, extent, NULL);
        H5Sclose(space);
        H5Dclose(set);
    }
    H5Gclose(group);
    if (set < 0) return qn_fail(QN_IO, "%s has no column %s", name, column);
    *rows = (int64_t)extent[0];
    return QN_OK;
}
