// SPDX-License-Identifier: Apache-2.0
// A definition as the text of a scene: every key, in SI units, with 17 digits.
#include "base/hash.h"
#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *yes(bool b)
{
    return b ? "yes" : "no";
}

#define S(NAME, name, text, meaning) text,
static const char *const schemes[] = {QN_SCHEMES(S)};
#undef S

static void write_vector(FILE *out, const char *key, qn_vec3 v, const char *unit)
{
    fprintf(out, "%s: %.17g %.17g %.17g%s%s", key, v.x, v.y, v.z, *unit ? " " : "", unit);
}

static void write_span(FILE *out, const char *key, qn_span s)
{
    static const char *const units[] = {"s", "rev", "steps"};
    fprintf(out, "%s: %.17g %s", key, s.value, units[s.unit]);
}

static void write_number(FILE *out, const char *key, double x, const char *unit)
{
    bool pure = !strcmp(unit, "1");
    fprintf(out, ", %s: %.17g%s%s", key, x, pure ? "" : " ", pure ? "" : unit);
}

/// A text between double quotes.
static void write_quoted(FILE *out, const char *key, const char *text)
{
    fprintf(out, "%s: \"", key);
    for (const char *p = text; *p; p++) {
        if (*p == '"' || *p == '\\') fputc('\\', out);
        if (*p == '\n')
            fputs("\\n", out);
        else
            fputc(*p, out);
    }
    fputs("\"\n", out);
}

static uint64_t hash_numbers(uint64_t hash, const double *x, int64_t count)
{
    return x ? qn_hash(hash, x, (size_t)count * sizeof *x) : hash;
}

/// What came from a file: how many of what, and a hash of it, so that a changed file shows.
static void write_contents(FILE *out, int count, const char *what, uint64_t hash)
{
    fprintf(out, "(%d %s from a file, hash %016llx)", count, what, (unsigned long long)hash);
}

static void write_head(FILE *out, const qn_def *def)
{
    fprintf(out,
            "# The scene as it was understood: every key, in SI units.\nformat: quern-scene/1\n");
    if (*def->title) write_quoted(out, "title", def->title);
    write_vector(out, "gravity", def->gravity, "m/s2");
    fprintf(out, "\nseed: %llu\ntime: {", (unsigned long long)def->seed);
    write_span(out, "end", def->end);
    if (def->step > 0)
        fprintf(out, ", step: %.17g s", def->step);
    else
        fprintf(out, ", step: auto");
    fprintf(out, ", rayleigh_fraction: %.17g}\n", def->rayleigh_fraction);
}

