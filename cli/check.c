// SPDX-License-Identifier: Apache-2.0
// `quern check`: what a scene will do, before a single step is done.
#include "cli/cli.h"
#include "cli/flow.h"
#include "cli/sizes.h"
#include "cli/warnings.h"

#include "record/json.h"
#include "scene/forecast.h"
#include "scene/scene.h"
#include "world/classes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Units of the coefficients of springs and dampings.
#define N(NAME, model, text, power, unit, meaning) unit,
static const char *const stiffness_units[] = {QN_NORMALS(N)};
#undef N
#define D(NAME, model, text, with, unit, meaning) unit,
static const char *const damping_units[] = {QN_DAMPINGS(D)};
#undef D

/// "hertz + tsuji, mindlin, epsd"
static const char *law_text(qn_law law, char *text, size_t size)
{
    bool sticks = law.cohesion != QN_COHESION_NONE;
    snprintf(text, size, "%s + %s%s%s, %s, rolling %s", qn_normal_text(law.normal),
             qn_damping_text(law.damping), sticks ? " + " : "",
             sticks ? qn_cohesion_text(law.cohesion) : "", qn_tangential_text(law.tangential),
             qn_rolling_text(law.rolling));
    return text;
}

/// Name of a contact entry, in the order of the scene.
static void name_pair(const qn_def *def, const qn_contact_def *c, char *name, size_t size)
{
    snprintf(name, size, "%s-%s", def->materials[c->material_a].name,
             def->materials[c->material_b].name);
}

/// Whether a law has one damping ratio for all speeds.
static bool has_ratio(qn_law law)
{
    return law.damping != QN_DAMPING_NONE && law.damping != QN_DAMPING_HUNT_CROSSLEY;
}

static double damping_ratio(const qn_forecast_pair *p)
{
    return qn_sides_damping_ratio(&p->sides);
}

