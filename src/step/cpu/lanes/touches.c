// SPDX-License-Identifier: Apache-2.0
// Contacts of the particles of one share with walls, eight at a time. Compiled once per instruction set,
// with QN_ISA naming it.
//
// Each particle asks the walls what it touches; touches are queued by surface and class, and then go the
// way of pairs (pairs.c). Their histories are found again by feature, particle by particle.
#include "step/cpu/lanes/sums.h"

// A wall point's velocity half a step ago is that of now less its acceleration times dt/2; the rest of the
// way to now is its kick. The same for the wall's spin.
static void gather_wall(const qn_world *w, const qn_share *share, const qn_pose *pose,
                        const queue *q, int from, int l, block *b)
{
    const qn_place *place = &w->place[q->a[from]];
    const qn_motion *a = &w->motion[q->a[from]];
    const qn_wall_hit *hit = &q->hit[from];
    const qn_frame *frame = &pose->frames[hit->body];
    qn_vec3 p = hit->point, x = qn_v3(place->x, place->y, place->z);
    qn_vec3 wall_kick = qn_scale(0.5 * w->dt, qn_frame_acceleration(frame, p));
    qn_vec3 wall = qn_sub(qn_frame_velocity(frame, p), wall_kick);
    double spin_kick = 0.5 * w->dt * frame->slope;
    PUT(b->between, l, qn_sub(x, p));
    PUT(b->velocity, l, qn_sub(a->velocity, wall));
    PUT(b->kick, l, qn_sub(a->kick, wall_kick));
    PUT(b->spin_a, l, a->spin);
    PUT(b->spin_b, l, qn_scale(frame->speed - spin_kick, frame->axis));
    PUT(b->spin_kick_a, l, a->spin_kick);
    PUT(b->spin_kick_b, l, qn_scale(spin_kick, frame->axis));
    const qn_wall_contact *contact = &share->walls_next[q->slot[from]];
    PUT(b->slip, l, contact->memory.slip);
    PUT(b->roll, l, contact->memory.roll);
    PUT(b->last, l, contact->normal);
}

// Force and torque of a lane on its part of the walls, and what they wear.
static void load_wall(qn_world *w, qn_share *share, const qn_pose *pose, const qn_wall_hit *hit,
                      const block *b, int l, qn_mode mode)
{
    const qn_frame *frame = &pose->frames[hit->body];
    qn_vec3 force = GET(b->force, l), normal = GET(b->normal, l);
    qn_vec3 torque = qn_cross(qn_sub(hit->point, frame->pivot), force);
    int64_t *sum = share->sums->part[hit->part];
    double per_force = 1 / w->part_force_unit;
    sum[0] += (int64_t)(force.x * per_force);
    sum[1] += (int64_t)(force.y * per_force);
    sum[2] += (int64_t)(force.z * per_force);
    torque = qn_add(torque, GET(b->torque, l));
    sum[3] += (int64_t)(qn_dot(frame->axis, torque) / w->part_torque_unit);
    if (mode == QN_PROBE) return;
    double work[QN_WEAR_COUNT];
    qn_wear_of(force, normal, qn_madd(GET(b->slide, l), -b->rate[l], normal), w->dt, work);
    qn_wear_add(&w->wear, hit->facet, work);
}

// Leaves a lane its share of everything, where a corner is shared; the depth told is that under the corner.
static void share_out(block *b, int l, double radius, double share, double beyond)
{
    double height = radius - b->depth[l];
    b->depth[l] = qn_max(0, radius - sqrt(height * height + beyond * beyond));
    PUT(b->force, l, qn_scale(share, GET(b->force, l)));
    PUT(b->torque_a, l, qn_scale(share, GET(b->torque_a, l)));
    PUT(b->torque, l, qn_scale(share, GET(b->torque, l)));
    for (int e = 0; e < QN_TALLY_COUNT; e++) b->energy[e][l] *= share;
}

