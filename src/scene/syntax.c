// SPDX-License-Identifier: Apache-2.0
// What a person did where libyaml only says what it expected.
//
// Each case was tried on the mistakes people make: a tab, a colon that is missing or has no space
// behind it, a line that is indented otherwise than its neighbours, a bracket or quote left open.
#include "scene/syntax.h"

#include <stdio.h>
#include <string.h>

/// A line of the source without its break, as far as a comment.
typedef struct line {
    const char *text;
    int length, indent;  // bytes, indent also the column of the first letter less one
} line;

/// Line `number` (from 1); empty past the end.
static line line_of(const qn_source *s, int number)
{
    const char *p = s->text, *end = s->text + s->length;
    for (int n = 1; n < number && p < end; p++) n += *p == '\n';
    line l = {p, 0, 0};
    while (p + l.length < end && p[l.length] != '\n' && p[l.length] != '\r') {
        if (p[l.length] == '#' && (l.length == 0 || p[l.length - 1] == ' ')) break;
        l.length++;
    }
    while (l.length > 0 && strchr(" \t", p[l.length - 1])) l.length--;
    while (l.indent < l.length && p[l.indent] == ' ') l.indent++;
    return l;
}

/// The nearest line above that holds more than a comment; 0 if there is none.
static int line_above(const qn_source *s, int number)
{
    do number--;
    while (number > 0 && line_of(s, number).length == 0);
    return number;
}

/// Column (from 1) of a colon that ends a key, 0 if there is none before column `end`.
static int key_colon(line l, int end)
{
    for (int i = l.indent; i < l.length && i + 1 < end; i++)
        if (l.text[i] == ':' && (i + 1 == l.length || l.text[i + 1] == ' ')) return i + 1;
    return 0;
}

static qn_mark whole(line l, int number)
{
    return (qn_mark){number, l.indent + 1, l.length - l.indent};
}

/// A line that should be a key with its value, but has no colon with a space behind it.
static qn_mark lacks_colon(const qn_source *s, int number, char *sentence, size_t size)
{
    line l = line_of(s, number);
    const char *colon = memchr(l.text, ':', (size_t)l.length);
    if (colon) {
        snprintf(sentence, size, "a space is missing behind the ':'");
        return (qn_mark){number, (int)(colon - l.text) + 1, 1};
    }
    snprintf(sentence, size, "a ':' is missing: each line is a key, a colon, a space and a value");
    return whole(l, number);
}

/// A colon where none can be: a second one in its line, or in a line that is part of the value above.
static qn_mark stray_colon(const qn_source *s, qn_mark mark, char *sentence, size_t size)
{
    line l = line_of(s, mark.line);
    int above = line_above(s, mark.line);
    line before = line_of(s, above);
    if (key_colon(l, mark.column)) {
        snprintf(sentence, size,
                 "a second ':' in the same line: put a value that holds ': ' in "
                 "quotes, and each key in a line of its own");
        return mark;
    }
    if (above > 0 && !key_colon(before, before.length + 2))
        return lacks_colon(s, above, sentence, size);
    if (above > 0 && l.indent > before.indent) {
        snprintf(
            sentence, size,
            "this line begins in column %d, that above in column %d: keys of one section begin "
            "in the same column, and a key with keys below it has no value of its own",
            l.indent + 1, before.indent + 1);
        return whole(l, mark.line);
    }
    snprintf(sentence, size, "a ':' cannot be here; put a value that holds ': ' in quotes");
    return mark;
}

/// Where libyaml wants another key of a section.
static qn_mark no_key(const qn_source *s, qn_mark mark, char *sentence, size_t size)
{
    line l = line_of(s, mark.line);
    if (mark.column > l.indent + 1) {
        snprintf(sentence, size, "this does not belong to the value before it");
        return mark;
    }
    int above = line_above(s, mark.line);
    line before = line_of(s, above);
    if (above > 0 && before.indent == l.indent && !key_colon(before, before.length + 2))
        return lacks_colon(s, above, sentence, size);
    if (l.length > l.indent && l.text[l.indent] == '-') {
        snprintf(sentence, size, "an entry of a list ('-') cannot stand among keys");
        return mark;
    }
    snprintf(sentence, size,
             "this line begins in column %d, where no section above has its keys: keys of one "
             "section begin in the same column",
             l.indent + 1);
    return whole(l, mark.line);
}

/// A tab among the spaces a line begins with, at the mark's line or the one above it.
static bool find_tab(const qn_source *s, qn_mark mark, qn_mark *tab)
{
    int numbers[] = {mark.line, line_above(s, mark.line)};
    for (int k = 0; k < 2; k++) {
        line l = line_of(s, numbers[k]);
        for (int i = 0; numbers[k] > 0 && i < l.length && strchr(" \t", l.text[i]); i++)
            if (l.text[i] == '\t') {
                *tab = (qn_mark){numbers[k], i + 1, 1};
                return true;
            }
    }
    return false;
}

qn_mark qn_syntax_explain(const qn_source *s, const char *problem, qn_mark mark, qn_mark context,
                          char *sentence, size_t size)
{
    line l = line_of(s, mark.line);
    int column = mark.column - 1;
    char here = column < l.length ? l.text[column] : '\0';
    char opened = 0;
    if (context.line > 0) {
        line c = line_of(s, context.line);
        opened = context.column <= c.length ? c.text[context.column - 1] : '\0';
    }
    qn_mark tab;
    if (opened != '"' && opened != '\'' && find_tab(s, mark, &tab)) {
        snprintf(sentence, size, "a tab cannot be used to indent; use spaces");
        return tab;
    }
    if (!strcmp(problem, "mapping values are not allowed in this context"))
        return stray_colon(s, mark, sentence, size);
    if (!strcmp(problem, "did not find expected key")) return no_key(s, mark, sentence, size);
    if (!strcmp(problem, "could not find expected ':'") && context.line > 0)
        return lacks_colon(s, context.line, sentence, size);
    if (strchr("{[", opened) && opened && strstr(problem, "did not find expected ','")) {
        if (context.line == mark.line) {
            snprintf(sentence, size, "a ',' or '%c' is missing here", opened == '{' ? '}' : ']');
            return mark;
        }
        snprintf(sentence, size, "the '%c' is still open in line %d: a ',' or its '%c' is missing",
                 opened, mark.line, opened == '{' ? '}' : ']');
        return (qn_mark){context.line, context.column, 1};
    }
    if (strchr("\"'", opened) && opened && strstr(problem, "unexpected")) {
        snprintf(sentence, size, "the quote (%c) is not closed", opened);
        return (qn_mark){context.line, context.column, 1};
    }
    if (!strcmp(problem, "found character that cannot start any token"))
        snprintf(sentence, size, "a value cannot begin with '%c'; put it in quotes", here);
    else if (!strcmp(problem, "did not find expected '-' indicator"))
        snprintf(sentence, size, "the list above goes on here: begin the line with '-'");
    else if (!strcmp(problem, "did not find expected node content"))
        snprintf(sentence, size, here ? "a value is missing before '%c'" : "a value is missing",
                 here);
    else
        snprintf(sentence, size, "this cannot be read: %s", problem);
    return mark;
}
