// SPDX-License-Identifier: Apache-2.0
// Walls as a whole: their motion, numbering, and what a particle finds.
#include "check.h"
#include "world/walls.h"
#include "worlds.h"

enum { ROOM = 16 };

static double uniform(double low, double high)
{
    static uint64_t seed = 1;
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

/// A drum of 0.3 m with 16 lifters, at rest for 0.5 s, up to 2 rad/s within 1 s, then for ever.
static qn_def mill(qn_ends ends)
{
    qn_def def = {0};
    def.drum = drum_of(0.3, 0.1, ends);
    def.drum.end_material = 2;
    add_lifters(&def.drum, 16, 0.006, 0.006, 0.006);
    def.drum.leg_count = 3;
    def.drum.legs[0] = (qn_leg){0.5, 0, 0};
    def.drum.legs[1] = (qn_leg){1, 0, 2};
    def.drum.legs[2] = (qn_leg){INFINITY, 2, 2};
    return def;
}

/// Adds a plane and a triangle, both named.
static void add_plane_and_mesh(qn_def *def, bool turning)
{
    const double vertices[9] = {0.05, 0, 0.02, 0.09, 0, 0.02, 0.05, 0.04, 0.02};
    const int triangle[3] = {0, 1, 2};
    def->planes = calloc(1, sizeof *def->planes);
    def->planes[0] =
        (qn_plane_def){.name = "table", .material = 3, .point = {0, 0, 0.01}, .normal = {0, 0, 1}};
    def->plane_count = 1;
    def->meshes = calloc(1, sizeof *def->meshes);
    def->mesh_count = 1;
    qn_mesh_def *mesh = &def->meshes[0];
    *mesh = (qn_mesh_def){.name = "plate", .material = 4, .vertex_count = 3, .triangle_count = 1};
    if (turning) mesh->drive.kind = QN_DRIVE_DRUM;
    mesh->vertices = malloc(sizeof vertices);
    mesh->triangles = malloc(sizeof triangle);
    memcpy(mesh->vertices, vertices, sizeof vertices);
    memcpy(mesh->triangles, triangle, sizeof triangle);
}

static void the_angle_is_the_integral_of_the_speed(void)
{
    qn_drum_def d = mill(QN_ENDS_PERIODIC).drum;
    CHECK_NEAR(qn_drum_angle(&d, -1), 0, 0);
    CHECK_NEAR(qn_drum_angle(&d, 0.4), 0, 0);
    CHECK_NEAR(qn_drum_angle(&d, 1), 0.25, 1e-16);
    CHECK_NEAR(qn_drum_angle(&d, 1.5), 1, 1e-16);
    CHECK_NEAR(qn_drum_angle(&d, 101.5), 201, 1e-13);
    CHECK_NEAR(qn_drum_speed(&d, 0.2), 0, 0);
    CHECK_NEAR(qn_drum_speed(&d, 0.75), 0.5, 1e-16);
    CHECK_NEAR(qn_drum_speed(&d, 99), 2, 0);
    d.legs[2].duration = 3;  // the last speed holds also where the last leg ends
    CHECK_NEAR(qn_drum_angle(&d, 101.5), 201, 1e-13);
    CHECK_NEAR(qn_drum_speed(&d, 99), 2, 0);
    d.leg_count = 0;
    CHECK_NEAR(qn_drum_angle(&d, 5), 0, 0);
    CHECK_NEAR(qn_drum_speed(&d, 5), 0, 0);
}

static void the_time_of_an_angle_inverts_it(void)
{
    qn_drum_def d = mill(QN_ENDS_PERIODIC).drum;
    for (int sense = 0; sense < 2; sense++) {
        for (int i = 1; i < 400; i++) {
            double angle = i * 0.01, t = qn_drum_time(&d, angle);
            CHECK_NEAR(fabs(qn_drum_angle(&d, t)), angle, 1e-14);
        }
        CHECK_NEAR(qn_drum_time(&d, 0), 0, 0);
        CHECK_NEAR(qn_drum_time(&d, 1), 1.5, 1e-12);
        for (int k = 0; k < 3; k++) d.legs[k].from *= -1, d.legs[k].to *= -1;
    }
    d.legs[2] = (qn_leg){1, 2, 0};  // slows down to rest at 2 rad
    CHECK_NEAR(qn_drum_time(&d, 2 - 1e-12), 2.5, 1e-5);
    CHECK(isinf(qn_drum_time(&d, 2.001)));
    d.legs[0] = (qn_leg){1, -1, -1};  // one back first, then on
    d.legs[1] = (qn_leg){1, -1, 3};
    d.legs[2] = (qn_leg){INFINITY, 3, 3};
    CHECK_NEAR(qn_drum_angle(&d, qn_drum_time(&d, 0.5)), 0.5, 1e-14);
    CHECK_NEAR(qn_drum_time(&d, 6), 4, 1e-14);
}

static void parts_and_surfaces_are_named(void)
{
    qn_def def = mill(QN_ENDS_TURNING);
    add_plane_and_mesh(&def, true);
    qn_walls w;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    CHECK(def.planes == NULL && def.mesh_count == 0);
    const char *const names[] = {"shell", "lifter_01", "lifter_02"};
    for (int k = 0; k < 3; k++) CHECK(strcmp(w.parts[k].name, names[k]) == 0 && w.parts[k].turning);
    CHECK(w.part_count == 21);
    CHECK(strcmp(w.parts[17].name, "end_low") == 0 && w.parts[17].turning);
    CHECK(strcmp(w.parts[18].name, "end_high") == 0);
    CHECK(strcmp(w.parts[19].name, "table") == 0 && !w.parts[19].turning);
    CHECK(strcmp(w.parts[20].name, "plate") == 0 && w.parts[20].turning);
    CHECK(w.surface_count == 5);
    CHECK(w.surfaces[w.shell_surface].radius == -0.15 && w.surfaces[w.shell_surface].material == 1);
    CHECK(isinf(w.surfaces[w.flat_surface].radius) && w.surfaces[w.end_surface].material == 2);
    CHECK(w.end_feature == 128 && w.plane_feature == 130 && w.meshes[0].first_feature == 131);
    qn_walls_free(&w);
    CHECK(w.parts == NULL);
}

static void every_kind_of_wall_is_found_in_order(void)
{
    qn_def def = mill(QN_ENDS_FIXED);
    add_plane_and_mesh(&def, false);
    qn_walls w;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    qn_pose pose = qn_walls_pose(&w, 0);
    qn_wall_hit h[ROOM];
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0.02, 0.03, 0.05), 0.0015, h, ROOM) == 0);
    // On a shell stretch at the low end: shell, end; then the side of lifter 0 as well.
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0.02, -0.1476, 0.001), 0.0015, h, ROOM) == 2);
    CHECK(h[0].part == 0 && h[0].surface == w.shell_surface && h[0].body == w.drum_body);
    CHECK(h[1].feature == w.end_feature && h[1].part == w.end_part[0] && h[1].body == 0);
    CHECK(h[1].point.x == 0.02 && h[1].point.z == 0);
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0.0044, -0.1485, 0.099), 0.0015, h, ROOM) == 3);
    CHECK(h[0].part == 1 && h[0].surface == w.flat_surface && h[1].part == 0);
    CHECK(h[2].feature == w.end_feature + 1);
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0.0044, -0.1485, 0.099), 0.0015, h, 1) == 3);
    // On the corner of a lifter.
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0.0031, -0.1439, 0.05), 0.0015, h, ROOM) == 1);
    CHECK(h[0].part == 1 && h[0].surface == w.flat_surface);
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0, 0, 0.011), 0.0015, h, ROOM) == 1);
    CHECK(h[0].feature == w.plane_feature && h[0].part == w.plane_part && h[0].point.z == 0.01);
    CHECK(h[0].surface == w.plane_surface && w.surfaces[h[0].surface].material == 3);
    CHECK(qn_walls_touch(&w, &pose, qn_v3(0.06, 0.01, 0.021), 0.0015, h, ROOM) == 1);
    CHECK(h[0].feature == w.meshes[0].first_feature && w.surfaces[h[0].surface].material == 4);
    CHECK(strcmp(w.parts[h[0].part].name, "plate") == 0);
    qn_walls_free(&w);
}

