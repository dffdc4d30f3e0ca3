// SPDX-License-Identifier: Apache-2.0
// Triangle meshes in STL, OBJ and PLY, read by assimp.
//
// The extension decides the format and the first bytes must agree with it, so that none of the
// library's fifty other readers is ever tried. Counts a file announces are checked against its size
// before the library sees it, and it works on our copy in memory, from which references to other
// files have been struck out. What it hands back is checked before it works on it further: polygons
// become triangles, points and lines are left out, and vertices that are equal in every bit become
// one, for which normals and colours have to go first (facets of an STL file each have their own).
#include "base/array.h"
#include "scene/load_datafile.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { STL_HEADER = 84, STL_FACET = 50 };  // bytes   of a binary STL file

static bool is_text(const qn_datafile *file)
{
    for (size_t i = 0; i < file->size; i++) {
        unsigned char c = (unsigned char)file->data[i];
        if ((c < ' ' && !strchr("\t\n\v\f\r", c)) || c == '\0') return false;
    }
    return true;
}

static qn_status check_stl(qn_datafile *file)
{
    bool solid = strncmp(file->data, "solid", 5) == 0;
    if (solid && is_text(file)) {
        if (strstr(file->data, "endsolid")) return QN_OK;
        return qn_fail(QN_INPUT, "%s: a text STL file without 'endsolid': it is cut short",
                       file->path);
    }
    if (file->size < STL_HEADER)
        return qn_fail(QN_INPUT,
                       "%s: %zu bytes; neither a text STL file, which begins with 'solid', nor a "
                       "binary one, which has at least %d bytes",
                       file->path, file->size, STL_HEADER);
    const unsigned char *n = (const unsigned char *)file->data + STL_HEADER - 4;
    uint32_t facets =
        (uint32_t)n[0] | (uint32_t)n[1] << 8 | (uint32_t)n[2] << 16 | (uint32_t)n[3] << 24;
    uint64_t needed = STL_HEADER + (uint64_t)STL_FACET * facets;
    if (needed == file->size) return QN_OK;
    return qn_fail(QN_INPUT,
                   "%s: as a binary STL file it announces %u triangles, which take %llu bytes; it "
                   "has %zu: it is cut short, or not an STL file",
                   file->path, facets, (unsigned long long)needed, file->size);
}

static bool word_is(qn_line word, const char *text)
{
    size_t length = (size_t)(word.end - word.begin);
    return strlen(text) == length && memcmp(word.begin, text, length) == 0;
}

static qn_status check_obj(qn_datafile *file)
{
    qn_line line, word;
    bool has_vertex = false, has_face = false;
    if (!is_text(file))
        return qn_fail(QN_INPUT, "%s: holds bytes that are not text; an OBJ file is text",
                       file->path);
    while (qn_datafile_line(file, &line)) {
        char *begin = file->data + (line.begin - file->data);
        if (!qn_line_word(&line, &word)) continue;
        has_vertex |= word_is(word, "v");
        has_face |= word_is(word, "f");
        if (word_is(word, "mtllib")) begin[0] = begin[word.begin - begin] = '#';
    }
    if (!has_vertex || !has_face)
        return qn_fail(QN_INPUT,
                       "%s: an OBJ file needs lines that begin with v (vertices) and "
                       "f (faces)",
                       file->path);
    return QN_OK;
}

/// The header of a PLY file: every element it announces takes at least one byte.
static qn_status check_ply(qn_datafile *file)
{
    qn_line line, word;
    if (!qn_datafile_line(file, &line) || !qn_line_word(&line, &word) || !word_is(word, "ply"))
        return qn_fail(QN_INPUT, "%s: a PLY file begins with a line 'ply'", file->path);
    while (qn_datafile_line(file, &line)) {
        if (!qn_line_word(&line, &word)) continue;
        if (word_is(word, "end_header")) return QN_OK;
        if (!word_is(word, "element")) continue;
        int64_t count;
        if (!qn_line_word(&line, &word))
            return qn_fail(QN_INPUT, "%s:%lld: an element without a name", file->path,
                           (long long)file->line);
        QN_TRY(qn_line_integers(file, line, 1, "the number of elements, no more than bytes", 0,
                                (int64_t)file->size, &count));
    }
    return qn_fail(QN_INPUT, "%s: a PLY file without 'end_header': it is cut short", file->path);
}

// clang-format off
static const struct {
    const char *extension, *hint;
    qn_status (*check)(qn_datafile *file);
} formats[] = {
    {".stl", "stl", check_stl},
    {".obj", "obj", check_obj},
    {".ply", "ply", check_ply},
};
// clang-format on

static bool vertex_is_near(const struct aiVector3D *at, double unit)
{
    double metres;
    return qn_length_from((double)at->x, unit, &metres)
           && qn_length_from((double)at->y, unit, &metres)
           && qn_length_from((double)at->z, unit, &metres);
}

static qn_status check_face(const qn_datafile *file, const struct aiMesh *part, unsigned f)
{
    const struct aiFace *face = &part->mFaces[f];
    if (face->mNumIndices == 0)
        return qn_fail(QN_INPUT, "%s: face %u has no corners", file->path, f + 1);
    for (unsigned k = 0; k < face->mNumIndices; k++)
        if (face->mIndices[k] >= part->mNumVertices)
            return qn_fail(QN_INPUT, "%s: face %u names vertex %u of %u", file->path, f + 1,
                           face->mIndices[k] + 1, part->mNumVertices);
    return QN_OK;
}

