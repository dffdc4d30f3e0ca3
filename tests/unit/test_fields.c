// SPDX-License-Identifier: Apache-2.0
// Voxel fields: known balls in, known solidity and velocities out.
#include "check.h"
#include "fake_mill.h"
#include "measure/fields.h"

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

int main(int argc, char **argv)
{
    TEST(a_uniform_lattice_has_its_solidity_inside_and_at_the_rim);
    TEST(a_ball_on_a_face_is_shared_half_and_half);
    TEST(the_solid_volume_adds_up_exactly);
    TEST(mean_velocity_and_temperature_are_those_of_the_data);
    TEST(a_particle_too_fast_for_the_sums_is_refused);
    DONE;
}
