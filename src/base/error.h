// SPDX-License-Identifier: Apache-2.0
// Errors: everything that can fail returns a qn_status and leaves one sentence behind.
//
// The sentence says what, where, value, unit and what is allowed. The library never prints, exits
// or aborts on input; the command line turns the status into an exit code from the same list.
#ifndef QN_BASE_ERROR_H
#define QN_BASE_ERROR_H

#include "quern/quern.h"

/// Stores the sentence for this thread and returns `status`, so that `return qn_fail(...)` reads.
qn_status qn_fail(qn_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Exit code of the command line for a status, from the same list.
int qn_status_exit(qn_status status);

/// Returns early from a function that itself returns qn_status.
#define QN_TRY(call)                                        \
    do {                                                    \
        qn_status qn_try_status_ = (call);                  \
        if (qn_try_status_ != QN_OK) return qn_try_status_; \
    } while (0)

#endif
