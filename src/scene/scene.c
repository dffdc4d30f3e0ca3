// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.h"

#include "scene/build.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

qn_section_from qn_section_entry(qn_reader *r, const char *parent, const qn_node *node, int index)
{
    char path[256];
    if (index >= 0)
        snprintf(path, sizeof path, "%s[%d]", parent, index + 1);
    else
        snprintf(path, sizeof path, "%s.%.60s", parent, node->key);
    size_t size = strlen(path) + 1;
    char *kept = qn_tree_allocate(&r->tree, size);
    return (qn_section_from){
        .node = node,
        .path = kept ? memcpy(kept, path, size) : parent,
        .mark = node->key_mark,
    };
}

bool qn_file_of(qn_reader *r, const qn_value *v, char path[QN_PATH_MAX])
{
    if (!r->directory) {
        qn_complain(r, v, "is a file, and files are not read here");
        return false;
    }
    const char *directory = *v->text == '/' ? "" : r->directory;
    int n = snprintf(path, QN_PATH_MAX, "%s%s", directory, v->text);
    if (n < QN_PATH_MAX) return true;
    qn_complain(r, v, "is longer than %d letters", QN_PATH_MAX - 1);
    return false;
}

static qn_status build(qn_reader *r)
{
    qn_scene_keys scene;
    qn_section_from whole = {.node = r->tree.root, .path = "", .mark = {1, 1, 1}};
    if (r->tree.root->kind != QN_NODE_MAP) {
        qn_complain_at(r, r->tree.root->mark,
                       "a scene is a map of keys, such as 'format: quern-scene/1'");
        return QN_OK;
    }
    qn_section_read(r, QN_SECTION_SCENE, whole, &scene);
    qn_def *def = r->def;
    snprintf(def->title, sizeof def->title, "%s", scene.title.text);
    def->gravity = qn_vector_of(&scene.gravity);
    def->seed = (uint64_t)scene.seed.number;
    QN_TRY(qn_build_materials(r, &scene));
    QN_TRY(qn_build_contacts(r, &scene));
    QN_TRY(qn_build_drum(r, &scene));
    QN_TRY(qn_build_walls(r, &scene));
    QN_TRY(qn_build_particles(r, &scene));
    QN_TRY(qn_build_flow(r, &scene));
    qn_build_times(r, &scene);
    qn_build_measure(r, &scene);
    qn_build_output(r, &scene);
    qn_build_check(r, &scene);
    return QN_OK;
}

qn_status qn_scene_read_text(const char *text, size_t length, const char *name,
                             const char *directory, qn_def *def, qn_messages *messages)
{
    *def = qn_def_default();
    qn_reader r = {
        .source = {name, text, length}, .messages = messages, .def = def, .directory = directory};
    qn_status status = qn_tree_read(&r.source, messages, &r.tree);
    if (status == QN_OK) status = build(&r);
    qn_tree_free(&r.tree);
    if (status == QN_OK && messages->errors > 0)
        status = qn_fail(QN_INPUT, "%s: %d error%s", name, messages->errors,
                         messages->errors > 1 ? "s" : "");
    if (status != QN_OK) qn_def_free(def);
    return status;
}

/// A sentence about the file as a whole, in the messages and as the error.
static qn_status refuse(const char *path, qn_status status, qn_messages *messages,
                        const char *sentence)
{
    qn_source source = {.name = path, .text = ""};
    qn_message(messages, &source, QN_ERROR, (qn_mark){0}, "%s", sentence);
    return qn_fail(status, "%s: %s", path, sentence);
}

static qn_status read_stream(FILE *file, const char *path, char **text, size_t *length,
                             qn_messages *messages)
{
    struct stat info;
    if (fstat(fileno(file), &info) != 0) return refuse(path, QN_IO, messages, strerror(errno));
    if (S_ISDIR(info.st_mode)) return refuse(path, QN_INPUT, messages, "is a folder, not a scene");
    *text = malloc(QN_TEXT_MAX + 1);
    if (!*text) return refuse(path, QN_MEMORY, messages, "there is no memory to read it");
    *length = fread(*text, 1, QN_TEXT_MAX + 1, file);
    if (ferror(file)) return refuse(path, QN_IO, messages, "cannot be read");
    if (*length > QN_TEXT_MAX)
        return refuse(path, QN_INPUT, messages, "is larger than 1 MB, which no scene needs");
    return QN_OK;
}

qn_status qn_scene_read(const char *path, qn_def *def, char **text, qn_messages *messages)
{
    *def = qn_def_default();
    char *own = NULL, directory[QN_PATH_MAX] = "";
    size_t length = 0;
    if (text) *text = NULL;
    FILE *file = fopen(path, "rb");
    if (!file) return refuse(path, QN_INPUT, messages, strerror(errno));
    qn_status status = read_stream(file, path, &own, &length, messages);
    fclose(file);
    const char *slash = strrchr(path, '/');
    int n = slash ? (int)(slash - path) + 1 : 0;
    if (status == QN_OK && n >= QN_PATH_MAX)
        status = refuse(path, QN_INPUT, messages, "has too long a name");
    else
        snprintf(directory, sizeof directory, "%.*s", n, path);
    if (status == QN_OK) status = qn_scene_read_text(own, length, path, directory, def, messages);
    if (own) own[length <= QN_TEXT_MAX ? length : 0] = 0;
    if (text)
        *text = own;
    else
        free(own);
    return status;
}
