// SPDX-License-Identifier: Apache-2.0
#include "measure/measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST_PASSAGES = 2 };  // of lifters in a mean over time

static double final_speed(const qn_world *w)
{
    const qn_drum_def *drum = &w->walls.drum;
    return w->walls.has_drum && drum->leg_count > 0 ? drum->legs[drum->leg_count - 1].to : 0;
}

static int64_t whole_steps(double steps)
{
    return steps < 0x1p62 ? llrint(steps) : INT64_MAX;
}

int64_t qn_span_steps(const qn_world *w, qn_span span)
{
    if (span.unit == QN_STEPS) return whole_steps(span.value);
    if (span.unit == QN_SECONDS) return whole_steps(span.value / w->dt);
    if (!w->walls.has_drum) return INT64_MAX;
    return whole_steps(qn_drum_time(&w->walls.drum, 2 * QN_PI * span.value) / w->dt);
}

// Steps between what happens every so often: at least one, 0 for never.
static qn_status stride_of(const qn_world *w, const char *what, qn_span span, int64_t *stride)
{
    *stride = 0;
    if (!(span.value > 0)) return QN_OK;
    double steps = span.unit == QN_SECONDS ? span.value / w->dt : span.value;
    if (span.unit == QN_REVOLUTIONS) {
        double speed = fabs(final_speed(w));
        if (!(speed > 0))
            return qn_fail(QN_INPUT, "%s = %g rev: nothing turns; give a time or a number of steps",
                           what, span.value);
        steps = 2 * QN_PI * span.value / speed / w->dt;
    }
    *stride = whole_steps(qn_max(1, steps));
    return QN_OK;
}

// Step at which a duration that begins at step `first` is over.
static int64_t step_after(const qn_world *w, int64_t first, qn_span duration)
{
    if (first == INT64_MAX) return first;
    if (duration.unit == QN_REVOLUTIONS && w->walls.has_drum) {
        double sense = qn_drum_sense(&w->walls.drum);
        double turned = sense * qn_drum_angle(&w->walls.drum, (double)first * w->dt);
        double angle = turned + 2 * QN_PI * duration.value;
        return whole_steps(qn_drum_time(&w->walls.drum, angle) / w->dt);
    }
    int64_t steps = qn_span_steps(w, duration);
    return steps < INT64_MAX - first ? first + steps : INT64_MAX;
}

static qn_status create_fields(const qn_world *w, qn_measure *m)
{
    const qn_measure_def *def = &m->def;
    m->fields_first = qn_span_steps(w, def->fields_start);
    m->fields_last = step_after(w, m->fields_first, def->fields_duration);
    QN_TRY(QN_ALLOCATE(m->fields, def->grid_count));
    for (int g = 0; g < def->grid_count; g++) {
        m->field_count++;
        QN_TRY(qn_field_create(w, def->grid_cell[g], def->grid_layers[g], &m->fields[g]));
    }
    return qn_ring_create(w, &m->ring);
}

static int64_t least_samples(const qn_world *w, const qn_measure *m)
{
    double turn = qn_min(FEWEST_PASSAGES * m->passages.angle, 2 * QN_PI);
    double rate = fabs(final_speed(w)) * w->dt * (double)m->fields_stride;  // rad per sample
    int64_t moving = rate > 0 ? (int64_t)qn_min(turn / rate, 1e9) : 0;
    int64_t counted = qn_ring_least_samples(&m->ring, w);
    return moving > counted ? moving : counted;
}

static qn_status create(const qn_world *w, qn_measure *m)
{
    m->def = w->def.measure;
    m->fields_first = m->fields_last = INT64_MAX;
    QN_TRY(stride_of(w, "measure.series", m->def.series_every, &m->series_stride));
    QN_TRY(stride_of(w, "measure.traces.every", m->def.traces_every, &m->traces_stride));
    bool has_fields = w->walls.has_drum && m->def.grid_count > 0 && w->class_count > 0;
    if (has_fields) {
        QN_TRY(stride_of(w, "measure.fields.every", m->def.fields_every, &m->fields_stride));
        QN_TRY(create_fields(w, m));
    }
    int64_t first = has_fields ? m->fields_first : INT64_MAX;
    if (!has_fields && final_speed(w) != 0) first = qn_passages_settled(w);
    QN_TRY(qn_passages_create(w, first, m->fields_last, &m->passages));
    if (m->fields_stride > 0) m->fields_least = least_samples(w, m);
    return qn_series_create(w, &m->series);
}

