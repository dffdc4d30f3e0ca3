// SPDX-License-Identifier: Apache-2.0
#include "scene/load_datafile.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <sys/types.h>

static const off_t largest = 2000000000;  // bytes   of a file that is read whole

enum { SHOWN = 40 };  // characters of a bad word that a message repeats

static qn_status check_info(const char *path, const struct stat *info)
{
    if (S_ISDIR(info->st_mode)) return qn_fail(QN_INPUT, "%s: is a folder; a file is needed", path);
    if (!S_ISREG(info->st_mode)) return qn_fail(QN_INPUT, "%s: is not an ordinary file", path);
    if (info->st_size == 0) return qn_fail(QN_INPUT, "%s: the file is empty", path);
    if (info->st_size > largest)
        return qn_fail(QN_INPUT, "%s: the file has %lld bytes; at most %lld are read", path,
                       (long long)info->st_size, (long long)largest);
    return QN_OK;
}

qn_status qn_datafile_check(const char *path)
{
    struct stat info;
    if (stat(path, &info) != 0)
        return qn_fail(QN_IO, "%s: cannot be opened: %s", path, strerror(errno));
    return check_info(path, &info);
}

static qn_status read_all(const char *path, FILE *stream, qn_datafile *file)
{
    struct stat info;  // of what was opened, should it have changed since it was looked at
    if (fstat(fileno(stream), &info) != 0)
        return qn_fail(QN_IO, "%s: cannot be read: %s", path, strerror(errno));
    QN_TRY(check_info(path, &info));
    size_t size = (size_t)info.st_size;
    char *data = malloc(size + 1);
    if (!data) return qn_fail(QN_MEMORY, "%s: no memory for its %zu bytes", path, size);
    size_t got = fread(data, 1, size, stream);
    if (got != size) {
        free(data);
        return qn_fail(QN_IO, "%s: only %zu of its %zu bytes could be read", path, got, size);
    }
    data[size] = '\0';
    *file = (qn_datafile){.path = path, .data = data, .size = size, .next = data};
    return QN_OK;
}

qn_status qn_datafile_read(const char *path, qn_datafile *file)
{
    *file = (qn_datafile){.path = path};
    QN_TRY(qn_datafile_check(path));
    FILE *stream = fopen(path, "rb");
    if (!stream) return qn_fail(QN_IO, "%s: cannot be opened: %s", path, strerror(errno));
    qn_status status = read_all(path, stream, file);
    fclose(stream);
    return status;
}

qn_status qn_datafile_read_text(const char *path, qn_datafile *file)
{
    QN_TRY(qn_datafile_read(path, file));
    int64_t line = 1;
    for (size_t i = 0; i < file->size; i++) {
        unsigned char c = (unsigned char)file->data[i];
        if (c == '\n') line++;
        if ((c >= ' ' && c != 127) || isspace(c)) continue;
        qn_status status = qn_fail(QN_INPUT, "%s:%lld: byte %zu is 0x%02x; a text file is needed",
                                   path, (long long)line, i, c);
        qn_datafile_free(file);
        return status;
    }
    if (strncmp(file->data, "\xef\xbb\xbf", 3) == 0) file->next += 3;
    return QN_OK;
}

void qn_datafile_free(qn_datafile *file)
{
    free(file->data);
    *file = (qn_datafile){0};
}

static bool is_gap(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';' || c == '\v' || c == '\f';
}

bool qn_datafile_line(qn_datafile *file, qn_line *line)
{
    const char *end = file->data + file->size;
    while (file->next < end) {
        const char *begin = file->next;
        const char *stop = memchr(begin, '\n', (size_t)(end - begin));
        if (!stop) stop = end;
        file->next = stop < end ? stop + 1 : end;
        file->line++;
        const char *hash = memchr(begin, '#', (size_t)(stop - begin));
        *line = (qn_line){begin, hash ? hash : stop};
        qn_line rest = *line, word;
        if (qn_line_word(&rest, &word)) return true;
    }
    return false;
}

