// SPDX-License-Identifier: Apache-2.0
// Lists of spheres: tables of text, and the raw binary format of the reference document.
//
// Source of the binary format: the reference document, section 5.2.1, Fig 5.8: one array of four
//         doubles a sphere, the fourth being 1 for those that make up a wall. They are left out,
//         because a scene describes its walls itself.
#include "base/array.h"
#include "scene/load_datafile.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ROOM = INT_MAX / 3 };  // spheres in one file

// clang-format off
//    name        array      index length  meaning
#define COLUMNS(C)                                                             \
    C("x",        POSITION,  0,    true)                                       \
    C("y",        POSITION,  1,    true)                                       \
    C("z",        POSITION,  2,    true)                                       \
    C("vx",       VELOCITY,  0,    false)                                      \
    C("vy",       VELOCITY,  1,    false)                                      \
    C("vz",       VELOCITY,  2,    false)                                      \
    C("wx",       SPIN,      0,    false)                                      \
    C("wy",       SPIN,      1,    false)                                      \
    C("wz",       SPIN,      2,    false)                                      \
    C("diameter", DIAMETER,  0,    true)                                       \
    C("radius",   RADIUS,    0,    true)                                       \
    C("id",       UNUSED,    0,    false)
// clang-format on

enum group { POSITION, VELOCITY, SPIN, DIAMETER, RADIUS, UNUSED, GROUP_COUNT };

static const struct {
    const char *name;
    enum group group;
    int index;
    bool length;
} columns[] = {
#define C(name, group, index, length) {name, group, index, length},
    COLUMNS(C)
#undef C
};

#define C(name, group, index, length) " " name
static const char allowed[] = COLUMNS(C);
#undef C

enum { COLUMN_COUNT = sizeof columns / sizeof columns[0] };

/// Which column of the list above each column of the file is.
struct table {
    int count;
    int column[COLUMN_COUNT];
    int seen[GROUP_COUNT];  // columns found of each group
};

static int find_column(qn_line word)
{
    if (word.end - word.begin > 2 && *word.begin == '"' && word.end[-1] == '"') {
        word.begin++;
        word.end--;
    }
    for (int i = 0; i < COLUMN_COUNT; i++) {
        size_t length = strlen(columns[i].name);
        if (length == (size_t)(word.end - word.begin)
            && strncasecmp(word.begin, columns[i].name, length) == 0)
            return i;
    }
    return -1;
}

static qn_status read_header(qn_datafile *file, struct table *table)
{
    qn_line line, word;
    if (!qn_datafile_line(file, &line))
        return qn_fail(QN_INPUT, "%s: holds only comments; the first line names the columns:%s",
                       file->path, allowed);
    while (qn_line_word(&line, &word)) {
        int column = find_column(word), length = (int)(word.end - word.begin);
        if (length > 40) length = 40;
        if (column < 0)
            return qn_fail(QN_INPUT, "%s:%lld: '%.*s' is not a column; columns are%s", file->path,
                           (long long)file->line, length, word.begin, allowed);
        for (int i = 0; i < table->count; i++)
            if (table->column[i] == column)
                return qn_fail(QN_INPUT, "%s:%lld: column '%s' is there twice", file->path,
                               (long long)file->line, columns[column].name);
        table->column[table->count++] = column;
        table->seen[columns[column].group]++;
    }
    if (table->seen[POSITION] != 3 || table->seen[VELOCITY] % 3 || table->seen[SPIN] % 3
        || table->seen[DIAMETER] + table->seen[RADIUS] > 1)
        return qn_fail(QN_INPUT,
                       "%s:%lld: the columns must be x y z, then vx vy vz or none of them, wx wy "
                       "wz or none of them, and diameter or radius or neither",
                       file->path, (long long)file->line);
    return QN_OK;
}

static qn_status store_row(const qn_datafile *file, const struct table *table, double unit,
                           const double *row, int64_t i, qn_particle_list *list)
{
    for (int c = 0; c < table->count; c++) {
        int column = table->column[c];
        double value = row[c];
        if (columns[column].length) QN_TRY(qn_datafile_length(file, value, unit, &value));
        double *place[GROUP_COUNT] = {
            [POSITION] = list->position, [VELOCITY] = list->velocity, [SPIN] = list->spin,
            [DIAMETER] = list->diameter, [RADIUS] = list->diameter,
        };
        enum group group = columns[column].group;
        if (group == UNUSED) continue;
        if (group == DIAMETER || group == RADIUS) {
            if (!(value > 0))
                return qn_fail(QN_INPUT, "%s:%lld: %s = %g; a size is above 0", file->path,
                               (long long)file->line, columns[column].name, row[c]);
            place[group][i] = group == RADIUS ? 2 * value : value;
        } else {
            place[group][3 * i + columns[column].index] = value;
        }
    }
    return QN_OK;
}

