// SPDX-License-Identifier: Apache-2.0
// What is observed as a whole: energies, rows, windows, enough samples; the same bits whatever the
// order, and after a stop.
#include "check.h"
#include "fake_mill.h"
#include "measure/measure.h"

static void energies_are_the_plain_sums(void)
{
    qn_world *w = fake_mill(0, 1, 0.001, 0.001);
    fake_fill(w, 3000);
    double translation = 0, rotation = 0, gravity = 0, x = 0, fastest = 0;
    for (int i = 0; i < w->count; i++) {
        qn_vec3 v = qn_velocity_now(w, i), s = w->motion[i].spin;
        translation += 0.5 * w->classes[0].mass * qn_dot(v, v);
        rotation += 0.5 * w->classes[0].inertia * qn_dot(s, s);
        gravity += w->classes[0].mass * 9.81 * w->place[i].y;
        x += w->place[i].x / w->count;
        fastest = qn_max(fastest, qn_norm(v));
    }
    qn_balance b;
    CHECK_STATUS(qn_balance_now(w, &b));
    CHECK_NEAR(b.kinetic_translation, translation, 1e-12 * translation);
    CHECK_NEAR(b.kinetic_rotation, rotation, 1e-12 * rotation);
    CHECK_NEAR(b.gravity, gravity, 1e-12 * translation);
    CHECK_NEAR(b.centre.x, x, 1e-12);
    CHECK_NEAR(b.max_speed, fastest, 0);
    w->motion[5].velocity.y = NAN;
    CHECK(qn_balance_now(w, &b) == QN_UNSTABLE);
    fake_free(w);
}

static qn_world *observed_mill(void)
{
    qn_world *w = fake_mill(16, 2, 0.001, 0.001);
    fake_fill(w, 2000);
    w->def.measure = (qn_measure_def){.series_every = {3, QN_STEPS},
                                      .fields_every = {2, QN_STEPS},
                                      .fields_start = {4, QN_STEPS},
                                      .fields_duration = {1, QN_REVOLUTIONS},
                                      .grid_count = 2,
                                      .grid_cell = {2, 4},
                                      .grid_layers = {1, 2}};
    return w;
}

/// Lets the fake mill's numbers go on without moving anything, from the present step up to `end`.
static qn_status observe(qn_measure *m, qn_world *w, int64_t end)
{
    for (; w->step < end; w->step++) {
        double n = (double)w->step;
        for (int p = 0; p < w->ledger.part_count; p++) {
            w->ledger.work[p] = n * (p + 1) + sin(n);
            w->ledger.impulse[p] = 0.5 * n * (p + 1);
            w->ledger.torque_now[p] = cos(n);
            w->ledger.power_now[p] = 2 * cos(n);
            w->ledger.push[3 * p + 1] = 0.25 * n * (p + 1);
        }
        for (int k = 0; k < QN_LOSS_COUNT; k++) w->ledger.lost[k] = n * k;
        QN_TRY(qn_measure_sample(m, w));
    }
    return QN_OK;
}

static size_t bytes_of(const qn_column *c)
{
    size_t size = c->type == QN_INT32 || c->type == QN_FLOAT ? 4 : 8;
    return (size_t)c->rows * (size_t)c->width * size;
}

/// Whether two measures hold the same bits; -1 or the number of the first column that differs.
static int first_difference(qn_measure *a, qn_measure *b)
{
    qn_column of_a[128], of_b[128];
    int n = qn_measure_columns(a, of_a, 128);
    if (n != qn_measure_columns(b, of_b, 128)) return 0;
    for (int i = 0; i < n; i++)
        if (memcmp(of_a[i].data, of_b[i].data, bytes_of(&of_a[i])) != 0) return i;
    size_t row = (size_t)a->series.column_count * sizeof(double);
    return memcmp(a->series.row, b->series.row, row) == 0 ? -1 : n;
}

static void order_and_threads_change_no_bit(void)
{
    qn_world *w = observed_mill();
    qn_measure a, b;
    CHECK_STATUS(qn_measure_create(w, &a));
    CHECK_STATUS(qn_measure_create(w, &b));
    CHECK_STATUS(observe(&a, w, 13));
    w->step = 0, w->threads = 3;
    fake_reverse(w);
    CHECK_STATUS(observe(&b, w, 13));
    CHECK(a.fields[0].samples == 5 && a.ring.samples == 5);
    CHECK(first_difference(&a, &b) == -1);
    qn_measure_free(&a), qn_measure_free(&b), fake_free(w);
}

