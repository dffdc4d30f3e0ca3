// SPDX-License-Identifier: Apache-2.0
// Clumps keep their energy in a closed elastic box, and a mill of clumps balances.
//
// Setup      Box: 24 clumps of 3 mm in a box of 16 mm at random speeds up to 0.9 m/s, restitution 1, no
//            friction: tetrahedra, whose moments are equal, and lumps with three different moments.
//            Mill: 120 of each in a slice of a 60 mm drum, friction 0.4, restitution 0.6, from when it
//            turns for 0.25 s.
// Formula    Box: kinetic energy of centres and of rotation plus elastic energy stays what it was, next to
//            the energy that collisions put into springs (05_elastic_box.c). It is shared by
//            translation and rotation: in the mean of a long run 1 to 1, three freedoms each. Mill: work of
//            the walls = losses + change of what is stored.
// Source     Conservation of energy; equipartition, Landau & Lifshitz, Statistical Physics I, 44.
// Tolerance  1e-6 of the turnover, as for balls, measured when nothing touches. Shares of the energy within
//            a third: 24 bodies over some thousand collisions. Mill: 1 % of the work, as asked for.
#include "check.h"
#include "worlds.h"

#include "base/random.h"
#include "measure/energy.h"

static int tetrahedron(qn_def *def)
{
    double centres[12], radii[4];
    qn_shape_tetrahedron(1.2, centres, radii);
    return add_shape(def, centres, radii, 4);
}

static int lump(qn_def *def)
{
    const double centres[] = {1.2, 0, 0, -1.2, 0, 0, 0, 0.7, 0}, radii[] = {1, 1, 0.8};
    return add_shape(def, centres, radii, 3);
}

static qn_world *box(int (*shape)(qn_def *))
{
    enum { N = 24 };
    qn_world *world = NULL;
    qn_def def = def_of_materials(QN_LAW_HERTZ_MINDLIN, 0, 1);
    def.gravity = qn_v3(0, 0, 0);
    add_box(&def, 0.016);
    qn_group_def *g = add_ball(&def, 0.003, qn_v3(0, 0, 0), qn_v3(0, 0, 0));
    g->shape = shape(&def);
    g->turned_at_random = true;
    g->list_count = N;
    g->list_position = realloc(g->list_position, 3 * N * sizeof(double));
    g->list_velocity = malloc(3 * N * sizeof(double));
    for (int i = 0; i < N; i++) {
        const double at[3] = {i % 3, i / 3 % 3, i / 9};
        for (int axis = 0; axis < 3; axis++) {
            g->list_position[3 * i + axis] = 0.0031 + 0.0049 * at[axis];
            g->list_velocity[3 * i + axis] = qn_random(1, (uint64_t)axis, (uint64_t)i) - 0.5;
        }
    }
    def.step = 7e-7;
    if (qn_world_create(&def, 1, &world) != QN_OK) printf("  %s\n", qn_error());
    qn_def_free(&def);
    return world;
}

typedef struct outcome {
    double drift, turnover;  // 1   of the energy by the turnover; that by the energy
    double rotation;         // 1   share of rotation in the kinetic energy, mean of the second half
} outcome;

static qn_status run_box(qn_world *w, int steps, outcome *o)
{
    qn_balance first, now;
    double elastic = 0, turnover = 0;
    int samples = 0;
    memset(o, 0, sizeof *o);
    QN_TRY(qn_step_forces(w, QN_COMMIT));
    QN_TRY(qn_balance_now(w, &first));
    for (int i = 0; i < steps || w->ledger.contacts_now + w->ledger.wall_contacts_now > 0; i++) {
        QN_TRY(qn_step_advance(w));
        QN_TRY(qn_step_forces(w, QN_COMMIT));
        double stored = w->ledger.now[QN_TALLY_ELASTIC_NORMAL];
        turnover += qn_max(0, stored - elastic);
        elastic = stored;
        if (i < steps / 2 || i % 500) continue;
        QN_TRY(qn_balance_now(w, &now));
        o->rotation += now.kinetic_rotation / (now.kinetic_rotation + now.kinetic_translation);
        samples++;
    }
    QN_TRY(qn_balance_now(w, &now));
    o->drift = (now.stored - first.stored) / turnover;
    o->turnover = turnover / first.kinetic_translation;
    o->rotation /= samples;
    return QN_OK;
}

static void check_box(int (*shape)(qn_def *))
{
    outcome o;
    qn_world *w = box(shape);
    CHECK(w);
    CHECK_STATUS(run_box(w, 600000, &o));
    printf("  drift %.2g of %.3g turnovers, rotation %.3f\n", o.drift, o.turnover, o.rotation);
    CHECK_NEAR(o.drift, 0, 1e-6);
    CHECK(o.turnover > 15);
    CHECK_NEAR(o.rotation, 0.5, 0.17);
    qn_world_destroy(w);
}

static void tetrahedra_keep_their_energy_in_an_elastic_box(void)
{
    check_box(tetrahedron);
}

static void lumps_keep_their_energy_in_an_elastic_box(void)
{
    check_box(lump);
}

static void a_mill_of_clumps_balances(void)
{
    qn_world *w;
    qn_balance first, last;
    qn_def def = def_of_mill(120, QN_ENDS_PERIODIC);
    def.materials[0].youngs_modulus = def.materials[1].youngs_modulus = 20e6;
    def.gravity = qn_v3(0, -9.81, 0);
    for (int k = 0; k < 2; k++) {
        qn_group_def *g = k == 0 ? &def.groups[0] : add_group(&def, "lumps", 0.003);
        g->amount = 120;
        g->turned_at_random = true;
        g->shape = k == 0 ? tetrahedron(&def) : lump(&def);
    }
    for (int i = 0; i < 3; i++) def.contacts[i].friction = 0.4;
    def.step = 0;
    CHECK_STATUS(qn_world_create(&def, 1, &w));
    qn_def_free(&def);
    CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
    CHECK_STATUS(qn_balance_now(w, &first));
    while (qn_world_time(w) < 0.25) {
        CHECK_STATUS(qn_step_advance(w));
        CHECK_STATUS(qn_step_forces(w, QN_COMMIT));
    }
    CHECK_STATUS(qn_balance_now(w, &last));
    double work = last.work - first.work, residual = qn_balance_residual(&last, &first);
    printf("  work %.4g J, lost %.4g J, residual %.3f %%\n", work, last.lost,
           100 * residual / work);
    CHECK(work > 1e-4 && last.lost > 0.5 * work);
    CHECK_NEAR(residual / work, 0, 0.01);
    qn_world_destroy(w);
}

int main(int argc, char **argv)
{
    TEST(tetrahedra_keep_their_energy_in_an_elastic_box);
    TEST(lumps_keep_their_energy_in_an_elastic_box);
    TEST(a_mill_of_clumps_balances);
    DONE;
}
