// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>

static _Thread_local char sentence[2048] = "no error";

static const struct {
    int exit_code;
    const char *text;
} rows[] = {
#define X(NAME, code, text) [QN_##NAME] = {code, text},
    QN_STATUS_LIST(X)
#undef X
};

const char *qn_error(void)
{
    return sentence;
}

const char *qn_status_text(qn_status status)
{
    return rows[status].text;
}

int qn_status_exit(qn_status status)
{
    return rows[status].exit_code;
}

qn_status qn_fail(qn_status status, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    return status;
}
