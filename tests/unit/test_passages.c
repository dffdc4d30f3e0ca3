// SPDX-License-Identifier: Apache-2.0
// Power by passage: mean, error and steadiness of powers made up for the purpose.
#include "check.h"
#include "fake_mill.h"
#include "measure/passages.h"

typedef double power_at(int passage, uint64_t *seed);

/// Runs through the passages of a mill of 16 lifters that turns at 2 rad/s, the power of each as
/// `power` says (W), all of it done by the first part that turns.
static qn_power after_passages(int count, power_at *power, qn_passages *p)
{
    static qn_world *w;
    if (w) fake_free(w);
    w = fake_mill(16, 2, 0.001, 0.001);
    uint64_t seed = 3;
    int part = 0;
    while (!w->walls.parts[part].turning) part++;
    if (qn_passages_create(w, 100, INT64_MAX, p) != QN_OK) abort();
    w->ledger.work[part] = 17;
    qn_balance balance = {.lost = 5, .stored = 1};
    for (int k = 0; k <= count; k++) {
        int64_t before = w->step;
        w->step = p->next_step;
        double length = (double)(w->step - before) * w->dt;
        if (k > 0) {
            w->ledger.work[part] += length * power(k, &seed);
            balance.lost += length * 3;
            balance.stored += length * 0.25;
        }
        qn_passages_sample(p, w, &balance);
    }
    return qn_passages_power(p);
}

static double constant(int passage, uint64_t *seed)
{
    (void)passage, (void)seed;
    return 4;
}

static double noisy(int passage, uint64_t *seed)
{
    (void)passage;
    return 4 + fake_uniform(seed, -1, 1);
}

static double correlated(int passage, uint64_t *seed)
{
    static double level;
    level = passage == 1 ? 0 : 0.9 * level + 0.1 * fake_uniform(seed, -10, 10);
    return 4 + level;
}

static double rising(int passage, uint64_t *seed)
{
    return 4 + 0.02 * passage + fake_uniform(seed, -0.1, 0.1);
}

static void constant_power_is_told_as_it_is(void)
{
    static qn_passages p;
    qn_power power = after_passages(32, constant, &p);
    CHECK(power.passages == 32 && power.steady);
    CHECK_NEAR(power.torque, 4, 1e-12);
    CHECK_NEAR(power.standard_error, 0, 1e-12);
    CHECK_NEAR(power.dissipated, 3, 1e-12);
    CHECK_NEAR(power.storing, 0.25, 1e-12);
    CHECK_NEAR(power.window, 2 * QN_PI / 2 * 2, 1e-3);
    CHECK_NEAR(qn_passages_part_power(&p, 0) + qn_passages_part_power(&p, 1), 4, 1e-12);
    qn_passages_free(&p);
}

static void the_error_of_noise_is_that_of_theory(void)
{
    static qn_passages p;
    qn_power power = after_passages(800, noisy, &p);
    double theory = sqrt(1.0 / 3 / 800);
    CHECK_NEAR(power.torque, 4, 4 * theory);
    CHECK(power.standard_error > 0.9 * theory && power.standard_error < 2 * theory);
    CHECK(power.steady);
    qn_passages_free(&p);
}

static void correlation_makes_the_error_larger(void)
{
    static qn_passages p;
    qn_power power = after_passages(1000, correlated, &p);
    double naive = sqrt(1.0 / 3 / 0.19 / 1000), theory = naive * sqrt(1.9 / 0.1);
    CHECK(power.standard_error > 0.5 * theory && power.standard_error < 2 * theory);
    qn_passages_free(&p);
}

static void a_rising_power_is_not_steady(void)
{
    static qn_passages p;
    qn_power power = after_passages(48, rising, &p);
    CHECK_NEAR(power.drift, 0.02 * 48, 0.15);
    CHECK(!power.steady);
    qn_passages_free(&p);
}

static void a_window_may_be_longer_than_the_notes(void)
{
    static qn_passages p;
    qn_power power = after_passages(QN_PASSAGES_MAX + 100, constant, &p);
    CHECK(p.stride == 2 && p.count == QN_PASSAGES_MAX / 2 + 101);
    CHECK(power.passages == QN_PASSAGES_MAX + 200 && power.steady);
    CHECK_NEAR(power.torque, 4, 1e-12);
    CHECK_NEAR(power.window, (QN_PASSAGES_MAX + 200) * QN_PI / 16, 2e-3);
    qn_passages_free(&p);
}

static void too_few_passages_say_nothing(void)
{
    static qn_passages p;
    CHECK(isnan(after_passages(0, constant, &p).torque));
    qn_passages_free(&p);
    qn_power power = after_passages(2, constant, &p);
    CHECK(power.passages == 2 && !power.steady);
    CHECK_NEAR(power.torque, 4, 1e-12);
    qn_passages_free(&p);
}

static void boundaries_fall_on_the_nearest_steps_within_the_window(void)
{
    qn_world *w = fake_mill(16, -2, 0.001, 0.001);
    qn_passages p;
    qn_balance balance = {0};
    CHECK_STATUS(qn_passages_create(w, 100, 100 + 393, &p));
    for (w->step = 0; w->step < 1000; w->step++) qn_passages_sample(&p, w, &balance);
    CHECK(p.count == 3 && p.step[0] == 100 && p.step[1] == 296 && p.step[2] == 493);
    qn_passages_free(&p), fake_free(w);
}

int main(int argc, char **argv)
{
    TEST(constant_power_is_told_as_it_is);
    TEST(the_error_of_noise_is_that_of_theory);
    TEST(correlation_makes_the_error_larger);
    TEST(a_rising_power_is_not_steady);
    TEST(a_window_may_be_longer_than_the_notes);
    TEST(too_few_passages_say_nothing);
    TEST(boundaries_fall_on_the_nearest_steps_within_the_window);
    DONE;
}
