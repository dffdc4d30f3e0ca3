// SPDX-License-Identifier: Apache-2.0
// Scenes: what is right is read as it is meant, and what is wrong gets its line, column and sentence.
//
// The cases of wrong input change one place of a scene that is right; the first line of the messages
// must then be exactly as the table says.
#include "check.h"

#include "scene/keys.h"
#include "scene/scene.h"

#include <glob.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static const char good[] =
    "format: quern-scene/1\n"                                                    // 1
    "time: {end: 2 rev}\n"                                                       // 2
    "materials:\n"                                                               // 3
    "  glass: {young: 64 MPa, poisson: 0.23, density: 2500 kg/m3}\n"             // 4
    "  soft-glass: {like: glass, shear: 0.31 GPa}\n"                             // 5
    "contacts:\n"                                                                // 6
    "  defaults: {friction: 20 %}\n"                                             // 7
    "  glass-glass: {restitution: 0.66}\n"                                       // 8
    "  soft-glass-glass: {restitution: 0.55, law: linear, stiffness: 1 kN/m}\n"  // 9
    "drum:\n"                                                                    // 10
    "  diameter: 300 mm\n"                                                       // 11
    "  length: 9 mm\n"                                                           // 12
    "  material: soft-glass\n"                                                   // 13
    "  speed: 70 %critical\n"                                                    // 14
    "  ramp: 0.5 s\n"                                                            // 15
    "  lifters: {count: 16, height: 6 mm, top: 6 mm, face_angle: 45 deg}\n"      // 16
    "particles:\n"                                                               // 17
    "  balls: {material: glass, diameter: 3 mm, count: 2500}\n"                  // 18
    "measure: {fields: {start: 1 rev}, traces: {ids: 1 2 3}}\n";                 // 19

/// `text` with the first `from` made `to`; both may be empty. Release it with free().
static char *changed(const char *text, const char *from, const char *to)
{
    const char *at = strstr(text, from);
    size_t size = strlen(text) + strlen(to) + 1;
    char *fresh = malloc(size);
    if (!at || !fresh) {
        printf("  '%s' is not in the scene\n", from);
        exit(1);
    }
    snprintf(fresh, size, "%.*s%s%s", (int)(at - text), text, to, at + strlen(from));
    return fresh;
}

typedef struct outcome {
    qn_status status;
    qn_def def;
    qn_messages messages;
} outcome;

static outcome read_changed(const char *from, const char *to)
{
    outcome o = {0};
    char *text = changed(good, from, to);
    o.status = qn_scene_read_text(text, strlen(text), "s.yaml", "/nowhere/", &o.def, &o.messages);
    free(text);
    return o;
}

static void release(outcome *o)
{
    qn_def_free(&o->def);
    qn_messages_free(&o->messages);
}

