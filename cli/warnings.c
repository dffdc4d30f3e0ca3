// SPDX-License-Identifier: Apache-2.0
#include "cli/warnings.h"

#include "scene/scene.h"
#include "world/timestep.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define LEAST_STEPS 10.0  // 1   steps in a contact: below it, a warning

static void __attribute__((format(printf, 3, 4)))
add(char *text, size_t room, const char *format, ...)
{
    size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, room - used, format, args);
    va_end(args);
}

const char *cli_warnings(const qn_world *w, const qn_forecast *f, char *text, size_t room)
{
    const qn_measure_def *m = &w->def.measure;
    double fraction = f->dt / f->timestep.rayleigh, steps = f->timestep.contact / f->dt;
    text[0] = 0;
    if (fraction > QN_RAYLEIGH_WARN)
        add(text, room,
            "warning: the time step is %.2f of the Rayleigh time; up to %.1f is usual, above %.0f "
            "is "
            "refused\n",
            fraction, QN_RAYLEIGH_WARN, QN_RAYLEIGH_REFUSE);
    if (steps < LEAST_STEPS)
        add(text, room, "warning: the hardest impact has but %.1f time steps; 20 to 40 are usual\n",
            steps);
    if (!isfinite(f->end))
        add(text, room, "warning: the drum never makes the turns that time.end asks for\n");
    if (m->grid_count == 0) return text;
    double start = qn_forecast_seconds(w, m->fields_start);
    if (!(start < f->end))
        add(text, room, "warning: measure.fields starts after the end of the run\n");
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
