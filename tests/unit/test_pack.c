// SPDX-License-Identifier: Apache-2.0
// Packing of one and of many sizes: nothing overlaps, amounts are exact, sizes are mixed.
#include "check.h"
#include "worlds.h"

// Ten sizes over 1:10 of equal mass, in one group.
static qn_group_def *ten_sizes(qn_def *def, double smallest)
{
    qn_group_def *g = add_group(def, "sand", smallest);
    double sum = 0;
    g->size_count = 10;
    g->jitter = 1;
    for (int s = 0; s < 10; s++) {
        g->diameter[s] = smallest * pow(10, s / 9.0);
        sum += g->fraction[s] = pow(g->diameter[s], -3);
    }
    for (int s = 0; s < 10; s++) g->fraction[s] /= sum;
    return g;
}

// A drum with lifters and periodic ends, with balls of `diameter` that stand in the way.
static qn_def def_of_drum(double diameter)
{
    qn_def def = def_of_mill(0, QN_ENDS_PERIODIC);
    def.group_count = 0;
    def.drum.length = 0.03;
    def.step = 1e-7;
    if (diameter > 0) add_ball(&def, diameter, qn_v3(0, -0.01, 0), qn_v3(0, 0, 0));
    return def;
}

// Deepest overlap of any two spheres (m), by trying all; below 0 where they are apart.
static double deepest(const qn_world *w)
{
    double deep = -INFINITY;
    for (int i = 0; i < w->count; i++)
        for (int j = i + 1; j < w->count; j++) {
            double x = w->place[i].x - w->place[j].x, y = w->place[i].y - w->place[j].y;
            double z = w->place[i].z - w->place[j].z;
            if (w->period > 0) z -= w->period * floor(z / w->period + 0.5);
            double reach =
                w->classes[w->place[i].klass].radius + w->classes[w->place[j].klass].radius;
            deep = qn_max(deep, reach - sqrt(x * x + y * y + z * z));
        }
    return deep;
}

// Deepest overlap of any sphere with a wall (m).
static double deepest_in_walls(const qn_world *w)
{
    qn_pose pose = qn_walls_pose(&w->walls, 0);
    double deep = -INFINITY;
    for (int i = 0; i < w->count; i++)
        deep = qn_max(deep, w->classes[w->place[i].klass].radius
                                - qn_walls_clearance(&w->walls, &pose, qn_world_position(w, i)));
    return deep;
}

static void ten_to_one_lies_apart_in_a_drum_with_something_in_the_way(void)
{
    qn_world *world;
    qn_def def = def_of_drum(0.012);
    ten_sizes(&def, 0.0008)->amount = 6000;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    CHECK(world->count == 6001);
    CHECK(deepest(world) <= 0 && deepest(world) > -2e-5);
    CHECK(deepest_in_walls(world) <= 0 && deepest_in_walls(world) > -1e-4);
    qn_world_destroy(world);
}

static void sizes_are_mixed_not_layered(void)
{
    qn_world *world;
    qn_def def = def_of_drum(0);
    def.drum.ends = QN_ENDS_FIXED;
    qn_group_def *g = ten_sizes(&def, 0.0008);
    g->size_count = 5;
    g->amount = 8000;
    for (int s = 0; s < 5; s++) g->fraction[s] = 0.2;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    double mean[5] = {0}, top[5] = {-1, -1, -1, -1, -1}, left[5] = {0};
    for (int i = 0; i < world->count; i++) {
        int s = world->place[i].klass;
        mean[s] += world->place[i].y / 1600;
        left[s] += world->place[i].x / 1600;
        top[s] = qn_max(top[s], world->place[i].y);
    }
    for (int s = 0; s < 4; s++) {
        CHECK_NEAR(mean[s], mean[4], 0.0025);
        CHECK_NEAR(left[s], left[4], 0.0025);
        CHECK_NEAR(top[s], top[4], 0.003);
    }
    CHECK(top[4] < 0.02);  // lies low
    qn_world_destroy(world);
}

static void counts_are_exact_for_every_size(void)
{
    qn_world *world;
    qn_def def = def_of_drum(0);
    qn_group_def *g = ten_sizes(&def, 0.0008);
    double fraction[10];
    memcpy(fraction, g->fraction, sizeof fraction);
    g->amount = 5000;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    int counts[10] = {0};
    CHECK(world->count == 5000);
    for (int i = 0; i < world->count; i++) counts[world->place[i].klass]++;
    for (int s = 0; s < 10; s++) CHECK_NEAR(counts[s], 5000 * fraction[s], 1);
    qn_world_destroy(world);
}