static qn_status read_table(qn_datafile *file, double unit, qn_particle_list *list)
{
    struct table table = {0};
    QN_TRY(read_header(file, &table));
    list->count = qn_datafile_lines_left(file);
    if (list->count < 1 || list->count > ROOM)
        return qn_fail(QN_INPUT, "%s: %lld spheres; 1 to %d are allowed", file->path,
                       (long long)list->count, ROOM);
    QN_TRY(QN_ALLOCATE(list->position, 3 * list->count));
    if (table.seen[VELOCITY]) QN_TRY(QN_ALLOCATE(list->velocity, 3 * list->count));
    if (table.seen[SPIN]) QN_TRY(QN_ALLOCATE(list->spin, 3 * list->count));
    if (table.seen[DIAMETER] + table.seen[RADIUS]) QN_TRY(QN_ALLOCATE(list->diameter, list->count));
    qn_line line;
    double row[COLUMN_COUNT];
    for (int64_t i = 0; qn_datafile_line(file, &line); i++) {
        QN_TRY(qn_line_numbers(file, line, table.count, "one for each column", row));
        QN_TRY(store_row(file, &table, unit, row, i, list));
    }
    return QN_OK;
}

static qn_status load_table(const char *path, double unit, qn_particle_list *list)
{
    qn_datafile file;
    QN_TRY(qn_datafile_read_text(path, &file));
    qn_status status = read_table(&file, unit, list);
    qn_datafile_free(&file);
    return status;
}

static double little_endian_double(const char *bytes)
{
    uint64_t bits = 0;
    for (int i = 7; i >= 0; i--) bits = bits << 8 | (unsigned char)bytes[i];
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static qn_status read_raw(const qn_datafile *file, double unit, qn_particle_list *list)
{
    enum { RECORD = 32 };  // bytes   of a sphere
    if (file->size % RECORD != 0 || file->size / RECORD > ROOM)
        return qn_fail(QN_INPUT,
                       "%s: %zu bytes; a raw list has %d a sphere (four doubles), and at most %d "
                       "spheres",
                       file->path, file->size, RECORD, ROOM);
    int64_t records = (int64_t)(file->size / RECORD);
    QN_TRY(QN_ALLOCATE(list->position, 3 * records));
    for (int64_t i = 0; i < records; i++) {
        double value[4];
        for (int k = 0; k < 4; k++)
            value[k] = little_endian_double(file->data + RECORD * i + 8 * k);
        bool wall = value[3] == 1;
        if (!wall && value[3] != 0)
            return qn_fail(QN_INPUT,
                           "%s: sphere %lld of %lld has %g as its fourth number; 0 (free) and 1 "
                           "(part of a wall) are allowed",
                           file->path, (long long)i + 1, (long long)records, value[3]);
        if (wall) continue;
        for (int axis = 0; axis < 3; axis++)
            if (!qn_length_from(value[axis], unit, &list->position[3 * list->count + axis]))
                return qn_fail(QN_INPUT,
                               "%s: sphere %lld of %lld has %g among its coordinates; finite "
                               "ones up to %g m are allowed",
                               file->path, (long long)i + 1, (long long)records, value[axis],
                               QN_LOAD_FARTHEST);
        list->count++;
    }
    if (list->count == 0)
        return qn_fail(QN_INPUT, "%s: all %lld spheres are part of a wall; none is free",
                       file->path, (long long)records);
    return QN_OK;
}

static qn_status load_raw(const char *path, double unit, qn_particle_list *list)
{
    qn_datafile file;
    QN_TRY(qn_datafile_read(path, &file));
    qn_status status = read_raw(&file, unit, list);
    qn_datafile_free(&file);
    return status;
}

static qn_status load_by_extension(const char *path, double unit, qn_particle_list *list)
{
    if (qn_path_has_extension(path, ".csv .txt")) return load_table(path, unit, list);
    if (qn_path_has_extension(path, ".bin .raw")) return load_raw(path, unit, list);
    if (!qn_path_has_extension(path, ".hdf .h5"))
        return qn_fail(QN_INPUT,
                       "%s: which kind of file is this? particles come from .csv .txt "
                       "(table), .bin .raw (four doubles each), .hdf .h5 (recording)",
                       path);
    if (unit != 1)
        return qn_fail(QN_INPUT, "%s: recordings are in metres; unit = %g m, allowed is 1 m", path,
                       unit);
    return qn_load_recording(path, list);
}

qn_status qn_load_particles(const char *path, double unit, qn_particle_list *list)
{
    qn_particle_list fresh = {0};
    qn_status status = load_by_extension(path, unit, &fresh);
    if (status == QN_OK)
        *list = fresh;
    else
        qn_particle_list_free(&fresh);
    return status;
}

void qn_particle_list_free(qn_particle_list *list)
{
    free(list->position);
    free(list->velocity);
    free(list->spin);
    free(list->diameter);
    *list = (qn_particle_list){0};
}
