// SPDX-License-Identifier: Apache-2.0
// Physics does not know which way is up, nor how fast the laboratory moves.
//
// Setup      (a) Two spinning balls of different sizes collide obliquely, without gravity: as they are,
//            turned about an odd axis, and both moving on at 0.3, -0.2, 0.4 m/s. (b) A ball with spin falls
//            on a plane under gravity, and the same turned. (c) Two balls held at a fixed overlap and
//            tangential displacement turn together as one rigid body, once about an odd axis.
// Formula    (a), (b) Velocities and spins afterwards are the first ones turned, or moved on by the
//            same speed. (c) Seen from the pair the displacement, so the force, stays what it was.
// Source     Newton's laws; (c) Luding (2008), Granular Matter 10, 235, doi:10.1007/s10035-008-0099-x.
// Tolerance  (a), (b) 1e-12 of the speed of impact: rounding of places, 1e-17 m, in an overlap of 1e-5
//            to 1e-4 m. (c) 1e-3 of a displacement of 0.2 um, at 100 000 steps a turn, as a mill at 10 rad/s
//            has; what is left is half a step's turn, 6e-5.
#include "evidence.h"
#include "worlds.h"

// Turns v by the rows of an orthogonal matrix whose numbers (2/3, 1/3, 2/3) are not exact.
static qn_vec3 turned(qn_vec3 v, bool turn)
{
    if (!turn) return v;
    return qn_v3((2 * v.x - v.y + 2 * v.z) / 3, (2 * v.x + 2 * v.y - v.z) / 3,
                 (-v.x + 2 * v.y + 2 * v.z) / 3);
}

// Runs for `steps`, and gives back the motions by id.
static qn_status run(qn_def *def, int steps, qn_motion *after)
{
    qn_world *w = NULL;
    bool touched = false;
    QN_TRY(qn_world_create(def, 1, &w));
    for (int i = 0; i < steps; i++) {
        QN_TRY(take_steps(w, 1));
        touched |= w->ledger.contacts_now + w->ledger.wall_contacts_now > 0;
    }
    for (int i = 0; i < w->count; i++) after[w->id[i] - 1] = w->motion[i];
    bool apart = w->ledger.contacts_now + w->ledger.wall_contacts_now == 0;
    qn_world_destroy(w);
    return touched && apart ? QN_OK : qn_fail(QN_UNSTABLE, "they have not met and parted");
}

static qn_status two_balls(bool turn, qn_vec3 drift, qn_motion *after)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.2, 0.6);
    def.contacts[0].law.rolling = QN_ROLLING_CONSTANT, def.contacts[0].rolling_friction = 0.01;
    def.gravity = qn_v3(0, 0, 0);
    def.step = 2e-6;
    qn_group_def *g = add_ball(&def, 0.003, turned(qn_v3(0, 0, 0), turn),
                               qn_add(turned(qn_v3(0.5, 0.1, 0), turn), drift));
    g->spin = turned(qn_v3(100, 200, -50), turn);
    g = add_ball(&def, 0.002, turned(qn_v3(0.0024, 0.0009, 0.0004), turn),
                 qn_add(turned(qn_v3(-0.7, 0, 0.2), turn), drift));
    g->spin = turned(qn_v3(-70, 20, 150), turn);
    return run(&def, 1000, after);
}

static void check_same(const char *what, const qn_motion *a, const qn_motion *b, int count,
                       bool turn, qn_vec3 drift)
{
    for (int i = 0; i < count; i++) {
        qn_vec3 v = qn_add(turned(a[i].velocity, turn), drift), s = turned(a[i].spin, turn);
        MEASURE("difference of velocities (m/s)", what, qn_norm(qn_sub(v, b[i].velocity)), 0,
                1e-12);
        MEASURE("difference of spins (rad/s)", what, qn_norm(qn_sub(s, b[i].spin)), 0, 1e-9);
    }
}

static void a_collision_is_the_same_turned(void)
{
    qn_motion a[2], b[2];
    CHECK_STATUS(two_balls(false, qn_v3(0, 0, 0), a));
    CHECK_STATUS(two_balls(true, qn_v3(0, 0, 0), b));
    CHECK(qn_norm(qn_sub(a[0].velocity, qn_v3(0.5, 0.1, 0))) > 0.1);
    check_same("collision turned", a, b, 2, true, qn_v3(0, 0, 0));
}

static void a_collision_is_the_same_in_a_moving_laboratory(void)
{
    qn_motion a[2], b[2];
    qn_vec3 drift = qn_v3(0.3, -0.2, 0.4);
    CHECK_STATUS(two_balls(false, qn_v3(0, 0, 0), a));
    CHECK_STATUS(two_balls(false, drift, b));
    check_same("collision drifting", a, b, 2, false, drift);
}

