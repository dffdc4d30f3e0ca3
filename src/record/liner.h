// SPDX-License-Identifier: Apache-2.0
// The walls as a surface to look at: quads of the drum's profile, triangles of the meshes.
#ifndef QN_RECORD_LINER_H
#define QN_RECORD_LINER_H

#include "world/world.h"

typedef struct qn_liner {
    int64_t point_count, corner_count, cell_count;
    float *points;     // m   3 x point_count, in the lab frame; owned
    int64_t *corners;  //     indices of points, cell after cell; owned
    int64_t *offsets;  //     cell_count + 1, where each cell begins in corners; owned
    // Of each cell: number of the lifter from 1, 0 for shell and meshes; the part of the walls; the facet
    // whose wear it shows. Owned.
    int32_t *lifter, *part, *facet;
    double *area;  // m2   of that facet; owned
} qn_liner;

/// Draws the walls as they stand at time t (s). Arcs are cut into pieces of at most 3 degrees; ends
/// and planes are left out. No cells where there is nothing to draw.
QN_NODISCARD qn_status qn_liner_draw(const qn_walls *walls, double t, qn_liner *liner);

void qn_liner_free(qn_liner *liner);

#endif
