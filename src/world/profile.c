// SPDX-License-Identifier: Apache-2.0
// Questions to a profile: what a disc touches, how far and on which side a point is.
//
// Every point belongs to the element that strictly contains its foot, or to the corner whose two
// neighbours both say "beyond me": the same product decides for both, so none is lost or counted
// twice. Source of the regions: Ericson (2005), Real-Time Collision Detection, 5.1.2, 5.1.5.
#include "world/profile.h"
#include "physics/sharing.h"
#include "world/touch.h"

#include <stdlib.h>

enum { HITS = 32 };  // most features one disc is taken to touch; further ones are passed over

void qn_profile_free(qn_profile *profile)
{
    free(profile->elements);
    free(profile->cell_start);
    free(profile->cell_items);
    free(profile->cell_side);
    *profile = (qn_profile){0};
}

static double square(double x)
{
    return x * x;
}

/// Whether the foot of a point lies strictly within an element; on an arc the two half planes bound
/// its sector, which is less than half a turn.
static bool owned_by_element(const qn_element *e, double x, double y)
{
    return (x - e->ax) * e->start_x + (y - e->ay) * e->start_y < 0
           && (x - e->bx) * e->end_x + (y - e->by) * e->end_y < 0;
}

/// Whether a point lies in the wedge of the corner where `before` ends and `e` begins.
static bool owned_by_corner(const qn_element *before, const qn_element *e, double x, double y)
{
    double dx = x - e->ax, dy = y - e->ay;
    return dx * before->end_x + dy * before->end_y >= 0 && dx * e->start_x + dy * e->start_y >= 0;
}

/// Signed distance (m) from a point owned by an element to it, positive inside.
static double height_over(const qn_element *e, double radius, double x, double y)
{
    if (e->arc) return radius - sqrt(x * x + y * y);
    return (x - e->ax) * e->normal_x + (y - e->ay) * e->normal_y;
}

/// Whether a point owned by a corner is on the drum's inner side.
static bool inside_corner(const qn_element *before, const qn_element *e, double x, double y)
{
    if (e->corner != QN_CORNER_SMOOTH) return e->corner == QN_CORNER_PROTRUDING;
    return before->end_x * (y - e->ay) - before->end_y * (x - e->ax) >= 0;
}

static bool touch_element(const qn_profile *p, int i, double x, double y, double radius,
                          qn_profile_hit *hit)
{
    const qn_element *e = &p->elements[i];
    if (!owned_by_element(e, x, y)) return false;
    double height = height_over(e, p->radius, x, y);
    if (!(height >= 0 && height < radius)) return false;
    *hit = (qn_profile_hit){i, i, x - height * e->normal_x, y - height * e->normal_y, 1, 0};
    if (e->arc) {
        double scale = p->radius / (p->radius - height);
        hit->x = scale * x;
        hit->y = scale * y;
    }
    return true;
}

static bool touch_corner(const qn_profile *p, int i, double x, double y, double radius,
                         qn_profile_hit *hit)
{
    const qn_element *e = &p->elements[i], *before = &p->elements[qn_profile_before(p, i)];
    if (!(square(x - e->ax) + square(y - e->ay) < radius * radius)) return false;
    if (!owned_by_corner(before, e, x, y) || !inside_corner(before, e, x, y)) return false;
    *hit = (qn_profile_hit){p->count + i, i, e->ax, e->ay, 1, 0};
    return true;
}

/// How far (m) a foot lies within one end of an element, negative beyond it; along an arc by the chord.
static double within_end(const double foot[2], double at_x, double at_y, double out_x, double out_y)
{
    double dx = foot[0] - at_x, dy = foot[1] - at_y;
    double distance = sqrt(dx * dx + dy * dy);
    return dx * out_x + dy * out_y < 0 ? distance : -distance;
}

