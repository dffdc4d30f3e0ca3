// SPDX-License-Identifier: Apache-2.0
// Contacts of one share, eight at a time (kernel.h). Compiled once per instruction set, with QN_ISA
// naming it.
//
// Touching pairs are queued by their pair of classes, so that a block of eight shares one law and one
// set of coefficients; a full queue is gathered into columns, evaluated side by side (block.c), and
// added to the loads as integers.
#include "step/cpu/block.h"
#include "step/cpu/lanes.h"

#include <stdlib.h>
#include <string.h>

// Forces and torques as integers: side 0 feels the force, side 1 its opposite.
static void quantise(block *b, const qn_class *a, const qn_class *other)
{
    const double *force[3] = {b->force.x, b->force.y, b->force.z};
    const double *torque[2][3] = {{b->torque_a.x, b->torque_a.y, b->torque_a.z},
                                  {b->torque_b.x, b->torque_b.y, b->torque_b.z}};
    const qn_class *side[2] = {a, other};
    for (int s = 0; s < 2 && side[s]; s++) {
        double per_force = (s ? -1 : 1) / side[s]->force_unit;
        double per_torque = 1 / side[s]->torque_unit;
        for (int axis = 0; axis < 3; axis++)
            for (int l = 0; l < W; l++) {
                b->load[s][axis][l] = (int64_t)(force[axis][l] * per_force);
                b->load[s][3 + axis][l] = (int64_t)(torque[s][axis][l] * per_torque);
            }
    }
}

static void add_load(qn_load *to, const block *b, int side, int l)
{
    for (int axis = 0; axis < 3; axis++) {
        to->force[axis] += b->load[side][axis][l];
        to->torque[axis] += b->load[side][3 + axis][l];
    }
}

// Adds the first `count` lanes' energies, split into multiples of two units: adding and taking off a
// number so large that no smaller bits survive rounds to a multiple, hence these are sums of integers.
static void tally(const qn_world *w, qn_tally_sums *sums, const block *b, int count, double radius)
{
    double coarse = 1.5 * 0x1p52 * w->energy_unit, fine = coarse * 0x1p-26, deepest = 0;
    for (int e = 0; e < QN_TALLY_COUNT; e++)
        for (int l = 0; l < count; l++) {
            double units = (b->energy[e][l] + coarse) - coarse;
            sums->energy[e][l] += units;
            sums->remainder[e][l] += ((b->energy[e][l] - units) + fine) - fine;
        }
    for (int l = 0; l < count; l++) deepest = qn_max(deepest, b->depth[l]);
    sums->deepest = qn_max(sums->deepest, deepest / radius);
}

static qn_load *load_of(qn_world *w, qn_share *share, int home)
{
    return home >= share->first && home < share->last ? &w->load[home] : &share->spill[home];
}

// Three columns of a block, of one side or of side a less side b.
static void put_columns(columns3 *to, double (*from)[W])
{
    memcpy(to->x, from[0], sizeof to->x);
    memcpy(to->y, from[1], sizeof to->y);
    memcpy(to->z, from[2], sizeof to->z);
}

static void put_difference(columns3 *to, double (*a)[W], double (*b)[W])
{
    for (int l = 0; l < W; l++) to->x[l] = a[0][l] - b[0][l];
    for (int l = 0; l < W; l++) to->y[l] = a[1][l] - b[1][l];
    for (int l = 0; l < W; l++) to->z[l] = a[2][l] - b[2][l];
}

// Lays the pairs of a queue out in the columns of a block; a lane without a pair repeats the first.
static void gather_pairs(const qn_world *w, const qn_share *share, const queue *q, block *b)
{
    const double *place[2][W], *motion[2][W], *slip[W];
    double x[2][4][W], v[2][12][W], kept[4][W];
    for (int l = 0; l < W; l++) {
        int from = l < q->count ? l : 0;
        const qn_place *pa = &w->place[q->a[from]], *pb = &w->place[q->b[from]];
        place[0][l] = &pa->x, place[1][l] = &pb->x;
        motion[0][l] = (const double *)&w->motion[pa->home];
        motion[1][l] = (const double *)&w->motion[pb->home];
        slip[l] = &share->slip[q->slot[from]].x;
    }
    for (int side = 0; side < 2; side++) {
        qn_turn(place[side], x[side]);
        for (int part = 0; part < 3; part++) {
            qn_turn(motion[side], v[side] + 4 * part);
            for (int l = 0; l < W; l++) motion[side][l] += 4;
        }
    }
    qn_turn(slip, kept);
    put_difference(&b->between, x[0], x[1]);
    put_difference(&b->velocity, v[0], v[1]);
    put_columns(&b->spin_a, v[0] + 3);
    put_columns(&b->spin_b, v[1] + 3);
    put_difference(&b->kick, v[0] + 6, v[1] + 6);
    put_columns(&b->spin_kick_a, v[0] + 9);
    put_columns(&b->spin_kick_b, v[1] + 9);
    put_columns(&b->slip, kept);
    memset(&b->last, 0, sizeof b->last);
    if (!share->roll) return;
    for (int l = 0; l < W; l++) slip[l] = &share->roll[q->slot[l < q->count ? l : 0]].x;
    qn_turn(slip, kept);
    put_columns(&b->roll, kept);
}

