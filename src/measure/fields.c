// SPDX-License-Identifier: Apache-2.0
#include "measure/fields.h"
#include "measure/open.h"
#include "world/flow.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

// Points of a cubic lattice that stand for a ball of radius 1: those of half-odd coordinates with
// r2 <= 4.75, scaled so that the mean square distance is the ball's 3/5, and turned by a rotation
// with rational elements, (1, 2, 3, 4) as a quaternion, so that no plane of the lattice lies along a
// voxel's face. Centroid and second moments are those of a ball.
static void ball_points(qn_vec3 *points)
{
    const double scale = sqrt(0.6 * QN_BALL_POINTS / 186.0);  // 186: sum of r2
    int n = 0;
    for (int i = -3; i <= 3; i += 2)
        for (int j = -3; j <= 3; j += 2)
            for (int k = -3; k <= 3; k += 2) {
                if (i * i + j * j + k * k > 19) continue;
                double s = scale / 30;
                points[n++] = qn_v3(s * (-10 * i + 2 * j + 11 * k), s * (10 * i - 5 * j + 10 * k),
                                    s * (5 * i + 14 * j + 2 * k));
            }
}

static qn_status allocate(qn_field *f, const qn_world *w)
{
    int64_t voxels = qn_field_voxel_count(f);
    for (int s = 0; s < QN_FIELD_SUM_COUNT; s++) QN_TRY(QN_ALLOCATE(f->sum[s], voxels));
    QN_TRY(QN_ALLOCATE(f->open_volume, voxels));
    return QN_ALLOCATE(f->ball_weight, w->class_count);
}

static qn_status fill_open_volume(qn_field *f, const qn_walls *walls)
{
    qn_open *open;
    QN_TRY(QN_ALLOCATE(open, 1));
    qn_open_build(walls, open);
    int64_t plane = (int64_t)f->nx * f->ny;
    for (int iy = 0; iy < f->ny; iy++)
        for (int ix = 0; ix < f->nx; ix++) {
            double area = qn_open_square(open, f->x0 + ix * f->side, f->y0 + iy * f->side, f->side);
            for (int iz = 0; iz < f->nz; iz++)
                f->open_volume[iz * plane + (int64_t)iy * f->nx + ix] = area * f->layer;
        }
    free(open);
    return QN_OK;
}

qn_status qn_field_create(const qn_world *w, double cell, int layers, qn_field *f)
{
    memset(f, 0, sizeof *f);
    double radius = w->walls.profile.radius;
    f->cell = cell;
    f->side = cell * w->largest_radius;
    f->radius = radius;
    f->length = w->walls.drum.length;
    f->layer = f->length / layers;
    double across = qn_max(1, ceil(2 * radius / f->side - 1e-9));
    if (!(across * across * layers < 0x1p31))
        return qn_fail(QN_INPUT,
                       "measure.fields: cells = %g and layers = %d make %g voxels; allowed are up "
                       "to 2147483648",
                       cell, layers, across * across * layers);
    f->nx = f->ny = (int)across;
    f->nz = layers;
    f->x0 = f->y0 = -0.5 * across * f->side;
    f->first_step = f->last_step = -1;
    QN_TRY(allocate(f, w));

    double volume = f->side * f->side * f->layer, d = 2 * w->smallest_radius;
    f->volume_unit = qn_volume_quantum(w, volume, QN_BALL_POINTS);
    for (int c = 0; c < w->class_count; c++)
        f->ball_weight[c] = llrint(w->classes[c].volume / (QN_BALL_POINTS * f->volume_unit));
    double most =
        (f->side + d) * (f->side + d) * (f->layer + d) / qn_ball_volume(w->smallest_radius);
    f->crowd = 1 + (int64_t)qn_min((double)qn_flow_most(w), most);
    return fill_open_volume(f, &w->walls);
}

void qn_field_free(qn_field *f)
{
    for (int s = 0; s < QN_FIELD_SUM_COUNT; s++) free(f->sum[s]);
    free(f->open_volume);
    free(f->ball_weight);
    memset(f, 0, sizeof *f);
}

static int clamp(double x, int n)
{
    return x < 0 ? 0 : x >= n ? n - 1 : (int)x;
}

// The voxel of a point: around a periodic axis, the nearest one for a point just outside the grid.
static int64_t voxel_of(const qn_field *f, double period, double x, double y, double z)
{
    if (period > 0) z -= floor(z / period) * period;
    int ix = clamp((x - f->x0) / f->side, f->nx), iy = clamp((y - f->y0) / f->side, f->ny);
    return ((int64_t)clamp((z - f->z0) / f->layer, f->nz) * f->ny + iy) * f->nx + ix;
}

