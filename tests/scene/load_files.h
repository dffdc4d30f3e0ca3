// SPDX-License-Identifier: Apache-2.0
// Files for the tests of the loaders: good ones of every format, and ways to damage them.
//
// All lie in one folder made by begin_files() and removed, with what is in it, by end_files().
#ifndef QN_TESTS_SCENE_LOAD_FILES_H
#define QN_TESTS_SCENE_LOAD_FILES_H

#include "scene/load.h"

#include <dirent.h>
#include <hdf5.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[512];

static const char *path_of(const char *name)
{
    static char path[2][1024];
    static int turn;
    turn = !turn;
    snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
    return path[turn];
}

static void must(int ok, const char *what)
{
    if (ok) return;
    perror(what);
    exit(2);
}

static void begin_files(void)
{
    const char *base = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/quern-load-XXXXXX", base ? base : "/tmp");
    must(mkdtemp(folder) != NULL, folder);
    H5dont_atexit();  // damaged files leave it with things it cannot close, and it would say so
}

static void end_files(void)
{
    DIR *all = opendir(folder);
    must(all != NULL, folder);
    for (struct dirent *e; (e = readdir(all));)
        if (e->d_name[0] != '.') unlink(path_of(e->d_name));
    closedir(all);
    rmdir(folder);
}

static void write_bytes(const char *name, const void *bytes, size_t size)
{
    FILE *out = fopen(path_of(name), "wb");
    must(out && fwrite(bytes, 1, size, out) == size && fclose(out) == 0, name);
}

static void write_text(const char *name, const char *text)
{
    write_bytes(name, text, strlen(text));
}

/// 2 GB and one byte of nothing, taking no room on the disk.
static void write_huge(const char *name)
{
    write_text(name, "x");
    must(truncate(path_of(name), 2000000001) == 0, name);
}

static void write_pipe(const char *name)
{
    must(mkfifo(path_of(name), 0600) == 0, name);
}

static void cut(const char *name, long size)
{
    must(truncate(path_of(name), size) == 0, name);
}

/// A copy with up to four bytes changed or, every fourth time, its end cut off; returns its name.
static const char *damage(const char *name, uint64_t seed)
{
    static char damaged[64];
    static char bytes[1 << 16];
    snprintf(damaged, sizeof damaged, "damaged%s", strrchr(name, '.'));
    FILE *in = fopen(path_of(name), "rb");
    must(in != NULL, name);
    size_t size = fread(bytes, 1, sizeof bytes, in);
    fclose(in);
    uint64_t random = seed * 0x9e3779b97f4a7c15u + 1;
    for (uint64_t i = 0; i <= seed % 4; i++) {
        random = (random ^ random >> 29) * 0xbf58476d1ce4e5b9u;
        random ^= random >> 32;
        size_t at = (size_t)(random % size);
        static const char nasty[] = {0, -1, '9', '-', '\n', 127, 'e', ' '};
        bytes[at] = random >> 60 < 8 ? nasty[random >> 60] : (char)(random >> 40);
        if (seed % 4 == 3 && i == 3 && at > 0) size = at;
    }
    write_bytes(damaged, bytes, size);
    return damaged;
}

/// The box of Fig 5.12 of the reference document, in vertices from 1; its pairs of triangles make
/// its six faces.
static const char box_text[] =
    "8 12\n-1 -1 -1\n-1 -1 1\n-1 1 -1\n-1 1 1\n1 -1 -1\n1 -1 1\n1 1 -1\n1 1 1\n1 2 3\n2 3 4\n"
    "1 2 5\n2 5 6\n1 3 5\n3 5 7\n5 6 7\n6 7 8\n3 4 7\n4 7 8\n2 4 6\n4 6 8\n";
static const int box_triangles[12][3] = {{1, 2, 3}, {2, 3, 4}, {1, 2, 5}, {2, 5, 6},
                                         {1, 3, 5}, {3, 5, 7}, {5, 6, 7}, {6, 7, 8},
                                         {3, 4, 7}, {4, 7, 8}, {2, 4, 6}, {4, 6, 8}};
