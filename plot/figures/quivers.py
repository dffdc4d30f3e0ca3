# SPDX-License-Identifier: Apache-2.0
"""Mean velocity as arrows coloured by speed, at each resolution.

A grid too fine for an arrow in every voxel shows the speed of every voxel as colour, and fewer arrows."""
from matplotlib.colors import ListedColormap
import numpy as np

from figures.maps import each_and_together
from figures.scenery import draw_swept, shade_drum
from figures.style import MM, clip_to_drum, mill_axes, round_limit
from figures.table import NotRecorded

LONGEST = 2.8  # 1       length of the arrow of the largest speed shown, in voxels
DENSEST = 14   # 1/inch  arrows that can be told apart


def draw_arrows(axes, run, grid, top):
    """Arrows whose length and colour follow the speed; `top` (m/s) is the end of the scale."""
    vx, vy = grid.motion("velocity_x"), grid.motion("velocity_y")
    speed = np.hypot(vx, vy)
    x, y = np.meshgrid(*grid.centres())
    seen = np.isfinite(speed)
    if run.drum_radius:
        seen &= np.hypot(x, y) < run.drum_radius
    shade_drum(axes, run)
    wide = axes.get_position().width * axes.figure.get_size_inches()[0]  # inches
    every = max(1, round(speed.shape[1] / (DENSEST * wide)))
    colours = {"cmap": "viridis", "clim": (0, top)}
    behind = {"cmap": "viridis", "vmin": 0, "vmax": top} if every > 1 else \
        {"cmap": ListedColormap(["white"])}
    picture = axes.pcolormesh(x * MM, y * MM, np.where(seen, speed, np.nan), shading="nearest",
                              rasterized=True, **behind)
    clip_to_drum(picture, axes, run)
    if every > 1:
        thin = np.zeros_like(seen)
        thin[every // 2::every, every // 2::every] = True
        seen &= thin
        colours = {"color": "white"}
    shown = np.minimum(1, top / np.maximum(speed[seen], 1e-30))  # arrows off the scale end at it
    values = [] if every > 1 else [speed[seen]]
    side = every * grid.cell * MM
    arrows = axes.quiver(x[seen] * MM, y[seen] * MM, vx[seen] * shown, vy[seen] * shown, *values,
                         angles="xy", scale_units="xy", pivot="mid",
                         scale=top / (LONGEST * side), units="xy",
                         width=(0.18 if every > 1 else 0.28) * side, headwidth=2.6, headlength=3.4,
                         headaxislength=3, minlength=0.5, **colours)
    clip_to_drum(arrows, axes, run)
    draw_swept(axes, run)
    mill_axes(axes, run)
    return picture if every > 1 else arrows


def velocity(run, gallery):
    """Arrows on each grid, all with one scale."""
    grids = [grid for grid in run.means if grid.has("velocity_x") and grid.has("velocity_y")]
    if not grids:
        raise NotRecorded("fields.h5 holds no velocities")
    coarse = grids[-1]
    top = round_limit(np.hypot(coarse.motion("velocity_x"), coarse.motion("velocity_y")), 99)

    def draw(axes, grid):
        return draw_arrows(axes, run, grid, top)

    each_and_together(run, gallery, grids, draw, "speed of the mean flow (m/s)", "velocity", "max")
