// SPDX-License-Identifier: Apache-2.0
// What a validation case hands to docs/validation.md, beside its verdict.
//
//     MEASURE(quantity, at, value, expected, tolerance)   a check that is a row of the page's table
//     CURVE(name, "time (s),speed (m/s)", t, v)           one row of a curve for the page's figure
//
// `make validate` (validation/report.py) names a folder in QUERN_VALIDATION, where the rows go:
// <case>.checks.csv, <case>.<name>.csv. Without it MEASURE only checks and CURVE does nothing.
#ifndef QN_TESTS_EVIDENCE_H
#define QN_TESTS_EVIDENCE_H

#include "check.h"

#include <stdarg.h>
#include <stdlib.h>

/// Whether the page is being made: cases may then take more points for its figures.
static inline bool evidence_wanted(void)
{
    return getenv("QUERN_VALIDATION") != NULL;
}

/// Opens <case>.<name>.csv for one more row; `source` is a test's __FILE__. NULL if nobody asked.
static inline FILE *evidence_open(const char *source, const char *name, const char *columns)
{
    char path[4096];
    const char *slash = strrchr(source, '/'), *stem = slash ? slash + 1 : source;
    if (!evidence_wanted()) return NULL;
    snprintf(path, sizeof path, "%s/%.*s.%s.csv", getenv("QUERN_VALIDATION"),
             (int)strcspn(stem, "."), stem, name);
    FILE *file = fopen(path, "a");
    if (file && fseek(file, 0, SEEK_END) == 0 && ftell(file) == 0) fprintf(file, "%s\n", columns);
    return file;
}

/// One row of the table; whether the value is as expected.
static inline bool evidence_check(const char *source, int line, const char *quantity,
                                  const char *at, double value, double expected, double tolerance)
{
    FILE *file = evidence_open(source, "checks", "quantity,at,value,expected,tolerance");
    bool good = fabs(value - expected) <= tolerance;
    if (file) {
        fprintf(file, "\"%s\",\"%s\",%.17g,%.17g,%.17g\n", quantity, at, value, expected,
                tolerance);
        fclose(file);
    }
    if (!good)
        printf("  %s:%d: %s %s = %.17g, expected %.17g within %g\n", source, line, quantity, at,
               value, expected, tolerance);
    return good;
}

static inline void evidence_curve(const char *source, const char *name, const char *columns,
                                  const double *row, int count)
{
    FILE *file = evidence_open(source, name, columns);
    if (!file) return;
    for (int i = 0; i < count; i++) fprintf(file, "%.10g%c", row[i], i + 1 < count ? ',' : '\n');
    fclose(file);
}

/// "40 deg", to say at what a quantity was measured; good until the next call.
static inline const char *where(const char *format, ...)
{
    static char text[128];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

#define MEASURE(quantity, at, value, expected, tolerance)                                    \
    do {                                                                                     \
        if (!evidence_check(__FILE__, __LINE__, quantity, at, value, expected, tolerance)) { \
            check_ok = false;                                                                \
            return;                                                                          \
        }                                                                                    \
    } while (0)

#define CURVE(name, columns, ...)                                    \
    evidence_curve(__FILE__, name, columns, (double[]){__VA_ARGS__}, \
                   (int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)))

#endif
