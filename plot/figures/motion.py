# SPDX-License-Identifier: Apache-2.0
"""Where a moving plane stands at a time, from the keys of its motion in resolved.yaml.

The formulas are those of the program (src/world/drive.c): the way gone (m or rad) is the integral of
a speed that is linear leg by leg; or, to and fro, that of a sine that starts at `settle`.
"""
import re

import numpy as np

KEY = re.compile(r"      (\w+): *(.*)")
LEG = re.compile(r"        - \{(?:duration: (\S+) s, from: (\S+) \S+ to: (\S+) \S+|at: (\S+) \S+)\}")


def read_motion(line, motion):
    """Takes a line under `motion:` into the dict of its keys."""
    if found := LEG.match(line):
        duration, first, last, steady = (float(text) if text else None for text in found.groups())
        motion.setdefault("legs", []).append(
            (np.inf, steady, steady) if duration is None else (duration, first, last))
    elif found := KEY.match(line):
        motion[found[1]] = found[2]


def way_gone(motion, time):
    """m or rad from where the plane is defined."""
    if motion["kind"] in ("rotate", "translate"):
        gone = 0.0
        for duration, first, last in motion["legs"]:
            part = min(time, duration)
            gone += first * part + 0.5 * (last - first) / duration * part ** 2
            time -= part
        return gone
    size, frequency, phase, start = (float(motion[key].split()[0]) for key in
                                     ("amplitude", "frequency", "phase", "settle"))
    if time < start:
        return 0.0
    return size * (np.sin(2 * np.pi * frequency * (time - start) + phase) - np.sin(phase))


def vector(text):
    return np.array(text.split()[:3], float)


def turned(v, axis, angle):
    """A vector turned about a unit axis (Rodrigues)."""
    return v * np.cos(angle) + np.cross(axis, v) * np.sin(angle) \
        + axis * (axis @ v) * (1 - np.cos(angle))


def moved(point, normal, motion, time):
    """Point (m) and normal of a plane at a time (s)."""
    gone = way_gone(motion, time)
    turns = motion["kind"] in ("rotate", "swing")
    axis = vector(motion["axis" if turns else "direction"])
    axis /= np.linalg.norm(axis)
    if not turns:
        return point + gone * axis, normal
    through = vector(motion["through"])
    return through + turned(point - through, axis, gone), turned(normal, axis, gone)