static void write_materials(FILE *out, const qn_def *def)
{
    fprintf(out, "materials:\n");
    for (int i = 0; i < def->material_count; i++) {
        const qn_material_def *m = &def->materials[i];
        fprintf(out, "  %s: {young: %.17g Pa, poisson: %.17g, density: %.17g kg/m3}\n", m->name,
                m->youngs_modulus, m->poisson_ratio, m->density);
    }
    if (def->contact_count > 0) fprintf(out, "contacts:\n");
    for (int i = 0; i < def->contact_count; i++) {
        const qn_contact_def *c = &def->contacts[i];
        qn_law law = c->law;
        fprintf(out,
                "  %s-%s: {normal: %s, damping: %s, cohesion: %s, tangential: %s, rolling: %s, "
                "clip: %s",
                def->materials[c->material_a].name, def->materials[c->material_b].name,
                qn_normal_text(law.normal), qn_damping_text(law.damping),
                qn_cohesion_text(law.cohesion), qn_tangential_text(law.tangential),
                qn_rolling_text(law.rolling), yes(c->clip));
// What may be zero is always written, what may not is zero where it was left out.
#define C(name, unit, used, with)                                                       \
    if ((used)                                                                          \
        && (c->name > 0 || &c->name == &c->friction || &c->name == &c->rolling_friction \
            || &c->name == &c->rolling_damping))                                        \
        write_number(out, #name, c->name, unit);
        QN_CONTACT_NUMBERS(C)
#undef C
        fprintf(out, "}\n");
    }
}

static const char *const drive_texts[] = {
#define D(NAME, text, meaning) text,
    QN_DRIVES(D)
#undef D
};

/// Legs of a speed in `unit`, in lines that begin with `indent`.
static void write_legs(FILE *out, const qn_leg *legs, int count, const char *unit,
                       const char *indent)
{
    for (int i = 0; i < count; i++)
        if (isfinite(legs[i].duration))
            fprintf(out, "%s- {duration: %.17g s, from: %.17g %s, to: %.17g %s}\n", indent,
                    legs[i].duration, legs[i].from, unit, legs[i].to, unit);
        else
            fprintf(out, "%s- {at: %.17g %s}\n", indent, legs[i].to, unit);
}

static void write_drive(FILE *out, const qn_drive_def *d)
{
    bool turns = d->kind == QN_DRIVE_ROTATE || d->kind == QN_DRIVE_SWING;
    bool legs = d->kind == QN_DRIVE_ROTATE || d->kind == QN_DRIVE_TRANSLATE;
    if (d->kind == QN_DRIVE_REST || d->kind == QN_DRIVE_DRUM) return;
    fprintf(out, "    motion:\n      kind: %s\n", drive_texts[d->kind]);
    write_vector(out, turns ? "      axis" : "      direction", d->axis, "");
    fprintf(out, "\n");
    if (turns) {
        write_vector(out, "      through", d->through, "m");
        fprintf(out, "\n");
    }
    if (legs) {
        fprintf(out, "      schedule:\n");
        write_legs(out, d->legs, d->leg_count, turns ? "rad/s" : "m/s", "        ");
    } else
        fprintf(out,
                "      amplitude: %.17g %s\n      frequency: %.17g Hz\n      phase: %.17g rad\n"
                "      settle: %.17g s\n",
                d->amplitude, turns ? "rad" : "m", d->frequency, d->phase, d->start);
}

static void write_drum(FILE *out, const qn_def *def)
{
    static const char *const ends[] = {"periodic", "fixed", "turning"};
    const qn_drum_def *d = &def->drum;
    if (!d->present) return;
    fprintf(out, "drum:\n");
    write_quoted(out, "  name", d->name);
    fprintf(out, "  diameter: %.17g m\n  length: %.17g m\n  material: %s\n  ends: %s\n",
            d->diameter, d->length, def->materials[d->material].name, ends[d->ends]);
    if (d->ends != QN_ENDS_PERIODIC)
        fprintf(out, "  end_material: %s\n", def->materials[d->end_material].name);
    fprintf(out, "  corner: %s\n  schedule:\n",
            d->corners == QN_CORNERS_SHARED ? "shared" : "exact");
    write_legs(out, d->legs, d->leg_count, "rad/s", "    ");
    if (d->profile_count > 0) {
        fprintf(out, "  profile: ");
        write_contents(out, d->profile_count, "points",
                       hash_numbers(QN_HASH_START, d->profile, 2 * d->profile_count));
        fprintf(out, "\n");
    } else if (d->lifter_count > 0)
        fprintf(out, "  lifters: {count: %d, height: %.17g m, top: %.17g m, base: %.17g m}\n",
                d->lifter_count, d->lifter_height, d->lifter_top, d->lifter_base);
}

static void write_walls(FILE *out, const qn_def *def)
{
    if (def->plane_count + def->mesh_count > 0) fprintf(out, "walls:\n");
    for (int i = 0; i < def->plane_count; i++) {
        const qn_plane_def *p = &def->planes[i];
        fprintf(out, "  %s:\n    shape: plane\n    material: %s\n", p->name,
                def->materials[p->material].name);
        write_vector(out, "    point", p->point, "m");
        write_vector(out, "\n    normal", p->normal, "");
        fprintf(out, "\n");
        write_drive(out, &p->drive);
    }
    for (int i = 0; i < def->mesh_count; i++) {
        const qn_mesh_def *m = &def->meshes[i];
        uint64_t hash = hash_numbers(QN_HASH_START, m->vertices, 3 * (int64_t)m->vertex_count);
        hash = qn_hash(hash, m->triangles, 3 * (size_t)m->triangle_count * sizeof *m->triangles);
        fprintf(out,
                "  %s:\n    shape: mesh\n    material: %s\n    turning: %s\n    file: ", m->name,
                def->materials[m->material].name, yes(m->drive.kind == QN_DRIVE_DRUM));
        write_contents(out, m->triangle_count, "triangles", hash);
        fprintf(out, "\n");
        write_drive(out, &m->drive);
    }
}

static void write_sizes(FILE *out, const qn_group_def *g)
{
    if (g->size_count == 1) {
        fprintf(out, "    diameter: %.17g m\n", g->diameter[0]);
        return;
    }
    fprintf(out, "    fractions_by: number\n    sizes:\n");
    for (int i = 0; i < g->size_count; i++)
        fprintf(out, "      - {diameter: %.17g m, fraction: %.17g}\n", g->diameter[i],
                g->fraction[i]);
}

static void write_list(FILE *out, const qn_group_def *g)
{
    int64_t n = g->list_count;
    uint64_t hash = hash_numbers(QN_HASH_START, g->list_position, 3 * n);
    hash = hash_numbers(hash, g->list_velocity, 3 * n);
    hash = hash_numbers(hash, g->list_spin, 3 * n);
    for (int64_t i = 0; i < n; i++)
        hash = hash_numbers(hash, &g->diameter[g->list_size ? g->list_size[i] : 0], 1);
    fprintf(out, "    fill: file\n    file: ");
    write_contents(out, g->list_count, "spheres", hash);
    fprintf(out, "\n");
}

static void write_shape(FILE *out, const qn_def *def, const qn_group_def *g)
{
    const qn_shape *s = &def->shapes[g->shape - 1];
    uint64_t hash = hash_numbers(QN_HASH_START, s->centre, 3 * (int64_t)s->count);
    fprintf(out, "    shape: file\n    shape_file: ");
    write_contents(out, s->count, "spheres", hash_numbers(hash, s->radius, s->count));
    if (!g->turned_at_random) write_vector(out, "\n    turned", g->turned, "rad");
    fprintf(out, "\n");
}

static void write_group(FILE *out, const qn_def *def, const qn_group_def *g)
{
    fprintf(out, "  %s:\n    material: %s\n    fixed: %s\n", g->name,
            def->materials[g->material].name, yes(g->fixed));
    if (g->turning) fprintf(out, "    turning: yes\n");
    bool is_one = g->list_count == 1 && !g->list_velocity && !g->list_spin;
    if (g->lining)
        fprintf(out, "    fill: lining\n");
    else if (g->packing == QN_PACK_LIST && is_one) {
        const double *x = g->list_position;
        write_vector(out, "    fill: at\n    at", qn_v3(x[0], x[1], x[2]), "m");
        fprintf(out, "\n");
    } else if (g->packing == QN_PACK_LIST)
        write_list(out, g);
    else if (g->packing == QN_PACK_FEED)
        fprintf(out, "    fill: feed\n    padding: %.17g\n", g->padding);
    else {
        fprintf(out, "    fill: %s\n    ", g->packing == QN_PACK_HCP ? "hcp" : "grid");
        if (g->amount_kind == QN_AMOUNT_COUNT)
            fprintf(out, "count: %.0f\n", g->amount);
        else if (g->amount_kind == QN_AMOUNT_FILLING)
            fprintf(out, "filling: %.17g\n", g->amount);
        else
            fprintf(out, "mass: %.17g kg\n", g->amount);
        fprintf(out, "    padding: %.17g\n    jitter: %.17g\n", g->padding, g->jitter);
    }
    if (g->packing != QN_PACK_LIST || is_one || g->lining) write_sizes(out, g);
    if (g->shape) write_shape(out, def, g);
    write_vector(out, "    velocity", g->velocity, "m/s");
    write_vector(out, "\n    spin", g->spin, "rad/s");
    fprintf(out, "\n");
}

static void write_feed(FILE *out, const qn_def *def, const qn_feed_def *f)
{
    fprintf(out, "  %s:\n    particles: %s\n    rate: %.17g %s\n", f->name,
            def->groups[f->group].name, f->rate, f->by_mass ? "kg/s" : "1/s");
    if (f->is_disc) {
        write_vector(out, "    centre", f->centre, "m");
        fprintf(out, "\n    radius: %.17g m\n", f->radius);
        write_vector(out, "    normal", f->normal, "");
    } else {
        write_vector(out, "    low", f->low, "m");
        write_vector(out, "\n    high", f->high, "m");
    }
    write_vector(out, "\n    velocity", f->velocity, "m/s");
    fprintf(out, "\n    start: %.17g s\n", f->start);
    if (isfinite(f->stop)) fprintf(out, "    stop: %.17g s\n", f->stop);
}

static void write_outlet(FILE *out, const qn_outlet_def *o)
{
    fprintf(out, "  %s:\n", o->name);
    write_vector(out, o->is_box ? "    low" : "    point", o->is_box ? o->low : o->point, "m");
    write_vector(out, o->is_box ? "\n    high" : "\n    normal", o->is_box ? o->high : o->normal,
                 o->is_box ? "m" : "");
    fprintf(out, "\n");
    if (!o->is_box && isfinite(o->radius)) fprintf(out, "    radius: %.17g m\n", o->radius);
    if (!o->is_box && isfinite(o->aperture)) fprintf(out, "    aperture: %.17g m\n", o->aperture);
}

static void write_flow(FILE *out, const qn_def *def)
{
    if (def->feed_count > 0) fprintf(out, "feeds:\n");
    for (int i = 0; i < def->feed_count; i++) write_feed(out, def, &def->feeds[i]);
    if (def->outlet_count > 0) fprintf(out, "outlets:\n");
    for (int i = 0; i < def->outlet_count; i++) write_outlet(out, &def->outlets[i]);
}

static void write_fields(FILE *out, const qn_measure_def *m)
{
    write_span(out, "  fields: {every", m->fields_every);
    write_span(out, ", start", m->fields_start);
    write_span(out, ", duration", m->fields_duration);
    fprintf(out, ", cells:");
    for (int i = 0; i < m->grid_count; i++) fprintf(out, " %.17g", m->grid_cell[i]);
    fprintf(out, ", layers:");
    for (int i = 0; i < m->grid_count; i++) fprintf(out, " %d", m->grid_layers[i]);
    fprintf(out, "}\n");
}

static void write_tail(FILE *out, const qn_def *def)
{
    const qn_measure_def *m = &def->measure;
    const qn_output_def *o = &def->output;
    write_span(out, "measure:\n  series", m->series_every);
    fprintf(out, "\n");
    if (m->grid_count > 0) write_fields(out, m);
    if (m->traced_count > 0) {
        fprintf(out, "  traces: {ids:");
        for (int i = 0; i < m->traced_count; i++) fprintf(out, " %lld", (long long)m->traced[i]);
        write_span(out, ", every", m->traces_every);
        fprintf(out, "}\n");
    }
    fprintf(out, "output:\n");
    write_quoted(out, "  directory", o->directory);
    if (o->frames_every.value > 0)
        write_span(out, "  frames", o->frames_every);
    else
        fprintf(out, "  frames: none");
    fprintf(out, "\n  checkpoint: %.17g s\n  keep: %d\n  pictures: %s\n", o->checkpoint_every,
            o->checkpoint_keep, yes(o->pictures));
    fprintf(out, "numerics: {scheme: %s", schemes[def->scheme]);
    if (def->skin > 0)
        fprintf(out, ", skin: %.17g", def->skin);
    else
        fprintf(out, ", skin: auto");
    fprintf(out, ", bed_solidity: %.17g}\n", def->bed_solidity);
}

qn_status qn_scene_resolved(const qn_def *def, char **text)
{
    size_t size;
    FILE *out = open_memstream(text, &size);
    if (!out) return qn_fail(QN_MEMORY, "no memory for the resolved scene");
    write_head(out, def);
    write_materials(out, def);
    write_drum(out, def);
    write_walls(out, def);
    fprintf(out, "particles:\n");
    for (int i = 0; i < def->group_count; i++) write_group(out, def, &def->groups[i]);
    write_flow(out, def);
    write_tail(out, def);
    if (fclose(out) == 0) return QN_OK;
    free(*text);
    return qn_fail(QN_MEMORY, "no memory for the resolved scene");
}
