// SPDX-License-Identifier: Apache-2.0
// From a map in the tree to the values of a section, by its keys; nothing here knows any key by name.
#ifndef QN_SCENE_READER_H
#define QN_SCENE_READER_H

#include "scene/keys.h"
#include "world/def.h"

enum { QN_NAMES_MAX = 128 };  // most materials, contacts, walls or groups in one scene

typedef struct qn_reader {
    qn_source source;
    qn_messages *messages;
    qn_tree tree;
    qn_def *def;            // being filled
    const char *directory;  // of the scene file, with its final '/'; NULL if files must not be read
} qn_reader;

/// How a section is to be read.
typedef struct qn_section_from {
    const qn_node *node;   // its map, or NULL where the section is left out
    const char *path;      // as messages name it; "" for the whole file
    qn_mark mark;          // for what is missing
    const void *fallback;  // values of the same section for keys not written, or NULL
    bool is_partial;       // required keys may be missing
} qn_section_from;

/// Reads every value of a section into `values`, the struct of that section. What is wrong goes to the
/// messages; the values concerned are left not set.
void qn_section_read(qn_reader *r, qn_section_id id, qn_section_from from, void *values);

/// A section that is the value of a key, which may not be written.
qn_section_from qn_section_under(const qn_reader *r, const qn_value *v);

/// Reads `text` as the value of v->key. Says what is wrong with it and returns false if it can't be.
bool qn_value_read(qn_reader *r, const char *text, qn_value *v);

/// An error about a value: its path and text, then the rest of the sentence.
void qn_complain(qn_reader *r, const qn_value *v, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/// An error at a place, in a sentence of its own.
void qn_complain_at(qn_reader *r, qn_mark mark, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/// The name of a material, group or wall; false, with a message, if it can't be one.
bool qn_name_read(qn_reader *r, const qn_node *node, const char *what, char name[QN_NAME_MAX]);

/// Index of the material called `name`, or -1.
int qn_material_find(const qn_def *def, const char *name, size_t length);

/// The children of a section whose keys are names, at most QN_NAMES_MAX of them, no name twice.
int qn_names_read(qn_reader *r, const qn_value *v, const qn_node *nodes[QN_NAMES_MAX]);

#endif
