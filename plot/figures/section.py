# SPDX-License-Identifier: Apache-2.0
"""Where a plane across the axis cuts the cells of a surface."""
import numpy as np


def slice_cells(points, connectivity, offsets, z):
    """Segments [n, 2, 2] in the plane at `z`; each polygon that crosses it gives one.

    Each edge that has one end on either side of the plane gives a point; an end exactly in the
    plane counts as above it, so a polygon is never cut in an odd number of points.
    """
    segments = []
    for first, last in zip(offsets[:-1], offsets[1:]):
        corner = points[connectivity[first:last]]
        if len(corner) < 3:
            continue
        following = np.roll(corner, -1, axis=0)
        crosses = np.flatnonzero((corner[:, 2] >= z) != (following[:, 2] >= z))
        if len(crosses) != 2:
            continue
        share = (z - corner[crosses, 2]) / (following[crosses, 2] - corner[crosses, 2])
        segments.append(corner[crosses, :2]
                        + share[:, None] * (following[crosses, :2] - corner[crosses, :2]))
    return np.array(segments).reshape(-1, 2, 2)
