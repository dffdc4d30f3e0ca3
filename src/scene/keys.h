// SPDX-License-Identifier: Apache-2.0
// Every key a scene can have, one row each. The reader, the checks of kind, unit and range,
// `quern help scene` and docs/scene.md all come from these lists, and so do the structs that hold the
// values: struct qn_drum_keys has a member for each row of QN_DRUM_KEYS.
//
// units    QN_IN_... bits (units.h)
// range    an interval in SI units, ] and [ meaning that the end is not part of it; "" for any
// words    for WORD the choices; for the others a word that may stand in for the value
// default  as it would be written; REQUIRED must be written; "" may be left out
// resume   FIXED: a run can only go on with the value it began with, because its motion or the sums in
//          its checkpoints depend on it; FREE: it may go on with another
#ifndef QN_SCENE_KEYS_H
#define QN_SCENE_KEYS_H

#include "base/sizes.h"
#include "physics/laws.h"
#include "physics/scheme.h"
#include "scene/tree.h"
#include "scene/units.h"

#define REQUIRED "!"

/// The texts of all size distributions, each with a space behind it.
#define QN_SIZE_WORD(NAME, text, first, second, meaning) text " "
#define QN_SIZE_WORDS QN_SIZE_KINDS(QN_SIZE_WORD)

typedef enum qn_resume { QN_RESUME_FIXED, QN_RESUME_FREE } qn_resume;

/// The texts of all contact laws, their models and the schemes, each with a space behind it;
/// L, N, D, C, T, R and Z must take the text out of a row.
#define QN_LAW_WORDS QN_LAWS(L)
#define QN_NORMAL_WORDS QN_NORMALS(N)
#define QN_DAMPING_WORDS QN_DAMPINGS(D)
#define QN_COHESION_WORDS QN_COHESIONS(C)
#define QN_TANGENTIAL_WORDS QN_TANGENTIALS(T)
#define QN_ROLLING_WORDS QN_ROLLINGS(R)
#define QN_SCHEME_WORDS QN_SCHEMES(Z)

// clang-format off
//    NAME       what a person writes
#define QN_KINDS(X)                     \
    X(NUMBER,    "number")              \
    X(WHOLE,     "whole number")        \
    X(NUMBERS,   "numbers")             \
    X(VECTOR,    "three numbers")       \
    X(YESNO,     "yes or no")           \
    X(WORD,      "word")                \
    X(TEXT,      "text")                \
    X(FILE,      "file name")           \
    X(UNIT,      "unit of length")      \
    X(MATERIAL,  "material")            \
    X(MAP,       "keys")                \
    X(LIST,      "list of keys")        \
    X(NAMES,     "names with keys")

//    key                 kind     units         range        words               default           resume meaning
#define QN_SCENE_KEYS(K)                                                                                                            \
    K(format,             WORD,    PURE,         "",          "quern-scene/1",    REQUIRED,         FIXED, "what this file is")             \
    K(title,              TEXT,    PURE,         "",          "",                 "",               FREE,  "what the scene shows")          \
    K(gravity,            VECTOR,  ACCELERATION, "",          "",                 "0 -9.81 0 m/s2", FIXED, "acceleration of gravity")       \
    K(seed,               WHOLE,   PURE,         "[0, 9e15]", "",                 "1",              FIXED, "of everything random")          \
    K(time,               MAP,     PURE,         "",          "",                 REQUIRED,         FIXED, "how long, and in what steps")   \
    K(materials,          NAMES,   PURE,         "",          "",                 REQUIRED,         FIXED, "what things are made of")       \
    K(contacts,           NAMES,   PURE,         "",          "",                 "",               FIXED, "the law between two materials, for every two that can touch") \
    K(drum,               MAP,     PURE,         "",          "",                 "",               FIXED, "a drum about the z axis, from z = 0 to its length") \
    K(walls,              NAMES,   PURE,         "",          "",                 "",               FIXED, "planes, boxes and meshes")      \
    K(particles,          NAMES,   PURE,         "",          "",                 REQUIRED,         FIXED, "groups of particles")             \
    K(feeds,              NAMES,   PURE,         "",          "",                 "",               FIXED, "where particles come in while running") \
    K(outlets,            NAMES,   PURE,         "",          "",                 "",               FIXED, "where particles leave while running") \
    K(measure,            MAP,     PURE,         "",          "",                 "",               FIXED, "what is observed while running") \
    K(output,             MAP,     PURE,         "",          "",                 "",               FIXED, "what is written, and where")    \
    K(numerics,           MAP,     PURE,         "",          "",                 "",               FIXED, "for the expert")

