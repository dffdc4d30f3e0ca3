// SPDX-License-Identifier: Apache-2.0
// Size distributions against their closed forms: cumulative curves and moments.
#include "base/sizes.h"
#include "check.h"

#include <math.h>
#include <string.h>

enum { ROOM = 64 };

typedef struct table {
    int count;
    double diameter[ROOM], fraction[ROOM];
} table;

static table classes_of(qn_size_def def)
{
    table t = {0};
    if (qn_size_classes(&def, t.diameter, t.fraction, &t.count) != QN_OK) t.count = 0;
    return t;
}

// Mean of d^power by number.
static double moment(const table *t, double power)
{
    double sum = 0;
    for (int i = 0; i < t->count; i++) sum += t->fraction[i] * pow(t->diameter[i], power);
    return sum;
}

// Share of number (power 0) or of mass (power 3) in the classes below index `end`.
static double share(const table *t, int end, double power)
{
    double sum = 0;
    for (int i = 0; i < end; i++) sum += t->fraction[i] * pow(t->diameter[i], power);
    return sum / moment(t, power);
}

static const qn_size_def examples[] = {
    {QN_SIZES_NORMAL, false, 3e-3, 0.5e-3, 1e-3, 5e-3, 12},
    {QN_SIZES_NORMAL, true, 3e-3, 0.5e-3, 1e-3, 5e-3, 12},
    {QN_SIZES_LOGNORMAL, true, 2e-3, 0.4, 0.5e-3, 8e-3, 16},
    {QN_SIZES_LOGNORMAL, false, 2e-3, 0.4, 0.5e-3, 8e-3, 5},
    {QN_SIZES_ROSIN_RAMMLER, true, 2e-3, 1.1, 0.5e-3, 6e-3, 12},
    {QN_SIZES_ROSIN_RAMMLER, false, 2e-3, 1.1, 0.5e-3, 6e-3, 12},
    {QN_SIZES_GAUDIN_SCHUHMANN, true, 6e-3, 0.5, 0.6e-3, 6e-3, 12},
    {QN_SIZES_GAUDIN_SCHUHMANN, false, 6e-3, 0.5, 0.6e-3, 6e-3, 1},
};

static void the_cumulative_curve_is_kept_at_the_ends_of_every_class(void)
{
    for (size_t e = 0; e < sizeof examples / sizeof *examples; e++) {
        const qn_size_def *s = &examples[e];
        table t = classes_of(*s);
        CHECK(t.count == s->classes);
        double low = qn_size_below(s, s->min), all = qn_size_below(s, s->max) - low;
        for (int k = 0; k <= s->classes; k++) {
            double d = s->min * pow(s->max / s->min, (double)k / s->classes);
            CHECK_NEAR(share(&t, k, s->by_mass ? 3 : 0), (qn_size_below(s, d) - low) / all, 1e-11);
            if (k < s->classes) CHECK(t.diameter[k] > d);
            if (k > 0) CHECK(t.diameter[k - 1] < d);
        }
    }
}

// By mass Phi(ln(d/m)/s), a lognormal is one by number too, with the median m exp(-3 s^2) (Hatch &
// Choate 1929, J. Franklin Inst. 207, 369).
static void a_lognormal_by_mass_is_hatch_and_choates_by_number(void)
{
    qn_size_def s = {QN_SIZES_LOGNORMAL, true, 2e-3, 0.3, 0.5e-3, 8e-3, 20};
    qn_size_def other = s;
    other.by_mass = false;
    other.first = s.first * exp(-3 * s.second * s.second);
    table t = classes_of(s), u = classes_of(other);
    for (int k = 0; k < 20; k++) {
        CHECK_NEAR(t.diameter[k] / u.diameter[k], 1, 1e-9);
        CHECK_NEAR(t.fraction[k], u.fraction[k], 1e-11);
    }
}

static void wide_lognormals_have_their_closed_mean_volume(void)
{
    for (int classes = 1; classes <= 64; classes += 21) {
        qn_size_def s = {QN_SIZES_LOGNORMAL, false, 2e-3, 0.25, 2e-4, 2e-2, classes};
        table t = classes_of(s);
        double expected = pow(s.first, 3) * exp(4.5 * s.second * s.second);
        CHECK_NEAR(moment(&t, 3) / expected, 1, 1e-10);
    }
}

// By number, with volume 1/d^3 each: N = m/(m - 3) (max^(m-3) - min^(m-3))/top^m, and the mass is
// (max^m - min^m)/top^m.
static void gaudin_schuhmann_has_its_closed_mean_volume(void)
{
    for (double m = 0.5; m < 2; m += 0.7) {
        qn_size_def s = {QN_SIZES_GAUDIN_SCHUHMANN, true, 6e-3, m, 0.6e-3, 6e-3, 7};
        table t = classes_of(s);
        double mass = pow(6e-3, m) - pow(0.6e-3, m);
        double number = m / (m - 3) * (pow(6e-3, m - 3) - pow(0.6e-3, m - 3));
        CHECK_NEAR(moment(&t, 3) / (mass / number), 1, 1e-11);
    }
}

// By number, the third moment of exp(-(d/a)^n) is a^3 Gamma(1 + 3/n).
static void rosin_rammler_has_its_closed_mean_volume(void)
{
    for (double n = 1; n < 4; n += 1) {
        qn_size_def s = {QN_SIZES_ROSIN_RAMMLER, false, 2e-3, n, 1e-13, 0.1, 64};
        table t = classes_of(s);
        CHECK_NEAR(moment(&t, 3) / (8e-9 * tgamma(1 + 3 / n)), 1, 1e-9);
    }
}

static void a_normal_by_number_has_its_closed_moments(void)
{
    qn_size_def s = {QN_SIZES_NORMAL, false, 3e-3, 0.2e-3, 1.2e-3, 4.8e-3, 60};
    table t = classes_of(s);
    double m = 3e-3, v = 0.04e-6;
    CHECK_NEAR(moment(&t, 3) / (m * m * m + 3 * m * v), 1, 1e-10);
    CHECK_NEAR(moment(&t, 1) / m, 1, 2e-4);  // classes keep the volume, the mean diameter nearly
}

static void a_narrow_distribution_leaves_empty_classes_out(void)
{
    qn_size_def s = {QN_SIZES_LOGNORMAL, true, 2e-3, 0.01, 0.2e-3, 20e-3, 16};
    table t = classes_of(s);
    CHECK(t.count >= 1 && t.count <= 2);
    CHECK_NEAR(moment(&t, 3) / pow(2e-3, 3), 1, 0.01);
}

static void nothing_between_the_ends_is_said(void)
{
    qn_size_def s = {QN_SIZES_LOGNORMAL, true, 2e-3, 0.01, 10e-3, 20e-3, 16};
    table t;
    CHECK(qn_size_classes(&s, t.diameter, t.fraction, &t.count) == QN_INPUT);
    CHECK(strstr(qn_error(), "nothing between 0.01 and 0.02 m"));
}

int main(int argc, char **argv)
{
    TEST(the_cumulative_curve_is_kept_at_the_ends_of_every_class);
    TEST(a_lognormal_by_mass_is_hatch_and_choates_by_number);
    TEST(wide_lognormals_have_their_closed_mean_volume);
    TEST(gaudin_schuhmann_has_its_closed_mean_volume);
    TEST(rosin_rammler_has_its_closed_mean_volume);
    TEST(a_normal_by_number_has_its_closed_moments);
    TEST(a_narrow_distribution_leaves_empty_classes_out);
    TEST(nothing_between_the_ends_is_said);
    DONE;
}