/// The touch of a disc and the whole line of an element, with the share that the element takes of it.
static bool touch_shared(const qn_profile *p, int i, double x, double y, double radius,
                         qn_profile_hit *hit)
{
    const qn_element *e = &p->elements[i];
    double height = height_over(e, p->radius, x, y);
    if (!(height >= 0 && height < radius)) return false;
    double out = e->arc ? p->radius / (p->radius - height) : 1;
    const double foot[2] = {out * x - height * e->normal_x, out * y - height * e->normal_y};
    double half = sqrt(radius * radius - height * height);  // m   of the chord
    double before = within_end(foot, e->ax, e->ay, e->start_x, e->start_y);
    double after = within_end(foot, e->bx, e->by, e->end_x, e->end_y);
    double overlap = qn_min(before, half) + qn_min(after, half);
    if (!(overlap > 0)) return false;
    double share = overlap < 2 * half ? qn_corner_share(overlap / (2 * half)) : 1;
    double beyond = qn_max(0, -qn_min(before, after));
    *hit = (qn_profile_hit){i, i, foot[0], foot[1], share, beyond};
    return true;
}

/// Takes out all but the nearest of feet that lie together; keeps the order.
static int join_close(qn_profile_hit *hits, int n, double x, double y, double radius)
{
    double near = square(QN_ONE_CONTACT * radius);
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) {
            if (square(hits[i].x - hits[j].x) + square(hits[i].y - hits[j].y) >= near) continue;
            bool keep_i = square(hits[i].x - x) + square(hits[i].y - y)
                          <= square(hits[j].x - x) + square(hits[j].y - y);
            int out = keep_i ? j : i;
            for (int k = out; k + 1 < n; k++) hits[k] = hits[k + 1];
            n--;
            j = i;
        }
    return n;
}

/// The grid cell of a point, or -1 off the grid.
static int cell_of(const qn_profile *p, double x, double y)
{
    double half = 0.5 * p->cells;
    double column = floor(x / p->cell + half), row = floor(y / p->cell + half);
    if (!(column >= 0 && row >= 0 && column < p->cells && row < p->cells)) return -1;
    return (int)row * p->cells + (int)column;
}

int qn_profile_touch(const qn_profile *profile, double x, double y, double radius,
                     qn_profile_hit *hits, int room)
{
    int cell = cell_of(profile, x, y);
    if (cell < 0 || profile->cell_start[cell] == profile->cell_start[cell + 1]) return 0;
    qn_profile_hit found[HITS];
    int n = 0;
    for (int k = profile->cell_start[cell]; k < profile->cell_start[cell + 1] && n < HITS; k++) {
        int f = profile->cell_items[k];
        if (profile->shared) {
            n += f < profile->count && touch_shared(profile, f, x, y, radius, &found[n]);
            continue;
        }
        bool touches = f < profile->count
                           ? touch_element(profile, f, x, y, radius, &found[n])
                           : touch_corner(profile, f - profile->count, x, y, radius, &found[n]);
        n += touches;
    }
    if (n > 1 && !profile->shared) n = join_close(found, n, x, y, radius);
    for (int k = 0; k < n && k < room; k++) hits[k] = found[k];
    return n;
}

double qn_element_distance(const qn_element *element, double radius, double x, double y)
{
    if (owned_by_element(element, x, y)) return fabs(height_over(element, radius, x, y));
    double to_a = square(x - element->ax) + square(y - element->ay);
    double to_b = square(x - element->bx) + square(y - element->by);
    return sqrt(qn_min(to_a, to_b));
}

double qn_profile_distance(const qn_profile *profile, double x, double y)
{
    double best = INFINITY;  // m   signed
    for (int i = 0; i < profile->count; i++) {
        const qn_element *e = &profile->elements[i];
        const qn_element *before = &profile->elements[qn_profile_before(profile, i)];
        if (owned_by_element(e, x, y)) {
            double height = height_over(e, profile->radius, x, y);
            if (fabs(height) < fabs(best)) best = height;
        }
        if (owned_by_corner(before, e, x, y)) {
            double distance = sqrt(square(x - e->ax) + square(y - e->ay));
            if (distance < fabs(best)) best = inside_corner(before, e, x, y) ? distance : -distance;
        }
    }
    return best;
}

qn_side qn_profile_side(const qn_profile *profile, double x, double y)
{
    int cell = cell_of(profile, x, y);
    if (cell < 0) return QN_SIDE_OUTSIDE;
    qn_side side = (qn_side)profile->cell_side[cell];
    if (side != QN_SIDE_MIXED) return side;
    return qn_profile_distance(profile, x, y) < 0 ? QN_SIDE_OUTSIDE : QN_SIDE_INSIDE;
}
