# SPDX-License-Identifier: Apache-2.0
"""What stands around the particles, and how it is drawn: planes and boxes, fixed balls, the liner.

Planes (a box is six of them) and fixed balls are read from resolved.yaml, which the program writes
with one key of a plane or a group of particles per line; earlier versions wrote a plane in one line.
Planes that move are drawn where they stand at the moment of a picture; a picture of a span of time
leaves them out.
"""
import re
from collections import namedtuple

import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection
import numpy as np

from figures.motion import moved, read_motion
from figures.style import BLACK, MM

WALL = "0.88"  # grey of what is solid, or where no particle's centre was seen

# m, unit normal towards the particles, keys of the motion (none: at rest)
Plane = namedtuple("Plane", "name point normal motion", defaults=(None,))
Ball = namedtuple("Ball", "centre radius")        # m
Scene = namedtuple("Scene", "planes fixed radius")  # radius: of all balls (m), None if they differ

PLANE = re.compile(r"  (.+?): \{shape: plane,.* point: (\S+) (\S+) (\S+) m, "
                   r"normal: (\S+) (\S+) (\S+)\}")
WALL_KEY = re.compile(r"    (shape|point|normal): *(.*)")
AT, DIAMETER = re.compile(r" +at: (\S+) (\S+) (\S+) m"), re.compile(r" .*diameter: (\S+) m")


def read_scene(path):
    """The Scene of a resolved.yaml; an empty one where there is none."""
    planes, fixed, diameters, block, group, wall = [], [], set(), "", {}, {}
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError:
        lines = []
    for line in lines:
        if not line.startswith(" "):
            block = line.split(":")[0]
        elif block == "walls" and (found := PLANE.match(line)):
            numbers = np.array(found.groups()[1:], float)
            planes.append(Plane(found[1], numbers[:3], numbers[3:] / np.linalg.norm(numbers[3:])))
        elif block == "walls" and not line.startswith("   "):
            wall = {"name": line.strip().removesuffix(":"), "motion": {}}
        elif block == "walls" and (found := WALL_KEY.match(line)):
            wall[found[1]] = found[2]
            if found[1] == "normal" and wall.get("shape") == "plane":
                point, normal = (np.array(wall[key].split()[:3], float) for key in ("point", "normal"))
                planes.append(Plane(wall["name"], point, normal / np.linalg.norm(normal),
                                    wall["motion"]))
        elif block == "walls" and line.startswith("      "):
            read_motion(line, wall["motion"])
        elif block == "particles":
            if not line.startswith("   "):
                group = {}
            elif found := AT.match(line):
                group["at"] = np.array(found.groups(), float)
            elif found := DIAMETER.match(line):
                group["radius"] = float(found[1]) / 2
                diameters.add(group["radius"])
            elif line.strip() == "fixed: yes":
                group["fixed"] = True
            if len(group) == 3:
                fixed.append(Ball(group["at"], group["radius"]))
                group = {}
    return Scene(planes, fixed, diameters.pop() if len(diameters) == 1 else None)


def standing(scene, time):
    """The scene as it stands at `time` (s); where that is None, without the planes that move."""
    planes = [plane if not plane.motion else
              Plane(plane.name, *moved(plane.point, plane.normal, plane.motion, time))
              for plane in scene.planes if time is not None or not plane.motion]
    return scene._replace(planes=planes)


def traces_of(scene, z, centre):
    """For each plane that the plane at `z` cuts: the point (m) of the line nearest to `centre`, and
    the unit normal within the section."""
    found = []
    for plane in scene.planes:
        size = np.hypot(*plane.normal[:2])
        if size < 1e-6:
            continue  # it lies along the section
        n = plane.normal[:2] / size
        off = (plane.point @ plane.normal - plane.normal[2] * z) / size - centre @ n
        found.append((centre + off * n, n))
    return found


