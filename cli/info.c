// SPDX-License-Identifier: Apache-2.0
// `quern info`: what is in a run folder, a checkpoint, a frame, fields.h5, series.h5 or a mesh file.
//
// Files are told apart by what they hold, not by their names; what is no HDF5 file is tried as a mesh.
#include "cli/cli.h"

#include "record/checkpoint.h"
#include "record/table.h"
#include "scene/load.h"
#include "world/mesh.h"

#include <dirent.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void print_size(const char *name, int64_t bytes)
{
    if (bytes < 1000000)
        printf("  %-28s %9.1f kB\n", name, (double)bytes / 1e3);
    else
        printf("  %-28s %9.1f MB\n", name, (double)bytes / 1e6);
}

// ---- HDF5 files ----------------------------------------------------------------------------------

static void print_text(hid_t object, const char *name)
{
    char text[512];
    if (qn_h5_get_text(object, name, text, sizeof text) == QN_OK)
        printf("  %-12s %s\n", name, text);
}

static void print_integer(hid_t object, const char *name)
{
    int64_t value;
    if (qn_h5_get_integer(object, name, &value) == QN_OK)
        printf("  %-12s %" PRId64 "\n", name, value);
}

static void print_number(hid_t object, const char *name, const char *unit)
{
    double value;
    if (qn_h5_get_number(object, name, &value) == QN_OK)
        printf("  %-12s %.6g%s\n", name, value, unit);
}

/// One dataset or group: where it is, how large, what it means.
static herr_t print_item(hid_t file, const char *name, const H5O_info_t *about, void *user)
{
    char unit[64] = "", meaning[256] = "", shape[64] = "";
    hsize_t extent[H5S_MAX_RANK] = {0};
    (void)user;
    if (about->type != H5O_TYPE_DATASET) return 0;
    hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    if (set < 0) return 0;
    hid_t space = H5Dget_space(set);
    int rank = H5Sget_simple_extent_dims(space, extent, NULL);
    for (int i = 0, n = 0; i < rank && n < (int)sizeof shape - 24; i++)
        n += snprintf(shape + n, sizeof shape - (size_t)n, i ? " x %" PRIu64 : "%" PRIu64,
                      (uint64_t)extent[i]);
    if (qn_h5_get_text(set, "unit", unit, sizeof unit) != QN_OK) *unit = 0;
    if (qn_h5_get_text(set, "meaning", meaning, sizeof meaning) != QN_OK) *meaning = 0;
    printf("  %-34s %-14s %-6s %s\n", name, shape, unit, meaning);
    H5Sclose(space);
    H5Dclose(set);
    return 0;
}

static void print_grid(hid_t file, int number)
{
    char name[32];
    hid_t grid;
    double cell, first, last;
    int64_t samples;
    snprintf(name, sizeof name, "grid_%d", number);
    if (qn_h5_group_open(file, name, &grid) != QN_OK) return;
    if (qn_h5_get_number(grid, "cell_m", &cell) == QN_OK
        && qn_h5_get_integer(grid, "samples", &samples) == QN_OK
        && qn_h5_get_number(grid, "first_time_s", &first) == QN_OK
        && qn_h5_get_number(grid, "last_time_s", &last) == QN_OK)
        printf("  %-12s voxels of %.4g mm, %" PRId64 " samples from %.6g to %.6g s\n", name,
               1e3 * cell, samples, first, last);
    H5Gclose(grid);
}

static qn_status print_h5(const char *path)
{
    hid_t file;
    QN_TRY(qn_h5_open(path, &file));
    printf("%s\n", path);
    print_text(file, "format");
    print_text(file, "version");
    print_text(file, "title");
    print_integer(file, "step");
    print_number(file, "time", " s");
    print_number(file, "time_s", " s");
    print_number(file, "dt", " s");
    for (int i = 0; i < 8; i++) print_grid(file, i);
    printf("\n  %-34s %-14s %-6s %s\n", "dataset", "rows", "unit", "meaning");
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, print_item, NULL, H5O_INFO_BASIC);
    qn_h5_close(file);
    return QN_OK;
}

// ---- Run folders ---------------------------------------------------------------------------------