/// Vertices finite and within bounds, indices within their part; also counts both.
static qn_status check_scene(const qn_datafile *file, const struct aiScene *scene, double unit,
                             int64_t *vertex_count)
{
    *vertex_count = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        const struct aiMesh *part = scene->mMeshes[m];
        for (unsigned v = 0; v < part->mNumVertices; v++)
            if (!vertex_is_near(&part->mVertices[v], unit))
                return qn_fail(QN_INPUT,
                               "%s: vertex %u of part %u is at %g %g %g; finite coordinates up to "
                               "%g m are allowed",
                               file->path, v + 1, m + 1, (double)part->mVertices[v].x,
                               (double)part->mVertices[v].y, (double)part->mVertices[v].z,
                               QN_LOAD_FARTHEST);
        for (unsigned f = 0; f < part->mNumFaces; f++) QN_TRY(check_face(file, part, f));
        *vertex_count += part->mNumVertices;
    }
    return QN_OK;
}

static int64_t count_triangles(const struct aiScene *scene)
{
    int64_t count = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; m++)
        for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; f++)
            count += scene->mMeshes[m]->mFaces[f].mNumIndices == 3;
    return count;
}

static void copy_part(const struct aiMesh *part, double unit, int first, double **vertex,
                      int **corner)
{
    for (unsigned v = 0; v < part->mNumVertices; v++) {
        *(*vertex)++ = (double)part->mVertices[v].x * unit;
        *(*vertex)++ = (double)part->mVertices[v].y * unit;
        *(*vertex)++ = (double)part->mVertices[v].z * unit;
    }
    for (unsigned f = 0; f < part->mNumFaces; f++)
        for (unsigned k = 0; k < 3 && part->mFaces[f].mNumIndices == 3; k++)
            *(*corner)++ = first + (int)part->mFaces[f].mIndices[k];
}

static qn_status copy_scene(const qn_datafile *file, const struct aiScene *scene, double unit,
                            double **vertices, int *vertex_count, int **triangles,
                            int *triangle_count)
{
    int64_t vertex_total, triangle_total = count_triangles(scene);
    QN_TRY(check_scene(file, scene, unit, &vertex_total));
    if (triangle_total == 0) return qn_fail(QN_INPUT, "%s: holds no triangle", file->path);
    if (triangle_total > INT_MAX / 3 || vertex_total > INT_MAX / 3)
        return qn_fail(QN_INPUT, "%s: %lld triangles on %lld vertices; at most %d are allowed",
                       file->path, (long long)triangle_total, (long long)vertex_total, INT_MAX / 3);
    double *vertex;
    int *corner;
    QN_TRY(QN_ALLOCATE(vertex, 3 * vertex_total));
    if (QN_ALLOCATE(corner, 3 * triangle_total) != QN_OK) {
        free(vertex);
        return QN_MEMORY;
    }
    *vertices = vertex;
    *triangles = corner;
    *vertex_count = (int)vertex_total;
    *triangle_count = (int)triangle_total;
    for (unsigned m = 0; m < scene->mNumMeshes; m++)
        copy_part(scene->mMeshes[m], unit, (int)((vertex - *vertices) / 3), &vertex, &corner);
    return QN_OK;
}

/// The scene as the file has it, unchecked; NULL with the library's own message.
static const struct aiScene *import_bare(const qn_datafile *file, const char *hint)
{
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    aiSetImportPropertyInteger(settings, AI_CONFIG_PP_RVC_FLAGS,
                               aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS
                                   | aiComponent_COLORS | aiComponent_TEXCOORDS);
    const struct aiScene *scene =
        aiImportFileFromMemoryWithProperties(file->data, (unsigned)file->size, 0, hint, settings);
    aiReleasePropertyStore(settings);
    return scene;
}

static qn_status import(const qn_datafile *file, const char *hint, double unit, double **vertices,
                        int *vertex_count, int **triangles, int *triangle_count)
{
    const unsigned tidy =
        aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices;
    const struct aiScene *scene = import_bare(file, hint);
    if (!scene)
        return qn_fail(QN_INPUT, "%s: cannot be read as .%s: %s", file->path, hint,
                       aiGetErrorString());
    int64_t unused;
    qn_status status = check_scene(file, scene, unit, &unused);
    if (status == QN_OK && !aiApplyPostProcessing(scene, tidy))  // the scene is gone already
        return qn_fail(QN_INPUT, "%s: its faces cannot be cut into triangles: %s", file->path,
                       aiGetErrorString());
    if (status == QN_OK)
        status = copy_scene(file, scene, unit, vertices, vertex_count, triangles, triangle_count);
    aiReleaseImport(scene);
    return status;
}

qn_status qn_load_mesh_library(const char *path, double unit, double **vertices, int *vertex_count,
                               int **triangles, int *triangle_count)
{
    qn_datafile file;
    QN_TRY(qn_datafile_read(path, &file));
    qn_status status = QN_INPUT;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (!qn_path_has_extension(path, formats[i].extension)) continue;
        status = formats[i].check(&file);
        if (status == QN_OK)
            status = import(&file, formats[i].hint, unit, vertices, vertex_count, triangles,
                            triangle_count);
    }
    qn_datafile_free(&file);
    return status;
}