#define QN_TIME_KEYS(K)                                                                                                             \
    K(end,                NUMBER,  SPAN,         "]0, inf[",  "",                 REQUIRED,         FREE,  "end of the run, counted from its start") \
    K(step,               NUMBER,  TIME,         "]0, inf[",  "auto",             "auto",           FIXED, "time step; auto: from the Rayleigh and Hertz times") \
    K(rayleigh_fraction,  NUMBER,  SHARE,        "]0, 1]",    "",                 "0.2",            FIXED, "most of the Rayleigh time that an automatic step takes")

#define QN_MATERIAL_KEYS(K)                                                                                                         \
    K(like,               MATERIAL, PURE,        "",          "",                 "",               FIXED, "a material above that gives what is not written here") \
    K(young,              NUMBER,  PRESSURE,     "]0, inf[",  "",                 "",               FIXED, "Young's modulus; this or shear") \
    K(shear,              NUMBER,  PRESSURE,     "]0, inf[",  "",                 "",               FIXED, "shear modulus; this or young")  \
    K(poisson,            NUMBER,  PURE,         "]-1, 0.5]", "",                 REQUIRED,         FIXED, "Poisson's ratio")               \
    K(density,            NUMBER,  DENSITY,      "]0, inf[",  "",                 REQUIRED,         FIXED, "density of the solid")

#define QN_CONTACT_KEYS(K)                                                                                                          \
    K(law,                WORD,    PURE,         "",          QN_LAW_WORDS,       "hertz-mindlin",  FIXED, "contact law: a set of models by one name") \
    K(normal,             WORD,    PURE,         "",          QN_NORMAL_WORDS,    "",               FIXED, "spring, instead of the law's")  \
    K(damping,            WORD,    PURE,         "",          QN_DAMPING_WORDS,   "",               FIXED, "normal damping, instead of the law's") \
    K(cohesion,           WORD,    PURE,         "",          QN_COHESION_WORDS,  "none",           FIXED, "what pulls touching spheres together") \
    K(tangential,         WORD,    PURE,         "",          QN_TANGENTIAL_WORDS, "",              FIXED, "friction, instead of the law's") \
    K(rolling,            WORD,    PURE,         "",          QN_ROLLING_WORDS,   "",               FIXED, "rolling resistance; constant if not written and there is a rolling_friction") \
    K(friction,           NUMBER,  SHARE,        "[0, inf[",  "",                 "",               FIXED, "Coulomb's coefficient of friction; required, but for tangential none") \
    K(restitution,        NUMBER,  SHARE,        "]0, 1]",    "",                 "",               FIXED, "coefficient of restitution, a ratio of speeds; required, but for damping none") \
    K(stiffness,          NUMBER,  STIFFNESS,    "]0, inf[",  "",                 "",               FIXED, "of a linear spring; this or impact_speed") \
    K(impact_speed,       NUMBER,  VELOCITY,     "]0, inf[",  "",                 "",               FIXED, "at which a linear spring is as stiff as Hertz's, and at which hunt-crossley gives the restitution") \
    K(surface_energy,     NUMBER,  SURFACE,      "]0, inf[",  "",                 "",               FIXED, "energy of each of the two surfaces; cohesion dmt") \
    K(tangential_ratio,   NUMBER,  SHARE,        "]0, inf[",  "",                 "0.2857142857142857", FIXED, "tangential over normal stiffness, 2/7; tangential linear") \
    K(tangential_damping, NUMBER,  DASHPOT,      "]0, inf[",  "",                 "",               FIXED, "force per sliding speed; tangential viscous") \
    K(rolling_friction,   NUMBER,  SHARE,        "[0, inf[",  "",                 "",               FIXED, "torque against rolling, over normal force and effective radius; rolling constant, epsd, thesis") \
    K(rolling_viscosity,  NUMBER,  SLOWNESS,     "]0, inf[",  "",                 "",               FIXED, "the same per rolling speed; rolling viscous") \
    K(rolling_damping,    NUMBER,  SHARE,        "[0, inf[",  "",                 "0.3",            FIXED, "damping ratio of the rolling spring; rolling epsd") \
    K(rolling_slope,      NUMBER,  IMPULSE,      "]0, inf[",  "",                 "1 N s",          FIXED, "normal force the rolling resistance takes for each rad/s; rolling thesis") \
    K(clip,               YESNO,   PURE,         "",          "",                 "",               FIXED, "no attraction before separation; the law's own choice if not written")

