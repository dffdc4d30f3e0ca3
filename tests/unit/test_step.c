// SPDX-License-Identifier: Apache-2.0
// The step as a whole: determinism, resuming, the pair list, images, the leapfrog, the guards.
#include "check.h"
#include "worlds.h"

#include "step/cpu/kernel.h"

static qn_world *mill(int threads, double skin, qn_ends ends)
{
    qn_world *world = NULL;
    qn_def def = def_of_mill(900, ends);
    def.skin = skin;
    if (qn_world_create(&def, threads, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

static void the_state_is_the_same_for_any_number_of_threads(void)
{
    uint64_t hash = 0;
    const int threads[] = {1, 2, 3, 8};
    for (int k = 0; k < 4; k++) {
        qn_world *world = mill(threads[k], 0, QN_ENDS_PERIODIC);
        CHECK(world);
        CHECK_STATUS(take_steps(world, 400));
        if (k == 0) hash = hash_of(world);
        CHECK(hash_of(world) == hash && hash != 0);
        qn_world_destroy(world);
    }
}

static void the_state_does_not_depend_on_the_skin_of_the_list(void)
{
    qn_world *thin = mill(2, 0.05, QN_ENDS_PERIODIC), *thick = mill(2, 0.6, QN_ENDS_PERIODIC);
    CHECK(thin && thick);
    CHECK_STATUS(take_steps(thin, 500));
    CHECK_STATUS(take_steps(thick, 500));
    CHECK(thin->neighbours->rebuilds > 2 * thick->neighbours->rebuilds);
    CHECK(hash_of(thin) == hash_of(thick));
    qn_world_destroy(thin);
    qn_world_destroy(thick);
}

// Runs `before` steps, moves the state to a new world, and goes on there to step 300.
static uint64_t resumed_at(int before, int threads)
{
    qn_world *world = mill(2, 0, QN_ENDS_FIXED), *other = mill(threads, 0, QN_ENDS_FIXED);
    qn_state state;
    uint64_t hash = 0;
    if (qn_step_begin(world) == QN_OK && take_steps(world, before) == QN_OK
        && qn_world_export(world, &state) == QN_OK) {
        if (qn_world_import(other, &state) == QN_OK && take_steps(other, 300 - before) == QN_OK)
            hash = hash_of(other);
        qn_state_free(&state);
    }
    qn_world_destroy(world);
    qn_world_destroy(other);
    return hash;
}

static void a_run_resumed_at_any_step_is_the_same_run(void)
{
    qn_world *world = mill(2, 0, QN_ENDS_FIXED);
    CHECK_STATUS(take_steps(world, 300));
    uint64_t hash = hash_of(world);
    qn_world_destroy(world);
    const int at[] = {0, 1, 7, 123, 250, 299};
    for (int k = 0; k < 6; k++) CHECK(resumed_at(at[k], 1 + k % 3) == hash);
}

// Hash after 300 steps of a mill with another law, moved to a new world after `before` steps.
static uint64_t hash_under(qn_law law, int before, int threads)
{
    qn_world *world[2];
    qn_state state;
    uint64_t hash = 0;
    for (int k = 0; k < 2; k++) {
        qn_def def = def_of_mill(400, QN_ENDS_FIXED);
        for (int i = 0; i < def.contact_count; i++) def.contacts[i].law = law;
        if (qn_world_create(&def, k ? threads : 2, &world[k]) != QN_OK)
            printf("  %s\n", qn_error());
        qn_def_free(&def);
    }
    if (qn_step_begin(world[0]) == QN_OK && take_steps(world[0], before) == QN_OK
        && qn_world_export(world[0], &state) == QN_OK) {
        if (qn_world_import(world[1], &state) == QN_OK
            && take_steps(world[1], 300 - before) == QN_OK)
            hash = hash_of(world[1]);
        qn_state_free(&state);
    }
    qn_world_destroy(world[0]);
    qn_world_destroy(world[1]);
    return hash;
}

static void a_law_with_a_rolling_spring_goes_on_from_its_state_too(void)
{
    qn_law law = {QN_NORMAL_HERTZ, QN_DAMPING_HUNT_CROSSLEY, QN_COHESION_NONE,
                  QN_TANGENTIAL_THORNTON, QN_ROLLING_EPSD};
    uint64_t hash = hash_under(law, 0, 1);
    CHECK(hash != 0 && hash_under(law, 100, 3) == hash && hash_under(law, 231, 2) == hash);
    law.rolling = QN_ROLLING_NONE;
    CHECK(hash_under(law, 0, 1) != hash);
}

static void an_exported_state_comes_back_unchanged_before_the_first_step(void)
{
    qn_world *world = mill(2, 0, QN_ENDS_FIXED), *other = mill(1, 0, QN_ENDS_FIXED);
    qn_state state;
    CHECK_STATUS(take_steps(world, 500));
    CHECK_STATUS(qn_world_export(world, &state));
    CHECK(state.contact_count > 50 && state.wall_contact_count > 5);
    CHECK_STATUS(qn_world_import(other, &state));
    CHECK(hash_of(other) == qn_state_hash(&state));
    qn_state_free(&state);
    qn_world_destroy(world);
    qn_world_destroy(other);
}

static void probing_leaves_the_state_as_it_is(void)
{
    qn_world *world = mill(2, 0, QN_ENDS_PERIODIC);
    CHECK_STATUS(take_steps(world, 200));
    uint64_t before = hash_of(world);
    CHECK_STATUS(qn_step_forces(world, QN_PROBE));
    CHECK_STATUS(qn_step_forces(world, QN_PROBE));
    CHECK(hash_of(world) == before);
    double probed = world->ledger.now[QN_TALLY_ELASTIC_NORMAL];
    CHECK_STATUS(qn_step_forces(world, QN_COMMIT));
    CHECK(world->ledger.now[QN_TALLY_ELASTIC_NORMAL] == probed && probed > 0);
    qn_world_destroy(world);
}

// Pairs that touch, by trying all, the nearest image counting along the period.
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
            n += x * x + y * y + z * z < reach * reach;
        }
    return n;
}

static void the_list_finds_every_touching_pair_at_every_step(void)
{
    qn_world *world = mill(2, 0.2, QN_ENDS_PERIODIC);
    int64_t most = 0;
    for (int i = 0; i < 600; i++) {
        CHECK_STATUS(qn_step_forces(world, QN_COMMIT));
        if (i % 7 == 0) CHECK(world->ledger.contacts_now == touching_by_brute_force(world));
        most = world->ledger.contacts_now > most ? world->ledger.contacts_now : most;
        CHECK_STATUS(qn_step_advance(world));
    }
    CHECK(most > 300);
    qn_world_destroy(world);
}

static void sizes_and_materials_mix(void)
{
    qn_world *world;
    qn_def def = def_of_mill(250, QN_ENDS_FIXED);
    qn_group_def *g = &def.groups[0];
    g->size_count = 3;
    const double diameter[] = {0.0015, 0.002, 0.003}, fraction[] = {0.5, 0.3, 0.2};
    memcpy(g->diameter, diameter, sizeof diameter);
    memcpy(g->fraction, fraction, sizeof fraction);
    g = add_group(&def, "rock", 0.0025);
    g->material = 1;
    g->amount = 100;
    def.step = 4e-6;
    CHECK_STATUS(qn_world_create(&def, 2, &world));
    int of_class[4] = {0};
    for (int i = 0; i < world->count; i++) of_class[world->place[i].klass]++;
    CHECK(of_class[0] == 125 && of_class[1] == 75 && of_class[2] == 50 && of_class[3] == 100);
    int64_t most = 0;
    for (int i = 0; i < 3000; i++) {
        CHECK_STATUS(qn_step_forces(world, QN_COMMIT));
        if (i % 50 == 0) CHECK(world->ledger.contacts_now == touching_by_brute_force(world));
        most = world->ledger.contacts_now > most ? world->ledger.contacts_now : most;
        CHECK_STATUS(qn_step_advance(world));
    }
    CHECK(most > 20);
    qn_world_destroy(world);
}

static void a_ball_falls_as_gravity_says(void)
{
    qn_world *world;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    add_ball(&def, 0.003, qn_v3(0, 1, 0), qn_v3(0.5, 2, 0));
    def.step = 4e-5;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    CHECK_STATUS(take_steps(world, 2500));
    CHECK_STATUS(qn_step_forces(world, QN_PROBE));
    qn_vec3 v = qn_velocity_now(world, 0);
    CHECK_NEAR(world->place[0].x, 0.05, 1e-14);
    CHECK_NEAR(world->place[0].y, 1 + 2 * 0.1 - 9.81 * 0.1 * 0.1 / 2, 1e-12);
    CHECK_NEAR(v.y, 2 - 9.81 * 0.1, 1e-12);
    qn_world_destroy(world);
}

static void momentum_is_kept_to_the_last_quantum(void)
{
    qn_world *world;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.5, 0.6);
    def.gravity = qn_v3(0, 0, 0);
    add_ball(&def, 0.003, qn_v3(0, 0, 0), qn_v3(0.5, 0.1, 0));
    add_ball(&def, 0.003, qn_v3(0.0031, 0.001, 0.0004), qn_v3(-0.7, 0, 0.2));
    def.step = 2e-6;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    bool touched = false;
    for (int i = 0; i < 500; i++) {
        CHECK_STATUS(qn_step_forces(world, QN_COMMIT));
        touched |= world->ledger.contacts_now > 0;
        for (int axis = 0; axis < 3; axis++)
            CHECK(world->load[0].force[axis] == -world->load[1].force[axis]);
        CHECK_STATUS(qn_step_advance(world));
    }
    CHECK(touched && world->ledger.contacts_now == 0);
    qn_world_destroy(world);
}

