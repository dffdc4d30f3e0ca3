// SPDX-License-Identifier: Apache-2.0
#include "record/frames.h"

#include "record/json.h"
#include "record/liner.h"
#include "record/table.h"

#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FRAME_LIST "frames.hdf.series"
#define LINER_LIST "liner.hdf.series"

enum { VTK_POLY_VERTEX = 2, VTK_TRIANGLE = 5, VTK_QUAD = 9 };  // numbers of VTK's cell types

static qn_status put_about(hid_t file, const qn_world *w)
{
    QN_TRY(qn_h5_put_text(file, "format", QN_FRAME_FORMAT));
    QN_TRY(qn_h5_put_text(file, "version", QN_VERSION));
    QN_TRY(qn_h5_put_integer(file, "step", w->step));
    return qn_h5_put_number(file, "time_s", qn_world_time(w));
}

/// The cell types of a grid, one byte each; without a time stamp, as all our datasets.
static qn_status put_types(hid_t grid, const uint8_t *types, int64_t count)
{
    hsize_t extent = (hsize_t)count;
    hid_t how = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(1, &extent, NULL);
    H5Pset_obj_track_times(how, 0);
    hid_t set = H5Dcreate2(grid, "Types", H5T_NATIVE_UINT8, space, H5P_DEFAULT, how, H5P_DEFAULT);
    herr_t done =
        set < 0 ? -1 : H5Dwrite(set, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, types);
    if (set >= 0) H5Dclose(set);
    H5Sclose(space);
    H5Pclose(how);
    return done < 0 ? qn_h5_fail(QN_MEMORY, "could not put down", "Types") : QN_OK;
}

/// Geometry of an unstructured grid (VTKHDF 1.0): points, and cells as runs of corners.
static qn_status put_grid(hid_t file, float *points, int64_t point_count, int64_t *corners,
                          int64_t *offsets, int64_t cell_count, const uint8_t *types)
{
    static const int64_t version[2] = {1, 0};
    int64_t corner_count = offsets[cell_count];
    const qn_column columns[] = {
        {"NumberOfPoints", "1", "points", QN_INT64, 1, 1, &point_count},
        {"NumberOfCells", "1", "cells", QN_INT64, 1, 1, &cell_count},
        {"NumberOfConnectivityIds", "1", "corners", QN_INT64, 1, 1, &corner_count},
        {"Points", "m", "position", QN_FLOAT, 3, point_count, points},
        {"Connectivity", "1", "corners of the cells", QN_INT64, 1, corner_count, corners},
        {"Offsets", "1", "where a cell begins", QN_INT64, 1, cell_count + 1, offsets},
    };
    hid_t grid;
    QN_TRY(qn_table_write(file, "VTKHDF", columns, sizeof columns / sizeof *columns, true));
    QN_TRY(qn_h5_group_open(file, "VTKHDF", &grid));
    qn_status status = qn_h5_put_text(grid, "Type", "UnstructuredGrid");
    if (status == QN_OK) status = qn_h5_put_integers(grid, "Version", version, 2);
    if (status == QN_OK) status = put_types(grid, types, cell_count);
    H5Gclose(grid);
    return status;
}

// ---- Particles -----------------------------------------------------------------------------------

typedef struct row {
    int64_t id, body;
    int32_t klass;
    float radius, position[3], velocity[3], speed, spin[3];
} row;

/// Everything of a frame in one block, sorted by id, and then column by column.
typedef struct columns {
    row *rows;
    int64_t *id, *body, *corners;
    int32_t *klass;
    float *radius, *position, *velocity, *speed, *spin;
} columns;

static int by_id(const void *a, const void *b)
{
    int64_t x = ((const row *)a)->id, y = ((const row *)b)->id;
    return (x > y) - (x < y);
}

static void to_float(float out[3], qn_vec3 v)
{
    out[0] = (float)v.x, out[1] = (float)v.y, out[2] = (float)v.z;
}

static qn_status allocate(columns *c, int64_t n)
{
    QN_TRY(QN_ALLOCATE(c->rows, n));
    QN_TRY(QN_ALLOCATE(c->id, n));
    QN_TRY(QN_ALLOCATE(c->body, n));
    QN_TRY(QN_ALLOCATE(c->corners, n));
    QN_TRY(QN_ALLOCATE(c->klass, n));
    QN_TRY(QN_ALLOCATE(c->radius, n));
    QN_TRY(QN_ALLOCATE(c->position, 3 * n));
    QN_TRY(QN_ALLOCATE(c->velocity, 3 * n));
    QN_TRY(QN_ALLOCATE(c->speed, n));
    return QN_ALLOCATE(c->spin, 3 * n);
}

