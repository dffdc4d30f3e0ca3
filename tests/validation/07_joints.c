// SPDX-License-Identifier: Apache-2.0
// A ball that rolls and slides over joints of a flat wall feels one wall.
//
// Setup      A ball of 3 mm pressed down by gravity, thrown with spin about all axes, over (a) a plane,
//            one large triangle, a square of two, and a sheet of 800, whose edges and corners it crosses
//            at odd angles; (b) a drum of square profile at rest, one side whole or cut into five.
// Formula    Same wall, same path: friction's history passes from triangle to triangle and from segment
//            to segment, and a joint adds no contact and no force.
// Source     Geometry: the Voronoi regions of the features (algorithms of contact ownership), no paper.
// Tolerance  1e-12 of the path, 0.1 m, and of the speed: the nearest point is found by other arithmetic
//            on each triangle, to some 1e-16 of its coordinates, which the stiff contact magnifies.
#include "evidence.h"
#include "worlds.h"

static const double R = 0.0015;  // m

// The walls of the mesh experiments are tilted, so that no coordinate is exact. Turns v, given as if the
// wall were the plane y = 0: about z by the angle of the 3-4-5 triangle, then about x by that of 5-12-13.
static qn_vec3 tilted(qn_vec3 v)
{
    double x = 0.8 * v.x - 0.6 * v.y, y = 0.6 * v.x + 0.8 * v.y;
    return qn_v3(x, (12 * y - 5 * v.z) / 13, (5 * y + 12 * v.z) / 13);
}

// Tilts gravity and the ball, and adds the plane they stand on if `plane`.
static void tilt(qn_def *def, bool plane)
{
    qn_group_def *g = def->groups;
    double *p = g->list_position;
    qn_vec3 at = tilted(qn_v3(p[0], p[1], p[2]));
    p[0] = at.x, p[1] = at.y, p[2] = at.z;
    g->velocity = tilted(g->velocity), g->spin = tilted(g->spin);
    def->gravity = tilted(def->gravity);
    if (plane) add_plane(def, "floor", qn_v3(0, 0, 0), tilted(qn_v3(0, 1, 0)));
    for (int m = 0; m < def->mesh_count; m++)
        for (int i = 0; i < def->meshes[m].vertex_count; i++) {
            double *v = &def->meshes[m].vertices[3 * i];
            qn_vec3 turned = tilted(qn_v3(v[0], v[1], v[2]));
            v[0] = turned.x, v[1] = turned.y, v[2] = turned.z;
        }
}

static qn_def thrown(double x, double y, double z, qn_vec3 velocity)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    for (int i = 0; i < 3; i++) {
        def.contacts[i].law.rolling = QN_ROLLING_CONSTANT;
        def.contacts[i].rolling_friction = 0.01;
    }
    add_ball(&def, 2 * R, qn_v3(x, y, z), velocity)->spin = qn_v3(150, 300, -80);
    def.step = 1e-5;
    return def;
}

// A sheet of n x n squares in the plane y = 0, from -0.1 to 0.1 m in x and z, each cut in two.
static void add_sheet(qn_def *def, int n)
{
    int side = n + 1;
    def->mesh_count = 1;
    def->meshes = calloc(1, sizeof *def->meshes);
    qn_mesh_def *m = def->meshes;
    *m = (qn_mesh_def){
        .name = "sheet", .material = 1, .vertex_count = side * side, .triangle_count = 2 * n * n};
    m->vertices = calloc((size_t)(3 * side * side), sizeof(double));
    m->triangles = calloc((size_t)(6 * n * n), sizeof(int));
    for (int i = 0; i < side * side; i++) {
        m->vertices[3 * i] = -0.1 + 0.2 * (i % side) / n;
        m->vertices[3 * i + 2] = -0.1 + 0.2 * (i / side) / n;
    }
    for (int k = 0; k < n * n; k++) {
        int a = k / n * side + k % n, b = a + 1, c = a + side, d = c + 1, *t = &m->triangles[6 * k];
        t[0] = a, t[1] = b, t[2] = d;
        t[3] = d, t[4] = c, t[5] = a;
    }
}

// One triangle that holds the whole path.
static void add_triangle(qn_def *def)
{
    add_sheet(def, 1);
    const double vertices[9] = {-0.2, 0, -0.15, 0.2, 0, -0.1, 0, 0, 0.3};
    qn_mesh_def *m = def->meshes;
    m->vertex_count = 3, m->triangle_count = 1;
    memcpy(m->vertices, vertices, sizeof vertices);
    m->triangles[0] = 0, m->triangles[1] = 1, m->triangles[2] = 2;
}

typedef struct path {
    qn_vec3 at[40], velocity[40], spin[40];
    int most_touches;
} path;

// 0.2 s of the ball's motion, noted every 500 steps.
static qn_status follow(qn_def *def, path *p)
{
    qn_world *w = NULL;
    memset(p, 0, sizeof *p);
    QN_TRY(qn_world_create(def, 1, &w));
    for (int k = 0; k < 40; k++) {
        for (int i = 0; i < 500; i++) {
            QN_TRY(take_steps(w, 1));
            int touches = (int)w->ledger.wall_contacts_now;
            p->most_touches = touches > p->most_touches ? touches : p->most_touches;
        }
        p->at[k] = qn_world_position(w, 0);
        p->velocity[k] = w->motion[0].velocity, p->spin[k] = w->motion[0].spin;
    }
    qn_world_destroy(w);
    qn_def_free(def);
    return QN_OK;
}