static const int box_quads[6][4] = {{1, 2, 4, 3}, {1, 2, 6, 5}, {1, 3, 7, 5},
                                    {5, 6, 8, 7}, {3, 4, 8, 7}, {2, 4, 8, 6}};

static int box_coordinate(int vertex, int axis)
{
    return (vertex - 1) >> (2 - axis) & 1 ? 1 : -1;
}

static void put_triangle_text(FILE *out, const int *corners, int t)
{
    fprintf(out, "facet normal 0 %d 1\nouter loop\n", t);
    for (int k = 0; k < 3; k++)
        fprintf(out, "vertex %d %d %d\n", box_coordinate(corners[k], 0),
                box_coordinate(corners[k], 1), box_coordinate(corners[k], 2));
    fprintf(out, "endloop\nendfacet\n");
}

static void put_text_stl(FILE *out)
{
    fprintf(out, "solid box\n");
    for (int t = 0; t < 12; t++) put_triangle_text(out, box_triangles[t], t);
    fprintf(out, "endsolid box\n");
}

static void put_binary_stl(FILE *out, const char *head)
{
    char header[80] = {0};
    uint32_t count = 12;
    uint16_t attribute = 0;
    memcpy(header, head, strlen(head));
    fwrite(header, 1, sizeof header, out);
    fwrite(&count, sizeof count, 1, out);
    for (int t = 0; t < 12; t++) {
        float facet[12] = {0, (float)t, 1};
        for (int k = 0; k < 9; k++)
            facet[3 + k] = (float)box_coordinate(box_triangles[t][k / 3], k % 3);
        fwrite(facet, sizeof facet, 1, out);
        fwrite(&attribute, sizeof attribute, 1, out);
    }
}

static void put_stl(FILE *out)
{
    put_binary_stl(out, "made by a test");
}

static void put_solid_stl(FILE *out)
{
    put_binary_stl(out, "solid in spite of being binary");
}

static void put_obj(FILE *out)
{
    fprintf(out, "# a box of quads\no box\n");
    for (int v = 1; v <= 8; v++)
        fprintf(out, "v %d %d %d\n", box_coordinate(v, 0), box_coordinate(v, 1),
                box_coordinate(v, 2));
    for (int q = 0; q < 6; q++)
        fprintf(out, "f %d %d %d %d\n", box_quads[q][0], box_quads[q][1], box_quads[q][2],
                box_quads[q][3]);
}

static void put_ply_header(FILE *out, const char *format)
{
    fprintf(out,
            "ply\nformat %s 1.0\ncomment a box\nelement vertex 8\nproperty float x\nproperty "
            "float y\nproperty float z\nelement face 12\nproperty list uchar int "
            "vertex_indices\nend_header\n",
            format);
}

static void put_text_ply(FILE *out)
{
    put_ply_header(out, "ascii");
    for (int v = 1; v <= 8; v++)
        fprintf(out, "%d %d %d\n", box_coordinate(v, 0), box_coordinate(v, 1),
                box_coordinate(v, 2));
    for (int t = 0; t < 12; t++)
        fprintf(out, "3 %d %d %d\n", box_triangles[t][0] - 1, box_triangles[t][1] - 1,
                box_triangles[t][2] - 1);
}

static void put_ply(FILE *out)
{
    put_ply_header(out, "binary_little_endian");
    for (int i = 0; i < 24; i++) {
        float x = (float)box_coordinate(i / 3 + 1, i % 3);
        fwrite(&x, sizeof x, 1, out);
    }
    for (int t = 0; t < 12; t++) {
        fputc(3, out);
        for (int k = 0; k < 3; k++) {
            int32_t index = box_triangles[t][k] - 1;
            fwrite(&index, sizeof index, 1, out);
        }
    }
}

static void put_text(FILE *out)
{
    fputs(box_text, out);
}

static const struct {
    const char *name;
    void (*put)(FILE *out);
} cubes[] = {
    {"box.msh", put_text},        {"text.stl", put_text_stl}, {"binary.STL", put_stl},
    {"solid.stl", put_solid_stl}, {"quads.obj", put_obj},     {"text.ply", put_text_ply},
    {"binary.ply", put_ply},
};

