// SPDX-License-Identifier: Apache-2.0
// What balls do to a wall: the works that wear models take, facet by facet.
//
// Setup      (a) A ball hits a plate squarely and bounces; (b) a ball slides over a strip of triangles until
//            it rolls; (c) Finnie's function itself; (d) a ball without friction hits a plate at an angle.
// Formula    (a) normal work = m v^2/2; (b) shear work = m u^2/7, what a sphere loses on its way from
//            sliding at u to rolling at 5u/7, and it lies on the triangles of the path; (c) E = 0 along the
//            face and at right angles, 0.3 where tan g = 1/3 from both sides, largest at tan 2g = 2/3;
//            (d) the integral of F v E(g) dt over the loading of an elastic spring, for which v_n falls
//            from V as sqrt(V^2 - 2 U/m), U from 0 to m V^2/2: by quadrature over v_n.
// Source     Archard (1953), Finnie (1960): physics/wear.h. (b) mu m g slows and spins it until u = R w.
// Tolerance  1 %: steps, and (b) the tangential spring, which slips a little while it sticks.
#include "check.h"
#include "worlds.h"

static const double R = 0.0015;  // m

static void finnies_function_is_as_published(void)
{
    double best = 0, at = 0;
    CHECK_NEAR(qn_finnie(0, 2), 0, 0);
    CHECK_NEAR(qn_finnie(2, 0), 0, 0);
    CHECK_NEAR(qn_finnie(0, 0), 0, 0);
    CHECK_NEAR(qn_finnie(1.0000001, 3), 0.3, 1e-7);
    CHECK_NEAR(qn_finnie(0.9999999, 3), 0.3, 1e-7);
    for (double g = 0; g < QN_PI / 2; g += 1e-4)
        if (qn_finnie(sin(g), cos(g)) > best) best = qn_finnie(sin(g), cos(g)), at = g;
    CHECK_NEAR(tan(2 * at), 2.0 / 3, 1e-3);
}

static void a_bounce_takes_its_kinetic_energy(void)
{
    const double speed = 0.8;  // m/s
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 1);
    qn_world *w = NULL;
    add_ball(&def, 2 * R, qn_v3(0, 1.1 * R, 0), qn_v3(0, -speed, 0));
    add_plane(&def, "plate", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    def.gravity = qn_v3(0, 0, 0);
    def.step = 1e-6;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    double energy = 0.5 * w->classes[0].mass * speed * speed;
    CHECK_STATUS(take_steps(w, 4000));
    CHECK(w->motion[0].velocity.y > 0.99 * speed);
    CHECK_NEAR(qn_walls_worn(w, 0, QN_WEAR_NORMAL), energy, 0.01 * energy);
    CHECK_NEAR(qn_walls_worn(w, 0, QN_WEAR_SHEAR), 0, 1e-9 * energy);
    CHECK_NEAR(qn_walls_worn(w, 0, QN_WEAR_FINNIE), 0, 1e-9 * energy);
    qn_world_destroy(w);
}

/// A strip of 2 n triangles along x in the plane y = 0, 2 mm each.
static void add_strip(qn_def *def, int n)
{
    def->mesh_count = 1;
    def->meshes = calloc(1, sizeof *def->meshes);
    qn_mesh_def *m = def->meshes;
    *m = (qn_mesh_def){
        .name = "strip", .material = 1, .vertex_count = 2 * (n + 1), .triangle_count = 2 * n};
    m->vertices = calloc((size_t)(6 * (n + 1)), sizeof(double));
    m->triangles = calloc((size_t)(6 * n), sizeof(int));
    for (int i = 0; i <= n; i++) {
        m->vertices[6 * i] = m->vertices[6 * i + 3] = 0.002 * i;
        m->vertices[6 * i + 2] = -0.01, m->vertices[6 * i + 5] = 0.01;
    }
    for (int i = 0; i < n; i++) {
        const int at[6] = {2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2};
        memcpy(m->triangles + 6 * i, at, sizeof at);
    }
}

static void a_ball_that_slides_until_it_rolls_shears_off_what_it_loses(void)
{
    const double speed = 0.4, mu = 0.3;  // m/s
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, mu, 0.4);
    qn_world *w = NULL;
    add_ball(&def, 2 * R, qn_v3(0.0107, 0.9995 * R, 0.0013), qn_v3(speed, 0, 0));
    add_strip(&def, 40);
    def.step = 5e-6;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    double mass = w->classes[0].mass, lost = mass * speed * speed / 7;
    double time = 2 * speed / (7 * mu * 9.81), way = 12.0 / 49 * speed * speed / (mu * 9.81);
    CHECK_STATUS(take_steps(w, (int)(1.3 * time / w->dt)));
    CHECK_NEAR(w->motion[0].velocity.x, 5.0 / 7 * speed, 1e-3 * speed);
    CHECK_NEAR(qn_walls_worn(w, 0, QN_WEAR_SHEAR), lost, 0.01 * lost);
    double sum = 0, end = 0.0107 + way;
    for (int t = 0; t < w->walls.meshes[0].triangle_count; t++) {
        int facet = w->walls.meshes[0].first_facet + t;
        double left = 0.002 * (t / 2), work = qn_wear_value(&w->wear, facet, QN_WEAR_SHEAR);
        sum += work;
        if (left + 0.002 < 0.0107 || left > 0.0107 + speed * 1.3 * time) CHECK(work == 0);
        if (left > 0.0127 && left + 0.004 < end) CHECK(work > 0);
    }
    CHECK_NEAR(sum, qn_walls_worn(w, 0, QN_WEAR_SHEAR), 1e-12 * sum);
    qn_world_destroy(w);
}

static void a_slanting_impact_does_finnies_work(void)
{
    const double along = 0.9, into = 0.5;  // m/s
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 1);
    qn_world *w = NULL;
    add_ball(&def, 2 * R, qn_v3(0, 1.1 * R, 0), qn_v3(along, -into, 0));
    add_plane(&def, "plate", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    def.gravity = qn_v3(0, 0, 0);
    def.step = 1e-6;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    double expected = 0, mass = w->classes[0].mass, v = into / 2000;
    for (int k = 0; k < 1000; k++, v += into / 1000)  // F dt = -m dv
        expected += mass * into / 1000 * hypot(v, along) * qn_finnie(v, along);
    CHECK_STATUS(take_steps(w, 4000));
    CHECK(w->motion[0].velocity.y > 0.99 * into);
    CHECK_NEAR(qn_walls_worn(w, 0, QN_WEAR_FINNIE), expected, 0.01 * expected);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(finnies_function_is_as_published);
    TEST(a_bounce_takes_its_kinetic_energy);
    TEST(a_slanting_impact_does_finnies_work);
    TEST(a_ball_that_slides_until_it_rolls_shears_off_what_it_loses);
    DONE;
}
