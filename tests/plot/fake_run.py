# SPDX-License-Identifier: Apache-2.0
"""Makes a run folder of invented numbers, in the layout of a real one, to try the figures on.

    python3 fake_run.py FOLDER [mill|drop]

The mill is a kidney of charge that turns with the shell and falls back over a free surface; the
drop is one ball that bounces on a plane. Only shapes and units are meant to be right.
"""
import json
import os
import sys

import h5py
import numpy as np

DRUM, BALL, LENGTH = 0.15, 0.0015, 0.012  # m   radius of drum and ball, length of the slice
SPEED = 5.66                              # rad/s
LIFTERS, HEIGHT = 16, 0.006               # 1, m


DROP = """\
format: quern-scene/1
walls:
  floor: {shape: plane, material: glass, point: 0 0 0 m, normal: 0 2 0}
  my box_low: {shape: plane, material: glass, point: 0.5 0 1 m, normal: -3 0 4}
particles:
  ball:
    fixed: no
    fill: at
    at: 0 0.1 0 m
    diameter: 0.003 m
  anvil:
    fixed: yes
    fill: at
    at: 0.1 0 0 m
    diameter: 0.003 m
measure:
  series: 0.0001 s
"""


def flow(x, y):
    """Solidity and velocity (m/s) of the invented charge at points (m) of the section."""
    rho, angle = np.hypot(x, y), np.arctan2(y, x)
    turned = (angle + np.pi / 2 + np.pi) % (2 * np.pi) - np.pi  # from straight down
    surface = 0.1 * DRUM - 0.55 * x + 0.8 * y                   # > 0 above the bed
    bed = 1 / (1 + np.exp(surface / (0.012 * DRUM) + 6))
    flying = 0.06 * np.exp(-((turned - 1.9) / 0.7) ** 2) * (rho > 0.3 * DRUM)
    solidity = np.where(rho < DRUM, 0.58 * bed + flying * (1 - bed), 0)
    fast = np.clip((rho / DRUM - 0.55) / 0.25, -1, 1)
    vx = -SPEED * y * fast - 0.5 * (1 - bed)
    vy = SPEED * x * fast - 0.6 * (1 - bed)
    return solidity, vx, vy


def write_fields(folder, cells, layers, rng):
    samples, voxel_height = 400, LENGTH / layers
    with h5py.File(os.path.join(folder, "fields.h5"), "w") as file:
        file.attrs["format"] = "quern-recording/1"
        file.attrs["samples_least"] = 98
        for index, cell_in_radii in enumerate(cells):
            cell = cell_in_radii * BALL
            n = int(np.ceil(2 * DRUM / cell))
            low = -n * cell / 2
            centre = low + cell * (np.arange(n) + 0.5)
            x, y = np.meshgrid(centre, centre)
            shape = (layers, n, n)
            solidity, vx, vy = flow(x, y)
            volume = cell * cell * voxel_height
            ball = 4 / 3 * np.pi * BALL ** 3
            rho = np.hypot(x, y)
            share = np.clip((DRUM + cell / 2 - rho) / cell, 0, 1)
            count = rng.poisson(np.broadcast_to(solidity * share * volume * samples / ball, shape))
            seen = np.where(count > 0, count, 1)
            noise = rng.normal(size=(4,) + shape) * 0.15 / np.sqrt(seen)
            empty = np.where(count > 0, 0, np.nan)
            group = file.create_group(f"grid_{index}")
            group.attrs.update(cell_m=cell, layer_m=voxel_height, origin_m=[low, low, 0.0],
                               samples=samples, radius_m=BALL, drum_radius_m=DRUM,
                               first_time_s=2.22, last_time_s=4.44)
            group["count"] = count
            group["open_volume_m3"] = np.broadcast_to(share * volume, shape)
            with np.errstate(divide="ignore", invalid="ignore"):
                group["solidity"] = np.where(share > 0, count * ball / (samples * share * volume),
                                             np.nan)
                group["porosity"] = 1 - group["solidity"][:]
            group["velocity_x"] = vx + noise[0] + empty
            group["velocity_y"] = vy + noise[1] + empty
            group["velocity_z"] = noise[2] + empty
            group["speed"] = np.hypot(vx, vy) + np.abs(noise[3]) + empty
            group["granular_temperature"] = 0.02 * np.exp(-solidity / 0.2) + 0 * noise[0] + empty
        angle = np.arange(-180, 180, 2.0) + 1
        ring = file.create_group("ring")
        ring.attrs.update(inner_radius_m=DRUM - HEIGHT - 4 * BALL, samples=samples)
        ring["angle_deg"] = angle
        ring["solidity"] = 0.57 / (1 + np.exp((np.abs(angle - 25) - 55) / 5)) + 0.02


