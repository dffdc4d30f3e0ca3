// SPDX-License-Identifier: Apache-2.0
// A YAML text as a small tree of maps, lists and scalars, each with its place in the text.
//
// Read from libyaml's events. Only what a scene needs is let in: one document, no anchors, aliases
// or tags, plain keys, and limits on depth and number of values, so that no text can be expensive.
#ifndef QN_SCENE_TREE_H
#define QN_SCENE_TREE_H

#include "scene/messages.h"

enum { QN_DEPTH_MAX = 12, QN_NODES_MAX = 50000, QN_TEXT_MAX = 1 << 20 };

typedef enum qn_node_kind { QN_NODE_SCALAR, QN_NODE_MAP, QN_NODE_LIST } qn_node_kind;

typedef struct qn_node {
    qn_node_kind kind;
    qn_mark mark;                         //   of the value
    const char *text;                     //   of a scalar, "" otherwise
    const char *key;                      //   in a map; NULL elsewhere
    qn_mark key_mark;                     //   in a map; that of the value elsewhere
    struct qn_node *first, *last, *next;  // children, and the next child of the same parent
} qn_node;

typedef struct qn_tree {
    qn_node *root;
    int node_count;
    void *blocks;  // owned; everything above lives there
} qn_tree;

/// Builds the tree of a text; what is wrong with it goes to `messages`. QN_INPUT if it is not YAML.
QN_NODISCARD qn_status qn_tree_read(const qn_source *source, qn_messages *messages, qn_tree *tree);

/// `size` bytes that live as long as the tree; NULL if there is no memory.
void *qn_tree_allocate(qn_tree *tree, size_t size);

void qn_tree_free(qn_tree *tree);

/// The child of a map with this key, or NULL.
const qn_node *qn_node_child(const qn_node *map, const char *key);

#endif