static void add(int64_t *sum, int64_t voxel, int64_t value)
{
#pragma omp atomic
    sum[voxel] += value;
}

// Spreads a ball's volume over the voxels of its points, a run of points in one voxel at a time.
static void spread(qn_field *f, double period, qn_vec3 centre, double radius, int64_t weight,
                   const qn_vec3 *points)
{
    int64_t *sum = f->sum[QN_FIELD_solid_volume];
    int64_t voxel = -1, pending = 0;
    for (int k = 0; k < QN_BALL_POINTS; k++) {
        qn_vec3 p = qn_madd(centre, radius, points[k]);
        int64_t here = voxel_of(f, period, p.x, p.y, p.z);
        if (here != voxel && pending > 0) {
            add(sum, voxel, pending);
            pending = 0;
        }
        voxel = here;
        pending += weight;
    }
    add(sum, voxel, pending);
}

// Adds a particle to the voxel of its centre.
static void add_at(qn_field *f, const qn_world *w, qn_vec3 centre, int64_t volume, qn_vec3 v)
{
    int64_t voxel = voxel_of(f, w->period, centre.x, centre.y, centre.z);
    const double q = 1 / QN_SPEED_QUANTUM;
    add(f->sum[QN_FIELD_count], voxel, 1);
    add(f->sum[QN_FIELD_centre_volume], voxel, volume);
    add(f->sum[QN_FIELD_velocity_sum_x], voxel, llrint(v.x * q));
    add(f->sum[QN_FIELD_velocity_sum_y], voxel, llrint(v.y * q));
    add(f->sum[QN_FIELD_velocity_sum_z], voxel, llrint(v.z * q));
    add(f->sum[QN_FIELD_speed_sum], voxel, llrint(qn_norm(v) * q));
    add(f->sum[QN_FIELD_velocity_square_sum_x], voxel, llrint(v.x * v.x * q));
    add(f->sum[QN_FIELD_velocity_square_sum_y], voxel, llrint(v.y * v.y * q));
    add(f->sum[QN_FIELD_velocity_square_sum_z], voxel, llrint(v.z * v.z * q));
}

// Takes this sample's largest possible addition to any sum out of what the sums can hold, 2^62.
static qn_status make_room(qn_field *f, const qn_world *w)
{
    double fastest = 0;
#pragma omp parallel for num_threads(w->threads) reduction(max : fastest)
    for (int i = 0; i < w->count; i++) {
        double speed = qn_norm(qn_velocity_now(w, i));
        fastest = speed <= fastest ? fastest : isfinite(speed) ? speed : (double)INFINITY;
    }
    double moving = (double)f->crowd * qn_max(fastest, fastest * fastest) / QN_SPEED_QUANTUM;
    double solid = 2 * f->side * f->side * f->layer / f->volume_unit;
    double filled = f->filled + qn_max(moving, solid) * 0x1p-62;
    if (!(filled < 1))
        return qn_fail(QN_UNSTABLE,
                       "measure.fields: the sums could overflow at t = %g s with a speed of %g m/s "
                       "after %lld samples; sample less often, or look for what makes particles "
                       "this fast",
                       qn_world_time(w), fastest, (long long)f->samples);
    f->filled = filled;
    return QN_OK;
}

qn_status qn_field_sample(qn_field *f, const qn_world *w)
{
    QN_TRY(make_room(f, w));
    qn_vec3 points[QN_BALL_POINTS];
    ball_points(points);
#pragma omp parallel for num_threads(w->threads)
    for (int i = 0; i < w->count; i++) {
        int klass = w->place[i].klass;
        if (!(w->classes[klass].inverse_mass > 0)) continue;  // a fixed ball is part of the walls
        int64_t weight = f->ball_weight[klass];
        qn_vec3 centre = qn_world_position(w, i);
        if (qn_body_of(w, i) < 0)
            add_at(f, w, centre, weight * QN_BALL_POINTS, qn_velocity_now(w, i));
        spread(f, w->period, centre, w->classes[klass].radius, weight, points);
    }
#pragma omp parallel for num_threads(w->threads)
    for (int k = 0; k < w->body_count; k++) {
        const qn_body *b = &w->bodies[k];
        const qn_grain *g = &w->grains[b->grain];
        int64_t volume = 0;
        if (!(g->inverse_mass > 0)) continue;
        for (int m = 0; m < g->count; m++) volume += f->ball_weight[g->klass[m]] * QN_BALL_POINTS;
        add_at(f, w, qn_body_position(w, b), volume, qn_body_velocity_now(w, b));
    }
    if (f->samples == 0) f->first_step = w->step;
    f->last_step = w->step;
    f->samples++;
    return QN_OK;
}