#define QN_DRUM_KEYS(K)                                                                                                             \
    K(name,               TEXT,    PURE,         "",          "",                 "drum",           FIXED, "as it appears in results")      \
    K(diameter,           NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "inside the shell")              \
    K(length,             NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "along the axis")                \
    K(material,           MATERIAL, PURE,        "",          "",                 REQUIRED,         FIXED, "of shell and lifters")          \
    K(ends,               WORD,    PURE,         "",          "periodic fixed turning", "periodic", FIXED, "periodic: a slice of a long drum; else flat walls") \
    K(end_material,       MATERIAL, PURE,        "",          "",                 "",               FIXED, "of the ends; the shell's if not written") \
    K(speed,              NUMBER,  SPEED,        "",          "",                 "",               FIXED, "positive about +z; %critical is of sqrt(2 g / diameter); this or schedule") \
    K(settle,             NUMBER,  TIME,         "[0, inf[",  "",                 "0 s",            FIXED, "at rest before it turns")       \
    K(ramp,               NUMBER,  TIME,         "[0, inf[",  "",                 "0 s",            FIXED, "then linearly up to speed")     \
    K(schedule,           LIST,    PURE,         "",          "",                 "",               FIXED, "legs of speed, one after another; this or speed") \
    K(lifters,            MAP,     PURE,         "",          "",                 "",               FIXED, "bars along the shell")          \
    K(corner,             WORD,    PURE,         "",          "exact shared",     "exact",          FIXED, "of the profile: exact: one stretch or corner acts; shared: each stretch acts with a share") \
    K(profile,            FILE,    PURE,         "",          "",                 "",               FIXED, "points of a closed cross-section that replaces shell and lifters") \
    K(profile_unit,       UNIT,    PURE,         "",          "",                 "mm",             FIXED, "of the profile's numbers")

#define QN_LIFTERS_KEYS(K)                                                                                                          \
    K(count,              WHOLE,   PURE,         "[1, 1000]", "",                 REQUIRED,         FIXED, "evenly around the shell")       \
    K(height,             NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "above the shell")               \
    K(top,                NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "width of the top")              \
    K(base,               NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "width at the shell; as wide as the top if not written") \
    K(face_angle,         NUMBER,  ANGLE,        "]0, 1.5707963267948966]", "",   "",               FIXED, "between side face and shell, 90 deg is rectangular; instead of base")

