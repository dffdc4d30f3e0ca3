// SPDX-License-Identifier: Apache-2.0
// Time, measurements, output and numerics.
#include "scene/build.h"

#include <stdio.h>
#include <string.h>

qn_span qn_span_of(const qn_value *v)
{
    qn_span_unit unit = v->dimension == QN_DIMENSION_REVOLUTIONS ? QN_REVOLUTIONS
                        : v->dimension == QN_DIMENSION_STEPS     ? QN_STEPS
                                                                 : QN_SECONDS;
    return (qn_span){v->number, unit};
}

/// A span that must be one the drum can give: turns only where it turns, whole steps only.
static qn_span span(qn_reader *r, const qn_value *v)
{
    const qn_drum_def *d = &r->def->drum;
    bool turns = false;
    for (int i = 0; i < d->leg_count; i++)
        turns = turns || d->legs[i].from != 0 || d->legs[i].to != 0;
    if (!v->set) return (qn_span){0, QN_SECONDS};
    if (v->dimension == QN_DIMENSION_REVOLUTIONS && !turns)
        qn_complain(r, v, "counts turns of the drum, but %s; use s",
                    d->present ? "the drum does not turn" : "there is no drum");
    if (v->dimension == QN_DIMENSION_STEPS && v->number != floor(v->number))
        qn_complain(r, v, "is not a whole number of steps");
    return qn_span_of(v);
}

void qn_build_times(qn_reader *r, const qn_scene_keys *scene)
{
    qn_time_keys k;
    if (!scene->time.set) return;
    qn_section_read(r, QN_SECTION_TIME, qn_section_under(r, &scene->time), &k);
    r->def->end = span(r, &k.end);
    r->def->step = k.step.number;
    r->def->rayleigh_fraction = k.rayleigh_fraction.number;
}

static void read_fields(qn_reader *r, const qn_value *fields)
{
    qn_measure_def *m = &r->def->measure;
    qn_fields_keys k;
    qn_section_from from = qn_section_under(r, fields);
    qn_section_read(r, QN_SECTION_FIELDS, from, &k);
    if (!r->def->drum.present) {
        qn_complain_at(r, from.mark,
                       "measure.fields needs a drum: its voxels cover the cross-section");
        return;
    }
    m->fields_every = span(r, &k.every);
    m->fields_start = span(r, &k.start);
    m->fields_duration = span(r, &k.duration);
    if (k.cells.count > QN_GRIDS_MAX)
        qn_complain(r, &k.cells, "has more than %d grids", QN_GRIDS_MAX);
    else if (k.cells.set && k.layers.set && k.layers.count != 1 && k.layers.count != k.cells.count)
        qn_complain(r, &k.layers, "has %d numbers; give one, or one for each of the %d cells",
                    k.layers.count, k.cells.count);
    else if (k.cells.set && k.layers.set) {
        m->grid_count = k.cells.count;
        for (int i = 0; i < m->grid_count; i++) {
            double layers = k.layers.numbers[k.layers.count > 1 ? i : 0];
            m->grid_cell[i] = k.cells.numbers[i];
            m->grid_layers[i] = (int)layers;
            if (layers != floor(layers)) {
                qn_complain(r, &k.layers, "must be whole numbers");
                return;
            }
        }
    }
}

static void read_traces(qn_reader *r, const qn_value *traces)
{
    qn_measure_def *m = &r->def->measure;
    qn_traces_keys k;
    qn_section_read(r, QN_SECTION_TRACES, qn_section_under(r, traces), &k);
    m->traces_every = span(r, &k.every);
    for (int i = 0; k.ids.set && i < k.ids.count; i++) {
        m->traced[i] = (int64_t)k.ids.numbers[i];
        if (k.ids.numbers[i] != floor(k.ids.numbers[i])) {
            qn_complain(r, &k.ids, "must be whole numbers");
            return;
        }
        for (int j = 0; j < i; j++)
            if (m->traced[j] == m->traced[i]) {
                qn_complain(r, &k.ids, "names particle %lld twice", (long long)m->traced[i]);
                return;
            }
    }
    m->traced_count = k.ids.count;
}

void qn_build_measure(qn_reader *r, const qn_scene_keys *scene)
{
    qn_measure_keys k;
    qn_section_read(r, QN_SECTION_MEASURE, qn_section_under(r, &scene->measure), &k);
    r->def->measure.series_every = span(r, &k.series);
    if (k.fields.set && k.fields.node) read_fields(r, &k.fields);
    if (k.traces.set && k.traces.node) read_traces(r, &k.traces);
}

/// The scene's file name without folder and ending.
static void stem_of(const char *name, char *stem, size_t size)
{
    const char *slash = strrchr(name, '/');
    const char *base = slash ? slash + 1 : name;
    const char *dot = strrchr(base, '.');
    int length = dot && dot > base ? (int)(dot - base) : (int)strlen(base);
    snprintf(stem, size, "%.*s", length, base);
}

static void read_numerics(qn_reader *r, const qn_value *numerics)
{
    qn_numerics_keys k;
    qn_section_read(r, QN_SECTION_NUMERICS, qn_section_under(r, numerics), &k);
    r->def->scheme = (qn_scheme)(k.scheme.set ? k.scheme.choice : QN_SCHEME_LEAPFROG);
    r->def->skin = k.skin.number;
    r->def->bed_solidity = k.bed_solidity.number;
}

void qn_build_output(qn_reader *r, const qn_scene_keys *scene)
{
    qn_output_def *o = &r->def->output;
    qn_output_keys k;
    qn_section_read(r, QN_SECTION_OUTPUT, qn_section_under(r, &scene->output), &k);
    char stem[256];
    stem_of(r->source.name, stem, sizeof stem);
    if (k.directory.set && strlen(k.directory.text) >= sizeof o->directory - 64)
        qn_complain(r, &k.directory, "is longer than %d letters", QN_PATH_MAX - 65);
    else if (k.directory.set)
        snprintf(o->directory, sizeof o->directory, "%s", k.directory.text);
    else
        snprintf(o->directory, sizeof o->directory, "out/%s", stem);
    o->frames_every = k.frames.is_word ? (qn_span){0, QN_SECONDS} : span(r, &k.frames);
    o->checkpoint_every = k.checkpoint.number;
    o->checkpoint_keep = (int)k.keep.number;
    o->pictures = k.pictures.choice == 1;
    read_numerics(r, &scene->numerics);
}
