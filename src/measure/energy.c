// SPDX-License-Identifier: Apache-2.0
#include "measure/energy.h"
#include "world/flow.h"

#include <omp.h>

__extension__ typedef __int128 wide;

enum { KINETIC, ROTATION, GRAVITY, SPEED, MASS, MOMENT_X, MOMENT_Y, MOMENT_Z, SUM_COUNT };

typedef struct sums {
    wide total[SUM_COUNT];
    double fastest;  // m/s
    int64_t moving;  // 1   balls and clumps that can move
    bool broken;     //     a number that no sum can hold
} sums;

// Half of this step's share belongs to the time up to step n.
double qn_part_work(const qn_world *w, int p)
{
    return w->ledger.work[p] + 0.5 * w->dt * w->ledger.power_now[p];
}

double qn_part_impulse(const qn_world *w, int p)
{
    return w->ledger.impulse[p] + 0.5 * w->dt * w->ledger.torque_now[p];
}

double qn_part_push(const qn_world *w, int p, int axis)
{
    return w->ledger.push[3 * p + axis] + 0.5 * w->dt * w->ledger.force_now[3 * p + axis];
}

double qn_drive_work(const qn_world *w)
{
    double sum = 0;
    for (int p = 0; p < w->ledger.part_count; p++)
        if (w->walls.parts[p].turning) sum += qn_part_work(w, p);
    return sum;
}

static void add(sums *s, int which, double value, double unit)
{
    double quanta = value / unit;
    if (fabs(quanta) < 0x1p90)
        s->total[which] += (wide)rint(quanta);
    else
        s->broken = true;
}

// Quanta: energies far below the ledger's own quantum, which is nothing where nothing can touch, hence
// no less than 2^-66 J/kg of the heaviest; masses and moments 2^-60 of it.
static void units_of(const qn_world *w, double unit[SUM_COUNT])
{
    double heaviest = 0;
    for (int c = 0; c < w->class_count; c++) heaviest = qn_max(heaviest, w->classes[c].mass);
    double mass = heaviest > 0 ? ldexp(1, ilogb(heaviest) - 60) : 1;
    unit[KINETIC] = unit[ROTATION] = unit[GRAVITY] =
        qn_max(w->energy_unit * 0x1p-24, mass * 0x1p-6);
    unit[SPEED] = 0x1p-60;
    unit[MASS] = unit[MOMENT_X] = unit[MOMENT_Y] = unit[MOMENT_Z] = mass;
}

// Adds what moves as one: its mass, rotational energy, centre and the velocity of that.
static void add_one(sums *s, const qn_world *w, double mass, double rotation, qn_vec3 x, qn_vec3 v,
                    const double *unit)
{
    qn_vec3 g = w->gravity;
    double speed = qn_norm(v), along = w->period > 0 ? 0 : g.z * x.z;
    add(s, KINETIC, 0.5 * mass * qn_dot(v, v), unit[KINETIC]);
    add(s, ROTATION, rotation, unit[ROTATION]);
    add(s, GRAVITY, -mass * (g.x * x.x + g.y * x.y + along), unit[GRAVITY]);
    add(s, SPEED, speed, unit[SPEED]);
    add(s, MASS, mass, unit[MASS]);
    add(s, MOMENT_X, mass * x.x, unit[MOMENT_X]);
    add(s, MOMENT_Y, mass * x.y, unit[MOMENT_Y]);
    add(s, MOMENT_Z, mass * x.z, unit[MOMENT_Z]);
    s->fastest = qn_max(speed, s->fastest);
    s->moving++;
}

static void add_ball(sums *s, const qn_world *w, int i, const double *unit)
{
    const qn_class *c = &w->classes[w->place[i].klass];
    if (!(c->inverse_mass > 0) || qn_body_of(w, i) >= 0) return;
    qn_vec3 spin = qn_spin_now(w, i);
    add_one(s, w, c->mass, 0.5 * c->inertia * qn_dot(spin, spin), qn_world_position(w, i),
            qn_velocity_now(w, i), unit);
}

