# SPDX-License-Identifier: Apache-2.0
"""A run folder as the figures see it; everything is read when it is first asked for.

Whatever is missing raises NotRecorded with the reason; nothing is made up for it.
"""
import functools
import glob
import json
import os

import h5py
import numpy as np

from figures.grid import Grid
from figures.liner import Liner
from figures.scenery import read_scene, standing, with_scenery
from figures.table import NotRecorded, read_table


class NotRun(Exception):
    """The folder is not a run folder."""


class Run:
    MARKS = ("scene.yaml", "resolved.yaml", "series.csv", "summary.json", "fields.h5", "frames")

    def __init__(self, folder):
        self.folder = folder
        if not os.path.isdir(folder):
            raise NotRun(f"{folder}: there is no such folder")
        if not any(os.path.exists(self.path(mark)) for mark in self.MARKS):
            raise NotRun(f"{folder}: not a run folder (none of {', '.join(self.MARKS)} in it)")

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    @functools.cached_property
    def summary(self):
        try:
            with open(self.path("summary.json"), encoding="utf-8") as file:
                return json.load(file)
        except (OSError, ValueError):
            return {}

    def number(self, key):
        """A number of the summary, or None."""
        value = self.summary.get(key)
        good = isinstance(value, (int, float)) and not isinstance(value, bool)
        return float(value) if good and np.isfinite(value) else None

    @functools.cached_property
    def grids(self):
        """The voxel grids that hold a sample, finest first."""
        path = self.path("fields.h5")
        if not os.path.exists(path):
            raise NotRecorded("no fields.h5: no sample of the fields was taken")
        try:
            with h5py.File(path, "r") as file:
                grids = [Grid(file[name]) for name in sorted(file) if name.startswith("grid")]
        except OSError as error:
            raise NotRecorded(f"fields.h5 can't be read: {error}") from None
        grids = [grid for grid in grids if grid.samples > 0]
        if not grids:
            raise NotRecorded("fields.h5 holds no grid with a sample in it")
        return sorted(grids, key=lambda grid: grid.cell)

    def need_means(self):
        """Raises NotRecorded if the samples are too few for a mean over time."""
        samples = self.grids[0].samples
        with h5py.File(self.path("fields.h5"), "r") as file:
            least = int(attribute(file, "samples_least", default=1))
        if samples < least:
            raise NotRecorded(f"fields.h5 holds {samples} of the {least} samples that a mean needs")

    @property
    def means(self):
        """The grids, once they hold means over time."""
        self.need_means()
        return self.grids

    @functools.cached_property
    def ring(self):
        """Angle (deg from straight down) and solidity of the ring along the shell, and the radius
        (m) from which on balls are counted."""
        self.need_means()
        try:
            with h5py.File(self.path("fields.h5"), "r") as file:
                group = file["ring"]
                return (np.ravel(group["angle_deg"][:]), np.ravel(group["solidity"][:]),
                        attribute(group, "inner_radius_m"))
        except (OSError, KeyError):
            raise NotRecorded("fields.h5 holds no ring") from None

    def _last(self, kind):
        names = sorted(glob.glob(self.path("frames", f"{kind}_*.hdf")))
        for name in reversed(names):
            try:
                return h5py.File(name, "r")
            except OSError:
                continue  # being written, or cut off with the machine
        raise NotRecorded(f"no whole frames/{kind}_*.hdf" if names else f"no frames/{kind}_*.hdf")

    @functools.cached_property
    def frame(self):
        """The last frame without fixed balls: a dict of arrays, with `position` and, in seconds,
        `time`."""
        with self._last("frame") as file:
            root = file["VTKHDF"]
            data = {name: root["PointData"][name][:] for name in root["PointData"]}
            data["position"] = root["Points"][:].astype(float)
            time = float(attribute(file, "time_s", "time"))
        if "radius" not in data:
            raise NotRecorded("the last frame holds no radius")
        data["radius"] = np.ravel(data["radius"]).astype(float)
        moves = np.ones(len(data["radius"]), bool)
        for ball in self.scene.fixed:  # frames are in single precision
            apart = np.abs(data["position"] - ball.centre).max(axis=1)
            moves &= apart > 1e-6 * (ball.radius + np.abs(ball.centre).max())
        if not moves.any():
            raise NotRecorded("the last frame holds no particle that can move")
        return {"time": time, **{name: values[moves] for name, values in data.items()}}

    @functools.cached_property
    def section(self):
        """z (m) of the cross-section that is drawn: the middle of the drum, else where a plane
        through some particle's centre cuts the largest area of particles."""
        if self.drum_radius and self.liner:
            return float(np.mean((self.liner.points[:, 2].min(), self.liner.points[:, 2].max())))
        z, radius = self.frame["position"][:, 2], self.frame["radius"]
        tried = np.unique(z)
        tried = tried[::max(1, len(tried) // 500)]
        area = [np.maximum(0, radius ** 2 - (z - at) ** 2).sum() for at in tried]
        return float(tried[np.argmax(area)])

    @functools.cached_property
    def scene(self):
        """Planes, fixed balls and the radius of the balls, as resolved.yaml has them."""
        return read_scene(self.path("resolved.yaml"))

    @functools.cached_property
    def liner(self):
        """The liner of the last frame, or None."""
        try:
            with self._last("liner") as file:
                return Liner(file["VTKHDF"])
        except (NotRecorded, KeyError):
            return None

    @functools.cached_property
    def outline(self):
        """Segments [n, 2, 2] (m) where the section cuts the last liner, or None."""
        return self.liner.outline(self.section) if self.liner else None

    @functools.cached_property
    def lifter_tips(self):
        """Radius (m) of the circle that the lifters' tips run on, or None."""
        return self.liner.tips() if self.liner else None

    @functools.cached_property
    def drum_radius(self):
        """m, or None in a world without a drum."""
        try:
            radius = self.grids[0].drum_radius
            if radius:
                return radius
        except NotRecorded:
            pass
        return self.liner.drum_radius() if self.liner else None

    def extent(self):
        """Lower and upper corner (m) of what the pictures of a section show."""
        if self.drum_radius:
            margin = 1.09 * self.drum_radius
            return np.array([-margin, -margin]), np.array([margin, margin])
        try:
            centre, radius = self.frame["position"][:, :2], self.frame["radius"].max()
        except NotRecorded:
            grid = self.grids[0]
            return grid.low, grid.high
        margin = 2 * radius + 0.05 * np.ptp(centre, axis=0).max()
        scene = standing(self.scene, self.frame["time"])
        return with_scenery(scene, centre.min(axis=0) - margin, centre.max(axis=0) + margin,
                            self.section)

    @functools.cached_property
    def series(self):
        return read_table(self.path("series.csv"))

    @functools.cached_property
    def traces(self):
        return read_table(self.path("traces.csv"))

    @functools.cached_property
    def trace_contacts(self):
        return read_table(self.path("trace_contacts.csv"))


def attribute(item, *names, default=np.nan):
    """The first of some attributes that an HDF5 object has, as a plain number."""
    for name in names:
        if name in item.attrs:
            return np.ravel(item.attrs[name])[0]
    return default
