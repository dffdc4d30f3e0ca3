// SPDX-License-Identifier: Apache-2.0
#include "record/summary.h"

#include "record/json.h"
#include "world/flow.h"
#include "world/neighbours.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static void put_run(qn_json *j, const qn_world *w, const qn_progress *p, bool finished)
{
    double particle_steps = (double)w->step * qn_world_particles(w);
    qn_json_text(j, "format", QN_RECORDING_FORMAT);
    qn_json_text(j, "version", QN_VERSION);
    qn_json_text(j, "title", w->def.title);
    qn_json_flag(j, "finished", finished);
    qn_json_integer(j, "particles", qn_world_particles(w));
    qn_json_integer(j, "steps", w->step);
    qn_json_number(j, "time_s", qn_world_time(w));
    qn_json_number(j, "dt_s", w->dt);
    qn_json_number(j, "wall_s", p->wall);
    qn_json_number(j, "particle_steps_per_s", particle_steps / p->wall);
    qn_json_integer(j, "threads", w->threads);
    qn_json_text(j, "backend", "cpu");
    qn_json_integer(j, "list_rebuilds", w->neighbours ? w->neighbours->rebuilds : 0);
}

/// What one feed or outlet has moved, by the sizes of its particles.
static void put_one_flow(qn_json *j, const qn_world *w, const char *name, const int64_t *by_class)
{
    qn_json_open(j, name, '{');
    qn_json_integer(j, "particles", qn_flow_count(w, by_class));
    qn_json_number(j, "mass_kg", qn_flow_mass(w, by_class));
    qn_json_open(j, "classes", '[');
    for (int c = 0; c < w->class_count; c++) {
        if (by_class[c] == 0) continue;
        qn_json_open(j, NULL, '{');
        qn_json_text(j, "group", w->def.groups[w->classes[c].group].name);
        qn_json_number(j, "diameter_m", 2 * w->classes[c].radius);
        qn_json_integer(j, "particles", by_class[c]);
        qn_json_close(j);
    }
    qn_json_close(j);
    qn_json_close(j);
}

static void put_flow(qn_json *j, const qn_world *w)
{
    const qn_flow *f = w->flow;
    if (!f) return;
    qn_json_open(j, "feeds", '{');
    for (int k = 0; k < f->feed_count; k++)
        put_one_flow(j, w, w->def.feeds[k].name, f->fed + k * f->class_count);
    qn_json_close(j);
    qn_json_open(j, "outlets", '{');
    for (int k = 0; k < f->outlet_count; k++)
        put_one_flow(j, w, w->def.outlets[k].name, f->taken + k * f->class_count);
    qn_json_close(j);
    qn_json_number(j, "brought_in_j", qn_flow_energy_in(w));
    qn_json_number(j, "taken_out_j", qn_flow_energy_out(w));
}

static void put_drum(qn_json *j, const qn_world *w)
{
    bool drum = w->walls.has_drum;
    double nothing = (double)NAN;
    double critical = sqrt(2 * qn_norm(w->gravity) / w->walls.drum.diameter);
    qn_json_number(j, "critical_speed_rad_s", drum ? critical : nothing);
    qn_json_number(j, "speed_rad_s",
                   drum ? qn_drum_speed(&w->walls.drum, qn_world_time(w)) : nothing);
}

static void put_power(qn_json *j, const qn_world *w, const qn_measure *m)
{
    qn_power power = qn_passages_power(&m->passages);
    qn_json_number(j, "power_torque_w", power.torque);
    qn_json_number(j, "power_stderr_w", power.standard_error);
    qn_json_number(j, "power_dissipated_w", power.dissipated);
    qn_json_number(j, "power_stored_w", power.storing);
    qn_json_number(j, "power_drift_w", power.drift);
    qn_json_number(j, "power_window_s", power.window);
    qn_json_integer(j, "power_passages", power.passages);
    if (isfinite(power.torque))
        qn_json_flag(j, "steady", power.steady);
    else
        qn_json_null(j, "steady");
    qn_json_open(j, "power_parts_w", '{');
    for (int p = 0; p < w->walls.part_count && m->passages.active; p++)
        qn_json_number(j, w->walls.parts[p].name, qn_passages_part_power(&m->passages, p));
    qn_json_close(j);
}