int64_t qn_datafile_lines_left(const qn_datafile *file)
{
    qn_datafile ahead = *file;
    qn_line line;
    int64_t count = 0;
    while (qn_datafile_line(&ahead, &line)) count++;
    return count;
}

bool qn_line_word(qn_line *line, qn_line *word)
{
    const char *at = line->begin;
    while (at < line->end && is_gap(*at)) at++;
    word->begin = at;
    while (at < line->end && !is_gap(*at)) at++;
    word->end = at;
    line->begin = at;
    return word->begin < word->end;
}

static int shown(qn_line word)
{
    return word.end - word.begin > SHOWN ? SHOWN : (int)(word.end - word.begin);
}

/// A decimal number that fills the word; strtod would also take nan, inf and hexadecimal.
static bool parse_number(qn_line word, double *number)
{
    for (const char *at = word.begin; at < word.end; at++)
        if (!isdigit((unsigned char)*at) && !strchr("+-.eEdD", *at)) return false;
    char *stop;
    *number = strtod(word.begin, &stop);
    return stop == word.end && isfinite(*number);
}

static bool parse_integer(qn_line word, int64_t *number)
{
    char *stop;
    errno = 0;
    *number = strtoll(word.begin, &stop, 10);
    return stop == word.end && errno == 0;
}

static qn_status wrong_count(const qn_datafile *file, int found, int count, const char *what)
{
    return qn_fail(QN_INPUT, "%s:%lld: %s %d numbers here; needed are %d: %s", file->path,
                   (long long)file->line, found < count ? "only" : "more than",
                   found < count ? found : count, count, what);
}

qn_status qn_line_numbers(const qn_datafile *file, qn_line line, int count, const char *what,
                          double *numbers)
{
    qn_line word;
    for (int i = 0; i < count; i++) {
        if (!qn_line_word(&line, &word)) return wrong_count(file, i, count, what);
        if (!parse_number(word, &numbers[i]))
            return qn_fail(QN_INPUT, "%s:%lld: '%.*s' is not a finite number; needed are %d: %s",
                           file->path, (long long)file->line, shown(word), word.begin, count, what);
    }
    return qn_line_word(&line, &word) ? wrong_count(file, count + 1, count, what) : QN_OK;
}

qn_status qn_line_integers(const qn_datafile *file, qn_line line, int count, const char *what,
                           int64_t low, int64_t high, int64_t *numbers)
{
    qn_line word;
    for (int i = 0; i < count; i++) {
        if (!qn_line_word(&line, &word)) return wrong_count(file, i, count, what);
        if (!parse_integer(word, &numbers[i]) || numbers[i] < low || numbers[i] > high)
            return qn_fail(QN_INPUT, "%s:%lld: '%.*s' is not a whole number from %lld to %lld: %s",
                           file->path, (long long)file->line, shown(word), word.begin,
                           (long long)low, (long long)high, what);
    }
    return qn_line_word(&line, &word) ? wrong_count(file, count + 1, count, what) : QN_OK;
}

bool qn_length_from(double value, double unit, double *metres)
{
    *metres = value * unit;
    return fabs(*metres) <= QN_LOAD_FARTHEST;
}

qn_status qn_datafile_length(const qn_datafile *file, double value, double unit, double *metres)
{
    if (qn_length_from(value, unit, metres)) return QN_OK;
    return qn_fail(QN_INPUT, "%s:%lld: %g x %g m is too far out; lengths up to %g m are allowed",
                   file->path, (long long)file->line, value, unit, QN_LOAD_FARTHEST);
}

bool qn_path_has_extension(const char *path, const char *list)
{
    const char *dot = strrchr(path, '.');
    if (!dot || strchr(dot, '/')) return false;
    size_t length = strlen(dot);
    for (const char *at = list; (at = strchr(at, '.')); at++)
        if (strncasecmp(at, dot, length) == 0 && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}