// clang-format off
static const struct {
    const char *from, *to, *first;
} wrong[] = {
    {"ramp:", "rampe:", "s.yaml:15:3: error: unknown key 'rampe' in drum; did you mean 'ramp'?"},
    {"time:", "zeitdauer: 1\ntime:", "s.yaml:2:1: error: unknown key 'zeitdauer' in the scene; known are: format, title, gravity, seed, time, materials, contacts, drum, walls, particles, feeds, outlets, measure, output, numerics"},
    {"material: soft-glass", "material: soft-gras", "s.yaml:13:13: error: drum.material = soft-gras is not a material; did you mean 'soft-glass'?"},
    {"material: soft-glass", "material: wood", "s.yaml:13:13: error: drum.material = wood is not a material; known are: glass soft-glass"},
    {"soft-glass-glass:", "soft-glas-glass:", "s.yaml:9:3: error: 'soft-glas-glass' in contacts is not a pair of materials; did you mean 'soft-glass-glass'?"},
    {"like: glass, ", "", "s.yaml:5:3: error: materials.soft-glass lacks the key 'poisson': Poisson's ratio"},
    {"format: quern-scene/1\n", "", "s.yaml:1:1: error: the scene lacks the key 'format': what this file is"},
    {"young: 64 MPa, ", "", "s.yaml:4:3: error: materials.glass lacks the key 'young': Young's modulus; this or shear"},
    {", count: 2500", "", "s.yaml:18:3: error: particles.balls lacks an amount: one of the keys count, filling, mass"},
    {"quern-scene/1", "quern-scene/2", "s.yaml:1:9: error: format = quern-scene/2 is unknown; it must be: quern-scene/1"},
    {"300 mm", "300 kg", "s.yaml:11:13: error: drum.diameter = 300 kg should be a length (m, mm, cm, um, in), but kg is the unit of a mass"},
    {"300 mm", "300 nm", "s.yaml:11:13: error: drum.diameter = 300 nm has no known unit: 'nm'; did you mean mm? Allowed: m, mm, cm, um, in"},
    {"300 mm", "300", "s.yaml:11:13: error: drum.diameter = 300 needs a unit: m, mm, cm, um, in"},
    {"0.23", "0.23 m", "s.yaml:4:35: error: materials.glass.poisson = 0.23 m is a pure number and takes no unit"},
    {"20 %", "20 mm", "s.yaml:7:24: error: contacts.defaults.friction = 20 mm is a pure number and takes no unit but %"},
    {"2500}", "25oo}", "s.yaml:18:51: error: particles.balls.count = 25oo is not a number: 'o' is a letter, not the digit 0"},
    {"2500}", "25oo,5}", "s.yaml:18:51: error: particles.balls.count = 25oo is not a number: 'o' is a letter, not the digit 0"},
    {"2500}", "2l00}", "s.yaml:18:51: error: particles.balls.count = 2l00 is not a number: 'l' is a letter, not the digit 1"},
    {"2500}", "25x}", "s.yaml:18:51: error: particles.balls.count = 25x is not a number: 'x' is left over"},
    {"density: 2500 kg/m3", "density: 25oo kg/m3", "s.yaml:4:50: error: materials.glass.density = 25oo kg/m3 is not a number: 'o' is a letter, not the digit 0"},
    {"300 mm", "4,5 mm", "s.yaml:11:13: error: drum.diameter = 4,5 mm has a comma: decimals follow a '.', and thousands are not set apart"},
    {"ids: 1 2 3}}", "ids: '1, 2'}}", "s.yaml:19:49: error: measure.traces.ids = 1, 2 has a comma: numbers stand apart by blanks, and decimals follow a '.'"},
    {"time:", "gravity: 0, -9.81, 0 m/s2\ntime:", "s.yaml:2:10: error: gravity = 0, -9.81, 0 m/s2 has a comma: numbers stand apart by blanks, and decimals follow a '.'"},
    {"count: 2500", "filling: 30", "s.yaml:18:53: error: particles.balls.filling = 30 must be above 0 and at most 1 (share of the drum's volume that the bed at rest takes, voids included); did you mean 30 %?"},
    {"count: 2500", "filling: 130 %", "s.yaml:18:53: error: particles.balls.filling = 130 % must be above 0 and at most 100 % (share of the drum's volume that the bed at rest takes, voids included)"},
    {"45 deg", "100 deg", "s.yaml:16:61: error: drum.lifters.face_angle = 100 deg must be above 0 and at most 90 deg (between side face and shell, 90 deg is rectangular; instead of base)"},
    {"2500}", "2500.5}", "s.yaml:18:51: error: particles.balls.count = 2500.5 is not a whole number"},
    {"2500}", "many}", "s.yaml:18:51: error: particles.balls.count = many is not a whole number"},
    {"diameter: 3 mm", "diameter: -3 mm", "s.yaml:18:38: error: particles.balls.diameter = -3 mm must be above 0 mm (of every sphere; this, sizes or distribution)"},
    {"0.23", "nan", "s.yaml:4:35: error: materials.glass.poisson = nan is not a number"},
    {"64 MPa", "inf MPa", "s.yaml:4:18: error: materials.glass.young = inf MPa is not a number"},
    {"64 MPa", "0x40 MPa", "s.yaml:4:18: error: materials.glass.young = 0x40 MPa has no known unit: 'x40 MPa'; allowed: Pa, kPa, MPa, GPa"},
    {"64 MPa", "1e400 Pa", "s.yaml:4:18: error: materials.glass.young = 1e400 Pa is too large for a number"},
    {"64 MPa", "1e305 GPa", "s.yaml:4:18: error: materials.glass.young = 1e305 GPa is too large for a number"},
    {"0.23", "0.7", "s.yaml:4:35: error: materials.glass.poisson = 0.7 must be above -1 and at most 0.5 (Poisson's ratio)"},
    {"0.66", "0", "s.yaml:8:30: error: contacts.glass-glass.restitution = 0 must be above 0 and at most 1 (coefficient of restitution, a ratio of speeds; required, but for damping none)"},
    {"0.66", "1.2", "s.yaml:8:30: error: contacts.glass-glass.restitution = 1.2 must be above 0 and at most 1 (coefficient of restitution, a ratio of speeds; required, but for damping none)"},
    {"  ramp: 0.5 s\n", "  ramp: 0.5 s\n  ramp: 1 s\n", "s.yaml:16:3: error: key 'ramp' appears twice in drum; it is first in line 15"},
    {"  soft-glass:", "  glass: {}\n  soft-glass:", "s.yaml:5:3: error: 'glass' appears twice in materials"},
    {"  soft-glass-glass: {", "  glass-soft-glass: {friction: 1, restitution: 1}\n  soft-glass-glass: {", "s.yaml:10:3: error: the pair 'soft-glass-glass' appears twice in contacts"},
    {"  soft-glass-glass: {restitution: 0.55, law: linear, stiffness: 1 kN/m}\n", "", "s.yaml:6:1: error: contacts lacks 'glass-soft-glass': particles 'balls' and the drum can touch, and no law says what happens then"},
    {"  glass-glass: {restitution: 0.66}\n", "", "s.yaml:6:1: error: contacts lacks 'glass-glass': particles 'balls' and themselves can touch, and no law says what happens then"},
    {", stiffness: 1 kN/m", "", "s.yaml:9:46: error: contacts.soft-glass-glass has a linear spring, which needs the key 'stiffness' or 'impact_speed'"},
    {", stiffness: 1 kN/m", ", damping: hunt-crossley", "s.yaml:9:3: error: contacts.soft-glass-glass lacks the key 'impact_speed': at which a linear spring is as stiff as Hertz's, and at which hunt-crossley gives the restitution"},
    {"0.66}", "0.66, stiffness: 1 N/m}", "s.yaml:8:47: error: contacts.glass-glass.stiffness = 1 N/m means nothing here: it goes with normal linear"},
    {"0.66}", "0.66, rolling: epsd}", "s.yaml:8:3: error: contacts.glass-glass lacks the key 'rolling_friction': torque against rolling, over normal force and effective radius; rolling constant, epsd, thesis"},
    {"0.66}", "0.66, rolling: none, rolling_friction: 0.1}", "s.yaml:8:69: error: contacts.glass-glass.rolling_friction = 0.1 means nothing here: it goes with rolling constant, epsd and thesis"},
    {"0.66}", "0.66, damping: viscous}", "s.yaml:8:45: error: contacts.glass-glass has the normal model hertz, with which the damping model viscous makes no sense; it goes with: linear"},
    {"0.66}", "0.66, normal: young, damping: none}", "s.yaml:8:44: error: contacts.glass-glass has the normal model young, with which the tangential model mindlin makes no sense; it goes with: hertz"},
    {"law: linear", "law: linear, tangential: mindlin", "s.yaml:9:66: error: contacts.soft-glass-glass has the normal model linear, with which the tangential model mindlin makes no sense; it goes with: hertz"},
    {"0.66}", "0.66, tangential: viscous, tangential_damping: 1 N/m}", "s.yaml:8:77: error: contacts.glass-glass.tangential_damping = 1 N/m should be a damping coefficient (N s/m, Ns/m), but N/m is the unit of a spring stiffness"},
    {"law: linear", "law: linaer", "s.yaml:9:46: error: contacts.soft-glass-glass.law = linaer is unknown; did you mean 'linear'? Allowed: hertz-mindlin linear thesis"},
    {"  ramp:", "\tramp:", "s.yaml:15:1: error: a tab cannot be used to indent; use spaces"},
    {"time: {end: 2 rev}", "time: 2 rev", "s.yaml:2:7: error: time = 2 rev is a single value, but should be a map of keys: how long, and in what steps"},
    {"300 mm", "{mm: 300}", "s.yaml:11:13: error: drum.diameter is a map of keys, but should be number: inside the shell"},
    {"ids: 1 2 3", "ids: [1, 2]", "s.yaml:19:49: error: measure.traces.ids is a list, but should be numbers: particles, numbered from 1"},
    {"ids: 1 2 3", "ids: 1 2.5", "s.yaml:19:49: error: measure.traces.ids = 1 2.5 must be whole numbers"},
    {"ids: 1 2 3", "ids: 0 1", "s.yaml:19:49: error: measure.traces.ids = 0 1 must be at least 1 and at most 9e+15 (particles, numbered from 1)"},
    {"{end: 2 rev}", "[[[[[[[[[[[[[[[[[[[[", "s.yaml:2:18: error: maps and lists are nested deeper than 12 levels"},
    {"{end: 2 rev}", "&a {end: 2 rev}", "s.yaml:2:7: error: anchors (&), aliases (*) and tags (!) are not part of a scene"},
    {"{end: 2 rev}", "*a", "s.yaml:2:7: error: anchors (&), aliases (*) and tags (!) are not part of a scene"},
    {"{end: 2 rev}", "!!map {end: 2 rev}", "s.yaml:2:7: error: anchors (&), aliases (*) and tags (!) are not part of a scene"},
    {"drum:\n", "---\ndrum:\n", "s.yaml:10:1: error: a second document begins; one file is one scene"},
    {"format: ", "? [a]\n: b\nformat: ", "s.yaml:1:3: error: a key must be a plain word, not a map or list"},
    {"  length: 9 mm", "  length 9 mm", "s.yaml:12:3: error: a ':' is missing: each line is a key, a colon, a space and a value"},
    {"  length: 9 mm", "  length:9 mm", "s.yaml:12:9: error: a space is missing behind the ':'"},
    {"  length: 9 mm", "  length 9 mm # mm", "s.yaml:12:3: error: a ':' is missing: each line is a key, a colon, a space and a value"},
    {"count: 16", "count:16", "s.yaml:16:13: error: unknown key 'count:16' in drum.lifters: a space is missing behind the ':'"},
    {"  length: 9 mm", "   length: 9 mm", "s.yaml:12:4: error: this line begins in column 4, that above in column 3: keys of one section begin in the same column, and a key with keys below it has no value of its own"},
    {"  length: 9 mm", " length: 9 mm", "s.yaml:12:2: error: this line begins in column 2, where no section above has its keys: keys of one section begin in the same column"},
    {"  length: 9 mm", "- length: 9 mm", "s.yaml:12:1: error: an entry of a list ('-') cannot stand among keys"},
    {"  length: 9 mm", "  \tlength: 9 mm", "s.yaml:12:3: error: a tab cannot be used to indent; use spaces"},
    {"time: {end: 2 rev}", "title: A mill: mine\ntime: {end: 2 rev}", "s.yaml:2:14: error: a second ':' in the same line: put a value that holds ': ' in quotes, and each key in a line of its own"},
    {"time: {end: 2 rev}", "title: @mill\ntime: {end: 2 rev}", "s.yaml:2:8: error: a value cannot begin with '@'; put it in quotes"},
    {"time: {end: 2 rev}", "title: 'mill\ntime: {end: 2 rev}", "s.yaml:2:8: error: the quote (') is not closed"},
    {"time: {end: 2 rev}", "title: 'a' mill\ntime: {end: 2 rev}", "s.yaml:2:12: error: this does not belong to the value before it"},
    {"time: {end: 2 rev}", "time: {end: 2 rev seed: 1}", "s.yaml:2:23: error: a ',' or '}' is missing here"},
    {"time: {end: 2 rev}", "time: ,", "s.yaml:2:7: error: a value is missing before ','"},
    {"time: {end: 2 rev}", "time:\n  end:2 rev", "s.yaml:3:3: error: time = end:2 rev is a single value, but should be a map of keys: a space is missing behind the ':'"},
    {"{end: 2 rev}", "{end: 2 rev", "s.yaml:2:7: error: the '{' is still open in line 3: a ',' or its '}' is missing"},
    {"count: 16", "count: 400", "s.yaml:16:20: error: drum.lifters.count = 400 lifters with a base of 18 mm do not fit on a shell 942.478 mm around"},
    {"height: 6 mm", "height: 160 mm", "s.yaml:16:32: error: drum.lifters.height = 160 mm reaches the axis of a drum of 300 mm"},
    {"face_angle: 45 deg", "face_angle: 45", "s.yaml:16:61: error: drum.lifters.face_angle = 45 needs a unit: deg, rad"},
    {"face_angle: 45 deg", "base: 3 mm", "s.yaml:16:55: error: drum.lifters.base = 3 mm is narrower than the top, 6 mm"},
    {"time:", "gravity: 0 0 -9.81 m/s2\ntime:", "s.yaml:2:10: error: gravity acts along z, the axis of a drum with periodic ends; use ends: fixed"},
    {"time:", "gravity: 0 -9.81 m/s2\ntime:", "s.yaml:2:10: error: gravity = 0 -9.81 m/s2 has 2 numbers, but three are needed: x y z, then the unit"},
    {"time:", "gravity: 0 -9.81 0\ntime:", "s.yaml:2:10: error: gravity = 0 -9.81 0 needs a unit: m/s2, mm/s2"},
    {"  speed: 70 %critical\n", "", "s.yaml:10:1: error: drum lacks the key 'speed' (or 'schedule'), such as speed: 70 %critical"},
    {"70 %critical", "0 rpm", "s.yaml:2:13: error: time.end = 2 rev counts turns of the drum, but the drum does not turn; use s"},
    {"  length: 9 mm", "  end_material: glass\n  length: 9 mm", "s.yaml:12:17: error: drum.end_material = glass means nothing: periodic ends have no wall"},
    {"count: 2500", "file: none.csv", "s.yaml:18:50: error: particles.balls.file = none.csv cannot be used: "},
    {"particles:\n", "walls:\n  chute: {shape: mesh, material: glass, file: none.stl}\nparticles:\n", "s.yaml:18:47: error: walls.chute.file = none.stl cannot be used: "},
    {"particles:\n", "walls:\n  floor: {shape: plain, material: glass}\nparticles:\n", "s.yaml:18:18: error: walls.floor.shape = plain is unknown; did you mean 'plane'?; allowed: plane box mesh"},
    {"particles:\n", "walls:\n  floor: {material: glass}\nparticles:\n", "s.yaml:18:3: error: walls.floor lacks the key 'shape': plane, box or mesh"},
    {"particles:\n", "walls:\n  floor: {shape: plane, material: glass, normal: 0 0 0}\nparticles:\n", "s.yaml:18:50: error: walls.floor.normal = 0 0 0 has no direction; give a vector to the side where particles live"},
    {"particles:\n", "walls:\n  room: {shape: box, material: glass, low: 0 0 0 m, high: 1 1 0 m}\nparticles:\n", "s.yaml:18:59: error: walls.room.high = 1 1 0 m must be above low, 0 0 0 m, in each coordinate"},
    {"count: 2500", "at: 0 0 0 m, count: 1", "s.yaml:18:64: error: particles.balls.count = 1 means nothing where fill is at"},
    {"count: 2500", "count: 2500, mass: 1 kg", "s.yaml:18:63: error: particles.balls.mass = 1 kg is given besides count; give one of count, filling, mass"},
    {"count: 2500", "count: 2500, shape: cube", "s.yaml:18:64: error: particles.balls.shape = cube is unknown; allowed: sphere tetrahedron file"},
    {"count: 2500", "count: 2500, shape: tetrahedron, spacing: 5", "s.yaml:18:86: error: particles.balls.spacing = 5 must be above 0 and at most 4 (between the centres of a tetrahedron's spheres, in their radii)"},
    {"count: 2500", "count: 2500, spacing: 1", "s.yaml:18:66: error: particles.balls.spacing = 1 means nothing where shape is not tetrahedron"},
    {"count: 2500", "count: 2500, turned: 0 0 1 rad", "s.yaml:18:65: error: particles.balls.turned = 0 0 1 rad means nothing for spheres"},
    {"count: 2500", "count: 2500, shape: file", "s.yaml:18:3: error: particles.balls lacks the key 'shape_file': CSV of a clump's spheres: x y z radius, in any unit as diameter gives the size"},
    {"count: 2500", "count: 2500, shape: file, shape_file: none.csv", "s.yaml:18:82: error: particles.balls.shape_file = none.csv cannot be used: "},
    {"count: 2500", "count: 2500, shape: tetrahedron, fixed: yes, spin: 0 0 1 rad/s", "s.yaml:18:95: error: particles.balls.spin = 0 0 1 rad/s means nothing for particles that are fixed"},
    {"diameter: 3 mm, ", "", "s.yaml:18:3: error: particles.balls lacks the key 'diameter' (or 'sizes' or 'distribution'): of every sphere; this, sizes or distribution"},
    {"diameter: 3 mm", "diameter: 3 mm, distribution: {kind: normal}", "s.yaml:18:58: error: particles.balls.distribution cannot stand beside diameter"},
    {"diameter: 3 mm", "distribution: {kind: log-normal, min: 1 mm, max: 3 mm}", "s.yaml:18:49: error: particles.balls.distribution.kind = log-normal is unknown; did you mean 'lognormal'? Allowed: normal lognormal rosin-rammler gaudin-schuhmann"},
    {"diameter: 3 mm", "distribution: {kind: lognormal, median: 2 mm, min: 1 mm, max: 3 mm}", "s.yaml:18:28: error: particles.balls.distribution lacks the key 'sigma' of a lognormal distribution: lognormal: standard deviation of ln d"},
    {"diameter: 3 mm", "distribution: {kind: rosin-rammler, d63: 2 mm, n: 1, top: 2 mm, min: 1 mm, max: 3 mm}", "s.yaml:18:86: error: particles.balls.distribution.top = 2 mm means nothing where kind is rosin-rammler"},
    {"diameter: 3 mm", "distribution: {kind: rosin-rammler, d63: 2 mm, n: 1, min: 3 mm, max: 2 mm}", "s.yaml:18:97: error: particles.balls.distribution.max = 2 mm must be above min, 0.003 m"},
    {"diameter: 3 mm", "distribution: {kind: gaudin-schuhmann, top: 2 mm, m: 1, min: 3 mm, max: 4 mm}", "s.yaml:18:28: error: particles.balls.distribution: the size distribution has nothing between 0.003 and 0.004 m"},
    {"  balls:", "  red balls:", "s.yaml:18:3: error: 'red balls' cannot be the name of a group of particles: use up to 47 letters, digits, '_', '-', '.'"},
    {"count: 2500", "fill: lining, turning: yes", "s.yaml:18:50: error: particles.balls.fill = lining goes along a smooth shell: leave out drum.lifters"},
    {"count: 2500", "count: 2500, shape: tetrahedron, turning: yes", "s.yaml:18:86: error: particles.balls.turning = yes is for spheres, not for clumps"},
    {"count: 2500", "count: 2500, fixed: yes, turning: yes", "s.yaml:18:78: error: particles.balls.turning = yes cannot stand beside fixed: yes"},
    {"count: 2500", "count: 2500, turning: yes, velocity: 0 1 0 m/s", "s.yaml:18:81: error: particles.balls.velocity = 0 1 0 m/s means nothing for particles that turn with the drum"},
    {"measure: {", "output: {frames: 10 steps, checkpoint: 5 steps}\nmeasure: {", "s.yaml:19:40: error: output.checkpoint = 5 steps should be a time (s, ms, us, ns, min, h), but steps is the unit of time steps"},
};
// clang-format on

