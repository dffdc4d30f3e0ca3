// SPDX-License-Identifier: Apache-2.0
#include "scene/units.h"

#include <stdio.h>
#include <string.h>

static const qn_unit units[] = {
#define U(dimension, name, times, over) {QN_DIMENSION_##dimension, name, times, over},
    QN_UNITS(U)
#undef U
};

static const char *const dimensions[] = {
#define D(NAME, what) what,
    QN_DIMENSIONS(D)
#undef D
};

enum { UNIT_COUNT = sizeof units / sizeof *units };

static bool same_but_carets(const char *name, size_t length, const char *known)
{
    for (size_t i = 0; i < length; i++)
        if (name[i] != '^' && name[i] != *known++) return false;
    return *known == '\0';
}

const qn_unit *qn_unit_find(const char *name, size_t length)
{
    for (int i = 0; i < UNIT_COUNT; i++)
        if (same_but_carets(name, length, units[i].name)) return &units[i];
    return NULL;
}

static void append(char *text, size_t size, const char *separator, const char *word)
{
    size_t used = strlen(text);
    if (used < size) snprintf(text + used, size - used, "%s%s", used ? separator : "", word);
}

void qn_units_list(unsigned accepted, char *text, size_t size)
{
    *text = '\0';
    for (int i = 0; i < UNIT_COUNT; i++)
        if (accepted >> units[i].dimension & 1) append(text, size, ", ", units[i].name);
}

void qn_units_describe(unsigned accepted, char *text, size_t size)
{
    *text = '\0';
    for (int i = 0; i < QN_DIMENSION_COUNT; i++) {
        unsigned rest = accepted >> i;
        if (rest & 1) append(text, size, rest == 1 ? " or " : ", ", dimensions[i]);
    }
}

const qn_unit *qn_units_first(unsigned accepted)
{
    unsigned lowest = accepted & ~(accepted - 1);
    for (int i = 0; i < UNIT_COUNT; i++)
        if (lowest >> units[i].dimension & 1) return &units[i];
    return NULL;
}

const char *qn_dimension_text(int dimension)
{
    return dimensions[dimension];
}
