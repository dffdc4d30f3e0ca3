// SPDX-License-Identifier: Apache-2.0
// The drum's cross-section and the sine and cosine that turn it.
#include "check.h"
#include "physics/angle.h"
#include "world/profile.h"

#include <stdlib.h>

static qn_drum_def drum_of(double diameter, int lifters, double height, double top, double base)
{
    return (qn_drum_def){.present = true,
                         .diameter = diameter,
                         .length = 1,
                         .lifter_count = lifters,
                         .lifter_height = height,
                         .lifter_top = top,
                         .lifter_base = base};
}

static qn_drum_def line_of(double *points, int count)
{
    return (qn_drum_def){.present = true, .length = 1, .profile = points, .profile_count = count};
}

/// Uniform in [low, high[, the same numbers in every run.
static double uniform(double low, double high)
{
    static uint64_t seed = 1;
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

static double nearest_by_force(const qn_profile *p, double x, double y)
{
    double best = INFINITY;
    for (int i = 0; i < p->count; i++)
        best = qn_min(best, qn_element_distance(&p->elements[i], p->radius, x, y));
    return best;
}

static void sine_and_cosine_agree_with_the_library(void)
{
    for (int i = 0; i < 200000; i++) {
        double s, c, range = i % 2 ? 10 : 1e5, angle = uniform(-range, range);
        qn_sincos(angle, &s, &c);
        CHECK_NEAR(s, sin(angle), 2.5e-16);
        CHECK_NEAR(c, cos(angle), 2.5e-16);
    }
    for (int k = -60000; k <= 60000; k++) {  // where one of them is nearly zero
        double s, c, angle = k * (QN_PI / 2);
        qn_sincos(angle, &s, &c);
        CHECK_NEAR(k % 2 ? c : s, k % 2 ? cos(angle) : sin(angle), 1e-18);
    }
}

/// A square turned by an angle, whose lower side is one stretch in p and two in q.
static qn_status build_jointed(double angle, qn_profile *p, qn_profile *q, double joint[2])
{
    double c = cos(angle), s = sin(angle), one[8], two[10];
    const double corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    for (int i = 0; i < 4; i++) {
        one[2 * i] = c * corners[2 * i] - s * corners[2 * i + 1];
        one[2 * i + 1] = s * corners[2 * i] + c * corners[2 * i + 1];
    }
    joint[0] = c * 0.123 + s;
    joint[1] = s * 0.123 - c;
    memcpy(two, one, 2 * sizeof *one);
    memcpy(two + 2, joint, 2 * sizeof *joint);
    memcpy(two + 4, one + 2, 6 * sizeof *one);
    qn_drum_def plain = line_of(one, 4), jointed = line_of(two, 5);
    qn_status status = qn_profile_build(&plain, 0.1, p);
    return status == QN_OK ? qn_profile_build(&jointed, 0.1, q) : status;
}

static void a_joint_in_a_straight_line_is_not_felt(void)
{
    for (int k = 0; k < 40; k++) {
        double joint[2], angle = uniform(0, 6), c = cos(angle), s = sin(angle);
        qn_profile p, q;
        CHECK_STATUS(build_jointed(angle, &p, &q, joint));
        CHECK(q.elements[1].corner == QN_CORNER_SMOOTH);
        CHECK(q.elements[1].start_x == -q.elements[0].end_x);
        CHECK(q.elements[1].start_y == -q.elements[0].end_y);
        for (int i = 0; i < 1000; i++) {
            // From far to nearly exactly over the joint.
            double along = i == 0 ? 0 : uniform(-0.1, 0.1) * pow(10, -(i % 18));
            double up = uniform(0.09, 0.0999);
            double x = joint[0] + c * along - s * up, y = joint[1] + s * along + c * up;
            qn_profile_hit a[4], b[4];
            CHECK(qn_profile_touch(&p, x, y, 0.1, a, 4) == 1);
            CHECK(qn_profile_touch(&q, x, y, 0.1, b, 4) == 1);
            CHECK_NEAR(a[0].x, b[0].x, 1e-12);
            CHECK_NEAR(a[0].y, b[0].y, 1e-12);
        }
        qn_profile_free(&p);
        qn_profile_free(&q);
    }
}

static void a_smooth_shell_is_felt_once_and_evenly_all_around(void)
{
    qn_drum_def d = drum_of(0.3, 0, 0, 0, 0);
    qn_profile p;
    CHECK_STATUS(qn_profile_build(&d, 0.005, &p));
    for (int i = 0; i < 36000; i++) {
        double s, c, rho = 0.1451;
        qn_sincos(i * (2 * QN_PI / 36000), &s, &c);
        qn_profile_hit hit[3];
        CHECK(qn_profile_touch(&p, rho * c, rho * s, 0.005, hit, 3) == 1);
        double depth = sqrt((hit[0].x - rho * c) * (hit[0].x - rho * c)
                            + (hit[0].y - rho * s) * (hit[0].y - rho * s));
        CHECK_NEAR(depth, 0.15 - rho, 2e-16);
        CHECK(qn_profile_touch(&p, 0.1449 * c, 0.1449 * s, 0.005, hit, 3) == 0);
    }
    qn_profile_hit hit[3];
    CHECK(qn_profile_touch(&p, 0, -0.1451, 0.005, hit, 3) == 1 && hit[0].feature >= p.count);
    CHECK(qn_profile_touch(&p, 0, 0, 0.005, hit, 3) == 0);
    qn_profile_free(&p);
}

static void a_rectangular_lifter_has_corners_where_it_should(void)
{
    qn_drum_def d = drum_of(0.3, 16, 0.006, 0.006, 0.006);
    qn_profile p;
    CHECK_STATUS(qn_profile_build(&d, 0.0015, &p));
    CHECK(p.count == 64);
    const qn_element *side = &p.elements[2];  // of lifter 0, from its top to the shell
    CHECK_NEAR(side->ax, 0.003, 1e-17);
    CHECK_NEAR(side->ay, -0.144, 1e-17);
    CHECK_NEAR(side->bx, 0.003, 1e-17);
    CHECK_NEAR(side->bx * side->bx + side->by * side->by, 0.0225, 1e-17);
    qn_profile_hit hit[4];
    // Over the top face, beside the side face, in the wedge of the corner between them.
    CHECK(qn_profile_touch(&p, 0.0029, -0.1427, 0.0015, hit, 4) == 1 && hit[0].feature == 1);
    CHECK(qn_profile_touch(&p, 0.0042, -0.1441, 0.0015, hit, 4) == 1 && hit[0].feature == 2);
    CHECK(qn_profile_touch(&p, 0.0031, -0.1439, 0.0015, hit, 4) == 1);
    CHECK(hit[0].feature == p.count + 2 && hit[0].x == side->ax && hit[0].y == side->ay);
    CHECK(qn_profile_touch(&p, 0.0041, -0.1429, 0.0015, hit, 4) == 0);
    // Where the lifter stands on the shell: side and shell, no corner.
    CHECK(qn_profile_touch(&p, 0.0044, -0.1485, 0.0015, hit, 4) == 2);
    CHECK(hit[0].feature == 2 && hit[1].feature == 3);
    CHECK_NEAR(hit[0].x, 0.003, 1e-16);
    CHECK_NEAR(hit[0].y, -0.1485, 1e-16);
    CHECK_NEAR(hit[1].x * 0.1485, -hit[1].y * 0.0044, 1e-16);
    CHECK(qn_profile_touch(&p, 0.0044, -0.1485, 0.0015, hit, 1) == 2);
    qn_profile_free(&p);
}

static void any_disc_that_overlaps_feels_the_nearest_point(void)
{
    double spiky[] = {-1, -1, 0.2, -0.9, 0.3, 0.4, 0.35, -0.9, 1, -1, 0.8, 0.9, 0, 0.2, -0.7, 1};
    qn_drum_def defs[4] = {drum_of(1, 5, 0.1, 0.03, 0.2), drum_of(1, 1, 0.2, 0, 0.1),
                           drum_of(1, 2, 0.2, 0.1, 0.1), line_of(spiky, 8)};
    for (int k = 0; k < 4; k++) {
        double reach = 0.06;
        qn_profile p;
        CHECK_STATUS(qn_profile_build(&defs[k], reach, &p));
        for (int i = 0; i < 20000; i++) {
            double x = uniform(-p.radius, p.radius), y = uniform(-p.radius, p.radius);
            double distance = qn_profile_distance(&p, x, y), best = INFINITY;
            CHECK_NEAR(fabs(distance), nearest_by_force(&p, x, y), 1e-15);
            CHECK(qn_profile_side(&p, x, y) == (distance < 0 ? QN_SIDE_OUTSIDE : QN_SIDE_INSIDE));
            if (distance < 0) continue;
            qn_profile_hit hit[16];
            int n = qn_profile_touch(&p, x, y, reach, hit, 16);
            CHECK((n > 0) == (distance < reach));
            for (int j = 0; j < n; j++) {
                CHECK(j == 0 || hit[j].feature > hit[j - 1].feature);
                best = qn_min(best, hypot(hit[j].x - x, hit[j].y - y));
            }
            if (n > 0) CHECK_NEAR(best, distance, 1e-15);
        }
        qn_profile_free(&p);
    }
}

static void the_signed_distance_has_the_right_sign_at_corners(void)
{
    double square[] = {-1, -1, -1, 1, 1, 1, 1, -1};  // clockwise, to be turned round
    qn_drum_def d = line_of(square, 4);
    qn_profile p;
    CHECK_STATUS(qn_profile_build(&d, 0.1, &p));
    CHECK_NEAR(qn_profile_distance(&p, 0, 0), 1, 1e-16);
    CHECK_NEAR(p.clear, 1, 1e-16);
    CHECK_NEAR(qn_profile_distance(&p, 0.9, 0.8), 0.1, 1e-15);
    CHECK_NEAR(qn_profile_distance(&p, 1.3, 1.4), -0.5, 1e-15);
    CHECK_NEAR(qn_profile_distance(&p, 1.3, 0), -0.3, 1e-15);
    qn_profile_free(&p);
    d = drum_of(0.3, 16, 0.006, 0.006, 0.006);
    CHECK_STATUS(qn_profile_build(&d, 0.0015, &p));
    CHECK_NEAR(qn_profile_distance(&p, 0.006, -0.14), 0.005, 1e-15);
    CHECK_NEAR(qn_profile_distance(&p, 0.001, -0.146), -0.002, 1e-15);
    CHECK_NEAR(qn_profile_distance(&p, 0.02, -0.16), 0.15 - hypot(0.02, 0.16), 1e-15);
    qn_profile_free(&p);
}

static void area_and_open_share_are_exact(void)
{
    double r = 0.15, b = 0.003, top = 0.144;
    qn_drum_def d = drum_of(2 * r, 16, r - top, 2 * b, 2 * b);
    qn_profile p;
    CHECK_STATUS(qn_profile_build(&d, 0.0015, &p));
    // A lifter covers its rectangle up to the chord of its base, and the segment beyond.
    double foot = sqrt(r * r - b * b), half = asin(b / r);
    double lifter = 2 * b * (foot - top) + r * r * (half - sin(half) * cos(half));
    CHECK_NEAR(qn_profile_area(&p), QN_PI * r * r - 16 * lifter, 1e-15);
    CHECK_NEAR(qn_profile_open_share(&p, 0.1), 1, 0);
    CHECK_NEAR(qn_profile_open_share(&p, 0.16), 0, 0);
    CHECK_NEAR(qn_profile_open_share(&p, 0.147), 1 - 16 * 2 * asin(b / 0.147) / (2 * QN_PI), 1e-14);
    double low = 0.14401;  // meets the top face, but not the sides
    CHECK_NEAR(qn_profile_open_share(&p, low), 1 - 16 * 2 * acos(top / low) / (2 * QN_PI), 1e-13);
    qn_profile_free(&p);
    double square[] = {-1, -1, 1, -1, 1, 1, -1, 1};
    d = line_of(square, 4);
    CHECK_STATUS(qn_profile_build(&d, 0.1, &p));
    CHECK_NEAR(qn_profile_area(&p), 4, 1e-15);
    CHECK_NEAR(qn_profile_open_share(&p, 1.2), 1 - 8 * acos(1 / 1.2) / (2 * QN_PI), 1e-15);
    qn_profile_free(&p);
}

static void the_facets_of_a_polygon_are_felt_one_at_a_time(void)
{
    enum { SIDES = 360 };
    double points[2 * SIDES];
    for (int i = 0; i < SIDES; i++)
        qn_sincos(i * (2 * QN_PI / SIDES), &points[2 * i + 1], &points[2 * i]);
    qn_drum_def d = line_of(points, SIDES);
    qn_profile p;
    CHECK_STATUS(qn_profile_build(&d, 0.02, &p));
    for (int i = 0; i < 20000; i++) {
        double s, c;
        qn_sincos(i * (2 * QN_PI / 20000), &s, &c);
        qn_profile_hit hit[4];
        CHECK(qn_profile_touch(&p, 0.981 * c, 0.981 * s, 0.02, hit, 4) == 1);
        CHECK_NEAR(hypot(hit[0].x - 0.981 * c, hit[0].y - 0.981 * s), 0.019, 4e-5);
    }
    qn_profile_free(&p);
}

static void impossible_profiles_are_refused(void)
{
    double crossing[] = {0, 0, 1, 1, 1, 0, 0, 1}, twice[] = {0, 0, 1, 0, 1, 0, 0, 1};
    double spike[] = {0, 0, 2, 0, 1, 0, 0, 1}, open[] = {0, 0, 1, 1, 0, 0};
    double odd[] = {0, 0, 1, 0, NAN, 1};
    const qn_drum_def bad[] = {
        line_of(crossing, 4),
        line_of(twice, 4),
        line_of(spike, 4),
        line_of(open, 3),
        line_of(odd, 3),
        drum_of(0, 0, 0, 0, 0),
        drum_of(1, 4, 0.6, 0.1, 0.1),
        drum_of(1, 4, 0.1, 0.1, 0),
        drum_of(1, 40, 0.1, 0.1, 0.1),
        drum_of(1, 4, 0.001, 0.2, 0.2),
        drum_of(1, 4, 0.1, 0.75, 0.05),
        drum_of(1, 20, 0.3, 0.09, 0.05),
        drum_of(1, 4, 0.001, 0.01, 0.2),
        drum_of(1, 20, 0.1, 0.01, 0.2),
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        qn_profile p;
        CHECK(qn_profile_build(&bad[k], 0.01, &p) == QN_INPUT);
        CHECK(strlen(qn_error()) > 20 && p.elements == NULL);
    }
    double closed[] = {0, 0, 1, 0, 0, 1, 0, 0};  // the first point once more
    qn_drum_def d = line_of(closed, 4);
    qn_profile p;
    CHECK_STATUS(qn_profile_build(&d, 0.01, &p));
    CHECK(p.count == 3);
    qn_profile_free(&p);
}

int main(int argc, char **argv)
{
    TEST(sine_and_cosine_agree_with_the_library);
    TEST(a_joint_in_a_straight_line_is_not_felt);
    TEST(a_smooth_shell_is_felt_once_and_evenly_all_around);
    TEST(a_rectangular_lifter_has_corners_where_it_should);
    TEST(any_disc_that_overlaps_feels_the_nearest_point);
    TEST(the_signed_distance_has_the_right_sign_at_corners);
    TEST(area_and_open_share_are_exact);
    TEST(the_facets_of_a_polygon_are_felt_one_at_a_time);
    TEST(impossible_profiles_are_refused);
    DONE;
}