static void what_is_wrong_gets_its_place_and_sentence(void)
{
    bool all = true;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        outcome o = read_changed(wrong[i].from, wrong[i].to);
        const char *text = o.messages.text ? o.messages.text : "";
        size_t length = strlen(wrong[i].first);
        bool ends = length > 0 && (text[length] == '\n' || wrong[i].first[length - 1] == ' ');
        if (o.status != QN_INPUT || strncmp(text, wrong[i].first, length) != 0 || !ends) {
            printf("  expected %s\n  got      %.*s\n", wrong[i].first, (int)strcspn(text, "\n"),
                   text);
            all = false;
        }
        release(&o);
    }
    CHECK(all);
}

static void the_caret_stands_under_the_value(void)
{
    outcome o = read_changed("0.23", "0.7");
    const char *expected = "\n  glass: {young: 64 MPa, poisson: 0.7, density: 2500 kg/m3}\n"
                           "                                  ^~~\n";
    bool found = o.messages.text && strstr(o.messages.text, expected);
    release(&o);
    CHECK(found);
}

static void all_errors_come_in_one_go(void)
{
    char *text = changed(good, "64 MPa", "64"), *more = changed(text, "300 mm", "-1 mm");
    qn_def def;
    qn_messages messages = {0};
    qn_status status = qn_scene_read_text(more, strlen(more), "s.yaml", NULL, &def, &messages);
    bool both = messages.errors == 2 && strstr(messages.text, "young = 64 needs a unit")
                && strstr(messages.text, "diameter = -1 mm must be above 0 mm");
    qn_messages_free(&messages);
    free(text);
    free(more);
    CHECK(status == QN_INPUT && both);
}

