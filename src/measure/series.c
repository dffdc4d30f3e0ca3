// SPDX-License-Identifier: Apache-2.0
#include "measure/series.h"
#include "world/flow.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name, *unit, *meaning;
} plain[] = {
#define C(name, unit, expression, meaning) {#name, unit, meaning},
    QN_SERIES_COLUMNS(C)
#undef C
};

static const struct {
    const char *name, *unit, *suffix, *meaning;
} by_part[] = {
#define C(name, unit, suffix, expression, meaning) {#name, unit, suffix, meaning},
    QN_SERIES_PART_COLUMNS(C)
#undef C
};

enum {
    PLAIN = sizeof plain / sizeof *plain,
    BY_PART = sizeof by_part / sizeof *by_part,
};

// A part's name as part of a column's: letters, digits and underscores.
static void name_part_column(char *out, size_t size, int which, const char *part)
{
    snprintf(out, size, "%s_%s%s", by_part[which].name, part, by_part[which].suffix);
    for (; *out; out++)
        if (!isalnum((unsigned char)*out)) *out = '_';
}

qn_status qn_series_create(const qn_world *w, qn_series *s)
{
    memset(s, 0, sizeof *s);
    s->part_count = w->ledger.part_count;
    s->column_count = PLAIN + BY_PART * s->part_count;
    s->row_step = -1;
    QN_TRY(QN_ALLOCATE(s->columns, s->column_count));
    QN_TRY(QN_ALLOCATE(s->row, s->column_count));
    QN_TRY(QN_ALLOCATE(s->impulse, s->part_count));
    QN_TRY(QN_ALLOCATE(s->part_work, s->part_count));
    QN_TRY(QN_ALLOCATE(s->push, 3 * s->part_count));
    qn_series_column *c = s->columns;
    for (int i = 0; i < PLAIN; i++, c++) {
        snprintf(c->name, sizeof c->name, "%s", plain[i].name);
        c->unit = plain[i].unit;
        c->meaning = plain[i].meaning;
    }
    for (int p = 0; p < s->part_count; p++)
        for (int i = 0; i < BY_PART; i++, c++) {
            name_part_column(c->name, sizeof c->name, i, w->walls.parts[p].name);
            c->unit = by_part[i].unit;
            c->meaning = by_part[i].meaning;
        }
    return QN_OK;
}

void qn_series_free(qn_series *s)
{
    free(s->columns);
    free(s->row);
    free(s->impulse);
    free(s->part_work);
    free(s->push);
    memset(s, 0, sizeof *s);
}

void qn_series_begin(qn_series *s, const qn_balance *b)
{
    s->start = *b;
    s->begun = 1;
    s->row_step = -1;
}

static double drum_angle(const qn_world *w)
{
    return w->walls.has_drum ? qn_drum_angle(&w->walls.drum, qn_world_time(w)) : 0;
}

static double drum_speed(const qn_world *w)
{
    return w->walls.has_drum ? qn_drum_speed(&w->walls.drum, qn_world_time(w)) : 0;
}

static double residual_relative(const qn_balance *b, const qn_series *s)
{
    double turnover = qn_balance_turnover(b, &s->start);
    return turnover > 0 ? qn_balance_residual(b, &s->start) / turnover : 0;
}

// A difference to the row before, by the time since; not a number for the first row.
static double since(const qn_world *w, const qn_series *s, double difference)
{
    if (s->row_step < 0 || s->row_step == w->step) return NAN;
    return difference / (qn_world_time(w) - s->time);
}

static double per_particle(const qn_world *w)
{
    int particles = qn_world_particles(w);
    return particles > 0 ? 2 * (double)w->ledger.contacts_now / particles : 0;
}

void qn_series_row(const qn_series *s, const qn_world *w, const qn_balance *b, double *row)
{
    const qn_ledger *l = &w->ledger;
#define C(name, unit, expression, meaning) *row++ = (expression);
    QN_SERIES_COLUMNS(C)
#undef C
    for (int p = 0; p < s->part_count; p++) {
#define C(name, unit, suffix, expression, meaning) *row++ = (expression);
        QN_SERIES_PART_COLUMNS(C)
#undef C
    }
}

void qn_series_take(qn_series *s, const qn_world *w, const qn_balance *b)
{
    qn_series_row(s, w, b, s->row);
    s->row_step = w->step;
    s->time = qn_world_time(w);
    s->work = b->work;
    s->lost = b->lost;
    for (int p = 0; p < s->part_count; p++) {
        s->impulse[p] = qn_part_impulse(w, p);
        s->part_work[p] = qn_part_work(w, p);
        for (int k = 0; k < 3; k++) s->push[3 * p + k] = qn_part_push(w, p, k);
    }
}

int qn_series_state(qn_series *s, qn_column *columns, int room)
{
    const qn_column all[] = {
        {"series_begun", "1", "whether the start is known", QN_INT64, 1, 1, &s->begun},
        {"series_row_step", "1", "step of the latest row", QN_INT64, 1, 1, &s->row_step},
        {"series_time", "s", "time of the latest row", QN_DOUBLE, 1, 1, &s->time},
        {"series_work", "J", "work up to the latest row", QN_DOUBLE, 1, 1, &s->work},
        {"series_lost", "J", "losses up to the latest row", QN_DOUBLE, 1, 1, &s->lost},
        {"series_impulse", "N m s", "torque times time by part up to it", QN_DOUBLE, 1,
         s->part_count, s->impulse},
        {"series_part_work", "J", "work by part up to it", QN_DOUBLE, 1, s->part_count,
         s->part_work},
        {"series_push", "N s", "force times time by part up to it", QN_DOUBLE, 3, s->part_count,
         s->push},
        {"series_start", "J", "energy balance at the start of the run, as struct qn_balance",
         QN_DOUBLE, 1, sizeof s->start / sizeof(double), &s->start},
    };
    int count = (int)(sizeof all / sizeof *all);
    for (int i = 0; i < count && i < room; i++) columns[i] = all[i];
    return count;
}
