// SPDX-License-Identifier: Apache-2.0
#include "measure/passages.h"

#include <stdlib.h>
#include <string.h>

enum { FEWEST_BATCHES = 8, FEWEST_NOTES = 4 };

int64_t qn_passages_settled(const qn_world *w)
{
    const qn_drum_def *drum = &w->walls.drum;
    int last = drum->leg_count - 1;
    double final = drum->legs[last].to;
    while (last >= 0 && drum->legs[last].from == final && drum->legs[last].to == final) last--;
    double t = 0;
    for (int i = 0; i <= last; i++) t += drum->legs[i].duration;
    double steps = ceil(t / w->dt);
    return steps < 0x1p62 ? (int64_t)steps : INT64_MAX;
}

// Step of boundary `next`; the first is where the window begins.
static int64_t boundary_step(const qn_passages *p)
{
    if (p->next == 0) return p->first_step;
    double t = qn_drum_time(p->drum, p->start_angle + (double)p->next * p->angle) / p->dt;
    return t < 0x1p62 ? llrint(t) : INT64_MAX;
}

qn_status qn_passages_create(const qn_world *w, int64_t first, int64_t last, qn_passages *p)
{
    memset(p, 0, sizeof *p);
    const qn_drum_def *drum = &w->walls.drum;
    double speed =
        w->walls.has_drum && drum->leg_count > 0 ? drum->legs[drum->leg_count - 1].to : 0;
    p->part_count = w->ledger.part_count;
    QN_TRY(QN_ALLOCATE(p->turning, p->part_count));
    QN_TRY(QN_ALLOCATE(p->part_work[0], p->part_count));
    QN_TRY(QN_ALLOCATE(p->part_work[1], p->part_count));
    for (int i = 0; i < p->part_count; i++) p->turning[i] = w->walls.parts[i].turning;
    p->active = speed != 0 && first < INT64_MAX;
    p->lifters = drum->lifter_count > 0 && !w->walls.has_profile_file;
    p->angle = 2 * QN_PI / (p->lifters ? drum->lifter_count : QN_PASSAGES_SMOOTH);
    p->sense = (int)qn_drum_sense(drum);
    p->dt = w->dt;
    p->drum = drum;
    p->first_step = first;
    p->last_step = last;
    p->start_angle = p->active ? p->sense * qn_drum_angle(drum, (double)first * w->dt) : 0;
    p->stride = 1;
    p->next_step = first;
    return QN_OK;
}

void qn_passages_free(qn_passages *p)
{
    free(p->turning);
    free(p->part_work[0]);
    free(p->part_work[1]);
    memset(p, 0, sizeof *p);
}

bool qn_passages_due(const qn_passages *p, int64_t step)
{
    return p->active && step == p->next_step && step <= p->last_step;
}

// Drops every second note; the first and the latest stay.
static void thin_out(qn_passages *p)
{
    for (int i = 0; i <= QN_PASSAGES_MAX / 2; i++) {
        p->step[i] = p->step[2 * i];
        p->work[i] = p->work[2 * i];
    }
    p->count = QN_PASSAGES_MAX / 2 + 1;
    p->stride *= 2;
}

void qn_passages_sample(qn_passages *p, const qn_world *w, const qn_balance *balance)
{
    if (!qn_passages_due(p, w->step)) return;
    p->step[p->count] = w->step;
    p->work[p->count] = qn_drive_work(w);
    for (int end = p->count == 0 ? 0 : 1; end < 2; end++) {
        p->lost[end] = balance->lost;
        p->stored[end] = balance->stored;
        for (int i = 0; i < p->part_count; i++) p->part_work[end][i] = qn_part_work(w, i);
    }
    p->count++;
    if (p->count == QN_PASSAGES_MAX + 1) thin_out(p);
    p->next += p->stride;
    p->next_step = boundary_step(p);
}