static void what_turns_with_the_drum_finds_its_wall_unchanged(void)
{
    qn_def def = mill(QN_ENDS_PERIODIC);
    add_plane_and_mesh(&def, true);
    qn_walls w;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    const qn_vec3 start[4] = {{0.0031, -0.1439, 0.05},
                              {0.0044, -0.1485, 0.05},
                              {0.02, -0.1476, 0.05},
                              {0.06, 0.01, 0.0209}};
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 500; i++) {
            qn_wall_hit rest[ROOM], h[ROOM];
            qn_pose now = qn_walls_pose(&w, i * 0.37), first = qn_walls_pose(&w, 0);
            double angle = qn_drum_angle(&w.drum, i * 0.37), c = cos(angle), s = sin(angle);
            qn_vec3 p = start[k];
            qn_vec3 centre = qn_v3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
            int n = qn_walls_touch(&w, &first, p, 0.0015, rest, ROOM);
            CHECK(n > 0 && qn_walls_touch(&w, &now, centre, 0.0015, h, ROOM) == n);
            CHECK(now.frames[w.drum_body].speed == qn_drum_speed(&w.drum, i * 0.37));
            for (int j = 0; j < n; j++) {
                CHECK(h[j].feature == rest[j].feature && h[j].part == rest[j].part);
                CHECK_NEAR(qn_norm(qn_sub(h[j].point, centre)), qn_norm(qn_sub(rest[j].point, p)),
                           2e-16);
            }
        }
    qn_walls_free(&w);
}