static void too_deep_an_overlap_names_the_pair(void)
{
    qn_world *world;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    add_ball(&def, 0.003, qn_v3(0, 0, 0), qn_v3(0, 0, 0));
    add_ball(&def, 0.003, qn_v3(0.0024, 0, 0), qn_v3(0, 0, 0));
    def.step = 1e-6;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    CHECK(qn_step_begin(world) == QN_UNSTABLE);
    CHECK(strstr(qn_error(), "particle 1 overlaps particle 2 by 40 %")
          || strstr(qn_error(), "particle 2 overlaps particle 1 by 40 %"));
    qn_world_destroy(world);
}

static void too_fast_a_particle_is_named(void)
{
    qn_world *world;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    add_ball(&def, 0.003, qn_v3(0, 0, 0), qn_v3(0, 0, 0));
    def.step = 1e-5;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    CHECK_STATUS(qn_step_forces(world, QN_COMMIT));
    world->motion[0].velocity.x = NAN;
    CHECK(qn_step_advance(world) == QN_UNSTABLE);
    CHECK(strstr(qn_error(), "particle 1 has a speed that is not a number"));
    qn_world_destroy(world);
}

static void a_particle_beyond_a_wall_is_named(void)
{
    qn_world *world = mill(1, 0, QN_ENDS_FIXED);
    CHECK_STATUS(take_steps(world, 3));
    world->place[5].x = 1;
    world->neighbours->stale = true;
    CHECK(qn_step_forces(world, QN_COMMIT) == QN_UNSTABLE);
    CHECK(strstr(qn_error(), "has left through a wall"));
    qn_world_destroy(world);
}

