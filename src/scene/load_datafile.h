// SPDX-License-Identifier: Apache-2.0
// What the loaders share: a file in memory, its lines, its numbers, and limits.
//
// A file is read whole, followed by a zero byte. Lines are handed out one at a time without being
// copied; blank lines, comments (from # on) and a carriage return at the end are passed over.
#ifndef QN_SCENE_LOAD_DATAFILE_H
#define QN_SCENE_LOAD_DATAFILE_H

#include "base/error.h"
#include "scene/load.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// m   furthest coordinate that is taken for a length in a mill
#define QN_LOAD_FARTHEST 1e6

typedef struct qn_datafile {
    const char *path;  // not owned
    char *data;        // owned, zero after the last byte
    size_t size;       // bytes
    const char *next;  // where the next line starts
    int64_t line;      // number of the line handed out last, from 1
} qn_datafile;

/// A line's text without comment: [begin, end).
typedef struct qn_line {
    const char *begin, *end;
} qn_line;

/// QN_IO where the file cannot be looked at; QN_INPUT where it is a folder, not an ordinary file,
/// empty or above 2 GB.
QN_NODISCARD qn_status qn_datafile_check(const char *path);

/// Reads a whole file that passes qn_datafile_check. QN_IO where it cannot be opened or read.
QN_NODISCARD qn_status qn_datafile_read(const char *path, qn_datafile *file);

/// As qn_datafile_read for text: passes over a byte order mark and refuses control characters.
QN_NODISCARD qn_status qn_datafile_read_text(const char *path, qn_datafile *file);

void qn_datafile_free(qn_datafile *file);

/// The next line that has something on it; false at the end of the file.
bool qn_datafile_line(qn_datafile *file, qn_line *line);

/// How many lines with something on them are left.
int64_t qn_datafile_lines_left(const qn_datafile *file);

/// Next word of a line, apart from others by blanks, commas or semicolons; false where none is left.
bool qn_line_word(qn_line *line, qn_line *word);

/// Exactly `count` finite numbers that make up the line; `what` names them in the message.
QN_NODISCARD qn_status qn_line_numbers(const qn_datafile *file, qn_line line, int count,
                                       const char *what, double *numbers);

/// As qn_line_numbers for whole numbers from `low` to `high`.
QN_NODISCARD qn_status qn_line_integers(const qn_datafile *file, qn_line line, int count,
                                        const char *what, int64_t low, int64_t high,
                                        int64_t *numbers);

/// value x unit as a length; false where it is not finite or beyond QN_LOAD_FARTHEST.
bool qn_length_from(double value, double unit, double *metres);

/// The same for a number on the line handed out last; QN_INPUT names the line.
QN_NODISCARD qn_status qn_datafile_length(const qn_datafile *file, double value, double unit,
                                          double *metres);

/// True where the path ends in one of the extensions in `list` (".stl .obj"), in either case.
bool qn_path_has_extension(const char *path, const char *list);

/// The three kinds of mesh file that a library reads; load_mesh.c picks.
QN_NODISCARD qn_status qn_load_mesh_library(const char *path, double unit, double **vertices,
                                            int *vertex_count, int **triangles,
                                            int *triangle_count);

/// Spheres of a frame or a checkpoint; load_particles.c picks.
QN_NODISCARD qn_status qn_load_recording(const char *path, qn_particle_list *list);

#endif
