// SPDX-License-Identifier: Apache-2.0
// Clumps in the step: against balls, against the theory of rigid bodies, and against themselves.
#include "check.h"
#include "worlds.h"

#include "measure/energy.h"
#include "measure/fields.h"

// A lump with three different moments, given along its axes: the longest along x, then y.
static int add_asymmetric(qn_def *def)
{
    const double centres[] = {1.5, 0, 0, -1.5, 0, 0, 0, 0.9, 0, 0, -0.9, 0};
    const double radii[] = {1, 1, 0.8, 0.8};
    return add_shape(def, centres, radii, 4);
}

static int add_tetrahedron(qn_def *def, double spacing)
{
    double centres[12], radii[4];
    qn_shape_tetrahedron(spacing, centres, radii);
    return add_shape(def, centres, radii, 4);
}

// ---- A clump of one sphere is a ball -------------------------------------------------------------

static qn_world *mill(int shape, int count, int threads, double skin, qn_ends ends)
{
    qn_world *world = NULL;
    const double origin[3] = {5, 6, 7}, radius = 0.7;
    qn_def def = def_of_mill(count, ends);
    qn_group_def *g = &def.groups[0];
    def.skin = skin;
    if (shape == 1) g->shape = add_shape(&def, origin, &radius, 1);
    if (shape == 4) g->shape = add_tetrahedron(&def, 1.1);
    if (shape == 5) g->shape = add_asymmetric(&def);
    g->turned_at_random = true;
    g->spin = qn_v3(20, -30, 40);
    if (shape > 1) g->velocity = qn_v3(0.4, -1, 0.5);
    if (shape > 1) def.step = 6e-6;
    if (qn_world_create(&def, threads, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

static void a_clump_of_one_sphere_moves_as_a_ball_to_the_bit(void)
{
    qn_world *balls = mill(0, 500, 2, 0, QN_ENDS_PERIODIC);
    qn_world *clumps = mill(1, 500, 2, 0, QN_ENDS_PERIODIC);
    qn_state a, b;
    CHECK(balls && clumps && clumps->body_count == 500 && balls->body_count == 0);
    CHECK_STATUS(take_steps(balls, 800));
    CHECK_STATUS(take_steps(clumps, 800));
    CHECK_STATUS(qn_world_export(balls, &a));
    CHECK_STATUS(qn_world_export(clumps, &b));
    CHECK(a.contact_count > 200 && a.wall_contact_count > 5);
    b.body_count = 0;
    CHECK(qn_state_hash(&a) == qn_state_hash(&b));
    CHECK(balls->ledger.lost[QN_TALLY_SLIDING] == clumps->ledger.lost[QN_TALLY_SLIDING]);
    b.body_count = 500;
    for (int k = 0; k < 1500; k++) CHECK(b.body_position[k] == b.position[k]);
    qn_state_free(&a), qn_state_free(&b);
    qn_world_destroy(balls), qn_world_destroy(clumps);
}

// One that starts in a wall, so that its first half kick, backwards, has something to do.
static void starts_as_a_ball(qn_scheme scheme)
{
    const double origin[3] = {0, 0, 0}, radius = 1;
    qn_state state[2];
    for (int k = 0; k < 2; k++) {
        qn_world *w;
        qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
        add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
        qn_group_def *g = add_ball(&def, 0.003, qn_v3(0, 0.00149, 0), qn_v3(0.1, 0, 0));
        g->spin = qn_v3(10, 20, 30);
        if (k == 1) g->shape = add_shape(&def, origin, &radius, 1);
        def.step = 1e-5;
        def.scheme = scheme;
        CHECK_STATUS(qn_world_create(&def, 1, &w));
        CHECK_STATUS(take_steps(w, 3));
        CHECK_STATUS(qn_world_export(w, &state[k]));
        CHECK(state[k].wall_contact_count == 1 && w->body_count == k);
        qn_world_destroy(w);
        state[k].body_count = 0;
    }
    CHECK(qn_state_hash(&state[0]) == qn_state_hash(&state[1]));
    for (int k = 0; k < 2; k++) qn_state_free(&state[k]);
}

static void a_clump_of_one_sphere_starts_as_a_ball_to_the_bit(void)
{
    for (int scheme = 0; scheme < QN_SCHEME_COUNT; scheme++) starts_as_a_ball((qn_scheme)scheme);
}

// ---- Determinism ---------------------------------------------------------------------------------

static void clumps_move_the_same_for_any_number_of_threads(void)
{
    for (int shape = 4; shape < 6; shape++) {
        uint64_t hash = 0;
        const int threads[] = {1, 2, 3, 8};
        for (int k = 0; k < 4; k++) {
            qn_world *world = mill(shape, 100, threads[k], 0, QN_ENDS_PERIODIC);
            CHECK(world);
            CHECK_STATUS(take_steps(world, 1000));
            if (k == 0) hash = hash_of(world);
            CHECK(hash_of(world) == hash && hash != 0);
            CHECK(world->ledger.contacts_now + world->ledger.wall_contacts_now > 10);
            qn_world_destroy(world);
        }
    }
}

static void clumps_do_not_feel_when_the_list_is_rebuilt(void)
{
    qn_world *thin = mill(5, 150, 2, 0.05, QN_ENDS_PERIODIC);
    qn_world *thick = mill(5, 150, 2, 0.6, QN_ENDS_PERIODIC);
    CHECK(thin && thick);
    CHECK_STATUS(take_steps(thin, 1500));
    CHECK_STATUS(take_steps(thick, 1500));
    CHECK(thin->neighbours->rebuilds > 2 * thick->neighbours->rebuilds);
    CHECK(hash_of(thin) == hash_of(thick));
    qn_world_destroy(thin), qn_world_destroy(thick);
}

static uint64_t resumed_at(int before, int threads)
{
    qn_world *world = mill(5, 100, 2, 0, QN_ENDS_PERIODIC);
    qn_world *other = mill(5, 100, threads, 0, QN_ENDS_PERIODIC);
    qn_state state;
    uint64_t hash = 0;
    if (qn_step_begin(world) == QN_OK && take_steps(world, before) == QN_OK
        && qn_world_export(world, &state) == QN_OK) {
        if (qn_world_import(other, &state) == QN_OK && hash_of(other) == qn_state_hash(&state)
            && take_steps(other, 900 - before) == QN_OK)
            hash = hash_of(other);
        qn_state_free(&state);
    }
    qn_world_destroy(world), qn_world_destroy(other);
    return hash;
}

static void clumps_resumed_at_any_step_go_on_to_the_bit(void)
{
    qn_world *world = mill(5, 100, 2, 0, QN_ENDS_PERIODIC);
    CHECK(world);
    CHECK_STATUS(take_steps(world, 900));
    uint64_t hash = hash_of(world);
    CHECK(world->neighbours->rebuilds > 5);
    qn_world_destroy(world);
    const int at[] = {0, 1, 7, 333, 700, 899};
    for (int k = 0; k < 6; k++) CHECK(resumed_at(at[k], 1 + k % 3) == hash);
}

// ---- The list ------------------------------------------------------------------------------------

// Touching pairs of spheres of different bodies, by trying all.
static int64_t touching_by_brute_force(const qn_world *w)
{
    int64_t n = 0;
    for (int i = 0; i < w->count; i++)
        for (int j = i + 1; j < w->count; j++) {
            double x = w->place[i].x - w->place[j].x, y = w->place[i].y - w->place[j].y;
            double z = w->place[i].z - w->place[j].z;
            if (w->period > 0) z -= w->period * floor(z / w->period + 0.5);
            double reach =
                w->classes[w->place[i].klass].radius + w->classes[w->place[j].klass].radius;
            n += w->body_of[i] != w->body_of[j] && x * x + y * y + z * z < reach * reach;
        }
    return n;
}

static void the_list_has_every_touching_pair_but_those_within_a_clump(void)
{
    qn_world *w = mill(5, 150, 2, 0.2, QN_ENDS_PERIODIC);
    int64_t most = 0;
    CHECK(w);
    for (int i = 0; i < 2000; i++) {
        CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
        if (i % 40 == 0) CHECK(w->ledger.contacts_now == touching_by_brute_force(w));
        most = w->ledger.contacts_now > most ? w->ledger.contacts_now : most;
        CHECK_STATUS(qn_step_advance(w));
    }
    CHECK(most > 50);
    for (int i = 0; i < w->count; i++) {  // spheres are where their bodies have them
        const qn_body *b = &w->bodies[w->body_of[i]];
        int k = (int)(w->id[i] - b->id);
        qn_vec3 lever = w->grains[b->grain].lever[k], at = qn_world_position(w, i);
        qn_vec3 apart = qn_sub(at, qn_body_position(w, b));
        apart.z -= w->period * floor(apart.z / w->period + 0.5);
        CHECK(w->members[b->first + k] == i);
        CHECK_NEAR(qn_norm(qn_sub(apart, qn_turned(b->orientation, lever))), 0, 1e-15);
    }
    qn_world_destroy(w);
}

// ---- Torque-free rotation ------------------------------------------------------------------------

// One lump in empty space, turning.
static qn_world *top(qn_vec3 spin, double dt)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    def.gravity = qn_v3(0, 0, 0);
    def.materials[0].youngs_modulus = 1e4;
    qn_group_def *g = add_ball(&def, 0.01, qn_v3(0, 0, 0), qn_v3(0.1, 0.2, 0.3));
    g->shape = add_asymmetric(&def);
    g->spin = spin;
    def.step = dt;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

// Jacobi's sn, cn, dn by descending Landen transformations: Abramowitz & Stegun (1964), 16.4.
static void jacobi(double u, double m, double *sn, double *cn, double *dn)
{
    double a[16], c[16], b = sqrt(1 - m), phi;
    int n = 0;
    a[0] = 1, c[0] = sqrt(m);
    while (fabs(c[n]) > 1e-16 && n < 14) {
        a[n + 1] = (a[n] + b) / 2, c[n + 1] = (a[n] - b) / 2;
        b = sqrt(a[n] * b);
        n++;
    }
    phi = ldexp(a[n] * u, n);
    for (; n > 0; n--) phi = (phi + asin(c[n] * sin(phi) / a[n])) / 2;
    *sn = sin(phi), *cn = cos(phi), *dn = sqrt(1 - m * *sn * *sn);
}

// Spin in the body's frame at a time, starting without a part along y. Landau & Lifshitz, Mechanics, 37.
static qn_vec3 euler_top(qn_vec3 moments, qn_vec3 start, double t)
{
    double i1 = moments.x, i2 = moments.y, i3 = moments.z, sn, cn, dn;
    double e2 = i1 * start.x * start.x + i3 * start.z * start.z;
    double m2 = i1 * i1 * start.x * start.x + i3 * i3 * start.z * start.z;
    double k2 = (i2 - i1) * (e2 * i3 - m2) / ((i3 - i2) * (m2 - e2 * i1));
    jacobi(t * sqrt((i3 - i2) * (m2 - e2 * i1) / (i1 * i2 * i3)), k2, &sn, &cn, &dn);
    return qn_v3(sqrt((e2 * i3 - m2) / (i1 * (i3 - i1))) * cn,
                 sqrt((e2 * i3 - m2) / (i2 * (i3 - i2))) * sn,
                 sqrt((m2 - e2 * i1) / (i3 * (i3 - i1))) * dn);
}

typedef struct flight {
    double spin_error;    // 1   largest difference to Euler's top, by the spin
    double energy_error;  // 1   largest change of the rotational energy
    double energy_end;    // 1   mean of that change over the last tenth
    qn_quat last;
} flight;

static qn_status fly(double dt, double time, flight *f)
{
    const qn_vec3 start = {60, 0, 80};
    qn_world *w = top(start, dt);
    const qn_grain *g = w->grains;
    const qn_body *b = w->bodies;
    int steps = (int)(time / dt + 0.5);
    double energy0 = 0;
    memset(f, 0, sizeof *f);
    for (int i = 0; i <= steps; i++) {
        QN_TRY(qn_step_forces(w, QN_COMMIT));
        qn_vec3 spin = qn_body_spin_now(w, b), body = qn_turned_back(b->orientation, spin);
        double energy = qn_dot(b->momentum, spin) / 2, size = qn_norm(start);
        if (i == 0) energy0 = energy;
        double off = energy / energy0 - 1;
        f->energy_error = qn_max(f->energy_error, fabs(off));
        if (i >= steps * 9 / 10) f->energy_end += off / (steps * 0.1);
        qn_vec3 theory = euler_top(g->moments, start, i * dt);
        f->spin_error = qn_max(f->spin_error, qn_norm(qn_sub(body, theory)) / size);
        f->last = b->orientation;
        QN_TRY(qn_step_advance(w));
    }
    qn_world_destroy(w);
    return QN_OK;
}

static double apart(qn_quat a, qn_quat b)
{
    return sqrt(qn_max(0, 2 - 2 * fabs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z)));
}

static void a_free_top_follows_eulers_solution_to_second_order(void)
{
    flight coarse, middle, fine;
    CHECK_STATUS(fly(4e-4, 0.4, &coarse));
    CHECK_STATUS(fly(2e-4, 0.4, &middle));
    CHECK_STATUS(fly(1e-4, 0.4, &fine));
    printf("  spin %.3g %.3g %.3g, energy %.3g %.3g %.3g\n", coarse.spin_error, middle.spin_error,
           fine.spin_error, coarse.energy_error, middle.energy_error, fine.energy_error);
    CHECK(fine.spin_error < 2e-3);
    CHECK_NEAR(coarse.spin_error / middle.spin_error, 4, 0.4);
    CHECK_NEAR(middle.spin_error / fine.spin_error, 4, 0.2);
    CHECK_NEAR(coarse.energy_error / middle.energy_error, 4, 0.4);
    CHECK_NEAR(middle.energy_error / fine.energy_error, 4, 0.2);
    CHECK_NEAR(apart(coarse.last, middle.last) / apart(middle.last, fine.last), 4, 0.5);
}

static void a_free_top_keeps_its_momentum_and_its_energy_does_not_drift(void)
{
    flight once, ten;
    CHECK_STATUS(fly(2e-4, 0.4, &once));
    CHECK_STATUS(fly(2e-4, 8, &ten));
    CHECK_NEAR(ten.energy_error, once.energy_error, 0.01 * once.energy_error);
    qn_world *w = top(qn_v3(60, 0, 80), 2e-4);
    CHECK_STATUS(take_steps(w, 1));
    const qn_body *b = w->bodies;
    qn_vec3 before = b->momentum;
    CHECK_STATUS(take_steps(w, 40000));
    CHECK(memcmp(&before, &b->momentum, sizeof before) == 0);
    const qn_quat q = b->orientation;
    CHECK_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-15);
    CHECK_NEAR(b->velocity.y, 0.2, 1e-15);
    CHECK_NEAR(b->position.y, 0.2 * 40001 * 2e-4, 1e-10);
    qn_world_destroy(w);
}

// The tennis racket: about the middle axis a body turns over, and over again.
static void a_top_on_its_middle_axis_turns_over(void)
{
    qn_world *w = top(qn_v3(0.01, 100, 0), 1e-4);
    double least = 1;
    int over = 0;
    bool up = true;
    for (int i = 0; i < 20000; i++) {
        CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
        const qn_body *b = w->bodies;
        double y = qn_turned_back(b->orientation, qn_body_spin_now(w, b)).y / 100;
        least = qn_min(least, y);
        if (up ? y < -0.9 : y > 0.9) up = !up, over++;
        CHECK_STATUS(qn_step_advance(w));
    }
    CHECK(least < -0.99999 && over >= 2);
    qn_world_destroy(w);
}

static void a_free_turn_runs_back_to_where_it_came_from(void)
{
    qn_quat first = qn_quat_unit(qn_quat_of(0.3, -0.5, 0.7, 0.2)), q = first;
    const qn_vec3 momentum = {0.3, 0.7, -0.4}, inverse = {1, 0.4, 2.5};
    for (int i = 0; i < 1000; i++) q = qn_free_turn(q, momentum, inverse, 0.05);
    CHECK(apart(q, first) > 0.01);
    for (int i = 0; i < 1000; i++) q = qn_free_turn(q, momentum, inverse, -0.05);
    CHECK_NEAR(q.w, first.w, 1e-12);
    CHECK_NEAR(q.x, first.x, 1e-12);
    CHECK_NEAR(q.y, first.y, 1e-12);
    CHECK_NEAR(q.z, first.z, 1e-12);
}

// What moved a sphere, and what its motion is predicted to be.
static void spheres_of_a_turning_clump_know_their_motion(void)
{
    qn_world *w = top(qn_v3(60, 30, 80), 1e-4);
    qn_vec3 before[4];
    CHECK_STATUS(take_steps(w, 100));
    const qn_body *b = w->bodies;
    for (int k = 0; k < 4; k++) before[k] = qn_world_position(w, w->members[k]);
    qn_quat q = b->orientation, q_before = qn_quat_of(q.w, -q.x, -q.y, -q.z);
    CHECK_STATUS(take_steps(w, 1));
    q = qn_quat_mul(b->orientation,
                    q_before);  // the turn of the step: sin(half its angle) along it
    CHECK_NEAR(q.x, sin(qn_norm(b->spin) * w->dt / 2) * b->spin.x / qn_norm(b->spin), 1e-7);
    CHECK_NEAR(q.y, sin(qn_norm(b->spin) * w->dt / 2) * b->spin.y / qn_norm(b->spin), 1e-7);
    CHECK_STATUS(qn_step_forces(w, QN_PROBE));
    for (int k = 0; k < 4; k++) {
        int i = w->members[k];
        const qn_motion *m = &w->motion[i];
        qn_vec3 step = qn_sub(qn_world_position(w, i), before[k]);
        CHECK_NEAR(qn_norm(qn_madd(step, -w->dt, m->velocity)), 0, 1e-15);
        qn_vec3 now = qn_velocity_now(w, i),
                swing = qn_cross(qn_spin_now(w, i), qn_body_lever(w, b, k));
        CHECK_NEAR(qn_norm(qn_sub(now, qn_add(b->velocity, swing))), 0, 1e-14);
        CHECK_NEAR(qn_norm(qn_sub(qn_add(m->velocity, m->kick), now)), 0, 1e-12);
        CHECK_NEAR(qn_norm(qn_sub(qn_add(m->spin, m->spin_kick), qn_spin_now(w, i))), 0, 1e-10);
    }
    qn_world_destroy(w);
}

// ---- Impact off the centre -----------------------------------------------------------------------

// A dumbbell, leaning, falls on a plane without friction: an impulse J = (1 + e) v / (1/m + a^2/I) at a
// lever a from the centre. Goldsmith (1960), Impact, 1.3.
static void a_leaning_dumbbell_rebounds_as_impulses_say(void)
{
    const double lean = 0.6, speed = 0.05, pair[] = {1, 0, 0, -1, 0, 0}, radii[] = {0.7, 0.7};
    qn_world *w;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 1);
    def.gravity = qn_v3(0, 0, 0);
    def.materials[0].youngs_modulus = def.materials[1].youngs_modulus = 1e10;
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    qn_group_def *g = add_ball(&def, 0.01, qn_v3(0, 0.02, 0), qn_v3(0, -speed, 0));
    g->shape = add_shape(&def, pair, radii, 2);
    g->turned = qn_v3(0, 0, lean);
    def.step = 2e-8;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    qn_def_free(&def);
    const qn_grain *grain = w->grains;
    const qn_body *b = w->bodies;
    double inertia = qn_max(grain->moments.x, grain->moments.y);
    double arm = qn_norm(grain->lever[0]) * cos(lean), m = grain->mass;
    b = w->bodies;
    double radius = w->classes[0].radius;
    w->bodies[0].position.y = radius + qn_norm(grain->lever[0]) * sin(lean) + 1e-7;
    bool touched = false;
    for (int i = 0; i < 60000 && !(touched && w->ledger.wall_contacts_now == 0); i++) {
        CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
        touched |= w->ledger.wall_contacts_now > 0;
        CHECK_STATUS(qn_step_advance(w));
    }
    double impulse = 2 * speed / (1 / m + arm * arm / inertia);
    double rise = -speed + impulse / m, spin = impulse * arm / inertia;
    CHECK(touched);
    CHECK_NEAR(b->velocity.y, rise, 1e-3 * speed);
    CHECK_NEAR(fabs(b->spin.z), spin, 1e-3 * spin);
    CHECK_NEAR(b->velocity.x, 0, 1e-12);
    double energy = m * b->velocity.y * b->velocity.y + inertia * b->spin.z * b->spin.z;
    CHECK_NEAR(energy / (m * speed * speed), 1, 1e-4);
    qn_world_destroy(w);
}

