// SPDX-License-Identifier: Apache-2.0
// Loading profiles, meshes and particles: every format there and back, every kind of bad file.
//
// Files are written into a folder of their own under $TMPDIR and removed with it. The mutation tests
// change bytes of good files and cut them short: whatever comes back, nothing may crash (they are
// meant to run under AddressSanitizer too), and an answer of QN_OK must hold together.
#include "load_files.h"
#include "unit/check.h"

/// The libraries leak when they give up on a damaged file; that is not ours to count.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libassimp\nleak:libhdf5\n";
}

/// A load that must fail with a sentence that holds `text`.
#define CHECK_FAILS(call, status, text)                                              \
    do {                                                                             \
        qn_status got = (call);                                                      \
        if (got != (status) || !strstr(qn_error(), text)) {                          \
            printf("  %s:%d: status %d: %s\n", __FILE__, __LINE__, got, qn_error()); \
            check_ok = false;                                                        \
            return;                                                                  \
        }                                                                            \
    } while (0)

static double *vertices, *xy;
static int *triangles, vertex_count, triangle_count, point_count;
static qn_particle_list list;

static qn_status load_points(const char *name, double unit)
{
    free(xy);
    xy = NULL;
    return qn_load_points(path_of(name), unit, &xy, &point_count);
}

static qn_status load_mesh(const char *name, double unit)
{
    free(vertices);
    free(triangles);
    vertices = NULL;
    triangles = NULL;
    return qn_load_mesh(path_of(name), unit, &vertices, &vertex_count, &triangles, &triangle_count);
}

/// Whether a mesh file of this name can be read at all: the library is optional.
static bool is_readable(const char *name)
{
    write_text("probe.stl", "solid");
    bool library = load_mesh("probe.stl", 1) == QN_OK || !strstr(qn_error(), "without assimp");
    return library || strstr(name, ".msh");
}

static qn_status load_particles(const char *name, double unit)
{
    qn_particle_list_free(&list);
    return qn_load_particles(path_of(name), unit, &list);
}

/// Area of a mesh and volume under it; a cube's are known whatever order its vertices come in.
static double mesh_area(void)
{
    double area = 0;
    for (int t = 0; t < triangle_count; t++) {
        double u[3], v[3];
        for (int k = 0; k < 3; k++) {
            double origin = vertices[3 * triangles[3 * t] + k];
            u[k] = vertices[3 * triangles[3 * t + 1] + k] - origin;
            v[k] = vertices[3 * triangles[3 * t + 2] + k] - origin;
        }
        double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2];
        double z = u[0] * v[1] - u[1] * v[0];
        area += sqrt(x * x + y * y + z * z) / 2;
    }
    return area;
}

static bool is_box(double side)
{
    double low = 0, high = 0;
    for (int i = 0; i < 3 * vertex_count; i++) {
        low = vertices[i] < low ? vertices[i] : low;
        high = vertices[i] > high ? vertices[i] : high;
    }
    return vertex_count == 8 && triangle_count == 12 && fabs(low + side / 2) < 1e-12
           && fabs(high - side / 2) < 1e-12 && fabs(mesh_area() - 6 * side * side) < 1e-12;
}

static void a_profile_is_read_with_its_unit_comments_and_commas(void)
{
    write_text("p.txt", "\xef\xbb\xbf# a square\r\n\n0 0\r\n2, 0 # corner\n2,1e0\n2 1\n\t0;1\n0 0");
    CHECK_STATUS(load_points("p.txt", 1e-3));
    CHECK(point_count == 4);
    const double expected[] = {0, 0, 2e-3, 0, 2e-3, 1e-3, 0, 1e-3};
    for (int i = 0; i < 8; i++) CHECK_NEAR(xy[i], expected[i], 1e-18);
}

