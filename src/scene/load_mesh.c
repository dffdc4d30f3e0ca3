// SPDX-License-Identifier: Apache-2.0
// Triangle meshes: the plain text format, and the choice of who reads the others.
//
// Source of the format: the reference document, section 5.2.1, Figs 5.11 and 5.12. Its own example
//         winds triangles both ways and numbers vertices from 1.
#include "base/array.h"
#include "scene/load_datafile.h"

#include <limits.h>
#include <stdlib.h>

enum { SHORTEST = 6 };  // bytes   of a line with three numbers: "0 0 0" and its end

struct mesh {
    int64_t vertex_count, triangle_count;
    double *vertices;
    int *triangles;
};

static qn_status read_counts(qn_datafile *file, struct mesh *mesh)
{
    qn_line line;
    int64_t counts[2];
    if (!qn_datafile_line(file, &line))
        return qn_fail(QN_INPUT,
                       "%s: holds only comments; the first line of a mesh gives the "
                       "numbers of vertices and triangles",
                       file->path);
    QN_TRY(qn_line_integers(file, line, 2, "the numbers of vertices and of triangles", 1,
                            INT_MAX / 3, counts));
    int64_t room = (int64_t)file->size / SHORTEST;
    if (counts[0] + counts[1] > room)
        return qn_fail(QN_INPUT,
                       "%s:%lld: announces %lld vertices and %lld triangles, but the file has "
                       "only %zu bytes, at most %lld lines of three numbers",
                       file->path, (long long)file->line, (long long)counts[0],
                       (long long)counts[1], file->size, (long long)room);
    mesh->vertex_count = counts[0];
    mesh->triangle_count = counts[1];
    return QN_OK;
}

static qn_status ends_early(const qn_datafile *file, const char *what, int64_t got, int64_t wanted)
{
    return qn_fail(QN_INPUT, "%s:%lld: the file ends after %lld of %lld %s", file->path,
                   (long long)file->line, (long long)got, (long long)wanted, what);
}

static qn_status read_vertices(qn_datafile *file, double unit, struct mesh *mesh)
{
    qn_line line;
    for (int64_t i = 0; i < mesh->vertex_count; i++) {
        double *vertex = mesh->vertices + 3 * i;
        if (!qn_datafile_line(file, &line))
            return ends_early(file, "vertices", i, mesh->vertex_count);
        QN_TRY(qn_line_numbers(file, line, 3, "x, y and z of a vertex", vertex));
        for (int axis = 0; axis < 3; axis++)
            QN_TRY(qn_datafile_length(file, vertex[axis], unit, &vertex[axis]));
    }
    return QN_OK;
}

static qn_status read_triangles(qn_datafile *file, struct mesh *mesh)
{
    qn_line line;
    for (int64_t i = 0; i < mesh->triangle_count; i++) {
        int64_t corners[3];
        if (!qn_datafile_line(file, &line))
            return ends_early(file, "triangles", i, mesh->triangle_count);
        QN_TRY(qn_line_integers(file, line, 3, "the vertices of a triangle, counted from 1", 1,
                                mesh->vertex_count, corners));
        for (int k = 0; k < 3; k++) mesh->triangles[3 * i + k] = (int)(corners[k] - 1);
    }
    if (qn_datafile_line(file, &line))
        return qn_fail(QN_INPUT,
                       "%s:%lld: more lines than the %lld vertices and %lld triangles "
                       "announced",
                       file->path, (long long)file->line, (long long)mesh->vertex_count,
                       (long long)mesh->triangle_count);
    return QN_OK;
}

static qn_status read_mesh(qn_datafile *file, double unit, struct mesh *mesh)
{
    QN_TRY(read_counts(file, mesh));
    QN_TRY(QN_ALLOCATE(mesh->vertices, 3 * mesh->vertex_count));
    QN_TRY(QN_ALLOCATE(mesh->triangles, 3 * mesh->triangle_count));
    QN_TRY(read_vertices(file, unit, mesh));
    return read_triangles(file, mesh);
}

static qn_status load_text(const char *path, double unit, double **vertices, int *vertex_count,
                           int **triangles, int *triangle_count)
{
    qn_datafile file;
    QN_TRY(qn_datafile_read_text(path, &file));
    struct mesh mesh = {0};
    qn_status status = read_mesh(&file, unit, &mesh);
    qn_datafile_free(&file);
    if (status != QN_OK) {
        free(mesh.vertices);
        free(mesh.triangles);
        return status;
    }
    *vertices = mesh.vertices;
    *triangles = mesh.triangles;
    *vertex_count = (int)mesh.vertex_count;
    *triangle_count = (int)mesh.triangle_count;
    return QN_OK;
}

qn_status qn_load_mesh(const char *path, double unit, double **vertices, int *vertex_count,
                       int **triangles, int *triangle_count)
{
    bool library = qn_path_has_extension(path, ".stl .obj .ply");
    return (library ? qn_load_mesh_library : load_text)(path, unit, vertices, vertex_count,
                                                        triangles, triangle_count);
}
