// SPDX-License-Identifier: Apache-2.0
#include "scene/keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The words of the laws and models are put together from their lists.
#define L(NAME, text, normal, damping, tangential, clips, meaning) text " "
#define N(NAME, model, text, power, unit, meaning) text " "
#define D(NAME, model, text, with, unit, meaning) text " "
#define C(NAME, model, text, with, meaning) text " "
#define T(NAME, model, text, with, meaning) text " "
#define R(NAME, model, text, remembers, meaning) text " "
#define Z(NAME, name, text, meaning) text " "
#define K(name, kind, units, range, words, fallback, resume, meaning) \
    {#name, QN_KIND_##kind, QN_IN_##units, range, words, fallback, QN_RESUME_##resume, meaning},
#define S(NAME, lower, path, title) static const qn_key lower##_keys[] = {QN_##NAME##_KEYS(K)};
QN_SECTIONS(S)
#undef S
#undef K
#undef L
#undef N
#undef D
#undef C
#undef T
#undef R
#undef Z

const qn_section qn_sections[QN_SECTION_COUNT] = {
#define S(NAME, lower, path, title) \
    [QN_SECTION_##NAME] = {path, title, lower##_keys, sizeof lower##_keys / sizeof(qn_key)},
    QN_SECTIONS(S)
#undef S
};

// A section's values can be walked as an array beside its keys.
#define S(NAME, lower, path, title)                                                \
    _Static_assert(sizeof(qn_##lower##_keys)                                       \
                       == sizeof lower##_keys / sizeof(qn_key) * sizeof(qn_value), \
                   "one value per key");
QN_SECTIONS(S)
#undef S

const qn_key *qn_key_find(const char *place, const char *name)
{
    size_t length = strlen(place);
    for (const qn_section *s = qn_sections; s < qn_sections + QN_SECTION_COUNT; s++) {
        // "walls.NAME (shape: plane)" and "contacts.NAME-NAME" stand at "walls.NAME", "contacts.NAME"
        bool here = !strncmp(s->path, place, length) && strchr(" -", s->path[length]);
        for (int i = 0; here && i < s->key_count; i++)
            if (!strcmp(s->keys[i].name, name)) return &s->keys[i];
    }
    return NULL;
}

typedef struct interval {
    double low, high;
    bool low_open, high_open;
} interval;

static interval interval_of(const char *range)
{
    if (!*range) return (interval){-HUGE_VAL, HUGE_VAL, true, true};
    char *comma;
    interval i = {.low_open = *range == ']'};
    i.low = strtod(range + 1, &comma);
    char *bracket;
    i.high = strtod(comma + 1, &bracket);
    i.high_open = *bracket == '[';
    return i;
}

bool qn_key_allows(const qn_key *key, double x)
{
    interval i = interval_of(key->range);
    return (i.low_open ? x > i.low : x >= i.low) && (i.high_open ? x < i.high : x <= i.high);
}

void qn_key_range_text(const qn_key *key, const qn_unit *unit, char *text, size_t size)
{
    interval i = interval_of(key->range);
    double scale = unit ? unit->over / unit->times : 1;
    const char *name = unit ? unit->name : "";
    char low[64] = "", high[64] = "";
    if (isfinite(i.low))
        snprintf(low, sizeof low, "%s %.6g", i.low_open ? "above" : "at least", i.low * scale);
    if (isfinite(i.high))
        snprintf(high, sizeof high, "%s %.6g", i.high_open ? "below" : "at most", i.high * scale);
    snprintf(text, size, "%s%s%s%s%s", low, *low && *high ? " and " : "", high,
             (*low || *high) && *name ? " " : "", *low || *high ? name : "");
}

const char *qn_kind_text(qn_kind kind)
{
    static const char *const texts[] = {
#define X(NAME, text) text,
        QN_KINDS(X)
#undef X
    };
    return texts[kind];
}
