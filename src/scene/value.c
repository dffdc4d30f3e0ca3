// SPDX-License-Identifier: Apache-2.0
// One value: numbers, their unit and range, words, names.
#include "scene/reader.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBERS_MAX = QN_TRACED_MAX };

typedef enum found { FOUND_NUMBER, FOUND_NONE, FOUND_HUGE } found;

static const char *past_digits(const char *p)
{
    while (isdigit((unsigned char)*p)) p++;
    return p;
}

/// Reads a decimal number: no hexadecimal, no nan, no infinity. *p is moved behind it.
static found read_number(const char **p, double *x)
{
    const char *start = *p + (**p == '-' || **p == '+');
    const char *whole = past_digits(start), *end = whole;
    if (*end == '.') end = past_digits(end + 1);
    if (end == start || (end == whole + 1 && whole == start)) return FOUND_NONE;
    if (*end == 'e' || *end == 'E') {
        const char *exponent = end + 1 + (end[1] == '-' || end[1] == '+');
        if (past_digits(exponent) > exponent) end = past_digits(exponent);
    }
    *x = strtod(*p, NULL);
    *p = end;
    return isfinite(*x) ? FOUND_NUMBER : FOUND_HUGE;
}

static const char *past_spaces(const char *p)
{
    return p + strspn(p, " \n");
}

/// What stands directly behind a number and cannot: a decimal comma, a letter for a digit. Says so and
/// returns true.
static bool is_misspelt(qn_reader *r, const qn_value *v, const char *rest)
{
    size_t run = strspn(rest, "oOlI0123456789");
    bool row = v->key->kind == QN_KIND_NUMBERS || v->key->kind == QN_KIND_VECTOR;
    if (*rest == ',' && row)
        qn_complain(r, v, "has a comma: numbers stand apart by blanks, and decimals follow a '.'");
    else if (*rest == ',')
        qn_complain(r, v, "has a comma: decimals follow a '.', and thousands are not set apart");
    else if (run > 0 && (!rest[run] || isspace((unsigned char)rest[run])))
        qn_complain(r, v, "is not a number: '%c' is a letter, not the digit %c", *rest,
                    strchr("oO", *rest) ? '0' : '1');
    else
        return false;
    return true;
}

/// The numbers of `text` up to `room`; *rest is what follows them. Returns how many, -1 with a message
/// if there is none or one is too large.
static int read_numbers(qn_reader *r, const qn_value *v, const char *text, double *x, int room,
                        const char **rest)
{
    const char *p = past_spaces(text);
    int n = 0;
    while (n < room) {
        found f = read_number(&p, &x[n]);
        if (f == FOUND_HUGE) {
            qn_complain(r, v, "is too large for a number");
            return -1;
        }
        if (f == FOUND_NONE) break;
        n++;
        if (is_misspelt(r, v, p)) return -1;
        bool apart = isspace((unsigned char)*p);
        p = past_spaces(p);
        if (!apart) break;
    }
    *rest = p;
    if (n == 0) {
        qn_complain(r, v, "is not %s",
                    v->key->kind == QN_KIND_NUMBER   ? "a number"
                    : v->key->kind == QN_KIND_WHOLE  ? "a whole number"
                    : v->key->kind == QN_KIND_VECTOR ? "three numbers"
                                                     : "a row of numbers");
        return -1;
    }
    return n;
}

static bool complain_about_unit(qn_reader *r, const qn_value *v, const char *name,
                                const qn_unit *unit)
{
    char allowed[256], needed[256], nearest[32];
    qn_units_list(v->key->units, allowed, sizeof allowed);
    qn_units_describe(v->key->units, needed, sizeof needed);
    bool pure = (v->key->units | QN_IN_SHARE) == QN_IN_SHARE;
    if (!*name)
        qn_complain(r, v, "needs a unit: %s", allowed);
    else if (unit && pure)
        qn_complain(r, v, "is a pure number and takes no unit%s", *allowed ? " but %" : "");
    else if (pure)
        qn_complain(r, v, "is not a number: '%.40s' is left over", name);
    else if (unit)
        qn_complain(r, v, "should be %s (%s), but %s is the unit of %s", needed, allowed,
                    unit->name, qn_dimension_text(unit->dimension));
    else if (qn_nearest_word(name, allowed, nearest, sizeof nearest))
        qn_complain(r, v, "has no known unit: '%.40s'; did you mean %s? Allowed: %s", name, nearest,
                    allowed);
    else
        qn_complain(r, v, "has no known unit: '%.40s'; allowed: %s", name, allowed);
    return false;
}

static void complain_about_range(qn_reader *r, const qn_value *v, const qn_unit *unit, double x)
{
    char range[128];
    bool is_percent = v->key->units & QN_IN_PERCENT && !unit && x >= 2 && x <= 100;
    qn_key_range_text(v->key, unit, range, sizeof range);
    if (is_percent && qn_key_allows(v->key, x / 100))
        qn_complain(r, v, "must be %s (%s); did you mean %g %%?", range, v->key->meaning, x);
    else
        qn_complain(r, v, "must be %s (%s)", range, v->key->meaning);
}

