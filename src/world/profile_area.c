// SPDX-License-Identifier: Apache-2.0
// How much of a circle and of the plane a profile encloses, both exact.
#include "world/profile.h"

static double radius_at(const qn_profile *p, double x, double y)
{
    double r = sqrt(x * x + y * y);
    return fabs(r - p->radius) <= 1e-12 * p->radius ? p->radius : r;
}

/// Angle (rad) at which the line through an element's a along its direction meets the circle, before
/// (sign -1) or beyond (+1) the point nearest to the axis.
static double crossing(const qn_element *e, double rho, int sign)
{
    double along = -(e->ax * e->end_x + e->ay * e->end_y);  // m   from a to that nearest point
    double away = e->ax * e->normal_x + e->ay * e->normal_y;
    double t = along + sign * sqrt(qn_max(0, rho * rho - away * away));
    return atan2(e->ay + t * e->end_y, e->ax + t * e->end_x);
}

/// Walking outwards through the circle the inside is to the left: the open stretch begins there.
/// Open share = (sum of the angles where it ends - sum where it begins) / 2 pi, up to whole turns.
double qn_profile_open_share(const qn_profile *profile, double rho)
{
    if (rho >= profile->radius * (1 - 1e-12)) return 0;
    double open = 0;  // rad
    int crossings = 0;
    for (int i = 0; i < profile->count; i++) {
        const qn_element *e = &profile->elements[i];
        if (e->arc) continue;
        bool a_out = radius_at(profile, e->ax, e->ay) >= rho;
        bool b_out = radius_at(profile, e->bx, e->by) >= rho;
        double along = -(e->ax * e->end_x + e->ay * e->end_y);
        double away = e->ax * e->normal_x + e->ay * e->normal_y;
        bool dips = a_out && b_out && along > 0 && along < e->length && fabs(away) < rho;
        if ((a_out && !b_out) || dips) open += crossing(e, rho, -1), crossings++;
        if ((!a_out && b_out) || dips) open -= crossing(e, rho, 1), crossings++;
    }
    double share = open / (2 * QN_PI);
    share -= floor(share);
    if (crossings && share > 1e-12 && share < 1 - 1e-12) return share;
    return qn_profile_distance(profile, -rho, 0) > 0 ? 1 : 0;
}

/// Green: half the sum of a x b, and half R^2 times the angle of each arc.
double qn_profile_area(const qn_profile *profile)
{
    double area = 0;  // m2
    for (int i = 0; i < profile->count; i++) {
        const qn_element *e = &profile->elements[i];
        double cross = e->ax * e->by - e->ay * e->bx, dot = e->ax * e->bx + e->ay * e->by;
        area += 0.5 * (e->arc ? profile->radius * profile->radius * atan2(cross, dot) : cross);
    }
    return area;
}
