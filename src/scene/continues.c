// SPDX-License-Identifier: Apache-2.0
// Whether a run can go on with a scene that was changed: two resolved scenes, value by value.
#include "base/array.h"
#include "base/hash.h"
#include "scene/keys.h"
#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_ROOM = 256, VALUE_ROOM = 512 };

/// A value of a resolved scene.
typedef struct leaf {
    const char *path, *value;  // in the tree
    qn_resume resume;
} leaf;

typedef struct leaves {
    qn_tree tree;
    leaf *all;  // owned
    int count;
    int64_t room;
} leaves;

static qn_status add_leaf(leaves *l, const char *path, const qn_node *node, const qn_key *key)
{
    size_t size = strlen(path) + 1;
    char *kept = qn_tree_allocate(&l->tree, size);
    if (!kept) return qn_fail(QN_MEMORY, "no memory to compare scenes");
    QN_TRY(QN_RESERVE(l->all, l->room, l->count + 1));
    l->all[l->count++] =
        (leaf){memcpy(kept, path, size), node->text, key ? key->resume : QN_RESUME_FIXED};
    return QN_OK;
}

/// Collects the values under a node of a kind: `path` as messages name it, `place` as the list of
/// sections does.
static qn_status collect(leaves *l, const qn_node *node, qn_kind kind, const char *path,
                         const char *place)
{
    int number = 0;
    const char *dot = *path ? "." : "";
    for (const qn_node *n = node->first; n; n = n->next) {
        char at[PATH_ROOM], at_place[PATH_ROOM];
        const qn_key *key = kind == QN_KIND_MAP && n->key ? qn_key_find(place, n->key) : NULL;
        if (n->key) {
            snprintf(at, sizeof at, "%s%s%s", path, dot, n->key);
            snprintf(at_place, sizeof at_place, "%s%s%s", place, dot, key ? n->key : "NAME");
        } else {
            snprintf(at, sizeof at, "%s[%d]", path, ++number);
            snprintf(at_place, sizeof at_place, "%s[]", place);
        }
        if (n->kind == QN_NODE_SCALAR)
            QN_TRY(add_leaf(l, at, n, key));
        else
            QN_TRY(collect(l, n, key ? key->kind : QN_KIND_MAP, at, at_place));
    }
    return QN_OK;
}

static qn_status read_leaves(const char *text, const char *name, leaves *l)
{
    qn_source source = {name, text, strlen(text)};
    qn_messages messages = {0};
    qn_status status = qn_tree_read(&source, &messages, &l->tree);
    qn_messages_free(&messages);
    if (status == QN_OK) status = collect(l, l->tree.root, QN_KIND_MAP, "", "");
    return status;
}

static void free_leaves(leaves *l)
{
    qn_tree_free(&l->tree);
    free(l->all);
    *l = (leaves){0};
}

static const leaf *find(const leaves *l, const char *path)
{
    for (int i = 0; i < l->count; i++)
        if (!strcmp(l->all[i].path, path)) return &l->all[i];
    return NULL;
}

/// A value as a person would write it: numbers with as many digits as they need, not seventeen.
static const char *show(const leaf *l, char text[VALUE_ROOM])
{
    size_t used = 0;
    if (!l) return "not there";
    text[0] = 0;
    for (const char *p = l->value; *p && used < VALUE_ROOM - 40;) {
        size_t length = strcspn(p, " ") + strspn(p + strcspn(p, " "), " ");
        char *end, shorter[40];
        double x = strtod(p, &end);
        bool is_number = end > p && (*end == ' ' || !*end);
        for (int digits = 6; is_number && digits <= 17; digits++) {
            snprintf(shorter, sizeof shorter, "%.*g%s", digits, x, *end ? " " : "");
            if (strtod(shorter, NULL) == x) break;
        }
        int n = snprintf(text + used, VALUE_ROOM - used, "%.*s", is_number ? 40 : (int)length,
                         is_number ? shorter : p);
        used += (size_t)n;
        p += length;
    }
    return text;
}

static qn_status refuse(const char *path, const leaf *before, const leaf *now)
{
    char old[VALUE_ROOM], fresh[VALUE_ROOM];
    return qn_fail(QN_INPUT,
                   "%s = %s, but the run began with %s: it can't go on with another value. "
                   "Put that back, or start anew with --force or in another folder (-o)",
                   path, show(now, fresh), show(before, old));
}

/// Keys of one scene against those of the other; those that may differ are told in `out`.
static qn_status compare(const leaves *before, const leaves *now, FILE *out)
{
    char old[VALUE_ROOM], fresh[VALUE_ROOM];
    for (int i = 0; i < now->count; i++) {
        const leaf *n = &now->all[i], *b = find(before, n->path);
        if (b && !strcmp(b->value, n->value)) continue;
        if (n->resume == QN_RESUME_FIXED) return refuse(n->path, b, n);
        fprintf(out, "%s = %s, was %s\n", n->path, show(n, fresh), show(b, old));
    }
    for (int i = 0; i < before->count; i++) {
        const leaf *b = &before->all[i];
        if (find(now, b->path)) continue;
        if (b->resume == QN_RESUME_FIXED) return refuse(b->path, b, NULL);
        fprintf(out, "%s is not there, was %s\n", b->path, show(b, old));
    }
    return QN_OK;
}

/// Particles are numbered, and materials and walls counted, in the order of the scene.
static qn_status compare_order(const leaves *before, const leaves *now)
{
    int b = 0, n = 0;
    for (;; b++, n++) {
        while (b < before->count && before->all[b].resume == QN_RESUME_FREE) b++;
        while (n < now->count && now->all[n].resume == QN_RESUME_FREE) n++;
        if (b >= before->count || n >= now->count) return QN_OK;
        if (strcmp(before->all[b].path, now->all[n].path))
            return qn_fail(QN_INPUT,
                           "%s stands where the run began with %s: the order matters. Put it back, "
                           "or start anew with --force or in another folder (-o)",
                           now->all[n].path, before->all[b].path);
    }
}

qn_status qn_scene_continues(const char *before, const char *now, char **changes)
{
    leaves old = {0}, fresh = {0};
    size_t size;
    FILE *out = open_memstream(changes, &size);
    if (!out) return qn_fail(QN_MEMORY, "no memory to compare scenes");
    qn_status status = read_leaves(before, "the scene of the run", &old);
    if (status == QN_OK) status = read_leaves(now, "the scene", &fresh);
    if (status == QN_OK) status = compare(&old, &fresh, out);
    if (status == QN_OK) status = compare_order(&old, &fresh);
    free_leaves(&old);
    free_leaves(&fresh);
    if (fclose(out) != 0 && status == QN_OK)
        status = qn_fail(QN_MEMORY, "no memory to compare scenes");
    if (status == QN_OK) return QN_OK;
    free(*changes);
    *changes = NULL;
    return status;
}

qn_status qn_scene_hash(const char *resolved, uint64_t *hash)
{
    leaves l = {0};
    qn_status status = read_leaves(resolved, "the scene", &l);
    *hash = QN_HASH_START;
    for (int i = 0; i < l.count; i++) {
        const leaf *a = &l.all[i];
        if (a->resume == QN_RESUME_FREE) continue;
        *hash = qn_hash(*hash, a->path, strlen(a->path) + 1);
        *hash = qn_hash(*hash, a->value, strlen(a->value) + 1);
    }
    free_leaves(&l);
    return status;
}
