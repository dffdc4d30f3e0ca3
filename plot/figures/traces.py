# SPDX-License-Identifier: Apache-2.0
"""Traced particles: their motion against time, and the forces of their contacts."""
import matplotlib.pyplot as plt
import numpy as np

from figures.style import BLACK, BLUE, LINES, MM, ORANGE, PAGE, RED
from figures.table import NotRecorded

SHOWN = 6        # 1   particles in one figure
ROUNDING = 1e-9  # 1   velocities (m/s) and spins (rad/s) below this, by the largest speed, are zero
RESOLVED = 10    # 1   rows of a contact from which its course can be told,
TURN = 5         # 1   and rows for each turn of its overlap
LABELLED = 0.1   # 1   of the largest force: contacts whose ratio of speeds is written beside them


def traced(run):
    """The table of the traces, and the particles of it that are shown."""
    table = run.traces
    if len(np.unique(table["time_s"])) < 2:
        raise NotRecorded("traces.csv holds a single moment")
    return table, np.unique(table["id"])[:SHOWN]


def panels_of(table):
    """Label and values of height, speed, and the components of velocity and spin that are not zero
    throughout; and the names of those that are."""
    speed = np.sqrt(sum(table[f"v{axis}_m_s"] ** 2 for axis in "xyz"))
    parts = [(f"$v_{axis}$", "m/s", table[f"v{axis}_m_s"]) for axis in "xyz"]
    parts += [(f"$\\omega_{axis}$", "rad/s", table[f"w{axis}_rad_s"]) for axis in "xyz"]
    moves = [np.max(np.abs(values)) > ROUNDING * np.max(speed) for _, _, values in parts]
    panels = [("height $y$ (mm)", table["y_m"] * MM), ("speed (m/s)", speed)]
    panels += [(f"{name} ({unit})", values) for (name, unit, values), yes in zip(parts, moves) if yes]
    return panels, [name for (name, _, _), yes in zip(parts, moves) if not yes]


def motion(run, gallery):
    """The motion of the first few traced particles."""
    table, ids = traced(run)
    panels, zero = panels_of(table)
    figure, rows = plt.subplots(len(panels), 1, sharex=True, constrained_layout=True,
                                figsize=(0.72 * PAGE, min(1.25, 0.08 + 0.195 * len(panels)) * PAGE))
    for axes, (label, values) in zip(rows, panels):
        for colour, one in zip(LINES, ids):
            mine = table["id"] == one
            axes.plot(table["time_s"][mine], values[mine], color=colour, lw=0.8,
                      label=f"particle {one:.0f}")
        axes.set_ylabel(label)
        axes.margins(y=0.08)
    if len(ids) > 1:
        rows[0].legend(loc="lower right", bbox_to_anchor=(1, 1.0), ncol=6, borderaxespad=0.2)
    else:
        rows[0].set_title(f"particle {ids[0]:.0f}", fontsize=7, loc="right", pad=3)
    if zero:
        rows[0].set_title(f"zero throughout: {', '.join(zero)}", fontsize=7, loc="left",
                          pad=3 if len(ids) == 1 else 18)
    rows[-1].set_xlabel("time $t$ (s)")
    rows[-1].margins(x=0)
    figure.align_ylabels()
    gallery.save(figure, "traces")


def episodes(table):
    """Index arrays of the single contacts, first to last: rows of one particle and one partner
    without a gap."""
    step, partner = table["step"], np.unique(table["partner"], return_inverse=True)[1]
    steps = np.unique(step)
    stride = np.diff(steps).min() if len(steps) > 1 else 1
    order = np.lexsort((step, partner, table["id"]))
    apart = np.diff(table["id"][order]) != 0
    apart |= np.diff(partner[order]) != 0
    apart |= np.diff(step[order]) > 1.5 * stride
    found = np.split(order, np.flatnonzero(apart) + 1)
    return sorted(found, key=lambda rows: (step[rows[0]], rows[0]))


def resolved(depth):
    """True where the rows of a contact are dense enough to tell its course from its overlap."""
    way = np.sign(np.diff(depth))
    turns = np.count_nonzero(way[1:] != way[:-1])
    return len(depth) >= max(RESOLVED, TURN * turns)


def contacts(run, gallery):
    """The parts of the force in the first contact that was traced densely enough, with its loop; or
    in the longest, without it; and all contacts over time."""
    table = run.trace_contacts
    single = episodes(table)
    first = next((rows for rows in single if resolved(table["depth_m"][rows])), None)
    figure = plt.figure(figsize=(PAGE, 0.72 * PAGE), constrained_layout=True)
    grid = figure.add_gridspec(2, 2, height_ratios=(1.25, 1))
    if first is not None:
        draw_parts(figure.add_subplot(grid[0, 0]), table, first)
        draw_loop(figure.add_subplot(grid[0, 1]), table, first)
    else:
        top = figure.add_subplot(grid[0, :])
        draw_parts(top, table, max(single, key=len))
        top.set_xlabel(top.get_xlabel().replace("first touch", "its first row"))
        top.set_title(f"{top.get_title()}\ntraced too rarely to show the course of a contact, or its "
                      "loop (measure: traces: every)", fontsize=7)
    bottom = figure.add_subplot(grid[1, :])
    draw_all(bottom, table, single)
    if not run.drum_radius:
        label_rebounds(bottom, run, single)
    gallery.save(figure, "contact_forces")


