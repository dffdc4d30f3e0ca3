// SPDX-License-Identifier: Apache-2.0
// The key `motion` of walls: what is written is what moves, and what is wrong is told where it stands.
#include "check.h"
#include "scene/scene.h"

#include <stdlib.h>

static const char *const head =
    "format: quern-scene/1\n"                                         // 1
    "time: {end: 1 s}\n"                                              // 2
    "materials:\n"                                                    // 3
    "  glass: {young: 64 MPa, poisson: 0.23, density: 2500 kg/m3}\n"  // 4
    "contacts: {glass-glass: {friction: 0.2, restitution: 0.66}}\n"   // 5
    "particles:\n"                                                    // 6
    "  ball: {material: glass, diameter: 3 mm, at: 0 50 0 mm}\n"      // 7
    "walls:\n"                                                        // 8
    "  floor:\n"                                                      // 9
    "    shape: plane\n"                                              // 10
    "    normal: 0 1 0\n"                                             // 11
    "    material: glass\n";                                          // 12

/// Reads the head with `motion` as the value of that key, in line 13.
static qn_status read_motion(const char *motion, qn_def *def, char *line, size_t size)
{
    char text[4096];
    qn_messages messages = {0};
    *def = qn_def_default();
    snprintf(text, sizeof text, "%s    motion: %s\n", head, motion);
    qn_status status =
        qn_scene_read_text(text, strlen(text), "s.yaml", "/nowhere/", def, &messages);
    const char *said = messages.text ? messages.text : "";
    snprintf(line, size, "%.*s", (int)strcspn(said, "\n"), said);
    qn_messages_free(&messages);
    return status;
}

static void every_kind_of_motion_is_read_as_it_is_meant(void)
{
    qn_def def;
    char line[512];
    CHECK_STATUS(read_motion("{kind: rotate, axis: 0 0 2, through: 10 0 0 mm, speed: 60 rpm, "
                             "settle: 1 s, ramp: 0.5 s}",
                             &def, line, sizeof line));
    const qn_drive_def *d = &def.planes[0].drive;
    CHECK(d->kind == QN_DRIVE_ROTATE && d->axis.z == 1 && d->through.x == 0.01);
    CHECK(d->leg_count == 3 && d->legs[0].duration == 1 && d->legs[1].duration == 0.5);
    CHECK_NEAR(d->legs[2].to, 2 * QN_PI, 1e-15);
    qn_def_free(&def);
    CHECK_STATUS(read_motion("{kind: swing, axis: 3 4 0, amplitude: 10 deg, frequency: 2 Hz, "
                             "settle: 0.1 s, phase: 90 deg}",
                             &def, line, sizeof line));
    d = &def.planes[0].drive;
    CHECK(d->kind == QN_DRIVE_SWING && d->frequency == 2 && d->start == 0.1);
    CHECK_NEAR(d->axis.x, 0.6, 1e-15);
    CHECK_NEAR(d->amplitude, QN_PI / 18, 1e-16);
    CHECK_NEAR(d->phase, QN_PI / 2, 1e-15);
    qn_def_free(&def);
    CHECK_STATUS(read_motion("{kind: translate, direction: 0 -2 0, schedule: [{duration: 1 s, at: "
                             "0 m/s}, {duration: 2 s, to: 30 mm/s}]}",
                             &def, line, sizeof line));
    d = &def.planes[0].drive;
    CHECK(d->kind == QN_DRIVE_TRANSLATE && d->axis.y == -1 && d->leg_count == 3);
    CHECK(d->legs[1].from == 0 && d->legs[1].to == 0.03 && d->legs[2].to == 0.03);
    qn_def_free(&def);
    CHECK_STATUS(
        read_motion("{kind: oscillate, direction: 0 1 0, amplitude: 2 mm, frequency: 1500 1/min}",
                    &def, line, sizeof line));
    d = &def.planes[0].drive;
    CHECK(d->kind == QN_DRIVE_OSCILLATE && d->amplitude == 0.002 && d->frequency == 25);
    qn_def_free(&def);
}

