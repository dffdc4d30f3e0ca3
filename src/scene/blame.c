// SPDX-License-Identifier: Apache-2.0
// The place in a scene that a sentence of the world is about.
#include "scene/scene.h"
#include "scene/tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The deepest node that the path at the start of a sentence leads to ("drum.length = ..." and
// "drum.schedule[2].to = ...").
static qn_mark place_of(const qn_node *root, const char *sentence)
{
    char key[64];
    const qn_node *node = root;
    qn_mark mark = {0, 0, 0};
    for (const char *at = sentence; node && node->kind == QN_NODE_MAP;) {
        size_t length = strcspn(at, ".: =");
        if (length == 0 || length >= sizeof key) break;
        snprintf(key, sizeof key, "%.*s", (int)length, at);
        char *bracket = strchr(key, '[');
        int number = bracket ? atoi(bracket + 1) : 0;
        if (bracket) *bracket = 0;
        node = qn_node_child(node, key);
        if (number > 0 && node && node->kind == QN_NODE_LIST)
            for (node = node->first; node && number > 1; number--) node = node->next;
        if (node) mark = node->kind == QN_NODE_SCALAR ? node->mark : node->key_mark;
        if (at[length] != '.') break;
        at += length + 1;
    }
    return mark;
}

void qn_scene_blame(const char *path, const char *text, const char *sentence, qn_messages *messages)
{
    qn_source source = {path, text, strlen(text)};
    qn_messages ignored = {0};
    qn_tree tree = {0};
    qn_mark mark = {0, 0, 0};
    if (qn_tree_read(&source, &ignored, &tree) == QN_OK) mark = place_of(tree.root, sentence);
    qn_tree_free(&tree);
    qn_messages_free(&ignored);
    qn_message(messages, &source, QN_ERROR, mark, "%s", sentence);
}
