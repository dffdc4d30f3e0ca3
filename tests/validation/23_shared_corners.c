// SPDX-License-Identifier: Apache-2.0
// Shared corners: a ball over the joint of two stretches takes from each the share the reference document says.
//
// Setup      (a) The share itself. (b) A ball dropped on a joint of a straight wall, on both its sides and on
//            the joint, and (c) thrown along the wall over five joints, with whole, cut, and cut and shared
//            walls. (d) A ball held over a protruding right angle.
// Formula    p = a^2 (3 - 2 a), the part of the area between circle and chord, of a circle much larger than
//            the chord; p(a) + p(1 - a) = 1, so that (b, c) a cut wall is the whole one; (d) the force is
//            the sum over both lines of p F(depth under that line) along its normal, F by Hertz.
// Source     The reference document, 5.2.1, Figs 5.18 to 5.20; its own codes gave twice the force in (b).
// Tolerance  (a) 1e-4 against the area at R = 500 chords; (b, c) 1e-11 of the path: rounding; (d) 1e-8: forces
//            are sums of quanta.
#include "check.h"
#include "physics/sharing.h"
#include "worlds.h"

static const double R = 0.0015;  // m

/// Part of the area between a circle and a chord of length 1 that lies up to `a` along the chord.
static double area_part(double radius, double a)
{
    enum { N = 20000 };
    double low = sqrt(radius * radius - 0.25), part = 0, whole = 0;
    for (int i = 0; i < N; i++) {
        double x = (i + 0.5) / N, y = sqrt(radius * radius - (x - 0.5) * (x - 0.5)) - low;
        if (x < a) part += y;
        whole += y;
    }
    return part / whole;
}

static void the_share_is_the_part_of_the_area(void)
{
    for (double a = 0; a <= 1; a += 0.05) {
        CHECK_NEAR(qn_corner_share(a), area_part(500, a), 1e-4);
        CHECK_NEAR(qn_corner_share(a) + qn_corner_share(1 - a), 1, 1e-15);
    }
    CHECK_NEAR(qn_corner_share(0.2), 0.104, 1e-15);  // as read from Fig 5.20
    CHECK_NEAR(qn_corner_share(0.5), 0.5, 0);
}

/// A square trough of 0.2 m at rest, its lower side whole or cut at six places; all turned by the angle of the
/// triangle 3-4-5.
static qn_def trough(qn_vec3 at, qn_vec3 velocity, bool cut, bool shared)
{
    static const double whole[] = {-0.1, -0.1, 0.1, -0.1, 0.1, 0.1, -0.1, 0.1};
    static const double pieces[] = {-0.1, -0.1, -0.03,  -0.1, -0.029, -0.1, 0,   -0.1, 0.0101, -0.1,
                                    0.04, -0.1, 0.0412, -0.1, 0.1,    -0.1, 0.1, 0.1,  -0.1,   0.1};
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.3, 0.6);
    qn_vec3 turned = qn_v3(0.8 * at.x - 0.6 * at.y, 0.6 * at.x + 0.8 * at.y, at.z);
    qn_vec3 v =
        qn_v3(0.8 * velocity.x - 0.6 * velocity.y, 0.6 * velocity.x + 0.8 * velocity.y, velocity.z);
    add_ball(&def, 2 * R, turned, v)->spin = qn_v3(10, -20, 30);
    def.gravity = qn_v3(0.6 * 9.81, -0.8 * 9.81, 0);
    def.step = 1e-5;
    def.drum = (qn_drum_def){.present = true,
                             .name = "drum",
                             .diameter = 0.3,
                             .length = 0.2,
                             .ends = QN_ENDS_FIXED,
                             .corners = shared ? QN_CORNERS_SHARED : QN_CORNERS_EXACT,
                             .material = 1,
                             .end_material = 1,
                             .profile_count = cut ? 10 : 4};
    const double *points = cut ? pieces : whole;
    def.drum.profile = malloc((size_t)(2 * def.drum.profile_count) * sizeof(double));
    for (int i = 0; i < def.drum.profile_count; i++) {
        def.drum.profile[2 * i] = 0.8 * points[2 * i] - 0.6 * points[2 * i + 1];
        def.drum.profile[2 * i + 1] = 0.6 * points[2 * i] + 0.8 * points[2 * i + 1];
    }
    return def;
}

typedef struct path {
    qn_vec3 at[40], velocity[40], spin[40];
    int most;  // touches
} path;

static qn_status follow(qn_def def, int steps, path *p)
{
    qn_world *w = NULL;
    memset(p, 0, sizeof *p);
    QN_TRY(qn_world_create(&def, 1, &w));
    for (int k = 0; k < 40; k++) {
        for (int i = 0; i < steps; i++) {
            QN_TRY(take_steps(w, 1));
            int touches = (int)w->ledger.wall_contacts_now;
            p->most = touches > p->most ? touches : p->most;
        }
        p->at[k] = qn_world_position(w, 0);
        p->velocity[k] = w->motion[0].velocity, p->spin[k] = w->motion[0].spin;
    }
    qn_world_destroy(w);
    return QN_OK;
}

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