static qn_status falling_ball(bool turn, qn_motion *after)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    for (int i = 0; i < 3; i++) {
        def.contacts[i].law.rolling = QN_ROLLING_CONSTANT;
        def.contacts[i].rolling_friction = 0.01;
    }
    def.gravity = turned(qn_v3(0, -9.81, 0), turn);
    def.step = 4e-6;
    add_plane(&def, "floor", qn_v3(0, 0, 0), turned(qn_v3(0, 1, 0), turn));
    qn_group_def *g = add_ball(&def, 0.003, turned(qn_v3(0.001, 0.002, 0.003), turn),
                               turned(qn_v3(0.3, -0.4, 0.2), turn));
    g->spin = turned(qn_v3(100, 200, -50), turn);
    return run(&def, 2000, after);
}

static void a_bounce_is_the_same_turned_with_wall_and_gravity(void)
{
    qn_motion a, b;
    CHECK_STATUS(falling_ball(false, &a));
    CHECK_STATUS(falling_ball(true, &b));
    CHECK(a.velocity.y > 0.1);
    check_same("bounce turned", &a, &b, 1, true, qn_v3(0, 0, 0));
}

// Turns v about the unit vector `axis` by `angle` (Rodrigues).
static qn_vec3 turned_about(qn_vec3 axis, double angle, qn_vec3 v)
{
    double c = cos(angle), s = sin(angle);
    return qn_add(qn_madd(qn_scale(c, v), s, qn_cross(axis, v)),
                  qn_scale((1 - c) * qn_dot(axis, v), axis));
}

// Largest change of the displacement and of the rolling spring's moment, relative to them and as seen
// from the pair, during one turn in `steps` steps.
static double change_of_memory(qn_vec3 axis, bool wall, int steps)
{
    const double r = 0.0015, depth = 1e-5, stretch = 2e-7, rate = 50;  // m, m, m, rad/s
    double mass = 4.0 / 3 * QN_PI * r * r * r * 2500, angle = 2 * QN_PI / steps;
    qn_sides sides = {.young = {64e6, 64e6},
                      .poisson = {0.23, 0.23},
                      .radius = {r, r},
                      .mass = {mass, mass},
                      .clip = true,
                      .dt = angle / rate,
                      .friction = 0.9,
                      .restitution = 0.6,
                      .rolling_friction = 0.5,
                      .rolling_damping = 0.3};
    qn_law law = qn_law_named(QN_LAW_HERTZ_MINDLIN);
    law.rolling = QN_ROLLING_EPSD;
    qn_pair pair = qn_law_pair(law, &sides);
    qn_reach reach = wall ? (qn_reach){r, r, 0, 1, 0} : (qn_reach){2 * r, r, r, 0.5, 0.5};
    double moment = 0.5 * pair.rolling_arm * qn_normal_at(law.normal, &pair, depth).elastic;
    qn_vec3 between = qn_v3(0, reach.reach - depth, 0);
    qn_memory first = {{stretch, 0, 0}, {0, 0, moment}}, memory = first;
    double most = 0;
    for (int i = 1; i <= steps; i++) {
        qn_vec3 before = turned_about(axis, (i - 1) * angle, between);
        qn_vec3 now = turned_about(axis, i * angle, between);
        qn_touch t = {now,
                      qn_scale(rate / angle, qn_sub(now, before)),
                      {0, 0, 0},
                      qn_scale(rate, axis),
                      qn_scale(rate, axis),
                      {0, 0, 0},
                      {0, 0, 0},
                      memory,
                      qn_scale(wall ? 1 / qn_norm(before) : 0, before)};
        qn_reply reply;
        qn_contact_evaluate(law, &pair, &reach, &t, &reply);
        memory = reply.memory;
        qn_vec3 slip = turned_about(axis, -i * angle, memory.slip);
        qn_vec3 roll = turned_about(axis, -i * angle, memory.roll);
        most = qn_max(most, qn_norm(qn_sub(slip, first.slip)) / stretch);
        most = qn_max(most, qn_norm(qn_sub(roll, first.roll)) / moment);
    }
    return most;
}

static void a_loaded_pair_that_turns_as_one_body_keeps_its_memory(void)
{
    // Along the displacement, along the normal, across both, and askew.
    const qn_vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2.0 / 7, 3.0 / 7, 6.0 / 7}};
    const char *names[] = {"along the displacement", "along the normal", "across both", "askew"};
    for (int k = 0; k < 4; k++)
        for (int wall = 0; wall < 2; wall++)
            MEASURE(wall ? "change of memory in a turn, ball and wall"
                         : "change of memory in a turn, two balls",
                    names[k], change_of_memory(axes[k], wall, 100000), 0, 1e-3);
}

int main(int argc, char **argv)
{
    TEST(a_collision_is_the_same_turned);
    TEST(a_collision_is_the_same_in_a_moving_laboratory);
    TEST(a_bounce_is_the_same_turned_with_wall_and_gravity);
    TEST(a_loaded_pair_that_turns_as_one_body_keeps_its_memory);
    DONE;
}
