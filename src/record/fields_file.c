// SPDX-License-Identifier: Apache-2.0
#include "record/fields_file.h"

#include "record/atomic_file.h"
#include "record/table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// A dataset of [nz, ny, nx] numbers; volumes carry their unit in the name.
static qn_status put_voxels(hid_t group, const char *name, const char *unit, const char *meaning,
                            const qn_field *f, hid_t type, const double *numbers)
{
    char full[QN_NAME_MAX + 8];
    hsize_t extent[3] = {(hsize_t)f->nz, (hsize_t)f->ny, (hsize_t)f->nx};
    snprintf(full, sizeof full, "%s%s", name, strcmp(unit, "m3") == 0 ? "_m3" : "");
    hid_t how = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(3, extent, NULL);
    H5Pset_obj_track_times(how, 0);
    H5Pset_chunk(how, 3, extent);
    H5Pset_shuffle(how);
    H5Pset_deflate(how, 1);
    hid_t set = H5Dcreate2(group, full, type, space, H5P_DEFAULT, how, H5P_DEFAULT);
    herr_t done =
        set < 0 ? -1 : H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers);
    qn_status status = done < 0 ? qn_h5_fail(QN_MEMORY, "could not put down", full) : QN_OK;
    if (status == QN_OK) status = qn_h5_put_text(set, "unit", unit);
    if (status == QN_OK) status = qn_h5_put_text(set, "meaning", meaning);
    if (set >= 0) H5Dclose(set);
    H5Sclose(space);
    H5Pclose(how);
    return status;
}

static qn_status put_sums(hid_t group, const qn_field *f, double *numbers)
{
    int64_t voxels = qn_field_voxel_count(f);
#define F(name, unit, meaning)                                                                  \
    for (int64_t v = 0; v < voxels; v++)                                                        \
        numbers[v] = qn_field_unit(f, QN_FIELD_##name) * (double)f->sum[QN_FIELD_##name][v];    \
    QN_TRY(put_voxels(group, #name, unit, meaning, f,                                           \
                      QN_FIELD_##name == QN_FIELD_count ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE, \
                      numbers));
    QN_FIELD_SUMS(F)
#undef F
    return put_voxels(group, "open_volume", "m3", "volume particles can be in", f,
                      H5T_NATIVE_DOUBLE, f->open_volume);
}

static qn_status put_means(hid_t group, const qn_field *f, double *numbers)
{
    int64_t voxels = qn_field_voxel_count(f);
#define F(name, unit, meaning)                                                   \
    for (int64_t v = 0; v < voxels; v++) numbers[v] = qn_field_voxel(f, v).name; \
    QN_TRY(put_voxels(group, #name, unit, meaning, f, H5T_NATIVE_DOUBLE, numbers));
    QN_FIELD_MEANS(F)
#undef F
    return QN_OK;
}

static qn_status put_geometry(hid_t group, const qn_field *f, const qn_world *w)
{
    const double origin[3] = {f->x0, f->y0, f->z0};
    QN_TRY(qn_h5_put_number(group, "cell_m", f->side));
    QN_TRY(qn_h5_put_number(group, "layer_m", f->layer));
    QN_TRY(qn_h5_put_numbers(group, "origin_m", origin, 3));
    QN_TRY(qn_h5_put_integer(group, "samples", f->samples));
    QN_TRY(qn_h5_put_number(group, "radius_m", w->largest_radius));
    QN_TRY(qn_h5_put_number(group, "drum_radius_m", w->walls.profile.radius));
    QN_TRY(qn_h5_put_number(group, "first_time_s", (double)f->first_step * w->dt));
    return qn_h5_put_number(group, "last_time_s", (double)f->last_step * w->dt);
}

static qn_status put_field(hid_t file, int index, const qn_field *f, const qn_world *w)
{
    char name[32];
    double *numbers;
    hid_t group;
    snprintf(name, sizeof name, "grid_%d", index);
    QN_TRY(QN_ALLOCATE(numbers, qn_field_voxel_count(f)));
    qn_status status = qn_h5_group(file, name, &group);
    if (status == QN_OK) {
        status = put_geometry(group, f, w);
        if (status == QN_OK) status = put_sums(group, f, numbers);
        if (status == QN_OK) status = put_means(group, f, numbers);
        H5Gclose(group);
    }
    free(numbers);
    return status;
}

static qn_status put_ring(hid_t file, const qn_ring *ring)
{
    double angle[QN_RING_BINS], solidity[QN_RING_BINS];
    for (int i = 0; i < QN_RING_BINS; i++) {
        angle[i] = qn_ring_angle(i);
        solidity[i] = qn_ring_solidity(ring, i);
    }
    const qn_column columns[] = {
        {"angle_deg", "deg",
         "middle of the bin, from straight down, positive in the sense of rotation", QN_DOUBLE, 1,
         QN_RING_BINS, angle},
        {"solidity", "1", "solid volume in the open volume of the bin", QN_DOUBLE, 1, QN_RING_BINS,
         solidity},
    };
    hid_t group;
    QN_TRY(qn_table_write(file, "ring", columns, 2, false));
    QN_TRY(qn_h5_group_open(file, "ring", &group));
    qn_status status = qn_h5_put_number(group, "inner_radius_m", ring->inner_radius);
    if (status == QN_OK) status = qn_h5_put_integer(group, "samples", ring->samples);
    H5Gclose(group);
    return status;
}

qn_status qn_fields_write(const char *path, const qn_measure *measure, const qn_world *world)
{
    bool begun = false;
    hid_t file;
    for (int i = 0; i < measure->field_count; i++) begun |= measure->fields[i].samples > 0;
    if (!begun) return QN_OK;
    QN_TRY(qn_h5_begin(&file));
    qn_status status = qn_h5_put_text(file, "format", QN_RECORDING_FORMAT);
    if (status == QN_OK) status = qn_h5_put_integer(file, "samples_least", measure->fields_least);
    for (int i = 0; i < measure->field_count && status == QN_OK; i++)
        status = put_field(file, i, &measure->fields[i], world);
    if (status == QN_OK && measure->ring.samples > 0) status = put_ring(file, &measure->ring);
    if (status == QN_OK) return qn_h5_commit(file, path);
    qn_h5_close(file);
    return status;
}
