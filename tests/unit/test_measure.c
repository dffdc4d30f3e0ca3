// SPDX-License-Identifier: Apache-2.0
// Fields, ring and series: known data in, known numbers out, whatever the order.
#include "check.h"
#include "fake_mill.h"
#include "measure/measure.h"

static const double RADIUS = 0.0005;  // m

/// A cubic lattice of touching balls that fills the drum.
static void fill_lattice(qn_world *w)
{
    for (int i = -50; i < 50; i++)
        for (int j = -50; j < 50; j++)
            for (int k = 0; k < 20; k++) {
                double x = (i + 0.5) * 1e-3, y = (j + 0.5) * 1e-3;
                if (hypot(x, y) < 0.05 - RADIUS)
                    fake_add(w, x, y, (k + 0.5) * 1e-3, qn_v3(0.5, 0, 0));
            }
}

/// Area (m2) of a voxel within `radius` of the axis.
static double area_within(const qn_field *f, int64_t voxel, double radius)
{
    double x0 = f->x0 + (double)(voxel % f->nx) * f->side, step = f->side / 200;
    double y0 = f->y0 + (double)(voxel / f->nx % f->ny) * f->side;
    int inside = 0;
    for (int k = 0; k < 40000; k++)
        inside += hypot(x0 + (k % 200 + 0.5) * step, y0 + (k / 200 + 0.5) * step) < radius;
    return inside * step * step;
}

static void a_uniform_lattice_has_its_solidity_inside_and_at_the_rim(void)
{
    qn_world *w = fake_mill(0, 1, RADIUS, 0.01);
    fill_lattice(w);
    qn_field f;
    CHECK_STATUS(qn_field_create(w, 1, 1, &f));
    CHECK(f.nx == 10 && f.ny == 10 && f.nz == 1);
    for (int n = 0; n < 3; n++) CHECK_STATUS(qn_field_sample(&f, w));
    int rim = 0;
    for (int64_t v = 0; v < qn_field_voxel_count(&f); v++) {
        qn_voxel m = qn_field_voxel(&f, v);
        double open = f.open_volume[v] / (f.side * f.side * f.layer);
        if (open > 1 - 1e-12) {
            CHECK_NEAR(m.solidity, QN_PI / 6, 1e-3);
            CHECK_NEAR(m.solidity_raw, QN_PI / 6, 1e-9);
        } else if (open > 0.2) {
            rim++;
            // No centre lies within a radius of the shell.
            double filled = area_within(&f, v, 0.05 - RADIUS) / area_within(&f, v, 0.05);
            CHECK_NEAR(m.solidity, QN_PI / 6 * filled, 0.04);
            CHECK(m.solidity_raw < 0.54 * open);
        }
    }
    CHECK(rim > 20);
    CHECK(f.open_volume[0] == 0 && isnan(qn_field_voxel(&f, 0).solidity));
    double bulk;
    CHECK_STATUS(qn_field_bulk_solidity(&f, &bulk));
    CHECK_NEAR(bulk, QN_PI / 6, 1e-3);
    qn_field_free(&f), fake_free(w);
}

static void a_ball_on_a_face_is_shared_half_and_half(void)
{
    qn_world *w = fake_mill(0, 1, 0.002, 0.002);
    fake_add(w, 0, 0.003, 0.0125, qn_v3(0, 0, 0));
    qn_field f;
    CHECK_STATUS(qn_field_create(w, 5, 2, &f));
    CHECK_STATUS(qn_field_sample(&f, w));
    int64_t left = ((int64_t)f.ny + f.ny / 2) * f.nx + f.nx / 2 - 1;
    const int64_t *solid = f.sum[QN_FIELD_solid_volume];
    CHECK(solid[left] == solid[left + 1] && solid[left] > 0);
    CHECK(f.sum[QN_FIELD_count][left + 1] == 1 && f.sum[QN_FIELD_count][left] == 0);
    qn_field_free(&f), fake_free(w);
}

static void the_solid_volume_adds_up_exactly(void)
{
    qn_world *w = fake_mill(16, 1, 0.001, 0.001);
    fake_fill(w, 5000);
    qn_field f;
    CHECK_STATUS(qn_field_create(w, 2, 3, &f));
    CHECK_STATUS(qn_field_sample(&f, w));
    CHECK_STATUS(qn_field_sample(&f, w));
    int64_t solid = 0, centres = 0;
    double open = 0;
    for (int64_t v = 0; v < qn_field_voxel_count(&f); v++) {
        solid += f.sum[QN_FIELD_solid_volume][v];
        centres += f.sum[QN_FIELD_count][v];
        open += f.open_volume[v];
    }
    double volume = 2 * 5000 * 4.0 / 3 * QN_PI * 1e-9;
    CHECK(centres == 10000);
    CHECK_NEAR((double)solid * f.volume_unit, volume, 1e-13 * volume);
    CHECK_NEAR(open, qn_walls_volume(&w->walls), 2e-3 * open);
    qn_field_free(&f), fake_free(w);
}

