// SPDX-License-Identifier: Apache-2.0
#include "record/series_h5.h"

#include "record/series_file.h"
#include "record/table.h"

#include <stdlib.h>
#include <string.h>

qn_status qn_series_header(const qn_series *series, char **header)
{
    char *text;
    QN_TRY(QN_ALLOCATE(text, series->column_count * (int64_t)sizeof series->columns->name));
    for (int c = 0; c < series->column_count; c++) {
        if (c > 0) strcat(text, ",");
        strcat(text, series->columns[c].name);
    }
    *header = text;
    return QN_OK;
}

/// One column out of numbers that stand row by row.
static qn_status put_column(hid_t file, const qn_series_column *c, const double *numbers,
                            int64_t rows, int stride)
{
    double *column;
    QN_TRY(QN_ALLOCATE(column, rows));
    for (int64_t i = 0; i < rows; i++) column[i] = numbers[i * stride];
    const qn_column table = {c->name, c->unit, c->meaning, QN_DOUBLE, 1, rows, column};
    qn_status status = qn_table_write(file, "series", &table, 1, true);
    free(column);
    return status;
}

qn_status qn_series_h5_write(const char *folder, const qn_series *series)
{
    char path[QN_FILE_NAME_MAX];
    double *numbers;
    int64_t rows;
    hid_t file;
    int columns = series->column_count;
    QN_TRY(qn_series_file_read(qn_path_join(path, folder, "series.csv"), columns, &numbers, &rows));
    qn_status status = qn_h5_begin(&file);
    if (status == QN_OK) {
        status = qn_h5_put_text(file, "format", QN_RECORDING_FORMAT);
        for (int c = 0; c < columns && status == QN_OK; c++)
            status = put_column(file, &series->columns[c], numbers + c, rows, columns);
        if (status == QN_OK)
            status = qn_h5_commit(file, qn_path_join(path, folder, "series.h5"));
        else
            qn_h5_close(file);
    }
    free(numbers);
    return status;
}
