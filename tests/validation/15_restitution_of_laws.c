// SPDX-License-Identifier: Apache-2.0
// The restitution of every damping model against the speed of impact.
//
// Setup      A ball of 3 mm (64 MPa, 0.23, 2500 kg/m3) hits a rigid plane head on at 0.01 to 3 m/s, restitution
//            0.3, 0.6, 0.9: viscous on a linear spring, tsuji on Hertz's, both clipped and not; hunt-crossley on
//            both, with the restitution asked for at 0.3 m/s; the document's law.
// Formula    viscous, tsuji: e at any speed, clipped or not. hunt-crossley: e(u) solves x - ln(1 + x) = -e x -
//            ln(1 - e x) with x in proportion to the speed u, so e(u) falls with speed and is 1 at rest. The
//            document's law at a wall: exp(-pi q/sqrt(1 - q^2)), q its damping ratio over sqrt(2).
// Source     Antypov & Elliott (2011), EPL 94, 50004, doi:10.1209/0295-5075/94/50004; Schwager & Poeschel (2008),
//            Phys. Rev. E 78, 051304, doi:10.1103/PhysRevE.78.051304; Hunt & Crossley (1975), J. Appl. Mech. 42,
//            440, doi:10.1115/1.3423596.
// Tolerance  5e-4 at 2000 steps a contact: the dashpot's force sets in at once (linear) or with infinite
//            slope (Hertz), a part of a step late. hunt-crossley sets in smoothly: 1e-4; at
//            0.3 m/s, where it is the restitution asked for, the equation is not needed.
#include "evidence.h"
#include "impacts.h"

static const substance ball = {"glass", 64e6, 0.23, 2500, 0.0015};

// Ratio of the speeds of one bounce from the plane.
static qn_status ratio_of(qn_law law, bool clip, double e, double speed, double *ratio)
{
    qn_world *w;
    impact o;
    qn_def def = impact_def(&ball, 0.3, e);
    def.contacts[1].law = law;
    def.contacts[1].clip = clip;
    def.contacts[1].impact_speed = 0.3;
    def.contacts[1].stiffness = 2e4;
    double mass = 4.0 / 3 * QN_PI * 0.0015 * 0.0015 * 0.0015 * 2500;
    def.step =
        (law.normal == QN_NORMAL_LINEAR ? QN_PI * sqrt(mass / 2e4) : impact_time(&ball, speed))
        / 2000;
    add_plane(&def, "plate", qn_v3(0, 0, 0), qn_v3(0, 1, 0));
    add_ball(&def, 0.003, qn_v3(0, 0.0015 + 1.5 * def.step * speed, 0), qn_v3(0, -speed, 0));
    qn_status status = qn_world_create(&def, 1, &w);
    qn_def_free(&def);
    QN_TRY(status);
    status = impact_collide(w, &o);
    qn_world_destroy(w);
    *ratio = o.after.velocity.y / speed;
    return status;
}

static const double speeds[] = {0.01, 0.03, 0.1, 0.3, 1, 3};  // m/s
static const double asked[] = {0.3, 0.6, 0.9};

static void viscous_and_tsuji_dampings_keep_the_restitution_at_every_speed(void)
{
    const qn_law laws[] = {qn_law_named(QN_LAW_LINEAR), qn_law_named(QN_LAW_HERTZ_MINDLIN)};
    const char *names[] = {"viscous", "tsuji"};
    for (int i = 0; i < 24; i++) {
        int m = i / 12, clip = i / 6 % 2, k = i % 6;
        for (int j = 0; j < 3; j++) {
            double ratio;
            CHECK_STATUS(ratio_of(laws[m], clip, asked[j], speeds[k], &ratio));
            const char *which = where("e = %g, %g m/s", asked[j], speeds[k]);
            CURVE(names[m], "clip (1),asked (1),speed (m/s),measured (1)", clip, asked[j],
                  speeds[k], ratio);
            MEASURE(m == 0 ? (clip ? "viscous, clipped" : "viscous, not clipped")
                           : (clip ? "tsuji, clipped" : "tsuji, not clipped"),
                    which, ratio, asked[j], 5e-4);
        }
    }
}

static void hunt_crossley_damping_falls_with_speed_as_its_equation_says(void)
{
    const qn_normal_model springs[] = {QN_NORMAL_LINEAR, QN_NORMAL_HERTZ};
    for (int m = 0; m < 2; m++)
        for (int j = 0; j < 3; j++)
            for (double v = 0.01; v < 3.1; v *= evidence_wanted() ? pow(30, 0.1) : pow(30, 0.25)) {
                qn_law law = {.normal = springs[m],
                              .damping = QN_DAMPING_HUNT_CROSSLEY,
                              .tangential = QN_TANGENTIAL_NONE,
                              .rolling = QN_ROLLING_NONE};
                double ratio, x = qn_hunt_crossley_number(asked[j]) * v / 0.3;
                CHECK_STATUS(ratio_of(law, true, asked[j], v, &ratio));
                CURVE(m ? "hertz_hunt" : "linear_hunt", "asked (1),speed (m/s),measured (1)",
                      asked[j], v, ratio);
                MEASURE(m ? "hunt-crossley on hertz" : "hunt-crossley on linear",
                        where("e = %g, %.3g m/s", asked[j], v), ratio,
                        qn_hunt_crossley_restitution(x), 1e-4);
            }
}

static void the_documents_law_at_a_wall_damps_as_half_the_mass(void)
{
    for (int j = 0; j < 3; j++)
        for (int k = 2; k < 6; k++) {
            double ratio, b = -log(asked[j]) / hypot(QN_PI, log(asked[j])), q = b / sqrt(2);
            CHECK_STATUS(ratio_of(qn_law_named(QN_LAW_THESIS), false, asked[j], speeds[k], &ratio));
            MEASURE("the document's law", where("e = %g, %g m/s", asked[j], speeds[k]), ratio,
                    exp(-QN_PI * q / sqrt(1 - q * q)), 5e-4);
        }
}

int main(int argc, char **argv)
{
    TEST(viscous_and_tsuji_dampings_keep_the_restitution_at_every_speed);
    TEST(hunt_crossley_damping_falls_with_speed_as_its_equation_says);
    TEST(the_documents_law_at_a_wall_damps_as_half_the_mass);
    DONE;
}