def write_vtk(path, points, connectivity, offsets, kinds, arrays, **attributes):
    with h5py.File(path, "w") as file:
        file.attrs.update(attributes, format="quern-recording/1")
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = (1, 0)
        root.attrs["Type"] = np.bytes_("UnstructuredGrid")
        root["Points"] = points.astype("f4")
        root["Connectivity"], root["Offsets"] = connectivity, offsets
        root["Types"] = np.array(kinds, "u1")
        data = root.create_group("PointData")
        for name, values in arrays.items():
            data[name] = values


def write_frame(folder, rng):
    step = 2.02 * BALL
    grid = np.mgrid[-DRUM:DRUM:step, -DRUM:DRUM:step, BALL:LENGTH:step].reshape(3, -1).T
    position = grid + rng.normal(scale=0.1 * BALL, size=grid.shape)
    solidity, vx, vy = flow(position[:, 0], position[:, 1])
    clear = np.hypot(position[:, 0], position[:, 1]) < DRUM - HEIGHT - BALL
    keep = clear & (rng.random(len(position)) < solidity / 0.55)
    position = position[keep]
    velocity = np.stack([vx[keep], vy[keep], 0 * vx[keep]], axis=1)
    velocity += rng.normal(scale=0.05, size=velocity.shape)
    n = len(position)
    write_vtk(os.path.join(folder, "frames", "frame_000042.hdf"), position, np.arange(n), [0, n],
              [2], {"id": np.arange(1, n + 1), "class": np.zeros(n, "i4"),
                    "radius": np.full(n, BALL, "f4"), "velocity": velocity.astype("f4"),
                    "speed": np.linalg.norm(velocity, axis=1).astype("f4"),
                    "spin": np.zeros((n, 3), "f4")}, step=88800, time_s=4.44)


def write_liner(folder):
    """Shell and lifters as quadrangles along the axis."""
    angles = np.linspace(0, 2 * np.pi, 16 * 24, endpoint=False)
    half = np.arcsin(HEIGHT / 2 / DRUM)
    section = []
    for k in range(LIFTERS):
        middle = 2 * np.pi * k / LIFTERS + 0.1
        top = DRUM - HEIGHT
        section += [(DRUM, middle - half), (top, middle - half), (top, middle + half),
                    (DRUM, middle + half)]
        between = middle + half + (2 * np.pi / LIFTERS - 2 * half) * np.linspace(0, 1, 24)[1:-1]
        section += [(DRUM, angle) for angle in between]
    section = np.array([(r * np.cos(a), r * np.sin(a)) for r, a in section])
    n = len(section)
    points = np.concatenate([np.c_[section, np.zeros(n)], np.c_[section, np.full(n, LENGTH)]])
    quads = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    write_vtk(os.path.join(folder, "frames", "liner_000042.hdf"), points, np.ravel(quads),
              4 * np.arange(n + 1), [9] * n, {}, step=88800, time_s=4.44)
    return len(angles)


def write_csv(path, columns):
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join(v if isinstance(v, str) else f"{v:.12g}" for v in row) + "\n")