#define QN_LEG_KEYS(K)                                                                                                              \
    K(duration,           NUMBER,  TIME,         "]0, inf[",  "",                 "",               FIXED, "of the leg; the last may go on for ever") \
    K(from,               NUMBER,  SPEED,        "",          "",                 "",               FIXED, "speed at its start; where the leg before ended if not written") \
    K(to,                 NUMBER,  SPEED,        "",          "",                 "",               FIXED, "speed at its end, reached linearly") \
    K(at,                 NUMBER,  SPEED,        "",          "",                 "",               FIXED, "constant speed, instead of from and to")

#define QN_PLANE_KEYS(K)                                                                                                            \
    K(shape,              WORD,    PURE,         "",          "plane",            REQUIRED,         FIXED, "an infinite plane")             \
    K(material,           MATERIAL, PURE,        "",          "",                 REQUIRED,         FIXED, "of the wall")                   \
    K(motion,             MAP,     PURE,         "",          "",                 "",               FIXED, "how it moves; at rest if not written") \
    K(point,              VECTOR,  LENGTH,       "",          "",                 "0 0 0 m",        FIXED, "on the plane")                  \
    K(normal,             VECTOR,  PURE,         "",          "",                 REQUIRED,         FIXED, "to the side where particles live; any length")

#define QN_BOX_KEYS(K)                                                                                                              \
    K(shape,              WORD,    PURE,         "",          "box",              REQUIRED,         FIXED, "six planes, particles inside") \
    K(material,           MATERIAL, PURE,        "",          "",                 REQUIRED,         FIXED, "of the walls")                  \
    K(motion,             MAP,     PURE,         "",          "",                 "",               FIXED, "how it moves; at rest if not written") \
    K(low,                VECTOR,  LENGTH,       "",          "",                 REQUIRED,         FIXED, "corner with the smallest x, y and z") \
    K(high,               VECTOR,  LENGTH,       "",          "",                 REQUIRED,         FIXED, "corner with the largest x, y and z")

#define QN_MESH_KEYS(K)                                                                                                             \
    K(shape,              WORD,    PURE,         "",          "mesh",             REQUIRED,         FIXED, "triangles from a file, acting on both sides") \
    K(material,           MATERIAL, PURE,        "",          "",                 REQUIRED,         FIXED, "of the wall")                   \
    K(file,               FILE,    PURE,         "",          "",                 REQUIRED,         FIXED, "STL, OBJ, PLY or text, relative to the scene") \
    K(unit,               UNIT,    PURE,         "",          "",                 "mm",             FIXED, "of the file's numbers")         \
    K(turning,            YESNO,   PURE,         "",          "",                 "no",             FIXED, "with the drum; instead of motion") \
    K(motion,             MAP,     PURE,         "",          "",                 "",               FIXED, "how it moves; at rest if not written")

#define QN_MOTION_KEYS(K)                                                                                                           \
    K(kind,               WORD,    PURE,         "",          "rotate swing translate oscillate", REQUIRED, FIXED, "about an axis, or along a direction; swing and oscillate go to and fro") \
    K(axis,               VECTOR,  PURE,         "",          "",                 "0 0 1",          FIXED, "rotate, swing: the axis turned about, right-handed; any length") \
    K(through,            VECTOR,  LENGTH,       "",          "",                 "0 0 0 m",        FIXED, "rotate, swing: a point on the axis") \
    K(direction,          VECTOR,  PURE,         "",          "",                 "",               FIXED, "translate, oscillate: the way it goes; any length") \
    K(speed,              NUMBER,  RATE,         "",          "",                 "",               FIXED, "rotate (rpm), translate (m/s); this or schedule") \
    K(schedule,           LIST,    PURE,         "",          "",                 "",               FIXED, "rotate, translate: legs of speed, one after another; this or speed") \
    K(settle,             NUMBER,  TIME,         "[0, inf[",  "",                 "0 s",            FIXED, "at rest before it moves")       \
    K(ramp,               NUMBER,  TIME,         "[0, inf[",  "",                 "0 s",            FIXED, "rotate, translate: then linearly up to speed") \
    K(amplitude,          NUMBER,  WAY,          "]0, inf[",  "",                 "",               FIXED, "swing (deg), oscillate (mm): half the way from end to end") \
    K(frequency,          NUMBER,  FREQUENCY,    "]0, inf[",  "",                 "",               FIXED, "swing, oscillate")              \
    K(phase,              NUMBER,  ANGLE,        "",          "",                 "0 rad",          FIXED, "swing, oscillate: at the start, where it stands as defined; at 90 deg it starts from rest")

