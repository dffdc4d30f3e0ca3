// SPDX-License-Identifier: Apache-2.0
// A silo's floor bears less than what stands on it: Janssen's law.
//
// Setup      Balls of 3 mm dropped between two walls 24 mm apart and two smooth panes 9 mm apart, mu = 0.3 between
//            balls and 0.5 or 0 at the walls; 150 to 1500 balls. When they are at rest gravity is raised 20
//            times, slowly: the bed sinks a little everywhere and so calls up the friction of the walls, which filling
//            leaves in any state.
// Formula    Floor + walls bear the weight. Smooth walls: the floor bears all. Rough walls: the floor bears
//            M_s (1 - exp(-M/M_s)) of a weight M. The one number M_s is found from the tallest bed.
// Source     Janssen (1895), Z. Ver. dt. Ing. 39, 1045 (translated by Sperl 2006, Granular Matter 8, 59,
//            doi:10.1007/s10035-005-0224-z).
// Tolerance  1 % of the weight, as a little still moves. 10 % of M_s for the other beds: a section of eight balls by
//            three has packings of its own, and friction is not at its limit everywhere.
#include "beds.h"
#include "evidence.h"

static const double D = 0.003, WIDTH = 0.024, THICKNESS = 0.009;  // m

typedef struct shares {
    double floor, walls, weight;  // N
} shares;

// Adds up the vertical force of the walls on one ball; parts are numbered in the order of the planes.
static void add_force(void *user, int64_t id, int64_t partner, const qn_reply *r, qn_vec3 point)
{
    shares *s = user;
    (void)id, (void)point;
    double up = r->push * r->normal.y + r->tangential.y;
    if (partner == -1 - 2) s->floor += up;
    if (partner == -1 - 3 || partner == -1 - 4) s->walls += up;
}

static qn_status filled(int count, double wall_friction, shares *s)
{
    qn_world *w;
    qn_def def = bed_def(0.3, wall_friction, THICKNESS);
    *s = (shares){0};
    add_plane(&def, "floor", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_plane(&def, "left", qn_v3(0, 0, 0), qn_v3(1, 0, 0));
    add_plane(&def, "right", qn_v3(WIDTH, 0, 0), qn_v3(-1, 0, 0));
    bed_fill(&def, D, count, WIDTH, THICKNESS, 0);
    qn_status status = qn_world_create(&def, 1, &w);
    qn_def_free(&def);
    QN_TRY(status);
    while (qn_world_time(w) < 0.35) QN_TRY(take_steps(w, 1));
    while (qn_world_time(w) < 0.6) {
        double share = qn_min((qn_world_time(w) - 0.35) / 0.12, 1);
        w->gravity.y = -9.81 * pow(20, share);
        QN_TRY(take_steps(w, 1));
    }
    QN_TRY(qn_step_forces(w, QN_COMMIT));
    for (int i = 0; i < w->count; i++) QN_TRY(qn_step_visit(w, w->id[i], add_force, s));
    s->weight = w->count * w->classes[0].mass * -w->gravity.y;
    qn_world_destroy(w);
    return QN_OK;
}

// M_s (N) by which the floor bears what it does.
static double limit_of(const shares *s)
{
    double low = 0, high = 100 * s->weight;
    for (int i = 0; i < 100; i++) {
        double limit = (low + high) / 2;
        if (limit * (1 - exp(-s->weight / limit)) < s->floor)
            low = limit;
        else
            high = limit;
    }
    return low;
}

static void between_smooth_walls_the_floor_bears_all(void)
{
    shares s;
    CHECK_STATUS(filled(300, 0, &s));
    MEASURE("floor, by the weight", "smooth walls, 300 balls", s.floor / s.weight, 1, 0.01);
}

static void between_rough_walls_the_floor_bears_what_janssen_says(void)
{
    const int counts[] = {150, 300, 600, 900, 1200, 1500};
    shares s[6];
    for (int k = 5; k >= 0; k--) {
        if (!evidence_wanted() && k % 2 == 0) continue;
        CHECK_STATUS(filled(counts[k], 0.5, &s[k]));
        const char *which = where("%d balls", counts[k]);
        double limit = limit_of(&s[5]), wanted = limit * (1 - exp(-s[k].weight / limit));
        printf("  %s: weight %.5g N, floor %.5g N, walls %.5g N\n", which, s[k].weight, s[k].floor,
               s[k].walls);
        CURVE("floor", "weight (N),floor (N),limit (N)", s[k].weight, s[k].floor, limit);
        MEASURE("floor and walls, by the weight", which, (s[k].floor + s[k].walls) / s[k].weight, 1,
                0.01);
        MEASURE("floor, by M_s", which, s[k].floor / limit, wanted / limit, 0.1);
    }
    MEASURE("floor, by the weight", "1500 balls", s[5].floor / s[5].weight, 0.35, 0.15);
}

int main(int argc, char **argv)
{
    TEST(between_smooth_walls_the_floor_bears_all);
    TEST(between_rough_walls_the_floor_bears_what_janssen_says);
    DONE;
}
