// SPDX-License-Identifier: Apache-2.0
// Tables: lists of columns (base/column.h) as datasets of an HDF5 group, and back.
//
// Every dataset carries `unit`, `meaning` and `hash`, over its name, its type and every bit of it,
// so that a damaged file is noticed when it is read.
#ifndef QN_RECORD_TABLE_H
#define QN_RECORD_TABLE_H

#include "base/column.h"
#include "record/h5.h"

/// The qn_type of a number, for columns made from field lists.
#define QN_TYPE_OF(number) \
    _Generic((number), int32_t : QN_INT32, int64_t : QN_INT64, float : QN_FLOAT, double : QN_DOUBLE)

/// Writes the columns as datasets of parent/name (made if need be). `squeeze` compresses them
/// (gzip 1 after shuffling, as any HDF5 reads it).
QN_NODISCARD qn_status qn_table_write(hid_t parent, const char *name, const qn_column *columns,
                                      int count, bool squeeze);

/// Reads columns of parent/name into their data. QN_IO with a sentence if one is missing, has another
/// type, width or number of rows, or if the table is not what was written.
QN_NODISCARD qn_status qn_table_read(hid_t parent, const char *name, const qn_column *columns,
                                     int count);

/// Number of rows of one column of parent/name.
QN_NODISCARD qn_status qn_table_rows(hid_t parent, const char *name, const char *column,
                                     int64_t *rows);

#endif
