# SPDX-License-Identifier: Apache-2.0
"""Charge along the shell: solidity of the ring against angle, with shoulder and toe."""
import matplotlib.pyplot as plt
import numpy as np

from figures.maps import window
from figures.style import BLUE, COLUMN, GREEN, GREY, MM, RED


def ring(run, gallery):
    angle, solidity, inner = run.ring
    angle, solidity = from_minus_180(angle, solidity)
    figure, axes = plt.subplots(figsize=(1.3 * COLUMN, 0.8 * COLUMN), constrained_layout=True)
    axes.step(angle, solidity, where="mid", color=BLUE, lw=1.0)
    axes.fill_between(angle, solidity, step="mid", color=BLUE, alpha=0.15, lw=0)
    bulk = run.number("solidity_bulk")
    if bulk is not None:
        axes.axhline(bulk / 2, color=GREY, lw=0.7, ls=(0, (4, 2)))
        axes.text(-178, bulk / 2, "half the bulk solidity", fontsize=7, va="bottom",
                  color="0.35")
    height = 1.18 * max(np.nanmax(solidity), 1e-3)
    for name, colour in (("shoulder", RED), ("toe", GREEN)):
        at = run.number(f"{name}_deg")
        if at is None:
            continue
        at = (at + 180) % 360 - 180
        axes.axvline(at, color=colour, lw=0.9)
        text = f" {name} {at:.0f}° ".replace("-", "−")
        axes.text(at, height * 0.985, text, fontsize=7, color=colour, va="top",
                  ha="left" if at < 90 else "right")
    axes.set_xlim(-180, 180)
    axes.set_ylim(0, height)
    axes.set_xticks(np.arange(-180, 181, 45))
    axes.set_xlabel("angle from straight down, in the sense of rotation (°)")
    axes.set_ylabel("solidity in the ring (–)")
    depth = f", {(run.drum_radius - inner) * MM:.3g} mm deep" if run.drum_radius else ""
    axes.set_title(f"ring along the shell{depth}; mean of {window(run.grids[0])}", fontsize=7)
    gallery.save(figure, "ring")


def from_minus_180(angle, solidity):
    """Angles between -180 and 180 degrees, rising."""
    angle = (angle + 180) % 360 - 180
    order = np.argsort(angle, kind="stable")
    return angle[order], solidity[order]
