// SPDX-License-Identifier: Apache-2.0
// The world: everything that exists in a simulation at one step.
//
// Particles are kept in three records of the size the inner loop wants, sorted along a space-filling
// curve and re-sorted at every list rebuild: an index is good until the next step, an id for ever.
// A ball is body and sphere in one; clumps have a table of their own (body.h). Positions are those of
// step n; velocities those that moved them there, v(n - 1/2) in the leapfrog, with the kick that
// predicts step n beside them (physics/scheme.h).
//
// Forces are summed as integers, each particle class with its own quantum: the sum does not depend
// on its order, hence not on threads, list or chunks, and a checkpoint needs no list.
#ifndef QN_WORLD_WORLD_H
#define QN_WORLD_WORLD_H

#include "base/array.h"
#include "physics/contact.h"
#include "world/body.h"
#include "world/def.h"
#include "world/ledger.h"
#include "world/walls.h"
#include "world/wear.h"

/// Spheres of one material and size: balls, or spheres of clumps. There is one for each size of each
/// group, in their order; then come those for clumps' spheres of other radii.
typedef struct qn_class {
    int group, size;  //        in the definition
    int material;
    int grain;                             //   index of the clump it is part of; -1 for a ball
    double radius, mass, inertia;          // m, kg, kg m2   a clump's mass, mean principal moment
    double inverse_mass, inverse_inertia;  // 0 where fixed or turning
    bool turning;                          //        with the drum (turning.h)
    int part;                              //        of the walls, where turning
    double bound;   // m    radius of the sphere around the whole body; the radius of a ball
    double volume;  // m3   of the body; that of a clump is shared out among its spheres
    double
        least_mass;  // kg   that a contact can feel: of a clump hit off its centre, less than mass
    double force_unit, torque_unit;  // N, N m   quantum of the integer sums, powers of two
} qn_class;

/// Where a particle is: what the distance check reads. 32 bytes.
typedef struct qn_place {
    double x, y, z;  // m
    int32_t klass;   //     index of its class
    int32_t home;    //     index of the particle itself; for a periodic image, of its original
} qn_place;

/// How a particle moves. 96 bytes.
typedef struct qn_motion {
    qn_vec3 velocity, spin;   // m/s, rad/s   at step n - 1/2
    qn_vec3 kick, spin_kick;  // m/s, rad/s   a(n-1) dt/2: predicts step n
} qn_motion;

/// What acts on a particle, in quanta of its class.
typedef struct qn_load {
    int64_t force[3], torque[3];
} qn_load;

/// A touching pair as it is kept between list rebuilds and on file.
typedef struct qn_contact {
    int64_t low, high;  //    ids
    qn_memory memory;   //    acting on the low one
} qn_contact;

/// A particle touching a wall feature, as it is kept between steps and on file.
typedef struct qn_wall_contact {
    int64_t id;       //    of the particle
    int32_t feature;  //    walls.h
    int32_t index;    //    present index of the particle
    qn_memory memory;
    qn_vec3 normal;  // 1  from the wall to the particle, at the last step
} qn_wall_contact;

typedef struct qn_neighbours qn_neighbours;  // world/neighbours.h
typedef struct qn_flow qn_flow;              // world/flow.h

typedef struct qn_world {
    // Fixed for the run.
    qn_def def;       //       owned copy of the small things; its arrays moved here
    double dt;        // s
    qn_vec3 gravity;  // m/s2
    double period;    // m     length of the periodic axis z; 0 for none
    double lattice;   // m     positions along a periodic axis are multiples of lattice
    int class_count, surface_count, grain_count;
    qn_class *classes;        //       owned
    qn_grain *grains;         //       owned
    qn_law *laws;             //       owned; [class_a * class_count + class_b]
    bool rolls;               //       some law's rolling model remembers a moment
    qn_pair *pairs;           //       owned; as laws
    qn_reach *reaches;        //       owned; as laws
    qn_law *wall_laws;        //       owned; [surface * class_count + class]
    qn_pair *wall_pairs;      //       owned; as wall_laws
    double energy_unit;       // J     quantum of the energy sums, a power of two
    double part_torque_unit;  // N m   quantum of the wall parts' torque sums, likewise
    double part_force_unit;   // N     and of their force sums
    double largest_radius, smallest_radius;  // m
    qn_walls walls;                          //       owned

    // The state at step `step`.
    int64_t step;
    int count;          //       particles
    int64_t room;       //       capacity of the arrays, images included
    qn_place *place;    //       owned; count, then periodic images
    qn_motion *motion;  //       owned
    qn_load *load;      //       owned
    int64_t *id;        //       owned; from 1, never reused
    qn_vec3 *rest;      // m     owned; by id - 1: where it was at step 0; NULL if none turns
    int body_count;     //       clumps, in the order of their ids
    int member_count;   //       their spheres
    qn_body *bodies;    //       owned
    int32_t *members;   //       owned; present index of each sphere of each body
    double *shift;      // m     owned; of those spheres, periods that wrapping has put between
    int32_t *body_of;   //       owned; by sphere, -1 for a ball; NULL in a world of balls
    qn_ledger ledger;   //       owned; energies lost and work done since step 0
    qn_wear wear;       //       owned; what the walls' facets have suffered since step 0
    qn_neighbours *neighbours;  //       owned; the pair list, with the contacts' history
    qn_flow *flow;              //       owned; feeds and outlets, NULL without
    int threads;
    bool started;    //       velocities are half a step back (qn_step_begin)
    bool committed;  //       this step's forces have moved the histories on
} qn_world;