static void add_clump(sums *s, const qn_world *w, const qn_body *b, const double *unit)
{
    const qn_grain *g = &w->grains[b->grain];
    if (!(g->inverse_mass > 0)) return;
    qn_vec3 spin = qn_body_spin_now(w, b);
    qn_vec3 momentum = qn_tensor_times(b->orientation, g->moments, spin);
    add_one(s, w, g->mass, 0.5 * qn_dot(spin, momentum), qn_body_position(w, b),
            qn_body_velocity_now(w, b), unit);
}

static sums add_particles(const qn_world *w, const double *unit)
{
    sums all = {0};
#pragma omp parallel num_threads(w->threads)
    {
        sums mine = {0};
#pragma omp for
        for (int i = 0; i < w->count; i++) add_ball(&mine, w, i, unit);
#pragma omp for
        for (int k = 0; k < w->body_count; k++) add_clump(&mine, w, &w->bodies[k], unit);
#pragma omp critical(qn_balance_sums)
        {
            for (int k = 0; k < SUM_COUNT; k++) all.total[k] += mine.total[k];
            all.fastest = qn_max(all.fastest, mine.fastest);
            all.moving += mine.moving;
            all.broken |= mine.broken;
        }
    }
    return all;
}

qn_status qn_balance_now(const qn_world *w, qn_balance *b)
{
    double unit[SUM_COUNT];
    units_of(w, unit);
    sums s = add_particles(w, unit);
    if (s.broken)
        return qn_fail(
            QN_UNSTABLE,
            "energy at t = %g s: a particle's position, velocity or spin is not finite, or "
            "too large to be summed; the time step may be too long",
            qn_world_time(w));
    double v[SUM_COUNT];
    for (int k = 0; k < SUM_COUNT; k++) v[k] = (double)s.total[k] * unit[k];
    const qn_ledger *l = &w->ledger;
    b->kinetic_translation = v[KINETIC];
    b->kinetic_rotation = v[ROTATION];
    b->gravity = v[GRAVITY];
    b->elastic_normal = l->now[QN_TALLY_ELASTIC_NORMAL];
    b->elastic_tangential = l->now[QN_TALLY_ELASTIC_TANGENTIAL];
    b->stored = b->kinetic_translation + b->kinetic_rotation + b->gravity + b->elastic_normal
                + b->elastic_tangential;
    b->work = 0;
    for (int p = 0; p < l->part_count; p++) b->work += qn_part_work(w, p);
    b->lost = 0;
    for (int k = 0; k < QN_LOSS_COUNT; k++) b->lost += qn_ledger_lost(l, k);
    b->brought = qn_flow_energy_in(w);
    b->taken = qn_flow_energy_out(w);
    b->mean_speed = s.moving > 0 ? v[SPEED] / (double)s.moving : 0;
    b->max_speed = s.fastest;
    double mass = v[MASS] > 0 ? v[MASS] : 1;
    b->centre = qn_v3(v[MOMENT_X] / mass, v[MOMENT_Y] / mass, v[MOMENT_Z] / mass);
    return QN_OK;
}

double qn_balance_residual(const qn_balance *now, const qn_balance *first)
{
    double net = (now->brought - first->brought) - (now->taken - first->taken);
    return (now->work - first->work) + net - (now->stored - first->stored)
           - (now->lost - first->lost);
}

double qn_balance_turnover(const qn_balance *now, const qn_balance *first)
{
    double turnover = qn_max(fabs(now->work - first->work), fabs(now->lost - first->lost));
    turnover = qn_max(turnover, fabs(now->gravity - first->gravity));
    turnover = qn_max(turnover, now->stored - now->gravity);
    return qn_max(turnover, first->stored - first->gravity);
}
