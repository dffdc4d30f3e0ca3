// SPDX-License-Identifier: Apache-2.0
// Volume, centre and moments of unions of spheres against closed forms.
#include "check.h"

#include "physics/rigid.h"
#include "world/shape.h"

static double ball(double r)
{
    return 4.0 / 3 * QN_PI * r * r * r;
}

static void one_sphere_is_a_ball(void)
{
    const double centre[3] = {3, -2, 5}, radius = 0.7;
    qn_solid s;
    CHECK_STATUS(qn_solid_of(centre, &radius, 1, &s));
    CHECK_NEAR(s.volume, ball(0.7), 1e-14);
    CHECK_NEAR(s.centre.x, 3, 1e-14);
    CHECK_NEAR(s.centre.z, 5, 1e-14);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            CHECK_NEAR(s.inertia[i][j], i == j ? 0.4 * ball(0.7) * 0.49 : 0, 1e-14);
}

static void spheres_apart_add_up_by_the_parallel_axes(void)
{
    const double centres[] = {0, 0, 0, 4, 0, 0}, radii[] = {1, 2 * 0.75};
    qn_solid s;
    CHECK_STATUS(qn_solid_of(centres, radii, 2, &s));
    double a = ball(1), b = ball(1.5), spins = 0.4 * (a + b * 2.25);
    CHECK_NEAR(s.volume, a + b, 1e-12);
    CHECK_NEAR(s.centre.x, 4 * b / (a + b), 1e-13);
    CHECK_NEAR(s.inertia[0][0], spins, 1e-12);
    CHECK_NEAR(s.inertia[1][1], spins + a * b / (a + b) * 16, 1e-11);
    CHECK_NEAR(s.inertia[2][2], s.inertia[1][1], 1e-11);
}

static void a_sphere_inside_another_adds_nothing(void)
{
    const double centres[] = {0, 0, 0, 0.3, 0.2, 0, 0, 0, 0}, radii[] = {1, 0.5, 1};
    qn_solid s;
    CHECK_STATUS(qn_solid_of(centres, radii, 3, &s));
    CHECK_NEAR(s.volume, ball(1), 1e-13);
    CHECK_NEAR(s.centre.x, 0, 1e-14);
    CHECK_NEAR(s.inertia[2][2], 0.4 * ball(1), 1e-13);
}