// Evaluates the pairs queued for classes (a, b); a lane without a pair repeats the first.
static void flush_pairs(qn_world *w, qn_share *share, int classes, qn_mode mode)
{
    workspace *work = share->workspace;
    queue *q = &work->pairs[classes];
    block *b = &work->block;
    const qn_class *ca = &w->classes[classes / w->class_count];
    const qn_class *cb = &w->classes[classes % w->class_count];
    if (q->count == 0) return;
    gather_pairs(w, share, q, b);
    JOIN(qn_block_evaluate, QN_ISA)(w->laws[classes], &w->pairs[classes], &w->reaches[classes], b);
    quantise(b, ca, cb);
    for (int l = 0; l < q->count; l++) {
        add_load(load_of(w, share, w->place[q->a[l]].home), b, 0, l);
        add_load(load_of(w, share, w->place[q->b[l]].home), b, 1, l);
    }
    if (mode == QN_COMMIT)
        for (int l = 0; l < q->count; l++) {
            qn_memory_set(share, q->slot[l],
                          (qn_memory){GET(b->next_slip, l), GET(b->next_roll, l)});
            share->touching[q->slot[l]] = 1;
        }
    tally(w, share->sums, b, q->count, qn_min(ca->radius, cb->radius));
    share->sums->contacts += q->count;
    q->count = 0;
}

// Puts the pairs found to touch into their queues.
static void queue_pairs(qn_world *w, qn_share *share, int count, qn_mode mode)
{
    workspace *work = share->workspace;
    for (int t = 0; t < count; t++) {
        const touch *found = &work->touches[t];
        int classes = w->place[found->a].klass * w->class_count + w->place[found->b].klass;
        queue *waiting = &work->pairs[classes];
        int c = waiting->count++;
        waiting->a[c] = found->a, waiting->b[c] = found->b, waiting->slot[c] = found->slot;
        if (c == W - 1) flush_pairs(w, share, classes, mode);
    }
}

static void part(qn_share *share, int64_t k)
{
    share->touching[k] = 0;
    qn_memory_set(share, k, (qn_memory){{0, 0, 0}, {0, 0, 0}});
}

// The distance check of the whole list: pairs that touch are noted without a branch, as whether one does
// can't be foretold, and worked on some hundred at a time; those that no longer do forget.
static void all_pairs(qn_world *w, qn_share *share, qn_mode mode)
{
    workspace *work = share->workspace;
    const qn_place *place = w->place;
    const double *touch2 = w->neighbours->touch2;
    int n = w->class_count, found = 0;
    for (int i = share->first; i < share->last; i++) {
        const qn_place p = place[i];
        const double *reach2 = touch2 + (int64_t)p.klass * n;
        int64_t end = share->row[i - share->first + 1];
        for (int64_t k = share->row[i - share->first]; k < end; k++) {
            bool lower;
            int j = qn_partner(share, k, &lower);
            const qn_place *q = &place[j];
            double x = p.x - q->x, y = p.y - q->y, z = p.z - q->z;
            bool touches = x * x + y * y + z * z < reach2[q->klass];
            work->touches[found] = (touch){lower ? j : i, lower ? i : j, k};
            found += touches;
            if (share->touching[k] > touches && mode == QN_COMMIT) part(share, k);
            if (found == TOUCHES) queue_pairs(w, share, found, mode), found = 0;
        }
    }
    queue_pairs(w, share, found, mode);
    for (int c = 0; c < n * n; c++) flush_pairs(w, share, c, mode);
}

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

static qn_status all_walls(qn_world *w, qn_share *share, const qn_pose *pose, qn_mode mode)
{
    int at = 0;
    share->wall_next_count = 0;
    for (int i = share->first; i < share->last; i++) {
        int from = at;
        while (at < share->wall_count && share->walls[at].index == i) at++;
        if (w->classes[w->place[i].klass].inverse_mass <= 0) continue;
        QN_TRY(touch_walls(w, share, pose, mode, i, share->walls + from, at - from));
    }
    for (int k = 0; k < w->surface_count * w->class_count; k++)
        flush_walls(w, share, pose, k, mode);
    return QN_OK;
}

qn_status JOIN(qn_kernel_contacts, QN_ISA)(qn_world *w, qn_share *share, const qn_pose *pose,
                                           qn_mode mode);

qn_status JOIN(qn_kernel_contacts, QN_ISA)(qn_world *w, qn_share *share, const qn_pose *pose,
                                           qn_mode mode)
{
    all_pairs(w, share, mode);
    QN_TRY(all_walls(w, share, pose, mode));
    if (mode == QN_PROBE) return QN_OK;
    qn_wall_contact *walls = share->walls;
    int64_t room = share->wall_room;
    share->walls = share->walls_next, share->wall_room = share->wall_next_room;
    share->walls_next = walls, share->wall_next_room = room;
    share->wall_count = share->wall_next_count;
    return QN_OK;
}
