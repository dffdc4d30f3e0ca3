#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the mills of the reference document as slices and writes docs/validation-mills.md (`make validate-mills`).

Each scene of RUNS goes into a folder of its own under --runs; one that is finished there is not run
again, one that was stopped goes on. The page is then made from what the folders hold, so a mill that was
not run, or not to its end, is told as such. With --report nothing is run.

    validation/mills.py BUILD [--runs out/mills] [--only thesis-slice-60,high-friction-46] [--report]
"""
import argparse
import os
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "plot"))
from figures.folder import Run  # noqa: E402
from figures.maps import draw_map  # noqa: E402

SLICES = ["thesis-slice-60", "thesis-slice-70", "thesis-slice-80"]
FRICTION = ["high-friction-none", "high-friction-42", "high-friction-44", "high-friction-46"]
MU = dict(zip(FRICTION, ("0.154", "0.42", "0.44", "0.46")))
LEAST_SAMPLES = 50  # 1   below which a run has no maps yet
DENSE = 0.3  # 1   solidity at which the charge has its surface
HEAD = """<!-- Written by `make validate-mills`; do not edit. -->
# The mills of the reference document

Slices of its drum of 300 mm: three rows of balls (mills) or four rings (linings), with periodic ends, softened
([scenes](../scenes)). Its own figures are of the full 270 mm with flat ends, under its own law. Each number
below comes from a run folder; what was not run, or not to its end, is said so.

`make validate-mills` runs them all, one after another: about an hour on two cores that are free.
"""


def run_all(build, folder, names):
    for name in names:
        out = os.path.join(folder, name)
        command = [os.path.join(build, "quern"), "run", os.path.join(ROOT, "scenes", name + ".yaml"),
                   "-o", out]
        if os.path.exists(out):
            command.append("--resume")
            run = load(folder, name)
            if run and run.summary.get("finished"):
                continue
        print(f"{name}: into {out}", flush=True)
        if subprocess.run(command, check=False).returncode:
            sys.exit(f"mills.py: {name} failed")


def load(folder, name):
    """The run of a scene, or None."""
    path = os.path.join(folder, name)
    return Run(path) if os.path.exists(os.path.join(path, "summary.json")) else None


def grid_of(run):
    """The grid of voxels of 2 R, if it has enough samples."""
    if run is None or not os.path.exists(run.path("fields.h5")):
        return None
    grids = [g for g in run.grids if g.name() == "2R" and g.samples >= LEAST_SAMPLES]
    return grids[0] if grids else None


def state(run):
    if run is None:
        return "not run"
    if not run.summary.get("finished"):
        return f"run to {run.number('time_s'):.2f} s, not to its end"
    return f"run to its end, {run.number('time_s'):.2f} s"


def at_shell(run, grid):
    """Mean speed around the axis (m/s) of the charge within R to 2.5 R of the shell, where it is dense."""
    x, y = np.meshgrid(*grid.centres())
    rho, radius = np.hypot(x, y), run.drum_radius
    off, ball = radius - rho, grid.radius
    near = (off >= ball) & (off <= 2.5 * ball) & (1 - grid.porosity() > 0.5)
    around = (grid.motion("velocity_y") * x - grid.motion("velocity_x") * y) / rho
    return np.nanmean(around[near] * radius / rho[near])


def splash(grid):
    """Granular temperature (m2/s2) where the charge is thin (solidity below 0.1): its median in the free
    stream (above y = -R/4), the largest on the toe's side (x < -0.3 R), and where that is (m)."""
    x, y = np.meshgrid(*grid.centres())
    hot = grid.motion("granular_temperature")
    thin = (1 - grid.porosity() < 0.1) & (grid.count >= 20)
    stream = np.nanmedian(hot[thin & (y > -0.25 * grid.drum_radius)])
    toe = np.where(thin & (x < -0.3 * grid.drum_radius), np.nan_to_num(hot), -1)
    k = np.argmax(toe)
    return stream, toe.flat[k], x.flat[k], y.flat[k]


def surface(grid):
    """The charge's upper surface (m), along and above the straight line fitted to it, and the slope of
    that line (deg): the highest place of solidity DENSE above each point of the line."""
    solid = np.nan_to_num(1 - grid.porosity())
    x, y = grid.centres()

    def sample(px, py):
        i = np.clip(((px - x[0]) / grid.cell + 0.5).astype(int), 0, len(x) - 1)
        j = np.clip(((py - y[0]) / grid.cell + 0.5).astype(int), 0, len(y) - 1)
        return solid[j, i]

    slope = np.radians(35)
    reach = grid.drum_radius - 4 * grid.cell  # the lining and its ring of voxels are left out
    for _ in range(8):
        along = np.arange(-reach, reach, grid.cell / 2)
        above = np.arange(-reach, reach, grid.cell / 8)
        u, v = np.meshgrid(along, above)
        px, py = u * np.cos(slope) - v * np.sin(slope), u * np.sin(slope) + v * np.cos(slope)
        dense = (sample(px, py) >= DENSE) & (np.hypot(px, py) < reach)
        found = dense.any(axis=0)
        top = above[len(above) - 1 - np.argmax(dense[::-1], axis=0)]
        edge = np.hypot(along, top) > reach - 2 * grid.cell  # the shell, not the surface
        found &= ~edge
        u, v = along[found], top[found]
        tilt = np.polyfit(u, v, 1)[0]
        slope += np.arctan(tilt)
    return u, v - np.polyval(np.polyfit(u, v, 1), u), np.degrees(slope)


