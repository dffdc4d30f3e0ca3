// SPDX-License-Identifier: Apache-2.0
// The contact laws between materials: the pair, its models, the numbers they need.
#include "base/array.h"
#include "scene/build.h"

#include <stdio.h>
#include <string.h>

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

static qn_law law_of(const qn_contact_keys *k, qn_law_name name)
{
    qn_law law = qn_law_named(name);
    if (k->rolling_friction.number > 0) law.rolling = QN_ROLLING_CONSTANT;
    if (k->normal.set) law.normal = (qn_normal_model)k->normal.choice;
    if (k->damping.set) law.damping = (qn_damping_model)k->damping.choice;
    if (k->cohesion.set) law.cohesion = (qn_cohesion_model)k->cohesion.choice;
    if (k->tangential.set) law.tangential = (qn_tangential_model)k->tangential.choice;
    if (k->rolling.set) law.rolling = (qn_rolling_model)k->rolling.choice;
    return law;
}

/// Complains about a model that does not go with the spring; `fits` says which do.
static void complain_about_model(qn_reader *r, const qn_contact_keys *k, const qn_value *model,
                                 const char *text, qn_law law, bool (*fits)(qn_law))
{
    const qn_value *at = model->node ? model : k->normal.node ? &k->normal : &k->law;
    const char *spring = qn_normal_text(law.normal);
    char others[128] = "";
    for (int n = 0; n < QN_NORMAL_COUNT; n++) {
        law.normal = (qn_normal_model)n;
        if (fits(law)) strcat(strcat(others, *others ? ", " : ""), qn_normal_text(law.normal));
    }
    qn_complain_at(r, at->mark,
                   "%s has the normal model %s, with which the %s model %s makes no sense; it goes "
                   "with: %s",
                   at->path, spring, model->key->name, text, others);
}

static void check_models(qn_reader *r, const qn_contact_keys *k, qn_law law)
{
    if (!qn_damping_fits(law))
        complain_about_model(r, k, &k->damping, qn_damping_text(law.damping), law, qn_damping_fits);
    if (!qn_cohesion_fits(law))
        complain_about_model(r, k, &k->cohesion, qn_cohesion_text(law.cohesion), law,
                             qn_cohesion_fits);
    if (!qn_tangential_fits(law))
        complain_about_model(r, k, &k->tangential, qn_tangential_text(law.tangential), law,
                             qn_tangential_fits);
}

/// Numbers that the law lacks, and numbers that mean nothing to it.
static void check_numbers(qn_reader *r, const qn_contact_keys *k, const qn_contact_keys *defaults,
                          qn_law law)
{
    bool either = law.normal == QN_NORMAL_LINEAR && law.damping != QN_DAMPING_HUNT_CROSSLEY;
    const struct {
        const qn_value *value, *fallback;
        bool used;
        const char *with;
    } numbers[] = {
#define C(name, unit, used, with) {&k->name, &defaults->name, used, with},
        QN_CONTACT_NUMBERS(C)
#undef C
    };
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        const qn_value *v = numbers[i].value;
        bool optional = v == &k->stiffness || (v == &k->impact_speed && either);
        if (numbers[i].used && !optional && !v->set && !v->node && !numbers[i].fallback->node)
            qn_complain_at(r, v->mark, "%s lacks the key '%s': %s", v->path, v->key->name,
                           v->key->meaning);
        if (!numbers[i].used && v->node && v->number > 0)
            qn_complain(r, v, "means nothing here: it goes with %s", numbers[i].with);
    }
    const qn_value *v = &k->stiffness, *linear = k->normal.node ? &k->normal : &k->law;
    if (either && !v->set && !v->node && !k->impact_speed.set && !k->impact_speed.node)
        qn_complain_at(r, linear->mark,
                       "%s has a linear spring, which needs the key 'stiffness' or 'impact_speed'",
                       v->path);
}

static void fill_contact(qn_reader *r, const qn_contact_keys *k, const qn_contact_keys *defaults,
                         qn_contact_def *c)
{
    const qn_value *words[] = {&k->law,      &k->normal,     &k->damping,
                               &k->cohesion, &k->tangential, &k->rolling};
    qn_law_name name = (qn_law_name)(k->law.set ? k->law.choice : QN_LAW_HERTZ_MINDLIN);
    c->law = law_of(k, name);
    c->clip = k->clip.set ? k->clip.choice == 1 : law_clips[name];
#define C(name, unit, used, with) c->name = k->name.number;
    QN_CONTACT_NUMBERS(C)
#undef C
    for (int i = 0; i < 6; i++)
        if (words[i]->node && !words[i]->set)
            return;  // a misspelt model: nothing can be said of its numbers
    check_models(r, k, c->law);
    check_numbers(r, k, defaults, c->law);
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
        fill_contact(r, &k, &defaults, c);
        r->def->contact_count++;
    }
    return QN_OK;
}
