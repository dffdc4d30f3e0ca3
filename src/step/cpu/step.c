// SPDX-License-Identifier: Apache-2.0
// One time step on the CPU: shares in parallel, each on one thread.
#include "step/step.h"
#include "step/bodies.h"
#include "step/cpu/kernel.h"
#include "step/flow.h"
#include "step/guards.h"
#include "world/turning.h"

#include <string.h>

#define QN_FAST 0.2  // 1   of the smallest radius: no particle may move further in one step

// Periodic images follow their originals.
static void place_images(qn_world *w)
{
    const qn_neighbours *nb = w->neighbours;
    for (int k = w->count; k < w->count + nb->image_count; k++) {
        w->place[k] = w->place[w->place[k].home];
        w->place[k].z += k < w->count + nb->rising_count ? w->period : -w->period;
    }
}

static void clear_share(qn_world *w, qn_share *share)
{
    memset(&w->load[share->first], 0, (size_t)(share->last - share->first) * sizeof *w->load);
    for (int k = 0; k < share->foreign_count; k++)
        memset(&share->spill[share->foreign[k]], 0, sizeof *share->spill);
    qn_tally_sums *sums = share->sums;
    memset(sums->energy, 0, sizeof sums->energy);
    memset(sums->remainder, 0, sizeof sums->remainder);
    memset(sums->part, 0, (size_t)w->walls.part_count * sizeof *sums->part);
    sums->deepest = 0, sums->contacts = 0, sums->wall_contacts = 0;
}

// Takes what the other shares spilled onto this one's particles.
static void fold(qn_world *w, qn_share *share)
{
    const qn_neighbours *nb = w->neighbours;
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *other = &nb->shares[t];
        for (int k = 0; k < other->foreign_count; k++) {
            int i = other->foreign[k];
            if (i < share->first || i >= share->last) continue;
            for (int axis = 0; axis < 3; axis++) {
                w->load[i].force[axis] += other->spill[i].force[axis];
                w->load[i].torque[axis] += other->spill[i].torque[axis];
            }
        }
    }
}

// What this share's spheres that turn with the drum do to the others, as force and torque of the walls'
// parts.
static void lean(const qn_world *w, qn_share *share)
{
    for (int i = share->first; w->rest && i < share->last; i++) {
        const qn_class *c = &w->classes[w->place[i].klass];
        if (!c->turning) continue;
        int64_t *sum = share->sums->part[c->part];
        qn_vec3 force = qn_turning_force(w, i);
        sum[0] += (int64_t)(force.x / w->part_force_unit);
        sum[1] += (int64_t)(force.y / w->part_force_unit);
        sum[2] += (int64_t)(force.z / w->part_force_unit);
        sum[3] += (int64_t)(qn_turning_torque(w, i) / w->part_torque_unit);
    }
}

// Contacts of all shares into the loads.
static qn_status contacts(qn_world *w, const qn_pose *pose, qn_mode mode)
{
    qn_neighbours *nb = w->neighbours;
    qn_status worst = QN_OK;
    for (int t = 0; t < nb->share_count; t++) QN_TRY(qn_kernel_prepare(w, &nb->shares[t]));
#pragma omp parallel num_threads(nb->share_count)
    {
#pragma omp for schedule(static, 1)
        for (int t = 0; t < nb->share_count; t++) {
            clear_share(w, &nb->shares[t]);
            qn_status status = qn_kernel_contacts(w, &nb->shares[t], pose, mode);
            if (status != QN_OK) {
#pragma omp critical
                worst = status;
            }
        }
#pragma omp for schedule(static, 1)
        for (int t = 0; t < nb->share_count; t++) {
            fold(w, &nb->shares[t]);
            lean(w, &nb->shares[t]);
        }
    }
    return worst == QN_OK ? QN_OK : qn_fail(worst, "the list of wall contacts could not grow");
}

// Forces, torque and power of the walls' parts. A body turns about a line or moves along one, so that its
// power follows from the sums.
static void tally_parts(qn_world *w, const qn_pose *pose)
{
    qn_ledger *ledger = &w->ledger;
    const qn_neighbours *nb = w->neighbours;
    for (int p = 0; p < ledger->part_count; p++) {
        const qn_frame *frame = &pose->frames[w->walls.parts[p].body];
        int64_t sum[4] = {0};
        for (int t = 0; t < nb->share_count; t++)
            for (int k = 0; k < 4; k++) sum[k] += nb->shares[t].sums->part[p][k];
        double *force = &ledger->force_now[3 * p], power = 0;
        ledger->torque_now[p] = w->part_torque_unit * (double)sum[3];
        for (int k = 0; k < 3; k++) force[k] = w->part_force_unit * (double)sum[k];
        if (frame->moves)
            power = ledger->torque_now[p] * frame->speed
                    + qn_dot(qn_v3(force[0], force[1], force[2]), frame->velocity);
        ledger->power_now[p] = power;
    }
}

// Brings the shares' sums of this step together in the ledger.
static void tally(qn_world *w)
{
    qn_ledger *ledger = &w->ledger;
    const qn_neighbours *nb = w->neighbours;
    double remainder[QN_TALLY_COUNT] = {0};
    ledger->contacts_now = ledger->wall_contacts_now = 0;
    ledger->deepest_now = 0;
    memset(ledger->now, 0, sizeof ledger->now);
    for (int t = 0; t < nb->share_count; t++) {
        const qn_tally_sums *sums = nb->shares[t].sums;
        for (int e = 0; e < QN_TALLY_COUNT; e++)
            for (int l = 0; l < QN_LANES; l++) {
                ledger->now[e] += sums->energy[e][l];
                remainder[e] += sums->remainder[e][l];
            }
        ledger->contacts_now += sums->contacts;
        ledger->wall_contacts_now += sums->wall_contacts;
        ledger->deepest_now = qn_max(ledger->deepest_now, sums->deepest);
    }
    for (int e = 0; e < QN_TALLY_COUNT; e++) ledger->now[e] += remainder[e];
}

