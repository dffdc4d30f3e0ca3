// SPDX-License-Identifier: Apache-2.0
// Materials, and the contact laws between them.
#include "base/array.h"
#include "scene/build.h"

#include <stdio.h>
#include <string.h>

/// The entry of `materials` that a material is like, already read, or NULL.
static const qn_material_keys *like_of(const qn_def *def, const qn_node *node,
                                       const qn_material_keys *all)
{
    const qn_node *like = qn_node_child(node, "like");
    int m = like ? qn_material_find(def, like->text, strlen(like->text)) : -1;
    return m >= 0 ? &all[m] : NULL;
}

static void fill_material(qn_reader *r, qn_material_keys *k, qn_section_from from,
                          qn_material_def *m)
{
    bool both = k->young.node && k->shear.node;
    if (both)
        qn_complain(r, &k->shear, "is given besides young; one follows from the other, give one");
    if (k->shear.node)
        k->young.set = false;
    else if (k->young.node)
        k->shear.set = false;
    if (!k->young.set && !k->shear.set && !k->young.node && !k->shear.node && !k->like.node)
        qn_complain_at(r, from.mark, "%s lacks the key 'young': %s", from.path,
                       k->young.key->meaning);
    m->poisson_ratio = k->poisson.number;
    m->density = k->density.number;
    m->youngs_modulus =
        k->young.set ? k->young.number : 2 * (1 + k->poisson.number) * k->shear.number;
}

qn_status qn_build_materials(qn_reader *r, const qn_scene_keys *scene)
{
    const qn_node *nodes[QN_NAMES_MAX];
    int count = qn_names_read(r, &scene->materials, nodes);
    qn_material_keys *all = qn_tree_allocate(&r->tree, (size_t)(count + 1) * sizeof *all);
    if (!all) return qn_fail(QN_MEMORY, "no memory for the scene");
    QN_TRY(QN_ALLOCATE(r->def->materials, count));
    for (int i = 0; i < count; i++) {
        qn_material_def *m = &r->def->materials[r->def->material_count];
        if (!qn_name_read(r, nodes[i], "material", m->name)) continue;
        qn_section_from from = qn_section_entry(r, "materials", nodes[i], -1);
        from.fallback = like_of(r->def, nodes[i], all);
        from.is_partial = !from.fallback && qn_node_child(nodes[i], "like");
        qn_material_keys *k = &all[r->def->material_count];
        qn_section_read(r, QN_SECTION_MATERIAL, from, k);
        fill_material(r, k, from, m);
        r->def->material_count++;
    }
    if (count == 0 && scene->materials.set)
        qn_complain_at(r, scene->materials.mark, "materials has no entry; at least one is needed");
    return QN_OK;
}

/// Appends the material nearest to the first `length` letters of `name` to a suggestion.
static bool suggest(const qn_def *def, const char *name, size_t length, char *pair, size_t size)
{
    char known[QN_NAMES_MAX * 16] = "", word[QN_NAME_MAX] = "", nearest[QN_NAME_MAX];
    if (length >= sizeof word) return false;
    memcpy(word, name, length);
    for (int i = 0; i < def->material_count; i++)
        if (strlen(known) + QN_NAME_MAX + 2 < sizeof known)
            strcat(strcat(known, " "), def->materials[i].name);
    if (qn_material_find(def, name, length) >= 0)
        memcpy(nearest, word, sizeof nearest);
    else if (!qn_nearest_word(word, known, nearest, sizeof nearest))
        return false;
    size_t used = strlen(pair);
    snprintf(pair + used, size - used, "%s%s", used > 0 ? "-" : "", nearest);
    return true;
}

static void complain_about_pair(qn_reader *r, const qn_node *node)
{
    for (const char *p = strchr(node->key, '-'); p; p = strchr(p + 1, '-')) {
        char pair[2 * QN_NAME_MAX + 2] = "";
        if (suggest(r->def, node->key, (size_t)(p - node->key), pair, sizeof pair)
            && suggest(r->def, p + 1, strlen(p + 1), pair, sizeof pair)) {
            qn_complain_at(r, node->key_mark,
                           "'%.60s' in contacts is not a pair of materials; did you mean '%s'?",
                           node->key, pair);
            return;
        }
    }
    qn_complain_at(r, node->key_mark,
                   "'%.60s' in contacts is not a pair of materials, such as %s-%s; the only other "
                   "entry is 'defaults'",
                   node->key, r->def->material_count > 0 ? r->def->materials[0].name : "steel",
                   r->def->material_count > 1 ? r->def->materials[1].name : "glass");
}

