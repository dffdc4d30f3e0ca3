// SPDX-License-Identifier: Apache-2.0
#include "world/lining.h"
#include "physics/angle.h"

qn_lining qn_lining_of(const qn_drum_def *drum, double diameter)
{
    double r = diameter / 2, sine = r / (drum->diameter / 2 - r), row = r * sqrt(3.0);
    qn_lining lining = {0, 0};
    if (!(sine > 0 && sine < 1)) return lining;
    lining.around = (int64_t)floor(QN_PI / asin(sine) * (1 + 1e-12));
    if (drum->ends == QN_ENDS_PERIODIC)
        lining.rings = 2 * (int64_t)floor(drum->length / (2 * row) + 0.5);
    else if (drum->length >= diameter)
        lining.rings = 1 + (int64_t)floor((drum->length - diameter) / row + 0.5);
    return lining;
}

qn_vec3 qn_lining_centre(const qn_lining *lining, const qn_drum_def *drum, double diameter,
                         int64_t ring, int64_t k)
{
    double r = diameter / 2, rho = drum->diameter / 2 - r, z, sine, cosine;
    double turn = 2 * QN_PI * ((double)k + (ring % 2 ? 0.5 : 0)) / (double)lining->around;
    if (drum->ends == QN_ENDS_PERIODIC)
        z = ((double)ring + 0.5) * drum->length / (double)lining->rings;
    else if (lining->rings > 1)
        z = r + (double)ring * (drum->length - diameter) / (double)(lining->rings - 1);
    else
        z = drum->length / 2;
    qn_sincos(turn, &sine, &cosine);
    return qn_v3(rho * cosine, rho * sine, z);
}
