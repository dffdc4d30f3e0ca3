// SPDX-License-Identifier: Apache-2.0
#include "scene/forecast.h"

#include "world/classes.h"

#include <stdlib.h>

double qn_forecast_seconds(const qn_world *w, qn_span span)
{
    if (span.unit == QN_STEPS) return span.value * w->dt;
    if (span.unit == QN_SECONDS) return span.value;
    return qn_drum_time(&w->def.drum, 2 * QN_PI * span.value);
}

/// Rows, samples or frames in the whole run.
static double occasions(const qn_world *w, double end, qn_span every)
{
    double t = qn_forecast_seconds(w, every);
    return t > 0 && isfinite(t) ? end / t : 0;
}

/// What a run keeps in memory: the records of each particle, its share of pairs with their history, and
/// images beyond periodic ends.
static double memory_of(const qn_world *w)
{
    const double pairs = 8, images = 1.2;
    double records = sizeof(qn_place) + sizeof(qn_motion) + sizeof(qn_load) + sizeof(int64_t);
    double lists = pairs * (2 * sizeof(int32_t) + sizeof(qn_contact));
    return (double)w->count * images * (records + lists);
}

/// What a run leaves on disk: frames, kept checkpoints, the time series and the fields.
static double disk_of(const qn_world *w, double end)
{
    const double frame = 44, checkpoint = 400, row = 1000;  // bytes, per particle or row
    const qn_output_def *o = &w->def.output;
    const qn_measure_def *m = &w->def.measure;
    double bytes = (double)w->count
                   * (frame * occasions(w, end, o->frames_every) + checkpoint * o->checkpoint_keep);
    bytes += row * occasions(w, end, m->series_every);
    for (int i = 0; i < m->grid_count; i++) {
        double n = w->def.drum.diameter / (m->grid_cell[i] * w->largest_radius);
        bytes += 120 * n * n * m->grid_layers[i];
    }
    return bytes;
}

qn_status qn_forecast_timestep(const qn_def *def, qn_timestep *timestep)
{
    qn_class *classes;
    int count;
    QN_TRY(qn_classes_build(def, &classes, &count));
    *timestep = qn_timestep_of(def, classes, count);
    free(classes);
    return QN_OK;
}

qn_forecast qn_forecast_of(const qn_world *w, const qn_timestep *timestep)
{
    const qn_drum_def *drum = &w->def.drum;
    qn_forecast f = {.particles = w->count, .dt = w->dt, .timestep = *timestep};
    double solid = 0;  // m3
    for (int i = 0; i < w->count; i++) {
        const qn_class *c = &w->classes[w->place[i].klass];
        f.mass += c->mass;
        solid += c->mass / w->def.materials[c->material].density;
    }
    f.end = qn_forecast_seconds(w, w->def.end);
    f.steps = isfinite(f.end) ? (int64_t)floor(f.end / w->dt + 0.5) : 0;
    if (drum->present) {
        f.critical_speed = sqrt(2 * qn_norm(w->gravity) / drum->diameter);
        f.speed = drum->legs[drum->leg_count - 1].to;
        f.revolutions = isfinite(f.end) ? qn_drum_angle(drum, f.end) / (2 * QN_PI) : 0;
        f.filling = solid / w->def.bed_solidity / qn_walls_volume(&w->walls);
    }
    f.wall_time = (double)f.steps * (double)w->count / (QN_FORECAST_RATE * w->threads);
    f.memory = memory_of(w);
    f.disk = disk_of(w, f.end);
    return f;
}

static bool are(int a, int b, const qn_contact_def *c)
{
    return (a == c->material_a && b == c->material_b) || (a == c->material_b && b == c->material_a);
}

qn_forecast_pair qn_forecast_pair_of(const qn_world *w, const qn_contact_def *contact)
{
    qn_forecast_pair p = {.is_used = false};
    for (int a = 0; a < w->class_count; a++)
        for (int b = 0; b < w->class_count; b++) {
            const qn_class *ca = &w->classes[a], *cb = &w->classes[b];
            bool moves = ca->inverse_mass > 0 || cb->inverse_mass > 0;
            const qn_pair *pair = &w->pairs[a * w->class_count + b];
            bool meet = moves && pair->normal_stiffness > 0;
            if (p.is_used || !meet || !are(ca->material, cb->material, contact)) continue;
            p.is_used = true;
            p.sides = qn_sides_of_classes(&w->def, contact, ca, cb, w->dt);
            p.pair = *pair;
        }
    for (int a = 0; a < w->class_count; a++)
        for (int k = 0; k < w->surface_count; k++) {
            const qn_class *ca = &w->classes[a];
            const qn_surface *surface = &w->walls.surfaces[k];
            bool moves = ca->inverse_mass > 0;
            if (p.is_used || !moves || !are(ca->material, surface->material, contact)) continue;
            p.is_used = p.is_wall = true;
            p.sides = qn_sides_of_wall(&w->def, contact, ca, surface, w->dt);
            p.pair = w->wall_pairs[k * w->class_count + a];
        }
    return p;
}