def bends(u, v):
    """How far the surface rises above its chord in the upper half and sinks below it in the lower, by
    the chord's length: an S has both well above 0."""
    chord = v[0] + (v[-1] - v[0]) * (u - u[0]) / (u[-1] - u[0])
    off, length, middle = v - chord, u[-1] - u[0], (u[0] + u[-1]) / 2
    return max(0, off[u >= middle].max()) / length, max(0, -off[u < middle].min()) / length


def maps(runs, labels, path):
    """Porosity above, velocity below, one column for each run."""
    figure, axes = plt.subplots(2, len(runs), figsize=(3.1 * len(runs), 6.4), squeeze=False,
                                layout="constrained")
    top = max(np.nanpercentile(grid_of(r).motion("speed"), 98) for r in runs)
    for k, (run, label) in enumerate(zip(runs, labels)):
        grid = grid_of(run)
        one = draw_map(axes[0, k], run, grid, grid.porosity(), cmap="cividis", vmin=0.3, vmax=1)
        two = draw_map(axes[1, k], run, grid, grid.motion("speed"), cmap="viridis", vmin=0, vmax=top)
        x, y = (c * 1e3 for c in grid.centres())
        vx, vy = grid.motion("velocity_x"), grid.motion("velocity_y")
        every = (slice(None, None, 4),) * 2
        axes[1, k].quiver(x[::4], y[::4], vx[every], vy[every], color="white", scale=25, width=0.004)
        axes[0, k].set_title(f"{label}\n{grid.samples} samples, {grid.first_time:.2f} to "
                             f"{grid.last_time:.2f} s", fontsize=8)
    figure.colorbar(one, ax=axes[0], label="porosity (–)", extend="min")
    figure.colorbar(two, ax=axes[1], label="mean speed (m/s)", extend="max")
    figure.savefig(path, dpi=110)
    plt.close(figure)


def surfaces(runs, labels, path):
    figure, axes = plt.subplots(figsize=(5.2, 3), layout="constrained")
    for run, label in zip(runs, labels):
        u, v, slope = surface(grid_of(run))
        axes.plot(u * 1e3, v * 1e3, label=f"{label}, {slope:.0f}°")
    axes.axhline(0, color="grey", linewidth=0.5)
    axes.set_xlabel("along the surface, toe to shoulder (mm)")
    axes.set_ylabel("above its straight line (mm)")
    axes.legend(fontsize=8)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def number(value, form):
    return format(value, form) if value is not None and np.isfinite(value) else "–"


def slices_part(found, images):
    lines = ["", "## The mill at 60, 70 and 80 % of its critical speed", "",
             "| scene | state | shell (m/s) | charge at the shell (m/s) | bulk solidity | shoulder | toe "
             "| power (W) | granular temperature in the stream, at the toe (m²/s²) |", "|---|---|---|---|---|---|---|---|---|"]
    for name in SLICES:
        run, grid = found[name], grid_of(found[name])
        row = [f"`{name}`", state(run)] + ["–"] * 7
        if grid is not None:
            s = run.summary
            stream, toe, x, y = splash(grid)
            row[2:] = [number(run.number("speed_rad_s") * run.drum_radius, ".3f"),
                       number(at_shell(run, grid), ".3f"), number(s.get("solidity_bulk"), ".3f"),
                       number(s.get("shoulder_deg"), ".1f") + "°", number(s.get("toe_deg"), ".1f") + "°",
                       f"{number(s.get('power_torque_w'), '.3f')} ± {number(s.get('power_stderr_w'), '.3f')}",
                       f"{stream:.3f}, {toe:.2f} at ({x * 1e3:.0f}, {y * 1e3:.0f}) mm"]
        lines.append("| " + " | ".join(row) + " |")
    lines += ["", "Angles are from straight down, positive in the sense of rotation. *Charge at the shell*: mean "
              "speed around the axis in voxels of solidity above 0.5 within R to 2.5 R of the shell, "
              "brought to the shell's radius. *Granular temperature*: the variance of the balls' velocities in a "
              "voxel, where the charge is thin (solidity below 0.1): its median in the free stream, and "
              "its largest on the toe's side; balls that bounce there mix with those that fall."]
    drawn = [n for n in SLICES if grid_of(found[n]) is not None]
    if drawn:
        maps([found[n] for n in drawn], [n[-2:] + " % of critical" for n in drawn],
             os.path.join(images, "mills-slices.png"))
        lines += ["", "![Porosity and velocity](img/mills-slices.png)"]
    lines += ["", "| the document says (6.2) | what the slices show |", "|---|---|"]
    lines += ["| " + " | ".join(row) + " |" for row in slice_verdicts(found)]
    return lines


