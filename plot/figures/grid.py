# SPDX-License-Identifier: Apache-2.0
"""One voxel grid of fields.h5, seen along the drum's axis.

Layers along the axis are averaged: solidity by open volume, velocity by count. What lies outside
the drum, or was never visited, is NaN.
"""
import numpy as np

LEAST_COUNT = 3    # 1   visits below which a mean velocity is not shown
LEAST_OPEN = 0.02  # 1   share of a voxel that must lie inside the drum for it to be shown


class Grid:
    def __init__(self, group):
        def number(name, default=np.nan):
            return float(np.ravel(group.attrs.get(name, default))[0])

        self.cell = number("cell_m")
        self.samples = int(number("samples", 0))
        self.drum_radius = number("drum_radius_m", 0) or None
        if self.drum_radius and not np.isfinite(self.drum_radius):
            self.drum_radius = None
        self.radius = number("radius_m", number("particle_radius_m"))
        self.first_time, self.last_time = number("first_time_s"), number("last_time_s")
        self.low = np.ravel(group.attrs["origin_m"])[:2].astype(float)
        self.count = group["count"][:].sum(axis=0).astype(float)
        self._layers = {name.removesuffix("_m3"): group[name][:].astype(float) for name in group
                        if group[name].ndim == 3}
        self.high = self.low + self.cell * np.array(self.count.shape[::-1])
        self.outside = self._outside()

    def name(self):
        """The voxel's side in particle radii, such as '2R'; in mm where the radius is unknown."""
        ratio = self.cell / self.radius
        if not np.isfinite(ratio):
            return f"{self.cell * 1e3:.3g} mm"
        return "R" if abs(ratio - 1) < 1e-3 else f"{ratio:.3g}R"

    def title(self):
        ny, nx = self.count.shape
        return f"{nx} × {ny} voxels of side {self.name().replace('R', ' $R$').strip()}"

    def file_name(self):
        return self.name().replace(" ", "_").replace(".", "p")

    def edges(self):
        ny, nx = self.count.shape
        return tuple(low + self.cell * np.arange(n + 1) for low, n in zip(self.low, (nx, ny)))

    def centres(self):
        x, y = self.edges()
        return (x[:-1] + x[1:]) / 2, (y[:-1] + y[1:]) / 2

    def _outside(self):
        """Voxels that hold next to nothing of the drum's open space."""
        open_volume = self._layers.get("open_volume")
        if open_volume is not None:
            total = np.nan_to_num(open_volume).sum(axis=0)
            return total <= LEAST_OPEN * total.max()
        if not self.drum_radius:
            return np.zeros(self.count.shape, bool)
        x, y = self.centres()
        return np.hypot(*np.meshgrid(x, y)) > self.drum_radius

    def _mean(self, name, weight):
        values = self._layers[name]
        weight = np.where(np.isfinite(values), weight, 0.0)
        total = weight.sum(axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = (np.nan_to_num(values) * weight).sum(axis=0) / total
        return np.where((total > 0) & ~self.outside, mean, np.nan)

    def porosity(self):
        weight = self._layers.get("open_volume", np.ones_like(self._layers["solidity"]))
        return 1 - self._mean("solidity", weight)

    def motion(self, name):
        """velocity_x, velocity_y, velocity_z, speed or granular_temperature."""
        mean = self._mean(name, self._layers["count"])
        return np.where(self.count >= LEAST_COUNT, mean, np.nan)

    def has(self, name):
        return name in self._layers
