// SPDX-License-Identifier: Apache-2.0
// Meshes against the analytic walls they stand for: the same motion, to rounding where they are the same shape.
//
// Setup      (a) A ball slides, then rolls, then rests with friction on a slope, on a plane, on a square of
//            two triangles along its diagonal, and on a sheet of 10 082 triangles. (b) A ball is pressed
//            into the corner of two, and of three, walls at right angles, of planes and of meshes. (c) A
//            ball rolls off a convex edge. (d) A ball thrown through a box, of six planes and of 1200
//            triangles. (e) A ball rolls to and fro in a round drum, and in a mesh of N flat facets.
// Formula    (a, b, d) the same path, spin and history; in (b) two and three contacts at every step; (c) at
//            most one contact, and without friction and losses the energy of before; (e) at each
//            of N joints the ball turns by 2 pi/N, and the dashpot takes the square of that: N (2 pi/N)^2.
// Source     Algorithms of contact ownership (Voronoi regions; docs/theory/walls.md); no paper.
// Tolerance  (a, b, d) 1e-10 of path and speed. (c) 1e-3 of the energy. (e) first order: less than 0.7
//            of the difference at twice as many facets, each time; 0.1 R at 480.
#include "check.h"
#include "worlds.h"

static const double R = 0.0015;  // m

/// A tilt that leaves no coordinate exact: about z by the angle of 3-4-5, then about x by that of 5-12-13.
static qn_vec3 tilted(qn_vec3 v)
{
    double x = 0.8 * v.x - 0.6 * v.y, y = 0.6 * v.x + 0.8 * v.y;
    return qn_v3(x, (12 * y - 5 * v.z) / 13, (5 * y + 12 * v.z) / 13);
}

/// Adds n x n squares of two triangles, from `at` along u and v, tilted with the rest.
static void add_sheet(qn_def *def, int n, qn_vec3 at, qn_vec3 u, qn_vec3 v)
{
    size_t which = (size_t)def->mesh_count++;
    int side = n + 1;
    def->meshes = realloc(def->meshes, (which + 1) * sizeof *def->meshes);
    qn_mesh_def *m = &def->meshes[which];
    *m = (qn_mesh_def){.material = 1, .vertex_count = side * side, .triangle_count = 2 * n * n};
    snprintf(m->name, sizeof m->name, "sheet_%d", (int)which);
    m->vertices = malloc((size_t)(3 * side * side) * sizeof(double));
    m->triangles = malloc((size_t)(6 * n * n) * sizeof(int));
    for (int i = 0; i < side * side; i++) {
        qn_vec3 p = qn_madd(qn_madd(at, (double)(i % side) / n, u), (double)(i / side) / n, v);
        qn_vec3 turned = tilted(p);
        memcpy(m->vertices + (ptrdiff_t)3 * i, &turned, sizeof turned);
    }
    for (int k = 0; k < n * n; k++) {
        int a = k / n * side + k % n;
        const int corners[6] = {a, a + 1, a + side + 1, a + side + 1, a + side, a};
        memcpy(m->triangles + (ptrdiff_t)6 * k, corners, sizeof corners);
    }
}

/// Makes all meshes one.
static void join(qn_def *def)
{
    qn_mesh_def *m = def->meshes;
    for (int k = 1; k < def->mesh_count; k++) {
        qn_mesh_def *more = &def->meshes[k];
        size_t v = (size_t)(m->vertex_count + more->vertex_count) * 3;
        size_t t = (size_t)(m->triangle_count + more->triangle_count) * 3;
        m->vertices = realloc(m->vertices, v * sizeof(double));
        m->triangles = realloc(m->triangles, t * sizeof(int));
        for (int i = 0; i < 3 * more->vertex_count; i++)
            m->vertices[3 * m->vertex_count + i] = more->vertices[i];
        for (int i = 0; i < 3 * more->triangle_count; i++)
            m->triangles[3 * m->triangle_count + i] = m->vertex_count + more->triangles[i];
        m->vertex_count += more->vertex_count, m->triangle_count += more->triangle_count;
        free(more->vertices), free(more->triangles);
    }
    def->mesh_count = 1;
}

/// A square of 0.2 m around the origin in the plane y = 0: a plane (n = 0), or a sheet.
static void add_floor(qn_def *def, int n)
{
    if (n == 0)
        add_plane(def, "floor", qn_v3(0, 0, 0), tilted(qn_v3(0, 1, 0)));
    else
        add_sheet(def, n, qn_v3(-0.1, 0, -0.1), qn_v3(0.2, 0, 0), qn_v3(0, 0, 0.2));
}