static void columns_hold_everything_a_resumed_run_needs(void)
{
    // Stops before, between and after samples, rows (every 3 steps) and passages (every 10).
    for (int64_t stop = 0; stop < 45; stop += 4) {
        int64_t end = stop + 4;
        qn_world *w = observed_mill();
        w->dt = 0.02;
        w->threads = 1;
        qn_measure whole, before, after;
        CHECK_STATUS(qn_measure_create(w, &whole));
        CHECK_STATUS(qn_measure_create(w, &before));
        CHECK_STATUS(qn_measure_create(w, &after));
        CHECK_STATUS(observe(&whole, w, end));
        w->step = 0;
        CHECK_STATUS(observe(&before, w, stop));
        qn_column from[128], to[128];
        int n = qn_measure_columns(&before, from, 128);
        CHECK(n == qn_measure_columns(&after, to, 128) && n < 128);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) CHECK(strcmp(from[i].name, from[j].name) != 0);
            CHECK(bytes_of(&from[i]) > 0);
            memcpy(to[i].data, from[i].data, bytes_of(&from[i]));
        }
        CHECK_STATUS(observe(&after, w, end));
        CHECK(first_difference(&whole, &after) == -1);
        CHECK_NEAR(after.fields[1].filled, whole.fields[1].filled, 0);
        qn_measure_free(&whole), qn_measure_free(&before), qn_measure_free(&after);
        fake_free(w);
    }
}

static void rows_tell_the_ledger_up_to_the_step_itself(void)
{
    qn_world *w = observed_mill();
    qn_measure m;
    CHECK_STATUS(qn_measure_create(w, &m));
    CHECK_STATUS(observe(&m, w, 4));
    const double *row = m.series.row;
    int shell = -1;
    for (int p = 0; p < w->walls.part_count; p++)
        if (strstr(w->walls.parts[p].name, "shell")) shell = p;
    CHECK(shell >= 0 && w->walls.parts[shell].turning);
    w->step = 3;
    CHECK_NEAR(qn_measure_value(&m, row, "step"), 3, 0);
    CHECK_NEAR(qn_measure_value(&m, row, "time_s"), 0.003, 1e-15);
    CHECK_NEAR(qn_measure_value(&m, row, "drum_angle_rad"), 0.006, 1e-15);
    CHECK_NEAR(qn_measure_value(&m, row, "lost_sliding_j"), 3.0 * QN_TALLY_SLIDING, 1e-12);
    double work = qn_part_work(w, shell);
    CHECK_NEAR(work, w->ledger.work[shell] + 0.5e-3 * w->ledger.power_now[shell], 1e-15);
    CHECK(isnan(qn_measure_value(&m, row, "no such column")));
    double first = 0.5 * 1e-3 * cos(0), now = 1.5 * (shell + 1) + 0.5 * 1e-3 * cos(3);
    char name[128];
    snprintf(name, sizeof name, "torque_%s_n_m", w->walls.parts[shell].name);
    for (char *c = name; *c; c++)
        if (*c == ' ' || *c == '-') *c = '_';
    CHECK_NEAR(qn_measure_value(&m, row, name), (now - first) / 0.003, 1e-9);
    snprintf(name, sizeof name, "force_y_%s_n", w->walls.parts[shell].name);
    CHECK_NEAR(qn_measure_value(&m, row, name), 0.75 * (shell + 1) / 0.003, 1e-9);
    double did = work - 0.5e-3 * 2;  // J   since the first row
    snprintf(name, sizeof name, "power_%s_w", w->walls.parts[shell].name);
    CHECK_NEAR(qn_measure_value(&m, row, name), did / 0.003, 1e-9);
    qn_measure_free(&m), fake_free(w);
}

static void windows_and_strides_come_from_spans(void)
{
    qn_world *w = observed_mill();
    qn_measure m;
    w->def.measure.series_every = (qn_span){0.0104, QN_SECONDS};
    w->def.measure.fields_start = (qn_span){2, QN_REVOLUTIONS};
    CHECK_STATUS(qn_measure_create(w, &m));
    CHECK(m.series_stride == 10 && m.traces_stride == 0);
    CHECK(m.fields_first == 6283 && m.fields_last == 9425);
    CHECK(!qn_measure_fields_due(&m, 6282) && qn_measure_fields_due(&m, 6283));
    CHECK(!qn_measure_fields_due(&m, 6284) && !qn_measure_fields_due(&m, 9425));
    qn_measure_free(&m), fake_free(w);
}