static void a_fixed_clump_stays_and_one_in_a_wall_is_refused(void)
{
    qn_world *w = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    qn_group_def *g = add_ball(&def, 0.01, qn_v3(0, 0.02, 0), qn_v3(0, 0, 0));
    g->shape = add_asymmetric(&def);
    g->fixed = true;
    g->spin = qn_v3(0, 0, 1);
    add_ball(&def, 0.004, qn_v3(0.001, 0.0285, 0), qn_v3(0, 0, 0));
    def.step = 1e-5;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    qn_def_free(&def);
    CHECK_STATUS(take_steps(w, 2000));
    CHECK(w->bodies[0].position.y == 0.02 && w->bodies[0].velocity.y == 0);
    CHECK(w->bodies[0].orientation.w == 1);
    CHECK(w->ledger.lost[QN_TALLY_NORMAL] > 0);
    qn_world_destroy(w);
    def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    g = add_ball(&def, 0.01, qn_v3(0, 0.006, 0), qn_v3(0, 0, 0));
    g->shape = add_asymmetric(&def);
    g->turned = qn_v3(0, 0, 1.57);
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    def.step = 1e-5;
    CHECK(qn_world_create(&def, 1, &w) == QN_INPUT);
    CHECK(strstr(qn_error(), "deep in a wall"));
}

