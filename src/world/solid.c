// SPDX-License-Identifier: Apache-2.0
#include "world/solid.h"

#include <stdlib.h>
#include <string.h>

enum { COARSE = 32, FINE = 64 };  // nodes between two heights

// Integrals over a solid or a cut through it.
enum { ONE, X, Y, Z, XX, YY, ZZ, XY, YZ, ZX, MOMENTS };

typedef struct spheres {
    const double *centres, *radii;
    int count;
} spheres;

typedef struct disc {
    double x, y, radius;
} disc;

static qn_vec3 centre_of(const spheres *s, int i)
{
    return qn_v3(s->centres[3 * i], s->centres[3 * i + 1], s->centres[3 * i + 2]);
}

// Adds an arc of a rim, from angle a to b: integrals of 1, x, y, x2, y2, xy over the area, as integrals
// of x dy, x2/2 dy, -y2/2 dx, x3/3 dy, -y3/3 dx, x2 y/2 dy along the rim.
static void add_arc(const disc *d, double a, double b, double sum[MOMENTS])
{
    double sa = sin(a), sb = sin(b), ca = cos(a), cb = cos(b);
    double t = b - a, r = d->radius, x = d->x, y = d->y;
    double c1 = sb - sa, s1 = ca - cb;  // of cos, of sin, and so on
    double c2 = 0.5 * (t + sb * cb - sa * ca), s2 = t - c2;
    double c3 = c1 - (sb * sb * sb - sa * sa * sa) / 3;
    double s3 = s1 + (cb * cb * cb - ca * ca * ca) / 3;
    double c4 = 0.75 * c2 + 0.25 * (cb * cb * cb * sb - ca * ca * ca * sa);
    double s4 = 0.75 * s2 - 0.25 * (sb * sb * sb * cb - sa * sa * sa * ca);
    double cs = 0.5 * (sb * sb - sa * sa);                      // cos sin
    double c2s = -(cb * cb * cb - ca * ca * ca) / 3;            // cos2 sin
    double c3s = -(cb * cb * cb * cb - ca * ca * ca * ca) / 4;  // cos3 sin
    sum[ONE] += r * (x * c1 + r * c2);
    sum[X] += r / 2 * (x * x * c1 + 2 * x * r * c2 + r * r * c3);
    sum[Y] += r / 2 * (y * y * s1 + 2 * y * r * s2 + r * r * s3);
    sum[XX] += r / 3 * (x * x * x * c1 + 3 * x * x * r * c2 + 3 * x * r * r * c3 + r * r * r * c4);
    sum[YY] += r / 3 * (y * y * y * s1 + 3 * y * y * r * s2 + 3 * y * r * r * s3 + r * r * r * s4);
    sum[XY] += r / 2
               * (y * (x * x * c1 + 2 * x * r * c2 + r * r * c3)
                  + r * (x * x * cs + 2 * x * r * c2s + r * r * c3s));
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Whether a point lies in one of the discs other than two.
static bool is_covered(const disc *discs, int count, double x, double y, int but)
{
    bool covered = false;
    for (int j = 0; j < count; j++) {
        double dx = x - discs[j].x, dy = y - discs[j].y;
        covered |= j != but && dx * dx + dy * dy < discs[j].radius * discs[j].radius;
    }
    return covered;
}

// The rim of disc i as far as no other disc covers it.
static void add_rim(const disc *discs, int count, int i, double sum[MOMENTS])
{
    double ends[2 * QN_SPHERES_MAX + 2];
    const disc *d = &discs[i];
    int n = 0;
    ends[n++] = -QN_PI;
    ends[n++] = QN_PI;
    for (int j = 0; j < count; j++) {
        double dx = discs[j].x - d->x, dy = discs[j].y - d->y, apart = hypot(dx, dy);
        if (j == i) continue;
        if (apart >= d->radius + discs[j].radius || apart + discs[j].radius <= d->radius) continue;
        double cosine = (apart * apart + d->radius * d->radius - discs[j].radius * discs[j].radius)
                        / (2 * apart * d->radius);
        double half = acos(qn_max(-1, qn_min(1, cosine))), towards = atan2(dy, dx);
        for (int end = -1; end <= 1; end += 2) {
            double angle = towards + end * half;
            angle -= 2 * QN_PI * floor((angle + QN_PI) / (2 * QN_PI));
            ends[n++] = angle;
        }
    }
    qsort(ends, (size_t)n, sizeof *ends, by_value);
    for (int k = 0; k + 1 < n; k++) {
        double middle = 0.5 * (ends[k] + ends[k + 1]);
        double x = d->x + d->radius * cos(middle), y = d->y + d->radius * sin(middle);
        if (ends[k + 1] > ends[k] && !is_covered(discs, count, x, y, i))
            add_arc(d, ends[k], ends[k + 1], sum);
    }
}

// Whether an earlier sphere is the same.
static bool is_repeated(const spheres *s, int i)
{
    bool found = false;
    for (int j = 0; j < i; j++)
        found |= s->radii[j] == s->radii[i]
                 && memcmp(&s->centres[3 * j], &s->centres[3 * i], 3 * sizeof(double)) == 0;
    return found;
}

// Integrals over the cut at a height.
static void cut(const spheres *s, double z, double sum[MOMENTS])
{
    disc discs[QN_SPHERES_MAX];
    int count = 0;
    memset(sum, 0, MOMENTS * sizeof *sum);
    for (int i = 0; i < s->count; i++) {
        double h = z - s->centres[3 * i + 2], q = s->radii[i] * s->radii[i] - h * h;
        if (q > 0 && !is_repeated(s, i))
            discs[count++] = (disc){s->centres[3 * i], s->centres[3 * i + 1], sqrt(q)};
    }
    for (int i = 0; i < count; i++) add_rim(discs, count, i, sum);
    sum[Z] = z * sum[ONE], sum[ZZ] = z * z * sum[ONE];
    sum[YZ] = z * sum[Y], sum[ZX] = z * sum[X];
}

// Nodes and weights on [0, 1]: Newton's iteration on the Legendre polynomial P_n.
static void gauss(int n, double *node, double *weight)
{
    for (int i = 0; i < n; i++) {
        double x = cos(QN_PI * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int round = 0; round < 20; round++) {
            double p = 1, before = 0;
            for (int k = 1; k <= n; k++) {
                double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p, p = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        node[i] = 0.5 * (1 + x);
        weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

// ---- Heights where the cut changes its kind ------------------------------------------------------

typedef struct heights {
    double *z;
    int count, room;
} heights;

// Notes a height unless another sphere hides it.
static void note(heights *h, const spheres *s, qn_vec3 point, int a, int b, int c)
{
    for (int i = 0; i < s->count; i++) {
        double r = s->radii[i] * (1 - 1e-9);
        qn_vec3 d = qn_sub(point, centre_of(s, i));
        if (i != a && i != b && i != c && qn_dot(d, d) < r * r) return;
    }
    if (h->count < h->room) h->z[h->count++] = point.z;
}

// The circle that two spheres share: its centre, radius and axis; false if there is none.
static bool circle_of(const spheres *s, int i, int j, qn_vec3 *centre, double *radius,
                      qn_vec3 *axis)
{
    qn_vec3 d = qn_sub(centre_of(s, j), centre_of(s, i));
    double apart = qn_norm(d), a = s->radii[i], b = s->radii[j];
    if (apart >= a + b || apart <= fabs(a - b)) return false;
    double along = (apart * apart + a * a - b * b) / (2 * apart);
    *axis = qn_scale(1 / apart, d);
    *centre = qn_madd(centre_of(s, i), along, *axis);
    *radius = sqrt(qn_max(0, a * a - along * along));
    return true;
}

static void note_pair(heights *h, const spheres *s, int i, int j)
{
    qn_vec3 centre, axis, other, other_axis;
    double radius, other_radius;
    if (!circle_of(s, i, j, &centre, &radius, &axis)) return;
    qn_vec3 up = qn_madd(qn_v3(0, 0, 1), -axis.z, axis);
    double size = qn_norm(up);
    for (int end = -1; end <= 1 && size > 0; end += 2)
        note(h, s, qn_madd(centre, end * radius / size, up), i, j, -1);
    if (size <= 0) note(h, s, qn_madd(centre, radius, qn_v3(1, 0, 0)), i, j, -1);
    for (int k = j + 1; k < s->count; k++) {
        if (!circle_of(s, i, k, &other, &other_radius, &other_axis)) continue;
        // The line of both planes: from the centre of i at right angles to both axes.
        qn_vec3 line = qn_cross(axis, other_axis), o = centre_of(s, i);
        double l2 = qn_dot(line, line), p = qn_dot(qn_sub(centre, o), axis);
        double q = qn_dot(qn_sub(other, o), other_axis), c = qn_dot(axis, other_axis);
        if (l2 < 1e-20) continue;
        qn_vec3 foot = qn_madd(qn_scale((p - q * c) / l2, axis), (q - p * c) / l2, other_axis);
        double rest = s->radii[i] * s->radii[i] - qn_dot(foot, foot);
        for (int end = -1; end <= 1 && rest >= 0; end += 2)
            note(h, s, qn_madd(qn_add(o, foot), end * sqrt(rest / l2), line), i, j, k);
    }
}

static void note_all(heights *h, const spheres *s)
{
    for (int i = 0; i < s->count; i++) {
        for (int end = -1; end <= 1; end += 2)
            note(h, s, qn_madd(centre_of(s, i), end * s->radii[i], qn_v3(0, 0, 1)), i, -1, -1);
        for (int j = i + 1; j < s->count; j++) note_pair(h, s, i, j);
    }
    qsort(h->z, (size_t)h->count, sizeof *h->z, by_value);
}

// ---- The whole -----------------------------------------------------------------------------------

static void integrate(const spheres *s, const heights *h, int nodes, double sum[MOMENTS])
{
    double node[FINE], weight[FINE], at[MOMENTS];
    gauss(nodes, node, weight);
    memset(sum, 0, MOMENTS * sizeof *sum);
    for (int k = 0; k + 1 < h->count; k++) {
        double low = h->z[k], high = h->z[k + 1];
        for (int i = 0; i < nodes && high > low; i++) {
            double t = node[i], slope = 6 * t * (1 - t) * (high - low) * weight[i];
            cut(s, low + (high - low) * t * t * (3 - 2 * t), at);
            for (int m = 0; m < MOMENTS; m++) sum[m] += slope * at[m];
        }
    }
}

// Volume, centre and inertia from integrals about the origin.
static qn_solid solid_from(const double sum[MOMENTS])
{
    qn_solid s = {.volume = sum[ONE]};
    double v = s.volume;
    qn_vec3 c = qn_v3(sum[X] / v, sum[Y] / v, sum[Z] / v);
    double xx = sum[XX] - v * c.x * c.x, yy = sum[YY] - v * c.y * c.y;
    double zz = sum[ZZ] - v * c.z * c.z;
    s.centre = c;
    s.inertia[0][0] = yy + zz, s.inertia[1][1] = zz + xx, s.inertia[2][2] = xx + yy;
    s.inertia[0][1] = s.inertia[1][0] = v * c.x * c.y - sum[XY];
    s.inertia[1][2] = s.inertia[2][1] = v * c.y * c.z - sum[YZ];
    s.inertia[2][0] = s.inertia[0][2] = v * c.z * c.x - sum[ZX];
    return s;
}

// Largest relative difference of two solids; a centre is compared with the radius of gyration.
static double difference(const qn_solid *a, const qn_solid *b)
{
    double trace = a->inertia[0][0] + a->inertia[1][1] + a->inertia[2][2];
    double worst = fabs(a->volume - b->volume) / a->volume;
    worst = qn_max(worst, qn_norm(qn_sub(a->centre, b->centre)) / sqrt(trace / a->volume));
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            worst = qn_max(worst, fabs(a->inertia[i][j] - b->inertia[i][j]) / trace);
    return worst;
}

qn_status qn_solid_of(const double *centres, const double *radii, int count, qn_solid *solid)
{
    double near[3 * QN_SPHERES_MAX], sum[MOMENTS];  // centres from the middle of them all
    qn_vec3 middle = qn_v3(0, 0, 0);
    const spheres s = {near, radii, count};
    heights h = {.room = 2 * count + count * (count - 1) * (1 + (count - 2) / 3 + 1)};
    QN_TRY(QN_ALLOCATE(h.z, h.room));
    for (int i = 0; i < count; i++)
        middle = qn_madd(middle, 1.0 / count,
                         qn_v3(centres[3 * i], centres[3 * i + 1], centres[3 * i + 2]));
    for (int i = 0; i < count; i++) {
        near[3 * i] = centres[3 * i] - middle.x;
        near[3 * i + 1] = centres[3 * i + 1] - middle.y;
        near[3 * i + 2] = centres[3 * i + 2] - middle.z;
    }
    note_all(&h, &s);
    integrate(&s, &h, COARSE, sum);
    qn_solid coarse = solid_from(sum);
    integrate(&s, &h, FINE, sum);
    *solid = solid_from(sum);
    solid->error = difference(solid, &coarse) + 1e-14;
    solid->centre = qn_add(solid->centre, middle);
    free(h.z);
    return QN_OK;
}
