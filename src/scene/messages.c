// SPDX-License-Identifier: Apache-2.0
#include "scene/messages.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN = 160, WORD = 48 };  // columns of a source line that are shown; longest word compared

static void append(qn_messages *m, const char *text, size_t length)
{
    size_t wanted = m->length + length + 1;
    if (wanted > m->capacity) {
        char *more = realloc(m->text, wanted * 2);
        if (!more) return;
        m->text = more;
        m->capacity = wanted * 2;
    }
    memcpy(m->text + m->length, text, length);
    m->length += length;
    m->text[m->length] = '\0';
}

/// Length in bytes of the line break at `p`, 0 if there is none; the same breaks as YAML 1.1.
static size_t break_length(const char *p, const char *end)
{
    if (*p == '\r') return p + 1 < end && p[1] == '\n' ? 2 : 1;
    if (*p == '\n') return 1;
    if (end - p >= 2 && !memcmp(p, "\xC2\x85", 2)) return 2;
    if (end - p >= 3 && (!memcmp(p, "\xE2\x80\xA8", 3) || !memcmp(p, "\xE2\x80\xA9", 3))) return 3;
    return 0;
}

static bool continues(char c)
{
    return ((unsigned char)c & 0xC0) == 0x80;
}

/// The source line and, under it, a caret at the mark.
static void show_line(qn_messages *m, const qn_source *s, qn_mark mark)
{
    const char *p = s->text, *end = s->text + s->length;
    for (int line = 1; line < mark.line && p < end;) {
        size_t length = break_length(p, end);
        line += length > 0;
        p += length ? length : 1;
    }
    int column = 1, first = mark.column > SHOWN / 2 ? mark.column - SHOWN / 4 : 1;
    while (p < end && !break_length(p, end) && column < first) {
        do p++;
        while (p < end && continues(*p));
        column++;
    }
    char under[SHOWN * 2 + 8] = "";
    size_t u = 0;
    for (; p < end && !break_length(p, end) && column < first + SHOWN; column++) {
        const char *start = p;
        do p++;
        while (p < end && continues(*p));
        append(m, start, (size_t)(p - start));
        if (column < mark.column)
            under[u++] = *start == '\t' ? '\t' : ' ';
        else if (column == mark.column)
            under[u++] = '^';
        else if (column < mark.column + mark.width)
            under[u++] = '~';
    }
    if (column <= mark.column) under[u++] = '^';
    append(m, "\n", 1);
    append(m, under, u);
    append(m, "\n", 1);
}

void qn_message(qn_messages *m, const qn_source *source, qn_severity severity, qn_mark mark,
                const char *format, ...)
{
    if (qn_messages_full(m)) return;
    char line[2048], sentence[1536];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    const char *kind = severity == QN_ERROR ? "error" : "warning";
    int n = mark.line > 0
                ? snprintf(line, sizeof line, "%.400s:%d:%d: %s: %s\n", source->name, mark.line,
                           mark.column, kind, sentence)
                : snprintf(line, sizeof line, "%.400s: %s: %s\n", source->name, kind, sentence);
    append(m, line, (size_t)n);
    if (mark.line > 0) show_line(m, source, mark);
    if (severity == QN_WARNING)
        m->warnings++;
    else if (++m->errors == QN_ERRORS_MAX) {
        static const char last[] = "(more errors may follow; these come first)\n";
        append(m, last, sizeof last - 1);
    }
}

void qn_messages_free(qn_messages *m)
{
    free(m->text);
    *m = (qn_messages){0};
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

/// Number of letters to insert, delete, replace or swap with their neighbour to turn a into b.
static int distance(const char *a, int la, const char *b, int lb)
{
    int d[WORD + 1][WORD + 1];
    for (int i = 0; i <= la; i++) d[i][0] = i;
    for (int j = 0; j <= lb; j++) d[0][j] = j;
    for (int i = 1; i <= la; i++)
        for (int j = 1; j <= lb; j++) {
            int change = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
            d[i][j] = least(change, least(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[la][lb];
}

bool qn_nearest_word(const char *word, const char *words, char *nearest, size_t size)
{
    size_t length = strlen(word);
    if (length > WORD) return false;
    int best = (int)length / 3 + 2;
    *nearest = '\0';
    for (const char *p = words; *p;) {
        size_t n = strcspn(p, " ,");
        if (n > 0 && n <= WORD) {
            int d = distance(word, (int)length, p, (int)n);
            if (d < best && d < (int)n) {
                best = d;
                snprintf(nearest, size, "%.*s", (int)n, p);
            }
        }
        p += n;
        p += strspn(p, " ,");
    }
    return *nearest != '\0';
}