/// Splits "a-b" into two materials; names may themselves hold a '-'.
static bool read_pair(qn_reader *r, const qn_node *node, qn_contact_def *c)
{
    int splits = 0;
    for (const char *p = strchr(node->key, '-'); p; p = strchr(p + 1, '-')) {
        int a = qn_material_find(r->def, node->key, (size_t)(p - node->key));
        int b = qn_material_find(r->def, p + 1, strlen(p + 1));
        if (a < 0 || b < 0) continue;
        c->material_a = a;
        c->material_b = b;
        splits++;
    }
    if (splits == 0) complain_about_pair(r, node);
    if (splits > 1)
        qn_complain_at(
            r, node->key_mark,
            "'%.60s' in contacts can be split into materials in more than one way; rename "
            "a material",
            node->key);
    return splits == 1;
}

static const bool law_clips[] = {
#define L(NAME, text, normal, damping, tangential, clips, meaning) clips,
    QN_LAWS(L)
#undef L
};

static void fill_contact(qn_reader *r, const qn_contact_keys *k, qn_contact_def *c)
{
    qn_law_name name = (qn_law_name)(k->law.set ? k->law.choice : QN_LAW_HERTZ_MINDLIN);
    c->law = qn_law_named(name);
    if (k->rolling_friction.number > 0) c->law.rolling = QN_ROLLING_CONSTANT;
    c->friction = k->friction.number;
    c->restitution = k->restitution.number;
    c->rolling_friction = k->rolling_friction.number;
    c->stiffness = k->stiffness.number;
    c->tangential_ratio = k->tangential_ratio.number;
    c->clip = k->clip.set ? k->clip.choice == 1 : law_clips[name];
    bool linear = name == QN_LAW_LINEAR;
    if (!k->law.set) return;
    if (linear && !k->stiffness.set && !k->stiffness.node)
        qn_complain_at(r, k->law.mark, "%s has the law linear, which needs the key 'stiffness': %s",
                       k->law.path, k->stiffness.key->meaning);
    const qn_value *only_linear[] = {&k->stiffness, &k->tangential_ratio};
    for (int i = 0; i < 2 && !linear; i++)
        if (only_linear[i]->node)
            qn_complain(r, only_linear[i], "means nothing here: only the law linear has it");
}

qn_status qn_build_contacts(qn_reader *r, const qn_scene_keys *scene)
{
    const qn_node *nodes[QN_NAMES_MAX];
    int count = qn_names_read(r, &scene->contacts, nodes);
    qn_contact_keys defaults = {0};
    QN_TRY(QN_ALLOCATE(r->def->contacts, count));
    const qn_node *written = qn_node_child(scene->contacts.node, "defaults");
    if (written) {
        qn_section_from from = qn_section_entry(r, "contacts", written, -1);
        from.is_partial = true;
        qn_section_read(r, QN_SECTION_CONTACT, from, &defaults);
    }
    for (int i = 0; i < count; i++) {
        qn_contact_def *c = &r->def->contacts[r->def->contact_count];
        if (nodes[i] == written || !read_pair(r, nodes[i], c)) continue;
        if (qn_def_contact(r->def, c->material_a, c->material_b)) {
            qn_complain_at(r, nodes[i]->key_mark, "the pair '%s' appears twice in contacts",
                           nodes[i]->key);
            continue;
        }
        qn_section_from from = qn_section_entry(r, "contacts", nodes[i], -1);
        from.fallback = &defaults;
        qn_contact_keys k;
        qn_section_read(r, QN_SECTION_CONTACT, from, &k);
        fill_contact(r, &k, c);
        r->def->contact_count++;
    }
    return QN_OK;
}
