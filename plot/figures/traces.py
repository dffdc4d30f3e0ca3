# SPDX-License-Identifier: Apache-2.0
"""Traced particles: their motion against time, and the forces of their contacts."""
import matplotlib.pyplot as plt
import numpy as np

from figures.style import BLACK, BLUE, LINES, MM, ORANGE, PAGE, RED

SHOWN = 6  # particles in one figure


def motion(run, gallery):
    """Height, velocity, speed and spin of the first few traced particles."""
    table = run.traces
    ids = np.unique(table["id"])[:SHOWN]
    speed = np.sqrt(sum(table[f"v{axis}_m_s"] ** 2 for axis in "xyz"))
    panels = (("height $y$ (mm)", table["y_m"] * MM), ("speed (m/s)", speed),
              ("$v_x$ (m/s)", table["vx_m_s"]), ("$v_y$ (m/s)", table["vy_m_s"]),
              ("spin $\\omega_z$ (rad/s)", table["wz_rad_s"]))
    figure, rows = plt.subplots(len(panels), 1, figsize=(0.72 * PAGE, 1.05 * PAGE), sharex=True,
                                constrained_layout=True)
    for axes, (label, values) in zip(rows, panels):
        for colour, one in zip(LINES, ids):
            mine = table["id"] == one
            axes.plot(table["time_s"][mine], values[mine], color=colour, lw=0.8,
                      label=f"particle {one:.0f}")
        axes.set_ylabel(label)
        axes.margins(y=0.08)
    if len(ids) > 1:
        rows[0].legend(loc="lower right", bbox_to_anchor=(1, 1.0), ncol=6, borderaxespad=0.2)
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


def contacts(run, gallery):
    """The parts of the force in the first contact of some length, and all contacts over time."""
    table = run.trace_contacts
    single = episodes(table)
    first = next((rows for rows in single if len(rows) >= 5), single[0])
    tangential = np.sqrt(sum(table[f"tangential_{axis}_n"] ** 2 for axis in "xyz"))
    figure = plt.figure(figsize=(PAGE, 0.72 * PAGE), constrained_layout=True)
    grid = figure.add_gridspec(2, 2, height_ratios=(1.25, 1))
    draw_parts(figure.add_subplot(grid[0, 0]), table, first)
    draw_loop(figure.add_subplot(grid[0, 1]), table, first)
    draw_all(figure.add_subplot(grid[1, :]), table, single, tangential)
    gallery.save(figure, "contact_forces")


def draw_parts(axes, table, rows):
    """Elastic and damping part of the normal force, their sum, and the friction, against time."""
    time = (table["time_s"][rows] - table["time_s"][rows[0]]) * 1e6
    tangential = np.sqrt(sum(table[f"tangential_{axis}_n"][rows] ** 2 for axis in "xyz"))
    mark = "." if len(rows) < 80 else ""
    for label, values, colour in (("elastic", table["elastic_n"][rows], BLUE),
                                  ("damping", table["damping_n"][rows], RED),
                                  ("normal force", table["normal_n"][rows], BLACK),
                                  ("tangential force", tangential, ORANGE)):
        axes.plot(time, values, color=colour, lw=0.9, marker=mark, ms=3, label=label)
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    axes.set_xlabel("time since first touch (µs)")
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


def draw_all(axes, table, single, tangential):
    """Normal force of every contact, and its friction, over the whole trace."""
    last = np.cumsum([len(rows) for rows in single])[:-1]  # where the line is interrupted
    rows = np.concatenate(single)
    time = np.insert(table["time_s"][rows], last, np.nan)
    for label, values, colour in (("normal force", table["normal_n"], BLACK),
                                  ("tangential force", tangential, ORANGE)):
        axes.plot(time, np.insert(values[rows], last, np.nan), color=colour, lw=0.7, label=label)
    axes.set_xlabel("time $t$ (s)")
    axes.set_ylabel("force (N)")
    axes.legend(ncol=2, loc="upper right")
    axes.set_title(f"{len(single)} contacts" if len(single) != 1 else "one contact", fontsize=7)