static void more_than_fit_says_how_many_do(void)
{
    qn_world *world = NULL;
    qn_def def = def_of_mill(100000, QN_ENDS_FIXED);
    CHECK(qn_world_create(&def, 1, &world) == QN_INPUT && world == NULL);
    CHECK(strstr(qn_error(), "100000 do not fit, at most "));
    int most = atoi(strstr(qn_error(), "at most ") + 8);
    def = def_of_mill(most, QN_ENDS_FIXED);
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    CHECK(world->count == most && touching_by_brute_force(world) == 0);
    CHECK_STATUS(qn_step_begin(world));
    CHECK(world->ledger.contacts_now == 0 && world->ledger.wall_contacts_now == 0);
    qn_world_destroy(world);
}

int main(int argc, char **argv)
{
    TEST(the_state_is_the_same_for_any_number_of_threads);
    TEST(the_state_does_not_depend_on_the_skin_of_the_list);
    TEST(a_run_resumed_at_any_step_is_the_same_run);
    TEST(a_law_with_a_rolling_spring_goes_on_from_its_state_too);
    TEST(an_exported_state_comes_back_unchanged_before_the_first_step);
    TEST(probing_leaves_the_state_as_it_is);
    TEST(the_list_finds_every_touching_pair_at_every_step);
    TEST(sizes_and_materials_mix);
    TEST(a_ball_falls_as_gravity_says);
    TEST(momentum_is_kept_to_the_last_quantum);
    TEST(too_deep_an_overlap_names_the_pair);
    TEST(too_fast_a_particle_is_named);
    TEST(a_particle_beyond_a_wall_is_named);
    TEST(more_than_fit_says_how_many_do);
    DONE;
}
