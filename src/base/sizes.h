// SPDX-License-Identifier: Apache-2.0
// Size distributions, cut off at both ends and divided into classes.
//
// Each formula is the share Q(d) of all spheres, by mass or by number, that is smaller than d. A class is
// an interval of diameters; its spheres all get the diameter whose volume is the class's mean volume, so
// that number and mass of every class, the cumulative curves at its ends, and the mean volume of all are
// those of the formula.
#ifndef QN_BASE_SIZES_H
#define QN_BASE_SIZES_H

#include "base/error.h"

#include <stdbool.h>

// clang-format off
//    NAME              text               first    second     formula and source
//  Q of d, with z the normal variable and Phi its cumulative distribution:
//    normal            Phi(z), z = (d - mean)/deviation
//    lognormal         Phi(z), z = ln(d/median)/sigma                Aitchison & Brown (1957), The Lognormal Distribution
//    Rosin-Rammler     1 - exp(-(d/d63)^n)                           Rosin & Rammler (1933), J. Inst. Fuel 7, 29
//    Gaudin-Schuhmann  (d/top)^m, d <= top                           Schuhmann (1940), AIME Tech. Publ. 1189
#define QN_SIZE_KINDS(K)                                                                            \
    K(NORMAL,           "normal",           mean,    deviation, "mean and standard deviation")      \
    K(LOGNORMAL,        "lognormal",        median,  sigma,     "median and standard deviation of ln d") \
    K(ROSIN_RAMMLER,    "rosin-rammler",    d63,     n,         "diameter that 63.2 % is below, and exponent") \
    K(GAUDIN_SCHUHMANN, "gaudin-schuhmann", top,     m,         "largest diameter and exponent")
// clang-format on

typedef enum qn_size_kind {
#define K(NAME, text, first, second, meaning) QN_SIZES_##NAME,
    QN_SIZE_KINDS(K)
#undef K
} qn_size_kind;

typedef struct qn_size_def {
    qn_size_kind kind;
    bool by_mass;          //     else by number
    double first, second;  //     parameters: m and, for normal, m; for the others m and 1
    double min, max;       // m   nothing is smaller or larger
    int classes;           //     equal steps of ln d between min and max
} qn_size_def;

/// Share of all spheres, by mass or number, that would be smaller than d (m) without the ends.
double qn_size_below(const qn_size_def *def, double d);

/// Diameters (m) and fractions by number, adding up to 1, of the classes that hold anything; arrays of
/// def->classes. *count is how many there are. QN_INPUT where there is nothing between the ends.
QN_NODISCARD qn_status qn_size_classes(const qn_size_def *def, double *diameter, double *fraction,
                                       int *count);

#endif