#define QN_STRETCH_KEYS(K)                                                                                                          \
    K(duration,           NUMBER,  TIME,         "]0, inf[",  "",                 "",               FIXED, "of the leg; the last may go on for ever") \
    K(from,               NUMBER,  RATE,         "",          "",                 "",               FIXED, "speed at its start; where the leg before ended if not written") \
    K(to,                 NUMBER,  RATE,         "",          "",                 "",               FIXED, "speed at its end, reached linearly") \
    K(at,                 NUMBER,  RATE,         "",          "",                 "",               FIXED, "constant speed, instead of from and to")

#define QN_GROUP_KEYS(K)                                                                                                            \
    K(material,           MATERIAL, PURE,        "",          "",                 REQUIRED,         FIXED, "of the spheres")                \
    K(shape,              WORD,    PURE,         "",          "sphere tetrahedron file", "sphere",  FIXED, "spheres; or clumps, rigid bodies of four spheres or of those in shape_file: their diameter is that of the sphere of equal volume") \
    K(spacing,            NUMBER,  PURE,         "]0, 4]",    "",                 "1",              FIXED, "between the centres of a tetrahedron's spheres, in their radii") \
    K(shape_file,         FILE,    PURE,         "",          "",                 "",               FIXED, "CSV of a clump's spheres: x y z radius, in any unit as diameter gives the size") \
    K(turned,             VECTOR,  ANGLE,        "",          "",                 "",               FIXED, "clumps: rotation vector from the template; if not written, none with at and file, random otherwise") \
    K(diameter,           NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "of every sphere; this, sizes or distribution") \
    K(sizes,              LIST,    PURE,         "",          "",                 "",               FIXED, "sizes one by one")              \
    K(distribution,       MAP,     PURE,         "",          "",                 "",               FIXED, "sizes by a formula, in classes") \
    K(fractions_by,       WORD,    PURE,         "",          "number mass",      "mass",           FIXED, "what the fractions of sizes count") \
    K(fixed,              YESNO,   PURE,         "",          "",                 "no",             FIXED, "never moves, whatever touches it") \
    K(turning,            YESNO,   PURE,         "",          "",                 "no",             FIXED, "moves with the drum, whatever touches it") \
    K(fill,               WORD,    PURE,         "",          "hcp grid file at feed lining", "hcp", FIXED, "hexagonal packing, cubic grid, from a file, one sphere, none at the start and later from a feed, or side by side along a smooth shell; file and at if those keys are there. hcp and grid take the places that are clear of walls, on both sides of a mesh, in the drum or in a box of planes") \
    K(count,              WHOLE,   PURE,         "[1, 2e9]",  "",                 "",               FIXED, "how many particles; hcp and grid need one of count, filling, mass") \
    K(filling,            NUMBER,  SHARE,        "]0, 1]",    "",                 "",               FIXED, "share of the drum's volume that the bed at rest takes, voids included") \
    K(mass,               NUMBER,  MASS,         "]0, inf[",  "",                 "",               FIXED, "of all particles together")       \
    K(padding,            NUMBER,  SHARE,        "[0, 10]",   "",                 "2 %",            FIXED, "room left around each sphere or the sphere around each clump, of its radius") \
    K(jitter,             NUMBER,  SHARE,        "[0, 1]",    "",                 "0",              FIXED, "random displacement, as a share of the padding") \
    K(file,               FILE,    PURE,         "",          "",                 "",               FIXED, "CSV, raw binary, or a frame or checkpoint of Quern, relative to the scene") \
    K(file_unit,          UNIT,    PURE,         "",          "",                 "m",              FIXED, "of the file's lengths")         \
    K(at,                 VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "centre of the one sphere, centre of mass of the one clump")      \
    K(velocity,           VECTOR,  VELOCITY,     "",          "",                 "0 0 0 m/s",      FIXED, "at the start")                  \
    K(spin,               VECTOR,  SPIN,         "",          "",                 "0 0 0 rad/s",    FIXED, "at the start")

