// SPDX-License-Identifier: Apache-2.0
// The folder of a run: who may write to it, what is in it, and its log.
//
// A folder belongs to one program at a time, which holds a lock that goes with it whatever ends it.
// Only files that a run makes are ever removed, and only from a folder that a run has made.
#ifndef QN_RECORD_RUN_FOLDER_H
#define QN_RECORD_RUN_FOLDER_H

#include "record/atomic_file.h"

#include <stdio.h>

typedef enum qn_run_mode {
    QN_NEW,     // into a folder that is empty or does not exist
    QN_RESUME,  // go on from the newest checkpoint; from the start where there is none
    QN_FORCE,   // remove the run that is there
} qn_run_mode;

typedef struct qn_run_folder {
    char path[QN_FILE_NAME_MAX];
    int lock;   //  file descriptor; -1 when not held
    FILE *log;  //  owned
} qn_run_folder;

/// Makes or takes over the folder and locks it. QN_INPUT where there is something that may not be
/// written over, or another program writes there; nothing is changed then.
QN_NODISCARD qn_status qn_run_folder_open(qn_run_folder *folder, const char *path,
                                          qn_run_mode mode);

/// Adds a line with date and time (UTC) to log.txt. The log is a service: errors are passed over.
void qn_run_folder_log(qn_run_folder *folder, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/// Gives the folder back; one that was never opened (zeroed) is fine.
void qn_run_folder_close(qn_run_folder *folder);

#endif