/// Builds the world a definition describes: derives classes and pairs, packs the particles. Takes over the definition's arrays and leaves it empty.
/// Returns QN_INPUT with a sentence where the definition can't be met; *world is then untouched.
/// `threads`: 0 for as many as there are processors. Cost: O(particles).
QN_NODISCARD qn_status qn_world_create(qn_def *def, int threads, qn_world **world);

/// Releases everything; accepts NULL.
void qn_world_destroy(qn_world *world);

/// Time of the present step (s).
static inline double qn_world_time(const qn_world *world)
{
    return (double)world->step * world->dt;
}

/// Centre of particle i (m), within the period along a periodic axis.
static inline qn_vec3 qn_world_position(const qn_world *world, int i)
{
    const qn_place *p = &world->place[i];
    double z = p->z;
    if (world->period > 0) z -= floor(z / world->period) * world->period;
    return qn_v3(p->x, p->y, z);
}

/// Index of the body that sphere i is part of; -1 for a ball.
static inline int qn_body_of(const qn_world *w, int i)
{
    return w->body_of ? w->body_of[i] : -1;
}

/// Number of particles: balls and clumps.
static inline int qn_world_particles(const qn_world *w)
{
    return w->count - w->member_count + w->body_count;
}

/// What all facets of a part of the walls have suffered (J). Cost: O(facets of the part).
double qn_walls_worn(const qn_world *world, int part, int which);

/// Acceleration (m/s2) and angular acceleration (rad/s2) of ball i at the present step; valid
/// between qn_step_forces() and qn_step_advance().
static inline qn_vec3 qn_acceleration(const qn_world *w, int i)
{
    const qn_class *c = &w->classes[w->place[i].klass];
    const qn_load *f = &w->load[i];
    double s = c->force_unit * c->inverse_mass;
    qn_vec3 a = qn_v3(s * (double)f->force[0], s * (double)f->force[1], s * (double)f->force[2]);
    return c->inverse_mass > 0 ? qn_add(a, w->gravity) : a;
}

static inline qn_vec3 qn_angular_acceleration(const qn_world *w, int i)
{
    const qn_class *c = &w->classes[w->place[i].klass];
    const qn_load *f = &w->load[i];
    double s = c->torque_unit * c->inverse_inertia;
    return qn_v3(s * (double)f->torque[0], s * (double)f->torque[1], s * (double)f->torque[2]);
}

/// The same of a clump's centre, and of a clump whose moments are equal.
static inline qn_vec3 qn_body_acceleration(const qn_world *w, const qn_body *b)
{
    double inverse = w->grains[b->grain].inverse_mass;
    qn_vec3 a = qn_scale(inverse, b->force);
    return inverse > 0 ? qn_add(a, w->gravity) : a;
}

static inline qn_vec3 qn_body_round_acceleration(const qn_world *w, const qn_body *b)
{
    return qn_scale(w->grains[b->grain].inverse_moments.x, b->torque);
}

/// Velocity (m/s) and spin (rad/s) of a clump at the present step itself; as qn_velocity_now().
static inline qn_vec3 qn_body_velocity_now(const qn_world *w, const qn_body *b)
{
    qn_kept kept = {b->velocity, b->kick};
    return qn_scheme_now(w->def.scheme, kept, qn_body_acceleration(w, b), w->dt);
}

static inline qn_vec3 qn_body_spin_now(const qn_world *w, const qn_body *b)
{
    const qn_grain *g = &w->grains[b->grain];
    qn_kept spin = {b->spin, b->spin_kick}, momentum = {b->momentum, b->momentum_kick};
    if (g->is_round)
        return qn_scheme_now(w->def.scheme, spin, qn_body_round_acceleration(w, b), w->dt);
    return qn_tensor_times(b->orientation, g->inverse_moments,
                           qn_scheme_now(w->def.scheme, momentum, b->torque, w->dt));
}

/// Centre of a clump (m), within the period along a periodic axis.
static inline qn_vec3 qn_body_position(const qn_world *w, const qn_body *b)
{
    double z = b->position.z;
    if (w->period > 0) z -= floor(z / w->period) * w->period;
    return qn_v3(b->position.x, b->position.y, z);
}

/// From a clump's centre to its sphere k (m), at the present step.
static inline qn_vec3 qn_body_lever(const qn_world *w, const qn_body *b, int k)
{
    return qn_turned(b->orientation, w->grains[b->grain].lever[k]);
}

/// Velocity (m/s) and spin (rad/s) of particle i at the present step itself, from the half step
/// before and the forces of now; valid between qn_step_forces() and qn_step_advance().
static inline qn_vec3 qn_velocity_now(const qn_world *w, int i)
{
    if (qn_body_of(w, i) >= 0) {
        const qn_body *b = &w->bodies[w->body_of[i]];
        qn_vec3 lever = qn_body_lever(w, b, (int)(w->id[i] - b->id));
        return qn_add(qn_body_velocity_now(w, b), qn_cross(qn_body_spin_now(w, b), lever));
    }
    qn_kept kept = {w->motion[i].velocity, w->motion[i].kick};
    return qn_scheme_now(w->def.scheme, kept, qn_acceleration(w, i), w->dt);
}

static inline qn_vec3 qn_spin_now(const qn_world *w, int i)
{
    if (qn_body_of(w, i) >= 0) return qn_body_spin_now(w, &w->bodies[w->body_of[i]]);
    qn_kept kept = {w->motion[i].spin, w->motion[i].spin_kick};
    return qn_scheme_now(w->def.scheme, kept, qn_angular_acceleration(w, i), w->dt);
}

#endif