qn_status qn_step_forces(qn_world *w, qn_mode mode)
{
    qn_pose pose = qn_walls_pose(&w->walls, qn_world_time(w));
    QN_TRY(qn_step_begin(w));
    if (w->neighbours->stale) QN_TRY(qn_neighbours_rebuild(w));
    place_images(w);
    QN_TRY(contacts(w, &pose, mode));
    qn_bodies_load(w);
    tally(w);
    tally_parts(w, &pose);
    w->committed = mode == QN_COMMIT;
    return qn_guard_overlap(w);
}

qn_status qn_step_begin(qn_world *w)
{
    if (w->started) return QN_OK;
    w->started = true;
    QN_TRY(qn_step_forces(w, QN_PROBE));
    for (int i = 0; i < w->count; i++) {
        qn_motion *m = &w->motion[i];
        if (qn_body_of(w, i) >= 0 || w->classes[w->place[i].klass].turning) continue;
        qn_scheme scheme = w->def.scheme;
        qn_kept v = qn_scheme_begin(scheme, m->velocity, qn_acceleration(w, i), w->dt);
        qn_kept s = qn_scheme_begin(scheme, m->spin, qn_angular_acceleration(w, i), w->dt);
        *m = (qn_motion){v.velocity, s.velocity, v.kick, s.kick};
    }
    qn_bodies_begin(w);
    return QN_OK;
}

// Kick and drift of a particle.
static void move_one(qn_world *w, int i)
{
    double rounder = 1.5 * 0x1p52 * w->lattice;
    qn_scheme scheme = w->def.scheme;
    qn_motion *m = &w->motion[i];
    qn_place *p = &w->place[i];
    qn_kept v = {m->velocity, m->kick}, s = {m->spin, m->spin_kick};
    v = qn_scheme_advance(scheme, v, qn_acceleration(w, i), w->dt);
    s = qn_scheme_advance(scheme, s, qn_angular_acceleration(w, i), w->dt);
    *m = (qn_motion){v.velocity, s.velocity, v.kick, s.kick};
    p->x += w->dt * m->velocity.x;
    p->y += w->dt * m->velocity.y;
    double along = w->dt * m->velocity.z;
    p->z += w->period > 0 ? (along + rounder) - rounder : along;
}

// Moves the balls among the particles [first, last) to the next step, where the drum is as given. Returns whether one has used
// up half the skin.
static bool move(qn_world *w, const qn_frame *drum, int first, int last, bool *lost)
{
    double half_skin2 = 0.25 * w->neighbours->skin * w->neighbours->skin;
    double fast = QN_FAST * w->smallest_radius / w->dt;
    bool spent = false, unsound = false;
    for (int i = first; i < last; i++) {
        if (qn_body_of(w, i) >= 0) continue;
        if (w->rest && w->classes[w->place[i].klass].turning)
            qn_turning_put(w, drum, i);
        else
            move_one(w, i);
        const qn_motion *m = &w->motion[i];
        const qn_place *p = &w->place[i];
        const qn_anchor *anchor = &w->neighbours->anchor[i];
        double x = p->x - anchor->x, y = p->y - anchor->y, z = p->z - anchor->z;
        spent |= !(x * x + y * y + z * z <= half_skin2);
        unsound |= !(qn_dot(m->velocity, m->velocity) <= fast * fast);
    }
    *lost = unsound;
    return spent;
}

qn_status qn_step_advance(qn_world *w)
{
    qn_neighbours *nb = w->neighbours;
    qn_ledger *ledger = &w->ledger;
    int body = w->walls.has_drum ? w->walls.drum_body : 0;
    qn_frame drum = qn_walls_frame(&w->walls, body, (double)(w->step + 1) * w->dt);
    int spent = 0, unsound = 0;
    if (w->flow) QN_TRY(qn_flow_look(w));
    for (int e = 0; e < QN_LOSS_COUNT; e++) ledger->lost[e] += ledger->now[e];
    for (int p = 0; p < ledger->part_count; p++) {
        ledger->work[p] += ledger->power_now[p] * w->dt;
        ledger->impulse[p] += ledger->torque_now[p] * w->dt;
        for (int k = 3 * p; k < 3 * p + 3; k++) ledger->push[k] += ledger->force_now[k] * w->dt;
    }
#pragma omp parallel for schedule(static, 1) num_threads(nb->share_count) \
    reduction(|                                                           \
              : spent, unsound)
    for (int t = 0; t < nb->share_count; t++) {
        bool lost;
        spent |= move(w, &drum, nb->shares[t].first, nb->shares[t].last, &lost);
        unsound |= lost;
    }
    double fast = QN_FAST * w->smallest_radius / w->dt;
    qn_bodies_advance(w, fast, &spent, &unsound);
    nb->stale |= spent;
    w->step++;
    w->committed = false;
    if (unsound) return qn_guard_speed(w, fast);
    return w->flow ? qn_flow_act(w) : QN_OK;
}
