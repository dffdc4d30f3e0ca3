// SPDX-License-Identifier: Apache-2.0
// What `quern check` derives from a scene.
#include "check.h"

#include "scene/forecast.h"
#include "scene/scene.h"

static const char thesis_mill[] =
    "format: quern-scene/1\n"
    "time: {end: 1 rev, step: 1 us}\n"
    "materials:\n"
    "  glass: {shear: 26 GPa, poisson: 0.23, density: 2500 kg/m3}\n"
    "  mesh: {shear: 0.31 GPa, poisson: 0.42, density: 950 kg/m3}\n"
    "contacts:\n"
    "  defaults: {law: thesis, friction: 0.3}\n"
    "  glass-glass: {restitution: 0.66}\n"
    "  glass-mesh: {restitution: 0.55}\n"
    "drum: {diameter: 0.3 m, length: 9 mm, material: mesh, speed: 6.46991 rad/s}\n"
    "particles: {balls: {material: glass, diameter: 3 mm, count: 500}}\n";

typedef struct read_world {
    qn_world *world;
    qn_timestep timestep;
} read_world;

static qn_status read_text(const char *text, read_world *r)
{
    qn_def def;
    qn_messages messages = {0};
    *r = (read_world){0};
    qn_status status = qn_scene_read_text(text, strlen(text), "s.yaml", NULL, &def, &messages);
    if (messages.text) printf("%s", messages.text);
    qn_messages_free(&messages);
    if (status == QN_OK) status = qn_forecast_timestep(&def, &r->timestep);
    if (status == QN_OK) status = qn_world_create(&def, 1, &r->world);
    qn_def_free(&def);
    return status;
}

// The reference thesis, Fig 5.23, to the digits that follow from its Fig 5.24.
static void the_thesis_mill_has_the_thesis_coefficients(void)
{
    read_world r;
    CHECK_STATUS(read_text(thesis_mill, &r));
    qn_pair pp = qn_forecast_pair_of(r.world, &r.world->def.contacts[0]).pair;
    qn_forecast_pair wall = qn_forecast_pair_of(r.world, &r.world->def.contacts[1]);
    qn_pair ps = wall.pair;
    qn_world_destroy(r.world);
    CHECK(wall.is_used && wall.is_wall);
    CHECK_NEAR(pp.normal_stiffness, 2335488985, 1);
    CHECK_NEAR(pp.normal_damping, 59.56369, 1e-5);
    CHECK_NEAR(pp.tangential_stiffness, 5696.3146, 1e-4);
    CHECK_NEAR(pp.tangential_damping, 75.952846, 1e-6);
    CHECK_NEAR(ps.normal_stiffness, 32147663, 1);
    CHECK_NEAR(ps.normal_damping, 9.963325, 1e-6);
    CHECK_NEAR(ps.tangential_stiffness, 67.917597, 1e-6);
    CHECK_NEAR(ps.tangential_damping, 11.824291, 1e-6);
}

static void the_derived_numbers_are_those_of_the_mill(void)
{
    read_world r;
    CHECK_STATUS(read_text(thesis_mill, &r));
    qn_forecast f = qn_forecast_of(r.world, &r.timestep);
    qn_world_destroy(r.world);
    CHECK_NEAR(f.critical_speed, sqrt(2 * 9.81 / 0.3), 1e-12);
    CHECK_NEAR(f.speed, 0.8 * f.critical_speed, 5e-4);
    CHECK(f.particles == 500 && f.dt == 1e-6);
    CHECK_NEAR(f.mass, 500 * 3.534292e-5, 1e-8);
    CHECK_NEAR(f.timestep.rayleigh, 1.60e-6, 0.005e-6);
    CHECK_NEAR(f.end, 2 * QN_PI / 6.46991, 1e-9);
    CHECK_NEAR((double)f.steps, f.end / 1e-6, 1);
    CHECK_NEAR(f.revolutions, 1, 1e-9);
    CHECK_NEAR(f.filling, f.mass / 2500 / 0.6 / (QN_PI * 0.15 * 0.15 * 0.009), 1e-9);
}

// A single ball never touches itself, so its material's own law is not used.
static void a_pair_that_never_meets_is_said_not_to(void)
{
    read_world r;
    CHECK_STATUS(read_text(qn_scene_template("drop"), &r));
    CHECK(r.world->def.contact_count == 1);
    qn_forecast_pair p = qn_forecast_pair_of(r.world, &r.world->def.contacts[0]);
    qn_world_destroy(r.world);
    CHECK(p.is_used && p.is_wall);
    CHECK_NEAR(r.timestep.impact_speed, sqrt(2 * 9.81 * 0.05), 1e-9);
}

static void a_count_that_does_not_fit_says_how_many_do(void)
{
    char text[sizeof thesis_mill + 16];
    const char *count = strstr(thesis_mill, "500}");
    read_world r;
    snprintf(text, sizeof text, "%.*s5000000}}\n", (int)(count - thesis_mill), thesis_mill);
    CHECK(read_text(text, &r) == QN_INPUT);
    CHECK(strstr(qn_error(), "do not fit") != NULL);
}

int main(int argc, char **argv)
{
    TEST(the_thesis_mill_has_the_thesis_coefficients);
    TEST(the_derived_numbers_are_those_of_the_mill);
    TEST(a_pair_that_never_meets_is_said_not_to);
    TEST(a_count_that_does_not_fit_says_how_many_do);
    DONE;
}
