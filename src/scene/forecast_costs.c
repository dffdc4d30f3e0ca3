// SPDX-License-Identifier: Apache-2.0
// What a run will cost: wall time, memory, disk.
//
// Sizes are those of the files that runs of this version leave, of 1 to 8625 particles; most are met
// within 30 %. What is at rest, or zero, is compressed to less; a single ball that is traced while it
// rolls along a wall takes twice as much. Feeds count with all they are asked for, outlets with nothing.
#include "scene/forecast.h"
#include "world/flow.h"

enum { BED = 100 };  // particles from which on a scene is a bed, with contacts all the time

/// Rows, samples or frames in the whole run.
static double occasions(const qn_world *w, double end, qn_span every)
{
    double t = qn_forecast_seconds(w, every);
    return t > 0 && isfinite(t) && isfinite(end) ? 1 + floor(end / t) : 0;
}

/// Spheres there are on average, feeds giving all the time.
static double mean_count(const qn_world *w)
{
    return 0.5 * ((double)w->count + (double)qn_flow_most(w));
}

/// What a run keeps in memory: the program itself, the records of each particle, its share of pairs with
/// their history, and images beyond periodic ends.
static double memory_of(const qn_world *w)
{
    const double program = 15e6, pairs = 8, images = 1.2;
    double records = sizeof(qn_place) + sizeof(qn_motion) + sizeof(qn_load) + sizeof(int64_t);
    double lists = pairs * (2 * sizeof(int32_t) + sizeof(qn_contact));
    return program + (double)qn_flow_most(w) * images * (records + lists)
           + (double)w->body_count * sizeof(qn_body);
}

/// Bytes of a frame with the liner of its moment.
static double frame_size(const qn_world *w)
{
    double triangles = 0;
    for (int i = 0; i < w->walls.mesh_count; i++) triangles += w->walls.meshes[i].triangle_count;
    double liner = w->walls.has_drum || triangles > 0 ? 16e3 + 40 * triangles : 0;
    return 25e3 + 36 * mean_count(w) + liner
           + 160;  // and a line in each of the two lists of frames
}

static double voxels_of(const qn_world *w)
{
    const qn_measure_def *m = &w->def.measure;
    double voxels = 0;
    for (int i = 0; i < m->grid_count; i++) {
        double n = w->def.drum.diameter / (m->grid_cell[i] * w->largest_radius);
        voxels += n * n * m->grid_layers[i];
    }
    return voxels;
}

/// Bytes of the checkpoints that are there in the end.
static double checkpoints_size(const qn_world *w, double wall_time)
{
    const qn_output_def *o = &w->def.output;
    double voxels = voxels_of(w), kept = o->checkpoint_keep, most = (double)qn_flow_most(w);
    if (o->checkpoint_every > 0) kept = qn_min(kept, 1 + floor(wall_time / o->checkpoint_every));
    return kept * (45e3 + (voxels > 0 ? 15e3 : 0) + 80 * voxels + (most < BED ? 150 : 195) * most);
}

/// Bytes of the time series and the traces.
static double rows_size(const qn_world *w, double end)
{
    const qn_measure_def *m = &w->def.measure;
    bool is_bed = qn_flow_most(w) >= BED;
    double columns = 28 + 3.0 * w->walls.part_count, rows = occasions(w, end, m->series_every);
    double series = columns * (600 + rows * (is_bed ? 16.5 + 6.5 : 7.6 + 3.5));
    double traced = m->traced_count * occasions(w, end, m->traces_every);
    return series + traced * (is_bed ? 260 + 3.5 * 360 : 95);
}

static double pictures_size(const qn_world *w, bool has_fields)
{
    if (!w->def.output.pictures) return 0;
    double grids = has_fields ? w->def.measure.grid_count : 0;
    return 0.6e6 + 0.7e6 * grids + (w->def.measure.traced_count > 0 ? 0.9e6 : 0);
}

/// What a run leaves on disk.
static double disk_of(const qn_world *w, const qn_forecast *f)
{
    bool has_fields = f->fields_start < f->end;
    double bytes = 6e3;  // scene, log, summary
    bytes += frame_size(w) * occasions(w, f->end, w->def.output.frames_every);
    bytes += checkpoints_size(w, f->wall_time) + rows_size(w, f->end);
    if (has_fields) bytes += 60e3 + 93 * voxels_of(w);
    return bytes + pictures_size(w, has_fields);
}

void qn_forecast_costs(const qn_world *w, qn_forecast *f)
{
    const double begin = 0.05, step = 3e-6;  // s   of a run, and of a step beside its particles
    f->wall_time =
        begin + (double)f->steps * (step + mean_count(w) / (QN_FORECAST_RATE * w->threads));
    f->memory = memory_of(w);
    f->disk = disk_of(w, f);
}