/// Turns numbers into SI by the unit that stands behind them, and holds them against the range.
static bool apply_unit(qn_reader *r, qn_value *v, const char *name, double *x, int n)
{
    size_t length = strlen(name);
    while (length > 0 && isspace((unsigned char)name[length - 1])) length--;
    const qn_unit *unit = length > 0 ? qn_unit_find(name, length) : NULL;
    v->dimension = unit ? unit->dimension : QN_DIMENSION_PURE;
    if ((length > 0 && !unit) || !(v->key->units >> v->dimension & 1))
        return complain_about_unit(r, v, length > 0 ? name : "", unit);
    for (int i = 0; i < n; i++) {
        if (unit) x[i] = x[i] * unit->times / unit->over;
        if (!isfinite(x[i])) {
            qn_complain(r, v, "is too large for a number");
            return false;
        }
        if (!qn_key_allows(v->key, x[i])) {
            complain_about_range(r, v, unit, x[i]);
            return false;
        }
    }
    return true;
}

static bool read_one(qn_reader *r, const char *text, qn_value *v)
{
    const char *rest;
    if (*v->key->words && !strcmp(text, v->key->words)) {
        v->is_word = true;
        return true;
    }
    if (read_numbers(r, v, text, &v->number, 1, &rest) < 1) return false;
    if (!apply_unit(r, v, rest, &v->number, 1)) return false;
    if (v->key->kind == QN_KIND_WHOLE && v->number != floor(v->number)) {
        qn_complain(r, v, "is not a whole number");
        return false;
    }
    return true;
}

static bool read_vector(qn_reader *r, const char *text, qn_value *v)
{
    const char *rest;
    int n = read_numbers(r, v, text, v->vector, 3, &rest);
    if (n < 0) return false;
    if (n < 3) {
        qn_complain(r, v, "has %d number%s, but three are needed: x y z, then the unit", n,
                    n > 1 ? "s" : "");
        return false;
    }
    return apply_unit(r, v, rest, v->vector, 3);
}

static bool read_row(qn_reader *r, const char *text, qn_value *v)
{
    double x[NUMBERS_MAX];
    const char *rest;
    int n = read_numbers(r, v, text, x, NUMBERS_MAX, &rest);
    if (n < 0 || !apply_unit(r, v, rest, x, n)) return false;
    double *numbers = qn_tree_allocate(&r->tree, (size_t)n * sizeof *numbers);
    if (!numbers) {
        qn_complain(r, v, "does not fit into memory");
        return false;
    }
    memcpy(numbers, x, (size_t)n * sizeof *x);
    v->numbers = numbers;
    v->count = n;
    return true;
}

/// Index of `text` in words separated by spaces, or -1.
static int word_index(const char *text, const char *words)
{
    size_t length = strlen(text);
    int i = 0;
    for (const char *p = words; *p; p += strspn(p, " "), i++) {
        size_t n = strcspn(p, " ");
        if (n == length && !strncmp(p, text, n)) return i;
        p += n;
    }
    return -1;
}

static bool read_word(qn_reader *r, const char *text, const char *words, qn_value *v)
{
    char nearest[64];
    v->choice = word_index(text, words);
    v->number = v->choice;
    if (v->choice >= 0) return true;
    size_t length = strlen(words);
    while (length > 0 && words[length - 1] == ' ') length--;
    bool alone = !memchr(words, ' ', length);
    if (!alone && qn_nearest_word(text, words, nearest, sizeof nearest))
        qn_complain(r, v, "is unknown; did you mean '%s'? Allowed: %.*s", nearest, (int)length,
                    words);
    else
        qn_complain(r, v, "is unknown; %s: %.*s", alone ? "it must be" : "allowed", (int)length,
                    words);
    return false;
}

static bool read_material(qn_reader *r, const char *text, qn_value *v)
{
    v->choice = qn_material_find(r->def, text, strlen(text));
    if (v->choice >= 0) return true;
    if (r->def->material_count == 0 && r->messages->errors > 0) return false;  // told already
    char known[QN_NAMES_MAX * 16] = "", nearest[64];
    for (int i = 0; i < r->def->material_count; i++)
        if (strlen(known) + QN_NAME_MAX + 2 < sizeof known)
            strcat(strcat(known, i > 0 ? " " : ""), r->def->materials[i].name);
    if (qn_nearest_word(text, known, nearest, sizeof nearest))
        qn_complain(r, v, "is not a material; did you mean '%s'?", nearest);
    else
        qn_complain(r, v, "is not a material%s%.400s", *known ? "; known are: " : "", known);
    return false;
}

static bool read_unit(qn_reader *r, const char *text, qn_value *v)
{
    const qn_unit *unit = qn_unit_find(text, strlen(text));
    if (unit && unit->dimension == QN_DIMENSION_LENGTH) {
        v->number = unit->times / unit->over;
        return true;
    }
    char allowed[256];
    qn_units_list(QN_IN_LENGTH, allowed, sizeof allowed);
    qn_complain(r, v, "is not a unit of length; allowed: %s", allowed);
    return false;
}

bool qn_value_read(qn_reader *r, const char *text, qn_value *v)
{
    v->text = text;
    if (!*text && v->key->kind != QN_KIND_TEXT) {
        qn_complain(r, v, "has no value: %s", v->key->meaning);
        return false;
    }
    switch (v->key->kind) {
    case QN_KIND_NUMBER:
    case QN_KIND_WHOLE: return read_one(r, text, v);
    case QN_KIND_NUMBERS: return read_row(r, text, v);
    case QN_KIND_VECTOR: return read_vector(r, text, v);
    case QN_KIND_YESNO: return read_word(r, text, "no yes", v);
    case QN_KIND_WORD: return read_word(r, text, v->key->words, v);
    case QN_KIND_MATERIAL: return read_material(r, text, v);
    case QN_KIND_UNIT: return read_unit(r, text, v);
    case QN_KIND_TEXT:
    case QN_KIND_FILE:
    case QN_KIND_MAP:
    case QN_KIND_LIST:
    case QN_KIND_NAMES: return true;
    }
    return true;
}
