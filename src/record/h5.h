// SPDX-License-Identifier: Apache-2.0
// HDF5 with our errors: files built in memory, attributes, groups.
//
// A file is put together in memory and written in one go by qn_atomic_write: HDF5 never meets a full
// disk, and a file is whole or not there. HDF5's own error printing is switched off; its innermost
// message becomes part of our sentence. Cost: memory for one file at a time.
#ifndef QN_RECORD_H5_H
#define QN_RECORD_H5_H

#include "base/error.h"

#include <hdf5.h>
#include <stdbool.h>
#include <stdint.h>

/// A new file in memory.
QN_NODISCARD qn_status qn_h5_begin(hid_t *file);

/// Writes the file to `path` atomically and closes it, whatever comes of it.
QN_NODISCARD qn_status qn_h5_commit(hid_t file, const char *path);

/// The same without waiting for the disk; see qn_atomic_write_lazily().
QN_NODISCARD qn_status qn_h5_commit_lazily(hid_t file, const char *path);

/// Opens a file to read. QN_IO with a sentence if it is missing, cut short or no HDF5 file.
QN_NODISCARD qn_status qn_h5_open(const char *path, hid_t *file);

/// Closes a file; one that was never opened (negative) is fine.
void qn_h5_close(hid_t file);

/// Makes (or opens) a group; close it with H5Gclose().
QN_NODISCARD qn_status qn_h5_group(hid_t parent, const char *name, hid_t *group);
QN_NODISCARD qn_status qn_h5_group_open(hid_t parent, const char *name, hid_t *group);
bool qn_h5_has(hid_t parent, const char *name);

/// Attributes. Texts are of fixed length, as VTK wants them.
QN_NODISCARD qn_status qn_h5_put_text(hid_t object, const char *name, const char *text);
QN_NODISCARD qn_status qn_h5_put_integers(hid_t object, const char *name, const int64_t *values,
                                          int count);
QN_NODISCARD qn_status qn_h5_put_integer(hid_t object, const char *name, int64_t value);
QN_NODISCARD qn_status qn_h5_put_numbers(hid_t object, const char *name, const double *values,
                                         int count);
QN_NODISCARD qn_status qn_h5_put_number(hid_t object, const char *name, double value);

/// A list of `count` names as texts of equal length; name i begins at first + i * stride.
QN_NODISCARD qn_status qn_h5_put_names(hid_t object, const char *name, const char *first,
                                       size_t stride, int count);

QN_NODISCARD qn_status qn_h5_get_text(hid_t object, const char *name, char *text, size_t room);
QN_NODISCARD qn_status qn_h5_get_integer(hid_t object, const char *name, int64_t *value);
QN_NODISCARD qn_status qn_h5_get_number(hid_t object, const char *name, double *value);

/// A sentence about `what` with HDF5's innermost message; returns `status`.
qn_status qn_h5_fail(qn_status status, const char *what, const char *name);

#endif
