// SPDX-License-Identifier: Apache-2.0
// A sphere hits a rigid plane head on: Hertz's collision, and any restitution.
//
// Setup      Elastic, r = 0.1 m at 0.2 m/s, no friction (test 2): aluminium alloy (70 GPa, 0.30, 2699 kg/m3)
//            and magnesium alloy (40 GPa, 0.35, 1800 kg/m3). r = 2.5 mm at 3.9 m/s with restitution 0.2 to 1
//            (test 3): aluminium oxide (380 GPa, 0.23, 4000 kg/m3), cast iron (100 GPa, 0.25, 7000 kg/m3).
// Formula    d = (5 m v^2 / (4 k))^(2/5), F = k d^(3/2), t = 2.94328 d/v, k = 4/3 E/(1 - nu^2) sqrt(r). With
//            damping the ratio of the speeds is the restitution asked for.
// Source     Chung & Ooi (2011), Granular Matter 13, 643, doi:10.1007/s10035-011-0277-0, tests 2 and 3.
// Tolerance  2000 steps a contact. 2e-5 of depth and force, as the numbers are given to five digits; two
//            steps in the time, 1e-3, as a touch begins and ends between steps; 5e-4 in the restitution,
//            the dashpot's depth^(1/4) setting in with infinite slope at the first step.
#include "evidence.h"
#include "impacts.h"

static void elastic(const substance *s, double v, double depth, double force, double time)
{
    impact o;
    CHECK_STATUS(impact_on_plane(s, NULL, 0, 1, qn_v3(0, -v, 0), 0, &o));
    MEASURE("largest overlap (um)", s->name, 1e6 * o.depth, depth, 2e-5 * depth);
    MEASURE("largest force (N)", s->name, o.force, force, 2e-5 * force);
    MEASURE("time of contact (us)", s->name, 1e6 * o.time, time, 1e-3 * time);
    MEASURE("ratio of speeds", s->name, o.after.velocity.y / v, 1, 1e-6);
}

static const substance oxide = {"aluminium oxide", 380e9, 0.23, 4000, 0.0025};
static const substance iron = {"cast iron", 100e9, 0.25, 7000, 0.0025};

static void an_elastic_sphere_rebounds_from_a_plane_as_hertz_says(void)
{
    const substance aluminium = {"aluminium alloy", 70e9, 0.30, 2699, 0.1};
    const substance magnesium = {"magnesium alloy", 40e9, 0.35, 1800, 0.1};
    elastic(&aluminium, 0.2, 49.717, 11369.9, 731.66);
    elastic(&magnesium, 0.2, 52.123, 7232.7, 767.07);
    elastic(&oxide, 3.9, 8.0888, 615.35, 6.1045);
    elastic(&iron, 3.9, 17.1887, 506.76, 12.972);
}

static void a_sphere_rebounds_with_the_restitution_asked_for(void)
{
    const substance *both[] = {&oxide, &iron};
    for (int k = 0; k < 2; k++)
        for (double e = 0.2; e < 1.05; e += evidence_wanted() ? 0.05 : 0.2) {
            impact o;
            CHECK_STATUS(impact_on_plane(both[k], NULL, 0, e, qn_v3(0, -3.9, 0), 0, &o));
            CURVE(k ? "iron" : "oxide", "asked (1),measured (1)", e, o.after.velocity.y / 3.9);
            MEASURE("restitution", where("%.2f, %s", e, both[k]->name), o.after.velocity.y / 3.9, e,
                    5e-4);
        }
}

int main(int argc, char **argv)
{
    TEST(an_elastic_sphere_rebounds_from_a_plane_as_hertz_says);
    TEST(a_sphere_rebounds_with_the_restitution_asked_for);
    DONE;
}
