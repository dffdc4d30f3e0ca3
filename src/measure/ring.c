// SPDX-License-Identifier: Apache-2.0
#include "measure/ring.h"
#include "measure/open.h"

#include <stdlib.h>
#include <string.h>

enum { SMOOTH = 2 };  // bins averaged on each side when looking for an edge

static const double DEGREE = QN_PI / 180;  // rad
static const double HALF_BED = 0.3;        // 1   half the solidity of a bed

qn_status qn_ring_create(const qn_world *w, qn_ring *ring)
{
    memset(ring, 0, sizeof *ring);
    qn_open *open;
    QN_TRY(QN_ALLOCATE(open, 1));
    qn_open_build(&w->walls, open);
    double height =
        w->walls.has_profile_file ? open->radius - open->clear : w->walls.drum.lifter_height;
    ring->inner_radius = qn_max(0, open->radius - height - 4 * w->largest_radius);
    ring->open_volume =
        qn_open_ring(open, ring->inner_radius) * w->walls.drum.length / QN_RING_BINS;
    free(open);
    bool has_down = hypot(w->gravity.x, w->gravity.y) > 0;
    ring->down = has_down ? atan2(w->gravity.y, w->gravity.x) : -QN_PI / 2;
    ring->sense = (int)qn_drum_sense(&w->walls.drum);
    ring->volume_unit = qn_volume_quantum(w, ring->open_volume, 1);
    QN_TRY(QN_ALLOCATE(ring->weight, w->class_count));
    for (int c = 0; c < w->class_count; c++)
        ring->weight[c] = llrint(w->classes[c].volume / ring->volume_unit);
    return QN_OK;
}

void qn_ring_free(qn_ring *ring)
{
    free(ring->weight);
    memset(ring, 0, sizeof *ring);
}

static int bin_of(const qn_ring *ring, double x, double y)
{
    double degrees = ring->sense * (atan2(y, x) - ring->down) / DEGREE + 180;
    degrees -= floor(degrees / 360) * 360;
    int bin = (int)degrees;
    return bin < QN_RING_BINS ? bin : 0;
}

void qn_ring_sample(qn_ring *ring, const qn_world *w)
{
    for (int i = 0; i < w->count; i++) {
        double x = w->place[i].x, y = w->place[i].y;
        if (!(w->classes[w->place[i].klass].inverse_mass > 0)) continue;  // part of the walls
        if (x * x + y * y < ring->inner_radius * ring->inner_radius) continue;
        ring->sum[bin_of(ring, x, y)] += ring->weight[w->place[i].klass];
    }
    ring->samples++;
}

double qn_ring_angle(int bin)
{
    return bin + 0.5 - QN_RING_BINS / 2;
}

double qn_ring_solidity(const qn_ring *ring, int bin)
{
    if (ring->samples == 0) return NAN;
    return (double)ring->sum[bin] * ring->volume_unit / ((double)ring->samples * ring->open_volume);
}

static int wrap(int bin)
{
    return (bin % QN_RING_BINS + QN_RING_BINS) % QN_RING_BINS;
}

static double smoothed(const qn_ring *ring, int bin)
{
    double sum = 0;
    for (int k = -SMOOTH; k <= SMOOTH; k++) sum += qn_ring_solidity(ring, wrap(bin + k));
    return sum / (2 * SMOOTH + 1);
}

// Bin in which the direction of the mean of all mass lies.
static int middle(const qn_ring *ring)
{
    double x = 0, y = 0;
    for (int b = 0; b < QN_RING_BINS; b++) {
        x += (double)ring->sum[b] * cos(qn_ring_angle(b) * DEGREE);
        y += (double)ring->sum[b] * sin(qn_ring_angle(b) * DEGREE);
    }
    return wrap((int)floor(atan2(y, x) / DEGREE) + QN_RING_BINS / 2);
}

static double edge(const qn_ring *ring, int from, int way, double half)
{
    double here = smoothed(ring, from);
    if (!(here >= half)) return NAN;
    for (int k = 1; k < QN_RING_BINS; k++) {
        double next = smoothed(ring, wrap(from + way * k));
        if (next < half) {
            double angle = qn_ring_angle(from) + way * (k - 1 + (here - half) / (here - next));
            return angle - 360 * floor((angle + 180) / 360);
        }
        here = next;
    }
    return NAN;
}

void qn_ring_edges(const qn_ring *ring, double bulk, double *shoulder, double *toe)
{
    *shoulder = *toe = NAN;
    if (ring->samples == 0) return;
    int from = middle(ring);
    *shoulder = edge(ring, from, 1, 0.5 * bulk);
    *toe = edge(ring, from, -1, 0.5 * bulk);
}

int64_t qn_ring_least_samples(const qn_ring *ring, const qn_world *w)
{
    double solid = HALF_BED * (2 * SMOOTH + 1) * ring->open_volume;
    double balls = solid / qn_ball_volume(w->largest_radius);  // at an edge, in one sample
    return (int64_t)ceil(qn_min(QN_RING_VISITS / balls, 1e9));
}

int qn_ring_columns(qn_ring *ring, qn_column *columns, int room)
{
    const qn_column all[] = {
        {"ring_sum", "quanta", "volume of balls centred in the ring, by degree", QN_INT64, 1,
         QN_RING_BINS, ring->sum},
        {"ring_samples", "1", "samples taken of the ring", QN_INT64, 1, 1, &ring->samples},
    };
    int count = (int)(sizeof all / sizeof *all);
    for (int i = 0; i < count && i < room; i++) columns[i] = all[i];
    return count;
}