static void a_mass_is_met_to_half_the_smallest_sphere(void)
{
    for (int filling = 0; filling < 2; filling++) {
        qn_world *world;
        qn_def def = def_of_drum(0);
        qn_group_def *g = ten_sizes(&def, 0.0011);
        g->amount_kind = filling ? QN_AMOUNT_FILLING : QN_AMOUNT_MASS;
        g->amount = filling ? 0.25 : 0.03;
        CHECK_STATUS(qn_world_create(&def, 1, &world));
        double mass = 0, wanted = 0.03, shares[10] = {0};
        for (int i = 0; i < world->count; i++) {
            mass += world->classes[world->place[i].klass].mass;
            shares[world->place[i].klass] += world->classes[world->place[i].klass].mass;
        }
        if (filling) wanted = 0.25 * 0.6 * qn_walls_volume(&world->walls) * 2500;
        CHECK_NEAR(mass, wanted, 0.5001 * world->classes[0].mass);
        for (int s = 0; s < 10; s++)
            CHECK_NEAR(shares[s], wanted / 10, 1.01 * world->classes[9].mass);
        CHECK(deepest(world) <= 0);
        qn_world_destroy(world);
    }
}

static uint64_t hash_of_start(uint64_t seed, int threads)
{
    qn_world *world;
    qn_def def = def_of_drum(0);
    def.seed = seed;
    ten_sizes(&def, 0.001)->amount = 3000;
    if (qn_world_create(&def, threads, &world) != QN_OK) return 0;
    uint64_t hash = hash_of(world);
    qn_world_destroy(world);
    return hash;
}

static void a_seed_gives_the_same_packing_and_another_seed_another(void)
{
    CHECK(hash_of_start(5, 1) != 0);
    CHECK(hash_of_start(5, 1) == hash_of_start(5, 2));
    CHECK(hash_of_start(5, 1) != hash_of_start(6, 1));
}

static void more_sizes_than_fit_says_how_many_do(void)
{
    qn_world *world = NULL;
    qn_def def = def_of_drum(0);
    ten_sizes(&def, 0.0012)->amount = 20000;
    CHECK(qn_world_create(&def, 1, &world) == QN_INPUT && !world);
    CHECK(strstr(qn_error(), "particles.sand.count: 20000 do not fit, at most "));
    int most = atoi(strstr(qn_error(), "at most ") + 8);
    CHECK(most > 1000);
    def = def_of_drum(0);
    ten_sizes(&def, 0.0012)->amount = most;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    CHECK(world->count == most && deepest(world) <= 0);
    qn_world_destroy(world);
}

static void spheres_far_too_small_for_the_space_are_said(void)
{
    qn_world *world = NULL;
    qn_def def = def_of_drum(0);
    add_group(&def, "dust", 2e-9)->amount = 10;
    def.step = 1e-14;
    CHECK(qn_world_create(&def, 1, &world) == QN_INPUT && !world);
    CHECK(strstr(qn_error(), "spheres of radius 1.02e-09 m are too small to be packed"));
}

static void balls_and_rock_of_two_groups_share_the_space(void)
{
    qn_world *world;
    qn_def def = def_of_drum(0);
    qn_group_def *g = add_group(&def, "balls", 0.006);
    g->amount = 60;
    g->velocity = qn_v3(1, 0, 0);
    g = add_group(&def, "rock", 0.0015);
    g->material = 1;
    g->amount = 3000;
    CHECK_STATUS(qn_world_create(&def, 1, &world));
    int balls = 0;
    for (int i = 0; i < world->count; i++) {
        bool ball = world->classes[world->place[i].klass].material == 0;
        balls += ball;
        CHECK(world->motion[i].velocity.x == (ball ? 1 : 0));
    }
    CHECK(balls == 60 && world->count == 3060);
    CHECK(deepest(world) <= 0);
    qn_world_destroy(world);
}

int main(int argc, char **argv)
{
    TEST(ten_to_one_lies_apart_in_a_drum_with_something_in_the_way);
    TEST(sizes_are_mixed_not_layered);
    TEST(counts_are_exact_for_every_size);
    TEST(a_mass_is_met_to_half_the_smallest_sphere);
    TEST(a_seed_gives_the_same_packing_and_another_seed_another);
    TEST(more_sizes_than_fit_says_how_many_do);
    TEST(spheres_far_too_small_for_the_space_are_said);
    TEST(balls_and_rock_of_two_groups_share_the_space);
    DONE;
}