/// Errors of a scene with its bytes from `at`, `length` of them, made `to`; what they are is printed if
/// they are not one.
static int errors_with(const char *at, size_t length, const char *to)
{
    char text[sizeof good + 64];
    qn_def def;
    qn_messages messages = {0};
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - good), good, to, at + length);
    qn_status status = qn_scene_read_text(text, strlen(text), "s.yaml", NULL, &def, &messages);
    int errors = status == QN_INPUT ? messages.errors : 0;
    if (errors != 1) printf("  %.*s -> %s:\n%s", (int)length, at, to, messages.text);
    qn_messages_free(&messages);
    qn_def_free(&def);
    return errors;
}

static void one_mistake_is_one_error(void)
{
    const char *density = strstr(good, ", density"), *shear = strstr(good, ", shear");
    bool all = errors_with(density, strcspn(density, "}"), "") == 1;
    all = all && errors_with(shear, strcspn(shear, "}"), ", sheer: 1 GPa") == 1;
    for (const char *colon = strchr(good, ':'); colon; colon = strchr(colon + 1, ':')) {
        const char *key = colon, *value = colon + 2;
        while (key > good && !strchr(" {\n", key[-1])) key--;
        size_t length = (size_t)(colon - key);
        char swapped[sizeof good];
        snprintf(swapped, sizeof swapped, "%.*s", (int)length, key);
        swapped[0] = key[1], swapped[1] = key[0];
        bool is_name = !strncmp(key, "glass", 5) || !strncmp(key, "soft-", 5)
                       || !strncmp(key, "balls", 5) || !strncmp(key, "defaults", 8);
        if (!is_name) all = all && errors_with(key, length, swapped) == 1;
        size_t end = strcspn(value, ",}\n");
        if (colon[1] == ' ' && *value != '{') all = all && errors_with(value, end, "bad") == 1;
    }
    CHECK(all);
}

