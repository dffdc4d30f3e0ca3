// SPDX-License-Identifier: Apache-2.0
#include "world/population.h"
#include "world/history.h"
#include "world/neighbours.h"

#include <stdlib.h>

qn_status qn_population_reserve(qn_world *w, int64_t wanted)
{
    int64_t room = w->room;
    if (wanted <= room) return QN_OK;
    QN_TRY(qn_reserve((void **)&w->place, &room, wanted, sizeof *w->place));
    room = w->room;
    QN_TRY(qn_reserve((void **)&w->motion, &room, wanted, sizeof *w->motion));
    room = w->room;
    QN_TRY(qn_reserve((void **)&w->load, &room, wanted, sizeof *w->load));
    room = w->room;
    QN_TRY(qn_reserve((void **)&w->id, &room, wanted, sizeof *w->id));
    if (w->body_of) {
        room = w->room;
        QN_TRY(qn_reserve((void **)&w->body_of, &room, wanted, sizeof *w->body_of));
    }
    w->room = room;
    return QN_OK;
}

// Closes the gaps that those who are gone leave; `to` as below.
static void close_gaps(qn_world *w, const int32_t *to)
{
    for (int i = 0; i < w->count; i++) {
        int at = to[i];
        if (at < 0) continue;
        w->place[at] = w->place[i];
        w->place[at].home = at;
        w->motion[at] = w->motion[i];
        w->id[at] = w->id[i];
    }
}

// What is kept of the velocity is that before step n, at which gravity alone acts.
static void add(qn_world *w, const qn_seedling *s, int64_t id)
{
    int i = w->count++;
    double z = s->position.z;
    if (w->period > 0) z = floor(z / w->lattice + 0.5) * w->lattice;
    qn_kept v = qn_scheme_begin(w->def.scheme, s->velocity, w->gravity, w->dt);
    if (w->body_of) w->body_of[i] = -1;
    w->place[i] = (qn_place){s->position.x, s->position.y, z, s->klass, i};
    w->motion[i] = (qn_motion){v.velocity, s->spin, v.kick, {0, 0, 0}};
    w->id[i] = id;
}

static qn_status change(qn_world *w, int32_t *to, int kept, const qn_seedling *fresh,
                        int fresh_count, int64_t first_id)
{
    QN_TRY(qn_population_reserve(w, (int64_t)kept + fresh_count));
    QN_TRY(qn_history_move(w, to, kept + fresh_count));
    close_gaps(w, to);
    w->count = kept;
    for (int k = 0; k < fresh_count; k++) add(w, &fresh[k], first_id + k);
    w->neighbours->stale = true;
    return QN_OK;
}

qn_status qn_population_change(qn_world *w, const bool *gone, const qn_seedling *fresh,
                               int fresh_count, int64_t first_id)
{
    int32_t *to;  // new index of each old one, -1 for those who are gone
    int kept = 0;
    QN_TRY(QN_ALLOCATE(to, w->count));
    for (int i = 0; i < w->count; i++) to[i] = gone && gone[i] ? -1 : kept++;
    qn_status status = change(w, to, kept, fresh, fresh_count, first_id);
    free(to);
    return status;
}
