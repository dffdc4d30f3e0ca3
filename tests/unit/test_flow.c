// SPDX-License-Identifier: Apache-2.0
// Feeds and outlets: amounts, room, energy, history, resuming.
#include "check.h"
#include "worlds.h"

#include "measure/energy.h"
#include "world/flow.h"
#include "world/population.h"

// A box of 24 mm, empty at first, into which grains of three sizes fall.
static qn_def def_of_hopper(double rate, bool by_mass)
{
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.4, 0.5);
    qn_group_def *g = add_group(&def, "grain", 0.0015);
    const double diameter[] = {0.0015, 0.002, 0.003}, fraction[] = {0.5, 0.3, 0.2};
    g->size_count = 3;
    memcpy(g->diameter, diameter, sizeof diameter);
    memcpy(g->fraction, fraction, sizeof fraction);
    g->packing = QN_PACK_FEED;
    g->spin = qn_v3(0, 0, 30);
    add_box(&def, 0.024);
    def.feed_count = 1;
    def.feeds = calloc(1, sizeof *def.feeds);
    def.feeds[0] = (qn_feed_def){.name = "chute",
                                 .rate = rate,
                                 .by_mass = by_mass,
                                 .start = 2e-3,
                                 .stop = INFINITY,
                                 .low = {0.003, 0.017, 0.003},
                                 .high = {0.021, 0.024, 0.021},
                                 .velocity = {0.1, -0.5, 0}};
    def.step = 5e-6;
    def.end = (qn_span){1, QN_SECONDS};
    return def;
}

// A screen in the floor that only the smallest pass.
static void add_screen(qn_def *def, double aperture)
{
    size_t n = (size_t)def->outlet_count++;
    def->outlets = realloc(def->outlets, (n + 1) * sizeof *def->outlets);
    def->outlets[n] = (qn_outlet_def){.name = "screen",
                                      .point = {0.012, 0, 0.012},
                                      .normal = {0, -1, 0},
                                      .radius = 0.01,
                                      .aperture = aperture};
}