static int64_t least_samples(double speed, double every)
{
    qn_world *w = observed_mill();
    w->walls.drum.legs[0] = (qn_leg){INFINITY, speed, speed};
    w->def.measure.fields_every.value = every;
    qn_measure m;
    if (qn_measure_create(w, &m) != QN_OK) abort();
    int64_t least = m.fields_least;
    qn_measure_free(&m), fake_free(w);
    return least;
}

static void a_mean_takes_two_passages_and_enough_balls(void)
{
    // Two sixteenths of a revolution at 2 rad/s take 392.7 steps of 1 ms.
    CHECK(least_samples(2, 1) == 392 && least_samples(-2, 1) == 392 && least_samples(2, 4) == 98);
    // Five degrees of a ring 8 mm deep and 20 mm long, a third full, hold about 45 balls of 1 mm.
    int64_t counted = least_samples(0, 1);
    CHECK(counted >= 8 && counted <= 11);
    CHECK(least_samples(2, 1000) == counted && least_samples(1000, 1) == counted);
}

/// A cubic lattice of touching balls that fills the lower half.
static void fill_half(qn_world *w)
{
    for (int i = -25; i < 25; i++)
        for (int j = -25; j < 0; j++)
            for (int k = 0; k < 10; k++) {
                double x = (i + 0.5) * 2e-3, y = (j + 0.5) * 2e-3;
                if (hypot(x, y) < 0.049) fake_add(w, x, y, (k + 0.5) * 2e-3, qn_v3(0, 0, 0));
            }
}

static void the_charge_is_told_from_enough_samples_on(void)
{
    qn_world *w = fake_mill(16, 2, 0.001, 0.001);
    fill_half(w);
    w->def.measure = (qn_measure_def){.fields_every = {20, QN_STEPS},
                                      .fields_duration = {1, QN_REVOLUTIONS},
                                      .grid_count = 1,
                                      .grid_cell = {2},
                                      .grid_layers = {1}};
    qn_measure m;
    qn_charge charge;
    char lack[160];
    CHECK_STATUS(qn_measure_create(w, &m));
    CHECK(m.fields_least == 19);
    CHECK_STATUS(observe(&m, w, 18 * 20));
    CHECK_STATUS(qn_measure_charge(&m, &charge));
    CHECK(isnan(charge.bulk) && isnan(charge.shoulder) && isnan(charge.toe));
    qn_measure_lack(&m, lack, sizeof lack);
    CHECK(strstr(lack, "18 of the 19 samples"));
    CHECK_STATUS(observe(&m, w, 19 * 20));
    CHECK_STATUS(qn_measure_charge(&m, &charge));
    CHECK_NEAR(charge.bulk, QN_PI / 6, 0.02);
    CHECK_NEAR(charge.shoulder, 90, 3);
    CHECK_NEAR(charge.toe, -90, 3);
    qn_measure_lack(&m, lack, sizeof lack);
    CHECK(!*lack);
    qn_measure_free(&m), fake_free(w);
}

static void a_world_without_a_drum_is_observed_too(void)
{
    qn_world *w = observed_mill();
    qn_walls_free(&w->walls);
    memset(&w->walls, 0, sizeof w->walls);
    w->ledger.part_count = 0;
    qn_measure m;
    CHECK_STATUS(qn_measure_create(w, &m));
    CHECK_STATUS(observe(&m, w, 7));
    CHECK_NEAR(qn_measure_value(&m, m.series.row, "step"), 6, 0);
    qn_charge charge;
    char lack[160];
    CHECK_STATUS(qn_measure_charge(&m, &charge));
    CHECK(m.field_count == 0 && isnan(charge.bulk) && isnan(charge.shoulder) && isnan(charge.toe));
    qn_measure_lack(&m, lack, sizeof lack);
    CHECK(!*lack);
    CHECK(isnan(qn_passages_power(&m.passages).torque));
    qn_measure_free(&m), fake_free(w);
}

int main(int argc, char **argv)
{
    TEST(energies_are_the_plain_sums);
    TEST(order_and_threads_change_no_bit);
    TEST(columns_hold_everything_a_resumed_run_needs);
    TEST(rows_tell_the_ledger_up_to_the_step_itself);
    TEST(windows_and_strides_come_from_spans);
    TEST(a_mean_takes_two_passages_and_enough_balls);
    TEST(the_charge_is_told_from_enough_samples_on);
    TEST(a_world_without_a_drum_is_observed_too);
    DONE;
}