static qn_def ball(qn_vec3 at, qn_vec3 velocity, qn_vec3 spin, qn_vec3 gravity)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    add_ball(&def, 2 * R, tilted(at), tilted(velocity))->spin = tilted(spin);
    def.gravity = tilted(gravity);
    def.step = 1e-5;
    return def;
}

typedef struct path {
    qn_vec3 at[40], velocity[40], spin[40], slip[40];
    int fewest, most;  // touches
} path;

/// `steps` steps between 40 notes of the ball; the history of its first touch too.
static qn_status follow(qn_def def, int steps, path *p)
{
    qn_world *w = NULL;
    memset(p, 0, sizeof *p);
    p->fewest = 99;
    QN_TRY(qn_world_create(&def, 1, &w));
    for (int k = 0; k < 40; k++) {
        for (int i = 0; i < steps; i++) {
            QN_TRY(take_steps(w, 1));
            int touches = (int)w->ledger.wall_contacts_now;
            p->most = touches > p->most ? touches : p->most;
            p->fewest = touches < p->fewest ? touches : p->fewest;
        }
        qn_wall_contact *contacts;
        int64_t count;
        p->at[k] = qn_world_position(w, 0);
        p->velocity[k] = w->motion[0].velocity, p->spin[k] = w->motion[0].spin;
        QN_TRY(qn_neighbours_wall_contacts(w, &contacts, &count));
        if (count > 0) p->slip[k] = contacts[0].memory.slip;
        free(contacts);
    }
    qn_world_destroy(w);
    return QN_OK;
}

/// Largest difference of places by 0.1 m, of speeds and spins by `speed`, of histories by 0.1 um, near where
/// the ball's weight lets it slide.
static double difference(const path *a, const path *b, double speed)
{
    double most = 0;
    for (int k = 0; k < 40; k++) {
        most = qn_max(most, qn_norm(qn_sub(a->at[k], b->at[k])) / 0.1);
        most = qn_max(most, qn_norm(qn_sub(a->velocity[k], b->velocity[k])) / speed);
        most = qn_max(most, qn_norm(qn_sub(a->spin[k], b->spin[k])) / speed * R);
        most = qn_max(most, qn_norm(qn_sub(a->slip[k], b->slip[k])) / 1e-7);
    }
    return most;
}

static void sliding_rolling_and_resting_on_a_mesh_are_those_on_a_plane(void)
{
    static const int sheets[3] = {1, 7, 71};
    const qn_vec3 down = qn_v3(0, -9.81, 0), slope = qn_v3(1.4, -9.7, 1.4), none = qn_v3(0, 0, 0);
    const qn_vec3 diagonal = qn_v3(0.25, 0, 0.25);
    const struct {
        const char *what;
        qn_vec3 at, velocity, spin, gravity;
    } cases[] = {
        {"sliding", qn_v3(-0.05, R, -0.03), qn_v3(0.45, 0, 0.21), qn_v3(150, 300, -80), down},
        {"sliding along the diagonal", qn_v3(-0.05, R, -0.05), diagonal, none, down},
        {"rolling", qn_v3(-0.04, R, -0.05), qn_v3(0.2, 0, 0.3), qn_v3(0.3 / R, 0, -0.2 / R), down},
        {"rolling down a slope", qn_v3(-0.04, R, -0.04), none, none, slope},
        {"held by rolling friction on a joint", qn_v3(0.01, R, 0.01), none, none, slope},
        {"held beside a joint", qn_v3(0.0105, R, 0.0101), none, none, slope},
    };
    for (int c = 0; c < 6; c++) {
        path plane, mesh;
        for (int s = -1; s < 3; s++) {
            qn_def def = ball(cases[c].at, cases[c].velocity, cases[c].spin, cases[c].gravity);
            for (int i = 0; i < 3; i++) {
                def.contacts[i].law.rolling = c < 4 ? QN_ROLLING_CONSTANT : QN_ROLLING_EPSD;
                def.contacts[i].rolling_friction = c < 4 ? 0.01 : 0.5;
            }
            add_floor(&def, s < 0 ? 0 : sheets[s]);
            CHECK_STATUS(follow(def, 500, s < 0 ? &plane : &mesh));
            if (s < 0) continue;
            double off = difference(&plane, &mesh, 0.5);
            printf("  %s, %d triangles: %.2g\n", cases[c].what, 2 * sheets[s] * sheets[s], off);
            CHECK(mesh.most == 1);
            CHECK_NEAR(off, 0, 1e-10);
        }
        double gone = qn_norm(qn_sub(plane.at[39], plane.at[0]));
        CHECK(c < 4 ? gone > 0.02 : gone < 1e-3);
    }
}