#define QN_SIZE_KEYS(K)                                                                                                             \
    K(diameter,           NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "of these spheres")              \
    K(fraction,           NUMBER,  SHARE,        "]0, inf[",  "",                 REQUIRED,         FIXED, "by mass or number, as fractions_by says; only ratios matter")

#define QN_DISTRIBUTION_KEYS(K)                                                                                                     \
    K(kind,               WORD,    PURE,         "",          QN_SIZE_WORDS,      REQUIRED,         FIXED, "formula of the share that is smaller than a diameter d") \
    K(by,                 WORD,    PURE,         "",          "mass number",      "mass",           FIXED, "what that share counts")        \
    K(mean,               NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "normal: mean")                  \
    K(deviation,          NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "normal: standard deviation")    \
    K(median,             NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "lognormal: half is smaller")    \
    K(sigma,              NUMBER,  PURE,         "]0, 10]",   "",                 "",               FIXED, "lognormal: standard deviation of ln d") \
    K(d63,                NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "rosin-rammler, 1 - exp(-(d/d63)^n): 63.2 % is smaller") \
    K(n,                  NUMBER,  PURE,         "]0, 100]",  "",                 "",               FIXED, "rosin-rammler: exponent")       \
    K(top,                NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "gaudin-schuhmann, (d/top)^m: all is smaller") \
    K(m,                  NUMBER,  PURE,         "]0, 100]",  "",                 "",               FIXED, "gaudin-schuhmann: exponent")    \
    K(min,                NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "nothing is smaller")            \
    K(max,                NUMBER,  LENGTH,       "]0, inf[",  "",                 REQUIRED,         FIXED, "nothing is larger")             \
    K(classes,            WHOLE,   PURE,         "[1, 64]",   "",                 "12",             FIXED, "equal steps of ln d between min and max, each with one diameter that keeps its number and mass")

#define QN_FEED_KEYS(K)                                                                                                             \
    K(particles,          TEXT,    PURE,         "",          "",                 REQUIRED,         FIXED, "group of balls, not clumps, whose material, sizes, padding and spin it gives, at places drawn by the seed") \
    K(rate,               NUMBER,  FEED_RATE,    "]0, inf[",  "",                 REQUIRED,         FIXED, "by mass or by number")          \
    K(low,                VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "corner of a box in which particles appear") \
    K(high,               VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "opposite corner")               \
    K(centre,             VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "of a disc in which they appear, instead of a box") \
    K(radius,             NUMBER,  LENGTH,       "]0, inf[",  "",                 "",               FIXED, "of the disc")                   \
    K(normal,             VECTOR,  PURE,         "",          "",                 "0 0 1",          FIXED, "of the disc")                   \
    K(velocity,           VECTOR,  VELOCITY,     "",          "",                 "0 0 0 m/s",      FIXED, "with which they appear")        \
    K(start,              NUMBER,  TIME,         "[0, inf[",  "",                 "0 s",            FIXED, "of the feed")                   \
    K(stop,               NUMBER,  TIME,         "]0, inf[",  "never",            "never",          FIXED, "of the feed")