static void a_drop_on_a_joint_is_a_drop_on_a_wall(void)
{
    const double along[4] = {0.0101, 0.01012, -0.02995, 0.04115};
    for (int i = 0; i < 4; i++) {
        path whole, cut, shared;
        qn_vec3 at = qn_v3(along[i], -0.1 + 2 * R, 0.1), v = qn_v3(0, -0.4, 0);
        CHECK_STATUS(follow(trough(at, v, false, false), 100, &whole));
        CHECK_STATUS(follow(trough(at, v, true, false), 100, &cut));
        CHECK_STATUS(follow(trough(at, v, true, true), 100, &shared));
        CHECK(cut.most == 1 && shared.most >= 2);
        CHECK_NEAR(difference(&whole, &cut), 0, 1e-11);
        CHECK_NEAR(difference(&whole, &shared), 0, 1e-11);
    }
}

static void a_ball_crosses_shared_joints_as_one_side(void)
{
    // Thrown along the wall, then let go on it where it slopes, so that friction's spring stays loaded.
    for (int slope = 0; slope < 2; slope++) {
        path of[2];
        for (int k = 0; k < 2; k++) {
            qn_vec3 v = slope ? qn_v3(0, 0, 0) : qn_v3(0.7, 0, 0.1);
            qn_def def = trough(qn_v3(-0.05, -0.1 + 0.9999 * R, 0.05), v, k == 1, k == 1);
            if (slope) def.gravity = qn_v3(0.8 * 6 + 0.6 * 9, 0.6 * 6 - 0.8 * 9, 0);
            CHECK_STATUS(follow(def, 400, &of[k]));
        }
        CHECK(qn_norm(qn_sub(of[0].at[39], of[0].at[0])) > 0.04 && of[1].most >= 2);
        CHECK_NEAR(difference(&of[0], &of[1]), 0, 1e-11);
    }
}

/// Force (N) on a ball at rest, held `x` and `y` (m) beyond the corner of a block in a trough.
static qn_status force_at(double x, double y, qn_vec3 *force, double *deepest)
{
    static const double points[] = {-0.1, -0.1, 0.1, -0.1, 0.1, 0.1, 0, 0.1, 0, 0, -0.1, 0};
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 0.6);
    qn_world *w = NULL;
    add_ball(&def, 2 * R, qn_v3(x, y, 0.1), qn_v3(0, 0, 0));
    def.gravity = qn_v3(0, 0, 0);
    def.drum = (qn_drum_def){.present = true,
                             .name = "drum",
                             .diameter = 0.3,
                             .length = 0.2,
                             .ends = QN_ENDS_FIXED,
                             .corners = QN_CORNERS_SHARED,
                             .material = 1,
                             .end_material = 1,
                             .profile_count = 6};
    def.drum.profile = malloc(sizeof points);
    memcpy(def.drum.profile, points, sizeof points);
    QN_TRY(qn_world_create(&def, 1, &w));
    qn_status status = qn_step_forces(w, QN_PROBE);
    *force = qn_scale(w->classes[0].mass, qn_acceleration(w, 0));
    *deepest = w->ledger.deepest_now;
    qn_world_destroy(w);
    return status;
}

static void a_protruding_corner_pushes_with_both_its_sides(void)
{
    // The block fills x < 0, y > 0; the ball is at (x, -y): its sides are under it by x and y. Hertz on a flat
    // wall: 4/3 E* sqrt(R) depth^1.5, E* of glass and liner.
    const double young = 64e6 / (1 - 0.23 * 0.23 + 1 - 0.42 * 0.42);
    for (int i = 0; i < 8; i++) {
        double angle = QN_PI * (0.2 + 0.015 * i), x = 0.985 * R * cos(angle),
               y = 0.985 * R * sin(angle);
        double under[2] = {x, y}, expected[2];
        for (int k = 0; k < 2; k++) {
            double half = sqrt(R * R - under[k] * under[k]);
            double force = 4.0 / 3 * young * sqrt(R) * pow(R - under[k], 1.5);
            expected[k] = qn_corner_share((half - under[1 - k]) / (2 * half)) * force;
        }
        double deepest;  // 1   in radii: of the real corner, not of the lines
        qn_vec3 force;
        CHECK_STATUS(force_at(x, -y, &force, &deepest));
        CHECK(expected[0] > 0 && expected[1] > 0 && deepest < 0.016);
        CHECK_NEAR(force.x, expected[0], 1e-8 * expected[0]);
        CHECK_NEAR(force.y, -expected[1], 1e-8 * expected[1]);
    }
}

int main(int argc, char **argv)
{
    TEST(the_share_is_the_part_of_the_area);
    TEST(a_drop_on_a_joint_is_a_drop_on_a_wall);
    TEST(a_ball_crosses_shared_joints_as_one_side);
    TEST(a_protruding_corner_pushes_with_both_its_sides);
    DONE;
}