static void inside_and_clearance_agree_with_the_profile(void)
{
    qn_def def = mill(QN_ENDS_FIXED);
    qn_walls w;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    qn_pose pose = qn_walls_pose(&w, 7.7);
    for (int i = 0; i < 20000; i++) {
        qn_vec3 p = qn_v3(uniform(-0.16, 0.16), uniform(-0.16, 0.16), uniform(-0.01, 0.11));
        double angle = qn_drum_angle(&w.drum, 7.7), c = cos(angle), s = sin(angle);
        double x = c * p.x + s * p.y, y = c * p.y - s * p.x;
        double clear = qn_min(qn_profile_distance(&w.profile, x, y), qn_min(p.z, 0.1 - p.z));
        CHECK_NEAR(qn_walls_clearance(&w, &pose, p), clear, 1e-15);
        CHECK(fabs(clear) < 1e-15 || qn_walls_outside(&w, &pose, p) == (clear < 0));
        qn_wall_hit h[ROOM];
        if (clear >= 0)
            CHECK((qn_walls_touch(&w, &pose, p, 0.0015, h, ROOM) > 0) == (clear < 0.0015));
    }
    CHECK_NEAR(qn_walls_volume(&w), 0.1 * qn_profile_area(&w.profile), 0);
    CHECK_NEAR(qn_walls_open_share(&w, 0.147), qn_profile_open_share(&w.profile, 0.147), 0);
    qn_walls_free(&w);
}

static void a_world_without_a_drum_has_its_planes_and_meshes(void)
{
    qn_def def = {0};
    add_plane_and_mesh(&def, false);
    qn_walls w;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    qn_pose pose = qn_walls_pose(&w, 3);
    CHECK(w.body_count == 1 && w.drum_body == -1 && !pose.frames[0].moves);
    CHECK(qn_walls_outside(&w, &pose, qn_v3(0, 0, 0)));
    CHECK(!qn_walls_outside(&w, &pose, qn_v3(9, 9, 9)));
    CHECK_NEAR(qn_walls_clearance(&w, &pose, qn_v3(0, 0, 0.013)), 0.003, 1e-17);
    CHECK_NEAR(qn_walls_clearance(&w, &pose, qn_v3(0.06, 0.01, 0.03)), 0.01, 1e-16);
    CHECK(qn_walls_volume(&w) == 0 && qn_walls_open_share(&w, 1) == 1);
    qn_walls_free(&w);
    qn_def nothing = {0};
    CHECK_STATUS(qn_walls_build(&nothing, 0.0015, &w));
    CHECK(isinf(qn_walls_clearance(&w, &pose, qn_v3(0, 0, 0))));
    qn_walls_free(&w);
}

