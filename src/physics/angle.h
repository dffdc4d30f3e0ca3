// SPDX-License-Identifier: Apache-2.0
// Sine and cosine from additions, products and one floor, the same bits on every processor.
//
// A library's sin() may use fused operations where the processor has them, and the drum's angle
// enters every wall contact. The angle is brought into [-pi/4, pi/4] by whole quarter turns, pi/2 being
// taken away in two pieces of 33 bits and a rest (Cody and Waite 1980, Software Manual for the
// Elementary Functions), then the Taylor series is summed. Compile with -ffp-contract=off.
// Holds: |angle| <= 1e5 rad; the error is then below 1e-15.
#ifndef QN_PHYSICS_ANGLE_H
#define QN_PHYSICS_ANGLE_H

#include "physics/real.h"

/// Taylor series of the sine for |r| <= pi/4; the first term left out is below 5e-17.
QN_FN double qn_sine_series(double r)
{
    double q = r * r, sum = -1.0 / 1307674368000.0;  // -1/15!
    sum = sum * q + 1.0 / 6227020800.0;
    sum = sum * q - 1.0 / 39916800.0;
    sum = sum * q + 1.0 / 362880.0;
    sum = sum * q - 1.0 / 5040.0;
    sum = sum * q + 1.0 / 120.0;
    sum = sum * q - 1.0 / 6.0;
    return r + r * (q * sum);
}

/// Taylor series of the cosine for |r| <= pi/4; the first term left out is below 3e-18.
QN_FN double qn_cosine_series(double r)
{
    double q = r * r, sum = 1.0 / 20922789888000.0;  // 1/16!
    sum = sum * q - 1.0 / 87178291200.0;
    sum = sum * q + 1.0 / 479001600.0;
    sum = sum * q - 1.0 / 3628800.0;
    sum = sum * q + 1.0 / 40320.0;
    sum = sum * q - 1.0 / 720.0;
    sum = sum * q + 1.0 / 24.0;
    return 1 - q * (0.5 - q * sum);
}

/// Sine and cosine of an angle (rad).
QN_FN void qn_sincos(double angle, double *sine, double *cosine)
{
    const double half_pi_1 = 1.57079632673412561417e+00;  // rad   leading 33 bits of pi/2
    const double half_pi_2 = 6.07710050630396597660e-11;  // rad   the next 33
    const double half_pi_3 = 2.02226624879595063154e-21;  // rad   the rest
    double turns = floor(angle * (2 / QN_PI) + 0.5);      // 1     whole quarter turns
    double r = ((angle - turns * half_pi_1) - turns * half_pi_2) - turns * half_pi_3;
    double s = qn_sine_series(r), c = qn_cosine_series(r);
    double quarter = turns - 4 * floor(turns / 4);  // 0 .. 3
    bool swap = quarter == 1 || quarter == 3;
    double sine_of = swap ? c : s, cosine_of = swap ? s : c;
    *sine = quarter >= 2 ? -sine_of : sine_of;
    *cosine = quarter == 1 || quarter == 2 ? -cosine_of : cosine_of;
}

#endif
