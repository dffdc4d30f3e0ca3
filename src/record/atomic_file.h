// SPDX-License-Identifier: Apache-2.0
// Whole files, written so that a reader sees the old one or the new one, and nothing in between.
//
// The bytes go to NAME.partial, are synced to the disk, and the name is then changed; the folder is
// synced as well. Whatever fails (a full disk, a quota, a folder without permission) leaves the old
// file as it was. A partial file left by a killed program means nothing and is swept away later.
#ifndef QN_RECORD_ATOMIC_FILE_H
#define QN_RECORD_ATOMIC_FILE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define QN_RECORDING_FORMAT "quern-recording/1"  // format of the files of a run folder

enum { QN_FILE_NAME_MAX = 1280 };  // bytes   longest path the recorder makes

/// Puts `bytes` of data in place of the file at `path`. QN_IO with the old file intact.
QN_NODISCARD qn_status qn_atomic_write(const char *path, const void *data, size_t bytes);

/// As qn_atomic_write, with both syncs left to a later qn_file_sync() and qn_file_sync_name(): for many
/// small files.
QN_NODISCARD qn_status qn_atomic_write_lazily(const char *path, const void *data, size_t bytes);

/// Makes sure that what a file holds is on the disk; one that is not there is fine.
QN_NODISCARD qn_status qn_file_sync(const char *path);

/// As qn_atomic_write for a string.
QN_NODISCARD qn_status qn_atomic_text(const char *path, const char *text);

/// A whole file as a string with a final zero; release with free(). QN_IO if it can't be read.
QN_NODISCARD qn_status qn_file_read(const char *path, char **text, int64_t *length);

/// Makes sure that the name of a new file survives a loss of power.
QN_NODISCARD qn_status qn_file_sync_name(const char *path);

bool qn_file_exists(const char *path);

/// Removes a file; one that is not there is fine.
QN_NODISCARD qn_status qn_file_remove(const char *path);

/// Removes the files of `folder` whose name begins with `head` and ends with `tail`.
QN_NODISCARD qn_status qn_file_sweep(const char *folder, const char *head, const char *tail);

/// Makes a folder (and those above it) unless it is there.
QN_NODISCARD qn_status qn_folder_make(const char *path);

/// path = folder/name. Returns path.
const char *qn_path_join(char path[QN_FILE_NAME_MAX], const char *folder, const char *name);

#endif