def with_scenery(scene, low, high, z):
    """Corners (m) of a window, widened to fixed balls, and to planes that are no further away from
    its middle than its longer side."""
    middle, size = (low + high) / 2, max(high - low)
    points = [at - 0.04 * size * n for at, n in traces_of(scene, z, middle)
              if np.hypot(*(at - middle)) < size]
    points += [ball.centre[:2] + way * 1.2 * ball.radius for ball in scene.fixed for way in (-1, 1)]
    return np.min([low, *points], axis=0), np.max([high, *points], axis=0)


def draw_scenery(axes, scene, z):
    """Planes and fixed balls where the plane at `z` cuts them; the axes have their limits."""
    x, y = axes.get_xlim(), axes.get_ylim()
    far = 2 * np.hypot(np.ptp(x), np.ptp(y))
    for at, n in traces_of(scene, z, np.array((np.mean(x), np.mean(y))) / MM):
        line = at * MM + far * np.outer((-1, 1), (-n[1], n[0]))
        axes.add_patch(plt.Polygon([*line, *(line[::-1] - far * n)], fc=WALL, ec="0.6", lw=0,
                                   hatch="//////", zorder=1.5))
        axes.plot(*line.T, color=BLACK, lw=0.8, zorder=1.6, scalex=False, scaley=False)
    for ball in scene.fixed:
        reach = ball.radius ** 2 - (ball.centre[2] - z) ** 2
        if reach > 0:
            for look in ({"fc": WALL, "ec": "0.6", "lw": 0, "hatch": "//////"},
                         {"fill": False, "ec": BLACK, "lw": 0.8}):
                axes.add_patch(plt.Circle(ball.centre[:2] * MM, np.sqrt(reach) * MM, zorder=1.5,
                                          **look))


def draw_liner(axes, run):
    """The section of the last liner with its lifters; without a liner, the drum's circle."""
    if run.outline is not None and len(run.outline):
        axes.add_collection(LineCollection(run.outline * MM, colors=BLACK, linewidths=0.6, zorder=6,
                                           capstyle="round"))
    elif run.drum_radius:
        draw_circle(axes, run.drum_radius)


def draw_swept(axes, run):
    """For means over time: the shell, and dashed the circle that the lifters' tips run on."""
    if run.drum_radius:
        draw_circle(axes, run.drum_radius)
    if run.lifter_tips:
        draw_circle(axes, run.lifter_tips, ec="white", alpha=0.6)
        draw_circle(axes, run.lifter_tips, ls=(0, (3, 3)))


def tell_dashes(axes, run):
    if run.lifter_tips:
        axes.text(1, 0.01, "dashed: path of\nthe lifters' tips", transform=axes.transAxes, ha="right",
                  va="bottom", fontsize=6)


def draw_circle(axes, radius, **options):
    options = {"fill": False, "lw": 0.6, "ec": BLACK, "zorder": 6, **options}
    axes.add_patch(plt.Circle((0, 0), radius * MM, **options))


def shade_drum(axes, run):
    """Grey behind a map, for where nothing was seen."""
    if run.drum_radius:
        draw_circle(axes, run.drum_radius, fill=True, fc=WALL, lw=0, zorder=0)


def draw_rotation(axes, run):
    """An arrow outside the drum in the sense it turns."""
    speed = run.number("speed_rad_s")
    if not run.drum_radius or not speed:
        return
    radius, sense = run.drum_radius * 1.06 * MM, np.sign(speed)
    angles = np.radians(90 + sense * np.linspace(-14, 14, 30))
    x, y = radius * np.cos(angles), radius * np.sin(angles)
    axes.plot(x[:-1], y[:-1], color=BLACK, lw=0.8, clip_on=False)
    axes.annotate("", (x[-1], y[-1]), (x[-3], y[-3]), annotation_clip=False,
                  arrowprops={"arrowstyle": "-|>", "lw": 0.8, "color": BLACK,
                              "mutation_scale": 7, "shrinkA": 0, "shrinkB": 0})
