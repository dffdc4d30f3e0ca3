// SPDX-License-Identifier: Apache-2.0
#include "world/def.h"

#include <stdlib.h>

qn_def qn_def_default(void)
{
    qn_def def = {
        .gravity = {0, -9.81, 0},
        .seed = 1,
        .end = {0, QN_SECONDS},
        .rayleigh_fraction = 0.2,
        .bed_solidity = 0.6,
        .measure =
            {
                .series_every = {1e-3, QN_SECONDS},
                .fields_every = {300, QN_STEPS},
                .fields_duration = {1, QN_REVOLUTIONS},
                .traces_every = {1, QN_STEPS},
            },
        .output =
            {
                .directory = "out",
                .frames_every = {10e-3, QN_SECONDS},
                .checkpoint_every = 60,
                .checkpoint_keep = 3,
                .pictures = true,
            },
    };
    return def;
}

void qn_def_free(qn_def *def)
{
    for (int i = 0; i < def->mesh_count; i++) {
        free(def->meshes[i].vertices);
        free(def->meshes[i].triangles);
    }
    for (int i = 0; i < def->group_count; i++) {
        free(def->groups[i].list_position);
        free(def->groups[i].list_velocity);
        free(def->groups[i].list_spin);
        free(def->groups[i].list_size);
    }
    free(def->materials);
    free(def->contacts);
    free(def->planes);
    free(def->meshes);
    free(def->groups);
    free(def->shapes);
    free(def->feeds);
    free(def->outlets);
    free(def->drum.profile);
    *def = qn_def_default();
}

const qn_contact_def *qn_def_contact(const qn_def *def, int material_a, int material_b)
{
    for (int i = 0; i < def->contact_count; i++) {
        const qn_contact_def *c = &def->contacts[i];
        if ((c->material_a == material_a && c->material_b == material_b)
            || (c->material_a == material_b && c->material_b == material_a))
            return c;
    }
    return NULL;
}