#define QN_OUTLET_KEYS(K)                                                                                                           \
    K(low,                VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "corner of a box; what has its centre in it leaves") \
    K(high,               VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "opposite corner")               \
    K(point,              VECTOR,  LENGTH,       "",          "",                 "",               FIXED, "of a plane, instead of a box; what has its centre beyond it leaves") \
    K(normal,             VECTOR,  PURE,         "",          "",                 "",               FIXED, "of the plane, the way out")     \
    K(radius,             NUMBER,  LENGTH,       "]0, inf[",  "all",              "all",            FIXED, "of the open part of the plane, about its point") \
    K(aperture,           NUMBER,  LENGTH,       "]0, inf[",  "none",             "none",           FIXED, "of a screen in the plane: what is smaller leaves when it touches it; it neither opens nor draws a wall: put it in the surface of one, which holds back what is larger")

#define QN_MEASURE_KEYS(K)                                                                                                          \
    K(series,             NUMBER,  SPAN,         "]0, inf[",  "",                 "1 ms",           FREE,  "between rows of the time series") \
    K(fields,             MAP,     PURE,         "",          "",                 "",               FIXED, "voxel fields of porosity and velocity; needs a drum") \
    K(traces,             MAP,     PURE,         "",          "",                 "",               FIXED, "particles followed one by one")

#define QN_FIELDS_KEYS(K)                                                                                                           \
    K(every,              NUMBER,  SPAN,         "]0, inf[",  "",                 "300 steps",      FIXED, "between samples")               \
    K(start,              NUMBER,  SPAN,         "[0, inf[",  "",                 REQUIRED,         FIXED, "of sampling, from the start of the run") \
    K(duration,           NUMBER,  SPAN,         "]0, inf[",  "",                 "1 rev",          FIXED, "of sampling")                   \
    K(cells,              NUMBERS, PURE,         "]0, 1000]", "",                 "1 2 4",          FIXED, "voxel sides in x and y, in radii of the largest sphere; a grid for each") \
    K(layers,             NUMBERS, PURE,         "[1, 10000]","",                 "1",              FIXED, "voxels along the axis, for all grids or for each")

#define QN_TRACES_KEYS(K)                                                                                                           \
    K(ids,                NUMBERS, PURE,         "[1, 9e15]", "",                 REQUIRED,         FREE,  "particles, numbered from 1")    \
    K(every,              NUMBER,  SPAN,         "]0, inf[",  "",                 "1 steps",        FREE,  "between rows")

#define QN_OUTPUT_KEYS(K)                                                                                                           \
    K(directory,          FILE,    PURE,         "",          "",                 "",               FREE,  "run folder; out/ and the scene's file name if not written") \
    K(frames,             NUMBER,  SPAN,         "]0, inf[",  "none",             "10 ms",          FREE,  "between frames for pictures and ParaView") \
    K(checkpoint,         NUMBER,  TIME,         "]0, inf[",  "",                 "60 s",           FREE,  "between checkpoints, by the wall clock") \
    K(keep,               WHOLE,   PURE,         "[1, 1000]", "",                 "3",              FREE,  "checkpoints that are kept")     \
    K(pictures,           YESNO,   PURE,         "",          "",                 "yes",            FREE,  "draw them at the end of the run")

#define QN_NUMERICS_KEYS(K)                                                                                                         \
    K(scheme,             WORD,    PURE,         "",          QN_SCHEME_WORDS,    "leapfrog",       FIXED, "time integration")              \
    K(skin,               NUMBER,  SHARE,        "]0, 10]",   "auto",             "auto",           FREE,  "of the pair list, in radii of the smallest sphere") \
    K(bed_solidity,       NUMBER,  SHARE,        "]0, 0.74]", "",                 "0.6",            FIXED, "solid share of a bed at rest, for filling")

