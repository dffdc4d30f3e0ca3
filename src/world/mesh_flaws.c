// SPDX-License-Identifier: Apache-2.0
// What is odd about a mesh: places that are nearly the same, borders and seams, and how it is told.
#include "world/mesh_flaws.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SEAM =
    1e-4;  // 1   of the mesh's size: border edges that are nearer form a seam

typedef struct spot {
    int64_t key[3];
    int index;
} spot;

static int by_spot(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p->key[k] != q->key[k]) return p->key[k] < q->key[k] ? -1 : 1;
    return (p->index > q->index) - (p->index < q->index);
}

static int root_of(int *first, int v)
{
    while (first[v] != v) v = first[v] = first[first[v]];
    return v;
}

static void unite(int *first, int a, int b)
{
    a = root_of(first, a), b = root_of(first, b);
    if (a < b)
        first[b] = a;
    else
        first[a] = b;
}

/// Points in one cell of a lattice are the same. Two that are nearer than half a cell share one in at least
/// one of eight lattices, each moved on by half a cell along some axes.
qn_status qn_same_places(const qn_vec3 *points, int count, double tolerance, int *first)
{
    spot *spots;
    double cell = tolerance > 0 ? 2 * tolerance : 1;
    QN_TRY(QN_ALLOCATE(spots, count));
    for (int v = 0; v < count; v++) first[v] = v;
    for (int shift = 0; shift < 8; shift++) {
        for (int v = 0; v < count; v++) {
            qn_vec3 d = qn_sub(points[v], points[0]);
            const double x[3] = {d.x, d.y, d.z};
            spots[v].index = v;
            for (int k = 0; k < 3; k++)
                spots[v].key[k] = llround(x[k] / cell + 0.5 * (shift >> k & 1));
        }
        qsort(spots, (size_t)count, sizeof *spots, by_spot);
        for (int i = 1; i < count; i++)
            if (memcmp(spots[i].key, spots[i - 1].key, sizeof spots[i].key) == 0)
                unite(first, spots[i].index, spots[i - 1].index);
    }
    for (int v = 0; v < count; v++) first[v] = root_of(first, v);
    free(spots);
    return QN_OK;
}

void qn_mesh_note(qn_mesh *m, int kind, int number, qn_vec3 where)
{
    qn_mesh_flaw *flaw = &m->flaws[kind];
    if (flaw->count++ > 0 && flaw->first <= number) return;
    flaw->first = number;
    flaw->where = where;
}

static qn_vec3 middle_of(const qn_mesh *m, const qn_mesh_edge *e)
{
    return qn_scale(0.5, qn_add(m->vertices[e->a], m->vertices[e->b]));
}

static void note_edge(qn_mesh *m, int kind, const qn_mesh_edge *e)
{
    qn_mesh_note(m, kind, m->source[e->owner], middle_of(m, e));
}

/// Border edges whose middles lie together.
static qn_status find_seams(qn_mesh *m, const int *borders, int count)
{
    qn_vec3 *middles = NULL;
    int *first = NULL, *members = NULL;
    qn_status status = QN_ALLOCATE(middles, count);
    if (status == QN_OK) status = QN_ALLOCATE(first, count);
    if (status == QN_OK) status = QN_ALLOCATE(members, count);
    for (int i = 0; status == QN_OK && i < count; i++)
        middles[i] = middle_of(m, &m->edges[borders[i]]);
    if (status == QN_OK)
        status = qn_same_places(middles, count, SEAM * qn_norm(qn_sub(m->high, m->low)), first);
    for (int i = 0; status == QN_OK && i < count; i++) members[first[i]]++;
    for (int i = 0; status == QN_OK && i < count; i++)
        if (members[first[i]] > 1) note_edge(m, QN_MESH_GAP, &m->edges[borders[i]]);
    free(middles);
    free(first);
    free(members);
    return status;
}

qn_status qn_mesh_find_flaws(qn_mesh *m)
{
    int *borders, count = 0;
    QN_TRY(QN_ALLOCATE(borders, m->edge_count));
    for (int e = 0; e < m->edge_count; e++) {
        const qn_mesh_edge *edge = &m->edges[e];
        if (edge->count == 1) note_edge(m, QN_MESH_BORDER, edge);
        if (edge->count == 1) borders[count++] = e;
        if (edge->count > 2) note_edge(m, QN_MESH_CROWDED, edge);
    }
    qn_status status = count > 0 ? find_seams(m, borders, count) : QN_OK;
    free(borders);
    return status;
}

static const struct {
    const char *one, *many, *what;
} sentences[] = {
#define F(NAME, one, many, what) {one, many, what},
    QN_MESH_FLAWS(F)
#undef F
};

void qn_mesh_flaw_text(const qn_mesh *m, int kind, double unit, const char *unit_name, char *text,
                       size_t size)
{
    const qn_mesh_flaw *f = &m->flaws[kind];
    bool one = f->count == 1, vertex = kind == QN_MESH_APART;
    bool edge = kind == QN_MESH_BORDER || kind == QN_MESH_GAP || kind == QN_MESH_CROWDED;
    text[0] = 0;
    if (f->count == 0) return;
    snprintf(text, size, "mesh '%s': %d %s %s; %s%s %d at %.6g %.6g %.6g%s%s", m->name, f->count,
             one ? sentences[kind].one : sentences[kind].many, sentences[kind].what,
             one ? "it is " : "the first is ",
             vertex ? "vertex"
             : edge ? "at triangle"
                    : "triangle",
             f->first, f->where.x / unit, f->where.y / unit, f->where.z / unit,
             *unit_name ? " " : "", unit_name);
}
