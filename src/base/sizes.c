// SPDX-License-Identifier: Apache-2.0
#include "base/sizes.h"

#include <math.h>

#define LEAST_SHARE 1e-12  // 1   of a class, by mass and by number: what has less is left out

double qn_size_below(const qn_size_def *s, double d)
{
    switch (s->kind) {
    case QN_SIZES_NORMAL: return 0.5 * erfc((s->first - d) / (s->second * sqrt(2)));
    case QN_SIZES_LOGNORMAL: return 0.5 * erfc(log(s->first / d) / (s->second * sqrt(2)));
    case QN_SIZES_ROSIN_RAMMLER: return -expm1(-pow(d / s->first, s->second));
    case QN_SIZES_GAUDIN_SCHUHMANN: return d < s->first ? pow(d / s->first, s->second) : 1;
    }
    return 0;
}

// dQ/d ln d
static double density(const qn_size_def *s, double d)
{
    const double root_two_pi = 2.5066282746310002;
    double z, power = pow(d / s->first, s->second);
    switch (s->kind) {
    case QN_SIZES_NORMAL:
        z = (d - s->first) / s->second;
        return d * exp(-0.5 * z * z) / (s->second * root_two_pi);
    case QN_SIZES_LOGNORMAL:
        z = log(d / s->first) / s->second;
        return exp(-0.5 * z * z) / (s->second * root_two_pi);
    case QN_SIZES_ROSIN_RAMMLER: return s->second * power * exp(-power);
    case QN_SIZES_GAUDIN_SCHUHMANN: return d <= s->first ? s->second * power : 0;
    }
    return 0;
}

// Width in ln d over which the density changes: panels of the quadrature are narrower.
static double detail(const qn_size_def *s)
{
    if (s->kind == QN_SIZES_NORMAL) return s->second / s->first;
    return s->kind == QN_SIZES_LOGNORMAL ? s->second : 1 / s->second;
}

// Number and volume, up to a common factor, of the spheres with ln d between `from` and `to`, by Gauss
// and Legendre's rule of five points on each of many panels (Abramowitz & Stegun 1964, 25.4.30). Both
// with the same points, so that their ratio always lies within the class.
static void integrate(const qn_size_def *s, double from, double to, double *number, double *volume)
{
    static const double at[3] = {0, 0.5384693101056831, 0.9061798459386640};
    static const double weight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    int panels = (int)fmin(4096, 8 + ceil(4 * (to - from) / detail(s)));
    double half = 0.5 * (to - from) / panels;
    *number = *volume = 0;
    for (int k = 0; k < panels; k++)
        for (int point = -2; point <= 2; point++) {
            int p = point < 0 ? -point : point;
            double x = from + (2 * k + 1) * half + (point < 0 ? -half : half) * at[p];
            double d = exp(x), share = half * weight[p] * density(s, d), cube = d * d * d;
            *number += s->by_mass ? share / cube : share;
            *volume += s->by_mass ? share : share * cube;
        }
}

qn_status qn_size_classes(const qn_size_def *s, double *diameter, double *fraction, int *count)
{
    double low = log(s->min), step = log(s->max / s->min) / s->classes;
    double number = 0, volume = 0, n, v;
    for (int k = 0; k < s->classes; k++) {
        integrate(s, low + k * step, low + (k + 1) * step, &n, &v);
        number += n, volume += v;
    }
    *count = 0;
    if (!(qn_size_below(s, s->max) - qn_size_below(s, s->min) > LEAST_SHARE && number > 0))
        return qn_fail(QN_INPUT, "the size distribution has nothing between %g and %g m", s->min,
                       s->max);
    for (int k = 0; k < s->classes; k++) {
        integrate(s, low + k * step, low + (k + 1) * step, &n, &v);
        if (n < LEAST_SHARE * number && v < LEAST_SHARE * volume) continue;
        if (!(n > 0 && v > 0)) continue;
        diameter[*count] = cbrt(v / n);
        fraction[(*count)++] = n / number;
    }
    return QN_OK;
}
