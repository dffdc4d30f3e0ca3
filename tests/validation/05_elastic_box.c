// SPDX-License-Identifier: Apache-2.0
// Nothing is lost in a closed elastic box.
//
// Setup      40 balls of 3 mm in a box of 14 mm at random speeds up to 0.9 m/s, restitution 1, no friction,
//            with gravity and without; 100 steps a contact, some 2000 collisions.
// Formula    Kinetic + gravity + elastic energy stays what it was. The turnover it is compared with is
//            the energy that collisions put into springs: the sum over steps of what the elastic energy
//            grew by (less than the true exchange where several contacts overlap in time).
// Source     Conservation of energy.
// Tolerance  1e-6 of the turnover. A leapfrog returns each collision's energy to some 1e-5 at 100 steps
//            a contact, of either sign: 2000 of them make 2e-7 of the turnover. It is measured when
//            nothing touches, as on-step velocities are second order within a contact.
#include "evidence.h"
#include "worlds.h"

#include "base/random.h"
#include "measure/energy.h"

static qn_world *box(double gravity)
{
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 1);
    def.gravity = qn_v3(0, -gravity, 0);
    add_box(&def, 0.014);
    qn_group_def *g = add_ball(&def, 0.003, qn_v3(0, 0, 0), qn_v3(0, 0, 0));
    enum { N = 40 };
    g->list_count = N;
    g->list_position = realloc(g->list_position, 3 * N * sizeof(double));
    g->list_velocity = malloc(3 * N * sizeof(double));
    for (int i = 0; i < N; i++) {
        const double at[3] = {i % 4, i / 4 % 4, i / 16};
        for (int axis = 0; axis < 3; axis++) {
            g->list_position[3 * i + axis] = 0.002 + 0.0032 * at[axis];
            g->list_velocity[3 * i + axis] = qn_random(1, (uint64_t)axis, (uint64_t)i) - 0.5;
        }
    }
    def.step = 1.5e-6;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

// Runs for `steps` and on until nothing touches; the drift of the energy over the turnover.
static qn_status drift_of(qn_world *w, int steps, double *drift, double *turnover)
{
    qn_balance first, now;
    double elastic = 0;
    *turnover = 0;
    QN_TRY(qn_step_forces(w, QN_COMMIT));
    QN_TRY(qn_balance_now(w, &first));
    for (int i = 0; i < steps || w->ledger.contacts_now + w->ledger.wall_contacts_now > 0; i++) {
        QN_TRY(qn_step_advance(w));
        QN_TRY(qn_step_forces(w, QN_COMMIT));
        double stored = w->ledger.now[QN_TALLY_ELASTIC_NORMAL];
        *turnover += qn_max(0, stored - elastic);
        elastic = stored;
    }
    QN_TRY(qn_balance_now(w, &now));
    *drift = (now.stored - first.stored) / *turnover;
    *turnover /= first.kinetic_translation;
    return qn_balance_residual(&now, &first) == first.stored - now.stored && now.lost == 0
               ? QN_OK
               : qn_fail(QN_UNSTABLE, "something was lost: %g J", now.lost);
}

static void energy_stays_within_1e_6_of_its_turnover_without_gravity(void)
{
    double drift, turnover;
    qn_world *w = box(0);
    CHECK(w);
    CHECK_STATUS(drift_of(w, 200000, &drift, &turnover));
    MEASURE("drift of the energy, by turnover", "no gravity", drift, 0, 1e-6);
    CHECK(turnover > 50);  // the kinetic energy went through springs as often
    qn_world_destroy(w);
}

static void energy_stays_within_1e_6_of_its_turnover_with_gravity(void)
{
    double drift, turnover;
    qn_world *w = box(9.81);
    CHECK(w);
    CHECK_STATUS(drift_of(w, 200000, &drift, &turnover));
    MEASURE("drift of the energy, by turnover", "with gravity", drift, 0, 1e-6);
    CHECK(turnover > 50);  // the kinetic energy went through springs as often
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(energy_stays_within_1e_6_of_its_turnover_without_gravity);
    TEST(energy_stays_within_1e_6_of_its_turnover_with_gravity);
    DONE;
}
