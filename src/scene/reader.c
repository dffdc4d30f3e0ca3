// SPDX-License-Identifier: Apache-2.0
#include "scene/reader.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
    SHOWN = 60,     // letters of a value that a message repeats
    KEYS_MAX = 32,  // keys of a section
};

/// "drum.diameter = 3 kg", or "drum.diameter" where nothing is written.
static void name_value(const qn_value *v, char *text, size_t size)
{
    const char *dot = *v->path ? "." : "";
    if (!v->node || v->node->kind != QN_NODE_SCALAR || !*v->node->text)
        snprintf(text, size, "%s%s%s", v->path, dot, v->key->name);
    else {
        int shown = (int)strcspn(v->node->text, "\n");
        bool cut = shown > SHOWN || v->node->text[shown];
        snprintf(text, size, "%s%s%s = %.*s%s", v->path, dot, v->key->name,
                 shown > SHOWN ? SHOWN : shown, v->node->text, cut ? "..." : "");
    }
}

void qn_complain(qn_reader *r, const qn_value *v, const char *format, ...)
{
    char sentence[1024], name[256];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    name_value(v, name, sizeof name);
    qn_message(r->messages, &r->source, QN_ERROR, v->mark, "%s %s", name, sentence);
}

void qn_complain_at(qn_reader *r, qn_mark mark, const char *format, ...)
{
    char sentence[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    qn_message(r->messages, &r->source, QN_ERROR, mark, "%s", sentence);
}

/// Path of a section, kept as long as the tree.
static const char *keep(qn_reader *r, const char *path)
{
    size_t length = strlen(path);
    char *kept = qn_tree_allocate(&r->tree, length + 1);
    return kept ? memcpy(kept, path, length + 1) : "";
}

static int key_index(const qn_section *s, const char *name)
{
    for (int i = 0; i < s->key_count; i++)
        if (!strcmp(s->keys[i].name, name)) return i;
    return -1;
}

/// Index of the key that was probably meant; -1 where that is open.
static int complain_about_key(qn_reader *r, const qn_section *s, const char *path,
                              const qn_node *node)
{
    char known[512] = "", nearest[64];
    for (int i = 0; i < s->key_count; i++) {
        size_t used = strlen(known);
        snprintf(known + used, sizeof known - used, "%s%s", i > 0 ? ", " : "", s->keys[i].name);
    }
    const char *where = *path ? path : "the scene";
    if (strchr(node->key, ':')) {
        qn_complain_at(r, node->key_mark,
                       "unknown key '%.*s' in %s: a space is missing behind the ':'", SHOWN,
                       node->key, where);
        char before[64];
        snprintf(before, sizeof before, "%.*s", (int)strcspn(node->key, ":"), node->key);
        return key_index(s, before);
    }
    if (qn_nearest_word(node->key, known, nearest, sizeof nearest)) {
        qn_complain_at(r, node->key_mark, "unknown key '%.*s' in %s; did you mean '%s'?", SHOWN,
                       node->key, where, nearest);
        return key_index(s, nearest);
    }
    qn_complain_at(r, node->key_mark, "unknown key '%.*s' in %s; known are: %s", SHOWN, node->key,
                   where, known);
    return -1;
}

static const char *kind_of_node(const qn_node *node)
{
    return node->kind == QN_NODE_MAP    ? "a map of keys"
           : node->kind == QN_NODE_LIST ? "a list"
                                        : "a single value";
}

/// Whether the node is of the kind its key wants: scalar, map or list. `output:` with nothing behind
/// it is an empty map.
static bool fits(qn_reader *r, const qn_value *v, const qn_node *node)
{
    bool is_map = v->key->kind == QN_KIND_MAP || v->key->kind == QN_KIND_NAMES;
    qn_node_kind wanted = is_map                         ? QN_NODE_MAP
                          : v->key->kind == QN_KIND_LIST ? QN_NODE_LIST
                                                         : QN_NODE_SCALAR;
    if (node->kind == wanted) return true;
    if (is_map && node->kind == QN_NODE_SCALAR && !*node->text) return true;
    bool stuck = is_map && node->kind == QN_NODE_SCALAR && strchr(node->text, ':');
    qn_complain(r, v, "is %s, but should be %s: %s", kind_of_node(node),
                is_map                   ? "a map of keys"
                : wanted == QN_NODE_LIST ? "a list"
                                         : qn_kind_text(v->key->kind),
                stuck ? "a space is missing behind the ':'" : v->key->meaning);
    return false;
}

static void read_node(qn_reader *r, const qn_node *n, qn_value *v)
{
    v->node = n;
    v->mark = n->mark;
    v->set = fits(r, v, n) && qn_value_read(r, n->kind == QN_NODE_SCALAR ? n->text : " ", v);
    if (!v->set)
        *v = (qn_value){.key = v->key, .path = v->path, .node = n, .mark = n->mark, .text = ""};
}

/// A misspelt key is read as the one that was probably meant, so that nothing more is said about that one
/// being missing; a value that does not fit it is passed over.
static void read_meant(qn_reader *r, const qn_node *n, qn_value *v)
{
    qn_messages *messages = r->messages, none = {0};
    r->messages = &none;
    read_node(r, n, v);
    r->messages = messages;
    qn_messages_free(&none);
}

/// 2,5 mm between braces: YAML takes what follows the comma for a key.
static bool is_split(const qn_node *n)
{
    const qn_node *rest = n->next;
    size_t length = strlen(n->text);
    return length > 0 && isdigit((unsigned char)n->text[length - 1]) && rest
           && rest->kind == QN_NODE_SCALAR && !*rest->text && isdigit((unsigned char)rest->key[0]);
}

/// Reads what is written; how many keys were misspelt.
static int read_written(qn_reader *r, const qn_section *s, const qn_section_from *from,
                        qn_value *values)
{
    int misspelt = 0;
    const qn_node *meant[KEYS_MAX] = {NULL};
    for (const qn_node *n = from->node->first; n && !qn_messages_full(r->messages); n = n->next) {
        int k = key_index(s, n->key);
        if (k < 0) {
            k = complain_about_key(r, s, from->path, n);
            if (k >= 0) meant[k] = n;
            continue;
        }
        if (values[k].node) {
            qn_complain_at(r, n->key_mark, "key '%s' appears twice in %s; it is first in line %d",
                           n->key, *from->path ? from->path : "the scene",
                           values[k].node->key_mark.line);
            continue;
        }
        if (is_split(n)) {
            qn_complain_at(
                r, n->mark,
                "%s%s%s = %.*s,%.*s has a comma: decimals follow a '.', and thousands are "
                "not set apart",
                from->path, *from->path ? "." : "", n->key, SHOWN, n->text, SHOWN, n->next->key);
            values[k].node = n;
            n = n->next;
            continue;
        }
        read_node(r, n, &values[k]);
    }
    for (int k = 0; k < s->key_count; k++)
        if (meant[k]) {
            misspelt++;
            if (!values[k].node) read_meant(r, meant[k], &values[k]);
        }
    return misspelt;
}

void qn_section_read(qn_reader *r, qn_section_id id, qn_section_from from, void *out)
{
    const qn_section *s = &qn_sections[id];
    qn_value *values = out;
    const qn_value *fallback = from.fallback;
    const char *path = keep(r, from.path);
    for (int i = 0; i < s->key_count; i++)
        values[i] = (qn_value){.key = &s->keys[i], .path = path, .mark = from.mark, .text = ""};
    bool is_map = from.node && from.node->kind == QN_NODE_MAP;
    if (from.node && !is_map && *from.node->text) {
        qn_complain_at(r, from.node->mark, "%s is %s, but should be a map of keys", from.path,
                       kind_of_node(from.node));
        return;
    }
    int misspelt = is_map ? read_written(r, s, &from, values) : 0;
    // In a material it may be the one that says where the rest is to be found.
    bool is_partial = from.is_partial || (misspelt > 0 && id == QN_SECTION_MATERIAL);
    for (int i = 0; i < s->key_count; i++) {
        qn_value *v = &values[i];
        if (v->node) continue;
        if (fallback && fallback[i].set) {
            *v = fallback[i];
            v->node = NULL;
            v->path = path;
            v->mark = from.mark;
        } else if (!strcmp(v->key->fallback, REQUIRED)) {
            // What the fallback itself has wrong, or a material above lacks, is told already.
            bool told = fallback && (fallback[i].node || id == QN_SECTION_MATERIAL);
            if (!is_partial && !told && !qn_messages_full(r->messages))
                qn_complain_at(r, from.mark, "%s lacks the key '%s': %s",
                               *path ? path : "the scene", v->key->name, v->key->meaning);
        } else if (*v->key->fallback)
            v->set = qn_value_read(r, v->key->fallback, v);
    }
}

qn_section_from qn_section_under(const qn_reader *r, const qn_value *v)
{
    qn_section_from from = {.node = v->node, .path = v->key->name, .mark = v->mark};
    if (*v->path) {
        size_t size = strlen(v->path) + strlen(v->key->name) + 2;
        char *path = qn_tree_allocate((qn_tree *)&r->tree, size);
        if (path) {
            snprintf(path, size, "%s.%s", v->path, v->key->name);
            from.path = path;
        }
    }
    if (v->node) from.mark = v->node->key_mark;
    return from;
}

bool qn_name_read(qn_reader *r, const qn_node *node, const char *what, char name[QN_NAME_MAX])
{
    size_t length = strlen(node->key);
    bool good = length > 0;
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)node->key[i];
        good = good && c < 0x80 && (c == '_' || c == '-' || c == '.' || c >= '0')
               && !strchr(":;<=>?@[\\]^`{|}~", c);
    }
    if (good && length < QN_NAME_MAX) {
        memcpy(name, node->key, length + 1);
        return true;
    }
    qn_complain_at(r, node->key_mark,
                   "'%.*s' cannot be the name of a %s: use up to %d letters, digits, '_', '-', '.'",
                   SHOWN, node->key, what, QN_NAME_MAX - 1);
    return false;
}

int qn_material_find(const qn_def *def, const char *name, size_t length)
{
    for (int i = 0; i < def->material_count; i++)
        if (strlen(def->materials[i].name) == length
            && !strncmp(def->materials[i].name, name, length))
            return i;
    return -1;
}

int qn_names_read(qn_reader *r, const qn_value *v, const qn_node *nodes[QN_NAMES_MAX])
{
    int n = 0;
    if (!v->set || !v->node || v->node->kind != QN_NODE_MAP) return 0;
    for (const qn_node *c = v->node->first; c && !qn_messages_full(r->messages); c = c->next) {
        bool twice = false;
        for (int i = 0; i < n && !twice; i++) twice = !strcmp(nodes[i]->key, c->key);
        if (twice)
            qn_complain_at(r, c->key_mark, "'%.*s' appears twice in %s", SHOWN, c->key,
                           v->key->name);
        else if (n == QN_NAMES_MAX) {
            qn_complain_at(r, c->key_mark, "%s has more than %d entries", v->key->name,
                           QN_NAMES_MAX);
            break;
        } else
            nodes[n++] = c;
    }
    return n;
}
