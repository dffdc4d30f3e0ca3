# SPDX-License-Identifier: Apache-2.0
"""A run folder as the figures see it; everything is read when it is first asked for.

Whatever is missing raises NotRecorded with the reason; nothing is made up for it.
"""
import csv
import functools
import glob
import json
import os

import h5py
import numpy as np

from figures.grid import Grid
from figures.section import slice_cells


QUAD = 9  # VTK's number for a quadrangle


class NotRun(Exception):
    """The folder is not a run folder."""


class NotRecorded(Exception):
    """What a figure needs was not recorded."""


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
        """The voxel grids, finest first."""
        path = self.path("fields.h5")
        if not os.path.exists(path):
            raise NotRecorded("no fields.h5: sampling of the fields had not begun")
        try:
            with h5py.File(path, "r") as file:
                grids = [Grid(file[name]) for name in sorted(file) if name.startswith("grid")]
        except OSError as error:
            raise NotRecorded(f"fields.h5 can't be read: {error}") from None
        grids = [grid for grid in grids if grid.samples > 0]
        if not grids:
            raise NotRecorded("fields.h5 holds no grid with a sample in it")
        return sorted(grids, key=lambda grid: grid.cell)

    @functools.cached_property
    def ring(self):
        """Angle (deg from straight down) and solidity of the ring along the shell."""
        try:
            with h5py.File(self.path("fields.h5"), "r") as file:
                group = file["ring"]
                angle = next(group[name][:] for name in group if name.startswith("angle"))
                solidity = next(group[name][:] for name in group if name.startswith("solidity"))
        except (OSError, KeyError, StopIteration):
            raise NotRecorded("fields.h5 holds no ring") from None
        return np.ravel(angle), np.ravel(solidity)

    def _last(self, kind):
        names = sorted(glob.glob(self.path("frames", f"{kind}_*.hdf")))
        for name in reversed(names):
            try:
                return h5py.File(name, "r")
            except OSError:
                continue  # being written, or cut off with the machine
        raise NotRecorded(f"no frames/{kind}_*.hdf")

    @functools.cached_property
    def frame(self):
        """The last frame: a dict of arrays, with `position` and, in seconds, `time`."""
        with self._last("frame") as file:
            root = file["VTKHDF"]
            data = {name: root["PointData"][name][:] for name in root["PointData"]}
            data["position"] = root["Points"][:].astype(float)
            data["time"] = float(attribute(file, "time_s", "time"))
        if "radius" not in data or not len(data["position"]):
            raise NotRecorded("the last frame holds no particle with a radius")
        data["radius"] = np.ravel(data["radius"]).astype(float)
        return data

    @functools.cached_property
    def section(self):
        """z (m) of the cross-section that is drawn: the middle of the drum or of the particles."""
        try:
            with self._last("liner") as file:
                z = file["VTKHDF/Points"][:, 2]
        except NotRecorded:
            z = self.frame["position"][:, 2]
        return float((np.min(z) + np.max(z)) / 2)

    @functools.cached_property
    def outline(self):
        """Segments [n, 2, 2] (m) where the section cuts the last liner, or None."""
        try:
            with self._last("liner") as file:
                root = file["VTKHDF"]
                return slice_cells(root["Points"][:].astype(float), root["Connectivity"][:],
                                   root["Offsets"][:], self.section)
        except (NotRecorded, KeyError):
            return None

    @functools.cached_property
    def drum_radius(self):
        """m, or None in a world without a drum."""
        try:
            radius = self.grids[0].drum_radius
            if radius:
                return radius
        except NotRecorded:
            pass
        try:
            with self._last("liner") as file:
                root = file["VTKHDF"]
                first = root["Offsets"][:-1][root["Types"][:] == QUAD]  # of the drum's profile
                corner = root["Points"][:][root["Connectivity"][:][first], :2]
        except (NotRecorded, KeyError):
            return None
        return float(np.hypot(*corner.T).max()) if len(corner) else None

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
        return centre.min(axis=0) - margin, centre.max(axis=0) + margin

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


def read_table(path):
    """A CSV file as a dict of columns: numbers where all are numbers, else strings. A last line
    that was cut off while being written is left out."""
    name = os.path.basename(path)
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    except OSError:
        raise NotRecorded(f"no {name}") from None
    if len(rows) < 2:
        raise NotRecorded(f"{name} holds no row yet")
    head = [title.strip() for title in rows[0]]
    rows = [row for row in rows[1:] if len(row) == len(head)]
    if not rows:
        raise NotRecorded(f"{name} holds no whole row yet")
    table = {}
    for title, column in zip(head, zip(*rows)):
        try:
            table[title] = np.array([float(text) if text else np.nan for text in column])
        except ValueError:
            table[title] = np.array(column)
    return table