static void a_resolved_motion_reads_as_the_same_motion(void)
{
    static const char *const motions[] = {
        "{kind: rotate, axis: 1 2 2, through: 10 0 5 mm, speed: 60 rpm, settle: 1 s, ramp: 0.5 s}",
        "{kind: swing, axis: 3 4 0, amplitude: 9 deg, frequency: 2 Hz, settle: 1 s, phase: 9 deg}",
        "{kind: translate, direction: 0 -2 0, speed: 3 cm/s}",
        "{kind: oscillate, direction: 0 1 1, amplitude: 2 mm, frequency: 3 Hz}"};
    for (int k = 0; k < 4; k++) {
        qn_def def, again;
        char line[512], *text;
        qn_messages messages = {0};
        CHECK_STATUS(read_motion(motions[k], &def, line, sizeof line));
        CHECK_STATUS(qn_scene_resolved(&def, &text));
        CHECK_STATUS(qn_scene_read_text(text, strlen(text), "r.yaml", NULL, &again, &messages));
        qn_drive_def a = def.planes[0].drive, b = again.planes[0].drive;
        CHECK(a.kind == b.kind && a.leg_count == b.leg_count);
        CHECK_NEAR(qn_norm(qn_sub(a.axis, b.axis)), 0, 2e-16);
        CHECK(a.through.x == b.through.x && a.amplitude == b.amplitude && a.phase == b.phase);
        CHECK(a.frequency == b.frequency && a.start == b.start);
        for (int i = 0; i < a.leg_count; i++)
            CHECK(a.legs[i].to == b.legs[i].to && a.legs[i].duration == b.legs[i].duration);
        free(text);
        qn_messages_free(&messages);
        qn_def_free(&def), qn_def_free(&again);
    }
}

static void what_is_wrong_with_a_motion_is_told(void)
{
    // clang-format off
    static const struct {
        const char *motion, *first;
    } wrong[] = {
        {"{kind: rotates, speed: 1 rpm}", "s.yaml:13:20: error: walls.floor.motion.kind = rotates is unknown; did you mean 'rotate'? Allowed: rotate swing translate oscillate"},
        {"{speed: 1 rpm}", "s.yaml:13:5: error: walls.floor.motion lacks the key 'kind': about an axis, or along a direction; swing and oscillate go to and fro"},
        {"{kind: rotate}", "s.yaml:13:5: error: walls.floor.motion lacks the key 'speed' (or 'schedule')"},
        {"{kind: rotate, speed: 1 m/s}", "s.yaml:13:35: error: walls.floor.motion.speed = 1 m/s is a velocity, but this kind of motion needs an angular velocity"},
        {"{kind: translate, speed: 1 m/s}", "s.yaml:13:5: error: walls.floor.motion lacks the key 'direction', which the kind translate needs"},
        {"{kind: translate, direction: 0 0 0, speed: 1 m/s}", "s.yaml:13:42: error: walls.floor.motion.direction = 0 0 0 has no direction; give a vector that is not zero"},
        {"{kind: rotate, speed: 1 rpm, amplitude: 1 deg}", "s.yaml:13:53: error: walls.floor.motion.amplitude = 1 deg means nothing for the kind rotate"},
        {"{kind: swing, amplitude: 1 mm, frequency: 1 Hz}", "s.yaml:13:38: error: walls.floor.motion.amplitude = 1 mm is a length, but this kind of motion needs an angle"},
        {"{kind: oscillate, direction: 1 0 0, amplitude: 1 mm}", "s.yaml:13:5: error: walls.floor.motion lacks the key 'frequency', which the kind oscillate needs"},
        {"{kind: oscillate, direction: 1 0 0, amplitude: 1 mm, frequency: 1 Hz, speed: 1 m/s}", "s.yaml:13:90: error: walls.floor.motion.speed = 1 m/s means nothing for the kind oscillate"},
        {"{kind: rotate, schedule: [{to: 1 rpm}]}", "s.yaml:13:39: error: walls.floor.motion.schedule[1] changes the speed, so it needs the key 'duration'"},
        {"{kind: rotate, speed: 1 rpm, schedule: [{at: 1 rpm}]}", "s.yaml:13:35: error: walls.floor.motion.speed = 1 rpm cannot stand beside the schedule, which gives all speeds"},
    };
    // clang-format on
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        qn_def def;
        char line[512];
        CHECK(read_motion(wrong[k].motion, &def, line, sizeof line) == QN_INPUT);
        if (strcmp(line, wrong[k].first) != 0) printf("  %s\n  %s\n", line, wrong[k].first);
        CHECK(!strcmp(line, wrong[k].first));
        qn_def_free(&def);
    }
}

int main(int argc, char **argv)
{
    TEST(every_kind_of_motion_is_read_as_it_is_meant);
    TEST(a_resolved_motion_reads_as_the_same_motion);
    TEST(what_is_wrong_with_a_motion_is_told);
    DONE;
}
