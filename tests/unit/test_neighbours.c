// SPDX-License-Identifier: Apache-2.0
// The pair list over a wide range of sizes, against trying all pairs.
#include "check.h"
#include "worlds.h"

#include "base/random.h"
#include "world/sorter.h"

// Spheres anywhere in a drum's inner box, into each other too: the list does not mind.
static void scatter(qn_def *def, const char *name, int material, double diameter, int count)
{
    const double half = 0.018, length = def->drum.length;
    qn_group_def *g = add_group(def, name, diameter);
    g->material = material;
    g->packing = QN_PACK_LIST;
    g->list_count = count;
    g->list_position = malloc(3 * (size_t)count * sizeof(double));
    for (int i = 0; i < 3 * count; i++) {
        double u = qn_random(7, (uint64_t)(diameter * 1e6), (uint64_t)i);
        double margin = def->drum.ends == QN_ENDS_PERIODIC ? 0 : diameter / 2;
        g->list_position[i] =
            i % 3 == 2 ? margin + u * (length - 2 * margin) : (2 * u - 1) * (half - diameter / 2);
    }
}

// Four sizes over 1:10 in three groups of two materials, in a drum.
static qn_world *mixture(qn_ends ends, int threads)
{
    qn_world *world = NULL;
    qn_def def = def_of_mill(0, ends);
    def.group_count = 0;
    def.drum.length = 0.02;
    scatter(&def, "balls", 0, 0.008, 8);
    scatter(&def, "rock", 1, 0.004, 40);
    scatter(&def, "sand", 0, 0.0024, 1000);
    scatter(&def, "dust", 1, 0.00078, 3000);
    def.step = 1e-6;
    if (qn_world_create(&def, threads, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

static double apart2(const qn_world *w, int i, int j)
{
    double x = w->place[i].x - w->place[j].x, y = w->place[i].y - w->place[j].y;
    double z = w->place[i].z - w->place[j].z;
    if (w->period > 0) z -= w->period * floor(z / w->period + 0.5);
    return x * x + y * y + z * z;
}

// How often each pair stands in the list, at times[i * count + j] with i below j; the caller frees it.
static unsigned char *times_listed(const qn_world *w, bool *near)
{
    size_t n = (size_t)w->count;
    unsigned char *times = calloc(n * n, 1);
    for (int t = 0; t < w->neighbours->share_count; t++) {
        const qn_share *share = &w->neighbours->shares[t];
        for (int i = share->first; i < share->last; i++)
            for (int64_t k = share->row[i - share->first]; k < share->row[i - share->first + 1];
                 k++) {
                bool lower;
                int at = qn_partner(share, k, &lower), j = w->place[at].home;
                double x = w->place[i].x - w->place[at].x, y = w->place[i].y - w->place[at].y;
                double z = w->place[i].z - w->place[at].z;
                *near &= fabs(x * x + y * y + z * z - apart2(w, i, j)) < 1e-12;
                times[(size_t)(i < j ? i : j) * n + (size_t)(i < j ? j : i)]++;
            }
    }
    return times;
}

static void check_list(qn_ends ends, int threads)
{
    qn_world *w = mixture(ends, threads);
    CHECK(w);
    CHECK_STATUS(qn_neighbours_rebuild(w));
    CHECK(w->neighbours->sorter->level_count == 3);
    bool near = true, exact = true;
    unsigned char *times = times_listed(w, &near);
    int64_t listed = 0, across = 0;
    for (int i = 0; i < w->count; i++)
        for (int j = i + 1; j < w->count; j++) {
            double reach = w->classes[w->place[i].klass].radius
                           + w->classes[w->place[j].klass].radius + w->neighbours->skin;
            bool wanted = apart2(w, i, j) < reach * reach;
            exact &= times[(size_t)i * (size_t)w->count + (size_t)j] == wanted;
            listed += wanted;
            across += wanted && fabs(w->place[i].z - w->place[j].z) > w->def.drum.length / 2;
        }
    CHECK(near);
    CHECK(exact);
    CHECK(listed > 1500);
    CHECK(ends != QN_ENDS_PERIODIC || across > 50);
    free(times);
    qn_world_destroy(w);
}

static void every_near_pair_of_ten_to_one_stands_in_the_list_once(void)
{
    check_list(QN_ENDS_FIXED, 1);
    check_list(QN_ENDS_FIXED, 3);
}

static void every_near_pair_across_periodic_ends_stands_in_the_list_once(void)
{
    check_list(QN_ENDS_PERIODIC, 1);
    check_list(QN_ENDS_PERIODIC, 3);
}

static qn_vec3 mark_of(int64_t a, int64_t b)
{
    return qn_v3((double)(a < b ? a : b), (double)(a < b ? b : a), 1);
}

// Gives every listed pair a history that says which pair it is, or checks that it has it.
static bool marks(qn_world *w, bool check)
{
    bool good = true;
    for (int t = 0; t < w->neighbours->share_count; t++) {
        qn_share *share = &w->neighbours->shares[t];
        for (int i = share->first; i < share->last; i++)
            for (int64_t k = share->row[i - share->first]; k < share->row[i - share->first + 1];
                 k++) {
                bool lower;
                int j = w->place[qn_partner(share, k, &lower)].home;
                qn_vec3 mark = mark_of(w->id[i], w->id[j]), *slip = &share->slip[k];
                good &= lower == (w->id[j] < w->id[i]);
                if (check)
                    good &= share->touching[k] && slip->x == mark.x && slip->y == mark.y;
                else
                    share->touching[k] = 1, *slip = mark;
            }
    }
    return good;
}

static void history_follows_its_pair_through_a_rebuild_and_a_file(void)
{
    for (int periodic = 0; periodic < 2; periodic++) {
        qn_world *w = mixture(periodic ? QN_ENDS_PERIODIC : QN_ENDS_FIXED, 2);
        qn_world *other = mixture(periodic ? QN_ENDS_PERIODIC : QN_ENDS_FIXED, 1);
        qn_state state;
        CHECK(w && other);
        CHECK_STATUS(qn_neighbours_rebuild(w));
        CHECK(marks(w, false));
        CHECK_STATUS(qn_neighbours_rebuild(w));
        CHECK(marks(w, true));
        CHECK_STATUS(qn_world_export(w, &state));
        CHECK_STATUS(qn_world_import(other, &state));
        CHECK_STATUS(qn_neighbours_rebuild(other));
        CHECK(marks(other, true));
        CHECK(state.contact_count > 1500);
        qn_state_free(&state);
        qn_world_destroy(w);
        qn_world_destroy(other);
    }
}

static void a_large_ball_among_many_small_ones_keeps_rows_short(void)
{
    qn_world *w = mixture(QN_ENDS_FIXED, 1);
    CHECK(w);
    CHECK_STATUS(qn_neighbours_rebuild(w));
    marks(w, false);
    CHECK_STATUS(qn_neighbours_rebuild(w));
    const qn_sorter *s = w->neighbours->sorter;
    const qn_share *share = &w->neighbours->shares[0];
    for (int i = 0; i < w->count; i++) {
        if (w->classes[w->place[i].klass].radius < 0.004) continue;
        CHECK(share->row[i + 1] - share->row[i] < 8);  // of its own size only
    }
    CHECK(s->carried_row[w->count] == share->pair_count);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(every_near_pair_of_ten_to_one_stands_in_the_list_once);
    TEST(every_near_pair_across_periodic_ends_stands_in_the_list_once);
    TEST(history_follows_its_pair_through_a_rebuild_and_a_file);
    TEST(a_large_ball_among_many_small_ones_keeps_rows_short);
    DONE;
}
