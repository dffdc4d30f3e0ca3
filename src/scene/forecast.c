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

qn_status qn_forecast_timestep(const qn_def *def, qn_timestep *timestep)
{
    qn_class *classes;
    int count;
    QN_TRY(qn_classes_build(def, &classes, &count));
    *timestep = qn_timestep_of(def, classes, count);
    free(classes);
    return QN_OK;
}

/// Time (s) at which a span that begins at `start` (s) is over.
static double after(const qn_world *w, double start, qn_span span)
{
    const qn_drum_def *drum = &w->def.drum;
    if (span.unit != QN_REVOLUTIONS || !drum->present || !isfinite(start))
        return start + qn_forecast_seconds(w, span);
    double sense = qn_drum_sense(drum);
    return qn_drum_time(drum, sense * qn_drum_angle(drum, start) + 2 * QN_PI * span.value);
}

// The damping ratio of a pair's dashpot, of Hunt and Crossley's that of a viscous one with the restitution
// it has at the forecast impact.
static double dashpot_ratio(const qn_forecast *f, const qn_contact_def *c,
                            const qn_forecast_pair *p)
{
    if (c->law.damping == QN_DAMPING_NONE) return 0;
    if (c->law.damping != QN_DAMPING_HUNT_CROSSLEY) return qn_sides_damping_ratio(&p->sides);
    qn_sides hardest = p->sides;
    double x = qn_hunt_crossley_number(c->restitution) / c->impact_speed;
    hardest.restitution = qn_max(qn_hunt_crossley_restitution(x * f->timestep.impact_speed), 1e-6);
    return qn_sides_damping_ratio(&hardest);
}

double qn_forecast_dashpot(const qn_forecast *f, const qn_contact_def *c, const qn_forecast_pair *p)
{
    double zeta = dashpot_ratio(f, c, p);
    double time = qn_contact_time(c, &p->sides, f->timestep.impact_speed, NULL);
    return 2 * QN_PI * zeta * f->dt / time;
}

qn_forecast qn_forecast_of(const qn_world *w, const qn_timestep *timestep)
{
    const qn_drum_def *drum = &w->def.drum;
    qn_forecast f = {.particles = qn_world_particles(w),
                     .spheres = w->count,
                     .dt = w->dt,
                     .timestep = *timestep};
    double solid = 0;  // m3
    for (int i = 0; i < w->count; i++) {
        const qn_class *c = &w->classes[w->place[i].klass];
        f.mass += c->volume * w->def.materials[c->material].density;
        if (c->inverse_mass > 0) solid += c->volume;
    }
    f.end = qn_forecast_seconds(w, w->def.end);
    f.steps = isfinite(f.end) ? (int64_t)floor(f.end / w->dt + 0.5) : 0;
    if (drum->present) {
        f.critical_speed = sqrt(2 * qn_norm(w->gravity) / drum->diameter);
        f.speed = drum->legs[drum->leg_count - 1].to;
        f.revolutions = isfinite(f.end) ? qn_drum_angle(drum, f.end) / (2 * QN_PI) : 0;
        f.filling = solid / w->def.bed_solidity / qn_walls_volume(&w->walls);
    }
    f.fields_start = w->def.measure.grid_count > 0
                         ? qn_forecast_seconds(w, w->def.measure.fields_start)
                         : (double)INFINITY;
    f.fields_end = after(w, f.fields_start, w->def.measure.fields_duration);
    qn_forecast_costs(w, &f);
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
