// SPDX-License-Identifier: Apache-2.0
#include "scene/tree.h"

#include "scene/syntax.h"

#include <stdlib.h>
#include <string.h>
#include <yaml.h>

typedef struct block {
    struct block *next;
    size_t used, size;
    max_align_t bytes[];
} block;

void *qn_tree_allocate(qn_tree *tree, size_t size)
{
    size = (size + sizeof(max_align_t) - 1) / sizeof(max_align_t) * sizeof(max_align_t);
    block *b = tree->blocks;
    if (!b || b->size - b->used < size) {
        size_t room = size > 16384 ? size : 16384;
        b = malloc(sizeof *b + room);
        if (!b) return NULL;
        *b = (block){.next = tree->blocks, .size = room};
        tree->blocks = b;
    }
    void *fresh = (char *)b->bytes + b->used;
    b->used += size;
    return memset(fresh, 0, size);
}

void qn_tree_free(qn_tree *tree)
{
    for (block *b = tree->blocks, *next; b; b = next) {
        next = b->next;
        free(b);
    }
    *tree = (qn_tree){0};
}

const qn_node *qn_node_child(const qn_node *map, const char *key)
{
    if (!map || map->kind != QN_NODE_MAP) return NULL;
    for (const qn_node *n = map->first; n; n = n->next)
        if (!strcmp(n->key, key)) return n;
    return NULL;
}

/// The state of a walk through the events: the open maps and lists, and a key that waits for its value.
typedef struct walk {
    const qn_source *source;
    qn_messages *messages;
    qn_tree *tree;
    qn_node *open[QN_DEPTH_MAX];
    int depth;
    const char *key;
    qn_mark key_mark;
} walk;

static qn_mark mark_of(yaml_mark_t start, yaml_mark_t end)
{
    size_t width =
        end.line == start.line && end.column > start.column ? end.column - start.column : 1;
    return (qn_mark){(int)start.line + 1, (int)start.column + 1, (int)width};
}

static qn_status refuse(walk *w, qn_mark mark, const char *sentence)
{
    qn_message(w->messages, w->source, QN_ERROR, mark, "%s", sentence);
    return qn_fail(QN_INPUT, "%s: %s", w->source->name, sentence);
}

static const char *copy_text(qn_tree *tree, const yaml_event_t *e)
{
    size_t length = e->data.scalar.length;
    char *text = qn_tree_allocate(tree, length + 1);
    if (text) memcpy(text, e->data.scalar.value, length);
    return text;
}

static bool is_text(const yaml_event_t *e)
{
    for (size_t i = 0; i < e->data.scalar.length; i++) {
        unsigned char c = e->data.scalar.value[i];
        if ((c < 0x20 && c != '\n') || c == 0x7F) return false;
    }
    return true;
}

/// Puts a new node where the walk stands: at the root, in a list, or behind the waiting key.
static qn_status add_node(walk *w, qn_node_kind kind, qn_mark mark, const char *text)
{
    if (++w->tree->node_count > QN_NODES_MAX)
        return refuse(w, mark, "the file has more than 50000 values, which no scene needs");
    qn_node *n = qn_tree_allocate(w->tree, sizeof *n);
    if (!n) return qn_fail(QN_MEMORY, "no memory for the scene");
    *n = (qn_node){.kind = kind, .mark = mark, .text = text, .key = w->key};
    n->key_mark = w->key ? w->key_mark : mark;
    w->key = NULL;
    if (w->depth == 0)
        w->tree->root = n;
    else {
        qn_node *parent = w->open[w->depth - 1];
        if (parent->last)
            parent->last->next = n;
        else
            parent->first = n;
        parent->last = n;
    }
    if (kind == QN_NODE_SCALAR) return QN_OK;
    if (w->depth == QN_DEPTH_MAX)
        return refuse(w, mark, "maps and lists are nested deeper than 12 levels");
    w->open[w->depth++] = n;
    return QN_OK;
}

/// Whether the next node in the open map must be a key.
static bool key_is_due(const walk *w)
{
    return w->depth > 0 && w->open[w->depth - 1]->kind == QN_NODE_MAP && !w->key;
}

