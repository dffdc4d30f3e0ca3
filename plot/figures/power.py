# SPDX-License-Identifier: Apache-2.0
"""Power against time: what the drum puts in, and what contacts take out."""
import matplotlib.pyplot as plt
import numpy as np

from figures.ledger import Ledger
from figures.style import BLUE, COLUMN, GREY, RED
from figures.table import NotRecorded

SMOOTH_REVOLUTIONS = 0.1  # 1   width of the running mean


def interval_rate(time, total):
    """Mean rate of a running total over each interval between rows, and the intervals' middles."""
    step = np.diff(time)
    good = step > 0
    return ((time[1:] + time[:-1]) / 2)[good], np.diff(total)[good] / step[good]


def running_mean(time, total, width):
    """Rate of a running total over a window of `width` seconds about each row, exactly: its
    difference over the window. Rows nearer than half a window to an end are left out."""
    inside = (time >= time[0] + width / 2) & (time <= time[-1] - width / 2)
    middle = time[inside]
    if width <= 0 or not len(middle):
        return time[:0], time[:0]
    rise = np.interp(middle + width / 2, time, total) - np.interp(middle - width / 2, time, total)
    return middle, rise / width


def smoothing_width(run, time):
    speed = abs(run.number("speed_rad_s") or 0)
    span = time[-1] - time[0]
    width = SMOOTH_REVOLUTIONS * 2 * np.pi / speed if speed else span / 50
    return min(width, span / 5)


def measured_window(run):
    """First and last time (s) of the fields' averaging, or None."""
    try:
        grid = run.grids[0]
    except NotRecorded:
        return None
    limits = grid.first_time, grid.last_time
    return limits if np.all(np.isfinite(limits)) and limits[1] > limits[0] else None


def power(run, gallery):
    ledger = Ledger(run.series)
    time = ledger.time
    if run.number("speed_rad_s") is None and run.number("steps") is not None:
        raise NotRecorded("there is no drum")
    if len(time) < 3:
        raise NotRecorded("series.csv holds fewer than three rows")
    curves = [("torque × speed", ledger.work(), BLUE),
              ("dissipated", ledger.losses(), RED)]
    curves = [(label, total, colour) for label, total, colour in curves if total is not None]
    if not any(np.any(total != total[0]) for _, total, _ in curves):
        raise NotRecorded("series.csv holds neither work of a wall nor losses")
    figure, axes = plt.subplots(figsize=(1.6 * COLUMN, 0.8 * COLUMN), constrained_layout=True)
    width, highest = smoothing_width(run, time), []
    for (label, total, colour), line in zip(curves, (1.8, 0.9)):
        axes.plot(*interval_rate(time, total), color=colour, lw=0.4, alpha=0.3)
        middle, rate = running_mean(time, total, width)
        axes.plot(middle, rate, color=colour, lw=line, label=label, zorder=3)
        highest += [np.percentile(rate, 99.5)] if len(rate) else []
    told = [f"lines: running mean over {width:.2g} s", "pale: each row", *show_mean(axes, run)]
    if highest and max(highest) > 0:
        axes.set_ylim(min(0, axes.get_ylim()[0] * 0.2), 1.5 * max(highest))
    axes.set_xlim(time[0], time[-1])
    axes.set_xlabel("time $t$ (s)")
    axes.set_ylabel("power (W)")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1.01), ncol=2, borderaxespad=0, alignment="left",
                title=", ".join(told), title_fontsize=7)
    gallery.save(figure, "power")


def show_mean(axes, run):
    """The measuring window, shaded, and the mean over lifter passages with its standard error;
    returns what to say of the shading."""
    limits = measured_window(run)
    if not limits:
        return []
    axes.axvspan(*limits, color=GREY, alpha=0.12, lw=0, zorder=0)
    mean, error = run.number("power_torque_w"), run.number("power_stderr_w")
    if mean is None:
        return ["grey: window of the fields"]
    text = f"mean torque power {with_error(mean, error)} W"
    drift = run.number("power_drift_w")
    if run.summary.get("steady") is False:
        text += "\nnot steady"
        if drift is not None and mean:
            text += f": drift {100 * drift / mean:+.0f} %"
    axes.plot(limits, [mean, mean], color="black", lw=1.0, ls=(0, (5, 2)), label=text,
              zorder=4)
    return ["grey: window of the mean"]


def with_error(value, error):
    """A value rounded to the digit that its standard error (to one digit) reaches."""
    if not error or error <= 0:
        return f"{value:.4g}"
    digits = int(np.clip(-np.floor(np.log10(error)), 0, 12))
    return f"({value:.{digits}f} ± {error:.{digits}f})"