static void a_bad_profile_is_refused_by_line(void)
{
    write_text("p.txt", "0 0\n1 0\n1 zero\n");
    CHECK_FAILS(load_points("p.txt", 1), QN_INPUT, "p.txt:3: 'zero' is not a finite number");
    write_text("p.txt", "0 0\n1 0\n1 1 1\n");
    CHECK_FAILS(load_points("p.txt", 1), QN_INPUT, "p.txt:3: more than 2 numbers");
    write_text("p.txt", "0 0\n1 0\n\n1\n");
    CHECK_FAILS(load_points("p.txt", 1), QN_INPUT, "p.txt:4: only 1 number");
    write_text("p.txt", "0 0\n1 0\n1 0\n0 0\n");
    CHECK_FAILS(load_points("p.txt", 1), QN_INPUT, "2 different points");
    for (int i = 0; i < 6; i++) {
        static const char *const bad[] = {"nan", "inf", "1e400", "0x10", "2oo", "1e9"};
        char text[64];
        snprintf(text, sizeof text, "0 0\n1 0\n1 %s\n", bad[i]);
        write_text("p.txt", text);
        CHECK_FAILS(load_points("p.txt", 1), QN_INPUT, "p.txt:3: ");
    }
}

static void a_file_that_is_none_is_refused(void)
{
    CHECK_FAILS(load_points("none.txt", 1), QN_IO, "none.txt: cannot be opened: No such file");
    CHECK_FAILS(load_mesh("none.stl", 1), QN_IO, "none.stl: cannot be opened: No such file");
    CHECK_FAILS(load_particles("none.h5", 1), QN_IO, "none.h5: cannot be opened: No such file");
    CHECK_FAILS(load_points(".", 1), QN_INPUT, "is a folder");
    write_bytes("e.stl", "", 0);
    write_bytes("e.csv", "", 0);
    CHECK_FAILS(load_mesh("e.stl", 1), QN_INPUT, "the file is empty");
    CHECK_FAILS(load_particles("e.csv", 1), QN_INPUT, "the file is empty");
    write_bytes("b.csv", "x,y\0z\n", 6);
    CHECK_FAILS(load_particles("b.csv", 1), QN_INPUT, "b.csv:1: byte 3 is 0x00; a text file");
    CHECK_FAILS(qn_load_points("/dev/zero", 1, &xy, &point_count), QN_INPUT, "not an ordinary");
    write_huge("huge.bin");
    CHECK_FAILS(load_particles("huge.bin", 1), QN_INPUT, "at most 2000000000 are read");
    write_text("p.dat", "0 0 0\n");
    CHECK_FAILS(load_particles("p.dat", 1), QN_INPUT, "which kind of file is this?");
}

static void a_cube_comes_back_from_every_mesh_format(void)
{
    for (int i = 0; i < cube_count; i++) {
        if (!is_readable(cubes[i].name)) continue;
        write_cube(i);
        CHECK_STATUS(load_mesh(cubes[i].name, 1e-3));
        if (!is_box(2e-3)) printf("  %s: %d, %d\n", cubes[i].name, vertex_count, triangle_count);
        CHECK(is_box(2e-3));
    }
}

