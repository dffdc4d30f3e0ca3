// SPDX-License-Identifier: Apache-2.0
// A named array with its unit: how modules show what they keep to whoever writes files.
#ifndef QN_BASE_COLUMN_H
#define QN_BASE_COLUMN_H

#include <stdint.h>

typedef enum qn_type { QN_INT32, QN_INT64, QN_FLOAT, QN_DOUBLE } qn_type;

typedef struct qn_column {
    const char *name, *unit, *meaning;  // not owned
    qn_type type;
    int width;     // 1   numbers per row
    int64_t rows;  // 1
    void *data;    //     rows x width numbers; not owned, written to on reading back
} qn_column;

#endif
