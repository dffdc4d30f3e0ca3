# SPDX-License-Identifier: Apache-2.0
"""The liner as the last liner_*.hdf has it: quadrangles of the drum's profile, triangles of meshes."""
import numpy as np

QUAD = 9         # VTK's number for a quadrangle
SMOOTH = 0.995   # 1   of the drum's radius: profiles that reach no further in have no lifters


class Liner:
    def __init__(self, root):
        """Reads the group VTKHDF of an open file."""
        self.points = root["Points"][:].astype(float)
        self.connectivity, self.offsets = root["Connectivity"][:], root["Offsets"][:]
        first = self.offsets[:-1][root["Types"][:] == QUAD]
        edge = self.connectivity[first[:, None] + (0, 1)]  # of each quadrangle, along the profile
        self.profile = self.points[edge, :2].reshape(-1, 2, 2)

    def outline(self, z):
        """Segments [n, 2, 2] (m) where the plane at `z` cuts it."""
        return slice_cells(self.points, self.connectivity, self.offsets, z)

    def drum_radius(self):
        """m, or None where there are only meshes."""
        if not len(self.profile):
            return None
        return float(np.hypot(*self.profile.reshape(-1, 2).T).max())

    def tips(self):
        """Radius (m) of the circle that the lifters' tips run on; None on a smooth drum."""
        if not len(self.profile):
            return None
        start, along = self.profile[:, 0], self.profile[:, 1] - self.profile[:, 0]
        square = np.maximum((along ** 2).sum(axis=1), 1e-300)
        foot = np.clip(-(start * along).sum(axis=1) / square, 0, 1)
        nearest = float(np.hypot(*(start + foot[:, None] * along).T).min())
        return nearest if nearest < SMOOTH * self.drum_radius() else None


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
