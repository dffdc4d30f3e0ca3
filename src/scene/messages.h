// SPDX-License-Identifier: Apache-2.0
// Messages about a text a person wrote: all of them, each with its place and a caret.
//
//     mill.yaml:14:19: error: materials.glass.poisson = 0.7 must be above -1 and below 0.5: ...
//         poisson: 0.7
//                  ^~~
//
// The reader collects them and the command line prints them; the library itself prints nothing.
#ifndef QN_SCENE_MESSAGES_H
#define QN_SCENE_MESSAGES_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { QN_ERRORS_MAX = 50 };  // after so many errors the reader stops looking

/// A place in a text, from 1 on; line 0 means the file as a whole.
typedef struct qn_mark {
    int line, column, width;
} qn_mark;

/// The text that marks point into; nothing here is owned.
typedef struct qn_source {
    const char *name, *text;
    size_t length;
} qn_source;

typedef struct qn_messages {
    char *text;  // owned; all messages as they should be printed, NULL when there are none
    size_t length, capacity;
    int errors, warnings;
} qn_messages;

typedef enum qn_severity { QN_WARNING, QN_ERROR } qn_severity;

/// Adds one message. Past QN_ERRORS_MAX errors nothing is added.
void qn_message(qn_messages *messages, const qn_source *source, qn_severity severity, qn_mark mark,
                const char *format, ...) __attribute__((format(printf, 5, 6)));

/// Whether there is no point in looking for more.
static inline bool qn_messages_full(const qn_messages *messages)
{
    return messages->errors >= QN_ERRORS_MAX;
}

void qn_messages_free(qn_messages *messages);

/// The word of `words` (separated by spaces or commas) most like `word`, copied to `nearest`; false if none is
/// close enough to be what was meant.
bool qn_nearest_word(const char *word, const char *words, char *nearest, size_t size);

#endif