static int visible(const struct dirent *e)
{
    return e->d_name[0] != '.';
}

/// Name and size of the files in a folder, or only their number and size together.
static void print_files(const char *folder, const char *inner, bool each)
{
    char path[QN_FILE_NAME_MAX], file[QN_FILE_NAME_MAX];
    struct dirent **entries;
    int64_t total = 0, files = 0;
    qn_path_join(path, folder, inner);
    int n = scandir(path, &entries, visible, alphasort);
    for (int i = 0; i < n; i++) {
        struct stat about;
        qn_path_join(file, path, entries[i]->d_name);
        if (stat(file, &about) == 0 && S_ISREG(about.st_mode)) {
            if (each) print_size(entries[i]->d_name, about.st_size);
            total += about.st_size, files++;
        }
        free(entries[i]);
    }
    if (n < 0) return;
    free(entries);
    char name[64];
    snprintf(name, sizeof name, "%s: %" PRId64 " files", inner, files);
    if (!each && files > 0) print_size(name, total);
}

/// The key and the value in a line of summary.json; false where it has none.
static bool split_line(const char *line, char key[64], char value[256])
{
    if (sscanf(line, " \"%63[^\"]\": %255[^\n]", key, value) != 2) return false;
    size_t end = strlen(value);
    if (value[end - 1] == ',') value[end - 1] = 0;
    return true;
}

/// Whether the first thing in an object, of which `text` is the rest, has no value: then none has.
static bool begins_with_null(const char *text)
{
    char key[64], value[256];
    return text && split_line(text, key, value) && !strcmp(value, "null");
}

/// The parts of the walls, a row each; `next` is behind the line that begins them, and then behind the
/// one that ends them.
static void print_parts(char **next)
{
    double power = 0, force[3] = {0};
    char part[64] = "", key[64], value[256];
    printf("  %-28s %10s %31s\n", "walls", "power (W)", "mean force x, y, z (N)");
    for (char *line; (line = strsep(next, "\n")) && strncmp(line, "  }", 3);) {
        if (!strncmp(line, "    }", 5))
            printf("    %-26s %10.4g %10.4g %9.4g %9.4g\n", part, power, force[0], force[1],
                   force[2]);
        if (!split_line(line, key, value)) continue;
        if (value[0] == '{') snprintf(part, sizeof part, "%s", key);
        if (!strcmp(key, "mean_power_w")) power = strtod(value, NULL);
        for (int c = 0; c < 3; c++)
            if (!strncmp(key, "mean_force_", 11) && key[11] == "xyz"[c])
                force[c] = strtod(value, NULL);
    }
}

/// summary.json as a list of names and values, what is inside of something under its name.
static void print_summary(const char *folder)
{
    char path[QN_FILE_NAME_MAX], *text, *next, key[64], value[256];
    int64_t length;
    if (!qn_file_exists(qn_path_join(path, folder, "summary.json"))) return;
    if (qn_file_read(path, &text, &length) != QN_OK) return;
    printf("\nsummary\n");
    next = text;
    for (char *line; (line = strsep(&next, "\n"));) {
        if (!split_line(line, key, value) || !strcmp(value, "null")) continue;
        int inside = (int)strspn(line, " ");
        bool opens = value[0] == '{' || value[0] == '[';
        if (!opens)
            printf("%*s%-*s %s\n", inside, "", 30 - inside, key, value);
        else if (inside == 2 && !strcmp(key, "walls") && value[1] != '}')
            print_parts(&next);
        else if (!value[1] && !begins_with_null(next))
            printf("%*s%s\n", inside, "", key);
    }
    free(text);
}

static qn_status print_folder(const char *folder)
{
    char path[QN_FILE_NAME_MAX];
    int64_t *steps;
    int count;
    if (!qn_file_exists(qn_path_join(path, folder, "log.txt")))
        return qn_fail(QN_INPUT, "%s is not the folder of a run: it has no log.txt", folder);
    QN_TRY(qn_checkpoint_list(qn_path_join(path, folder, "checkpoints"), &steps, &count));
    printf("%s\n", folder);
    for (int i = 0; i < count; i++)
        printf("  checkpoint at step %" PRId64 "%s\n", steps[i],
               i == 0 ? ", the newest: --resume goes on from here" : "");
    if (count == 0) printf("  no checkpoint: --resume starts from the beginning\n");
    free(steps);
    printf("\nfiles\n");
    print_files(folder, ".", true);
    print_files(folder, "frames", false);
    print_files(folder, "checkpoints", false);
    print_files(folder, "pictures", false);
    print_summary(folder);
    return QN_OK;
}

