# SPDX-License-Identifier: Apache-2.0
"""The figures of docs/validation.md: one function each, drawn from the CSV files of its case.

A function gets `curve`, which gives the columns of a named curve, and the name of the picture. It may
draw a formula beside the points, but no measured number that its case has not written.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "plot"))

import numpy as np  # noqa: E402

from figures.style import (BLACK, BLUE, GREEN, GREY, LINES, NO_DATE, PAGE,  # noqa: E402
                           RED, plt)

DPI = 130
HEIGHT = 2.2  # inches   of a row of panels
POINTS = {"linestyle": "none", "marker": "o", "markersize": 3}


def panels(columns, rows=1):
    """A figure as wide as a page, or two thirds of it for a single panel; and its panels in a list."""
    width = PAGE if columns > 1 else 0.65 * PAGE
    figure, axes = plt.subplots(rows, columns, figsize=(width, HEIGHT * rows), squeeze=False,
                                layout="constrained")
    return figure, list(axes.flat)


def save(figure, path):
    figure.savefig(path, dpi=DPI, metadata=NO_DATE["png"], facecolor="white")
    plt.close(figure)


def label(axes, x, y, legend=True):
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    if legend:
        axes.legend()


def head_on(curve, path):
    figure, axes = panels(2)
    for name, e_star, colour in (("glass", 48e9 / (2 * (1 - 0.2**2)), BLUE),
                                 ("limestone", 20e9 / (2 * (1 - 0.25**2)), RED)):
        overlap, force, time = curve(name)
        depth = np.linspace(0, overlap.max(), 200)
        axes[0].plot(depth, 4 / 3 * e_star * 0.005**0.5 * (depth * 1e-6)**1.5 / 1e3, color=colour)
        axes[0].plot(overlap[::4], force[::4], color=colour, label=name, **POINTS)
        axes[1].plot(time, force, color=colour, label=name)
    label(axes[0], "overlap (µm)", "force (kN)")
    label(axes[1], "time (µs)", "force (kN)")
    save(figure, path)


def oblique(curve, path):
    figure, axes = panels(3)
    angle, *values = curve("run")
    measured = curve("measured")
    slope = np.tan(np.radians(np.linspace(33, 85, 100)))
    theory = (1 - 0.092 * 1.98 / slope,
              -2.5 * 0.092 * 1.98 * 3.9 * np.cos(np.arctan(slope)) / 0.0025,
              np.degrees(np.arctan((slope - 3.5 * 0.092 * 1.98) / 0.98)))
    for k, name in enumerate(("tangential restitution (1)", "spin (rad/s)", "angle of rebound (deg)")):
        axes[k].plot(angle, values[k], color=BLUE, label="run")
        axes[k].plot(np.degrees(np.arctan(slope)), theory[k], color=BLACK, linestyle=":",
                     label="sliding, rigid")
        axes[k].plot(measured[0], measured[k + 1], color=RED, label="published, sticking", **POINTS)
        label(axes[k], "angle of impact (deg)", name, legend=k == 2)
    save(figure, path)


def slip_to_roll(curve, path):
    figure, axes = panels(1)
    for k, mu in enumerate((0.2, 0.5, 1)):
        time, speed, rim = curve(f"slip{k}")
        axes[0].plot(time, speed, color=LINES[k], label=f"µ = {mu:g}")
        axes[0].plot(time, rim, color=LINES[k], linestyle="--")
    axes[0].axhline(5 / 7 * 0.1, color=GREY, linestyle=":")
    axes[0].set_xlim(0, 18)
    label(axes[0], "time (ms)", "speed (m/s)")
    save(figure, path)


def haff(curve, path):
    figure, axes = panels(1)
    time, temperature = curve("temperature")
    line = np.linspace(0, time.max(), 200)
    axes[0].semilogy(line, (1 + line)**-2, color=BLACK, label="$(1 + t/\\tau)^{-2}$")
    axes[0].semilogy(time, temperature, color=BLUE, label="run", **POINTS)
    label(axes[0], "time / $\\tau$", "temperature / its first")
    save(figure, path)


def thesis(curve, path):
    figure, axes = panels(2, 2)
    step, spring, dashpot, force = curve("contact")
    for values, name, colour in ((spring, "spring", GREEN), (dashpot, "dashpot", RED),
                                 (force, "force", BLACK)):
        axes[0].plot(step, values, marker=".", markersize=3, color=colour, label=name)
    axes[0].axhline(0, color=GREY, linewidth=0.5)
    label(axes[0], "step of 1 µs", "force (N)")
    speed, overlap = curve("overlap")
    line = np.linspace(0, 2.2, 100)
    axes[1].plot(line, overlap[1] * line**0.8, color=BLACK, label="speed$^{4/5}$")
    axes[1].plot(speed, overlap, color=BLUE, label="run", **POINTS)
    label(axes[1], "speed of impact (m/s)", "overlap (% of $R$)")
    time, height, _ = curve("drop")
    axes[2].plot(1e3 * time, height, color=BLUE)
    label(axes[2], "time (ms)", "height of the centre (mm)", legend=False)
    time, _, speed, rim = curve("launch")
    axes[3].plot(1e3 * time, speed, color=BLUE, label="speed")
    axes[3].plot(1e3 * time, rim, color=RED, label="rim")
    axes[3].axhline(5 / 7, color=GREY, linestyle=":")
    label(axes[3], "time (ms)", "speed (m/s)")
    for k, panel in enumerate(axes):
        panel.set_title(f"({'abcd'[k]})", loc="left")
    save(figure, path)


def restitution(curve, path):
    figure, axes = panels(1)
    axes[0].plot([0, 1], [0, 1], color=GREY, linewidth=0.6, label="asked for")
    for name, colour in (("oxide", BLUE), ("iron", RED)):
        axes[0].plot(*curve(name), color=colour, label=name, **POINTS)
    label(axes[0], "restitution asked for", "ratio of speeds")
    save(figure, path)


def gripping(curve, path):
    figure, axes = panels(3)
    for name, colour in (("steel", BLUE), ("polyethylene", GREEN)):
        x, surface, spin = curve(name)
        axes[0].plot(x, surface, color=colour, label=name)
        axes[1].plot(x, spin, color=colour, label=name)
    axes[0].plot([7, 12], [0, 5], color=BLACK, linestyle=":", label="sliding, rigid")
    axes[1].plot([7, 12], [-5, -5], color=BLACK, linestyle=":", label="sliding, rigid")
    axes[0].plot(*curve("published5"), color=RED, label="other codes", **POINTS)
    label(axes[0], "$V_t / \\mu V_n$", "surface speed / $\\mu V_n$")
    label(axes[1], "$V_t / \\mu V_n$", "$r\\omega / \\mu V_n$")
    for name, colour in (("aluminium", BLUE), ("nylon", GREEN)):
        axes[2].semilogx(*curve(name), color=colour, label=name)
    axes[2].semilogx(*curve("large"), color=BLACK, marker="+", linestyle="none", markersize=4,
                     label="on a large one")
    axes[2].semilogx(*curve("published6"), color=RED, label="other codes", **POINTS)
    label(axes[2], "$3.5\\,\\mu(1+e)V_n / r\\omega$", "reversal of the surface speed")
    save(figure, path)


def mfix(curve, path):
    figure, axes = panels(2)
    for name, e, colour in (("soft10", 1.0, BLUE), ("soft06", 0.6, RED)):
        time, height, theory = curve(name)
        axes[0].plot(time, theory, color=BLACK, linewidth=0.6)
        axes[0].plot(time[::24], height[::24], color=colour, label=f"e = {e:g}", **POINTS)
    label(axes[0], "time (s)", "height of the centre (m)")
    bounce = np.arange(1, 6)
    axes[1].semilogy(bounce, 0.4 * 0.8 ** (2 * bounce), color=BLACK, linewidth=0.6, label="hard ball")
    for name, k, colour in (("soft", "5·10$^5$", RED), ("medium", "5·10$^6$", GREEN), ("stiff", "5·10$^7$", BLUE)):
        axes[1].semilogy(*curve(name), color=colour, label=f"$k$ = {k} N/m", **POINTS)
    axes[1].set_xticks(bounce)
    label(axes[1], "bounce", "height above the plane (m)")
    save(figure, path)


def restitution_of_laws(curve, path):
    figure, axes = panels(2)
    for name, mark in (("viscous", "o"), ("tsuji", "s")):
        for clip, face in ((0, "none"), (1, None)):
            rows = curve(name)
            _, _, speed, ratio = rows[:, rows[0] == clip]
            axes[0].semilogx(speed, ratio, linestyle="none", marker=mark, color=BLUE if mark == "o" else RED,
                             markersize=3 + 3 * (1 - clip), markerfacecolor=face,
                             label=f"{name}, {'clipped' if clip else 'not clipped'}")
    for e in (0.3, 0.6, 0.9):
        axes[0].axhline(e, color=GREY, linewidth=0.5)
    for k, e in enumerate((0.3, 0.6, 0.9)):
        for name, style in (("linear_hunt", {"linestyle": "-"}), ("hertz_hunt", POINTS)):
            asked, speed, ratio = curve(name)
            chosen = np.isclose(asked, e)
            axes[1].semilogx(speed[chosen], ratio[chosen], color=LINES[k], **style,
                             label=f"e = {e:g}" if name == "linear_hunt" else None)
    axes[1].axvline(0.3, color=GREY, linewidth=0.5)
    for panel in axes:
        panel.set_ylim(-0.35 if panel is axes[0] else 0, 1.02)
    for panel in axes:
        label(panel, "speed of impact (m/s)", "ratio of speeds")
    save(figure, path)


def cycle(curve, path):
    figure, axes = panels(2)
    for k, what in enumerate(("slide", "load")):
        for name, style in (("mindlin", {"color": RED}), ("thornton", {"color": BLUE, "linestyle": "--"})):
            axes[k].plot(*curve(f"{name}_{what}"), label={"mindlin": "mindlin", "thornton": "mindlin-thornton"}[name],
                         **style)
        axes[k].set_title(f"({'ab'[k]})", loc="left")
        label(axes[k], "displacement (µm)", "tangential force (mN)")
    save(figure, path)


def stack(curve, path):
    figure, axes = panels(1)
    above, overlap, theory = curve("depth")
    axes[0].plot(above, theory, color=BLACK, marker="_", linestyle="none", markersize=9, label="Hertz")
    axes[0].plot(above, overlap, color=BLUE, label="run", **POINTS)
    label(axes[0], "balls borne by the contact (10: on the floor)", "overlap (µm)")
    save(figure, path)


def silo(curve, path):
    figure, axes = panels(1)
    weight, floor, limit = curve("floor")
    line = np.linspace(0, 1.05 * weight.max(), 200)
    axes[0].plot(line, limit[0] * (1 - np.exp(-line / limit[0])), color=BLACK, label="Janssen")
    axes[0].plot(line, line, color=GREY, linestyle=":", label="all of it")
    axes[0].plot(weight, floor, color=BLUE, label="run", **POINTS)
    axes[0].set_ylim(0, 2 * limit[0])
    label(axes[0], "weight of the balls (N)", "force on the floor (N)")
    save(figure, path)


def heap(curve, path):
    figure, axes = panels(2)
    for k, name in enumerate(("r000", "r010", "r040")):
        x, height = curve(name)
        axes[0].plot(x, height, color=LINES[k], marker="o", markersize=3,
                     label=f"$\\mu_r$ = {int(name[1:]) / 100:g}")
    axes[0].set_aspect("equal")
    axes[1].plot(*curve("slopes"), color=BLUE, marker="o", markersize=3)
    label(axes[0], "distance from the wall (mm)", "height (mm)")
    label(axes[1], "rolling friction $\\mu_r$", "slope of the heap (deg)", legend=False)
    save(figure, path)