// ---- Measures ------------------------------------------------------------------------------------

static void a_clumps_energy_is_that_of_its_body(void)
{
    const qn_vec3 spin = {60, 30, 80}, v = {0.1, 0.2, 0.3};
    qn_world *w = top(spin, 1e-6);
    qn_balance b;
    CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
    CHECK_STATUS(qn_balance_now(w, &b));
    const qn_grain *g = w->grains;
    double rotation = g->moments.x * spin.x * spin.x + g->moments.y * spin.y * spin.y
                      + g->moments.z * spin.z * spin.z;
    CHECK_NEAR(b.kinetic_translation, 0.5 * g->mass * qn_dot(v, v), 1e-12 * b.kinetic_translation);
    CHECK_NEAR(b.kinetic_rotation, 0.5 * rotation, 1e-12 * rotation);
    CHECK_NEAR(b.max_speed, qn_norm(v), 1e-12);
    CHECK_NEAR(b.mean_speed, qn_norm(v), 1e-12);
    CHECK_NEAR(g->mass, 2500 * QN_PI / 6 * 1e-6, 1e-15);
    CHECK(qn_world_particles(w) == 1 && w->count == 4);
    qn_world_destroy(w);
}

static void fields_count_clumps_once_and_all_of_their_volume(void)
{
    qn_world *w = mill(5, 60, 2, 0, QN_ENDS_PERIODIC);
    qn_field f;
    CHECK_STATUS(take_steps(w, 300));
    CHECK_STATUS(qn_step_forces(w, QN_PROBE));
    CHECK_STATUS(qn_field_create(w, 2, 1, &f));
    CHECK_STATUS(qn_field_sample(&f, w));
    int64_t count = 0, centred = 0, solid = 0, along = 0;
    for (int64_t k = 0; k < qn_field_voxel_count(&f); k++) {
        count += f.sum[QN_FIELD_count][k];
        centred += f.sum[QN_FIELD_centre_volume][k];
        solid += f.sum[QN_FIELD_solid_volume][k];
        along += f.sum[QN_FIELD_velocity_sum_x][k];
    }
    double volume = 60 * QN_PI / 6 * 27e-9, velocity = 0;
    for (int k = 0; k < 60; k++) velocity += qn_body_velocity_now(w, &w->bodies[k]).x;
    CHECK(count == 60 && centred == solid);
    CHECK_NEAR((double)solid * f.volume_unit, volume, 1e-5 * volume);
    CHECK_NEAR((double)along * QN_SPEED_QUANTUM, velocity, 60 * QN_SPEED_QUANTUM);
    qn_field_free(&f);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(a_clump_of_one_sphere_moves_as_a_ball_to_the_bit);
    TEST(a_clump_of_one_sphere_starts_as_a_ball_to_the_bit);
    TEST(clumps_move_the_same_for_any_number_of_threads);
    TEST(clumps_do_not_feel_when_the_list_is_rebuilt);
    TEST(clumps_resumed_at_any_step_go_on_to_the_bit);
    TEST(the_list_has_every_touching_pair_but_those_within_a_clump);
    TEST(a_free_top_follows_eulers_solution_to_second_order);
    TEST(a_free_top_keeps_its_momentum_and_its_energy_does_not_drift);
    TEST(a_top_on_its_middle_axis_turns_over);
    TEST(a_free_turn_runs_back_to_where_it_came_from);
    TEST(spheres_of_a_turning_clump_know_their_motion);
    TEST(a_leaning_dumbbell_rebounds_as_impulses_say);
    TEST(a_fixed_clump_stays_and_one_in_a_wall_is_refused);
    TEST(a_clumps_energy_is_that_of_its_body);
    TEST(fields_count_clumps_once_and_all_of_their_volume);
    DONE;
}
