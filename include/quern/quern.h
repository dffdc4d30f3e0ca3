// SPDX-License-Identifier: Apache-2.0
// Quern, a discrete element simulator for tumbling mills: the public C interface.
//
// Units are SI throughout. Every function that can fail returns a qn_status, and qn_error() then
// holds one sentence that says what, where, value, unit and what is allowed.
#ifndef QUERN_QUERN_H
#define QUERN_QUERN_H

#ifdef __cplusplus
extern "C" {
#endif

#define QN_VERSION "0.1.0"

// clang-format off
//    NAME        exit  what went wrong
#define QN_STATUS_LIST(X)                                             \
    X(OK,          0,   "no error")                                   \
    X(INPUT,       2,   "the input is wrong")                         \
    X(IO,          3,   "a file could not be read or written")        \
    X(MEMORY,      4,   "there is not enough memory")                 \
    X(DEVICE,      5,   "the GPU reported an error")                  \
    X(UNSTABLE,    6,   "the simulation has lost its footing")        \
    X(INTERRUPTED, 7,   "the run was interrupted and can be resumed")
// clang-format on

typedef enum qn_status {
#define X(NAME, exit, text) QN_##NAME,
    QN_STATUS_LIST(X)
#undef X
        QN_STATUS_COUNT
} qn_status;

#if defined(__GNUC__)
#define QN_NODISCARD __attribute__((warn_unused_result))
#else
#define QN_NODISCARD
#endif

/// This thread's last sentence; never NULL.
const char *qn_error(void);

/// What a status means in general; never NULL.
const char *qn_status_text(qn_status status);

#ifdef __cplusplus
}
#endif
#endif
