// SPDX-License-Identifier: Apache-2.0
// The time series: one row of numbers every so many steps.
//
// One list names the columns with unit, meaning and expression; after them come, for each part of the
// walls, its work, torque, power and force on the particles. A part's torque is told about the line it turns
// about, else about z.
#ifndef QN_MEASURE_SERIES_H
#define QN_MEASURE_SERIES_H

#include "base/column.h"
#include "measure/energy.h"

// In an expression: w the world, l its ledger, b the balance now, s the series.
// clang-format off
//    name                    unit     expression and meaning
#define QN_SERIES_COLUMNS(C)                                                                       \
    C(step,                   "1",     (double)w->step,              "number of the step")         \
    C(time_s,                 "s",     qn_world_time(w),             "since the start of the run") \
    C(drum_angle_rad,         "rad",   drum_angle(w),                "total angle the drum has turned") \
    C(drum_speed_rad_s,       "rad/s", drum_speed(w),                "of the drum, positive about +z") \
    C(kinetic_translation_j,  "J",     b->kinetic_translation,       "kinetic energy of the centres") \
    C(kinetic_rotation_j,     "J",     b->kinetic_rotation,          "kinetic energy of the spins") \
    C(gravity_j,              "J",     b->gravity,                   "potential energy in gravity, 0 at the origin") \
    C(elastic_normal_j,       "J",     b->elastic_normal,            "stored in normal springs")   \
    C(elastic_tangential_j,   "J",     b->elastic_tangential,        "stored in tangential springs") \
    C(lost_normal_j,          "J",     qn_ledger_lost(l, QN_TALLY_NORMAL),     "lost to normal dashpots so far, the clip included") \
    C(lost_tangential_j,      "J",     qn_ledger_lost(l, QN_TALLY_TANGENTIAL), "lost to tangential dashpots so far") \
    C(lost_sliding_j,         "J",     qn_ledger_lost(l, QN_TALLY_SLIDING),    "lost to sliding friction so far") \
    C(lost_rolling_j,         "J",     qn_ledger_lost(l, QN_TALLY_ROLLING),    "lost to rolling resistance so far") \
    C(mindlin_residue_j,      "J",     qn_ledger_lost(l, QN_TALLY_RESIDUE),    "lost by the Mindlin spring as its stiffness changes, so far") \
    C(work_j,                 "J",     b->work,                      "done by the walls on the particles so far") \
    C(residual_j,             "J",     qn_balance_residual(b, &s->start),   "work and energy brought in less energy taken out, change of stored energy and losses, since the start") \
    C(residual_relative,      "1",     residual_relative(b, s),      "the residual by the turnover: the largest of work, losses, change of gravity's energy, kinetic and elastic energy now and at the start") \
    C(power_w,                "W",     since(w, s, b->work - s->work),   "work by time since the row before") \
    C(dissipated_w,           "W",     since(w, s, b->lost - s->lost),   "losses by time since the row before") \
    C(brought_in_j,           "J",     b->brought,                   "kinetic and gravity's energy of the particles that feeds gave so far") \
    C(taken_out_j,            "J",     b->taken,                     "energy of the particles that outlets took so far, with that of their contacts") \
    C(particles,              "1",     (double)w->count,             "in the world")               \
    C(fed,                    "1",     qn_flow_total_count(w, 0),    "particles that feeds gave so far") \
    C(fed_kg,                 "kg",    qn_flow_total_mass(w, 0),     "their mass")                 \
    C(removed,                "1",     qn_flow_total_count(w, 1),    "particles that outlets took so far") \
    C(removed_kg,             "kg",    qn_flow_total_mass(w, 1),     "their mass")                 \
    C(contacts,               "1",     (double)l->contacts_now,      "between particles, touching") \
    C(wall_contacts,          "1",     (double)l->wall_contacts_now, "of particles with walls, touching") \
    C(contacts_per_particle,  "1",     per_particle(w),              "coordination: twice the contacts by the particles, walls not counted; a clump is one particle") \
    C(overlap_percent,        "%",     100 * l->deepest_now,         "largest overlap now, of the smaller radius") \
    C(mean_speed_m_s,         "m/s",   b->mean_speed,                "mean speed of the particles") \
    C(max_speed_m_s,          "m/s",   b->max_speed,                 "largest speed")              \
    C(centre_x_m,             "m",     b->centre.x,                  "centre of mass, x")          \
    C(centre_y_m,             "m",     b->centre.y,                  "centre of mass, y")          \
    C(centre_z_m,             "m",     b->centre.z,                  "centre of mass, z; within the period where there is one")
//    name       unit suffix   meaning, for each part
#define QN_SERIES_PART_COLUMNS(C)                                                                  \
    C(work,      "J",     "_j",       qn_part_work(w, p),            "work done by this part on the particles so far") \
    C(impulse,   "N m s", "_n_m_s",   qn_part_impulse(w, p),         "its torque about the axis on the particles times time so far") \
    C(torque,    "N m",   "_n_m",     since(w, s, qn_part_impulse(w, p) - s->impulse[p]), "that torque, mean since the row before") \
    C(power,     "W",     "_w",       since(w, s, qn_part_work(w, p) - s->part_work[p]), "its work by time since the row before") \
    C(force_x,   "N",     "_n",       since(w, s, qn_part_push(w, p, 0) - s->push[3 * p]), "its force on the particles, mean since the row before, along x") \
    C(force_y,   "N",     "_n",       since(w, s, qn_part_push(w, p, 1) - s->push[3 * p + 1]), "along y") \
    C(force_z,   "N",     "_n",       since(w, s, qn_part_push(w, p, 2) - s->push[3 * p + 2]), "along z")
// clang-format on

typedef struct qn_series_column {
    char name[QN_NAME_MAX + 40];  // as in the first line of the CSV file
    const char *unit, *meaning;   // not owned
} qn_series_column;

typedef struct qn_series {
    int column_count, part_count;
    qn_series_column *columns;  //     owned
    double *row;                //     the latest row, filled by qn_series_take(); owned
    // Kept in a checkpoint.
    int64_t begun;            //     0 before the start is known, then 1
    int64_t row_step;         //     step of the row before; -1 for none
    double time, work, lost;  // s, J, J   of the row before
    // Of each part, up to the row before; owned.
    double *impulse, *part_work, *push;  // N m s, J, N s   the last with x, y and z
    qn_balance start;                    //     the balance at the start of the run
} qn_series;

QN_NODISCARD qn_status qn_series_create(const qn_world *world, qn_series *series);
void qn_series_free(qn_series *series);

/// Notes the balance that residuals are counted from; once, at the start of the run.
void qn_series_begin(qn_series *series, const qn_balance *balance);

/// Writes the present step's numbers into `row` (column_count of them) and changes nothing.
void qn_series_row(const qn_series *series, const qn_world *world, const qn_balance *balance,
                   double *row);

/// Fills series->row, and makes it the one that the next row's means are counted from.
void qn_series_take(qn_series *series, const qn_world *world, const qn_balance *balance);

/// What must survive a checkpoint; as qn_measure_columns().
int qn_series_state(qn_series *series, qn_column *columns, int room);

#endif