// Two balls of radius 1 at +-d/2 on an axis are a body of revolution: along x >= 0 its section is a
// disc of radius squared q = 1 - (x - d/2)^2, and polynomials of degree 5 are exact with three nodes.
static void revolution(double d, double *volume, double *along, double *across)
{
    const double node[] = {-sqrt(0.6), 0, sqrt(0.6)}, weight[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    double half = (1 + d / 2) / 2;
    *volume = *along = *across = 0;
    for (int i = 0; i < 3; i++) {
        double x = half * (1 + node[i]), q = 1 - (x - d / 2) * (x - d / 2);
        double w = 2 * half * weight[i] * QN_PI;
        *volume += w * q;
        *along += w * q * q / 2;
        *across += w * (q * q / 4 + q * x * x);
    }
}

static void two_overlapping_spheres_count_their_lens_once(void)
{
    const double d = 1.1, radii[] = {1, 1};
    double lens = QN_PI * (4 + d) * (2 - d) * (2 - d) / 12;  // Polya & Szego: of two unit spheres
    double volume, along, across;
    revolution(d, &volume, &along, &across);
    CHECK_NEAR(volume, 2 * ball(1) - lens, 1e-13);
    const qn_vec3 axes[] = {{1, 0, 0}, {0, 0, 1}, {2 / 3.0, -1 / 3.0, 2 / 3.0}};
    for (int a = 0; a < 3; a++) {
        qn_vec3 n = axes[a], h = qn_scale(d / 2, n);
        const double centres[] = {h.x, h.y, h.z, -h.x, -h.y, -h.z};
        qn_solid s;
        CHECK_STATUS(qn_solid_of(centres, radii, 2, &s));
        CHECK_NEAR(s.volume, volume, 2e-13);
        CHECK_NEAR(qn_norm(s.centre), 0, 1e-14);
        const double m[3] = {n.x, n.y, n.z};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                CHECK_NEAR(s.inertia[i][j], (i == j) * across + (along - across) * m[i] * m[j],
                           3e-13);
        CHECK(s.error < 1e-12);
    }
}

// Six spheres, several corners of three, one sphere hidden in the rest.
static const double LUMP[] = {0,   0,    0,   0.9, 0.2, 0.1,  -0.3, 0.8,  0.4,
                              0.2, -0.5, 0.7, 0.1, 0.1, -0.9, 0.05, 0.02, 0.01};
static const double LUMP_RADII[] = {1, 0.7, 0.6, 0.8, 0.5, 0.3};

static void a_turned_lump_has_the_same_volume_and_moments(void)
{
    qn_shape first, other;
    double radius, turned_radius;
    CHECK_STATUS(qn_shape_of(LUMP, LUMP_RADII, 6, &first, &radius));
    CHECK(first.error < 1e-11 && !first.is_round);
    for (int t = 0; t < 5; t++) {
        qn_quat q = qn_quat_of_vector(qn_v3(0.3 + t, 1 - 0.2 * t, 0.7 * t));
        double turned[18];
        for (int i = 0; i < 6; i++) {
            qn_vec3 x = qn_turned(q, qn_v3(LUMP[3 * i], LUMP[3 * i + 1], LUMP[3 * i + 2]));
            turned[3 * i] = x.x + 1, turned[3 * i + 1] = x.y - 2, turned[3 * i + 2] = x.z;
        }
        CHECK_STATUS(qn_shape_of(turned, LUMP_RADII, 6, &other, &turned_radius));
        double sum = first.moment.x + first.moment.y + first.moment.z;
        double product = first.moment.x * first.moment.y * first.moment.z;
        CHECK_NEAR(turned_radius, radius, 1e-11);
        CHECK_NEAR(other.moment.x + other.moment.y + other.moment.z, sum, 1e-11);
        CHECK_NEAR(other.moment.x * other.moment.y * other.moment.z, product, 1e-11);
        CHECK_NEAR(other.bound, first.bound, 1e-11);
        CHECK(other.error < 1e-11);
    }
}

// Counts the points of a fine grid instead.
static void a_lump_is_what_a_grid_of_points_says(void)
{
    enum { N = 120 };
    double volume = 0, moment = 0;
    qn_vec3 centre = {0, 0, 0};
    qn_solid s;
    CHECK_STATUS(qn_solid_of(LUMP, LUMP_RADII, 6, &s));
    for (int i = 0; i < N * N * N; i++) {
        double h = 4.0 / N;
        qn_vec3 x =
            qn_v3(-2 + h * (i % N + 0.5), -2 + h * (i / N % N + 0.5), -2 + h * (i / N / N + 0.5));
        bool inside = false;
        for (int k = 0; k < 6; k++) {
            qn_vec3 c = qn_v3(LUMP[3 * k], LUMP[3 * k + 1], LUMP[3 * k + 2]);
            inside |= qn_norm(qn_sub(x, c)) < LUMP_RADII[k];
        }
        if (!inside) continue;
        volume += h * h * h;
        centre = qn_madd(centre, h * h * h, x);
        moment += h * h * h * (x.x * x.x + x.y * x.y);
    }
    centre = qn_scale(1 / volume, centre);
    moment -= volume * (centre.x * centre.x + centre.y * centre.y);
    CHECK_NEAR(s.volume, volume, 2e-3 * volume);
    CHECK_NEAR(qn_norm(qn_sub(s.centre, centre)), 0, 2e-3);
    CHECK_NEAR(s.inertia[2][2], moment, 3e-3 * moment);
}

static void a_tetrahedron_is_round_and_a_dumbbell_is_not(void)
{
    double centres[12], radii[4], radius;
    qn_shape s;
    for (double spacing = 0.2; spacing < 2.5; spacing += 0.4) {
        qn_shape_tetrahedron(spacing, centres, radii);
        double edge =
            hypot(hypot(centres[0] - centres[3], centres[1] - centres[4]), centres[2] - centres[5]);
        CHECK_NEAR(edge, spacing, 1e-14);
        CHECK_STATUS(qn_shape_of(centres, radii, 4, &s, &radius));
        CHECK(s.is_round && s.error < 1e-11 && s.moment.x > 0.4);
    }
    // Apart, at spacing 2.2: four balls on levers of 2.2 sqrt(3/8), each axis seeing 2/3 of the square.
    CHECK_NEAR(s.moment.x * radius * radius, 0.4 + 2.0 / 3 * 2.2 * 2.2 * 3 / 8, 1e-11);
    const double pair[] = {0, 0, 0, 1, 1, 0};
    CHECK_STATUS(qn_shape_of(pair, radii, 2, &s, &radius));
    CHECK(!s.is_round);
    CHECK_NEAR(s.overlap * 2 * ball(1), ball(radius), 1e-10);
}

static void the_axes_lead_back_to_the_spheres_as_given(void)
{
    qn_shape s;
    qn_solid solid;
    double radius;
    CHECK_STATUS(qn_shape_of(LUMP, LUMP_RADII, 6, &s, &radius));
    CHECK_STATUS(qn_solid_of(LUMP, LUMP_RADII, 6, &solid));
    for (int i = 0; i < 6; i++) {
        qn_vec3 at = qn_v3(s.centre[3 * i], s.centre[3 * i + 1], s.centre[3 * i + 2]);
        at = qn_madd(solid.centre, radius, qn_turned(s.axes, at));
        CHECK_NEAR(at.x, LUMP[3 * i], 1e-11);
        CHECK_NEAR(at.y, LUMP[3 * i + 1], 1e-11);
        CHECK_NEAR(at.z, LUMP[3 * i + 2], 1e-11);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double unit[3] = {j == 0, j == 1, j == 2}, out[3];
            qn_vec3 v = qn_tensor_times(s.axes, s.moment, qn_v3(unit[0], unit[1], unit[2]));
            out[0] = v.x, out[1] = v.y, out[2] = v.z;
            CHECK_NEAR(out[i] * ball(radius) * radius * radius, solid.inertia[i][j], 1e-11);
        }
}

// A rod's axes across it are free, and at 45 degrees two are equally near: rounding must not choose.
static void where_a_rod_lies_does_not_turn_its_free_axes(void)
{
    const double rod[] = {0, 0, 0, 1, 1, 0, 2, 2, 0}, radii[] = {1, 1, 1};
    qn_shape first, other;
    double radius, moved[9];
    CHECK_STATUS(qn_shape_of(rod, radii, 3, &first, &radius));
    for (int t = 1; t < 20; t++) {
        for (int k = 0; k < 9; k++) moved[k] = rod[k] + (k % 3 - 0.7) * 0.37 * t;
        CHECK_STATUS(qn_shape_of(moved, radii, 3, &other, &radius));
        CHECK(memcmp(&first.axes, &other.axes, sizeof first.axes) == 0);
        CHECK(memcmp(first.centre, other.centre, sizeof first.centre) == 0);
    }
}

static void a_shape_that_is_none_is_refused(void)
{
    double centres[6] = {0}, radii[2] = {1, -1}, radius;
    qn_shape s;
    CHECK(qn_shape_of(centres, radii, 2, &s, &radius) == QN_INPUT);
    CHECK(strstr(qn_error(), "sphere 2 of the clump has a radius of -1"));
    CHECK(qn_shape_of(centres, radii, 0, &s, &radius) == QN_INPUT);
    centres[4] = NAN, radii[1] = 1;
    CHECK(qn_shape_of(centres, radii, 2, &s, &radius) == QN_INPUT);
}

int main(int argc, char **argv)
{
    TEST(one_sphere_is_a_ball);
    TEST(spheres_apart_add_up_by_the_parallel_axes);
    TEST(a_sphere_inside_another_adds_nothing);
    TEST(two_overlapping_spheres_count_their_lens_once);
    TEST(a_turned_lump_has_the_same_volume_and_moments);
    TEST(a_lump_is_what_a_grid_of_points_says);
    TEST(a_tetrahedron_is_round_and_a_dumbbell_is_not);
    TEST(the_axes_lead_back_to_the_spheres_as_given);
    TEST(where_a_rod_lies_does_not_turn_its_free_axes);
    TEST(a_shape_that_is_none_is_refused);
    DONE;
}