def write_series(folder, rng):
    time = np.linspace(0, 4.44, 1500)
    ramp = np.clip((time - 0.3) / 0.8, 0, 1)
    power = 1.4 * ramp * (1 + 0.08 * np.sin(16 * SPEED * time))
    power += rng.normal(scale=0.15, size=time.size)
    work = np.cumsum(power) * (time[1] - time[0])
    kinetic, gravity = 0.03 * ramp ** 2, 0.2 + 0.05 * ramp
    elastic = 0.004 + 0.0005 * rng.normal(size=time.size)
    lost = work - (kinetic + gravity + elastic) + (kinetic + gravity + elastic)[0]
    split = {"lost_normal": 0.42, "lost_tangential": 0.06, "lost_sliding": 0.5,
             "lost_rolling": 0.0, "mindlin_residue": 0.02}
    columns = {"step": np.arange(time.size) * 60, "time_s": time,
               "kinetic_translation_j": kinetic * 0.9, "kinetic_rotation_j": kinetic * 0.1,
               "gravity_j": gravity, "elastic_normal_j": elastic * 0.9,
               "elastic_tangential_j": elastic * 0.1}
    columns.update({f"{name}_j": share * lost for name, share in split.items()})
    columns["work_j"] = work
    columns["residual_j"] = 1e-5 * rng.normal(size=time.size)
    write_csv(os.path.join(folder, "series.csv"), columns)


def write_bounces(folder):
    """One ball from 0.1 m onto a plane at y = 0: height, speed, spin, and its contacts."""
    radius, restitution, dt = 0.0015, 0.66, 1e-4
    time = np.arange(0, 0.6, dt)
    height, speed = np.empty_like(time), np.empty_like(time)
    y, v = 0.1, 0.0
    for i in range(time.size):
        height[i], speed[i] = y, v
        v -= 9.81 * dt
        y += v * dt
        if y < radius and v < 0:
            y, v = radius, -restitution * v
    zero = np.zeros_like(time)
    vx = np.linspace(0.5, 0.3, time.size)
    write_csv(os.path.join(folder, "traces.csv"), {
        "step": np.arange(time.size) * 100, "time_s": time, "id": zero + 1,
        "x_m": np.cumsum(vx) * dt, "y_m": height, "z_m": zero,
        "vx_m_s": vx, "vy_m_s": speed, "vz_m_s": zero,
        "wx_rad_s": zero, "wy_rad_s": zero, "wz_rad_s": -vx * 200})
    u = np.linspace(0, 1, 21)
    depth = 1.6e-5 * np.sin(np.pi * u) ** 1.1
    rows = {name: [] for name in ("step", "time_s", "id", "partner", "depth_m", "elastic_n",
                                  "damping_n", "normal_n", "tangential_x_n", "tangential_y_n",
                                  "tangential_z_n", "normal_x", "normal_y", "normal_z")}
    for bounce, size in enumerate((1, 0.8, 0.5)):
        elastic = size * 3e8 * depth ** 1.5
        damping = 0.25 * size * 19 * np.cos(np.pi * u) * np.sin(np.pi * u) ** 0.25
        at = np.arange(21)
        values = (142000 + 60000 * bounce + at, 0.142 + 0.06 * bounce + 1e-6 * at, u * 0 + 1,
                  ["floor"] * 21, depth, elastic, damping, elastic + damping,
                  -0.3 * elastic, u * 0, u * 0, u * 0, u * 0 + 1, u * 0)
        for column, value in zip(rows.values(), values):
            column.extend(value)
    write_csv(os.path.join(folder, "trace_contacts.csv"), rows)


def make_mill(folder, cells=(1, 2, 4), layers=1):
    rng = np.random.default_rng(1)
    os.makedirs(os.path.join(folder, "frames"), exist_ok=True)
    write_fields(folder, cells, layers, rng)
    write_frame(folder, rng)
    write_liner(folder)
    write_series(folder, rng)
    summary = {"particles": 1, "speed_rad_s": SPEED, "critical_speed_rad_s": 8.087,
               "power_torque_w": 1.4, "power_stderr_w": 0.03, "power_dissipated_w": 1.39,
               "solidity_bulk": 0.575, "shoulder_deg": 78.2, "toe_deg": -31.0, "steady": True}
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
        json.dump(summary, file)


def make_drop(folder):
    os.makedirs(os.path.join(folder, "frames"), exist_ok=True)
    write_bounces(folder)
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
        json.dump({"particles": 1}, file)
    with open(os.path.join(folder, "resolved.yaml"), "w", encoding="utf-8") as file:
        file.write(DROP)


if __name__ == "__main__":
    (make_drop if sys.argv[2:] == ["drop"] else make_mill)(sys.argv[1])
