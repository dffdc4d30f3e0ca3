# SPDX-License-Identifier: Apache-2.0
"""Where the energy is and where it went, and what the balance leaves open."""
import matplotlib.pyplot as plt
import numpy as np

from figures.ledger import LOST, STORED, Ledger
from figures.style import BLACK, LINES, PAGE
from figures.table import NotRecorded


def energy(run, gallery):
    ledger = Ledger(run.series)
    stored, lost = moving(ledger.channels(STORED)), moving(ledger.channels(LOST))
    if len(ledger.time) < 2:
        raise NotRecorded("series.csv holds a single row")
    if not stored and not lost:
        raise NotRecorded("series.csv holds no energy that ever changes")
    figure, (top, middle, bottom) = plt.subplots(
        3, 1, figsize=(0.75 * PAGE, 0.95 * PAGE), sharex=True, constrained_layout=True,
        gridspec_kw={"height_ratios": (3, 3, 1.6)})
    draw_stored(top, ledger, stored)
    draw_lost(middle, ledger, lost)
    draw_residual(bottom, ledger)
    bottom.set_xlabel("time $t$ (s)")
    bottom.set_xlim(ledger.time[0], ledger.time[-1])
    for axes in (top, middle):
        if axes.get_legend_handles_labels()[0]:
            axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    figure.align_ylabels()
    gallery.save(figure, "energy")


def moving(channels):
    """Without those that stay what they are throughout."""
    return [channel for channel in channels if np.any(channel[2] != channel[2][0])]


def draw_stored(axes, ledger, channels):
    """Stored energies; gravity as its change, since its zero is a matter of choice."""
    shown = [(label, values) if name != "gravity" else ("gravity, change", values - values[0])
             for name, label, values in channels]
    factor, unit = unit_for(*(values for _, values in shown))
    for (label, values), colour in zip(shown, LINES):
        axes.plot(ledger.time, factor * values, color=colour, lw=0.8, label=label)
    axes.set_ylabel(f"stored ({unit})")


def draw_lost(axes, ledger, channels):
    work, losses = ledger.work(), ledger.losses()
    flows = [(label, values, line) for label, values, line in (
        ("brought in by feeds", ledger.brought(), (0, (1, 1))),
        ("taken out by outlets", ledger.taken(), (0, (5, 1, 1, 1))))
        if values is not None and np.any(values != values[0])]
    factor, unit = unit_for(work, losses, *(values for _, values, _ in flows))
    if work is not None:
        axes.plot(ledger.time, factor * work, color=BLACK, lw=1.2, label="work of the walls")
    if losses is not None:
        axes.plot(ledger.time, factor * losses, color=BLACK, lw=0.9, ls=(0, (4, 2)),
                  label="all losses")
    for label, values, line in flows:
        axes.plot(ledger.time, factor * values, color=BLACK, lw=0.9, ls=line, label=label)
    for (_, label, values), colour in zip(channels, LINES):
        axes.plot(ledger.time, factor * values, color=colour, lw=0.8, label=label)
    axes.set_ylabel(f"done and lost ({unit})")


def draw_residual(axes, ledger):
    residual = ledger.residual()
    if residual is None:
        axes.text(0.5, 0.5, "no residual_j in series.csv", ha="center", va="center",
                  transform=axes.transAxes)
        axes.set_yticks([])
        return
    axes.axhline(0, color="0.6", lw=0.5)
    factor, unit = unit_for(residual)
    axes.plot(ledger.time, factor * residual, color=LINES[0], lw=0.8)
    axes.set_ylabel(f"residual ({unit})")
    turnover = ledger.turnover()
    if turnover > 0:
        axes.set_title(f"residual at the end: {minus(residual[-1] / turnover)} of the turnover",
                       loc="right", fontsize=7, pad=2)


def minus(value):
    """Two digits of a number, with a sign that is not a hyphen."""
    return f"{value:.1e}".replace("-", "−")


def unit_for(*channels):
    """A factor and the unit it leads to from joules, for numbers a person can read on an axis."""
    largest = max((np.nanmax(np.abs(values)) for values in channels if values is not None),
                  default=0.0)
    for unit, size in (("kJ", 1e3), ("J", 1.0), ("mJ", 1e-3), ("µJ", 1e-6)):
        if largest >= size:
            return 1 / size, unit
    return 1e9, "nJ"