static void release(columns *c)
{
    free(c->rows);
    free(c->id);
    free(c->body);
    free(c->corners);
    free(c->klass);
    free(c->radius);
    free(c->position);
    free(c->velocity);
    free(c->speed);
    free(c->spin);
}

static void fill(columns *c, const qn_world *w)
{
    for (int i = 0; i < w->count; i++) {
        row *r = &c->rows[i];
        qn_vec3 velocity = qn_velocity_now(w, i);
        r->id = w->id[i];
        r->body = qn_body_of(w, i) < 0 ? r->id : w->bodies[w->body_of[i]].id;
        r->klass = w->place[i].klass;
        r->radius = (float)w->classes[r->klass].radius;
        r->speed = (float)qn_norm(velocity);
        to_float(r->position, qn_world_position(w, i));
        to_float(r->velocity, velocity);
        to_float(r->spin, qn_spin_now(w, i));
    }
    qsort(c->rows, (size_t)w->count, sizeof *c->rows, by_id);
    for (int i = 0; i < w->count; i++) {
        const row *r = &c->rows[i];
        c->corners[i] = i;
        c->id[i] = r->id;
        c->body[i] = r->body;
        c->klass[i] = r->klass;
        c->radius[i] = r->radius;
        c->speed[i] = r->speed;
        memcpy(c->position + 3 * i, r->position, sizeof r->position);
        memcpy(c->velocity + 3 * i, r->velocity, sizeof r->velocity);
        memcpy(c->spin + 3 * i, r->spin, sizeof r->spin);
    }
}

static qn_status put_particles(hid_t file, const qn_world *w, columns *c)
{
    const uint8_t type = VTK_POLY_VERTEX;
    int64_t n = w->count, offsets[2] = {0, n};
    const qn_column data[] = {
        {"id", "1", "persistent number of the particle, from 1", QN_INT64, 1, n, c->id},
        {"body", "1", "of a sphere of a clump: id of the clump's first sphere; else its own id",
         QN_INT64, 1, n, c->body},
        {"class", "1", "index of its class", QN_INT32, 1, n, c->klass},
        {"radius", "m", "of the particle", QN_FLOAT, 1, n, c->radius},
        {"velocity", "m/s", "of the centre", QN_FLOAT, 3, n, c->velocity},
        {"speed", "m/s", "of the centre", QN_FLOAT, 1, n, c->speed},
        {"spin", "rad/s", "of the particle", QN_FLOAT, 3, n, c->spin},
    };
    QN_TRY(put_about(file, w));
    QN_TRY(put_grid(file, c->position, n, c->corners, offsets, 1, &type));
    return qn_table_write(file, "VTKHDF/PointData", data, sizeof data / sizeof *data, true);
}

static qn_status commit_or_close(qn_status status, hid_t file, const char *path)
{
    if (status == QN_OK) return qn_h5_commit_lazily(file, path);
    qn_h5_close(file);
    return status;
}

static qn_status write_particles(const char *path, const qn_world *w)
{
    columns c = {0};
    hid_t file;
    qn_status status = allocate(&c, w->count);
    if (status == QN_OK) {
        fill(&c, w);
        status = qn_h5_begin(&file);
        if (status == QN_OK) status = commit_or_close(put_particles(file, w, &c), file, path);
    }
    release(&c);
    return status;
}

// ---- Liner ---------------------------------------------------------------------------------------

/// What a facet has suffered, by its area, for each cell.
static qn_status put_wear(hid_t file, const qn_world *w, const qn_liner *l)
{
    static const struct {
        const char *name, *unit, *meaning;
    } works[] = {
#define W(NAME, name, unit, meaning) {#name, unit "/m2", meaning ", by the area of the facet"},
        QN_WEARS(W)
#undef W
    };
    float *values;
    qn_status status = QN_ALLOCATE(values, l->cell_count);
    for (int k = 0; status == QN_OK && k < QN_WEAR_COUNT; k++) {
        for (int64_t c = 0; c < l->cell_count; c++)
            values[c] = (float)(qn_wear_value(&w->wear, l->facet[c], k) / l->area[c]);
        const qn_column column = {works[k].name, works[k].unit, works[k].meaning, QN_FLOAT, 1,
                                  l->cell_count, values};
        status = qn_table_write(file, "VTKHDF/CellData", &column, 1, true);
    }
    free(values);
    return status;
}

