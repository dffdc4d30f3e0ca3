# SPDX-License-Identifier: Apache-2.0
"""Checks what the small mill has recorded (mill.c) with h5py and nothing of ours.

Frames against the VTKHDF description (UnstructuredGrid, version 1.0), against the traces and the
drum; fields.h5 against its own sums; series.h5 against series.csv; summary.json for its keys.
"""
import csv
import json
import os
import sys

import h5py
import numpy as np

folder = sys.argv[1]
PARTICLES, STEP, EVERY, DRUM, LENGTH, SPEED = 80, 20e-6, 200, 0.020, 0.012, 20.0
KEYS = """particles steps time_s dt_s wall_s particle_steps_per_s threads backend critical_speed_rad_s
speed_rad_s power_torque_w power_stderr_w power_dissipated_w steady energy_residual_relative
max_overlap_over_radius contacts_per_particle solidity_bulk shoulder_deg toe_deg state_hash""".split()


def path(*names):
    return os.path.join(folder, *names)


def check_grid(file):
    """What a reader of VTKHDF 1.0 counts on; returns the root group."""
    root = file["VTKHDF"]
    assert tuple(root.attrs["Version"]) == (1, 0)
    assert root.attrs["Type"] == b"UnstructuredGrid"
    points, cells = root["NumberOfPoints"][0], root["NumberOfCells"][0]
    assert root["Points"].shape == (points, 3) and root["Points"].dtype == np.float32
    assert root["Types"].shape == (cells,) and root["Types"].dtype == np.uint8
    assert root["Offsets"].shape == (cells + 1,) and root["Offsets"][0] == 0
    assert root["Connectivity"].shape == (root["NumberOfConnectivityIds"][0],)
    assert root["Offsets"][-1] == root["NumberOfConnectivityIds"][0]
    assert root["Connectivity"][:].max() < points
    return root


def table(name):
    with open(path(name), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def check_frames():
    with open(path("frames", "frames.hdf.series"), encoding="utf-8") as file:
        files = json.load(file)["files"]
    assert [f["time"] for f in files] == [i * EVERY * STEP for i in range(11)]
    traces = {(int(row["step"]), int(row["id"])): row for row in table("traces.csv")}
    for i, entry in enumerate(files):
        with h5py.File(path("frames", entry["name"]), "r") as file:
            root = check_grid(file)
            assert file.attrs["step"] == i * EVERY and file.attrs["time_s"] == entry["time"]
            assert root["NumberOfCells"][0] == 1 and root["Types"][0] == 2
            ids, data = root["PointData/id"][:], root["PointData"]
            assert (ids == np.arange(1, PARTICLES + 1)).all()
            speed = np.linalg.norm(data["velocity"][:], axis=1)
            assert np.allclose(speed, data["speed"][:], rtol=1e-5, atol=1e-9)
            assert (data["radius"][:] == np.float32(0.002)).all()
            assert (np.hypot(*root["Points"][:, :2].T) < DRUM - 0.0018).all()
            for one in (1, 7):
                row = traces[i * EVERY, one]
                for names, have in ((("x_m", "y_m", "z_m"), root["Points"]),
                                    (("vx_m_s", "vy_m_s", "vz_m_s"), data["velocity"]),
                                    (("wx_rad_s", "wy_rad_s", "wz_rad_s"), data["spin"])):
                    want = np.array([row[n] for n in names], float)
                    assert np.allclose(have[one - 1], want, rtol=1e-6, atol=1e-9)


def check_liner():
    with open(path("frames", "liner.hdf.series"), encoding="utf-8") as file:
        files = json.load(file)["files"]
    tips = []
    for entry in files:
        with h5py.File(path("frames", entry["name"]), "r") as file:
            root = check_grid(file)
            assert (root["Types"][:] == 9).all()
            points = root["Points"][:].astype(float)
            assert set(np.unique(points[:, 2])) == {0, np.float32(LENGTH)}
            radius = np.hypot(points[:, 0], points[:, 1])
            assert np.isclose(radius.max(), DRUM, rtol=1e-4)
            assert DRUM - 0.0032 < radius.min() < DRUM - 0.0025
            lifter = root["CellData/lifter"][:]
            assert set(lifter) == {0, 1, 2, 3, 4}
            corners = root["Connectivity"][:].reshape(-1, 4)[lifter == 1]
            tips.append(points[corners.ravel(), :2].mean(axis=0))
    turned = np.unwrap(np.arctan2([y for _, y in tips], [x for x, _ in tips]))
    assert np.allclose(turned - turned[0], SPEED * STEP * EVERY * np.arange(11), atol=1e-5)


def check_fields():
    rows = [row for row in table("series.csv") if 400 <= int(row["step"]) < 1900]
    centre = [np.mean([float(row[f"centre_{axis}_m"]) for row in rows]) for axis in "xy"]
    with h5py.File(path("fields.h5"), "r") as file:
        for name, cell in (("grid_0", 0.002), ("grid_1", 0.004)):
            grid = file[name]
            count, samples = grid["count"][:], grid.attrs["samples"]
            side = round(2 * DRUM / cell)
            assert count.shape == (1, side, side)
            places = grid.attrs["origin_m"][:2, None] + cell * (np.arange(side) + 0.5)
            found = [(count.sum(axis=(0, 1 if a == 0 else 2)) * places[a]).sum() / count.sum()
                     for a in (0, 1)]
            assert np.allclose(found, centre, atol=0.2 * cell), (found, centre)
            assert count.sum() == PARTICLES * samples == PARTICLES * 150
            assert np.isclose(grid.attrs["cell_m"], cell)
            assert np.isclose(grid.attrs["first_time_s"], 400 * STEP)
            assert np.isclose(grid.attrs["last_time_s"], 1890 * STEP)
            ball = 4 / 3 * np.pi * 0.002 ** 3
            assert np.isclose(grid["solid_volume_m3"][:].sum(), PARTICLES * samples * ball, rtol=0.02)
            seen = count > 0
            assert np.allclose(grid["velocity_x"][:][seen],
                               grid["velocity_sum_x"][:][seen] / count[seen])
            voxel = cell * cell * grid.attrs["layer_m"]
            assert np.allclose(grid["solidity_raw"][:][seen], count[seen] * ball / (samples * voxel),
                               rtol=1e-6)
            assert (np.isnan(grid["speed"][:]) == ~seen).all()
        assert file["ring/angle_deg"].shape == file["ring/solidity"].shape == (360,)


def check_series():
    rows = table("series.csv")
    assert [int(row["step"]) for row in rows] == list(range(0, 2001, 20))
    with h5py.File(path("series.h5"), "r") as file:
        assert set(file["series"]) == set(rows[0])
        for name, data in file["series"].items():
            want = np.array([float(row[name]) for row in rows])
            assert np.array_equal(data[:], want, equal_nan=True) and data.attrs["unit"]


with open(path("summary.json"), encoding="utf-8") as summary:
    found = json.load(summary)
assert not [key for key in KEYS if key not in found]
assert found["steps"] == 2000 and len(found["state_hash"]) == 16
check_frames()
check_liner()
check_fields()
check_series()
