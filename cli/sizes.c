// SPDX-License-Identifier: Apache-2.0
#include "cli/sizes.h"

#include <stdio.h>

// A size of a group: how many there are, and their mass; for a group that is fed later none, and the mass
// of its share of one particle.
typedef struct row {
    double diameter;  // m
    int64_t count;
    double mass;  // kg
} row;

// Balls or clumps of a class.
static int64_t count_of(const qn_world *w, int klass)
{
    int64_t count = 0;
    int grain = w->classes[klass].grain;
    for (int i = 0; grain < 0 && i < w->count; i++) count += w->place[i].klass == klass;
    for (int b = 0; grain >= 0 && b < w->body_count; b++) count += w->bodies[b].grain == grain;
    return count;
}

// The sizes of a group by rising diameter, and their mass. Returns how many.
static int rows_of(const qn_world *w, int group, row rows[QN_SIZES_MAX], double *mass)
{
    const qn_group_def *g = &w->def.groups[group];
    int n = 0, first = 0;
    for (int k = 0; k < group; k++) first += w->def.groups[k].size_count;
    *mass = 0;
    for (int s = 0; s < g->size_count; s++) {
        bool fed = g->packing == QN_PACK_FEED;
        row fresh = {g->diameter[s], count_of(w, first + s), 0};
        fresh.mass = w->classes[first + s].mass * (fed ? g->fraction[s] : (double)fresh.count);
        *mass += fresh.mass;
        int at = n++;
        for (; at > 0 && rows[at - 1].diameter > fresh.diameter; at--) rows[at] = rows[at - 1];
        rows[at] = fresh;
    }
    return n;
}

void cli_sizes_print(const qn_world *w)
{
    for (int g = 0; g < w->def.group_count; g++) {
        row rows[QN_SIZES_MAX];
        double mass, below = 0;
        int n = rows_of(w, g, rows, &mass);
        if (n < 2) continue;
        printf("\nsizes of %s\n  diameter [m]  number     share of mass  not larger\n",
               w->def.groups[g].name);
        for (int k = 0; k < n; k++) {
            below += rows[k].mass;
            printf("  %-12.5g  %-9lld  %9.3f %%    %9.3f %%\n", rows[k].diameter,
                   (long long)rows[k].count, 100 * rows[k].mass / mass, 100 * below / mass);
        }
    }
}

void cli_sizes_put(qn_json *j, const qn_world *w)
{
    qn_json_open(j, "sizes", '{');
    for (int g = 0; g < w->def.group_count; g++) {
        row rows[QN_SIZES_MAX];
        double mass;
        int n = rows_of(w, g, rows, &mass);
        qn_json_open(j, w->def.groups[g].name, '[');
        for (int k = 0; k < n; k++) {
            qn_json_open(j, NULL, '{');
            qn_json_number(j, "diameter_m", rows[k].diameter);
            qn_json_integer(j, "number", rows[k].count);
            qn_json_number(j, "mass_share", rows[k].mass / mass);
            qn_json_close(j);
        }
        qn_json_close(j);
    }
    qn_json_close(j);
}
