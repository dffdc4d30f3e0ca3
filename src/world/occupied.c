// SPDX-License-Identifier: Apache-2.0
#include "world/occupied.h"

#include <stdlib.h>
#include <string.h>

static int64_t cells_of(const qn_occupied_level *l)
{
    return (int64_t)l->cells[0] * l->cells[1] * l->cells[2];
}

static qn_status lay(qn_occupied *o, qn_occupied_level *l, int64_t expected)
{
    qn_vec3 size = qn_sub(o->high, o->low);
    const double wide[3] = {size.x, size.y, size.z};
    double wanted = 4.0 * (double)expected + 4096;
    for (double cell = 2 * l->radius;; cell *= 1.26) {
        double cells = 1;
        for (int axis = 0; axis < 3; axis++) {
            double n = floor(wide[axis] / cell) + 1;
            cells *= n;
            l->cells[axis] = n < wanted ? (int)n : 1;
        }
        l->inverse_cell = 1 / cell;
        if (cells <= wanted) break;
    }
    return QN_ALLOCATE(l->first, cells_of(l));
}

qn_status qn_occupied_create(qn_occupied *o, qn_vec3 low, qn_vec3 high, double period,
                             double largest, int64_t expected)
{
    memset(o, 0, sizeof *o);
    o->low = low, o->high = high, o->period = period, o->largest = largest;
    for (int k = 0; k < QN_OCCUPIED_LEVELS; k++) {
        o->levels[k].radius = ldexp(largest, -k);
        QN_TRY(lay(o, &o->levels[k], expected));
    }
    qn_occupied_clear(o);
    return QN_OK;
}

void qn_occupied_free(qn_occupied *o)
{
    for (int k = 0; k < QN_OCCUPIED_LEVELS; k++) free(o->levels[k].first);
    free(o->spheres), free(o->next);
    memset(o, 0, sizeof *o);
}

void qn_occupied_clear(qn_occupied *o)
{
    o->count = 0;
    for (int k = 0; k < QN_OCCUPIED_LEVELS; k++)
        memset(o->levels[k].first, 0xff, (size_t)cells_of(&o->levels[k]) * sizeof(int32_t));
}

// Cell along one axis; what lies outside belongs to the cells at the border.
static int cell_along(const qn_occupied_level *l, int axis, double x)
{
    double c = x * l->inverse_cell;
    return c < 0 ? 0 : c >= l->cells[axis] ? l->cells[axis] - 1 : (int)c;
}

static int64_t cell_at(const qn_occupied_level *l, int x, int y, int z)
{
    return ((int64_t)z * l->cells[1] + y) * l->cells[0] + x;
}

qn_status qn_occupied_add(qn_occupied *o, qn_vec3 centre, double radius)
{
    QN_TRY(QN_RESERVE(o->spheres, o->room, o->count + 1));
    QN_TRY(QN_RESERVE(o->next, o->next_room, o->count + 1));
    int k = 0;
    while (k + 1 < QN_OCCUPIED_LEVELS && radius <= o->levels[k + 1].radius) k++;
    qn_occupied_level *l = &o->levels[k];
    qn_vec3 at = qn_sub(centre, o->low);
    int32_t *first = &l->first[cell_at(l, cell_along(l, 0, at.x), cell_along(l, 1, at.y),
                                       cell_along(l, 2, at.z))];
    o->spheres[o->count].centre = centre;
    o->spheres[o->count].radius = radius;
    o->next[o->count] = *first;
    *first = o->count++;
    return QN_OK;
}

static bool is_free_in(const qn_occupied *o, const qn_occupied_level *l, qn_vec3 centre,
                       double radius)
{
    qn_vec3 at = qn_sub(centre, o->low);
    const double x[3] = {at.x, at.y, at.z};
    int low[3], high[3];
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = cell_along(l, axis, x[axis] - radius - l->radius);
        high[axis] = cell_along(l, axis, x[axis] + radius + l->radius);
    }
    for (int cz = low[2]; cz <= high[2]; cz++)
        for (int cy = low[1]; cy <= high[1]; cy++)
            for (int cx = low[0]; cx <= high[0]; cx++)
                for (int32_t i = l->first[cell_at(l, cx, cy, cz)]; i >= 0; i = o->next[i]) {
                    qn_vec3 d = qn_sub(o->spheres[i].centre, centre);
                    double apart = o->spheres[i].radius + radius;
                    if (qn_dot(d, d) < apart * apart) return false;
                }
    return true;
}

bool qn_occupied_is_free(const qn_occupied *o, qn_vec3 centre, double radius)
{
    double reach = radius + o->largest;
    qn_vec3 up = centre, down = centre;
    up.z += o->period, down.z -= o->period;
    bool low = o->period > 0 && centre.z - reach < o->low.z;
    bool high = o->period > 0 && centre.z + reach > o->low.z + o->period;
    for (int k = 0; k < QN_OCCUPIED_LEVELS; k++) {
        const qn_occupied_level *l = &o->levels[k];
        if (!is_free_in(o, l, centre, radius)) return false;
        if (low && !is_free_in(o, l, up, radius)) return false;
        if (high && !is_free_in(o, l, down, radius)) return false;
    }
    return true;
}