// Standard error of the mean of `values` about 0, which they scatter around: the largest of the
// estimates from batches of 1, 2, 4, ... values; overwrites them.
static double batched_error(double *values, int n)
{
    double largest = NAN;
    while (n >= 2) {
        double squares = 0, sum = 0;
        for (int i = 0; i < n; i++) sum += values[i];
        for (int i = 0; i < n; i++) squares += (values[i] - sum / n) * (values[i] - sum / n);
        double error = sqrt(squares / n / (n - 1));
        if (!(largest >= error)) largest = error;
        if (n / 2 < FEWEST_BATCHES) break;
        for (int i = 0; i < n / 2; i++) values[i] = 0.5 * (values[2 * i] + values[2 * i + 1]);
        n /= 2;
    }
    return largest;
}

// Slope (W/s) of the straight line through the powers of the intervals, by least squares; takes the
// line off them.
static double take_off_line(double *power, const double *time, int n)
{
    double t = 0, f = 0, tt = 0, tf = 0;
    for (int i = 0; i < n; i++) {
        t += time[i] / n;
        f += power[i] / n;
    }
    for (int i = 0; i < n; i++) {
        tt += (time[i] - t) * (time[i] - t);
        tf += (time[i] - t) * (power[i] - f);
    }
    double slope = tf / tt;
    for (int i = 0; i < n; i++) power[i] -= f + slope * (time[i] - t);
    return slope;
}

static double window_of(const qn_passages *p)
{
    return p->count < 2 ? (double)NAN : (double)(p->step[p->count - 1] - p->step[0]) * p->dt;
}

qn_power qn_passages_power(const qn_passages *p)
{
    qn_power out = {0, NAN, NAN, NAN, NAN, NAN, NAN, false};
    int n = p->count > 0 ? (int)p->count - 1 : 0;
    if (n < 1) return out;
    double power[QN_PASSAGES_MAX], time[QN_PASSAGES_MAX], off[QN_PASSAGES_MAX];
    for (int i = 0; i < n; i++) {
        double length = (double)(p->step[i + 1] - p->step[i]) * p->dt;
        power[i] = off[i] = (p->work[i + 1] - p->work[i]) / length;
        time[i] = 0.5 * (double)(p->step[i + 1] + p->step[i]) * p->dt;
    }
    out.passages = n * p->stride;
    out.window = window_of(p);
    out.torque = (p->work[n] - p->work[0]) / out.window;
    out.dissipated = (p->lost[1] - p->lost[0]) / out.window;
    out.storing = (p->stored[1] - p->stored[0]) / out.window;
    out.standard_error = batched_error(power, n);
    if (n < FEWEST_NOTES - 1) return out;
    out.drift = take_off_line(off, time, n) * out.window;
    double drift_error = sqrt(12) * batched_error(off, n);
    out.steady = fabs(out.drift) <= 0.02 * fabs(out.torque) || fabs(out.drift) < 2 * drift_error;
    return out;
}

double qn_passages_part_power(const qn_passages *p, int part)
{
    return (p->part_work[1][part] - p->part_work[0][part]) / window_of(p);
}

int qn_passages_columns(qn_passages *p, qn_column *columns, int room)
{
    const qn_column all[] = {
        {"passages_stride", "1", "passages between notes", QN_INT64, 1, 1, &p->stride},
        {"passages_next", "1", "number of the next boundary", QN_INT64, 1, 1, &p->next},
        {"passages_next_step", "1", "its step", QN_INT64, 1, 1, &p->next_step},
        {"passages_count", "1", "notes taken", QN_INT64, 1, 1, &p->count},
        {"passages_step", "1", "steps of the notes", QN_INT64, 1, QN_PASSAGES_MAX + 1, p->step},
        {"passages_work", "J", "the drive's work up to each", QN_DOUBLE, 1, QN_PASSAGES_MAX + 1,
         p->work},
        {"passages_lost", "J", "losses up to the first and the latest note", QN_DOUBLE, 1, 2,
         p->lost},
        {"passages_stored", "J", "stored energy at the first and the latest note", QN_DOUBLE, 1, 2,
         p->stored},
        {"passages_part_work_first", "J", "work by part up to the first note", QN_DOUBLE, 1,
         p->part_count, p->part_work[0]},
        {"passages_part_work_latest", "J", "work by part up to the latest note", QN_DOUBLE, 1,
         p->part_count, p->part_work[1]},
    };
    int count = (int)(sizeof all / sizeof *all);
    for (int i = 0; i < count && i < room; i++) columns[i] = all[i];
    return count;
}
