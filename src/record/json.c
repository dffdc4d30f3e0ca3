// SPDX-License-Identifier: Apache-2.0
#include "record/json.h"

#include "base/array.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put(qn_json *json, const char *text)
{
    int64_t length = (int64_t)strlen(text);
    if (json->out_of_memory) return;
    if (QN_RESERVE(json->text, json->room, json->length + length + 1) != QN_OK) {
        json->out_of_memory = true;
        return;
    }
    memcpy(json->text + json->length, text, (size_t)length + 1);
    json->length += length;
}

static void put_quoted(qn_json *json, const char *text)
{
    put(json, "\"");
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        char one[8];
        if (*c == '"' || *c == '\\')
            snprintf(one, sizeof one, "\\%c", *c);
        else if (*c < 0x20)
            snprintf(one, sizeof one, "\\u%04x", *c);
        else
            snprintf(one, sizeof one, "%c", *c);
        put(json, one);
    }
    put(json, "\"");
}

static void put_indent(qn_json *json)
{
    put(json, "\n");
    for (int i = 0; i < json->depth; i++) put(json, "  ");
}

/// Everything in front of a value: comma, new line, key.
static void put_key(qn_json *json, const char *key)
{
    bool *filled = &json->filled[json->depth - 1];
    if (*filled) put(json, ",");
    *filled = true;
    put_indent(json);
    if (!key) return;
    put_quoted(json, key);
    put(json, ": ");
}

static void descend(qn_json *json, char bracket)
{
    char text[2] = {bracket, 0};
    put(json, text);
    json->closer[json->depth] = bracket == '{' ? '}' : ']';
    json->filled[json->depth] = false;
    json->depth++;
}

void qn_json_begin(qn_json *json)
{
    *json = (qn_json){0};
    descend(json, '{');
}

void qn_json_open(qn_json *json, const char *key, char bracket)
{
    put_key(json, key);
    descend(json, bracket);
}

void qn_json_close(qn_json *json)
{
    char text[2] = {json->closer[json->depth - 1], 0};
    bool filled = json->filled[json->depth - 1];
    json->depth--;
    if (filled) put_indent(json);
    put(json, text);
}

qn_status qn_json_end(qn_json *json, char **text)
{
    while (json->depth > 0) qn_json_close(json);
    put(json, "\n");
    if (json->out_of_memory) {
        free(json->text);
        return qn_fail(QN_MEMORY, "no memory for a JSON text of %lld bytes",
                       (long long)json->length);
    }
    *text = json->text;
    json->text = NULL;
    return QN_OK;
}

void qn_json_text(qn_json *json, const char *key, const char *value)
{
    put_key(json, key);
    put_quoted(json, value);
}

/// The shortest of 15, 16 or 17 digits that reads back as the same number.
void qn_json_number(qn_json *json, const char *key, double value)
{
    char text[32] = "null";
    put_key(json, key);
    for (int digits = 15; isfinite(value) && digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value) break;
    }
    put(json, text);
}

void qn_json_integer(qn_json *json, const char *key, int64_t value)
{
    char text[32];
    put_key(json, key);
    snprintf(text, sizeof text, "%" PRId64, value);
    put(json, text);
}

void qn_json_flag(qn_json *json, const char *key, bool value)
{
    put_key(json, key);
    put(json, value ? "true" : "false");
}

void qn_json_null(qn_json *json, const char *key)
{
    put_key(json, key);
    put(json, "null");
}

void qn_json_hex(qn_json *json, const char *key, uint64_t value)
{
    char text[24];
    snprintf(text, sizeof text, "%016" PRIx64, value);
    qn_json_text(json, key, text);
}
