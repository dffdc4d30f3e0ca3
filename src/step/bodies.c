// SPDX-License-Identifier: Apache-2.0
#include "step/bodies.h"
#include "world/bodies.h"
#include "world/neighbours.h"

static qn_vec3 in_units(double unit, const int64_t quanta[3])
{
    return qn_v3(unit * (double)quanta[0], unit * (double)quanta[1], unit * (double)quanta[2]);
}

void qn_bodies_load(qn_world *w)
{
    if (w->body_count == 0) return;
#pragma omp parallel for schedule(static) num_threads(w->neighbours->share_count)
    for (int n = 0; n < w->body_count; n++) {
        qn_body *b = &w->bodies[n];
        const qn_grain *g = &w->grains[b->grain];
        b->force = b->torque = qn_v3(0, 0, 0);
        for (int k = 0; k < g->count; k++) {
            const qn_load *load = &w->load[w->members[b->first + k]];
            const qn_class *c = &w->classes[g->klass[k]];
            qn_vec3 force = in_units(c->force_unit, load->force);
            qn_vec3 torque = in_units(c->torque_unit, load->torque);
            b->force = qn_add(b->force, force);
            b->torque = qn_add(b->torque, torque);
            b->torque = qn_add(b->torque, qn_cross(qn_body_lever(w, b, k), force));
        }
    }
}

// Orientation a time dt (s) later, under the motion of the half step in between.
static qn_quat turned(const qn_grain *g, const qn_body *b, double dt)
{
    return g->is_round ? qn_round_turn(b->orientation, b->spin, dt)
                       : qn_free_turn(b->orientation, b->momentum, g->inverse_moments, dt);
}

// What a body keeps of its rotation: a round one its spin, any other its angular momentum.
static qn_kept rotation_of(const qn_grain *g, const qn_body *b)
{
    qn_kept spin = {b->spin, b->spin_kick}, momentum = {b->momentum, b->momentum_kick};
    return g->is_round ? spin : momentum;
}

static qn_vec3 rotation_rate(const qn_world *w, const qn_grain *g, const qn_body *b)
{
    return g->is_round ? qn_body_round_acceleration(w, b) : b->torque;
}

static void keep_rotation(const qn_grain *g, qn_body *b, qn_kept kept)
{
    double inertia = g->is_round ? g->moments.x : 1;
    if (g->is_round) b->spin = kept.velocity, b->spin_kick = kept.kick;
    b->momentum = qn_scale(inertia, kept.velocity);
    b->momentum_kick = qn_scale(inertia, kept.kick);
}

// Spin over a step that turned the body from one orientation to another, and the kick to the predicted
// spin at its end. A round body has both already.
static void predict(const qn_grain *g, qn_body *b, qn_quat from, qn_quat to)
{
    if (g->is_round) return;
    qn_vec3 before = qn_tensor_times(from, g->inverse_moments, b->momentum);
    qn_vec3 after = qn_tensor_times(to, g->inverse_moments, b->momentum);
    b->spin = qn_scale(0.5, qn_add(before, after));
    qn_vec3 next = qn_add(b->momentum, b->momentum_kick);
    b->spin_kick = qn_sub(qn_tensor_times(to, g->inverse_moments, next), b->spin);
}

// Motion of a sphere that was at `from` and is at `to` from the body's centre (m).
static void move_sphere(const qn_world *w, const qn_body *b, qn_vec3 from, qn_vec3 to, qn_motion *m)
{
    qn_vec3 swing = qn_scale(1 / w->dt, qn_sub(to, from));
    qn_vec3 now = qn_cross(qn_add(b->spin, b->spin_kick), to);
    m->velocity = qn_add(b->velocity, swing);
    m->kick = qn_add(b->kick, qn_sub(now, swing));
    m->spin = b->spin;
    m->spin_kick = b->spin_kick;
}

void qn_bodies_begin(qn_world *w)
{
    for (int n = 0; n < w->body_count; n++) {
        qn_body *b = &w->bodies[n];
        const qn_grain *g = &w->grains[b->grain];
        if (g->inverse_mass <= 0) continue;
        qn_scheme scheme = w->def.scheme;
        qn_kept v = qn_scheme_begin(scheme, b->velocity, qn_body_acceleration(w, b), w->dt);
        b->velocity = v.velocity, b->kick = v.kick;
        qn_vec3 start = rotation_of(g, b).velocity;
        keep_rotation(g, b, qn_scheme_begin(scheme, start, rotation_rate(w, g, b), w->dt));
        qn_quat before = turned(g, b, -w->dt);
        predict(g, b, before, b->orientation);
        for (int k = 0; k < g->count; k++)
            move_sphere(w, b, qn_turned(before, g->lever[k]), qn_body_lever(w, b, k),
                        &w->motion[w->members[b->first + k]]);
    }
}

static void advance(qn_world *w, qn_body *b)
{
    const qn_grain *g = &w->grains[b->grain];
    qn_vec3 from[QN_SPHERES_MAX], to[QN_SPHERES_MAX];
    qn_scheme scheme = w->def.scheme;
    qn_kept v = {b->velocity, b->kick};
    qn_quat before = b->orientation;
    v = qn_scheme_advance(scheme, v, qn_body_acceleration(w, b), w->dt);
    b->velocity = v.velocity, b->kick = v.kick;
    keep_rotation(g, b,
                  qn_scheme_advance(scheme, rotation_of(g, b), rotation_rate(w, g, b), w->dt));
    b->position.x += w->dt * b->velocity.x;
    b->position.y += w->dt * b->velocity.y;
    b->position.z += qn_lattice_round(w, w->dt * b->velocity.z);
    for (int k = 0; k < g->count; k++) from[k] = qn_body_lever(w, b, k);
    b->orientation = turned(g, b, w->dt);
    predict(g, b, before, b->orientation);
    qn_body_place(w, b, to);
    for (int k = 0; k < g->count; k++)
        move_sphere(w, b, from[k], to[k], &w->motion[w->members[b->first + k]]);
}

// Whether a body's spheres have used up half the skin, and whether one is too fast.
static void look(const qn_world *w, const qn_body *b, double fast, int *spent, int *unsound)
{
    double half_skin2 = 0.25 * w->neighbours->skin * w->neighbours->skin;
    for (int k = 0; k < w->grains[b->grain].count; k++) {
        int i = w->members[b->first + k];
        const qn_place *p = &w->place[i];
        const qn_anchor *anchor = &w->neighbours->anchor[i];
        double x = p->x - anchor->x, y = p->y - anchor->y, z = p->z - anchor->z;
        const qn_vec3 v = w->motion[i].velocity;
        *spent |= !(x * x + y * y + z * z <= half_skin2);
        *unsound |= !(qn_dot(v, v) <= fast * fast);
    }
}

void qn_bodies_advance(qn_world *w, double fast, int *spent, int *unsound)
{
    int all_spent = 0, all_unsound = 0;
    if (w->body_count == 0) return;
#pragma omp parallel for schedule(static) num_threads(w->neighbours->share_count) \
    reduction(|                                                                   \
              : all_spent, all_unsound)
    for (int n = 0; n < w->body_count; n++) {
        qn_body *b = &w->bodies[n];
        if (w->grains[b->grain].inverse_mass <= 0) continue;
        advance(w, b);
        look(w, b, fast, &all_spent, &all_unsound);
    }
    *spent |= all_spent;
    *unsound |= all_unsound;
}
