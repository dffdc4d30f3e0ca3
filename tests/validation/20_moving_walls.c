// SPDX-License-Identifier: Apache-2.0
// Walls that move on their own: the work they do is the energy the balls gain and lose.
//
// Setup      (a) Balls bounce on a floor that shakes; (b) a paddle, a mesh, turns about a tilted axis in
//            a closed box of balls; (c) a box of meshes and planes swings about an axis outside it.
//            (d) A ball on a floor that carries it along, against the same ball on a floor at rest and
//            thrown the other way. (e) A ball at rest on a plate that is lifted evenly.
// Formula    (a-c) work of the walls = change of stored energy + losses, part by part F.V dt;
//            (d) Galileo: the same path but for the floor's; (e) force m g, power m g V, work m g V t.
// Source     Newton; the ledger's definitions (docs/theory/energy.md).
// Tolerance  (a-c) of the turnover: elastic and smooth 5e-4, and 1e-5 at a quarter of the step, as the
//            scheme is of second order; with friction 5e-3 and 3e-3, what the same box leaves at rest, where
//            sliding begins and ends within steps. (d) 1e-9 of the path: rounding of the moving coordinates.
//            (e) 1e-6: the ball has still some of its first bounce.
#include "check.h"
#include "measure/energy.h"
#include "worlds.h"

static const double R = 0.0015;  // m

static qn_mesh_def *add_mesh(qn_def *def, const char *name, const double *vertices,
                             int vertex_count, const int *triangles, int triangle_count)
{
    size_t n = (size_t)def->mesh_count++;
    def->meshes = realloc(def->meshes, (n + 1) * sizeof *def->meshes);
    qn_mesh_def *m = &def->meshes[n];
    *m = (qn_mesh_def){
        .material = 1, .vertex_count = vertex_count, .triangle_count = triangle_count};
    snprintf(m->name, sizeof m->name, "%s", name);
    m->vertices = malloc((size_t)vertex_count * 3 * sizeof(double));
    m->triangles = malloc((size_t)triangle_count * 3 * sizeof(int));
    memcpy(m->vertices, vertices, (size_t)vertex_count * 3 * sizeof(double));
    memcpy(m->triangles, triangles, (size_t)triangle_count * 3 * sizeof(int));
    return m;
}

/// Balls in a box of 20 mm.
static qn_def boxed(double step, bool smooth)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, smooth ? 0 : 0.3, smooth ? 1 : 0.8);
    add_box(&def, 0.02);
    add_group(&def, "balls", 2 * R)->amount = 60;
    def.gravity = qn_v3(0, -98.1, 0);
    def.step = step;
    return def;
}

static qn_def shaken(double step, bool smooth)
{
    qn_def def = boxed(step, smooth);
    def.planes[2].drive = (qn_drive_def){.kind = QN_DRIVE_OSCILLATE,
                                         .axis = {0, 1, 0},
                                         .amplitude = 0.0006,
                                         .frequency = 60,
                                         .phase = QN_PI / 2};
    return def;
}

static qn_def paddled(double step, bool smooth)
{
    static const double corners[12] = {0.002, 0.004, 0.01, 0.018, 0.004, 0.01,
                                       0.018, 0.016, 0.01, 0.002, 0.016, 0.01};
    static const int halves[6] = {0, 1, 2, 0, 2, 3};
    qn_def def = boxed(step, smooth);
    qn_mesh_def *m = add_mesh(&def, "paddle", corners, 4, halves, 2);
    m->drive = (qn_drive_def){.kind = QN_DRIVE_ROTATE,
                              .axis = {0.6, 0.8, 0},
                              .through = {0.01, 0.01, 0.01},
                              .leg_count = 2};
    m->drive.legs[0] = (qn_leg){0.02, 0, 25};
    m->drive.legs[1] = (qn_leg){INFINITY, 25, 25};
    return def;
}

static qn_def swung(double step, bool smooth)
{
    qn_def def = boxed(step, smooth);
    for (int i = 0; i < 6; i++)
        def.planes[i].drive = (qn_drive_def){.kind = QN_DRIVE_SWING,
                                             .axis = {0, 0, 1},
                                             .through = {0.01, -0.03, 0},
                                             .amplitude = 0.25,
                                             .frequency = 12,
                                             .phase = 0.4};
    return def;
}