// ---- Meshes --------------------------------------------------------------------------------------

/// What is odd about a mesh, as a run would find it.
static qn_status print_flaws(double *vertices, int vertex_count, int *triangles, int triangle_count)
{
    qn_mesh_def def = {.name = "mesh",
                       .vertex_count = vertex_count,
                       .triangle_count = triangle_count,
                       .vertices = vertices,
                       .triangles = triangles};
    qn_mesh mesh;
    double size = 0;
    char text[512];
    for (int i = 0; i < 3 * vertex_count; i++) size = fmax(size, fabs(vertices[i]));
    QN_TRY(qn_mesh_build(&def, size > 0 ? size : 1, &mesh));
    bool odd = false;
    for (int k = 0; k < QN_MESH_FLAW_COUNT; k++) {
        qn_mesh_flaw_text(&mesh, k, 1, "", text, sizeof text);
        if (*text) printf("  %s\n", strchr(text, ':') + 2);
        odd = odd || *text;
    }
    if (!odd) printf("  closed, every edge between two triangles, nothing to mend\n");
    qn_mesh_free(&mesh);
    return QN_OK;
}

static qn_status print_mesh(const char *path)
{
    double *vertices, low[3], high[3], area = 0;
    int *triangles, vertex_count, triangle_count;
    QN_TRY(qn_load_mesh(path, 1, &vertices, &vertex_count, &triangles, &triangle_count));
    for (int c = 0; c < 3; c++) low[c] = (double)INFINITY, high[c] = -(double)INFINITY;
    for (int i = 0; i < 3 * vertex_count; i++) {
        low[i % 3] = fmin(low[i % 3], vertices[i]);
        high[i % 3] = fmax(high[i % 3], vertices[i]);
    }
    for (int t = 0; t < triangle_count; t++) {
        const double *a = vertices + 3 * triangles[3 * t], *b = vertices + 3 * triangles[3 * t + 1],
                     *c = vertices + 3 * triangles[3 * t + 2];
        qn_vec3 u = qn_v3(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        qn_vec3 v = qn_v3(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
        area += 0.5 * qn_norm(qn_cross(u, v));
    }
    printf("%s\n  a mesh, in units of the file\n  vertices     %d\n  triangles    %d\n", path,
           vertex_count, triangle_count);
    printf("  area         %.6g\n", area);
    for (int c = 0; c < 3; c++) printf("  %c            %.6g to %.6g\n", "xyz"[c], low[c], high[c]);
    qn_status status = print_flaws(vertices, vertex_count, triangles, triangle_count);
    free(vertices);
    free(triangles);
    return status;
}

static qn_status print_info(const char *path)
{
    struct stat about;
    if (stat(path, &about) != 0) return qn_fail(QN_IO, "there is no file or folder %s", path);
    if (S_ISDIR(about.st_mode)) return print_folder(path);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    const char *ending = strrchr(path, '.');
    if (ending && strstr(".yaml.yml.json.csv.log.png", ending))
        return qn_fail(
            QN_INPUT, "%s is plain text or a picture: read it as it is ('quern check' for a scene)",
            path);
    return H5Fis_hdf5(path) > 0 ? print_h5(path) : print_mesh(path);
}

int cli_info(int argc, char **argv)
{
    if (argc != 2) {
        if (argc > 2)
            fprintf(stderr, "quern info: '%s' is one word too many: give one folder or file\n",
                    argv[2]);
        else
            fprintf(stderr, "quern info: of what? Give one folder or file\n");
        cli_usage("info", true);
        return qn_status_exit(QN_INPUT);
    }
    qn_status status = print_info(argv[1]);
    if (status != QN_OK) fprintf(stderr, "quern info: %s\n", qn_error());
    return qn_status_exit(status);
}