double qn_field_unit(const qn_field *f, qn_field_sum sum)
{
    if (sum == QN_FIELD_count) return 1;
    bool is_volume = sum == QN_FIELD_centre_volume || sum == QN_FIELD_solid_volume;
    return is_volume ? f->volume_unit : QN_SPEED_QUANTUM;
}

static double total(const qn_field *f, qn_field_sum sum, int64_t voxel)
{
    return (double)f->sum[sum][voxel] * qn_field_unit(f, sum);
}

static double variance(const qn_field *f, qn_field_sum squares, double mean, int64_t voxel)
{
    double n = (double)f->sum[QN_FIELD_count][voxel];
    return qn_max(0, total(f, squares, voxel) / n - mean * mean);
}

qn_voxel qn_field_voxel(const qn_field *f, int64_t voxel)
{
    double whole = f->side * f->side * f->layer, open = f->open_volume[voxel];
    double n = (double)f->sum[QN_FIELD_count][voxel], samples = (double)f->samples;
    qn_voxel m = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    if (f->samples > 0 && open > QN_OPEN_LEAST * whole) {
        m.solidity = total(f, QN_FIELD_solid_volume, voxel) / (samples * open);
        m.porosity = 1 - m.solidity;
    }
    if (f->samples > 0 && open > 0)
        m.solidity_raw = total(f, QN_FIELD_centre_volume, voxel) / (samples * whole);
    if (n > 0) {
        m.velocity_x = total(f, QN_FIELD_velocity_sum_x, voxel) / n;
        m.velocity_y = total(f, QN_FIELD_velocity_sum_y, voxel) / n;
        m.velocity_z = total(f, QN_FIELD_velocity_sum_z, voxel) / n;
        m.speed = total(f, QN_FIELD_speed_sum, voxel) / n;
        m.granular_temperature =
            (variance(f, QN_FIELD_velocity_square_sum_x, m.velocity_x, voxel)
             + variance(f, QN_FIELD_velocity_square_sum_y, m.velocity_y, voxel)
             + variance(f, QN_FIELD_velocity_square_sum_z, m.velocity_z, voxel))
            / 3;
    }
    return m;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Whether a voxel's farthest corner lies within the drum's circle; the grid is as wide as it is.
static bool is_whole(const qn_field *f, double radius, int64_t voxel)
{
    int ix = (int)(voxel % f->nx), iy = (int)(voxel / f->nx % f->ny);
    double x = f->x0 + ix * f->side, y = f->y0 + iy * f->side;
    return hypot(qn_max(fabs(x), fabs(x + f->side)), qn_max(fabs(y), fabs(y + f->side))) <= radius;
}

qn_status qn_field_bulk_solidity(const qn_field *f, double *bulk)
{
    double *values;
    int64_t n = 0, voxels = qn_field_voxel_count(f);
    QN_TRY(QN_ALLOCATE(values, voxels));
    for (int64_t v = 0; v < voxels; v++) {
        double solidity = is_whole(f, f->radius, v) ? qn_field_voxel(f, v).solidity : (double)NAN;
        if (solidity > 0.4) values[n++] = solidity;
    }
    qsort(values, (size_t)n, sizeof *values, by_value);
    *bulk = n > 0 ? 0.5 * (values[(n - 1) / 2] + values[n / 2]) : (double)NAN;
    free(values);
    return QN_OK;
}

int qn_field_columns(qn_field *f, qn_column *columns, int room)
{
    int64_t voxels = qn_field_voxel_count(f);
    const qn_column all[QN_FIELD_COLUMN_COUNT] = {
#define F(name, unit, meaning) \
    {#name, "quanta", meaning, QN_INT64, 1, voxels, f->sum[QN_FIELD_##name]},
        QN_FIELD_SUMS(F)
#undef F
            {"samples", "1", "samples taken", QN_INT64, 1, 1, &f->samples},
        {"first_step", "1", "step of the first sample", QN_INT64, 1, 1, &f->first_step},
        {"last_step", "1", "step of the latest sample", QN_INT64, 1, 1, &f->last_step},
        {"filled", "1", "share of the sums' range used at most", QN_DOUBLE, 1, 1, &f->filled},
    };
    for (int i = 0; i < QN_FIELD_COLUMN_COUNT && i < room; i++) columns[i] = all[i];
    return QN_FIELD_COLUMN_COUNT;
}
