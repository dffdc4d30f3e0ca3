// SPDX-License-Identifier: Apache-2.0
// Set-up of a profile: the chain of elements from a drum's sizes or points, and its grid.
#include "physics/angle.h"
#include "world/profile.h"

#include <stdlib.h>

enum { SIDE_CELLS = 1024 };  // most grid cells per side

static const double SMOOTH = 1e-9;  // 1   directions that differ by less run on smoothly

/// Adds a stretch from a to b; the end directions follow.
static void add(qn_profile *p, const double a[2], const double b[2], bool arc, int lifter)
{
    qn_element *e = &p->elements[p->count++];
    *e = (qn_element){.ax = a[0], .ay = a[1], .bx = b[0], .by = b[1], .arc = arc, .lifter = lifter};
    double r = p->radius;
    double dx = b[0] - a[0], dy = b[1] - a[1];
    e->length = sqrt(dx * dx + dy * dy);
    e->start_x = arc ? a[1] / r : -dx / e->length;
    e->start_y = arc ? -a[0] / r : -dy / e->length;
    e->end_x = arc ? -b[1] / r : dx / e->length;
    e->end_y = arc ? b[0] / r : dy / e->length;
    e->normal_x = arc ? 0 : -e->end_y;
    e->normal_y = arc ? 0 : e->end_x;
}

/// Says how the chain turns at each corner and makes smooth joints exactly smooth.
static void settle_corners(qn_profile *p)
{
    for (int i = 0; i < p->count; i++) {
        qn_element *e = &p->elements[i];
        const qn_element *before = &p->elements[qn_profile_before(p, i)];
        double sum_x = before->end_x + e->start_x, sum_y = before->end_y + e->start_y;
        double turn = before->end_y * e->start_x - before->end_x * e->start_y;
        e->corner = turn > 0 ? QN_CORNER_CONCAVE : QN_CORNER_PROTRUDING;
        if (sum_x * sum_x + sum_y * sum_y >= SMOOTH * SMOOTH) continue;
        e->corner = QN_CORNER_SMOOTH;
        e->start_x = -before->end_x;
        e->start_y = -before->end_y;
    }
}

static void turned(double x, double y, double angle, double out[2])
{
    double s, c;
    qn_sincos(angle, &s, &c);
    out[0] = c * x - s * y;
    out[1] = s * x + c * y;
}

/// The lifter that stands at the bottom must lie in its own sector, inside the shell, and rise above
/// the chord of its base.
static qn_status check_lifters(const qn_drum_def *d)
{
    double r = 0.5 * d->diameter, floor_y = r - d->lifter_height;
    if (!(d->lifter_height > 0 && floor_y > 0))
        return qn_fail(
            QN_INPUT,
            "lifters are %g m high in a drum of %g m diameter; their height must be above "
            "0 and below its radius",
            d->lifter_height, d->diameter);
    if (!(d->lifter_base > 0 && d->lifter_base < d->diameter && d->lifter_top >= 0))
        return qn_fail(QN_INPUT,
                       "lifters have a base %g m and a top %g m wide; the base must be above 0 and "
                       "below the drum's diameter of %g m, the top not negative",
                       d->lifter_base, d->lifter_top, d->diameter);
    double half = 0.5 * d->lifter_top, foot = 0.5 * d->lifter_base;
    double base_y = sqrt(r * r - foot * foot);
    if (!(floor_y * floor_y + half * half < r * r) || !(floor_y < base_y))
        return qn_fail(QN_INPUT,
                       "lifters %g m high with a base %g m and a top %g m wide do not stand free "
                       "inside a drum of %g m diameter; make them higher or narrower",
                       d->lifter_height, d->lifter_base, d->lifter_top, d->diameter);
    double s = 1, c = 0;
    if (d->lifter_count > 2) qn_sincos(QN_PI / d->lifter_count, &s, &c);
    if (!(foot * c < base_y * s && half * c < floor_y * s))
        return qn_fail(QN_INPUT,
                       "%d lifters with a base %g m and a top %g m wide overlap in a drum of %g m "
                       "diameter; use fewer or narrower ones",
                       d->lifter_count, d->lifter_base, d->lifter_top, d->diameter);
    return QN_OK;
}

static void add_lifters(const qn_drum_def *d, qn_profile *p)
{
    double r = p->radius, foot = 0.5 * d->lifter_base, half = 0.5 * d->lifter_top;
    double base_y = -sqrt(r * r - foot * foot), top_y = -(r - d->lifter_height);
    for (int k = 0; k < d->lifter_count; k++) {
        double at = k * (2 * QN_PI / d->lifter_count);
        double next = (k + 1) % d->lifter_count * (2 * QN_PI / d->lifter_count);
        double a[2], b[2], c[2], e[2], f[2];
        turned(-foot, base_y, at, a);
        turned(-half, top_y, at, b);
        turned(half, top_y, at, c);
        turned(foot, base_y, at, e);
        turned(-foot, base_y, next, f);
        add(p, a, b, false, k);
        if (half > 0) add(p, b, c, false, k);
        add(p, c, e, false, k);
        if (d->lifter_count == 1) {  // an arc must be less than half a turn
            double g[2], h[2];
            turned(0, -r, 2 * QN_PI / 3, g);
            turned(0, -r, 4 * QN_PI / 3, h);
            add(p, e, g, true, -1);
            add(p, g, h, true, -1);
            add(p, h, f, true, -1);
        } else {
            add(p, e, f, true, -1);
        }
    }
}