static void flush_walls(qn_world *w, qn_share *share, const qn_pose *pose, int kind, qn_mode mode)
{
    workspace *work = share->workspace;
    queue *q = &work->walls[kind];
    block *b = &work->block;
    const qn_class *c = &w->classes[kind % w->class_count];
    const qn_reach reach = {c->radius, c->radius, 0, 1, 0};
    if (q->count == 0) return;
    for (int l = 0; l < W; l++) gather_wall(w, share, pose, q, l < q->count ? l : 0, l, b);
    JOIN(qn_block_evaluate, QN_ISA)(w->wall_laws[kind], &w->wall_pairs[kind], &reach, b);
    for (int l = 0; l < q->count; l++)
        if (q->hit[l].share < 1) share_out(b, l, c->radius, q->hit[l].share, q->hit[l].beyond);
    quantise(b, c, NULL);
    for (int l = 0; l < q->count; l++) {
        qn_wall_contact *contact = &share->walls_next[q->slot[l]];
        add_load(&w->load[q->a[l]], b, 0, l);
        load_wall(w, share, pose, &q->hit[l], b, l, mode);
        contact->memory = (qn_memory){GET(b->next_slip, l), GET(b->next_roll, l)};
        contact->normal = GET(b->normal, l);
    }
    tally(w, share->sums, b, q->count, c->radius);
    share->sums->wall_contacts += q->count;
    q->count = 0;
}

// The history of a touch: that of the same feature at the last step, else that of a feature which is
// no longer touched and whose normal is within 20 degrees, as when rolling over a joint. `taken` marks
// those already inherited: each history goes on once. A stretch that shares a corner copies the history of
// its neighbour, which goes on being touched.
static qn_memory wall_history(const qn_wall_contact *old, int old_count, const qn_wall_hit *hits,
                              int hit_count, int h, qn_vec3 centre, uint32_t *taken)
{
    for (int k = 0; k < old_count; k++)
        if (old[k].feature == hits[h].feature) return old[k].memory;
    qn_vec3 away = qn_sub(centre, hits[h].point);
    double least = 0.9396926207859084 * qn_norm(away);  // cos 20 degrees
    for (int k = 0; k < old_count; k++) {
        bool still = false;
        for (int other = 0; other < hit_count; other++)
            still |= old[k].feature == hits[other].feature;
        if (!(qn_dot(old[k].normal, away) > least)) continue;
        if (still && hits[h].share < 1) return old[k].memory;
        if (still || *taken >> k & 1) continue;
        *taken |= (uint32_t)1 << k;
        return old[k].memory;
    }
    return (qn_memory){{0, 0, 0}, {0, 0, 0}};
}

// The normal of a touch of the same feature at the last step, or 0.
static qn_vec3 last_normal(const qn_wall_contact *old, int old_count, int32_t feature)
{
    for (int k = 0; k < old_count; k++)
        if (old[k].feature == feature) return old[k].normal;
    return qn_v3(0, 0, 0);
}

// Queues the touches of one particle. old: its wall contacts of the last step.
static qn_status touch_walls(qn_world *w, qn_share *share, const qn_pose *pose, qn_mode mode, int i,
                             const qn_wall_contact *old, int old_count)
{
    enum { ROOM = 32 };
    workspace *work = share->workspace;
    qn_wall_hit hits[ROOM];
    uint32_t taken = 0;
    const qn_place *p = &w->place[i];
    qn_vec3 centre = qn_v3(p->x, p->y, p->z);
    int count = qn_walls_touch(&w->walls, pose, centre, w->classes[p->klass].radius, hits, ROOM);
    if (count > ROOM)
        return qn_fail(QN_UNSTABLE, "particle %lld touches %d wall features at once, at most %d",
                       (long long)w->id[i], count, ROOM);
    for (int h = 0; h < count; h++) {
        QN_TRY(QN_RESERVE(share->walls_next, share->wall_next_room, share->wall_next_count + 1));
        int slot = share->wall_next_count++;
        share->walls_next[slot] =
            (qn_wall_contact){w->id[i], hits[h].feature, i,
                              wall_history(old, old_count, hits, count, h, centre, &taken),
                              last_normal(old, old_count, hits[h].feature)};
        int kind = hits[h].surface * w->class_count + p->klass;
        queue *q = &work->walls[kind];
        q->a[q->count] = i;
        q->slot[q->count] = slot;
        q->hit[q->count] = hits[h];
        if (++q->count == W) flush_walls(w, share, pose, kind, mode);
    }
    return QN_OK;
}

qn_status JOIN(qn_lanes_touches, QN_ISA)(qn_world *w, qn_share *share, const qn_pose *pose,
                                         qn_mode mode)
{
    int at = 0;
    share->wall_next_count = 0;
    for (int i = share->first; i < share->last; i++) {
        int from = at;
        while (at < share->wall_count && share->walls[at].index == i) at++;
        if (w->classes[w->place[i].klass].inverse_mass <= 0) continue;
        const qn_wall_contact *old = at > from ? share->walls + from : NULL;
        QN_TRY(touch_walls(w, share, pose, mode, i, old, at - from));
    }
    for (int k = 0; k < w->surface_count * w->class_count; k++)
        flush_walls(w, share, pose, k, mode);
    return QN_OK;
}
