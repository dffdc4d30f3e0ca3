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
