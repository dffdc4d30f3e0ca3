// SPDX-License-Identifier: Apache-2.0
// A writer of JSON text into a growing string.
//
//     qn_json j;
//     qn_json_begin(&j);                       {
//     qn_json_integer(&j, "steps", 12);            "steps": 12,
//     qn_json_open(&j, "power", '{');              "power": {
//     qn_json_number(&j, "shell", 3.5);                "shell": 3.5
//     qn_json_close(&j);                           }
//     QN_TRY(qn_json_end(&j, &text));          }
//
// Keys are NULL within a list. A number that is not finite becomes null: JSON has no other word for
// "does not exist". Running out of memory is remembered and told by qn_json_end.
#ifndef QN_RECORD_JSON_H
#define QN_RECORD_JSON_H

#include "base/error.h"

#include <stdbool.h>
#include <stdint.h>

enum { QN_JSON_DEPTH = 32 };  // deepest nesting

typedef struct qn_json {
    char *text;            // owned until qn_json_end
    int64_t length, room;  // bytes
    int depth;
    char closer[QN_JSON_DEPTH];  // bracket that ends each open level
    bool filled[QN_JSON_DEPTH];  // whether something stands in it already
    bool out_of_memory;
} qn_json;

/// Starts a text with an open object.
void qn_json_begin(qn_json *json);

/// Closes whatever is open and hands the text over (release with free()); QN_MEMORY if it did not fit.
QN_NODISCARD qn_status qn_json_end(qn_json *json, char **text);

/// Opens an object ('{') or a list ('[').
void qn_json_open(qn_json *json, const char *key, char bracket);
void qn_json_close(qn_json *json);

void qn_json_text(qn_json *json, const char *key, const char *value);
void qn_json_number(qn_json *json, const char *key, double value);
void qn_json_integer(qn_json *json, const char *key, int64_t value);
void qn_json_flag(qn_json *json, const char *key, bool value);
void qn_json_null(qn_json *json, const char *key);

/// A 64-bit number as a string of 16 hexadecimal digits, as hashes are written.
void qn_json_hex(qn_json *json, const char *key, uint64_t value);

#endif