// Largest difference of two paths: of places by 0.1 m, speeds by 0.5 m/s, spins by 0.5 m/s over R.
static double difference(const path *a, const path *b)
{
    double most = 0;
    for (int k = 0; k < 40; k++) {
        most = qn_max(most, qn_norm(qn_sub(a->at[k], b->at[k])) / 0.1);
        most = qn_max(most, qn_norm(qn_sub(a->velocity[k], b->velocity[k])) / 0.5);
        most = qn_max(most, qn_norm(qn_sub(a->spin[k], b->spin[k])) / 0.5 * R);
    }
    return most;
}

static void a_ball_crosses_the_joints_of_a_mesh_as_a_plane(void)
{
    path plane, mesh;
    const qn_vec3 v = qn_v3(0.45, 0, 0.21);
    qn_def def = thrown(-0.07, R, -0.03, v);
    tilt(&def, true);
    CHECK_STATUS(follow(&def, &plane));
    CHECK(qn_norm(qn_sub(plane.at[39], plane.at[0])) > 0.06 && plane.most_touches == 1);
    for (int k = 0; k < 4; k++) {
        def = thrown(-0.07, R, -0.03, v);
        if (k == 0)
            add_triangle(&def);
        else
            add_sheet(&def, k == 1 ? 1 : k == 2 ? 7 : 20);
        tilt(&def, false);
        CHECK_STATUS(follow(&def, &mesh));
        CHECK(mesh.most_touches == 1);
        MEASURE("difference from the path on a plane",
                where("%d triangles", k == 0   ? 1
                                      : k == 1 ? 2
                                      : k == 2 ? 98
                                               : 800),
                difference(&plane, &mesh), 0, 1e-12);
    }
}

static void a_ball_rolls_along_the_very_edge_between_two_triangles(void)
{
    // Along the line x = z, the diagonal of every square, and over its corners.
    path plane, mesh;
    for (int k = 0; k < 2; k++) {
        qn_def def = thrown(-0.05, R, -0.05, qn_v3(0.3, 0, 0.3));
        def.groups[0].spin = qn_v3(0.3 / R, 0, -0.3 / R);
        if (k == 1) add_sheet(&def, 10);
        tilt(&def, k == 0);
        CHECK_STATUS(follow(&def, k == 0 ? &plane : &mesh));
    }
    CHECK(mesh.most_touches == 1);
    CHECK(qn_norm(qn_sub(plane.at[39], plane.at[0])) > 0.06);
    MEASURE("difference from the path on a plane", "along the edges of 200",
            difference(&plane, &mesh), 0, 1e-12);
}

// A square channel of 0.2 m, its lower side cut at x = -0.03, 0, 0.0101, 0.04.
static qn_def channel(bool cut)
{
    static const double whole[] = {-0.1, -0.1, 0.1, -0.1, 0.1, 0.1, -0.1, 0.1};
    static const double pieces[] = {-0.1, -0.1, -0.03, -0.1, 0,   -0.1, 0.0101, -0.1,
                                    0.04, -0.1, 0.1,   -0.1, 0.1, 0.1,  -0.1,   0.1};
    qn_def def = thrown(-0.07, -0.1 + R, 0.05, qn_v3(0.7, 0, 0.1));
    size_t size = cut ? sizeof pieces : sizeof whole;
    def.drum = drum_of(0.3, 0.2, QN_ENDS_FIXED);
    def.drum.profile_count = cut ? 8 : 4;
    def.drum.profile = malloc(size);
    const double *points = cut ? pieces : whole;
    for (int i = 0; i < def.drum.profile_count; i++) {
        def.drum.profile[2 * i] = 0.8 * points[2 * i] - 0.6 * points[2 * i + 1];
        def.drum.profile[2 * i + 1] = 0.6 * points[2 * i] + 0.8 * points[2 * i + 1];
    }
    qn_vec3 v = def.groups[0].velocity, g = def.gravity;
    double *at = def.groups[0].list_position, x = at[0], y = at[1];
    at[0] = 0.8 * x - 0.6 * y, at[1] = 0.6 * x + 0.8 * y;
    def.groups[0].velocity = qn_v3(0.8 * v.x - 0.6 * v.y, 0.6 * v.x + 0.8 * v.y, v.z);
    def.gravity = qn_v3(-0.6 * g.y, 0.8 * g.y, 0);
    return def;
}

static void a_ball_crosses_the_joints_of_a_profile_as_one_side(void)
{
    path whole, cut;
    qn_def def = channel(false);
    CHECK_STATUS(follow(&def, &whole));
    def = channel(true);
    CHECK_STATUS(follow(&def, &cut));
    CHECK(qn_norm(qn_sub(whole.at[39], whole.at[0])) > 0.1 && cut.most_touches == 1);
    MEASURE("difference from the path on one segment", "five segments", difference(&whole, &cut), 0,
            1e-12);
}

int main(int argc, char **argv)
{
    TEST(a_ball_crosses_the_joints_of_a_mesh_as_a_plane);
    TEST(a_ball_rolls_along_the_very_edge_between_two_triangles);
    TEST(a_ball_crosses_the_joints_of_a_profile_as_one_side);
    DONE;
}
