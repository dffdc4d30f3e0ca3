# SPDX-License-Identifier: Apache-2.0
"""Mean velocity as arrows coloured by speed, at each resolution."""
import numpy as np

from figures.folder import NotRecorded
from figures.maps import each_and_together
from figures.style import MM, clip_to_drum, draw_outline, mill_axes, round_limit

LONGEST = 2.8  # 1   length of the arrow of the largest speed shown, in voxels


def draw_arrows(axes, run, grid, top):
    """Arrows whose length and colour follow the speed; `top` (m/s) is the end of the scale."""
    vx, vy = grid.motion("velocity_x"), grid.motion("velocity_y")
    speed = np.hypot(vx, vy)
    x, y = np.meshgrid(*grid.centres())
    seen = np.isfinite(speed)
    if run.drum_radius:
        seen &= np.hypot(x, y) < run.drum_radius
    shown = np.minimum(1, top / np.maximum(speed[seen], 1e-30))  # arrows off the scale end at it
    picture = axes.quiver(x[seen] * MM, y[seen] * MM, vx[seen] * shown, vy[seen] * shown,
                          speed[seen], angles="xy", scale_units="xy", pivot="mid",
                          scale=top / (LONGEST * grid.cell * MM), units="xy",
                          width=0.28 * grid.cell * MM, headwidth=2.6, headlength=3.4,
                          headaxislength=3, minlength=0.5, cmap="viridis", clim=(0, top),
                          rasterized=speed.size > 2e4)
    clip_to_drum(picture, axes, run)
    draw_outline(axes, run)
    mill_axes(axes, run)
    return picture


def velocity(run, gallery):
    """Arrows on each grid, all with one scale."""
    grids = [grid for grid in run.grids if grid.has("velocity_x") and grid.has("velocity_y")]
    if not grids:
        raise NotRecorded("fields.h5 holds no velocities")
    coarse = grids[-1]
    top = round_limit(np.hypot(coarse.motion("velocity_x"), coarse.motion("velocity_y")), 99)

    def draw(axes, grid):
        return draw_arrows(axes, run, grid, top)

    each_and_together(run, gallery, grids, draw, "speed of the mean flow (m/s)", "velocity", "max")