qn_status qn_measure_create(const qn_world *w, qn_measure *m)
{
    memset(m, 0, sizeof *m);
    qn_status status = create(w, m);
    if (status != QN_OK) qn_measure_free(m);
    return status;
}

void qn_measure_free(qn_measure *m)
{
    for (int g = 0; g < m->field_count; g++) qn_field_free(&m->fields[g]);
    free(m->fields);
    qn_ring_free(&m->ring);
    qn_passages_free(&m->passages);
    qn_series_free(&m->series);
    memset(m, 0, sizeof *m);
}

bool qn_measure_series_due(const qn_measure *m, int64_t step)
{
    return m->series_stride > 0 && step % m->series_stride == 0;
}

bool qn_measure_fields_due(const qn_measure *m, int64_t step)
{
    return m->fields_stride > 0 && step >= m->fields_first && step < m->fields_last
           && (step - m->fields_first) % m->fields_stride == 0;
}

bool qn_measure_traces_due(const qn_measure *m, int64_t step)
{
    return m->def.traced_count > 0 && m->traces_stride > 0 && step % m->traces_stride == 0;
}

static bool balance_due(const qn_measure *m, int64_t step)
{
    return !m->series.begun || qn_measure_series_due(m, step)
           || qn_passages_due(&m->passages, step);
}

qn_status qn_measure_sample(qn_measure *m, const qn_world *w)
{
    if (balance_due(m, w->step)) {
        qn_balance balance;
        QN_TRY(qn_balance_now(w, &balance));
        if (!m->series.begun) qn_series_begin(&m->series, &balance);
        if (qn_measure_series_due(m, w->step)) qn_series_take(&m->series, w, &balance);
        qn_passages_sample(&m->passages, w, &balance);
    }
    if (!qn_measure_fields_due(m, w->step)) return QN_OK;
    for (int g = 0; g < m->field_count; g++) QN_TRY(qn_field_sample(&m->fields[g], w));
    qn_ring_sample(&m->ring, w);
    return QN_OK;
}

qn_status qn_measure_row(const qn_measure *m, const qn_world *w, double *row)
{
    qn_balance balance;
    QN_TRY(qn_balance_now(w, &balance));
    qn_series_row(&m->series, w, &balance, row);
    return QN_OK;
}

double qn_measure_value(const qn_measure *m, const double *row, const char *name)
{
    for (int i = 0; i < m->series.column_count; i++)
        if (strcmp(m->series.columns[i].name, name) == 0) return row[i];
    return NAN;
}

bool qn_measure_lacks_samples(const qn_measure *m)
{
    return m->field_count > 0 && m->ring.samples < m->fields_least;
}

void qn_measure_lack(const qn_measure *m, char *sentence, size_t room)
{
    *sentence = 0;
    if (!qn_measure_lacks_samples(m)) return;
    snprintf(sentence, room,
             "the fields have %lld of the %lld samples that bulk solidity, shoulder and toe need",
             (long long)m->ring.samples, (long long)m->fields_least);
}

qn_status qn_measure_charge(const qn_measure *m, qn_charge *charge)
{
    *charge = (qn_charge){NAN, NAN, NAN};
    const qn_field *nearest = NULL;
    for (int g = 0; g < m->field_count; g++)
        if (!nearest || fabs(m->fields[g].cell - 2) < fabs(nearest->cell - 2))
            nearest = &m->fields[g];
    if (!nearest || qn_measure_lacks_samples(m)) return QN_OK;
    QN_TRY(qn_field_bulk_solidity(nearest, &charge->bulk));
    qn_ring_edges(&m->ring, charge->bulk, &charge->shoulder, &charge->toe);
    return QN_OK;
}

static void append(qn_column *all, int *count, const qn_column *some, int n, int room)
{
    for (int i = 0; i < n; i++, ++*count)
        if (*count < room) all[*count] = some[i];
}

int qn_measure_columns(qn_measure *m, qn_column *columns, int room)
{
    enum { MOST = 32 };  // columns of one module
    qn_column some[MOST];
    int count = 0;
    for (int g = 0; g < m->field_count; g++) {
        int n = qn_field_columns(&m->fields[g], some, MOST);
        for (int i = 0; i < n; i++) {
            char *name = m->grid_names[g][i];
            snprintf(name, QN_NAME_MAX, "grid_%d_%s", g, some[i].name);
            some[i].name = name;
        }
        append(columns, &count, some, n, room);
    }
    append(columns, &count, some, qn_ring_columns(&m->ring, some, MOST), room);
    append(columns, &count, some, qn_passages_columns(&m->passages, some, MOST), room);
    append(columns, &count, some, qn_series_state(&m->series, some, MOST), room);
    return count;
}
