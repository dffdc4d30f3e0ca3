// SPDX-License-Identifier: Apache-2.0
// One ball sent at a rigid plane, or two balls at each other, for the collision experiments.
#ifndef QN_TESTS_IMPACTS_H
#define QN_TESTS_IMPACTS_H

#include "worlds.h"

/// A ball's material and radius.
typedef struct substance {
    const char *name;
    double young, poisson, density, radius;  // Pa, 1, kg/m3, m
} substance;

/// What a collision shows.
typedef struct impact {
    qn_motion after;            //        of ball 1
    double depth, force, time;  // m, N, s   largest overlap and normal force, duration
} impact;

/// Hertz's time of contact (s) against a rigid plane at v (m/s).
static inline double impact_time(const substance *s, double v)
{
    double k = 4.0 / 3 * s->young / (1 - s->poisson * s->poisson) * sqrt(s->radius);
    double mass = 4.0 / 3 * QN_PI * s->radius * s->radius * s->radius * s->density;
    return qn_impact_time(k, 1.5, mass, v, NULL);
}

/// The ball's material and one a million times stiffer; no gravity.
static inline qn_def impact_def(const substance *s, double friction, double e)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, friction, e);
    def.gravity = qn_v3(0, 0, 0);
    def.materials[0] = (qn_material_def){"ball", s->young, s->poisson, s->density};
    def.materials[1] = (qn_material_def){"rigid", s->young * 1e6, s->poisson, s->density};
    return def;
}

/// Lets whatever is about to touch touch and part.
static inline qn_status impact_collide(qn_world *w, impact *o)
{
    int steps = 0;
    *o = (impact){0};
    for (int i = 0; i < 10 || w->ledger.contacts_now + w->ledger.wall_contacts_now > 0; i++) {
        QN_TRY(qn_step_forces(w, QN_COMMIT));
        steps += w->ledger.contacts_now + w->ledger.wall_contacts_now > 0;
        double mass = w->classes[0].mass;
        o->force = qn_max(o->force, mass * fabs(qn_acceleration(w, 0).y));
        QN_TRY(qn_step_advance(w));
    }
    o->depth = w->ledger.deepest * w->classes[0].radius;
    o->time = steps * w->dt;
    o->after = w->motion[w->id[0] == 1 ? 0 : 1 % w->count];
    return QN_OK;
}

/// A ball with spin about z sent at the plane y = 0, 2000 steps a contact. The law is hertz-mindlin, or
/// what `law` says.
static inline qn_status impact_on_plane(const substance *s, const qn_law *law, double friction,
                                        double e, qn_vec3 velocity, double spin, impact *o)
{
    qn_world *w;
    qn_def def = impact_def(s, friction, e);
    if (law) def.contacts[1].law = *law;
    def.step = impact_time(s, -velocity.y) / 2000;
    add_plane(&def, "plate", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_ball(&def, 2 * s->radius, qn_v3(0, s->radius - 1.5 * def.step * velocity.y, 0), velocity)
        ->spin.z = spin;
    qn_status status = qn_world_create(&def, 1, &w);
    qn_def_free(&def);
    QN_TRY(status);
    status = impact_collide(w, o);
    qn_world_destroy(w);
    return status;
}

#endif