static void a_concave_corner_of_meshes_is_one_of_planes(void)
{
    // Two walls, then three; the ball is pushed towards the corner and comes to rest in it.
    const qn_vec3 push[2] = {qn_v3(-4, -9, 1), qn_v3(-4, -9, -3)};
    for (int walls = 2; walls <= 3; walls++) {
        path of[2];
        for (int k = 0; k < 2; k++) {
            qn_def def = ball(qn_v3(1.0001 * R, 1.0002 * R, 1.0003 * R), qn_v3(0, 0, 0),
                              qn_v3(50, 20, -30), push[walls - 2]);
            const qn_vec3 x = qn_v3(0.1, 0, 0), y = qn_v3(0, 0.1, 0), z = qn_v3(0, 0, 0.1);
            const qn_vec3 low = qn_v3(0, 0, walls == 2 ? -0.05 : 0);
            if (k == 0) {
                add_plane(&def, "x", qn_v3(0, 0, 0), tilted(qn_v3(1, 0, 0)));
                add_plane(&def, "y", qn_v3(0, 0, 0), tilted(qn_v3(0, 1, 0)));
                if (walls == 3) add_plane(&def, "z", qn_v3(0, 0, 0), tilted(qn_v3(0, 0, 1)));
            } else {
                add_sheet(&def, 9, low, y, z);
                add_sheet(&def, 9, low, z, x);
                if (walls == 3) add_sheet(&def, 9, low, x, y);
                join(&def);
            }
            CHECK_STATUS(follow(def, 250, &of[k]));
        }
        double off = difference(&of[0], &of[1], 0.1);
        printf("  %d walls: %.2g, %d touches at most\n", walls, off, of[1].most);
        CHECK(of[1].most == walls && of[0].most == walls);
        CHECK_NEAR(off, 0, 1e-10);
    }
}

static void a_convex_edge_is_one_contact_all_the_way_round(void)
{
    // Off the end of a floor that meets a wall going down, at right angles.
    qn_def def = ball(qn_v3(-0.006, 0.99995 * R, 0), qn_v3(0.12, 0, 0.02), qn_v3(0, 0, 0),
                      qn_v3(0, -9.81, 0));
    for (int i = 0; i < 3; i++) def.contacts[i].friction = 0, def.contacts[i].restitution = 1;
    def.step = 1e-6;
    const double v[18] = {-0.05, 0, -0.05, 0, 0,     -0.05, 0, 0,     0.05,
                          -0.05, 0, 0.05,  0, -0.05, -0.05, 0, -0.05, 0.05};
    const int t[12] = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    add_sheet(&def, 2, qn_v3(0, 0, 0), qn_v3(1, 0, 0), qn_v3(0, 1, 0));
    qn_mesh_def *m = def.meshes;
    for (int i = 0; i < 6; i++) {
        qn_vec3 turned = tilted(qn_v3(v[3 * i], v[3 * i + 1], v[3 * i + 2]));
        memcpy(m->vertices + (ptrdiff_t)3 * i, &turned, sizeof turned);
    }
    m->vertex_count = 6, m->triangle_count = 4;
    memcpy(m->triangles, t, sizeof t);
    qn_vec3 gravity = def.gravity;
    path p;
    CHECK_STATUS(follow(def, 3500, &p));
    double first = 0, last = 0;  // J/kg
    for (int k = 0; k < 40; k++) {
        double energy = 0.5 * qn_dot(p.velocity[k], p.velocity[k]) - qn_dot(gravity, p.at[k]);
        if (k == 0) first = energy;
        last = energy;
    }
    qn_vec3 down = qn_sub(p.at[39], p.at[0]);
    CHECK(p.most == 1 && p.fewest == 0);
    CHECK(qn_dot(down, gravity) > 0.02 * 9.81);
    CHECK_NEAR(last, first, 1e-3 * fabs(first));
}