static void a_bad_text_mesh_is_refused_by_line(void)
{
    static const char *const bad[][2] = {
        {"# nothing\n", "holds only comments"},
        {"3\n", "m.msh:1: only 1 number"},
        {"3 x\n", "m.msh:1: 'x' is not a whole number from 1"},
        {"0 1\n1 2 3\n", "m.msh:1: '0' is not a whole number from 1"},
        {"-3 1\n", "m.msh:1: '-3' is not a whole number from 1"},
        {"99999999999999999999 1\n", "m.msh:1: '99999999999999999999' is not"},
        {"700000000 1\n0 0 0\n", "announces 700000000 vertices and 1 triangles, but"},
        {"3 1 # a comment to make room\n0 0 0\n1 0 0\n", "m.msh:3: the file ends after 2 of 3 v"},
        {"3 1\n0 0 0\n1 0 0\n0 1 nan\n1 2 3\n", "m.msh:4: 'nan' is not a finite number"},
        {"3 1\n0 0 0\n1 0 0\n0 1 1e7\n1 2 3\n", "m.msh:4: 1e+07 x 1 m is too far out"},
        {"3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 4\n", "m.msh:5: '4' is not a whole number from 1 to 3"},
        {"3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n", "m.msh:5: '0' is not a whole number from 1 to 3"},
        {"3 2 # room\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n",
         "m.msh:5: the file ends after 1 of 2 triangles"},
        {"3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n1 2 3\n", "m.msh:6: more lines than"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        write_text("m.msh", bad[i][0]);
        CHECK_FAILS(load_mesh("m.msh", 1), QN_INPUT, bad[i][1]);
    }
}

static void a_bad_stl_obj_or_ply_is_refused_with_its_reason(void)
{
    static const char *const bad[][3] = {
        {"m.stl", "solid x\n facet normal 0 0 1\n", "without 'endsolid': it is cut short"},
        {"m.stl", "#!/bin/sh\n", "neither a text STL file"},
        {"m.stl", "solid x\nendsolid x\n", "m.stl: "},
        {"m.stl",
         "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 nan 0\n"
         "endloop\nendfacet\nendsolid x\n",
         "vertex 3 of part 1 is at 0 nan 0; finite"},
        {"m.obj", "hello\n", "an OBJ file needs lines that begin with v"},
        {"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "m.obj: "},
        {"m.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n", "m.obj: "},
        {"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "m.obj: "},
        {"m.ply", "plywood\n", "begins with a line 'ply'"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "without 'end_header'"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n",
         "m.ply:3: '4000000000' is not a whole number from 0 to"},
        {"m.ply", "ply\nformat ascii 1.0\nelement\nend_header\n", "m.ply:3: an element without"},
        {"m.ply", "ply\nformat ascii 1.0\nend_header\n", "m.ply: "},
    };
    if (!is_readable("any.stl")) return;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        write_text(bad[i][0], bad[i][1]);
        CHECK_FAILS(load_mesh(bad[i][0], 1), QN_INPUT, bad[i][2]);
    }
    for (int i = 0; i < cube_count; i++) {
        if (strcmp(cubes[i].name, "solid.stl") != 0) continue;
        write_cube(i);
        cut("solid.stl", 300);
        CHECK_FAILS(load_mesh("solid.stl", 1), QN_INPUT,
                    "announces 12 triangles, which take 684 bytes; it has 300: it is cut short");
    }
}

static void an_obj_file_opens_no_other_file(void)
{
    char text[1100];
    if (!is_readable("any.obj")) return;
    snprintf(text, sizeof text, "mtllib %s\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", path_of("pipe"));
    write_pipe("pipe");  // whoever opens it would wait for ever
    write_text("m.obj", text);
    CHECK_STATUS(load_mesh("m.obj", 1));
    CHECK(triangle_count == 1);
}

static void particles_are_read_from_a_table(void)
{
    write_text("a.csv", "# made by hand\nid, \"x\",Y,z,radius\n7,1,2,3,0.5\n8,4,5,6,1\n");
    CHECK_STATUS(load_particles("a.csv", 1e-3));
    CHECK(list.count == 2 && !list.velocity && !list.spin);
    for (int i = 0; i < 6; i++) CHECK_NEAR(list.position[i], (i + 1) * 1e-3, 1e-18);
    CHECK_NEAR(list.diameter[0], 1e-3, 1e-18);
    CHECK_NEAR(list.diameter[1], 2e-3, 1e-18);
    write_text("a.csv", "wz wy wx vx vy vz x y z diameter\n3 2 1 4 5 6 7 8 9 10\n");
    CHECK_STATUS(load_particles("a.csv", 0.1));
    CHECK(list.count == 1);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(list.spin[i], i + 1, 0);
        CHECK_NEAR(list.velocity[i], i + 4, 0);
        CHECK_NEAR(list.position[i], (i + 7) * 0.1, 1e-15);
    }
    CHECK_NEAR(list.diameter[0], 1, 1e-15);
}

static void a_bad_table_is_refused_by_line(void)
{
    static const char *const bad[][2] = {
        {"x,y,z\n", "0 spheres; 1 to"},
        {"# no\n", "holds only comments"},
        {"x,y\n1,2\n", "a.csv:1: the columns must be x y z"},
        {"x,y,z,vx\n1,2,3,4\n", "a.csv:1: the columns must be x y z"},
        {"x,y,z,radius,diameter\n1,2,3,4,8\n", "diameter or radius or neither"},
        {"x,y,z,x\n1,2,3,4\n", "a.csv:1: column 'x' is there twice"},
        {"x,y,z,colour\n1,2,3,4\n", "a.csv:1: 'colour' is not a column; columns are x y z vx"},
        {"x,y,z\n1,2,3\n1,2\n", "a.csv:3: only 2 numbers"},
        {"x,y,z\n1,2,3\n1,2,3,4\n", "a.csv:3: more than 3 numbers"},
        {"x,y,z\n1,2,nan\n", "a.csv:2: 'nan' is not a finite number"},
        {"x,y,z,vx,vy,vz\n1,2,3,0,1e400,0\n", "a.csv:2: '1e400' is not a finite number"},
        {"x,y,z,radius\n1,2,3,0\n", "a.csv:2: radius = 0; a size is above 0"},
        {"x,y,z,diameter\n1,2,3,-1\n", "a.csv:2: diameter = -1; a size is above 0"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        write_text("a.csv", bad[i][0]);
        CHECK_FAILS(load_particles("a.csv", 1), QN_INPUT, bad[i][1]);
    }
}

static void raw_spheres_of_a_wall_are_left_out(void)
{
    double raw[] = {1, 2, 3, 0, 9, 9, 9, 1, 4, 5, 6, 0};
    write_bytes("a.bin", raw, sizeof raw);
    CHECK_STATUS(load_particles("a.bin", 1e-3));
    CHECK(list.count == 2 && !list.velocity && !list.spin && !list.diameter);
    for (int i = 0; i < 6; i++) CHECK_NEAR(list.position[i], (i + 1) * 1e-3, 1e-18);
    raw[7] = 0.5;
    write_bytes("a.bin", raw, sizeof raw);
    CHECK_FAILS(load_particles("a.bin", 1), QN_INPUT, "sphere 2 of 3 has 0.5 as its fourth");
    raw[7] = (double)NAN;
    write_bytes("a.bin", raw, sizeof raw);
    CHECK_FAILS(load_particles("a.bin", 1), QN_INPUT, "sphere 2 of 3 has nan as its fourth");
    raw[7] = 1;
    raw[9] = (double)NAN;
    write_bytes("a.bin", raw, sizeof raw);
    CHECK_FAILS(load_particles("a.bin", 1), QN_INPUT, "sphere 3 of 3 has nan among its coord");
    raw[3] = raw[11] = 1;
    write_bytes("a.bin", raw, sizeof raw);
    CHECK_FAILS(load_particles("a.bin", 1), QN_INPUT, "all 3 spheres are part of a wall");
    write_bytes("a.bin", raw, 40);
    CHECK_FAILS(load_particles("a.bin", 1), QN_INPUT, "40 bytes; a raw list has 32 a sphere");
}

static void particles_are_read_from_a_frame(void)
{
    write_frame("f.hdf", 3);
    CHECK_STATUS(load_particles("f.hdf", 1));
    CHECK(list.count == 3 && list.velocity && list.spin && list.diameter);
    for (int i = 0; i < 9; i++) {
        CHECK_NEAR(list.position[i], i, 0);
        CHECK_NEAR(list.velocity[i], i + 100, 0);
        CHECK_NEAR(list.spin[i], i + 200, 0);
    }
    CHECK_NEAR(list.diameter[2], 2 * 1.5, 0);
    CHECK_FAILS(load_particles("f.hdf", 1e-3), QN_INPUT, "recordings are in metres");
}

static void particles_are_read_from_a_checkpoint_at_one_moment(void)
{
    write_checkpoint("c.h5", 4, 1);
    CHECK_STATUS(load_particles("c.h5", 1));
    CHECK(list.count == 4 && list.velocity && list.spin && list.diameter);
    for (int i = 0; i < 12; i++) {
        CHECK_NEAR(list.position[i], i, 0);
        CHECK_NEAR(list.velocity[i], i + 100 + i + 300, 0);
        CHECK_NEAR(list.spin[i], i + 200 + i + 400, 0);
    }
    CHECK_NEAR(list.diameter[0], 2 * 0.5, 0);
    CHECK_NEAR(list.diameter[3], 2 * 1.5, 0);
    write_checkpoint("c.h5", 4, 2);
    CHECK_FAILS(load_particles("c.h5", 1), QN_INPUT, "of class 2; there are 2, from 0");
}

static void a_bad_recording_is_refused_with_its_reason(void)
{
    write_text("f.h5", "not a recording at all");
    CHECK_FAILS(load_particles("f.h5", 1), QN_INPUT, "is not an HDF5 file");
    write_frame("f.hdf", 3);
    cut("f.hdf", 900);
    CHECK_FAILS(load_particles("f.hdf", 1), QN_INPUT, "is damaged or cut short");
    write_frame("f.hdf", -1);
    CHECK_FAILS(load_particles("f.hdf", 1), QN_INPUT, "holds neither /VTKHDF/Points");
    write_lying_frame("f.hdf");
    CHECK_FAILS(load_particles("f.hdf", 1), QN_INPUT, "more than a file of");
}

/// Loads a damaged file; an answer of QN_OK must hold together.
static bool is_sound(const char *name, bool is_mesh)
{
    if (is_mesh) {
        if (load_mesh(name, 1) != QN_OK) return qn_error()[0] != '\0';
        for (int i = 0; i < 3 * triangle_count; i++)
            if (triangles[i] < 0 || triangles[i] >= vertex_count) return false;
        for (int i = 0; i < 3 * vertex_count; i++)
            if (!(fabs(vertices[i]) <= 1e6)) return false;
        return true;
    }
    if (load_particles(name, 1) != QN_OK) return qn_error()[0] != '\0';
    for (int64_t i = 0; i < 3 * list.count; i++)
        if (!(fabs(list.position[i]) <= 1e6)) return false;
    return true;
}

static void damaged_meshes_never_crash(void)
{
    for (int i = 0; i < cube_count; i++) {
        write_cube(i);
        for (int trial = 0; trial < 400; trial++) {
            const char *damaged = damage(cubes[i].name, (uint64_t)trial);
            CHECK(is_sound(damaged, true));
        }
    }
}

static void damaged_particle_files_never_crash(void)
{
    const double raw[] = {1, 2, 3, 0, 9, 9, 9, 1, 4, 5, 6, 0};
    write_bytes("a.bin", raw, sizeof raw);
    write_text("a.csv", "x,y,z,vx,vy,vz,radius\n1,2,3,4,5,6,7\n1.5,2,3,4,5,6,7e-1\n");
    write_frame("f.hdf", 3);
    write_checkpoint("c.h5", 4, 1);
    static const char *const names[] = {"a.bin", "a.csv", "f.hdf", "c.h5"};
    for (int i = 0; i < 4; i++)
        for (int trial = 0; trial < 400; trial++)
            CHECK(is_sound(damage(names[i], (uint64_t)trial), false));
}

int main(int argc, char **argv)
{
    begin_files();
    TEST(a_profile_is_read_with_its_unit_comments_and_commas);
    TEST(a_bad_profile_is_refused_by_line);
    TEST(a_file_that_is_none_is_refused);
    TEST(a_cube_comes_back_from_every_mesh_format);
    TEST(a_bad_text_mesh_is_refused_by_line);
    TEST(a_bad_stl_obj_or_ply_is_refused_with_its_reason);
    TEST(an_obj_file_opens_no_other_file);
    TEST(particles_are_read_from_a_table);
    TEST(a_bad_table_is_refused_by_line);
    TEST(raw_spheres_of_a_wall_are_left_out);
    TEST(particles_are_read_from_a_frame);
    TEST(particles_are_read_from_a_checkpoint_at_one_moment);
    TEST(a_bad_recording_is_refused_with_its_reason);
    TEST(damaged_meshes_never_crash);
    TEST(damaged_particle_files_never_crash);
    end_files();
    free(xy);
    free(vertices);
    free(triangles);
    qn_particle_list_free(&list);
    DONE;
}