static qn_world *world_of(qn_def def, int threads)
{
    qn_world *w = NULL;
    if (qn_world_create(&def, threads, &w) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return w;
}

// Steps, and the balance at the first and the last of them.
static qn_status run(qn_world *w, int steps, qn_balance *first, qn_balance *last)
{
    QN_TRY(qn_step_forces(w, QN_PROBE));
    QN_TRY(qn_balance_now(w, first));
    QN_TRY(take_steps(w, steps));
    QN_TRY(qn_step_forces(w, QN_PROBE));
    return qn_balance_now(w, last);
}

static void a_feed_gives_its_number_into_an_empty_box(void)
{
    qn_balance first, last;
    qn_def def = def_of_hopper(5000, false);
    def.step = 2.5e-6;
    qn_world *w = world_of(def, 2);
    CHECK(w && w->count == 0);
    CHECK_STATUS(run(w, 16000, &first, &last));
    CHECK(w->count >= 183 && w->count <= 190);  // 5000 in (40 - 2) ms, less what an occasion waits
    CHECK(w->flow->next_id == w->count + 1);
    CHECK(w->ledger.deepest < 0.05);
    CHECK(w->flow->energy[0] > 0);
    CHECK_NEAR(qn_balance_residual(&last, &first) / qn_balance_turnover(&last, &first), 0, 2e-3);
    qn_world_destroy(w);
}

static void a_feed_by_mass_gives_its_mass_and_its_sizes(void)
{
    double given, asked;
    qn_def def = def_of_hopper(0.05, true);
    def.feeds[0].stop = 0.06;
    qn_world *w = world_of(def, 1);
    CHECK_STATUS(take_steps(w, 14000));
    double wanted = 0.05 * 0.058, mass = qn_flow_mass(w, w->flow->fed);
    CHECK_NEAR(mass, wanted, 0.51 * w->classes[2].mass);
    CHECK(!qn_flow_is_short(w, 0, &given, &asked));
    CHECK_NEAR(asked, wanted, 1e-12);
    double n = (double)w->count, variance = 0;
    const double fraction[] = {0.5, 0.3, 0.2};
    for (int s = 0; s < 3; s++) {
        double away = (double)w->flow->fed[s] - n * fraction[s];
        variance += away * away / (n * fraction[s]);  // chi squared of two degrees of freedom
    }
    CHECK(n > 200 && variance < 12);
    qn_world_destroy(w);
}

// Spheres of one size, as many as there is room for, at the feed's first occasion.
static qn_world *world_at_first_intake(bool is_disc)
{
    qn_def def = def_of_hopper(1e9, false);
    def.groups[0].size_count = 1;
    def.groups[0].fraction[0] = 1;
    if (is_disc) {
        def.feeds[0].is_disc = true;
        def.feeds[0].centre = qn_v3(0.012, 0.02, 0.012);
        def.feeds[0].normal = qn_v3(0, 1, 0);
        def.feeds[0].radius = 0.009;
    }
    qn_world *w = world_of(def, 1);
    for (int i = 0; i < 2000 && w->count == 0; i++)
        if (take_steps(w, 1) != QN_OK) break;
    return w;
}

static void what_a_box_feeds_fills_it_well_but_stands_in_no_columns(void)
{
    qn_world *w = world_at_first_intake(false);
    const qn_feed_def *f = &w->def.feeds[0];
    double radius = w->classes[0].radius, step = 1e-3 * radius;
    CHECK(w->count > 0.5 * w->flow->feeds[0].site_count);
    int above = 0;
    for (int i = 0; i < w->count; i++) {
        qn_vec3 x = qn_world_position(w, i);
        CHECK(x.x >= f->low.x + radius && x.x <= f->high.x - radius);
        CHECK(x.y >= f->low.y + radius - step && x.y <= f->high.y - radius);
        CHECK(x.z >= f->low.z + radius && x.z <= f->high.z - radius);
        for (int j = 0; j < i; j++) {
            qn_vec3 y = qn_world_position(w, j);
            above += fabs(x.x - y.x) < step && fabs(x.z - y.z) < step;
        }
    }
    CHECK(above == 0);
    qn_world_destroy(w);
}

static void what_a_disc_feeds_lies_scattered_in_it(void)
{
    qn_world *w = world_at_first_intake(true);
    double radius = w->classes[0].radius;
    int off = 0;
    CHECK(w->count > 0.5 * w->flow->feeds[0].site_count);
    for (int i = 0; i < w->count; i++) {
        qn_vec3 d = qn_sub(qn_world_position(w, i), w->def.feeds[0].centre);
        CHECK(fabs(d.y) < 1e-4 && hypot(d.x, d.z) <= 0.009 - radius + 1e-6);
        double cells = d.x / (2 * radius * 1.02);
        off += fabs(cells - nearbyint(cells)) > 0.02;
    }
    CHECK(off > w->count / 4);
    qn_world_destroy(w);
}

static void what_finds_no_room_waits(void)
{
    double given, asked;
    qn_def def = def_of_hopper(1e6, false);
    qn_world *w = world_of(def, 1);
    for (int i = 0; i < 3000; i++) {
        int before = w->count;
        CHECK_STATUS(take_steps(w, 1));
        if (w->count > before) {  // what has come in touches nothing
            CHECK_STATUS(qn_step_forces(w, QN_PROBE));
            for (int64_t id = before + 1; id <= w->count; id++)
                for (int j = 0; j < w->count; j++) {
                    int k = 0;
                    while (w->id[k] != id) k++;
                    if (k == j) continue;
                    double x = w->place[k].x - w->place[j].x, y = w->place[k].y - w->place[j].y;
                    double z = w->place[k].z - w->place[j].z;
                    double reach =
                        w->classes[w->place[k].klass].radius + w->classes[w->place[j].klass].radius;
                    CHECK(x * x + y * y + z * z > reach * reach);
                }
        }
    }
    CHECK(w->count > 50 && w->count < 1000);
    CHECK(qn_flow_is_short(w, 0, &given, &asked));
    CHECK(given == (double)w->count);
    CHECK_NEAR(asked, 1e6 * (3000 * w->dt - 2e-3), 1e-6 * asked);
    CHECK(w->ledger.deepest < 0.1);
    qn_world_destroy(w);
}

static void a_screen_lets_only_the_smaller_pass_and_the_energy_adds_up(void)
{
    qn_balance first, last;
    qn_def def = def_of_hopper(4000, false);
    add_screen(&def, 0.0018);
    def.step = 2.5e-6;
    qn_world *w = world_of(def, 2);
    CHECK_STATUS(run(w, 28000, &first, &last));
    const int64_t *taken = w->flow->taken, *fed = w->flow->fed;
    CHECK(taken[0] > 20 && taken[1] == 0 && taken[2] == 0);
    CHECK(w->count == fed[0] + fed[1] + fed[2] - taken[0]);
    CHECK(w->flow->energy[1] > 0);
    CHECK(last.elastic_normal > 0);
    CHECK_NEAR(qn_balance_residual(&last, &first) / qn_balance_turnover(&last, &first), 0, 2e-3);
    qn_world_destroy(w);
}

// In a bed, all above some height leave at once: their contacts' energy must leave with them.
static void what_leaves_a_bed_takes_the_energy_of_its_contacts(void)
{
    qn_balance first, before, after;
    qn_def def = def_of_hopper(20000, false);
    def.gravity = qn_v3(0, -98.1, 0);
    def.feeds[0].stop = 0.02;
    def.outlet_count = 1;
    def.outlets = calloc(1, sizeof *def.outlets);
    def.outlets[0] = (qn_outlet_def){.is_box = true, .low = {1, 1, 1}, .high = {2, 2, 2}};
    qn_world *w = world_of(def, 1);
    CHECK_STATUS(run(w, 16000, &first, &before));
    int64_t left = w->flow->outlet_stride - w->step % w->flow->outlet_stride;
    CHECK_STATUS(take_steps(w, (int)left));
    CHECK_STATUS(qn_step_forces(w, QN_PROBE));
    CHECK_STATUS(qn_balance_now(w, &before));
    w->def.outlets[0].low = qn_v3(0, 0.003, 0), w->def.outlets[0].high = qn_v3(1, 1, 1);
    CHECK_STATUS(take_steps(w, 1));
    CHECK_STATUS(qn_step_forces(w, QN_PROBE));
    CHECK_STATUS(qn_balance_now(w, &after));
    double gone = before.elastic_normal + before.elastic_tangential - after.elastic_normal
                  - after.elastic_tangential;
    double jump = qn_balance_residual(&after, &before);
    CHECK(qn_flow_count(w, w->flow->taken) > 100 && w->count > 50);
    CHECK(gone > 0.2 * before.elastic_normal);
    CHECK_NEAR(jump / gone, 0, 0.02);
    qn_world_destroy(w);
}

static void what_falls_freely_takes_out_the_energy_it_brought_in(void)
{
    qn_def def = def_of_hopper(1000, false);
    def.outlet_count = 1;
    def.outlets = calloc(1, sizeof *def.outlets);
    def.outlets[0] = (qn_outlet_def){.name = "hole", .is_box = true, .high = {1, 0.01, 1}};
    def.groups[0].size_count = 1;
    def.feeds[0].velocity = qn_v3(0, -0.5, 0);
    def.feeds[0].stop = 0.003;
    qn_world *w = world_of(def, 1);
    CHECK_STATUS(take_steps(w, 20000));
    CHECK(w->count == 0 && w->flow->fed[0] == 1 && w->flow->taken[0] == 1);
    CHECK_NEAR(w->flow->energy[1] / w->flow->energy[0], 1, 1e-9);
    double mass = w->classes[0].mass, spin = 0.5 * w->classes[0].inertia * 900;
    double y = (w->flow->energy[0] - 0.125 * mass - spin) / (9.81 * mass);
    CHECK(y > 0.017 && y < 0.024);
    qn_world_destroy(w);
}

// The hopper with its screen and a second outlet, at `steps`, from a state at step `from` on.
static uint64_t hash_after(int from, int steps, int threads)
{
    qn_def def = def_of_hopper(6000, false), again;
    add_screen(&def, 0.0018);
    qn_world *w = world_of(def, threads);
    uint64_t hash = 0;
    if (from > 0) {
        qn_state state;
        qn_column columns[QN_FLOW_COLUMNS], fresh[QN_FLOW_COLUMNS];
        again = def_of_hopper(6000, false);
        add_screen(&again, 0.0018);
        qn_world *other = world_of(again, threads);
        if (take_steps(w, from) != QN_OK || qn_world_export(w, &state) != QN_OK) return 0;
        if (qn_world_import(other, &state) != QN_OK) return 0;
        qn_flow_columns(w->flow, columns);
        qn_flow_columns(other->flow, fresh);
        for (int c = 0; c < QN_FLOW_COLUMNS; c++)
            memcpy(fresh[c].data, columns[c].data,
                   8 * (size_t)columns[c].width * (size_t)columns[c].rows);
        qn_state_free(&state);
        qn_world_destroy(w);
        w = other;
    }
    if (take_steps(w, steps - from) == QN_OK) hash = hash_of(w);
    if (w->flow->taken[0] == 0) hash = 0;
    qn_world_destroy(w);
    return hash;
}

static void a_run_with_flow_is_the_same_for_any_threads_and_after_any_stop(void)
{
    uint64_t hash = hash_after(0, 10000, 1);
    CHECK(hash != 0);
    CHECK(hash_after(0, 10000, 3) == hash);
    const int at[] = {1, 777, 6000, 9501};
    for (int k = 0; k < 4; k++) CHECK(hash_after(at[k], 10000, 1 + k % 2) == hash);
}

// Sum of all displacements (m), of particles and walls.
static double sum_of_slip(const qn_state *s)
{
    double sum = 0;
    for (int64_t k = 0; k < 3 * s->contact_count; k++) sum += fabs(s->slip[k]);
    for (int64_t k = 0; k < 3 * s->wall_contact_count; k++) sum += fabs(s->wall_slip[k]);
    return sum;
}

static double slip_of(const qn_world *w)
{
    qn_state s;
    if (qn_world_export(w, &s) != QN_OK) return NAN;
    double sum = sum_of_slip(&s);
    qn_state_free(&s);
    return sum;
}

static void those_who_stay_keep_their_contacts(void)
{
    qn_state before, after;
    qn_def def = def_of_hopper(20000, false);
    def.gravity = qn_v3(0, -98.1, 0);
    qn_world *w = world_of(def, 2);
    CHECK_STATUS(take_steps(w, 11000));
    CHECK_STATUS(qn_world_export(w, &before));
    bool *gone = calloc((size_t)w->count, sizeof *gone);
    for (int i = 0; i < w->count; i++) gone[i] = w->id[i] % 5 == 0;
    CHECK_STATUS(qn_population_change(w, gone, NULL, 0, 0));
    CHECK_STATUS(qn_world_export(w, &after));
    int64_t n = 0, walls = 0;
    for (int64_t k = 0; k < before.contact_count; k++) {
        if (before.low[k] % 5 == 0 || before.high[k] % 5 == 0) continue;
        CHECK(n < after.contact_count);
        CHECK(after.low[n] == before.low[k] && after.high[n] == before.high[k]);
        CHECK(!memcmp(&after.slip[3 * n], &before.slip[3 * k], 3 * sizeof(double)));
        n++;
    }
    for (int64_t k = 0; k < before.wall_contact_count; k++) walls += before.wall_id[k] % 5 != 0;
    CHECK(n > 50 && n == after.contact_count && n < before.contact_count);
    CHECK(walls > 20 && walls == after.wall_contact_count);
    CHECK_STATUS(take_steps(w, 1));
    free(gone);
    CHECK_NEAR(slip_of(w) / sum_of_slip(&after), 1, 0.05);
    qn_state_free(&before);
    qn_state_free(&after);
    qn_world_destroy(w);
}

static void a_disc_feeds_a_periodic_drum(void)
{
    qn_def def = def_of_mill(200, QN_ENDS_PERIODIC);
    add_group(&def, "rock", 0.002)->packing = QN_PACK_FEED;
    def.feed_count = 1;
    def.feeds = calloc(1, sizeof *def.feeds);
    def.feeds[0] = (qn_feed_def){.name = "rocks",
                                 .group = 1,
                                 .rate = 3000,
                                 .stop = INFINITY,
                                 .is_disc = true,
                                 .centre = {0, 0.01, 0.0005},
                                 .normal = {0, 1, 0},
                                 .radius = 0.006};
    qn_world *w = world_of(def, 2);
    CHECK(w && w->flow->feeds[0].site_count > 20);
    CHECK_STATUS(take_steps(w, 4000));
    CHECK(w->count > 240 && w->count <= 320 && w->flow->fed[0] == 0);
    CHECK(w->ledger.deepest < 0.3);
    qn_world_destroy(w);
}

static void a_region_with_no_or_far_too_much_room_is_said(void)
{
    qn_world *w = NULL;
    qn_def def = def_of_hopper(10, false);
    def.feeds[0].high.y = 0.019;
    CHECK(qn_world_create(&def, 1, &w) == QN_INPUT);
    CHECK(strstr(qn_error(), "feeds.chute: its region has no room for a sphere of 0.003 m"));
    def = def_of_hopper(10, false);
    def.feeds[0].high = qn_v3(1e6, 1e6, 1e6);
    CHECK(qn_world_create(&def, 1, &w) == QN_INPUT);
    CHECK(strstr(qn_error(), "feeds.chute: its region has more than 1000000 places"));
    def = def_of_hopper(10, false);
    def.feeds[0].low.y = -0.007, def.feeds[0].high.y = 0;
    CHECK(qn_world_create(&def, 1, &w) == QN_INPUT);
    CHECK(strstr(qn_error(), "feeds.chute: its region has no room within the walls"));
    def = def_of_hopper(10, false);
    def.feeds[0].is_disc = true;
    def.feeds[0].normal = qn_v3(0, 1, 0);
    def.feeds[0].radius = 1e6;
    CHECK(qn_world_create(&def, 1, &w) == QN_INPUT);
    CHECK(strstr(qn_error(), "more than 1000000 places"));
}

int main(int argc, char **argv)
{
    TEST(a_feed_gives_its_number_into_an_empty_box);
    TEST(a_feed_by_mass_gives_its_mass_and_its_sizes);
    TEST(what_a_box_feeds_fills_it_well_but_stands_in_no_columns);
    TEST(what_a_disc_feeds_lies_scattered_in_it);
    TEST(what_finds_no_room_waits);
    TEST(a_screen_lets_only_the_smaller_pass_and_the_energy_adds_up);
    TEST(what_leaves_a_bed_takes_the_energy_of_its_contacts);
    TEST(what_falls_freely_takes_out_the_energy_it_brought_in);
    TEST(a_run_with_flow_is_the_same_for_any_threads_and_after_any_stop);
    TEST(those_who_stay_keep_their_contacts);
    TEST(a_disc_feeds_a_periodic_drum);
    TEST(a_region_with_no_or_far_too_much_room_is_said);
    DONE;
}
