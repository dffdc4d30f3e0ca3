// SPDX-License-Identifier: Apache-2.0
// A small mill that records itself, for tests of the recorder.
#ifndef QN_TESTS_RECORD_MILL_H
#define QN_TESTS_RECORD_MILL_H

#include "record/recorder.h"

typedef struct mill {
    qn_world *world;
    qn_measure measure;
    qn_recorder recorder;
} mill;

extern const char mill_scene[];        // the text of its scene, which says 2000 steps
extern const char mill_other_scene[];  // one that differs in a comment

/// Opens a run of `scene` in `folder`; on failure nothing is left open.
qn_status mill_open(mill *m, const char *scene, const char *folder, qn_run_mode mode);

/// Runs up to step `until`, with a checkpoint every `stride` steps (0 for none).
qn_status mill_run(mill *m, int64_t until, int64_t stride);

/// Opens, runs, finishes and closes; *hash is the final state's (unless NULL).
qn_status mill_run_through(const char *folder, qn_run_mode mode, int64_t until, int64_t stride,
                           uint64_t *hash);

void mill_close(mill *m);

/// Removes a folder and what is in it.
void remove_folder(const char *folder);

/// Whether two files hold the same bytes.
bool same_file(const char *folder_a, const char *folder_b, const char *name);

#endif