def forces(table):
    """Label, values (N) and colour of the normal force and, where there is any, the friction."""
    friction = np.sqrt(sum(table[f"tangential_{axis}_n"] ** 2 for axis in "xyz"))
    found = [("normal force", table["normal_n"], BLACK)]
    if np.max(friction) > ROUNDING * np.max(np.abs(table["normal_n"])):
        found.append(("tangential force", friction, ORANGE))
    return found


def draw_parts(axes, table, rows):
    """Elastic and damping part of the normal force, their sum, and the friction, against time."""
    time = table["time_s"][rows] - table["time_s"][rows[0]]  # s
    factor, unit = (1e3, "ms") if time[-1] > 2e-3 else (1e6, "µs")
    mark = "." if len(rows) < 80 else ""
    for label, values, colour in (("elastic", table["elastic_n"], BLUE),
                                  ("damping", table["damping_n"], RED), *forces(table)):
        axes.plot(factor * time, values[rows], color=colour, lw=0.9, marker=mark, ms=3, label=label)
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    axes.set_xlabel(f"time since first touch ({unit})")
    axes.set_ylabel("force (N)")
    axes.set_ylim(top=1.3 * max(axes.get_ylim()[1], 1e-30))
    axes.legend(ncol=2, loc="upper right")
    axes.set_title(f"particle {table['id'][rows[0]]:.0f} against {partner_name(table, rows[0])}, "
                   f"$t$ = {table['time_s'][rows[0]]:.4g} s", fontsize=7)


def partner_name(table, row):
    """A wall part by its name, a particle by its id."""
    partner = table["partner"][row]
    if table["partner"].dtype.kind != "f" and not partner.isdigit():
        return str(partner)
    return f"particle {int(partner)}"


def draw_loop(axes, table, rows):
    depth = table["depth_m"][rows] * 1e6
    axes.plot(depth, table["elastic_n"][rows], color=BLUE, lw=0.9, label="elastic")
    axes.plot(depth, table["normal_n"][rows], color=BLACK, lw=0.9, label="normal force")
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    axes.set_xlabel("overlap (µm)")
    axes.set_ylabel("force (N)")
    axes.legend()
    axes.set_title("area within the loop: energy lost", fontsize=7)


def draw_all(axes, table, single):
    """Normal force of every contact, and its friction, over the whole trace."""
    last = np.cumsum([len(rows) for rows in single])[:-1]  # where the line is interrupted
    rows = np.concatenate(single)
    time = np.insert(table["time_s"][rows], last, np.nan)
    for label, values, colour in forces(table):
        axes.plot(time, np.insert(values[rows], last, np.nan), color=colour, lw=0.7, label=label)
    axes.set_xlabel("time $t$ (s)")
    axes.set_ylabel("force (N)")
    axes.legend(ncol=2, loc="upper right")
    axes.set_title(f"{len(single)} contacts" if len(single) != 1 else "one contact", fontsize=7)


def rebound(motion_table, contact_table, rows):
    """Ratio of the speeds along the normal after and before a contact with a wall at rest, or None
    where the trace does not reach beyond it or the partner is a particle."""
    partner = str(contact_table["partner"][rows[0]])
    if contact_table["partner"].dtype.kind == "f" or partner.isdigit():
        return None
    mine = np.flatnonzero(motion_table["id"] == contact_table["id"][rows[0]])
    time = motion_table["time_s"][mine]
    before = np.flatnonzero(time < contact_table["time_s"][rows[0]])
    after = np.flatnonzero(time > contact_table["time_s"][rows[-1]])
    if not len(before) or not len(after):
        return None
    speeds = [sum(motion_table[f"v{axis}_m_s"][mine[at]] * contact_table[f"normal_{axis}"][row]
                  for axis in "xyz") for at, row in ((before[-1], rows[0]), (after[0], rows[-1]))]
    return -speeds[1] / speeds[0] if speeds[0] < 0 else None


def label_rebounds(axes, run, single):
    """The ratio of speeds beside the largest contacts."""
    table = run.trace_contacts
    peaks = [(table["normal_n"][rows].max(), rows) for rows in single]
    least = LABELLED * max(peak for peak, _ in peaks)
    try:
        found = [(rebound(run.traces, table, rows), peak, rows) for peak, rows in peaks
                 if peak > least]
    except (NotRecorded, KeyError):
        return  # the motion was not recorded
    found = [label for label in found if label[0] is not None]
    late = 0.9 * table["time_s"].max() + 0.1 * table["time_s"].min()
    for ratio, peak, rows in found:
        time = table["time_s"][rows[0]]
        axes.text(time, peak, f" {ratio:.3f} ", fontsize=7, va="bottom",
                  ha="right" if time > late else "left")
    if found:
        axes.set_ylim(top=axes.get_ylim()[1] * 1.12)
        axes.set_title(axes.get_title() + "; numbers: speed along the normal after a bounce by "
                       "that before", fontsize=7)