enum { cube_count = sizeof cubes / sizeof cubes[0] };

static void write_cube(int i)
{
    FILE *out = fopen(path_of(cubes[i].name), "wb");
    must(out != NULL, cubes[i].name);
    cubes[i].put(out);
    must(fclose(out) == 0, cubes[i].name);
}

/// rows x width doubles first, first + 1, ... (or `same` in all) as a dataset of `type`.
static void put_rows(hid_t file, const char *name, hid_t type, int rows, int width, double first,
                     int step)
{
    double *numbers = malloc((size_t)(rows * width) * sizeof *numbers);
    must(numbers != NULL, name);
    for (int i = 0; i < rows * width; i++) numbers[i] = first + step * i;
    hsize_t size[2] = {(hsize_t)rows, (hsize_t)width};
    hid_t space = H5Screate_simple(width == 1 ? 1 : 2, size, NULL);
    hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    hid_t data = H5Dcreate2(file, name, type, space, links, H5P_DEFAULT, H5P_DEFAULT);
    must(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0, name);
    H5Dclose(data);
    H5Pclose(links);
    H5Sclose(space);
    free(numbers);
}

static hid_t begin_hdf(const char *name)
{
    return H5Fcreate(path_of(name), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
}

/// A frame of n spheres, or a file that is none for n < 0.
static void write_frame(const char *name, int n)
{
    hid_t file = begin_hdf(name);
    if (n > 0) {
        put_rows(file, "/VTKHDF/Points", H5T_IEEE_F32LE, n, 3, 0, 1);
        put_rows(file, "/VTKHDF/PointData/velocity", H5T_IEEE_F32LE, n, 3, 100, 1);
        put_rows(file, "/VTKHDF/PointData/spin", H5T_IEEE_F32LE, n, 3, 200, 1);
        put_rows(file, "/VTKHDF/PointData/radius", H5T_IEEE_F32LE, n, 1, 1.5, 0);
    } else {
        put_rows(file, "/other", H5T_IEEE_F32LE, 1, 1, 0, 0);
    }
    H5Fclose(file);
}

/// A file of a few kB whose points would take many GB: a chunk that was never written.
static void write_lying_frame(const char *name)
{
    hid_t file = begin_hdf(name);
    put_rows(file, "/VTKHDF/PointData/radius", H5T_IEEE_F32LE, 1, 1, 1.5, 0);
    hsize_t size[2] = {400000000, 3}, chunk[2] = {1000, 3};
    hid_t space = H5Screate_simple(2, size, NULL);
    hid_t how = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(how, 2, chunk);
    H5Dclose(
        H5Dcreate2(file, "/VTKHDF/Points", H5T_IEEE_F32LE, space, H5P_DEFAULT, how, H5P_DEFAULT));
    H5Pclose(how);
    H5Sclose(space);
    H5Fclose(file);
}

/// A checkpoint of n particles in two classes of radius 0.5 and 1.5; the last one is of class `last`.
static void write_checkpoint(const char *name, int n, int last)
{
    hid_t file = begin_hdf(name);
    put_rows(file, "/particles/position", H5T_IEEE_F64LE, n, 3, 0, 1);
    put_rows(file, "/particles/velocity", H5T_IEEE_F64LE, n, 3, 100, 1);
    put_rows(file, "/particles/spin", H5T_IEEE_F64LE, n, 3, 200, 1);
    put_rows(file, "/particles/kick", H5T_IEEE_F64LE, n, 3, 300, 1);
    put_rows(file, "/particles/spin_kick", H5T_IEEE_F64LE, n, 3, 400, 1);
    put_rows(file, "/classes/radius", H5T_IEEE_F64LE, 2, 1, 0.5, 1);
    put_rows(file, "/particles/klass", H5T_STD_I32LE, n, 1, 0, 0);
    hid_t data = H5Dopen2(file, "/particles/klass", H5P_DEFAULT);
    int32_t klass[16] = {0};
    klass[n - 1] = last;
    H5Dwrite(data, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, klass);
    H5Dclose(data);
    H5Fclose(file);
}

#endif