static void walls_with_motions_of_their_own_are_found_where_they_are(void)
{
    // The table rises, the plate turns about a tilted axis; both are met in their own frame.
    qn_def def = {0};
    add_plane_and_mesh(&def, false);
    qn_vec3 axis = qn_scale(1.0 / 3, qn_v3(1, 2, 2));
    def.planes[0].drive =
        (qn_drive_def){.kind = QN_DRIVE_TRANSLATE, .axis = {0, 0, 1}, .leg_count = 1};
    def.planes[0].drive.legs[0] = (qn_leg){INFINITY, 0.01, 0.01};
    def.meshes[0].drive = (qn_drive_def){
        .kind = QN_DRIVE_ROTATE, .axis = axis, .through = {0.01, 0.02, 0.03}, .leg_count = 1};
    def.meshes[0].drive.legs[0] = (qn_leg){INFINITY, 4, 4};
    qn_walls w;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    CHECK(w.body_count == 3 && w.parts[0].body == 1 && w.parts[1].body == 2);
    const qn_vec3 own[3] = {{0.06, 0.01, 0.0209}, {0.07, -0.001, 0.0205}, {0.0495, -0.0005, 0.02}};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 300; i++) {
            qn_wall_hit rest[ROOM], h[ROOM];
            qn_pose first = qn_walls_pose(&w, 0), now = qn_walls_pose(&w, i * 0.37);
            qn_vec3 centre = qn_frame_leave(&now.frames[2], own[k]);
            double height = 0.01 + 0.0037 * i;
            qn_vec3 over = qn_v3(0.3, 0.2, height + 0.001), under = qn_v3(0.3, 0.2, height - 0.001);
            CHECK(qn_walls_touch(&w, &first, own[k], 0.0015, rest, ROOM) == 1);
            int n = qn_walls_touch(&w, &now, centre, 0.0015, h, ROOM);
            CHECK(n > 0 && h[n - 1].feature == rest[0].feature && h[n - 1].body == 2);
            CHECK_NEAR(qn_norm(qn_sub(h[n - 1].point, centre)),
                       qn_norm(qn_sub(rest[0].point, own[k])), 1e-15);
            CHECK(qn_walls_touch(&w, &now, over, 0.0015, h, ROOM) == 1);
            CHECK(h[0].body == 1 && h[0].facet == w.plane_facet);
            CHECK_NEAR(h[0].point.z, height, 1e-15);
            CHECK(qn_walls_outside(&w, &now, under) && !qn_walls_outside(&w, &now, over));
            CHECK_NEAR(qn_walls_clearance(&w, &now, over), 0.001, 1e-15);
        }
    qn_walls_free(&w);
}

static void walls_that_make_no_sense_are_refused(void)
{
    qn_walls w;
    qn_def def = mill(QN_ENDS_FIXED);
    def.drum.length = 0;
    CHECK(qn_walls_build(&def, 0.0015, &w) == QN_INPUT && strstr(qn_error(), "length"));
    def = mill(QN_ENDS_FIXED);
    def.drum.lifter_count = -1;
    CHECK(qn_walls_build(&def, 0.0015, &w) == QN_INPUT && strstr(qn_error(), "-1 lifters"));
    def = mill(QN_ENDS_FIXED);
    def.drum.legs[1].duration = INFINITY;
    CHECK(qn_walls_build(&def, 0.0015, &w) == QN_INPUT && strstr(qn_error(), "leg 2"));
    def = (qn_def){0};
    add_plane_and_mesh(&def, false);
    def.planes[0].normal = qn_v3(0, 0, 0);
    CHECK(qn_walls_build(&def, 0.0015, &w) == QN_INPUT && strstr(qn_error(), "'table'"));
    CHECK(def.planes != NULL && w.planes == NULL);  // left as it was
    def.planes[0].normal = qn_v3(0, 0, 1);
    def.meshes[0].drive.kind = QN_DRIVE_DRUM;
    CHECK(qn_walls_build(&def, 0.0015, &w) == QN_INPUT && strstr(qn_error(), "there is none"));
    def.meshes[0].drive.kind = QN_DRIVE_SWING;
    CHECK(qn_walls_build(&def, 0.0015, &w) == QN_INPUT && strstr(qn_error(), "'plate'"));
    def.meshes[0].drive.kind = QN_DRIVE_REST;
    CHECK_STATUS(qn_walls_build(&def, 0.0015, &w));
    qn_walls_free(&w);
}

static void the_sense_of_a_drum_is_that_of_its_last_motion(void)
{
    qn_drum_def drum = {.leg_count = 2, .legs = {{0.2, -6, -6}, {0.1, -6, 0}}};
    CHECK(qn_drum_sense(&drum) == -1);
    drum.legs[0] = (qn_leg){0.2, 6, 6}, drum.legs[1] = (qn_leg){INFINITY, 0, 0};
    CHECK(qn_drum_sense(&drum) == 1);
}

int main(int argc, char **argv)
{
    TEST(the_angle_is_the_integral_of_the_speed);
    TEST(the_time_of_an_angle_inverts_it);
    TEST(parts_and_surfaces_are_named);
    TEST(every_kind_of_wall_is_found_in_order);
    TEST(what_turns_with_the_drum_finds_its_wall_unchanged);
    TEST(inside_and_clearance_agree_with_the_profile);
    TEST(a_world_without_a_drum_has_its_planes_and_meshes);
    TEST(walls_with_motions_of_their_own_are_found_where_they_are);
    TEST(walls_that_make_no_sense_are_refused);
    TEST(the_sense_of_a_drum_is_that_of_its_last_motion);
    DONE;
}