def slice_verdicts(found):
    grids = {n: grid_of(found[n]) for n in SLICES}
    done = [n for n in SLICES if grids[n] is not None]
    first = grids[SLICES[0]]
    rows = []
    if first is not None:
        speed = at_shell(found[SLICES[0]], first)
        rows.append(["at 60 % the shell moves at 0.73 m/s and balls at the edge at about 0.7 m/s",
                     f"shell {found[SLICES[0]].number('speed_rad_s') * found[SLICES[0]].drum_radius:.3f} m/s; "
                     f"the charge there {speed:.3f} m/s"])
    rows.append(["the solidity of the charge is 0.5 to 0.6", "; ".join(
        f"{n[-2:]} %: {number(found[n].summary.get('solidity_bulk'), '.3f')}" for n in done) or "not run"])
    shoulders = [found[n].summary.get("shoulder_deg") for n in done]
    rising = len(done) > 1 and all(a < b for a, b in zip(shoulders, shoulders[1:]))
    rows.append(["the shoulder rises with the speed (its figures)", ", ".join(
        f"{number(s, '.1f')}° at {n[-2:]} %" for n, s in zip(done, shoulders))
        + (": it does" if rising else ": one speed shows no trend" if len(done) < 2 else ": it does not")])
    rows.append(["balls splash where they land at the toe (its figures)", "; ".join(
        "{}: {:.2f} m²/s² against {:.3f} in the stream".format(n[-2:] + " %", *splash(grids[n])[1::-1])
        for n in done) or "not run"])
    return rows


def friction_part(found, images):
    lines = ["", "## High friction: does an S-shape appear?", "",
             "A drum without lifters, lined with turning spheres, at half its critical speed (its section 6.3 "
             "and Fig 6.13). All friction between spheres, those of the lining included, is μ.", "",
             "| scene | μ | state | slope of the surface | above its chord, upper half | below its chord, "
             "lower half | power (W) | solidity |", "|---|---|---|---|---|---|---|---|"]
    for name in FRICTION:
        run, grid = found[name], grid_of(found[name])
        row = [f"`{name}`", MU[name], state(run)] + ["–"] * 5
        if grid is not None:
            u, v, slope = surface(grid)
            up, down = bends(u, v)
            row[3:] = [f"{slope:.1f}°", f"{100 * up:.1f} %", f"{100 * down:.1f} %",
                       number(run.summary.get("power_torque_w"), ".3f"),
                       number(run.summary.get("solidity_bulk"), ".3f")]
        lines.append("| " + " | ".join(row) + " |")
    lines += ["", "The surface is where the solidity of voxels of 2 R is 0.3, without the outermost 20 mm "
              "or so at either end. The chord joins its ends; deviations are by its length. An S rises above "
              "its chord in the upper half and sinks below it in the lower."]
    drawn = [n for n in FRICTION if grid_of(found[n]) is not None]
    if drawn:
        labels = ["μ = " + MU[n] for n in drawn]
        maps([found[n] for n in drawn], labels, os.path.join(images, "mills-friction.png"))
        surfaces([found[n] for n in drawn], labels, os.path.join(images, "mills-surfaces.png"))
        lines += ["", "![Porosity and velocity](img/mills-friction.png)", "",
                  "![Surfaces](img/mills-surfaces.png)"]
    return lines


def remarks(path):
    """What a person saw in the pictures; kept beside this script."""
    with open(path, encoding="utf-8") as file:
        return ["", "## What is seen", ""] + file.read().splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--runs", default=os.path.join(ROOT, "out", "mills"))
    parser.add_argument("--only", default=",".join(SLICES + FRICTION))
    parser.add_argument("--report", action="store_true")
    options = parser.parse_args()
    if not options.report:
        run_all(options.build, options.runs, options.only.split(","))
    found = {name: load(options.runs, name) for name in SLICES + FRICTION}
    images = os.path.join(ROOT, "docs", "img")
    lines = HEAD.splitlines() + slices_part(found, images) + friction_part(found, images)
    lines += remarks(os.path.join(ROOT, "validation", "mills-seen.md"))
    page = os.path.join(ROOT, "docs", "validation-mills.md")
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print(f"written: {page}")


main()