//    NAME      lower     where it stands               what it is
#define QN_SECTIONS(S)                                                                     \
    S(SCENE,    scene,    "",                           "The whole file")                  \
    S(TIME,     time,     "time",                       "Time")                            \
    S(MATERIAL, material, "materials.NAME",             "Materials")                       \
    S(CONTACT,  contact,  "contacts.NAME-NAME",         "Contacts; `contacts.defaults` gives what pairs leave out") \
    S(DRUM,     drum,     "drum",                       "Drum")                            \
    S(LIFTERS,  lifters,  "drum.lifters",               "Lifters")                         \
    S(LEG,      leg,      "drum.schedule[]",            "Legs of a speed schedule")        \
    S(PLANE,    plane,    "walls.NAME (shape: plane)",  "Planes")                          \
    S(BOX,      box,      "walls.NAME (shape: box)",    "Boxes")                           \
    S(MESH,     mesh,     "walls.NAME (shape: mesh)",   "Meshes")                          \
    S(MOTION,   motion,   "walls.NAME.motion",          "How a wall moves")                \
    S(STRETCH,  stretch,  "walls.NAME.motion.schedule[]", "Legs of a wall's speed")        \
    S(GROUP,    group,    "particles.NAME",             "Particles")                       \
    S(SIZE,     size,     "particles.NAME.sizes[]",     "Sizes of a distribution")         \
    S(DISTRIBUTION, distribution, "particles.NAME.distribution", "Size distributions")     \
    S(FEED,     feed,     "feeds.NAME",                 "Feeds")                           \
    S(OUTLET,   outlet,   "outlets.NAME",               "Outlets")                         \
    S(MEASURE,  measure,  "measure",                    "Measurements")                    \
    S(FIELDS,   fields,   "measure.fields",             "Voxel fields")                    \
    S(TRACES,   traces,   "measure.traces",             "Traces")                          \
    S(OUTPUT,   output,   "output",                     "Output")                          \
    S(NUMERICS, numerics, "numerics",                   "Numerics")
// clang-format on

typedef enum qn_kind {
#define X(NAME, text) QN_KIND_##NAME,
    QN_KINDS(X)
#undef X
} qn_kind;

typedef enum qn_section_id {
#define S(NAME, lower, path, title) QN_SECTION_##NAME,
    QN_SECTIONS(S)
#undef S
        QN_SECTION_COUNT
} qn_section_id;

typedef struct qn_key {
    const char *name;
    qn_kind kind;
    unsigned units;
    const char *range, *words, *fallback;
    qn_resume resume;
    const char *meaning;
} qn_key;

typedef struct qn_section {
    const char *path, *title;
    const qn_key *keys;
    int key_count;
} qn_section;

extern const qn_section qn_sections[QN_SECTION_COUNT];

/// The value of a key, as read.
typedef struct qn_value {
    const qn_key *key;
    const char *path;       //   of its section, "" for the whole file
    const qn_node *node;    //   where it is written; NULL for a default
    qn_mark mark;           //   of the value, or of the section where it is not written
    bool set;               //   there is a valid value, written or default
    bool is_word;           //   the word that may stand in for the value
    double number;          //   SI; also of a whole number, a yes (1) and a unit's size
    int dimension;          //   of that number
    int choice;             //   index in `words`, or of a material
    double vector[3];       //   SI
    int count;              //   of numbers
    const double *numbers;  //  not owned
    const char *text;       //   as written; for a default as in the table
} qn_value;

#define K(name, kind, units, range, words, fallback, resume, meaning) qn_value name;
#define S(NAME, lower, path, title)    \
    typedef struct qn_##lower##_keys { \
        QN_##NAME##_KEYS(K)            \
    } qn_##lower##_keys;
QN_SECTIONS(S)
#undef S
#undef K
#undef L

/// The key of this name in the section that stands at `place`, written as the sections' paths are
/// ("materials.NAME"); NULL if there is none.
const qn_key *qn_key_find(const char *place, const char *name);

/// The range of a key as a sentence's part, in a unit (NULL for none): "above 0 and at most 90 deg".
void qn_key_range_text(const qn_key *key, const qn_unit *unit, char *text, size_t size);

/// Whether a number in SI units lies in the range of the key.
bool qn_key_allows(const qn_key *key, double number);

const char *qn_kind_text(qn_kind kind);

#endif