static qn_status take_scalar(walk *w, const yaml_event_t *e, qn_mark mark)
{
    if (e->data.scalar.anchor || e->data.scalar.tag)
        return refuse(w, mark, "anchors (&), aliases (*) and tags (!) are not part of a scene");
    if (!is_text(e)) return refuse(w, mark, "a control character cannot be part of a value");
    const char *text = copy_text(w->tree, e);
    if (!text) return qn_fail(QN_MEMORY, "no memory for the scene");
    if (!key_is_due(w)) return add_node(w, QN_NODE_SCALAR, mark, text);
    if (!*text) return refuse(w, mark, "a key is missing before ':'");
    w->key = text;
    w->key_mark = mark;
    return QN_OK;
}

static qn_status take_start(walk *w, qn_node_kind kind, qn_mark mark, bool decorated)
{
    mark.width = 1;
    if (decorated)
        return refuse(w, mark, "anchors (&), aliases (*) and tags (!) are not part of a scene");
    if (key_is_due(w)) return refuse(w, mark, "a key must be a plain word, not a map or list");
    return add_node(w, kind, mark, "");
}

static qn_status take_event(walk *w, const yaml_event_t *e)
{
    qn_mark mark = mark_of(e->start_mark, e->end_mark);
    switch (e->type) {
    case YAML_SCALAR_EVENT: return take_scalar(w, e, mark);
    case YAML_MAPPING_START_EVENT:
        return take_start(w, QN_NODE_MAP, mark,
                          e->data.mapping_start.anchor || e->data.mapping_start.tag);
    case YAML_SEQUENCE_START_EVENT:
        return take_start(w, QN_NODE_LIST, mark,
                          e->data.sequence_start.anchor || e->data.sequence_start.tag);
    case YAML_MAPPING_END_EVENT:
    case YAML_SEQUENCE_END_EVENT: w->depth--; return QN_OK;
    case YAML_ALIAS_EVENT:
        return refuse(w, mark, "anchors (&), aliases (*) and tags (!) are not part of a scene");
    case YAML_DOCUMENT_START_EVENT:
        if (w->tree->root)
            return refuse(w, mark, "a second document begins; one file is one scene");
        return QN_OK;
    default: return QN_OK;
    }
}

static qn_status refuse_syntax(walk *w, const yaml_parser_t *parser)
{
    qn_mark mark = mark_of(parser->problem_mark, parser->problem_mark);
    if (parser->error == YAML_MEMORY_ERROR) return qn_fail(QN_MEMORY, "no memory for the scene");
    if (parser->error == YAML_READER_ERROR) {
        qn_message(w->messages, w->source, QN_ERROR, (qn_mark){0}, "byte %zu: %s",
                   parser->problem_offset + 1, parser->problem);
        return qn_fail(QN_INPUT, "%s is not a text file", w->source->name);
    }
    char sentence[256];
    qn_mark context = {0};
    if (parser->context) context = mark_of(parser->context_mark, parser->context_mark);
    mark = qn_syntax_explain(w->source, parser->problem ? parser->problem : "", mark, context,
                             sentence, sizeof sentence);
    return refuse(w, mark, sentence);
}

/// Text is UTF-8 without control characters; libyaml then sees the same lines as the messages.
static qn_status check_text(walk *w)
{
    const unsigned char *p = (const unsigned char *)w->source->text;
    for (size_t i = 0; i < w->source->length; i++)
        if ((p[i] < 0x20 && p[i] != '\t' && p[i] != '\n' && p[i] != '\r') || p[i] == 0x7F
            || p[i] >= 0xF8) {
            qn_message(w->messages, w->source, QN_ERROR, (qn_mark){0},
                       "not a text file: byte %zu is 0x%02x; a scene is plain text (YAML)", i + 1,
                       p[i]);
            return qn_fail(QN_INPUT, "%s is not a text file", w->source->name);
        }
    return QN_OK;
}

qn_status qn_tree_read(const qn_source *source, qn_messages *messages, qn_tree *tree)
{
    walk w = {.source = source, .messages = messages, .tree = tree};
    *tree = (qn_tree){0};
    QN_TRY(check_text(&w));
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser)) return qn_fail(QN_MEMORY, "no memory for the scene");
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)source->text, source->length);
    qn_status status = QN_OK;
    for (bool done = false; !done && status == QN_OK;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&parser, &event)) {
            status = refuse_syntax(&w, &parser);
            break;
        }
        status = take_event(&w, &event);
        done = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    if (status == QN_OK && !tree->root) status = refuse(&w, (qn_mark){0}, "the file is empty");
    return status;
}
