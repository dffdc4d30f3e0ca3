# SPDX-License-Identifier: Apache-2.0
"""The particles that a cross-section cuts, at their true size, coloured by speed."""
from matplotlib.collections import EllipseCollection
import numpy as np

from figures.folder import NotRecorded
from figures.style import (COLUMN, MM, MillFigure, draw_outline, draw_rotation, mill_axes,
                           round_limit)


def cut_particles(position, radius, z):
    """Indices of the particles that the plane at `z` cuts, the furthest from the eye first."""
    cut = np.flatnonzero(np.abs(position[:, 2] - z) < radius)
    return cut[np.argsort(position[cut, 2], kind="stable")]


def cross_section(run, gallery):
    frame = run.frame
    speed = np.ravel(frame["speed"]) if "speed" in frame else \
        np.linalg.norm(frame["velocity"], axis=1)
    chosen = cut_particles(frame["position"], frame["radius"], run.section)
    if not len(chosen):
        raise NotRecorded("no particle crosses the middle of the drum in the last frame")
    top = round_limit(speed[chosen], 99.5)
    page = MillFigure(1.5 * COLUMN)
    axes = page.panels[0]
    diameter = 2 * frame["radius"][chosen] * MM
    picture = EllipseCollection(diameter, diameter, np.zeros(len(chosen)), units="xy",
                                offsets=frame["position"][chosen, :2] * MM,
                                offset_transform=axes.transData, cmap="viridis",
                                linewidths=0.15, edgecolors="0.15")
    picture.set_array(speed[chosen])
    picture.set_clim(0, top)
    axes.add_collection(picture)
    draw_outline(axes, run)
    draw_rotation(axes, run)
    mill_axes(axes, run)
    axes.set_title(f"particles cut by $z$ = {run.section * MM:.3g} mm, $t$ = {frame['time']:.3f} s",
                   fontsize=7)
    page.colour_bar(picture, "speed (m/s)", extend="max")
    gallery.save(page.figure, "particles")
