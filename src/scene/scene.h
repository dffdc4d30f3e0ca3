// SPDX-License-Identifier: Apache-2.0
// Scenes: from the YAML a person writes to a checked world definition in SI units.
//
//     units      what may stand behind a number
//     keys       every key there is: kind, unit, range, default, meaning
//     tree       the text as maps, lists and scalars with their places
//     value      one value; reader: one section of them
//     build_*    sections into the definition; check: what only shows when all is known
//     messages   everything that is wrong, with line and caret, in one go
//     resolved   a definition as a scene again; continues: whether a run can go on with another one
//
// Read once at the start of a command. Nothing is printed or written.
#ifndef QN_SCENE_SCENE_H
#define QN_SCENE_SCENE_H

#include "scene/messages.h"
#include "world/def.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Reads a scene file and the geometry and particle files it names (relative to it).
///
/// @param def       filled on success; release with qn_def_free(). Empty otherwise.
/// @param text      NULL, or where to put the text of the file, zero-terminated and to be released with
///                  free(); NULL where it could not be read
/// @param messages  zeroed by the caller; errors and warnings as they should be printed
/// @return QN_INPUT if something is wrong with the scene, QN_IO if the file cannot be read; qn_error()
///         then holds one sentence, the messages all of them.
QN_NODISCARD qn_status qn_scene_read(const char *path, qn_def *def, char **text,
                                     qn_messages *messages);

/// As qn_scene_read for a text in memory.
///
/// @param name       for messages; the run folder is called after it
/// @param directory  of the files the scene names, with its final '/'; NULL refuses them all
QN_NODISCARD qn_status qn_scene_read_text(const char *text, size_t length, const char *name,
                                          const char *directory, qn_def *def,
                                          qn_messages *messages);

/// Adds what qn_world_create() said of a scene, a sentence that begins with the path of a key, to the
/// messages with the place of that key in the scene's text.
void qn_scene_blame(const char *path, const char *text, const char *sentence,
                    qn_messages *messages);

/// Every key of a definition with its value in SI units, defaults included, as the text of a scene;
/// *text is to be released with free(). Where a file is named (mesh, profile, list of particles) it says
/// what came from it, with a hash. Call it before qn_world_create(), which empties the definition.
QN_NODISCARD qn_status qn_scene_resolved(const qn_def *def, char **text);

/// Whether a run of one resolved scene (`before`) can go on with another (`now`): every key that its
/// motion or its checkpoints depend on has the same value.
///
/// @param changes  a line for each other key that differs, "" for none; to be released with free()
/// @return QN_INPUT otherwise, with a sentence that begins with the first such key
QN_NODISCARD qn_status qn_scene_continues(const char *before, const char *now, char **changes);

/// A hash of the keys of a resolved scene that a run can't change when it goes on.
QN_NODISCARD qn_status qn_scene_hash(const char *resolved, uint64_t *hash);

/// The reference of all keys (`part` NULL), or of those of one part (qn_scene_has_part()), for a terminal
/// or as Markdown; *text is to be released with free().
QN_NODISCARD qn_status qn_scene_reference(const char *part, bool markdown, char **text);

/// Whether a scene has a part of this name: a word on the way to its keys, as "particles", or what one
/// entry is, as "group".
bool qn_scene_has_part(const char *name);

/// What the parts of a scene are, separated by spaces.
const char *qn_scene_parts(void);

/// The commented scene of this name ("mill", "drop"), or NULL.
const char *qn_scene_template(const char *name);

/// Names of all templates, separated by spaces.
const char *qn_scene_template_names(void);

#endif
