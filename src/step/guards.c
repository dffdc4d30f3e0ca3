// SPDX-License-Identifier: Apache-2.0
#include "step/guards.h"
#include "world/bodies.h"
#include "world/classes.h"
#include "world/neighbours.h"

#include <stdio.h>

enum { WALL_HITS = 32 };  // places where one particle may touch walls

// The deepest overlap: of which particle, with what, at what distance.
typedef struct culprit {
    int index;
    double share;  // 1   of the smaller radius
    char partner[QN_PARTICLE_NAME];
} culprit;

/// Overlap of two particles, in radii of the smaller; negative where they are apart.
static double pair_depth(const qn_world *w, int i, int j)
{
    const qn_place *p = &w->place[i], *q = &w->place[j];
    double x = p->x - q->x, y = p->y - q->y, z = p->z - q->z;
    double a = w->classes[p->klass].radius, b = w->classes[q->klass].radius;
    return (a + b - sqrt(x * x + y * y + z * z)) / qn_min(a, b);
}

/// Where particle i touches walls at the present step; returns how many places.
static int walls_touched(const qn_world *w, int i, qn_wall_hit hits[WALL_HITS])
{
    qn_pose pose = qn_walls_pose(&w->walls, qn_world_time(w));
    const qn_place *p = &w->place[i];
    int count = qn_walls_touch(&w->walls, &pose, qn_v3(p->x, p->y, p->z),
                               w->classes[p->klass].radius, hits, WALL_HITS);
    return count < WALL_HITS ? count : WALL_HITS;
}

static void look_at_pairs(const qn_world *w, const qn_share *share, culprit *worst)
{
    for (int i = share->first; i < share->last; i++)
        for (int64_t k = share->row[i - share->first]; k < share->row[i - share->first + 1]; k++) {
            bool lower;
            int j = qn_partner(share, k, &lower);
            double deep = pair_depth(w, i, j);
            if (!(deep > worst->share)) continue;
            worst->index = i, worst->share = deep;
            qn_particle_name(w, w->place[j].home, worst->partner);
        }
}

static void look_at_walls(const qn_world *w, int i, culprit *worst)
{
    qn_wall_hit hits[WALL_HITS];
    const qn_place *p = &w->place[i];
    qn_vec3 centre = qn_v3(p->x, p->y, p->z);
    double radius = w->classes[p->klass].radius;
    int count = walls_touched(w, i, hits);
    for (int h = 0; h < count; h++) {
        double away = hypot(qn_norm(qn_sub(centre, hits[h].point)), hits[h].beyond);
        double deep = 1 - away / radius;
        if (!(deep > worst->share)) continue;
        worst->index = i, worst->share = deep;
        snprintf(worst->partner, sizeof worst->partner, "wall %s",
                 w->walls.parts[hits[h].part].name);
    }
}

/// How many particles and walls a particle touches: with more than one it may be squeezed.
static int touches_of(const qn_world *w, int index)
{
    int touches = 0;
    for (int t = 0; t < w->neighbours->share_count; t++) {
        const qn_share *share = &w->neighbours->shares[t];
        for (int i = share->first; i < share->last; i++)
            for (int64_t k = share->row[i - share->first]; k < share->row[i - share->first + 1];
                 k++) {
                bool lower;
                int j = qn_partner(share, k, &lower);
                if (i == index || j == index) touches += pair_depth(w, i, j) > 0;
            }
    }
    qn_wall_hit hits[WALL_HITS];
    return touches + walls_touched(w, index, hits);
}

qn_status qn_guard_overlap(qn_world *w)
{
    qn_ledger *ledger = &w->ledger;
    const qn_neighbours *nb = w->neighbours;
    if (ledger->deepest_now > ledger->deepest) {
        ledger->deepest = ledger->deepest_now;
        ledger->deepest_step = w->step;
    }
    if (ledger->deepest_now <= QN_OVERLAP_STOP) return QN_OK;
    culprit worst = {0, 0, "something"};
    char name[QN_PARTICLE_NAME];
    for (int t = 0; t < nb->share_count; t++) look_at_pairs(w, &nb->shares[t], &worst);
    for (int i = 0; i < w->count; i++)
        if (w->classes[w->place[i].klass].inverse_mass > 0) look_at_walls(w, i, &worst);
    const qn_place *p = &w->place[worst.index];
    return qn_fail(QN_UNSTABLE,
                   "%s overlaps %s by %.3g %% of its radius (allowed: %g %%), at "
                   "(%g, %g, %g) m with speed %g m/s, at %g s (step %lld): the materials are too "
                   "soft for such an impact, the time step (%g s) too long, or the particles were "
                   "placed into each other%s",
                   qn_particle_name(w, worst.index, name), worst.partner, 100 * worst.share,
                   100 * QN_OVERLAP_STOP, p->x, p->y, p->z,
                   qn_norm(w->motion[worst.index].velocity), qn_world_time(w), (long long)w->step,
                   w->dt,
                   touches_of(w, worst.index) > 1
                       ? ", or it is squeezed, as it touches more than one particle or wall"
                       : "");
}

qn_status qn_guard_speed(const qn_world *w, double limit)
{
    int which = -1;
    for (int i = 0; i < w->count; i++) {
        double speed = qn_norm(w->motion[i].velocity);
        if (!(speed <= limit) && (which < 0 || w->id[i] < w->id[which])) which = i;
    }
    if (which < 0) return QN_OK;
    const qn_place *p = &w->place[which];
    double speed = qn_norm(w->motion[which].velocity);
    char name[QN_PARTICLE_NAME];
    return qn_fail(QN_UNSTABLE,
                   "%s %s (%g m/s; a particle may move a fifth of the smallest radius in "
                   "one step, %g m/s) at (%g, %g, %g) m, at %g s (step %lld): the time step (%g s) "
                   "is too long or a contact has blown up",
                   qn_particle_name(w, which, name),
                   isfinite(speed) ? "is too fast" : "has a speed that is not a number", speed,
                   limit, p->x, p->y, p->z, qn_world_time(w), (long long)w->step, w->dt);
}