/// Joules unaccounted for over the turnover after `time` (s); the work too.
static qn_status residual(qn_def def, double time, double *relative, double *work)
{
    qn_world *w = NULL;
    qn_balance first, now;
    QN_TRY(qn_world_create(&def, 2, &w));
    qn_status status = take_steps(w, 1);
    if (status == QN_OK) status = qn_step_forces(w, QN_PROBE);
    if (status == QN_OK) status = qn_balance_now(w, &first);
    if (status == QN_OK) status = take_steps(w, (int)lrint(time / w->dt));
    if (status == QN_OK) status = qn_step_forces(w, QN_PROBE);
    if (status == QN_OK) status = qn_balance_now(w, &now);
    if (status == QN_OK) {
        *relative = fabs(qn_balance_residual(&now, &first)) / qn_balance_turnover(&now, &first);
        *work = now.work;
    }
    qn_world_destroy(w);
    return status;
}

static void the_work_of_moving_walls_is_what_the_balls_gain_and_lose(void)
{
    qn_def (*const cases[])(double, bool) = {shaken, paddled, swung};
    static const char *const names[] = {"shaken floor", "tilted paddle", "swinging box"};
    for (int k = 0; k < 6; k++) {
        double coarse, fine, work;
        bool smooth = k < 3;
        CHECK_STATUS(residual(cases[k % 3](1e-5, smooth), 0.05, &coarse, &work));
        CHECK_STATUS(residual(cases[k % 3](2.5e-6, smooth), 0.05, &fine, &work));
        printf("  %s, %s: residual %.2g of the turnover at 10 us, %.2g at 2.5 us; work %.4g J\n",
               names[k % 3], smooth ? "elastic and smooth" : "with losses", coarse, fine, work);
        CHECK(work > 1e-5);
        CHECK(coarse < (smooth ? 5e-4 : 5e-3));
        CHECK(fine < (smooth ? 1e-5 : 3e-3));
    }
}

/// A ball that sticks to a floor which shakes it along x.
static qn_def carried(double step)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 20, 0.5);
    add_ball(&def, 2 * R, qn_v3(0, 0.9998 * R, 0), qn_v3(0, 0, 0));
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    def.planes[0].drive = (qn_drive_def){.kind = QN_DRIVE_OSCILLATE,
                                         .axis = {1, 0, 0},
                                         .amplitude = 0.0002,
                                         .frequency = 60,
                                         .phase = QN_PI / 2};
    def.step = step;
    return def;
}

static void a_contact_remembers_the_way_its_wall_has_gone(void)
{
    qn_def def = carried(8e-6);
    qn_world *w = NULL;
    double way = 0, worst = 0;  // m   of the ball's lowest point, by the velocities that moved it
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    for (int i = 0; i < 5000; i++) {
        double arm = w->place[0].y;
        CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
        if (i > 0) way += w->dt * (w->motion[0].velocity.x + arm * w->motion[0].spin.z);
        qn_wall_contact *contacts;
        int64_t count;
        qn_frame floor = qn_walls_frame(&w->walls, 1, qn_world_time(w));
        CHECK_STATUS(qn_neighbours_wall_contacts(w, &contacts, &count));
        qn_vec3 slip = count == 1 ? contacts[0].memory.slip : qn_v3(1, 0, 0);
        free(contacts);
        worst = qn_max(worst, fabs(slip.x - (way - floor.shift.x)));
        CHECK_STATUS(qn_step_advance(w));
    }
    qn_world_destroy(w);
    CHECK_NEAR(worst, 0,
               1e-8);  // 3e-7 were it the wall's velocity at the step, not half a step ago
}

static void threads_change_no_bit_of_forces_work_and_wear(void)
{
    qn_world *w[2];
    for (int k = 0; k < 2; k++) {
        qn_def def = paddled(1e-5, false);
        CHECK_STATUS(qn_world_create(&def, k ? 3 : 1, &w[k]));
        CHECK_STATUS(take_steps(w[k], 6000));
        qn_wear_settle(&w[k]->wear);
    }
    size_t parts = (size_t)w[0]->walls.part_count, facets = (size_t)w[0]->wear.facet_count;
    CHECK(hash_of(w[0]) == hash_of(w[1]));
    CHECK(memcmp(w[0]->ledger.work, w[1]->ledger.work, parts * sizeof(double)) == 0);
    CHECK(memcmp(w[0]->ledger.push, w[1]->ledger.push, 3 * parts * sizeof(double)) == 0);
    CHECK(memcmp(w[0]->ledger.impulse, w[1]->ledger.impulse, parts * sizeof(double)) == 0);
    CHECK(memcmp(w[0]->wear.facets, w[1]->wear.facets, facets * sizeof(qn_worn)) == 0);
    CHECK(qn_walls_worn(w[0], 6, QN_WEAR_SHEAR) > 0 && w[0]->ledger.work[6] > 0);
    for (int k = 0; k < 2; k++) qn_world_destroy(w[k]);
}

