// SPDX-License-Identifier: Apache-2.0
// The shape of a group's particles: balls, or clumps from a template or a file.
#include "base/array.h"
#include "scene/build.h"
#include "scene/load.h"

#include <string.h>

enum { SHAPE_SPHERE, SHAPE_TETRAHEDRON, SHAPE_FILE };

/// Keys that only mean something for other shapes are mistakes.
static void check_shape(qn_reader *r, const qn_group_keys *k, int shape, qn_mark mark)
{
    if (k->spacing.node && shape != SHAPE_TETRAHEDRON)
        qn_complain(r, &k->spacing, "means nothing where shape is not tetrahedron");
    if (k->shape_file.node && shape != SHAPE_FILE)
        qn_complain(r, &k->shape_file, "means nothing where shape is not file");
    if (k->turned.node && shape == SHAPE_SPHERE)
        qn_complain(r, &k->turned, "means nothing for spheres");
    if (shape == SHAPE_FILE && !k->shape_file.node)
        qn_complain_at(r, mark, "%s lacks the key 'shape_file': %s", k->shape_file.path,
                       k->shape_file.key->meaning);
}

/// Adds the shape of these spheres to the definition.
static qn_status add_shape(qn_reader *r, const qn_value *source, const double *centres,
                           const double *radii, int count, qn_group_def *g)
{
    qn_shape *shape = &r->def->shapes[r->def->shape_count];
    double radius;
    qn_status status = qn_shape_of(centres, radii, count, shape, &radius);
    if (status == QN_INPUT) {
        qn_complain(r, source, "cannot be used: %s", qn_error());
        return QN_OK;
    }
    QN_TRY(status);
    g->shape = ++r->def->shape_count;
    return QN_OK;
}

static qn_status read_file(qn_reader *r, const qn_group_keys *k, qn_group_def *g)
{
    char path[QN_PATH_MAX];
    double radii[QN_SPHERES_MAX];
    qn_particle_list list;
    if (!k->shape_file.set || !qn_file_of(r, &k->shape_file, path)) return QN_OK;
    if (qn_load_particles(path, 1, &list) != QN_OK) {
        qn_complain(r, &k->shape_file, "cannot be used: %s", qn_error());
        return QN_OK;
    }
    qn_status status = QN_OK;
    if (!list.diameter)
        qn_complain(r, &k->shape_file, "has no column 'radius' or 'diameter'");
    else if (list.count > QN_SPHERES_MAX)
        qn_complain(r, &k->shape_file, "holds %lld spheres; a clump has at most %d",
                    (long long)list.count, QN_SPHERES_MAX);
    else {
        for (int i = 0; i < (int)list.count; i++) radii[i] = list.diameter[i] / 2;
        status = add_shape(r, &k->shape_file, list.position, radii, (int)list.count, g);
    }
    qn_particle_list_free(&list);
    return status;
}

qn_status qn_build_shape(qn_reader *r, const qn_group_keys *k, qn_mark mark, qn_group_def *g)
{
    double centres[12], radii[4];
    if (!k->shape.set) return QN_OK;
    check_shape(r, k, k->shape.choice, mark);
    g->turned = qn_vector_of(&k->turned);
    g->turned_at_random = !k->turned.node && g->packing != QN_PACK_LIST;
    if (k->shape.choice == SHAPE_FILE) return read_file(r, k, g);
    if (k->shape.choice == SHAPE_SPHERE || !k->spacing.set) return QN_OK;
    qn_shape_tetrahedron(k->spacing.number, centres, radii);
    return add_shape(r, &k->spacing, centres, radii, 4, g);
}
