// SPDX-License-Identifier: Apache-2.0
#include "cli/warnings.h"

#include "scene/scene.h"
#include "world/classes.h"
#include "world/flow.h"
#include "world/timestep.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define LEAST_STEPS 10.0   // 1   steps in a contact: below it, a warning
#define DASHPOT_WARN 0.25  // 1   qn_forecast_dashpot(): above it, a warning

static void __attribute__((format(printf, 3, 4)))
add(char *text, size_t room, const char *format, ...)
{
    size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, room - used, format, args);
    va_end(args);
}

static void warn_of_dashpots(const qn_world *w, const qn_forecast *f, char *text, size_t room)
{
    for (int i = 0; i < w->def.contact_count; i++) {
        const qn_contact_def *c = &w->def.contacts[i];
        qn_forecast_pair p = qn_forecast_pair_of(w, c);
        double stiff = p.is_used ? qn_forecast_dashpot(f, c, &p) : 0;
        if (stiff <= DASHPOT_WARN) continue;
        add(text, room,
            "warning: contacts.%s-%s.restitution = %g makes a dashpot that is too stiff for the "
            "time "
            "step (%.2g; up to %g is good): the energy balance will be off by %s; use a larger "
            "restitution, or time.step: %.2g us\n",
            w->def.materials[c->material_a].name, w->def.materials[c->material_b].name,
            c->restitution, stiff, DASHPOT_WARN,
            stiff > 1 ? "a lot, and the bed may explode" : "several percent",
            0.95e6 * f->dt * DASHPOT_WARN / stiff);
    }
}

/// Traced particles that there are none of; more may come where there are feeds.
static void warn_of_traces(const qn_world *w, char *text, size_t room)
{
    int64_t last = w->flow ? w->flow->next_id - 1 : w->count;
    for (int i = 0; i < w->def.measure.traced_count && w->def.feed_count == 0; i++)
        if (w->def.measure.traced[i] > last)
            add(text, room,
                "warning: measure.traces.ids: there is no particle %lld; the last is %lld\n",
                (long long)w->def.measure.traced[i], (long long)last);
}

/// What is odd about the meshes: most of it is mended or meant, but should be known.
static void add_flaws(const qn_world *w, char *text, size_t room)
{
    char flaw[512];
    for (int m = 0; m < w->walls.mesh_count; m++)
        for (int k = 0; k < QN_MESH_FLAW_COUNT; k++) {
            qn_mesh_flaw_text(&w->walls.meshes[m], k, 1e-3, "mm", flaw, sizeof flaw);
            if (*flaw) add(text, room, "note: %s\n", flaw);
        }
}

/// Soft materials and a drum so fast that its charge does not tumble.
static void warn_of_motion(const qn_world *w, const qn_forecast *f, char *text, size_t room)
{
    double overlap = f->timestep.largest_overlap, speed = fabs(f->speed) / f->critical_speed;
    if (overlap > QN_OVERLAP_STOP)
        add(text, room,
            "warning: the hardest impact to expect, %.3g m/s, goes %.3g %% of the radius deep; "
            "above "
            "%g %% the run stops: use a larger young\n",
            f->timestep.impact_speed, 100 * overlap, 100 * QN_OVERLAP_STOP);
    if (w->def.drum.present && f->critical_speed > 0 && speed > 1)
        add(text, room,
            "warning: the drum turns at %.4g %%critical: above 100 its charge clings to the "
            "shell\n",
            100 * speed);
}

static void warn(const qn_world *w, const qn_forecast *f, char *text, size_t room)
{
    double fraction = f->dt / f->timestep.rayleigh, steps = f->timestep.contact / f->dt;
    if (fraction > QN_RAYLEIGH_WARN)
        add(text, room,
            "warning: the time step is %.2f of the Rayleigh time; up to %.1f is usual, above %.0f "
            "is refused\n",
            fraction, QN_RAYLEIGH_WARN, QN_RAYLEIGH_REFUSE);
    if (steps < LEAST_STEPS)
        add(text, room, "warning: the hardest impact has but %.1f time steps; 20 to 40 are usual\n",
            steps);
    warn_of_dashpots(w, f, text, room);
    warn_of_motion(w, f, text, room);
    if (w->def.scheme == QN_SCHEME_EULER)
        add(text, room,
            "warning: numerics.scheme = forward-euler makes energy in every contact (some 15 %% of "
            "the "
            "speed at 40 steps); it is there to show that\n");
    if (!isfinite(f->end))
        add(text, room, "warning: the drum never makes the turns that time.end asks for\n");
    if (w->def.measure.grid_count == 0) return;
    if (!(f->fields_start < f->end))
        add(text, room,
            "warning: measure.fields starts at %.4g s, after the end of the run (%.4g s)\n",
            f->fields_start, f->end);
    else if (f->fields_end > f->end + 2 * f->dt)
        add(text, room,
            "warning: measure.fields lasts until %.4g s, but the run ends at %.4g s: fields and "
            "power "
            "are of a part of it\n",
            f->fields_end, f->end);
}

const char *cli_warnings(const qn_world *w, const qn_forecast *f, char *text, size_t room)
{
    text[0] = 0;
    warn(w, f, text, room);
    warn_of_traces(w, text, room);
    add_flaws(w, text, room);
    return text;
}

qn_status cli_blame(const char *path, const char *text, qn_status status)
{
    qn_messages messages = {0};
    char sentence[2048];
    snprintf(sentence, sizeof sentence, "%s", qn_error());
    qn_scene_blame(path, text, sentence, &messages);
    fprintf(stderr, "%s", messages.text ? messages.text : sentence);
    qn_messages_free(&messages);
    return status;
}