static qn_status build_shell(const qn_drum_def *d, qn_profile *p)
{
    if (!(d->diameter > 0 && isfinite(d->diameter)))
        return qn_fail(QN_INPUT, "the drum's diameter is %g m; it must be above 0", d->diameter);
    p->radius = 0.5 * d->diameter;
    if (d->lifter_count > 0) {
        QN_TRY(check_lifters(d));
        QN_TRY(QN_ALLOCATE(p->elements, 6 * (int64_t)d->lifter_count));
        add_lifters(d, p);
        return QN_OK;
    }
    double r = p->radius;
    const double at[4][2] = {{r, 0}, {0, r}, {-r, 0}, {0, -r}};
    QN_TRY(QN_ALLOCATE(p->elements, 4));
    for (int k = 0; k < 4; k++) add(p, at[k], at[(k + 1) % 4], true, -1);
    return QN_OK;
}

static double cross_of(const double *o, const double *a, const double *b)
{
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

static bool boxes_meet(const double *a, const double *b, const double *c, const double *d)
{
    for (int k = 0; k < 2; k++)
        if (qn_max(a[k], b[k]) < qn_min(c[k], d[k]) || qn_max(c[k], d[k]) < qn_min(a[k], b[k]))
            return false;
    return true;
}

/// Whether the stretches a-b and c-d have a point in common.
static bool meet(const double *a, const double *b, const double *c, const double *d)
{
    if (!boxes_meet(a, b, c, d)) return false;
    double c_side = cross_of(a, b, c), d_side = cross_of(a, b, d);
    double a_side = cross_of(c, d, a), b_side = cross_of(c, d, b);
    return !((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0) || (a_side > 0 && b_side > 0)
             || (a_side < 0 && b_side < 0));
}

static qn_status check_points(const double *at, int n, double size)
{
    for (int i = 0; i < n; i++) {
        const double *a = at + 2 * i, *b = at + 2 * ((i + 1) % n), *c = at + 2 * ((i + 2) % n);
        double x = b[0] - a[0], y = b[1] - a[1], u = c[0] - b[0], v = c[1] - b[1];
        double length = sqrt(x * x + y * y), next = sqrt(u * u + v * v);
        if (!(length > 1e-12 * size))
            return qn_fail(QN_INPUT,
                           "the profile's points %d and %d are the same (%g, %g) m; leave one out",
                           i + 1, (i + 1) % n + 1, a[0], a[1]);
        if (x * u + y * v < 0 && fabs(x * v - y * u) <= SMOOTH * length * next)
            return qn_fail(QN_INPUT,
                           "the profile turns back on itself at point %d (%g, %g) m; a wall needs "
                           "some thickness",
                           (i + 1) % n + 1, b[0], b[1]);
    }
    for (int i = 0; i < n; i++)
        for (int j = i + 2; j < n; j++) {
            if (i == 0 && j == n - 1) continue;
            if (meet(at + 2 * i, at + 2 * i + 2, at + 2 * j, at + 2 * ((j + 1) % n)))
                return qn_fail(
                    QN_INPUT,
                    "the profile crosses itself: the stretch from point %d and that from "
                    "point %d have a point in common near (%g, %g) m",
                    i + 1, j + 1, at[2 * j], at[2 * j + 1]);
        }
    return QN_OK;
}

/// A closed line of points, in either sense; the first may be repeated at the end.
static qn_status build_points(const qn_drum_def *d, qn_profile *p)
{
    const double *at = d->profile;
    int n = d->profile_count;
    double twice_area = 0;
    for (int i = 0; i < 2 * n; i++)
        if (!isfinite(at[i]))
            return qn_fail(QN_INPUT, "the profile's point %d is not finite", i / 2 + 1);
    if (n > 1 && at[0] == at[2 * n - 2] && at[1] == at[2 * n - 1]) n--;
    if (n < 3)
        return qn_fail(QN_INPUT, "the profile has %d different points; it needs at least 3", n);
    for (int i = 0; i < n; i++) {
        const double *a = at + 2 * i, *b = at + 2 * ((i + 1) % n);
        p->radius = qn_max(p->radius, sqrt(a[0] * a[0] + a[1] * a[1]));
        twice_area += a[0] * b[1] - a[1] * b[0];
    }
    QN_TRY(check_points(at, n, p->radius));
    QN_TRY(QN_ALLOCATE(p->elements, n));
    bool left = twice_area > 0;
    for (int i = 0; i < n; i++) {
        int from = left ? i : (n - i) % n, to = left ? (i + 1) % n : n - i - 1;
        add(p, at + 2 * from, at + 2 * to, false, -1);
    }
    return QN_OK;
}

/// Visits the grid cells that a disc of p->reach in them may touch feature f from: counts them, or
/// lists the feature where `items` is given. Cells the wall passes through are marked.
static void cover(qn_profile *p, int f, int *counts, int *items)
{
    const qn_element *e = &p->elements[f < p->count ? f : f - p->count];
    bool corner = f >= p->count;
    if (corner && e->corner == QN_CORNER_CONCAVE) return;
    double bx = corner ? e->ax : e->bx, by = corner ? e->ay : e->by;
    double chord = 0.5 * e->length / p->radius;
    double bulge = e->arc && !corner ? p->radius * (1 - sqrt(qn_max(0, 1 - chord * chord))) : 0;
    double half = 0.7072 * p->cell, near = p->reach * (1 + 1e-9) + half, half_grid = 0.5 * p->cells;
    int low[2], high[2];
    for (int k = 0; k < 2; k++) {
        double a = k ? e->ay : e->ax, b = k ? by : bx;
        low[k] = (int)qn_max(0, floor((qn_min(a, b) - bulge - near) / p->cell + half_grid));
        high[k] =
            (int)qn_min(p->cells - 1, floor((qn_max(a, b) + bulge + near) / p->cell + half_grid));
    }
    for (int row = low[1]; row <= high[1]; row++)
        for (int column = low[0]; column <= high[0]; column++) {
            double x = (column + 0.5 - half_grid) * p->cell, y = (row + 0.5 - half_grid) * p->cell;
            double dx = x - e->ax, dy = y - e->ay;
            double distance =
                corner ? sqrt(dx * dx + dy * dy) : qn_element_distance(e, p->radius, x, y);
            if (distance > near) continue;
            int cell = row * p->cells + column;
            if (items)
                items[counts[cell]++] = f;
            else
                counts[cell]++;
            if (distance <= half) p->cell_side[cell] = QN_SIDE_MIXED;
        }
}

/// Cells the wall does not pass through are on the side of their left neighbour, if it does not
/// pass through that either.
static void settle_sides(qn_profile *p)
{
    for (int row = 0; row < p->cells; row++)
        for (int column = 0; column < p->cells; column++) {
            unsigned char *side = &p->cell_side[row * p->cells + column];
            if (*side == QN_SIDE_MIXED) continue;
            double x = (column + 0.5 - 0.5 * p->cells) * p->cell;
            double y = (row + 0.5 - 0.5 * p->cells) * p->cell;
            if (column > 0 && side[-1] != QN_SIDE_MIXED)
                *side = side[-1];
            else if (x * x + y * y > p->radius * p->radius)
                *side = QN_SIDE_OUTSIDE;
            else
                *side = qn_profile_distance(p, x, y) > 0 ? QN_SIDE_INSIDE : QN_SIDE_OUTSIDE;
        }
}

static qn_status build_grid(qn_profile *p)
{
    double half = p->radius + p->reach;
    p->cell = qn_max(p->reach, 2 * half / (SIDE_CELLS - 2));
    p->cells = (int)ceil(2 * half / p->cell) + 2;
    int64_t total = (int64_t)p->cells * p->cells;
    QN_TRY(QN_ALLOCATE(p->cell_start, total + 1));
    QN_TRY(QN_ALLOCATE(p->cell_side, total));
    for (int f = 0; f < 2 * p->count; f++) cover(p, f, p->cell_start + 1, NULL);
    for (int64_t c = 0; c < total; c++) p->cell_start[c + 1] += p->cell_start[c];
    QN_TRY(QN_ALLOCATE(p->cell_items, p->cell_start[total]));
    for (int f = 0; f < 2 * p->count; f++) cover(p, f, p->cell_start, p->cell_items);
    for (int64_t c = total; c > 0; c--) p->cell_start[c] = p->cell_start[c - 1];
    p->cell_start[0] = 0;
    settle_sides(p);
    return QN_OK;
}

static qn_status build(const qn_drum_def *drum, double reach, qn_profile *p)
{
    if (!(reach > 0 && isfinite(reach)))
        return qn_fail(QN_INPUT, "the largest particle has a radius of %g m; it must be above 0",
                       reach);
    p->reach = reach;
    p->shared = drum->corners == QN_CORNERS_SHARED;
    QN_TRY(drum->profile_count > 0 ? build_points(drum, p) : build_shell(drum, p));
    settle_corners(p);
    p->clear = qn_max(0, qn_profile_distance(p, 0, 0));
    return build_grid(p);
}

qn_status qn_profile_build(const qn_drum_def *drum, double reach, qn_profile *profile)
{
    *profile = (qn_profile){0};
    qn_status status = build(drum, reach, profile);
    if (status != QN_OK) qn_profile_free(profile);
    return status;
}
