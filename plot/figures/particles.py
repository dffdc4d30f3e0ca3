# SPDX-License-Identifier: Apache-2.0
"""The circles in which a cross-section cuts the particles, coloured by speed."""
from matplotlib.collections import EllipseCollection
import numpy as np

from figures.scenery import draw_liner, draw_rotation, draw_scenery, standing
from figures.style import COLUMN, MM, MillFigure, colour_limits, mill_axes
from figures.table import NotRecorded


def cut_circles(position, radius, z):
    """Indices of the particles that the plane at `z` cuts, and the radii (m) of the circles."""
    square = radius ** 2 - (position[:, 2] - z) ** 2
    cut = np.flatnonzero(square > 0)
    return cut, np.sqrt(square[cut])


def cross_section(run, gallery):
    frame = run.frame
    speed = np.ravel(frame["speed"]) if "speed" in frame else \
        np.linalg.norm(frame["velocity"], axis=1)
    chosen, cut_radius = cut_circles(frame["position"], frame["radius"], run.section)
    if not len(chosen):
        raise NotRecorded("the section cuts no particle of the last frame")
    limits = colour_limits(speed[chosen].astype(float))
    page = MillFigure(1.5 * COLUMN)
    axes = page.panels[0]
    diameter = 2 * cut_radius * MM
    picture = EllipseCollection(diameter, diameter, np.zeros(len(chosen)), units="xy",
                                offsets=frame["position"][chosen, :2] * MM,
                                offset_transform=axes.transData, cmap="viridis",
                                linewidths=0.15, edgecolors="0.15")
    picture.set_array(speed[chosen])
    picture.set_clim(*limits)
    axes.add_collection(picture)
    mill_axes(axes, run)
    draw_scenery(axes, standing(run.scene, frame["time"]), run.section)
    draw_liner(axes, run)
    draw_rotation(axes, run)
    axes.set_title(f"balls as the plane $z$ = {run.section * MM:.3g} mm cuts them, "
                   f"$t$ = {frame['time']:.3f} s", fontsize=7)
    page.colour_bar(picture, "speed (m/s)",
                    extend="max" if speed[chosen].max() > limits[1] else "neither")
    gallery.save(page.figure, "particles")