static void the_scene_without_a_fault_is_read_as_it_is_meant(void)
{
    outcome o = read_changed("", "");
    qn_def d = o.def;
    qn_drum_def *drum = &o.def.drum;
    if (o.messages.text) printf("%s", o.messages.text);
    CHECK(o.status == QN_OK && o.messages.errors == 0);
    CHECK(d.material_count == 2 && d.contact_count == 2 && d.group_count == 1);
    CHECK(d.materials[0].youngs_modulus == 64e6 && d.materials[0].poisson_ratio == 0.23);
    CHECK_NEAR(d.materials[1].youngs_modulus, 2 * 1.23 * 0.31e9, 1);
    CHECK(d.materials[1].density == 2500);
    CHECK(d.contacts[0].law.tangential == QN_TANGENTIAL_MINDLIN && d.contacts[0].friction == 0.2);
    CHECK(d.contacts[0].clip && d.contacts[0].restitution == 0.66);
    CHECK(d.scheme == QN_SCHEME_LEAPFROG);
    CHECK(d.contacts[0].law.rolling == QN_ROLLING_NONE);
    CHECK(d.contacts[1].law.normal == QN_NORMAL_LINEAR && d.contacts[1].stiffness == 1000);
    CHECK(d.contacts[1].material_a == 1 && d.contacts[1].material_b == 0);
    CHECK_NEAR(d.contacts[1].tangential_ratio, 2.0 / 7, 1e-15);
    CHECK(drum->diameter == 0.3 && drum->length == 0.009 && drum->ends == QN_ENDS_PERIODIC);
    CHECK(drum->leg_count == 2 && drum->legs[0].duration == 0.5 && drum->legs[0].from == 0);
    CHECK_NEAR(drum->legs[1].to, 0.7 * sqrt(2 * 9.81 / 0.3), 1e-14);
    CHECK(isinf(drum->legs[1].duration) && drum->lifter_count == 16);
    CHECK_NEAR(drum->lifter_base, 0.018, 1e-15);
    CHECK(d.groups[0].diameter[0] == 0.003 && d.groups[0].amount == 2500);
    CHECK(d.groups[0].packing == QN_PACK_HCP && d.groups[0].padding == 0.02);
    CHECK(d.end.value == 2 && d.end.unit == QN_REVOLUTIONS && d.step == 0);
    CHECK(d.measure.grid_count == 3 && d.measure.grid_cell[2] == 4 && d.measure.traced[2] == 3);
    CHECK(!strcmp(d.output.directory, "out/s") && d.output.frames_every.value == 0.01);
    release(&o);
}

