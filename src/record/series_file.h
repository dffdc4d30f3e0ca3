// SPDX-License-Identifier: Apache-2.0
// Series files: tables in CSV that grow row by row and survive a stop at any moment.
//
// The first line names the columns, the first column is the step, and steps never decrease. Rows are
// synced to the disk before a checkpoint takes its name; what lies beyond it is cut when a run
// resumes. Numbers are written with the 17 digits that read back bit for bit.
#ifndef QN_RECORD_SERIES_FILE_H
#define QN_RECORD_SERIES_FILE_H

#include "record/atomic_file.h"

#include <stdio.h>

typedef struct qn_series_file {
    char path[QN_FILE_NAME_MAX];
    FILE *file;  // owned; NULL while closed
    bool begun;  //     whether the present row has a value already
} qn_series_file;

/// Opens a file to append to. Rows of steps >= `cut` and whatever follows them go, as does a last
/// line that was not finished; a file that is missing or empty starts with the header. QN_INPUT if
/// the header of the file is another one.
QN_NODISCARD qn_status qn_series_file_open(qn_series_file *s, const char *path, const char *header,
                                           int64_t cut);

/// Values of a row, in the order of the columns, then its end. Errors are told by _sync.
void qn_series_file_integer(qn_series_file *s, int64_t value);
void qn_series_file_number(qn_series_file *s, double value);
void qn_series_file_word(qn_series_file *s, const char *word);
void qn_series_file_end_row(qn_series_file *s);

/// Makes sure that every row so far is on the disk. Closed files are fine.
QN_NODISCARD qn_status qn_series_file_sync(qn_series_file *s);

/// Closes without any promise; call _sync first.
void qn_series_file_close(qn_series_file *s);

/// Reads the numbers of a series file: rows x columns, row by row, owned by the caller. Words become
/// NaN. QN_IO if a row has another number of columns than the header.
QN_NODISCARD qn_status qn_series_file_read(const char *path, int columns, double **numbers,
                                           int64_t *rows);

#endif