static void mean_velocity_and_temperature_are_those_of_the_data(void)
{
    qn_world *w = fake_mill(0, 1, 0.001, 0.01);
    fake_add(w, 0.001, 0.001, 0.01, qn_v3(1.5, -2, 0.25));
    fake_add(w, 0.004, 0.004, 0.01, qn_v3(0.5, -2, -0.25));
    qn_field f;
    CHECK_STATUS(qn_field_create(w, 1, 1, &f));
    CHECK_STATUS(qn_field_sample(&f, w));
    qn_voxel m = qn_field_voxel(&f, 5 * f.nx + 5);
    CHECK_NEAR(m.velocity_x, 1, 1e-9);
    CHECK_NEAR(m.velocity_y, -2, 1e-9);
    CHECK_NEAR(m.velocity_z, 0, 1e-9);
    CHECK_NEAR(m.speed, 0.5 * (sqrt(6.3125) + sqrt(4.3125)), 1e-9);
    CHECK_NEAR(m.granular_temperature, (0.25 + 0.0625) / 3, 1e-9);
    CHECK(isnan(qn_field_voxel(&f, 5 * f.nx + 6).speed));
    qn_field_free(&f), fake_free(w);
}

static void a_particle_too_fast_for_the_sums_is_refused(void)
{
    qn_world *w = fake_mill(0, 1, 0.001, 0.001);
    fake_add(w, 0, 0, 0.01, qn_v3(1e6, 0, 0));
    qn_field f;
    CHECK_STATUS(qn_field_create(w, 1, 1, &f));
    CHECK(qn_field_sample(&f, w) == QN_UNSTABLE);
    w->motion[0].velocity.x = NAN;
    CHECK(qn_field_sample(&f, w) == QN_UNSTABLE && f.samples == 0);
    qn_field_free(&f), fake_free(w);
}

/// Balls on a fine polar grid from `toe` to `shoulder` degrees from straight down, seen with the
/// sense of rotation.
static void edges_of(double toe, double shoulder, double speed, double *found_toe,
                     double *found_shoulder)
{
    qn_world *w = fake_mill(0, speed, RADIUS, RADIUS);
    for (double rho = 0.0485; rho < 0.05; rho += 0.0003)
        for (double angle = toe; angle < shoulder; angle += 0.1) {
            double a = -QN_PI / 2 + (speed < 0 ? -1 : 1) * angle * QN_PI / 180;
            fake_add(w, rho * cos(a), rho * sin(a), 0.01, qn_v3(0, 0, 0));
        }
    qn_ring ring;
    if (qn_ring_create(w, &ring) != QN_OK) abort();
    for (int n = 0; n < 5; n++) qn_ring_sample(&ring, w);
    double bulk = qn_ring_solidity(&ring, (int)(0.5 * (toe + shoulder)) + 180);
    qn_ring_edges(&ring, bulk, found_shoulder, found_toe);
    qn_ring_free(&ring), fake_free(w);
}

static void shoulder_and_toe_are_where_the_charge_ends(void)
{
    double toe, shoulder;
    edges_of(-30.25, 77.25, 3, &toe, &shoulder);
    CHECK_NEAR(toe, -30.25, 0.6);
    CHECK_NEAR(shoulder, 77.25, 0.6);
    edges_of(-30.25, 77.25, -3, &toe, &shoulder);
    CHECK_NEAR(toe, -30.25, 0.6);
    CHECK_NEAR(shoulder, 77.25, 0.6);
    edges_of(-100, 200, 3, &toe, &shoulder);
    CHECK_NEAR(toe, -100, 0.6);
    CHECK_NEAR(shoulder, 200 - 360, 0.6);
    edges_of(-180, 180, 3, &toe, &shoulder);
    CHECK(isnan(toe) && isnan(shoulder));
}

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
    CHECK_NEAR(work, w->ledger.work[shell] + 0.5e-3 * w->ledger.torque_now[shell] * 2, 1e-15);
    CHECK(isnan(qn_measure_value(&m, row, "no such column")));
    double first = 0.5 * 1e-3 * cos(0), now = 1.5 * (shell + 1) + 0.5 * 1e-3 * cos(3);
    char name[128];
    snprintf(name, sizeof name, "torque_%s_n_m", w->walls.parts[shell].name);
    for (char *c = name; *c; c++)
        if (*c == ' ' || *c == '-') *c = '_';
    CHECK_NEAR(qn_measure_value(&m, row, name), (now - first) / 0.003, 1e-9);
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
    double bulk, shoulder, toe;
    CHECK_STATUS(qn_measure_bulk_solidity(&m, &bulk));
    qn_ring_edges(&m.ring, bulk, &shoulder, &toe);
    CHECK(m.field_count == 0 && isnan(bulk) && isnan(shoulder) && isnan(toe));
    CHECK(isnan(qn_passages_power(&m.passages).torque));
    qn_measure_free(&m), fake_free(w);
}

int main(int argc, char **argv)
{
    TEST(a_uniform_lattice_has_its_solidity_inside_and_at_the_rim);
    TEST(a_ball_on_a_face_is_shared_half_and_half);
    TEST(the_solid_volume_adds_up_exactly);
    TEST(mean_velocity_and_temperature_are_those_of_the_data);
    TEST(a_particle_too_fast_for_the_sums_is_refused);
    TEST(shoulder_and_toe_are_where_the_charge_ends);
    TEST(energies_are_the_plain_sums);
    TEST(order_and_threads_change_no_bit);
    TEST(columns_hold_everything_a_resumed_run_needs);
    TEST(rows_tell_the_ledger_up_to_the_step_itself);
    TEST(windows_and_strides_come_from_spans);
    TEST(a_world_without_a_drum_is_observed_too);
    DONE;
}