static void fractions_by_mass_become_fractions_by_number(void)
{
    outcome o = read_changed("diameter: 3 mm", "sizes: [{diameter: 1 mm, fraction: 50 %}, "
                                               "{diameter: 2 mm, fraction: 50 %}]");
    CHECK(o.status == QN_OK && o.def.groups[0].size_count == 2);
    CHECK_NEAR(o.def.groups[0].fraction[0], 8.0 / 9, 1e-15);
    CHECK_NEAR(o.def.groups[0].fraction[1], 1.0 / 9, 1e-15);
    release(&o);
}

static void clumps_are_read_as_they_are_meant(void)
{
    outcome o = read_changed("count: 2500", "count: 2500, shape: tetrahedron, spacing: 1.2");
    CHECK(o.status == QN_OK && o.def.shape_count == 1);
    const qn_group_def *g = o.def.groups;
    CHECK(g->shape == 1 && g->turned_at_random && o.def.shapes[0].count == 4);
    CHECK(o.def.shapes[0].is_round);
    release(&o);
    qn_def def;
    qn_messages messages = {0};
    CHECK(qn_scene_read(QUERN_SOURCE_DIR "/scenes/clumps.yaml", &def, NULL, &messages) == QN_OK);
    CHECK(def.shape_count == 2 && def.groups[0].shape == 0);
    CHECK(def.groups[1].shape == 1 && def.groups[2].shape == 2);
    const qn_shape *rod = &def.shapes[1];
    CHECK(rod->count == 3 && !rod->is_round);
    double across = rod->radius[1] / rod->radius[0];
    CHECK_NEAR(across, 1 / 0.9, 1e-11);
    qn_def_free(&def);
    qn_messages_free(&messages);
    o = read_changed("count: 2500", "at: 0 0 4 mm, shape: tetrahedron, turned: 0 0 90 deg");
    CHECK(o.status == QN_OK && !o.def.groups[0].turned_at_random);
    CHECK_NEAR(o.def.groups[0].turned.z, QN_PI / 2, 1e-15);
    release(&o);
}