static void put_pair(qn_json *j, const qn_world *w, const qn_contact_def *c)
{
    char name[2 * QN_NAME_MAX];
    name_pair(&w->def, c, name, sizeof name);
    qn_forecast_pair p = qn_forecast_pair_of(w, c);
    if (!p.is_used) return;
    qn_json_open(j, name, '{');
    qn_json_text(j, "normal", qn_normal_text(c->law.normal));
    qn_json_text(j, "damping", qn_damping_text(c->law.damping));
    qn_json_text(j, "cohesion", qn_cohesion_text(c->law.cohesion));
    qn_json_text(j, "tangential", qn_tangential_text(c->law.tangential));
    qn_json_text(j, "rolling", qn_rolling_text(c->law.rolling));
    qn_json_text(j, "between", p.is_wall ? "particle and wall" : "particles");
    qn_json_number(j, "effective_young_pa", qn_effective_young(&p.sides));
    qn_json_number(j, "effective_shear_pa", qn_effective_shear(&p.sides));
    qn_json_number(j, "effective_radius_m", qn_effective_radius(&p.sides));
    qn_json_number(j, "effective_mass_kg", qn_effective_mass(&p.sides));
    qn_json_number(j, "normal_stiffness", p.pair.normal_stiffness);
    qn_json_number(j, "normal_damping", p.pair.normal_damping);
    qn_json_number(j, "tangential_stiffness", p.pair.tangential_stiffness);
    qn_json_number(j, "tangential_damping", p.pair.tangential_damping);
    qn_json_text(j, "normal_stiffness_unit", stiffness_units[c->law.normal]);
    qn_json_text(j, "normal_damping_unit", damping_units[c->law.damping]);
    qn_law law = c->law;
#define C(name, unit, used, with) \
    if (used) qn_json_number(j, #name, c->name);
    QN_CONTACT_NUMBERS(C)
#undef C
    if (has_ratio(c->law)) qn_json_number(j, "damping_ratio", damping_ratio(&p));
    qn_json_close(j);
}

/// Whether a class is the one a clump of some size goes by.
static bool is_first(const qn_world *w, int klass)
{
    int grain = w->classes[klass].grain;
    for (int i = 0; i < klass; i++)
        if (w->classes[i].grain == grain) return false;
    return grain >= 0;
}

static void put_clump(qn_json *j, const qn_world *w, const qn_class *c)
{
    const qn_grain *g = &w->grains[c->grain];
    qn_json_open(j, NULL, '{');
    qn_json_text(j, "group", w->def.groups[c->group].name);
    qn_json_integer(j, "spheres", g->count);
    qn_json_number(j, "diameter_m", 2 * g->radius);
    qn_json_number(j, "bounding_diameter_m", 2 * g->bound);
    qn_json_number(j, "mass_kg", g->mass);
    qn_json_open(j, "moments_kg_m2", '[');
    qn_json_number(j, NULL, g->moments.x);
    qn_json_number(j, NULL, g->moments.y);
    qn_json_number(j, NULL, g->moments.z);
    qn_json_close(j);
    qn_json_number(j, "error", w->def.shapes[g->shape].error);
    qn_json_close(j);
}

static void print_clump(const qn_world *w, const qn_class *c)
{
    const qn_grain *g = &w->grains[c->grain];
    double overlap = w->def.shapes[g->shape].overlap;
    printf("%-20s %d spheres, %.6g kg, diameter %.5g mm (equal volume), %.5g mm around it\n",
           w->def.groups[c->group].name, g->count, g->mass, 2e3 * g->radius, 2e3 * g->bound);
    printf("%-20s moments of inertia %.5g, %.5g, %.5g kg m2; %.1f %% of the spheres' volume\n", "",
           g->moments.x, g->moments.y, g->moments.z, 100 * overlap);
}

static qn_status print_json(const qn_world *w, const qn_forecast *f)
{
    qn_json j;
    qn_json_begin(&j);
    qn_json_text(&j, "title", w->def.title);
    qn_json_integer(&j, "particles", f->particles);
    qn_json_integer(&j, "spheres", f->spheres);
    qn_json_number(&j, "mass_kg", f->mass);
    qn_json_number(&j, "filling", f->filling);
    qn_json_number(&j, "critical_speed_rad_s", f->critical_speed);
    qn_json_number(&j, "speed_rad_s", f->speed);
    qn_json_number(&j, "revolutions", f->revolutions);
    qn_json_number(&j, "dt_s", f->dt);
    qn_json_number(&j, "rayleigh_time_s", f->timestep.rayleigh);
    qn_json_number(&j, "rayleigh_fraction", f->dt / f->timestep.rayleigh);
    qn_json_number(&j, "impact_speed_m_s", f->timestep.impact_speed);
    qn_json_number(&j, "contact_time_s", f->timestep.contact);
    qn_json_number(&j, "steps_per_contact", f->timestep.contact / f->dt);
    qn_json_number(&j, "max_overlap_over_radius", f->timestep.largest_overlap);
    qn_json_number(&j, "time_s", f->end);
    qn_json_integer(&j, "steps", f->steps);
    qn_json_integer(&j, "threads", w->threads);
    qn_json_number(&j, "wall_s", f->wall_time);
    qn_json_number(&j, "memory_bytes", f->memory);
    qn_json_number(&j, "disk_bytes", f->disk);
    qn_json_text(&j, "output_directory", w->def.output.directory);
    qn_json_open(&j, "pairs", '{');
    for (int i = 0; i < w->def.contact_count; i++) put_pair(&j, w, &w->def.contacts[i]);
    qn_json_close(&j);
    qn_json_open(&j, "clumps", '[');
    for (int i = 0; i < w->class_count; i++)
        if (is_first(w, i)) put_clump(&j, w, &w->classes[i]);
    qn_json_close(&j);
    cli_flow_put(&j, w);
    cli_sizes_put(&j, w);
    char *text;
    QN_TRY(qn_json_end(&j, &text));
    printf("%s\n", text);
    free(text);
    return QN_OK;
}

/// One number of a pair, where its law uses it; returns what sets the next one apart.
static const char *print_number(const char *apart, const char *name, double x, const char *unit,
                                bool used)
{
    if (!used) return apart;
    printf("%s %s %.4g%s%s", apart, name, x, strcmp(unit, "1") ? " " : "",
           strcmp(unit, "1") ? unit : "");
    return ",";
}

static void print_pairs(const qn_world *w)
{
    printf("\ncontacts\n");
    for (int i = 0; i < w->def.contact_count; i++) {
        const qn_contact_def *c = &w->def.contacts[i];
        qn_forecast_pair p = qn_forecast_pair_of(w, c);
        char name[2 * QN_NAME_MAX], text[128];
        name_pair(&w->def, c, name, sizeof name);
        if (!p.is_used) {
            printf("  %-18s never touch\n", name);
            continue;
        }
        qn_law law = c->law;
        printf("  %-18s %s%s\n", name, law_text(law, text, sizeof text),
               p.is_wall ? "; with a wall" : "");
        printf("  %-18s E* %.4g Pa, R* %.4g m, m* %.4g kg", "", qn_effective_young(&p.sides),
               qn_effective_radius(&p.sides), qn_effective_mass(&p.sides));
        if (has_ratio(law)) printf(", damping ratio %.4g", damping_ratio(&p));
        printf("\n  %-18s", "");
        const char *apart = "";
#define C(name, unit, used, with) apart = print_number(apart, #name, c->name, unit, used);
        QN_CONTACT_NUMBERS(C)
#undef C
        printf("\n  %-18s normal %.8g %s, %.8g %s; tangential %.8g, %.8g\n", "",
               p.pair.normal_stiffness, stiffness_units[law.normal], p.pair.normal_damping,
               damping_units[law.damping], p.pair.tangential_stiffness, p.pair.tangential_damping);
    }
}

static void print_time(const char *what, double seconds)
{
    if (seconds < 1)
        printf("%-20s less than a second\n", what);
    else if (seconds < 120)
        printf("%-20s about %.0f s\n", what, seconds);
    else if (seconds < 7200)
        printf("%-20s about %.0f min\n", what, seconds / 60);
    else
        printf("%-20s about %.1f h\n", what, seconds / 3600);
}

/// "12 kB", "3.4 MB" or "5.1 GB" of a number of bytes.
static void print_bytes(const char *what, double bytes, const char *where)
{
    const char *unit = bytes < 999.5e3 ? "kB" : bytes < 999.5e6 ? "MB" : "GB";
    double size = bytes / (bytes < 999.5e3 ? 1e3 : bytes < 999.5e6 ? 1e6 : 1e9);
    printf("%-20s about %.*f %s%s%s\n", what, size < 10, size, unit, *where ? " in " : "", where);
}

static void print_report(const qn_world *w, const qn_forecast *f)
{
    if (*w->def.title) printf("%s\n\n", w->def.title);
    printf("%-20s %lld, %.6g kg\n", "particles", (long long)f->particles, f->mass);
    for (int i = 0; i < w->class_count; i++)
        if (is_first(w, i)) print_clump(w, &w->classes[i]);
    cli_flow_print(w);
    if (w->def.drum.present) {
        double percent = f->critical_speed > 0 ? 100 * f->speed / f->critical_speed : 0;
        printf("%-20s %.1f %% of the drum, as a bed of solidity %.2f\n", "filling",
               100 * f->filling, w->def.bed_solidity);
        printf("%-20s %.6g rad/s (%.4g rpm)\n", "critical speed", f->critical_speed,
               f->critical_speed * 30 / QN_PI);
        printf("%-20s %.6g rad/s (%.4g rpm), %.4g %%critical\n", "speed", f->speed,
               f->speed * 30 / QN_PI, percent);
    }
    printf("%-20s %.6g s\n", "Rayleigh time", f->timestep.rayleigh);
    printf("%-20s %.6g s at an impact of %.3g m/s, overlap %.2g %% of the radius", "contact time",
           f->timestep.contact, f->timestep.impact_speed, 100 * f->timestep.largest_overlap);
    if (f->timestep.largest_overlap > QN_OVERLAP_WARN)
        printf(" (usual is below %g %%)", 100 * QN_OVERLAP_WARN);
    printf("\n");
    printf("%-20s %.6g s: %.3g of the Rayleigh time, %.3g steps in a contact\n", "time step", f->dt,
           f->dt / f->timestep.rayleigh, f->timestep.contact / f->dt);
    printf("%-20s %.6g s, %lld steps", "run", f->end, (long long)f->steps);
    if (w->def.drum.present) printf(", %.4g turns of the drum", f->revolutions);
    printf("\n");
    print_time("wall time", f->wall_time);
    print_bytes("memory", f->memory, "");
    print_bytes("disk", f->disk, w->def.output.directory);
    print_pairs(w);
    cli_sizes_print(w);
}

static qn_status report(const char *path, const char *text, qn_def *def, bool as_json)
{
    qn_world *w;
    qn_timestep timestep;
    qn_status status = qn_forecast_timestep(def, &timestep);
    if (status == QN_OK) status = qn_world_create(def, 0, &w);
    if (status != QN_OK) return cli_blame(path, text, status);
    qn_forecast f = qn_forecast_of(w, &timestep);
    if (as_json)
        status = print_json(w, &f);
    else
        print_report(w, &f);
    char warnings[CLI_WARNINGS_MAX];
    fputs(cli_warnings(w, &f, warnings, sizeof warnings), stderr);
    qn_world_destroy(w);
    return status;
}

static qn_status check(const char *path, bool as_json)
{
    qn_def def;
    char *text;
    qn_messages messages = {0};
    qn_status status = qn_scene_read(path, &def, &text, &messages);
    if (messages.text) fputs(messages.text, stderr);
    qn_messages_free(&messages);
    if (status == QN_OK) status = report(path, text, &def, as_json);
    qn_def_free(&def);
    free(text);
    return status;
}

int cli_check(int argc, char **argv)
{
    const char *path = NULL;
    bool as_json = false;
    for (int i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--json"))
            as_json = true;
        else if (*argv[i] == '-' || path) {
            fprintf(stderr, "quern check: '%s' is %s\n", argv[i],
                    *argv[i] == '-' ? "not an option; there is only --json"
                                    : "one word too many: give one scene");
            cli_usage("check", true);
            return qn_status_exit(QN_INPUT);
        } else
            path = argv[i];
    }
    if (!path) {
        fprintf(stderr, "quern check: which scene? Give one scene file\n");
        cli_usage("check", true);
        return qn_status_exit(QN_INPUT);
    }
    return qn_status_exit(check(path, as_json));
}
