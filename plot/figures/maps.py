# SPDX-License-Identifier: Apache-2.0
"""Maps on the voxel grids: porosity at each resolution, and the components of the motion."""
import numpy as np

from figures.scenery import draw_rotation, draw_swept, shade_drum, tell_dashes
from figures.style import (COLUMN, MM, PAGE, MillFigure, clip_to_drum, hide_inner_labels, mill_axes,
                           panel_letter, round_limit)
from figures.table import NotRecorded


def draw_map(axes, run, grid, values, **options):
    """One map with the drum around it; returns what a colour bar needs."""
    x, y = grid.edges()
    shade_drum(axes, run)
    picture = axes.pcolormesh(x * MM, y * MM, np.ma.masked_invalid(values), rasterized=True,
                              linewidth=0, **options)
    clip_to_drum(picture, axes, run)
    draw_swept(axes, run)
    mill_axes(axes, run)
    return picture


def window(grid):
    """What a mean is taken over."""
    if not np.isfinite(grid.first_time) or not np.isfinite(grid.last_time):
        return f"{grid.samples} samples"
    return f"{grid.samples} samples, {grid.first_time:.2f} s to {grid.last_time:.2f} s"


def each_and_together(run, gallery, grids, draw, label, name, extend):
    """One figure for each grid, and all side by side; draw(axes, grid) gives the picture."""
    for grid in grids:
        one = MillFigure((1.3 + 0.5 * (grid is grids[0])) * COLUMN)
        one.colour_bar(draw(one.panels[0], grid), label, extend=extend)
        draw_rotation(one.panels[0], run)
        tell_dashes(one.panels[0], run)
        one.panels[0].set_title(f"{grid.title()}\nmean of {window(grid)}", fontsize=7)
        gallery.save(one.figure, f"{name}_{grid.file_name()}")
    if len(grids) < 2:
        return
    row = MillFigure(PAGE, columns=len(grids))
    for index, (axes, grid) in enumerate(zip(row.panels, reversed(grids))):
        picture = draw(axes, grid)
        axes.set_title(f"{grid.title()}\n{window(grid)}", fontsize=7)
        panel_letter(axes, index)
    hide_inner_labels(row.panels, 1, len(grids))
    row.colour_bar(picture, label, extend=extend)
    gallery.save(row.figure, name)


def porosity(run, gallery):
    """Porosity of the charge on each grid."""
    def draw(axes, grid):
        return draw_map(axes, run, grid, grid.porosity(), cmap="cividis", vmin=0.3, vmax=1.0)

    each_and_together(run, gallery, run.means, draw, "porosity (–)", "porosity", "min")


COMPONENTS = (("velocity_x", "$v_x$ (m/s)"), ("velocity_y", "$v_y$ (m/s)"),
              ("speed", "speed (m/s)"),
              ("granular_temperature", "granular temperature (m$^2$/s$^2$)"))


def components(run, gallery):
    """Mean velocity by component, speed and granular temperature on the second finest grid."""
    grid = run.means[min(1, len(run.means) - 1)]
    wanted = [pair for pair in COMPONENTS if grid.has(pair[0])]
    if not wanted:
        raise NotRecorded("fields.h5 holds no velocities")
    square = MillFigure(PAGE, rows=2, columns=2, bar_each=True)
    for index, (name, label) in enumerate(wanted):
        axes, values = square.panels[index], grid.motion(name)
        top = round_limit(values, 99)
        signed = name.startswith("velocity")
        picture = draw_map(axes, run, grid, values, cmap="PuOr_r" if signed else "viridis",
                           vmin=-top if signed else 0, vmax=top)
        square.colour_bar(picture, label, index, extend="both" if signed else "max")
        panel_letter(axes, index)
    hide_inner_labels(square.panels, 2, 2)
    for axes in square.panels[len(wanted):] + square.bars[len(wanted):]:
        axes.set_visible(False)
    square.figure.text(0.5, 0.985, f"{grid.title()}, mean of {window(grid)}", ha="center", va="top",
                       fontsize=7)
    gallery.save(square.figure, "velocity_components")
