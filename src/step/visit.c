// SPDX-License-Identifier: Apache-2.0
// Looking at single contacts, for traces. Slow and plain: every pair of the list is looked at.
#include "step/flow.h"
#include "step/step.h"
#include "world/neighbours.h"

// The contact of a (lower id) and b, places already known to touch. A history that has been moved on
// by this step's forces is not moved on again: no time passes. The point is seen from a's place within
// the period, as which image of a pair is listed depends on when the list was built.
static qn_reply look(const qn_world *w, int a, int b, qn_memory memory, qn_vec3 *point)
{
    const qn_place *pa = &w->place[a], *pb = &w->place[b];
    const qn_motion *ma = &w->motion[pa->home], *mb = &w->motion[pb->home];
    int classes = pa->klass * w->class_count + pb->klass;
    qn_pair pair = w->pairs[classes];
    qn_touch t = {qn_v3(pa->x - pb->x, pa->y - pb->y, pa->z - pb->z),
                  qn_sub(ma->velocity, mb->velocity),
                  qn_sub(ma->kick, mb->kick),
                  ma->spin,
                  mb->spin,
                  ma->spin_kick,
                  mb->spin_kick,
                  memory,
                  {0, 0, 0}};
    qn_reply r;
    if (w->committed) pair.dt = 0;
    qn_contact_evaluate(w->laws[classes], &pair, &w->reaches[classes], &t, &r);
    double arm = w->classes[pa->klass].radius - 0.5 * r.depth;
    *point = qn_madd(qn_world_position(w, pa->home), -arm, r.normal);
    return r;
}

static void visit_pairs(const qn_world *w, int which, qn_contact_visit *visit, void *user)
{
    const qn_neighbours *nb = w->neighbours;
    for (int s = 0; s < nb->share_count; s++) {
        const qn_share *share = &nb->shares[s];
        for (int64_t k = 0, i = share->first; k < share->pair_count; k++) {
            while (k >= share->row[i - share->first + 1]) i++;
            bool lower;
            int j = qn_partner(share, k, &lower), mine = (int)i;
            if (mine != which && w->place[j].home != which) continue;
            const qn_place *p = &w->place[mine], *q = &w->place[j];
            double x = p->x - q->x, y = p->y - q->y, z = p->z - q->z;
            if (!(x * x + y * y + z * z < nb->touch2[p->klass * w->class_count + q->klass]))
                continue;
            qn_vec3 point;
            qn_reply r =
                look(w, lower ? j : mine, lower ? mine : j, qn_memory_of(share, k), &point);
            int high = lower ? mine : w->place[j].home;
            if (high == which) {
                r.normal = qn_scale(-1, r.normal);  // as side b sees it
                r.tangential = qn_scale(-1, r.tangential);
            }
            int other = mine == which ? w->place[j].home : mine;
            visit(user, w->id[which], w->id[other], &r, point);
        }
    }
}

static void visit_walls(const qn_world *w, int which, qn_contact_visit *visit, void *user)
{
    enum { ROOM = 32 };
    qn_wall_hit hits[ROOM];
    const qn_neighbours *nb = w->neighbours;
    const qn_place *p = &w->place[which];
    const qn_motion *m = &w->motion[which];
    qn_pose pose = qn_walls_pose(&w->walls, qn_world_time(w));
    qn_vec3 centre = qn_world_position(w, which);
    double radius = w->classes[p->klass].radius;
    int count = qn_walls_touch(&w->walls, &pose, centre, radius, hits, ROOM);
    const qn_share *share = nb->shares;
    while (which >= share->last) share++;
    const qn_wall_contact *list = w->committed ? share->walls : share->walls_next;
    int listed = w->committed ? share->wall_count : share->wall_next_count;
    for (int h = 0; h < count && h < ROOM; h++) {
        const qn_frame *frame = &pose.frames[hits[h].body];
        int kind = hits[h].surface * w->class_count + p->klass;
        qn_pair pair = w->wall_pairs[kind];
        qn_reach reach = {radius, radius, 0, 1, 0};
        qn_vec3 wall = qn_frame_velocity(frame, hits[h].point);
        qn_touch t = {qn_sub(centre, hits[h].point),
                      qn_sub(m->velocity, wall),
                      m->kick,
                      m->spin,
                      qn_scale(frame->speed, frame->axis),
                      m->spin_kick,
                      {0, 0, 0},
                      {{0, 0, 0}, {0, 0, 0}},
                      {0, 0, 0}};
        qn_reply r;
        for (int k = 0; k < listed; k++)
            if (list[k].index == which && list[k].feature == hits[h].feature)
                t.memory = list[k].memory;
        pair.dt = 0;
        qn_contact_evaluate(w->wall_laws[kind], &pair, &reach, &t, &r);
        r.elastic *= hits[h].share, r.damping *= hits[h].share, r.push *= hits[h].share;
        r.stored_normal *= hits[h].share, r.stored_tangential *= hits[h].share;
        r.tangential = qn_scale(hits[h].share, r.tangential);
        visit(user, w->id[which], -1 - hits[h].part, &r, hits[h].point);
    }
}

// Adds the elastic energy of a contact, in quanta.
typedef struct stored {
    int64_t sum;
    double unit;  // J
} stored;

static void add_stored(void *user, int64_t id, int64_t partner, const qn_reply *r, qn_vec3 point)
{
    stored *s = user;
    (void)id, (void)partner, (void)point;
    s->sum += llrint((r->stored_normal + r->stored_tangential) / s->unit);
}

int64_t qn_flow_stored(const qn_world *w, const bool *marked, double unit)
{
    const qn_neighbours *nb = w->neighbours;
    stored s = {0, unit};
    for (int t = 0; t < nb->share_count; t++) {
        const qn_share *share = &nb->shares[t];
        for (int i = share->first; i < share->last; i++)
            for (int64_t k = share->row[i - share->first]; k < share->row[i - share->first + 1];
                 k++) {
                bool lower;
                int j = qn_partner(share, k, &lower);
                qn_vec3 point;
                if (!share->touching[k] || !(marked[i] || marked[w->place[j].home])) continue;
                qn_reply r = look(w, lower ? j : i, lower ? i : j, qn_memory_of(share, k), &point);
                add_stored(&s, 0, 0, &r, point);
            }
    }
    for (int i = 0; i < w->count; i++)
        if (marked[i]) visit_walls(w, i, add_stored, &s);
    return s.sum;
}

qn_status qn_step_visit(qn_world *w, int64_t id, qn_contact_visit *visit, void *user)
{
    int which = 0;
    while (which < w->count && w->id[which] != id) which++;
    if (which == w->count) return qn_fail(QN_INPUT, "there is no particle %lld", (long long)id);
    visit_pairs(w, which, visit, user);
    visit_walls(w, which, visit, user);
    return QN_OK;
}
