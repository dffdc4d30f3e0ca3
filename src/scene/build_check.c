// SPDX-License-Identifier: Apache-2.0
// What only shows when the whole scene is known: every two materials that can meet need a law.
#include "scene/build.h"

#include <stdio.h>
#include <string.h>

/// Says once for each pair that is missing who would meet.
static void need_law(qn_reader *r, qn_mark mark, int a, int b, const char *one, const char *other,
                     bool said[QN_NAMES_MAX][QN_NAMES_MAX])
{
    if (a < 0 || b < 0 || said[a][b] || qn_def_contact(r->def, a, b)) return;
    said[a][b] = said[b][a] = true;
    const char *name_a = r->def->materials[a].name, *name_b = r->def->materials[b].name;
    qn_complain_at(r, mark,
                   "contacts lacks '%s-%s': %s and %s can touch, and no law says what happens then",
                   name_a, name_b, one, other);
}

static bool is_held(const qn_group_def *g)
{
    return g->fixed || g->turning;
}

/// A group that cannot touch itself: nothing in it moves freely, or it is a single sphere.
static bool is_apart(const qn_group_def *g)
{
    return is_held(g) || (g->packing == QN_PACK_LIST && g->list_count < 2);
}

static void check_group(qn_reader *r, qn_mark mark, const qn_group_def *g,
                        bool said[QN_NAMES_MAX][QN_NAMES_MAX])
{
    const qn_def *def = r->def;
    char self[QN_NAME_MAX + 32], other[QN_NAME_MAX + 32];
    snprintf(self, sizeof self, "particles '%s'", g->name);
    if (!is_apart(g)) need_law(r, mark, g->material, g->material, self, "themselves", said);
    for (const qn_group_def *o = def->groups; o < g; o++) {
        snprintf(other, sizeof other, "particles '%s'", o->name);
        if (!is_held(g) || !is_held(o))
            need_law(r, mark, g->material, o->material, self, other, said);
    }
    if (is_held(g)) return;
    if (def->drum.present) {
        need_law(r, mark, g->material, def->drum.material, self, "the drum", said);
        if (def->drum.ends != QN_ENDS_PERIODIC)
            need_law(r, mark, g->material, def->drum.end_material, self, "the drum's ends", said);
    }
    for (int i = 0; i < def->plane_count; i++) {
        snprintf(other, sizeof other, "wall '%s'", def->planes[i].name);
        need_law(r, mark, g->material, def->planes[i].material, self, other, said);
    }
    for (int i = 0; i < def->mesh_count; i++) {
        snprintf(other, sizeof other, "wall '%s'", def->meshes[i].name);
        need_law(r, mark, g->material, def->meshes[i].material, self, other, said);
    }
}

/// Whether every entry of contacts could be read; what is missing may else be a pair misspelt.
static bool is_complete(const qn_reader *r, const qn_value *contacts)
{
    int entries = 0;
    if (!contacts->node) return true;
    for (const qn_node *n = contacts->node->first; n; n = n->next)
        entries += strcmp(n->key, "defaults") != 0;
    return contacts->set && entries == r->def->contact_count;
}

void qn_build_check(qn_reader *r, const qn_scene_keys *scene)
{
    if (!is_complete(r, &scene->contacts)) return;
    bool said[QN_NAMES_MAX][QN_NAMES_MAX] = {{false}};
    qn_mark mark = {1, 1, 1};
    if (scene->contacts.node)
        mark = scene->contacts.node->key_mark;
    else if (scene->particles.node)
        mark = scene->particles.node->key_mark;
    for (int i = 0; i < r->def->group_count; i++) check_group(r, mark, &r->def->groups[i], said);
}
