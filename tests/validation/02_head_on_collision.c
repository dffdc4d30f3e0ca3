// SPDX-License-Identifier: Apache-2.0
// Two spheres meet head on: the collision of Hertz's theory.
//
// Setup      Two spheres of r = 10 mm at 10 m/s each, e = 1, no gravity: glass (E = 48 GPa, nu = 0.20,
//            2800 kg/m3) and limestone (20 GPa, 0.25, 2500 kg/m3). Then glass with damping.
// Formula    d = (5 m* v^2 / (4 k))^(2/5), F = k d^(3/2), t = 2.94328 d/v, k = 4/3 E* sqrt(R*).
// Source     Chung & Ooi (2011), Granular Matter 13, 643, doi:10.1007/s10035-011-0277-0, test 1: 274.113 um,
//            10.6969 kN, 40.339 us; 368.304 um, 7.1082 kN, 54.201 us.
// Tolerance  2000 steps a contact: depth and force to the printed digits (1e-5), the duration to two
//            steps (a touch begins and ends between steps), the rebound to 1e-6. With the automatic
//            step's 20 steps a contact, restitution to 0.005, which timestep.h promises.
#include "evidence.h"
#include "worlds.h"

typedef struct outcome {
    double depth, force, time, rebound;  // m, N, s, 1
} outcome;

// Both spheres touch at t = 0 but for a part `phase` of a step.
static qn_world *two_spheres(double young, double poisson, double density, double e, bool clip,
                             double dt, double phase)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0.35, e);
    def.gravity = qn_v3(0, 0, 0);
    def.materials[0].youngs_modulus = young;
    def.materials[0].poisson_ratio = poisson;
    def.materials[0].density = density;
    def.contacts[0].clip = clip;
    def.step = dt;
    double x = 0.01 + 10 * dt * (1 + phase);
    add_ball(&def, 0.02, qn_v3(-x, 0, 0), qn_v3(10, 0, 0));
    add_ball(&def, 0.02, qn_v3(x, 0, 0), qn_v3(-10, 0, 0));
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

// Steps until the spheres have met and parted; the force goes to a curve of that name unless NULL.
static qn_status collide(qn_world *w, const char *curve, outcome *o)
{
    *o = (outcome){0};
    int steps = 0;
    for (int i = 0; i < 10 || w->ledger.contacts_now > 0; i++) {
        QN_TRY(qn_step_forces(w, QN_COMMIT));
        steps += w->ledger.contacts_now > 0;
        double mass = w->classes[0].mass;
        double force = mass * fabs(qn_acceleration(w, 0).x);
        double depth = w->ledger.deepest_now * w->classes[0].radius;
        o->force = qn_max(o->force, force);
        if (curve && i % 10 == 0 && depth > 0)
            CURVE(curve, "overlap (um),force (kN),time (us)", 1e6 * depth, force / 1e3,
                  1e6 * steps * w->dt);
        QN_TRY(qn_step_advance(w));
    }
    o->depth = w->ledger.deepest * w->classes[0].radius;
    o->time = steps * w->dt;
    o->rebound = fabs(w->motion[0].velocity.x) / 10;
    return QN_OK;
}

static void elastic(const char *name, double young, double poisson, double density, outcome theory)
{
    outcome o;
    double dt = theory.time / 2000;
    qn_world *w = two_spheres(young, poisson, density, 1, true, dt, 0.5);
    CHECK(w);
    CHECK_STATUS(collide(w, name, &o));
    MEASURE("largest overlap (um)", name, 1e6 * o.depth, 1e6 * theory.depth, 10 * theory.depth);
    MEASURE("largest force (kN)", name, o.force / 1e3, theory.force / 1e3, 1e-8 * theory.force);
    MEASURE("time of contact (us)", name, 1e6 * o.time, 1e6 * theory.time, 2e6 * dt);
    MEASURE("ratio of speeds", name, o.rebound, 1, 1e-6);
    CHECK(w->motion[0].velocity.y == 0 && w->motion[0].spin.z == 0);
    qn_world_destroy(w);
}

static void glass_collides_as_hertz_says(void)
{
    elastic("glass", 48e9, 0.20, 2800, (outcome){274.113e-6, 10696.9, 40.339e-6, 1});
}

static void limestone_collides_as_hertz_says(void)
{
    elastic("limestone", 20e9, 0.25, 2500, (outcome){368.304e-6, 7108.2, 54.201e-6, 1});
}

static void spheres_part_with_the_restitution_asked_for_with_the_clip_or_without(void)
{
    for (int clip = 0; clip < 2; clip++)
        for (double e = 0.2; e < 1; e += 0.2) {
            outcome o;
            qn_world *w = two_spheres(48e9, 0.2, 2800, e, clip, 40.339e-6 / 1000, 0.5);
            CHECK(w);
            CHECK_STATUS(collide(w, NULL, &o));
            const char *which = where("e = %.1f, %s", e, clip ? "clipped" : "not clipped");
            MEASURE("restitution", which, o.rebound, e, 5e-4);
            double lost = w->ledger.lost[QN_TALLY_NORMAL];
            MEASURE("energy told lost, by that due", which,
                    lost / (w->classes[0].mass * 100 * (1 - e * e)), 1, 1e-3);
            qn_world_destroy(w);
        }
}

static void twenty_steps_keep_restitution_within_half_a_percent_on_average(void)
{
    for (double e = 0.3; e < 1.05; e += 0.2) {
        double sum = 0;
        for (int k = 0; k < 16; k++) {
            outcome o;
            qn_world *w =
                two_spheres(48e9, 0.2, 2800, qn_min(e, 1), true, 40.339e-6 / 20, (k + 0.5) / 16);
            CHECK(w);
            CHECK_STATUS(collide(w, NULL, &o));
            sum += o.rebound / 16;
            qn_world_destroy(w);
        }
        MEASURE("mean restitution at 20 steps a contact", where("e = %.1f", qn_min(e, 1)), sum,
                qn_min(e, 1), 5e-3);
    }
}

int main(int argc, char **argv)
{
    TEST(glass_collides_as_hertz_says);
    TEST(limestone_collides_as_hertz_says);
    TEST(spheres_part_with_the_restitution_asked_for_with_the_clip_or_without);
    TEST(twenty_steps_keep_restitution_within_half_a_percent_on_average);
    DONE;
}
