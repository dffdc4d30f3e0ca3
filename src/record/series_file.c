// SPDX-License-Identifier: Apache-2.0
#include "record/series_file.h"

#include "base/array.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static qn_status fail(const qn_series_file *s)
{
    return qn_fail(QN_IO, "%s could not be written: %s", s->path, strerror(errno));
}

/// Bytes of the file that stay: the header and the whole rows of steps below `cut`. 0 if not even
/// the header is whole.
static qn_status length_kept(const qn_series_file *s, const char *header, int64_t cut,
                             int64_t *kept)
{
    char *line = NULL;
    size_t room = 0;
    qn_status status = QN_OK;
    *kept = 0;
    for (ssize_t n; (n = getline(&line, &room, s->file)) > 0 && line[n - 1] == '\n'; *kept += n) {
        if (*kept == 0) {
            line[n - 1] = 0;
            if (strcmp(line, header) == 0) continue;
            status =
                qn_fail(QN_INPUT, "%s has the columns \"%.200s\", this program writes \"%.200s\"",
                        s->path, line, header);
            break;
        }
        char *end;
        int64_t step = strtoll(line, &end, 10);
        if (end == line || *end != ',' || step >= cut) break;
    }
    free(line);
    return status;
}

qn_status qn_series_file_open(qn_series_file *s, const char *path, const char *header, int64_t cut)
{
    int64_t kept;
    snprintf(s->path, sizeof s->path, "%s", path);
    s->begun = false;
    s->file = fopen(path, "a+");
    if (!s->file) return fail(s);
    rewind(s->file);
    qn_status status = length_kept(s, header, cut, &kept);
    if (status == QN_OK && ftruncate(fileno(s->file), (off_t)kept) != 0) status = fail(s);
    if (status == QN_OK && fseek(s->file, 0, SEEK_END) != 0) status = fail(s);
    if (status == QN_OK && kept == 0) fprintf(s->file, "%s\n", header);
    if (status == QN_OK) status = qn_series_file_sync(s);
    if (status == QN_OK) status = qn_file_sync_name(path);
    if (status != QN_OK) qn_series_file_close(s);
    return status;
}

static void separate(qn_series_file *s)
{
    if (s->begun) fputc(',', s->file);
    s->begun = true;
}

void qn_series_file_integer(qn_series_file *s, int64_t value)
{
    separate(s);
    fprintf(s->file, "%" PRId64, value);
}

void qn_series_file_number(qn_series_file *s, double value)
{
    separate(s);
    if (isnan(value))
        fputs("nan", s->file);
    else
        fprintf(s->file, "%.17g", value);
}

void qn_series_file_word(qn_series_file *s, const char *word)
{
    separate(s);
    fputs(word, s->file);
}

void qn_series_file_end_row(qn_series_file *s)
{
    fputc('\n', s->file);
    s->begun = false;
}

qn_status qn_series_file_sync(qn_series_file *s)
{
    if (!s->file) return QN_OK;
    if (fflush(s->file) != 0 || ferror(s->file) || fsync(fileno(s->file)) != 0) return fail(s);
    return QN_OK;
}

void qn_series_file_close(qn_series_file *s)
{
    if (s->file) fclose(s->file);
    s->file = NULL;
}

/// One row of text into `columns` numbers; false if it has more or fewer.
static bool read_row(char *line, int columns, double *out)
{
    char *next = line;
    for (int c = 0; c < columns; c++) {
        char *word = strsep(&next, ","), *end;
        if (!word) return false;
        out[c] = strtod(word, &end);
        if (end == word || *end) out[c] = (double)NAN;
    }
    return next == NULL;
}

qn_status qn_series_file_read(const char *path, int columns, double **numbers, int64_t *rows)
{
    char *text;
    int64_t length, room = 0;
    qn_status status = QN_OK;
    *numbers = NULL;
    *rows = 0;
    QN_TRY(qn_file_read(path, &text, &length));
    char *next = text, *line = strsep(&next, "\n");  // the header
    while (status == QN_OK && (line = strsep(&next, "\n")) && *line) {
        status = QN_RESERVE(*numbers, room, (*rows + 1) * columns);
        if (status == QN_OK && !read_row(line, columns, *numbers + *rows * columns))
            status = qn_fail(QN_IO, "%s: row %lld does not have %d columns", path,
                             (long long)*rows + 1, columns);
        ++*rows;
    }
    free(text);
    if (status == QN_OK) return QN_OK;
    free(*numbers);
    *numbers = NULL;
    return status;
}