static void a_distribution_becomes_classes_by_number(void)
{
    outcome o =
        read_changed("diameter: 3 mm", "distribution: {kind: gaudin-schuhmann, by: number, "
                                       "top: 4 mm, m: 1, min: 1 mm, max: 4 mm, classes: 2}");
    const qn_group_def *g = &o.def.groups[0];
    CHECK(o.status == QN_OK && g->size_count == 2);
    CHECK_NEAR(g->fraction[0], 1.0 / 3, 1e-12);
    CHECK_NEAR(g->diameter[1], cbrt((256 - 16) / 4.0 / 2) * 1e-3, 1e-12);
    release(&o);
}

static void a_schedule_gives_every_leg(void)
{
    outcome o = read_changed("  speed: 70 %critical\n  ramp: 0.5 s\n",
                             "  schedule:\n    - {duration: 1 s, at: 0 rpm}\n"
                             "    - {duration: 2 s, to: 30 rpm}\n    - {at: 60 rpm}\n");
    const qn_drum_def *d = &o.def.drum;
    CHECK(o.status == QN_OK && d->leg_count == 3);
    CHECK(d->legs[0].to == 0 && d->legs[1].from == 0 && isinf(d->legs[2].duration));
    CHECK_NEAR(d->legs[1].to, QN_PI, 1e-15);
    CHECK_NEAR(d->legs[2].from, 2 * QN_PI, 1e-15);
    release(&o);
}

static void a_box_is_six_planes_that_face_inwards(void)
{
    outcome o =
        read_changed("particles:\n", "walls:\n  room: {shape: box, material: glass, low: 0 0 0 m, "
                                     "high: 1 2 3 m}\nparticles:\n");
    CHECK(o.status == QN_OK && o.def.plane_count == 6);
    qn_vec3 middle = qn_v3(0.5, 1, 1.5);
    for (int i = 0; i < 6; i++)
        CHECK(qn_dot(qn_sub(middle, o.def.planes[i].point), o.def.planes[i].normal) > 0);
    CHECK(!strcmp(o.def.planes[3].name, "room_y1"));
    release(&o);
}

static bool same_def(const qn_def *a, const qn_def *b)
{
    size_t materials = (size_t)a->material_count * sizeof *a->materials;
    size_t contacts = (size_t)a->contact_count * sizeof *a->contacts;
    return a->material_count == b->material_count && a->contact_count == b->contact_count
           && !memcmp(a->materials, b->materials, materials)
           && !memcmp(a->contacts, b->contacts, contacts)
           && !memcmp(a->drum.legs, b->drum.legs, sizeof a->drum.legs)
           && a->drum.lifter_base == b->drum.lifter_base && a->drum.length == b->drum.length
           && a->groups[0].amount == b->groups[0].amount
           && a->groups[0].padding == b->groups[0].padding
           && !memcmp(&a->measure, &b->measure, sizeof a->measure) && a->seed == b->seed
           && a->end.value == b->end.value && a->end.unit == b->end.unit;
}

static void a_resolved_scene_reads_as_the_same_scene(void)
{
    outcome o = read_changed("0.66", "0.66, rolling_friction: 0.01"), again = {0};
    char *text;
    CHECK_STATUS(o.status);
    CHECK_STATUS(qn_scene_resolved(&o.def, &text));
    again.status =
        qn_scene_read_text(text, strlen(text), "r.yaml", NULL, &again.def, &again.messages);
    if (again.messages.text) printf("%s\n%s", text, again.messages.text);
    bool same = again.status == QN_OK && same_def(&o.def, &again.def);
    free(text);
    release(&o);
    release(&again);
    CHECK(same);
}

static void a_lining_is_a_list_of_spheres_along_the_shell(void)
{
    static const char *const lifters =
        "  lifters: {count: 16, height: 6 mm, top: 6 mm, face_angle: 45 deg}\nparticles:\n";
    outcome o = read_changed(lifters, "particles:\n  lining: {material: glass, diameter: 3 mm, "
                                      "fill: lining, turning: yes}\n");
    char *text = NULL;
    CHECK_STATUS(o.status);
    const qn_group_def *g = &o.def.groups[0];
    CHECK(g->turning && !g->fixed && g->lining && g->packing == QN_PACK_LIST);
    CHECK(g->list_count == 311 * 4);
    CHECK_NEAR(hypot(g->list_position[3000], g->list_position[3001]), 0.1485, 1e-15);
    CHECK_STATUS(qn_scene_resolved(&o.def, &text));
    CHECK(strstr(text, "    turning: yes\n    fill: lining\n    diameter: 0.003"));
    free(text);
    release(&o);
    o = read_changed(lifters, "particles:\n  lining: {material: glass, diameter: 160 mm, "
                              "fill: lining, turning: yes}\n");
    CHECK(o.status == QN_INPUT);
    CHECK(strstr(o.messages.text,
                 "makes a lining of 0 spheres around and 0 rings; at least 3 and 2"));
    release(&o);
}

static void every_shipped_scene_is_a_good_scene(void)
{
    glob_t found;
    CHECK(glob(QUERN_SOURCE_DIR "/scenes/*.yaml", 0, NULL, &found) == 0);
    bool all = true;
    for (size_t i = 0; i < found.gl_pathc; i++) {
        outcome o = {0};
        o.status = qn_scene_read(found.gl_pathv[i], &o.def, NULL, &o.messages);
        if (o.messages.text) printf("%s", o.messages.text);
        all = all && o.status == QN_OK;
        release(&o);
    }
    globfree(&found);
    CHECK(all);
}

