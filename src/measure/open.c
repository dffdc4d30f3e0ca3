// SPDX-License-Identifier: Apache-2.0
#include "measure/open.h"

enum { PIECES = 32 };  // along each side of a square that the shell or a lifter's circle crosses

void qn_open_build(const qn_walls *walls, qn_open *open)
{
    open->radius = walls->profile.radius;
    open->clear = open->radius;
    double width = open->radius / QN_OPEN_STEPS;
    for (int i = QN_OPEN_STEPS - 1; i >= 0; i--) {
        open->share[i] = qn_walls_open_share(walls, (i + 0.5) * width);
        if (open->share[i] < 1 - 1e-12) open->clear = i * width;
    }
}

static double share_at(const qn_open *open, double rho)
{
    if (rho < open->clear) return 1;
    int i = (int)(rho / open->radius * QN_OPEN_STEPS);
    return i < QN_OPEN_STEPS ? open->share[i] : 0;
}

double qn_open_square(const qn_open *open, double x, double y, double side)
{
    double far_x = qn_max(fabs(x), fabs(x + side)), far_y = qn_max(fabs(y), fabs(y + side));
    if (hypot(far_x, far_y) < open->clear) return side * side;
    double near_x = qn_max(0, qn_max(x, -x - side)), near_y = qn_max(0, qn_max(y, -y - side));
    if (hypot(near_x, near_y) >= open->radius) return 0;
    double piece = side / PIECES, sum = 0;
    for (int j = 0; j < PIECES; j++)
        for (int i = 0; i < PIECES; i++) {
            double u = x + (i + 0.5) * piece, v = y + (j + 0.5) * piece;
            sum += share_at(open, sqrt(u * u + v * v));
        }
    return sum * piece * piece;
}

double qn_open_ring(const qn_open *open, double inner)
{
    double width = open->radius / QN_OPEN_STEPS, sum = 0;
    for (int i = 0; i < QN_OPEN_STEPS; i++) {
        double from = qn_max(inner, i * width), to = (i + 1) * width;
        if (to > from) sum += open->share[i] * QN_PI * (to * to - from * from);
    }
    return sum;
}

double qn_volume_quantum(const qn_world *world, double volume, int parts)
{
    double smallest = qn_ball_volume(world->smallest_radius) / parts;
    double most = 0x1p62 / (2 * volume / smallest * 0x1p24);  // 1   multiples that still fit
    double multiple = most >= 1 ? ldexp(1, ilogb(qn_min(most, 0x1p20))) : 1;
    return smallest / multiple;
}
