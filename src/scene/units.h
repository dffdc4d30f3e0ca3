// SPDX-License-Identifier: Apache-2.0
// Units: what may stand behind a number in a scene, and what it is in SI.
//
// A value is number * times / over; the division keeps 3 mm the double nearest to 0.003.
#ifndef QN_SCENE_UNITS_H
#define QN_SCENE_UNITS_H

#include <stdbool.h>
#include <stddef.h>

// clang-format off
//    NAME           what it is
#define QN_DIMENSIONS(D)                            \
    D(PURE,         "a pure number")                \
    D(PERCENT,      "a share")                      \
    D(LENGTH,       "a length")                     \
    D(TIME,         "a time")                       \
    D(REVOLUTIONS,  "turns of the drum")            \
    D(STEPS,        "time steps")                   \
    D(MASS,         "a mass")                       \
    D(MASS_FLOW,    "a mass by time")               \
    D(DENSITY,      "a density")                    \
    D(PRESSURE,     "a pressure")                   \
    D(STIFFNESS,    "a spring stiffness")           \
    D(DASHPOT,      "a damping coefficient")        \
    D(IMPULSE,      "a force over a rate of turning") \
    D(SLOWNESS,     "one over a speed")             \
    D(SURFACE,      "a surface energy")             \
    D(ACCELERATION, "an acceleration")              \
    D(VELOCITY,     "a velocity")                   \
    D(SPIN,         "an angular velocity")          \
    D(CRITICAL,     "a share of the critical speed")\
    D(ANGLE,        "an angle")                     \
    D(FREQUENCY,    "a frequency")

//    dimension     name         times                    over
#define QN_UNITS(U)                                         \
    U(PERCENT,      "%",         1,                       100)  \
    U(LENGTH,       "m",         1,                       1)    \
    U(LENGTH,       "mm",        1,                       1e3)  \
    U(LENGTH,       "cm",        1,                       1e2)  \
    U(LENGTH,       "um",        1,                       1e6)  \
    U(LENGTH,       "in",        25.4,                    1e3)  \
    U(TIME,         "s",         1,                       1)    \
    U(TIME,         "ms",        1,                       1e3)  \
    U(TIME,         "us",        1,                       1e6)  \
    U(TIME,         "ns",        1,                       1e9)  \
    U(TIME,         "min",       60,                      1)    \
    U(TIME,         "h",         3600,                    1)    \
    U(REVOLUTIONS,  "rev",       1,                       1)    \
    U(STEPS,        "steps",     1,                       1)    \
    U(STEPS,        "step",      1,                       1)    \
    U(MASS,         "kg",        1,                       1)    \
    U(MASS,         "g",         1,                       1e3)  \
    U(MASS,         "mg",        1,                       1e6)  \
    U(MASS,         "t",         1e3,                     1)    \
    U(MASS_FLOW,    "kg/s",      1,                       1)    \
    U(MASS_FLOW,    "g/s",       1,                       1e3)  \
    U(MASS_FLOW,    "kg/h",      1,                       3600) \
    U(MASS_FLOW,    "t/h",       1e3,                     3600) \
    U(DENSITY,      "kg/m3",     1,                       1)    \
    U(DENSITY,      "g/cm3",     1e3,                     1)    \
    U(PRESSURE,     "Pa",        1,                       1)    \
    U(PRESSURE,     "kPa",       1e3,                     1)    \
    U(PRESSURE,     "MPa",       1e6,                     1)    \
    U(PRESSURE,     "GPa",       1e9,                     1)    \
    U(STIFFNESS,    "N/m",       1,                       1)    \
    U(STIFFNESS,    "kN/m",      1e3,                     1)    \
    U(STIFFNESS,    "MN/m",      1e6,                     1)    \
    U(STIFFNESS,    "N/mm",      1e3,                     1)    \
    U(DASHPOT,      "N s/m",     1,                       1)    \
    U(DASHPOT,      "Ns/m",      1,                       1)    \
    U(IMPULSE,      "N s",       1,                       1)    \
    U(IMPULSE,      "Ns",        1,                       1)    \
    U(SLOWNESS,     "s/m",       1,                       1)    \
    U(SURFACE,      "J/m2",      1,                       1)    \
    U(SURFACE,      "mJ/m2",     1,                       1e3)  \
    U(ACCELERATION, "m/s2",      1,                       1)    \
    U(ACCELERATION, "mm/s2",     1,                       1e3)  \
    U(VELOCITY,     "m/s",       1,                       1)    \
    U(VELOCITY,     "mm/s",      1,                       1e3)  \
    U(VELOCITY,     "cm/s",      1,                       1e2)  \
    U(SPIN,         "rad/s",     1,                       1)    \
    U(SPIN,         "rpm",       3.14159265358979323846,  30)   \
    U(SPIN,         "deg/s",     3.14159265358979323846,  180)  \
    U(CRITICAL,     "%critical", 1,                       100)  \
    U(ANGLE,        "deg",       3.14159265358979323846,  180)  \
    U(ANGLE,        "rad",       1,                       1)    \
    U(FREQUENCY,    "Hz",        1,                       1)    \
    U(FREQUENCY,    "kHz",       1e3,                     1)    \
    U(FREQUENCY,    "1/s",       1,                       1)    \
    U(FREQUENCY,    "1/min",     1,                       60)   \
    U(FREQUENCY,    "1/h",       1,                       3600)
// clang-format on

enum {
#define D(NAME, what) QN_DIMENSION_##NAME,
    QN_DIMENSIONS(D)
#undef D
        QN_DIMENSION_COUNT
};

/// What a key accepts: one bit for each dimension, and a few usual sets of them.
enum {
#define D(NAME, what) QN_IN_##NAME = 1 << QN_DIMENSION_##NAME,
    QN_DIMENSIONS(D)
#undef D
        QN_IN_SHARE = QN_IN_PURE | QN_IN_PERCENT,
    QN_IN_SPAN = QN_IN_TIME | QN_IN_REVOLUTIONS | QN_IN_STEPS,
    QN_IN_SPEED = QN_IN_SPIN | QN_IN_CRITICAL,
    QN_IN_RATE = QN_IN_SPIN | QN_IN_VELOCITY,
    QN_IN_WAY = QN_IN_ANGLE | QN_IN_LENGTH,
    QN_IN_FEED_RATE = QN_IN_MASS_FLOW | QN_IN_FREQUENCY,
};

typedef struct qn_unit {
    int dimension;
    const char *name;
    double times, over;
} qn_unit;

/// The unit of this name, of `length` bytes, or NULL; "m/s^2" is "m/s2".
const qn_unit *qn_unit_find(const char *name, size_t length);

/// Writes the names of all units that `accepted` (bits) lets in: "m, mm, cm, um, in".
void qn_units_list(unsigned accepted, char *text, size_t size);

/// "a time, turns of the drum or time steps"
void qn_units_describe(unsigned accepted, char *text, size_t size);

/// The first unit of the first dimension accepted; NULL for a pure number.
const qn_unit *qn_units_first(unsigned accepted);

const char *qn_dimension_text(int dimension);

#endif
