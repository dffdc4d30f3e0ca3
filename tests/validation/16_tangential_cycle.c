// SPDX-License-Identifier: Apache-2.0
// Mindlin's spring with displacement or force history, through cycles of sliding and of changing load.
//
// Setup      A ball of 3 mm (64 MPa, 0.23) is held against a plane by 2 or 8 um and moved along it by up to 1
//            um, both prescribed, without damping. (a) To and fro under constant load, mu = 0.3. (b) Moved by
//            s at the small load, pressed on, moved back at the large load, let off; mu = 10.
// Formula    (a) Both models: slope 8 G* sqrt(R* depth), limit mu F_n; a cycle of amplitude s loses 4 mu F_n
//            (s - mu F_n/k). (b) mindlin: F = k s follows the load, and the cycle yields (k2 - k1) s^2/2 out of
//            nothing. mindlin-thornton: F stays while the load grows and falls with the contact radius, so
//            the same cycle costs (k2 - k1) s^2/2.
// Source     Mindlin (1949), J. Appl. Mech. 16, 259; Thornton, Cummins & Cleary (2013), Powder Technol. 233, 30,
//            doi:10.1016/j.powtec.2012.08.012; Di Renzo & Di Maio (2004), Chem. Eng. Sci. 59, 525.
// Tolerance  1e-3: a leg is 4000 steps, and the force of a step is that of its end.
#include "evidence.h"
#include "impacts.h"

typedef struct machine {
    qn_law law;
    qn_pair pair;
    qn_memory memory;
    double depth, slip, force, work;  // m, m, N, J   force against the motion, work put in
    const char *curve;
} machine;

static const double R = 0.0015, SHALLOW = 2e-6, DEEP = 8e-6;  // m
enum { STEPS = 4000 };

static machine machine_of(qn_tangential_model tangential, double friction, const char *curve)
{
    machine m = {.law = {.normal = QN_NORMAL_HERTZ,
                         .damping = QN_DAMPING_NONE,
                         .tangential = tangential,
                         .rolling = QN_ROLLING_NONE},
                 .curve = curve};
    qn_sides sides = {.young = {64e6, 64e6},
                      .poisson = {0.23, 0.23},
                      .radius = {R, INFINITY},
                      .mass = {3.5e-5, INFINITY},
                      .wall = true,
                      .clip = true,
                      .dt = 1e-6,
                      .friction = friction,
                      .restitution = 1};
    m.pair = qn_law_pair(m.law, &sides);
    return m;
}

// Moves the ball by `deeper` and `along` (m) in one leg.
static void leg(machine *m, double deeper, double along)
{
    qn_reach reach = {R, R, 0, 1, 0};
    for (int i = 0; i < STEPS; i++) {
        double dt = m->pair.dt, before = m->force;
        m->depth += deeper / STEPS, m->slip += along / STEPS;
        qn_touch t = {.between = {0, R - m->depth, 0},
                      .velocity = {along / STEPS / dt, -deeper / STEPS / dt, 0},
                      .memory = m->memory,
                      .last = {0, 1, 0}};
        qn_reply reply;
        qn_contact_evaluate(m->law, &m->pair, &reach, &t, &reply);
        m->memory = reply.memory;
        m->force = -reply.tangential.x;
        m->work += (before + m->force) / 2 * along / STEPS;
        if (i % 40 == 0) CURVE(m->curve, "slip (um),force (mN)", 1e6 * m->slip, 1e3 * m->force);
    }
}

// N/m   8 G* sqrt(R* depth), both sides alike
static double stiffness_at(double depth)
{
    return 8 * 64e6 / (4 * (1 + 0.23) * (2 - 0.23)) * sqrt(R * depth);
}

static const qn_tangential_model models[] = {QN_TANGENTIAL_MINDLIN, QN_TANGENTIAL_THORNTON};
static const char *names[] = {"mindlin", "mindlin-thornton"};

static void sliding_to_and_fro_loses_what_its_loop_encloses(void)
{
    const double mu = 0.3, s = 1e-6;
    double press = 4.0 / 3 * 64e6 / (2 * (1 - 0.23 * 0.23)) * sqrt(R) * pow(SHALLOW, 1.5);
    double k = stiffness_at(SHALLOW);
    for (int i = 0; i < 2; i++) {
        machine m = machine_of(models[i], mu, i ? "thornton_slide" : "mindlin_slide");
        leg(&m, SHALLOW, 0);
        leg(&m, 0, 0.1 * mu * press / k);
        MEASURE("(a) slope, by 8 G* a", names[i], m.force / m.slip / k, 1, 1e-3);
        leg(&m, 0, s - m.slip);
        MEASURE("(a) limit, by mu F_n", names[i], m.force / (mu * press), 1, 1e-9);
        leg(&m, 0, -2 * s), leg(&m, 0, 2 * s);
        double before = m.work;
        leg(&m, 0, -2 * s), leg(&m, 0, 2 * s);
        double theory = 4 * mu * press * (s - mu * press / k);
        MEASURE("(a) energy a cycle loses (nJ)", names[i], 1e9 * (m.work - before), 1e9 * theory,
                1e6 * theory);
    }
}

static void a_cycle_under_changing_load_gains_or_loses_as_its_history_says(void)
{
    const double s = 2e-7;
    double k1 = stiffness_at(SHALLOW), k2 = stiffness_at(DEEP), unit = (k2 - k1) * s * s / 2;
    for (int i = 0; i < 2; i++) {
        machine m = machine_of(models[i], 10, i ? "thornton_load" : "mindlin_load");
        leg(&m, SHALLOW, 0), leg(&m, 0, s);
        double sheared = m.force;
        leg(&m, DEEP - SHALLOW, 0);
        MEASURE("(b) force after pressing on, by that before", names[i], m.force / sheared,
                i ? 1 : sqrt(DEEP / SHALLOW), 1e-3);
        leg(&m, 0, -s);
        double back = m.force;
        leg(&m, SHALLOW - DEEP, 0);
        if (i)
            MEASURE("(b) force after letting off, by that before", names[i], m.force / back,
                    sqrt(SHALLOW / DEEP), 1e-3);
        MEASURE("(b) work the cycle costs, by (k2 - k1) s^2/2", names[i], m.work / unit, i ? 1 : -1,
                1e-3);
    }
}

int main(int argc, char **argv)
{
    TEST(sliding_to_and_fro_loses_what_its_loop_encloses);
    TEST(a_cycle_under_changing_load_gains_or_loses_as_its_history_says);
    DONE;
}
