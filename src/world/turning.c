// SPDX-License-Identifier: Apache-2.0
#include "world/turning.h"

qn_status qn_turning_create(qn_world *w)
{
    bool any = false;
    int part = w->walls.group_part;
    for (int c = 0; c < w->class_count; c++) {
        qn_class *k = &w->classes[c];
        if (!k->turning) continue;
        bool first = c == 0 || w->classes[c - 1].group != k->group;
        k->part = first ? part++ : w->classes[c - 1].part;
        any = true;
    }
    if (!any) return QN_OK;
    qn_frame drum = qn_walls_frame(&w->walls, w->walls.drum_body, 0);
    QN_TRY(QN_ALLOCATE(w->rest, w->count));
    for (int i = 0; i < w->count; i++) {
        w->rest[w->id[i] - 1] = qn_v3(w->place[i].x, w->place[i].y, w->place[i].z);
        if (w->classes[w->place[i].klass].turning) qn_turning_put(w, &drum, i);
    }
    return QN_OK;
}

// As for the walls (kernel.c): the velocity half a step ago is that of now less the acceleration times
// dt/2, and the rest of the way to now is the kick. The same for the spin.
void qn_turning_put(qn_world *w, const qn_frame *drum, int i)
{
    qn_place *p = &w->place[i];
    qn_motion *m = &w->motion[i];
    qn_vec3 x = qn_frame_leave(drum, w->rest[w->id[i] - 1]);
    double spin_kick = 0.5 * w->dt * drum->slope;
    p->x = x.x, p->y = x.y;
    m->kick = qn_scale(0.5 * w->dt, qn_frame_acceleration(drum, x));
    m->velocity = qn_sub(qn_frame_velocity(drum, x), m->kick);
    m->spin = qn_scale(drum->speed - spin_kick, drum->axis);
    m->spin_kick = qn_scale(spin_kick, drum->axis);
}

qn_vec3 qn_turning_force(const qn_world *w, int i)
{
    const qn_load *load = &w->load[i];
    double unit = w->classes[w->place[i].klass].force_unit;
    return qn_v3(-unit * (double)load->force[0], -unit * (double)load->force[1],
                 -unit * (double)load->force[2]);
}

double qn_turning_torque(const qn_world *w, int i)
{
    const qn_place *p = &w->place[i];
    qn_vec3 force = qn_turning_force(w, i);
    double couple = w->classes[p->klass].torque_unit * (double)w->load[i].torque[2];
    return p->x * force.y - p->y * force.x - couple;
}