static void every_template_is_a_good_scene(void)
{
    static const char *const names[] = {"mill", "drop"};
    for (int i = 0; i < 2; i++) {
        const char *text = qn_scene_template(names[i]);
        outcome o = {0};
        CHECK(text != NULL);
        o.status = qn_scene_read_text(text, strlen(text), "t.yaml", NULL, &o.def, &o.messages);
        if (o.messages.text) printf("%s", o.messages.text);
        CHECK_STATUS(o.status);
        release(&o);
    }
    CHECK(qn_scene_template("mil") == NULL);
}

static void the_reference_names_every_key(void)
{
    char *text, row[64];
    CHECK_STATUS(qn_scene_reference(NULL, true, &text));
    bool all = true;
    for (int s = 0; s < QN_SECTION_COUNT; s++)
        for (int k = 0; k < qn_sections[s].key_count; k++) {
            snprintf(row, sizeof row, "| `%s` |", qn_sections[s].keys[k].name);
            all = all && strstr(text, row);
        }
    free(text);
    CHECK(all);
}

static void docs_scene_md_is_the_reference(void)
{
    char *text;
    CHECK_STATUS(qn_scene_reference(NULL, true, &text));
    FILE *file = fopen(QUERN_SOURCE_DIR "/docs/scene.md", "rb");
    size_t size = strlen(text);
    char *page = calloc(1, size + 2);
    bool same = file && page && fread(page, 1, size + 1, file) == size && !memcmp(page, text, size);
    if (file) fclose(file);
    free(page);
    free(text);
    CHECK(same);  // if not: quern help scene --markdown > docs/scene.md
}

/// First line of the messages of a file with this content, "" where there is none.
static qn_status read_file(const char *path, char *line, size_t size)
{
    qn_def def;
    qn_messages messages = {0};
    qn_status status = qn_scene_read(path, &def, NULL, &messages);
    const char *text = messages.text ? messages.text : "";
    snprintf(line, size, "%.*s", (int)strcspn(text, "\n"), text);
    qn_messages_free(&messages);
    qn_def_free(&def);
    return status;
}

static bool write_file(const char *path, const char *bytes, size_t length)
{
    FILE *file = fopen(path, "wb");
    bool written = file && fwrite(bytes, 1, length, file) == length;
    return file && fclose(file) == 0 && written;
}

static void what_is_no_scene_at_all_is_refused(void)
{
    char line[512];
    CHECK(write_file("empty.yaml", "", 0));
    CHECK(read_file("empty.yaml", line, sizeof line) == QN_INPUT);
    CHECK(!strcmp(line, "empty.yaml: error: the file is empty"));
    CHECK(write_file("binary.yaml",
                     "\x7f"
                     "ELF\0\1",
                     6));
    CHECK(read_file("binary.yaml", line, sizeof line) == QN_INPUT);
    CHECK(!strcmp(line,
                  "binary.yaml: error: not a text file: byte 1 is 0x7f; a scene is plain text "
                  "(YAML)"));
    CHECK(write_file("latin1.yaml", "title: K\xfchl\n", 12));
    CHECK(read_file("latin1.yaml", line, sizeof line) == QN_INPUT);
    CHECK(mkdir("folder.yaml", 0777) == 0 || access("folder.yaml", F_OK) == 0);
    CHECK(read_file("folder.yaml", line, sizeof line) == QN_INPUT);
    CHECK(!strcmp(line, "folder.yaml: error: is a folder, not a scene"));
    CHECK(read_file("nothing.yaml", line, sizeof line) == QN_INPUT);
    CHECK(!strcmp(line, "nothing.yaml: error: No such file or directory"));
    CHECK(write_file("large.yaml", "", 0) && truncate("large.yaml", 100000000) == 0);
    CHECK(read_file("large.yaml", line, sizeof line) == QN_INPUT);
    CHECK(!strcmp(line, "large.yaml: error: is larger than 1 MB, which no scene needs"));
    unlink("large.yaml");
}

static void no_more_than_fifty_errors_are_told(void)
{
    char *text = calloc(1, 5000);
    CHECK(text != NULL);
    for (int i = 0; i < 200; i++) sprintf(text + strlen(text), "key%d: 1\n", i);
    qn_def def;
    qn_messages messages = {0};
    qn_status status = qn_scene_read_text(text, strlen(text), "s.yaml", NULL, &def, &messages);
    int errors = messages.errors;
    qn_messages_free(&messages);
    free(text);
    CHECK(status == QN_INPUT && errors == QN_ERRORS_MAX);
}

int main(int argc, char **argv)
{
    TEST(the_scene_without_a_fault_is_read_as_it_is_meant);
    TEST(what_is_wrong_gets_its_place_and_sentence);
    TEST(the_caret_stands_under_the_value);
    TEST(one_mistake_is_one_error);
    TEST(all_errors_come_in_one_go);
    TEST(no_more_than_fifty_errors_are_told);
    TEST(what_is_no_scene_at_all_is_refused);
    TEST(fractions_by_mass_become_fractions_by_number);
    TEST(clumps_are_read_as_they_are_meant);
    TEST(a_distribution_becomes_classes_by_number);
    TEST(a_schedule_gives_every_leg);
    TEST(a_box_is_six_planes_that_face_inwards);
    TEST(a_resolved_scene_reads_as_the_same_scene);
    TEST(a_lining_is_a_list_of_spheres_along_the_shell);
    TEST(every_shipped_scene_is_a_good_scene);
    TEST(every_template_is_a_good_scene);
    TEST(the_reference_names_every_key);
    TEST(docs_scene_md_is_the_reference);
    DONE;
}
