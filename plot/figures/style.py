# SPDX-License-Identifier: Apache-2.0
"""How every figure looks, and how it is saved: sizes, colours, axes in millimetres.

Colours: Okabe & Ito's eight for lines, viridis and cividis for maps; both are told apart with any
kind of colour vision and in grey. Files carry no date, so the same data give the same bytes.
"""
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

COLUMN, PAGE = 3.35, 6.9  # inches   widths of a journal's column and page
MM = 1e3                  # mm per m
NARROW = 0.05             # 1   of their mean: values that differ by less have a scale without zero
ROUNDED = 1e-5            # 1   of their mean: differences of numbers in single precision

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, RED, PURPLE, GREY = "#F0E442", "#0072B2", "#D55E00", "#CC79A7", "#7F7F7F"
LINES = (BLUE, RED, GREEN, ORANGE, PURPLE, SKY, BLACK, GREY)

plt.rcParams.update({
    "font.size": 8, "axes.titlesize": 8, "axes.labelsize": 8, "legend.fontsize": 7,
    "xtick.labelsize": 7, "ytick.labelsize": 7, "mathtext.fontset": "dejavusans",
    "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
    "xtick.major.size": 2.5, "ytick.major.size": 2.5, "lines.linewidth": 1.0,
    "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
    "legend.frameon": False, "legend.handlelength": 1.6, "axes.axisbelow": True,
    "figure.dpi": 100, "image.cmap": "viridis", "svg.hashsalt": "quern", "path.simplify": True,
})

NO_DATE = {"png": {"Software": None}, "pdf": {"CreationDate": None}, "svg": {"Date": None}}


class Gallery:
    """Where figures go; it remembers the names of those written."""

    def __init__(self, folder, kind="png", dpi=300):
        os.makedirs(folder, exist_ok=True)
        self.folder, self.kind, self.dpi = folder, kind, dpi
        self.written = []

    def save(self, figure, name):
        path = os.path.join(self.folder, f"{name}.{self.kind}")
        figure.savefig(path, dpi=self.dpi, metadata=NO_DATE[self.kind], facecolor="white")
        plt.close(figure)
        self.written.append(path)


def mill_axes(axes, run):
    """Equal scales in millimetres, and as much room as the drum (or the particles) takes."""
    axes.set_aspect("equal")
    low, high = run.extent()
    axes.set_xlim(low[0] * MM, high[0] * MM)
    axes.set_ylim(low[1] * MM, high[1] * MM)
    axes.tick_params(top=False, right=False, direction="out")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.set_xlabel("$x$ (mm)", labelpad=2)
    axes.set_ylabel("$y$ (mm)", labelpad=1)


def clip_to_drum(picture, axes, run):
    if run.drum_radius:
        picture.set_clip_path(plt.Circle((0, 0), run.drum_radius * MM, transform=axes.transData))


class MillFigure:
    """Square panels in rows, with one colour bar at the right of all or one beside each; laid out
    in inches, so that every panel of every figure keeps its shape."""

    LEFT, BOTTOM, TOP, GAP, BAR, BAR_LABEL, BETWEEN = 0.52, 0.40, 0.36, 0.10, 0.11, 0.48, 0.14

    def __init__(self, width, rows=1, columns=1, bar_each=False):
        beside = self.GAP + self.BAR + self.BAR_LABEL + (self.BETWEEN if bar_each else 0)
        bars = columns if bar_each else 1
        side = (width - self.LEFT - bars * beside - (columns - 1) * self.BETWEEN) / columns
        step = side + self.BETWEEN + (beside if bar_each else 0)
        height = self.BOTTOM + rows * side + (rows - 1) * self.BETWEEN + self.TOP
        self.figure = plt.figure(figsize=(width, height))
        self.panels, self.bars = [], []
        for row in range(rows):
            bottom = self.BOTTOM + (rows - 1 - row) * (side + self.BETWEEN)
            for column in range(columns):
                x = self.LEFT + column * step
                self.panels.append(self._axes(x, bottom, side, side))
                if bar_each or column == columns - 1:
                    self.bars.append(self._axes(x + side + self.GAP, bottom + 0.04 * side,
                                                self.BAR, 0.92 * side))

    def _axes(self, x, y, width, height):
        full = self.figure.get_size_inches()
        return self.figure.add_axes((x / full[0], y / full[1], width / full[0], height / full[1]))

    def colour_bar(self, picture, label, index=0, **options):
        bar = self.figure.colorbar(picture, cax=self.bars[index], label=label, **options)
        bar.outline.set_linewidth(0.5)
        bar.ax.tick_params(direction="out", width=0.5, right=True)
        self._make_room(bar.ax)

    def _make_room(self, bar):
        """Widens the page for a bar at its right edge whose numbers are long."""
        wide, high = self.figure.get_size_inches()
        words = bar.yaxis.get_tightbbox(self.figure.canvas.get_renderer())
        more = words.x1 / self.figure.dpi + 0.03 - wide  # inches
        if more <= 0:
            return
        places = [(axes, axes.get_position(original=True).bounds) for axes in self.figure.axes]
        self.figure.set_size_inches(wide + more, high)
        for axes, (x, y, width, height) in places:
            axes.set_position((x * wide / (wide + more), y, width * wide / (wide + more), height))


def hide_inner_labels(panels, rows, columns):
    """Leaves axis labels to the first column and the last row."""
    for index, axes in enumerate(panels):
        if index % columns:
            axes.set_ylabel("")
            axes.tick_params(labelleft=False)
        if index // columns < rows - 1:
            axes.set_xlabel("")
            axes.tick_params(labelbottom=False)


def panel_letter(axes, index):
    axes.text(0.02, 0.99, f"({'abcdefgh'[index]})", transform=axes.transAxes, va="top", ha="left",
              fontsize=8, fontweight="bold")


def round_limit(values, share=99.5):
    """The next round number that holds `share` percent of the sizes of `values`."""
    values = np.abs(values[np.isfinite(values)])
    top = np.percentile(values, share) if values.size else 0.0
    if top <= 0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(top))
    return float(next(s for s in (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10) if s * power >= top) * power)


def colour_limits(values, share=99.5):
    """Ends of a scale for sizes: zero and a round number; or, where the values differ by little of
    their mean as in free fall, round numbers below and above them."""
    spread, mean = (np.ptp(values), np.mean(values)) if values.size else (0.0, 0.0)
    if not ROUNDED * mean < spread < NARROW * mean:
        return 0.0, round_limit(values, share)
    step = round_limit(np.array([spread])) / 5
    return float(np.floor(values.min() / step) * step), float(np.ceil(values.max() / step) * step)