static void a_box_of_1200_triangles_rebounds_as_one_of_six_planes(void)
{
    path of[2];
    for (int k = 0; k < 2; k++) {
        qn_def def = ball(qn_v3(0.011, 0.013, 0.009), qn_v3(0.9, 0.7, -0.8), qn_v3(40, -90, 60),
                          qn_v3(0, 0, 0));
        for (int i = 0; i < 3; i++) def.contacts[i].restitution = 0.9;
        const double s = 0.02;
        const qn_vec3 x = qn_v3(s, 0, 0), y = qn_v3(0, s, 0), z = qn_v3(0, 0, s),
                      o = qn_v3(0, 0, 0);
        const qn_vec3 axis[3] = {x, y, z};
        for (int a = 0; a < 3; a++) {
            qn_vec3 u = axis[(a + 1) % 3], v = axis[(a + 2) % 3];
            if (k == 0) {
                add_plane(&def, "low", o, qn_scale(1 / s, tilted(axis[a])));
                add_plane(&def, "high", tilted(axis[a]), qn_scale(-1 / s, tilted(axis[a])));
            } else {
                add_sheet(&def, 10, o, u, v);
                add_sheet(&def, 10, axis[a], u, v);
            }
        }
        if (k == 1) join(&def);
        CHECK(k == 0 || def.meshes[0].triangle_count == 1200);
        CHECK_STATUS(follow(def, 70, &of[k]));
    }
    double off = difference(&of[0], &of[1], 1);
    printf("  %.2g after %.2g m/s, spin %.3g rad/s\n", off, qn_norm(of[0].velocity[39]),
           qn_norm(of[0].spin[39]));
    CHECK(qn_norm(of[0].velocity[39]) < 1.2 && qn_norm(of[0].velocity[39]) > 0.2);
    CHECK_NEAR(off, 0, 1e-10);
}

/// A ball in a round trough of 0.1 m: the drum's shell (n = 0), or a mesh of n facets around.
static qn_status roll_to_and_fro(int n, path *p)
{
    const double radius = 0.05, a = -0.6;  // m, rad
    qn_def def = def_of_materials(QN_LAW_LINEAR, 0.3, 0.6);
    double at = radius - 0.9999 * R;
    add_ball(&def, 2 * R, qn_v3(at * sin(a), -at * cos(a), 0.05), qn_v3(0, 0, 0));
    for (int i = 0; i < 3; i++) def.contacts[i].stiffness = 1000;
    def.step = 2e-5;
    if (n == 0) {
        def.drum = (qn_drum_def){.present = true,
                                 .name = "drum",
                                 .diameter = 2 * radius,
                                 .length = 0.1,
                                 .ends = QN_ENDS_FIXED,
                                 .material = 1,
                                 .end_material = 1};
        return follow(def, 400, p);
    }
    add_sheet(&def, 1, qn_v3(0, 0, 0), qn_v3(1, 0, 0), qn_v3(0, 1, 0));
    qn_mesh_def *m = def.meshes;
    m->vertex_count = 2 * n, m->triangle_count = 2 * n;
    m->vertices = realloc(m->vertices, (size_t)(6 * n) * sizeof(double));
    m->triangles = realloc(m->triangles, (size_t)(6 * n) * sizeof(int));
    for (int i = 0; i < n; i++) {
        double angle = 2 * QN_PI * (i + 0.3) / n;  // corners on the circle
        const double pair[6] = {radius * sin(angle), -radius * cos(angle), -0.05,
                                radius * sin(angle), -radius * cos(angle), 0.15};
        int j = (i + 1) % n;
        const int two[6] = {2 * i, 2 * i + 1, 2 * j + 1, 2 * j + 1, 2 * j, 2 * i};
        memcpy(m->vertices + (ptrdiff_t)6 * i, pair, sizeof pair);
        memcpy(m->triangles + (ptrdiff_t)6 * i, two, sizeof two);
    }
    return follow(def, 400, p);
}

static void facets_become_the_cylinder(void)
{
    path round, faceted;
    double last = INFINITY;
    CHECK_STATUS(roll_to_and_fro(0, &round));
    for (int n = 60; n <= 480; n *= 2) {
        CHECK_STATUS(roll_to_and_fro(n, &faceted));
        double off = 0;
        for (int k = 0; k < 40; k++) off = qn_max(off, qn_norm(qn_sub(round.at[k], faceted.at[k])));
        printf("  %d facets: %.3g mm off", n, 1e3 * off);
        printf(n > 60 ? ", order %.2g\n" : "\n", log2(last / off));
        CHECK(off < 0.7 * last);
        last = off;
    }
    CHECK(last < 0.1 * R);
}

int main(int argc, char **argv)
{
    TEST(sliding_rolling_and_resting_on_a_mesh_are_those_on_a_plane);
    TEST(a_concave_corner_of_meshes_is_one_of_planes);
    TEST(a_convex_edge_is_one_contact_all_the_way_round);
    TEST(a_box_of_1200_triangles_rebounds_as_one_of_six_planes);
    TEST(facets_become_the_cylinder);
    DONE;
}
