# SPDX-License-Identifier: Apache-2.0
"""Paths of the traced particles across the axis, with what stands around them."""
import matplotlib.pyplot as plt
import numpy as np

from figures.scenery import draw_rotation, draw_scenery, draw_swept, standing, with_scenery
from figures.style import LINES, MM, PAGE
from figures.traces import traced

FLATTEST = 6  # 1   paths longer than this by their height are stretched


def window(run, x, y, z):
    """Lower and upper corner (m) of what is shown, seen along z with what is cut at `z`."""
    if run.drum_radius:
        return run.extent()
    low, high = np.array([x.min(), y.min()]), np.array([x.max(), y.max()])
    margin = 2 * run.scene.radius if run.scene.radius else 0.08 * max(high - low)
    low, high = with_scenery(standing(run.scene, None), low - margin, high + margin, z)
    spare = np.maximum(0, 0.5 * max(high - low) - (high - low))  # a straight fall is no wider
    spare[1] = 0
    return low - spare / 2, high + spare / 2


def paths(run, gallery):
    table, ids = traced(run)
    shown = np.isin(table["id"], ids)
    x, y, z = (table[f"{axis}_m"] for axis in "xyz")
    z = float(np.median(z[shown]))
    low, high = window(run, x[shown], y[shown], z)
    width, height = high - low
    even = width < FLATTEST * height
    shape = height / width if even else 1 / FLATTEST
    across = (0.6 if shape < 1 else 0.55 / shape) * PAGE  # inches of the panel
    legend = 0.15 * PAGE if len(ids) > 1 else 0
    figure, axes = plt.subplots(figsize=(0.7 + max(across, 0.25 * PAGE) + legend,
                                         0.8 + across * shape), constrained_layout=True)
    axes.set_xlim(low[0] * MM, high[0] * MM)
    axes.set_ylim(low[1] * MM, high[1] * MM)
    if even:
        axes.set_aspect("equal")
    for colour, one in zip(LINES, ids):
        rows = np.flatnonzero(table["id"] == one)
        axes.plot(x[rows] * MM, y[rows] * MM, color=colour, lw=0.8, label=f"particle {one:.0f}",
                  zorder=3)
        draw_ends(axes, run, x[rows] * MM, y[rows] * MM, colour, even)
    draw_scenery(axes, standing(run.scene, None), z)
    draw_swept(axes, run)
    draw_rotation(axes, run)
    axes.set_xlabel("$x$ (mm)")
    axes.set_ylabel("$y$ (mm)")
    title = (f"$t$ = {table['time_s'].min():.4g} s (filled) to {table['time_s'].max():.4g} s (open)")
    if not even:
        title += f", heights drawn {width / height / FLATTEST:.2g} times as large"
    if any(plane.motion for plane in run.scene.planes):
        title += "\nplanes that move are not drawn"
    axes.set_title(title, fontsize=7, pad=10 if run.drum_radius else 4)
    if len(ids) > 1:
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1))
    gallery.save(figure, "paths")


def draw_ends(axes, run, x, y, colour, even):
    """Filled where a path begins, open where it ends; at its true size where that is known."""
    for at, face in ((0, colour), (-1, "none")):
        if even and run.scene.radius:
            axes.add_patch(plt.Circle((x[at], y[at]), run.scene.radius * MM, fc=face, lw=0, alpha=0.4,
                                      zorder=2.5))
            axes.add_patch(plt.Circle((x[at], y[at]), run.scene.radius * MM, fill=False, ec=colour,
                                      lw=0.8, zorder=2.6))
        else:
            axes.plot(x[at], y[at], "o", ms=4, mec=colour, mfc=face, zorder=4)