/// Of each part of the walls, over the whole run: work, mean power, force and torque, and wear.
static void put_parts(qn_json *j, const qn_world *w)
{
    double time = qn_world_time(w);
    qn_json_open(j, "walls", '{');
    for (int p = 0; p < w->walls.part_count; p++) {
        qn_json_open(j, w->walls.parts[p].name, '{');
        qn_json_number(j, "work_j", qn_part_work(w, p));
        qn_json_number(j, "mean_power_w", qn_part_work(w, p) / time);
        qn_json_number(j, "mean_torque_n_m", qn_part_impulse(w, p) / time);
        qn_json_number(j, "mean_force_x_n", qn_part_push(w, p, 0) / time);
        qn_json_number(j, "mean_force_y_n", qn_part_push(w, p, 1) / time);
        qn_json_number(j, "mean_force_z_n", qn_part_push(w, p, 2) / time);
#define W(NAME, name, unit, meaning) \
    qn_json_number(j, #name "_j", qn_walls_worn(w, p, QN_WEAR_##NAME));
        QN_WEARS(W)
#undef W
        qn_json_close(j);
    }
    qn_json_close(j);
}

static double value_of(const qn_measure *m, const double *row, const char *name)
{
    return row ? qn_measure_value(m, row, name) : (double)NAN;
}

static qn_status put_charge(qn_json *j, const qn_world *w, const qn_measure *m, const double *row)
{
    qn_charge charge;
    char lack[160];
    QN_TRY(qn_measure_charge(m, &charge));
    qn_measure_lack(m, lack, sizeof lack);
    double deepest_time = (double)w->ledger.deepest_step * w->dt;
    qn_json_number(j, "energy_residual_relative", value_of(m, row, "residual_relative"));
    qn_json_number(j, "max_overlap_over_radius", w->ledger.deepest);
    qn_json_number(j, "max_overlap_time_s", deepest_time);
    qn_json_number(j, "contacts_per_particle", value_of(m, row, "contacts_per_particle"));
    qn_json_number(j, "solidity_bulk", charge.bulk);
    qn_json_number(j, "shoulder_deg", charge.shoulder);
    qn_json_number(j, "toe_deg", charge.toe);
    if (*lack)
        qn_json_text(j, "charge_note", lack);
    else
        qn_json_null(j, "charge_note");
    return QN_OK;
}

qn_status qn_summary_write(const char *path, const qn_world *world, const qn_measure *measure,
                           const qn_progress *progress, const double *row, bool finished)
{
    qn_json json;
    char *text;
    qn_json_begin(&json);
    put_run(&json, world, progress, finished);
    put_flow(&json, world);
    put_drum(&json, world);
    put_power(&json, world, measure);
    put_parts(&json, world);
    qn_status status = put_charge(&json, world, measure, row);
    qn_json_hex(&json, "state_hash", progress->state_hash);
    qn_status ended = qn_json_end(&json, &text);
    if (ended != QN_OK) return ended;
    if (status == QN_OK) status = qn_atomic_text(path, text);
    free(text);
    return status;
}

/// "power 0.31 +- 0.004 W over 30 lifter passages, steady (drift +0.4 %)", or what is known of it.
static void put_power_text(FILE *out, const qn_passages *p)
{
    qn_power power = qn_passages_power(p);
    if (!isfinite(power.torque)) return;
    fprintf(out, "power %.4g ", power.torque);
    if (isfinite(power.standard_error)) fprintf(out, "+- %.2g ", power.standard_error);
    fprintf(out, "W over %" PRId64 " %s%s%s", power.passages,
            p->lifters ? "lifter passage" : "sixteenth", power.passages == 1 ? "" : "s",
            p->lifters ? "" : " of a turn");
    if (!isfinite(power.drift))
        fprintf(out, ": too few for its error and drift\n");
    else
        fprintf(out, ", %s (drift %+.1f %%)\n", power.steady ? "steady" : "not steady",
                power.torque == 0 ? 0 : 100 * power.drift / power.torque);
}

const char *qn_summary_text(const qn_measure *m, const double *row, char *text, size_t room)
{
    double residual = value_of(m, row, "residual_relative");
    FILE *out = fmemopen(text, room, "w");
    text[0] = 0;
    if (!out) return text;
    put_power_text(out, &m->passages);
    if (isfinite(residual)) fprintf(out, "energy residual %.2g of the turnover\n", residual);
    fclose(out);
    return text;
}