static qn_status put_liner(hid_t file, const qn_world *w, const qn_liner *l, const uint8_t *types)
{
    const qn_column data[] = {
        {"lifter", "1", "number of the lifter from 1, 0 for shell and meshes", QN_INT32, 1,
         l->cell_count, l->lifter},
        {"part", "1", "of the walls, numbered from 0 as in series.csv", QN_INT32, 1, l->cell_count,
         l->part},
    };
    QN_TRY(put_about(file, w));
    if (w->walls.has_drum) QN_TRY(qn_h5_put_number(file, "drum_radius_m", w->walls.profile.radius));
    QN_TRY(put_grid(file, l->points, l->point_count, l->corners, l->offsets, l->cell_count, types));
    QN_TRY(qn_table_write(file, "VTKHDF/CellData", data, sizeof data / sizeof *data, true));
    return put_wear(file, w, l);
}

static qn_status write_liner(const char *path, const qn_world *w)
{
    qn_liner liner;
    uint8_t *types = NULL;
    hid_t file;
    QN_TRY(qn_liner_draw(&w->walls, qn_world_time(w), &liner));
    qn_status status = QN_ALLOCATE(types, liner.cell_count);
    for (int64_t i = 0; status == QN_OK && i < liner.cell_count; i++)
        types[i] = liner.offsets[i + 1] - liner.offsets[i] == 4 ? VTK_QUAD : VTK_TRIANGLE;
    if (status == QN_OK && liner.cell_count > 0) {
        status = qn_h5_begin(&file);
        if (status == QN_OK)
            status = commit_or_close(put_liner(file, w, &liner, types), file, path);
    }
    free(types);
    qn_liner_free(&liner);
    return status;
}

// ---- Files ---------------------------------------------------------------------------------------

static const char *path_of(char path[QN_FILE_NAME_MAX], const char *folder, const char *kind,
                           int64_t number)
{
    snprintf(path, QN_FILE_NAME_MAX, "%s/%s_%06" PRId64 ".hdf", folder, kind, number);
    return path;
}

qn_status qn_frames_write(const char *folder, int64_t number, const qn_world *world)
{
    char path[QN_FILE_NAME_MAX];
    QN_TRY(write_particles(path_of(path, folder, "frame", number), world));
    return write_liner(path_of(path, folder, "liner", number), world);
}

static qn_status write_list(const char *path, const char *kind, const int64_t *steps, int64_t count,
                            double dt)
{
    qn_json json;
    char name[64], *text;
    qn_json_begin(&json);
    qn_json_text(&json, "file-series-version", "1.0");
    qn_json_open(&json, "files", '[');
    for (int64_t i = 0; i < count; i++) {
        snprintf(name, sizeof name, "%s_%06" PRId64 ".hdf", kind, i);
        qn_json_open(&json, NULL, '{');
        qn_json_text(&json, "name", name);
        qn_json_number(&json, "time", (double)steps[i] * dt);
        qn_json_close(&json);
    }
    QN_TRY(qn_json_end(&json, &text));
    qn_status status = qn_atomic_write_lazily(path, text, strlen(text));
    free(text);
    return status;
}

qn_status qn_frames_list(const char *folder, const int64_t *steps, int64_t count,
                         const qn_world *world)
{
    char path[QN_FILE_NAME_MAX];
    qn_path_join(path, folder, FRAME_LIST);
    QN_TRY(write_list(path, "frame", steps, count, world->dt));
    if (!world->walls.has_drum && world->walls.mesh_count == 0) return QN_OK;
    qn_path_join(path, folder, LINER_LIST);
    return write_list(path, "liner", steps, count, world->dt);
}

qn_status qn_frames_sync(const char *folder, int64_t first, int64_t count)
{
    char path[QN_FILE_NAME_MAX];
    if (first >= count) return QN_OK;
    for (int64_t i = first; i < count; i++) {
        QN_TRY(qn_file_sync(path_of(path, folder, "frame", i)));
        QN_TRY(qn_file_sync(path_of(path, folder, "liner", i)));
    }
    QN_TRY(qn_file_sync(qn_path_join(path, folder, LINER_LIST)));
    QN_TRY(qn_file_sync(qn_path_join(path, folder, FRAME_LIST)));
    return qn_file_sync_name(path);
}

qn_status qn_frames_cut(const char *folder, int64_t first)
{
    qn_status status = QN_OK;
    DIR *entries = opendir(folder);
    if (!entries && errno == ENOENT) return QN_OK;
    if (!entries) return qn_fail(QN_IO, "%s could not be read: %s", folder, strerror(errno));
    for (struct dirent *e; status == QN_OK && (e = readdir(entries));) {
        char path[QN_FILE_NAME_MAX];
        int64_t number;
        bool ours = sscanf(e->d_name, "frame_%" SCNd64 ".hdf", &number) == 1
                    || sscanf(e->d_name, "liner_%" SCNd64 ".hdf", &number) == 1;
        if (ours && number >= first) status = qn_file_remove(qn_path_join(path, folder, e->d_name));
    }
    closedir(entries);
    return status;
}