/// A ball on a floor, thrown at `speed` along x over it, which moves at `drift` itself; a mesh or a plane.
static qn_status slide(bool mesh, double speed, double drift, qn_vec3 *at, qn_vec3 *spin)
{
    static const double corners[12] = {-0.2, 0, -0.1, 0.2, 0, -0.1, 0.2, 0, 0.1, -0.2, 0, 0.1};
    static const int halves[6] = {0, 1, 2, 0, 2, 3};
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    qn_world *w = NULL;
    add_ball(&def, 2 * R, qn_v3(0, 0.999 * R, 0.01), qn_v3(speed + drift, 0, 0));
    def.step = 1e-5;
    qn_drive_def drive = {.kind = QN_DRIVE_TRANSLATE, .axis = {1, 0, 0}, .leg_count = 1};
    drive.legs[0] = (qn_leg){INFINITY, drift, drift};
    if (mesh)
        add_mesh(&def, "floor", corners, 4, halves, 2)->drive = drive;
    else {
        add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
        def.planes[0].drive = drive;
    }
    QN_TRY(qn_world_create(&def, 1, &w));
    qn_status status = take_steps(w, 20000);
    *at = qn_world_position(w, 0);
    at->x -= drift * qn_world_time(w);
    *spin = w->motion[0].spin;
    qn_world_destroy(w);
    return status;
}

static void a_ball_cannot_tell_whether_it_moves_or_its_floor(void)
{
    qn_vec3 rest, rest_spin, at, spin;
    CHECK_STATUS(slide(false, 0.25, 0, &rest, &rest_spin));
    CHECK(rest.x > 0.03 && fabs(rest_spin.z) > 50);
    for (int mesh = 0; mesh < 2; mesh++)
        for (int k = 0; k < 2; k++) {
            CHECK_STATUS(slide(mesh, 0.25, k ? -0.25 : 0.4, &at, &spin));
            CHECK_NEAR(qn_norm(qn_sub(at, rest)), 0, 1e-9 * rest.x);
            CHECK_NEAR(qn_norm(qn_sub(spin, rest_spin)), 0, 1e-9 * fabs(rest_spin.z));
        }
}

static void a_plate_that_lifts_a_ball_does_the_work_of_its_weight(void)
{
    const double speed = 0.05, time = 1;  // m/s, s
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.3);
    qn_world *w = NULL;
    add_ball(&def, 2 * R, qn_v3(0, R, 0), qn_v3(0, speed, 0));
    add_plane(&def, "plate", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    def.planes[0].drive =
        (qn_drive_def){.kind = QN_DRIVE_TRANSLATE, .axis = {0, 1, 0}, .leg_count = 1};
    def.planes[0].drive.legs[0] = (qn_leg){INFINITY, speed, speed};
    def.step = 1e-5;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    double weight = w->classes[0].mass * 9.81;
    CHECK_STATUS(take_steps(w, (int)lrint(time / w->dt)));
    CHECK_NEAR(w->ledger.force_now[1], weight, 1e-6 * weight);
    CHECK_NEAR(w->ledger.power_now[0], weight * speed, 1e-6 * weight * speed);
    CHECK_NEAR(w->ledger.work[0], weight * speed * time, 1e-4 * weight * speed * time);
    CHECK_NEAR(w->ledger.push[1], weight * time, 1e-4 * weight * time);
    CHECK_NEAR(w->ledger.force_now[0], 0, 1e-12 * weight);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(the_work_of_moving_walls_is_what_the_balls_gain_and_lose);
    TEST(a_contact_remembers_the_way_its_wall_has_gone);
    TEST(threads_change_no_bit_of_forces_work_and_wear);
    TEST(a_ball_cannot_tell_whether_it_moves_or_its_floor);
    TEST(a_plate_that_lifts_a_ball_does_the_work_of_its_weight);
    DONE;
}
