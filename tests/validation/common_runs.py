# SPDX-License-Identifier: Apache-2.0
"""For the experiments that run a shipped scene: running it, reading its traces, finding bounces;
checks and curves for docs/validation.md, as evidence.h has them for C."""
import csv
import os
import shutil
import subprocess
import sys

SCENES = os.path.join(os.environ.get("QUERN_SOURCE_DIR", "."), "scenes")


def run(scene, changes=(), program=None):
    """Runs a shipped scene on one thread, with pieces of its text exchanged; returns its folder."""
    with open(os.path.join(SCENES, scene + ".yaml"), encoding="utf-8") as file:
        text = file.read()
    for old, new in changes:
        assert text.count(old) == 1, f"{scene}.yaml has {old!r} {text.count(old)} times"
        text = text.replace(old, new)
    folder = os.path.abspath("run-" + scene)
    shutil.rmtree(folder, ignore_errors=True)
    with open("changed.yaml", "w", encoding="utf-8") as file:
        file.write(text)
    subprocess.run([program or sys.argv[1], "run", "changed.yaml", "-o", folder, "--threads", "1",
                    "--quiet"], check=True, timeout=240)
    return folder


def rows(folder, name):
    """Rows of a CSV file of a run, numbers as floats."""
    def number(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return [{k: number(v) for k, v in row.items()} for row in csv.DictReader(file)]


def _record(name, columns, values):
    """Adds rows to <case>.<name>.csv in the folder that `make validate` names, if it does."""
    folder = os.environ.get("QUERN_VALIDATION")
    if not folder:
        return
    case = os.path.splitext(os.path.basename(sys.argv[0]))[0]
    path = os.path.join(folder, f"{case}.{name}.csv")
    begins = not os.path.exists(path)
    with open(path, "a", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        if begins:
            writer.writerow(columns.split(","))
        writer.writerows(values)


def curve(name, columns, values):
    """Rows of a curve for the figure of the case; columns are "time (s),speed (m/s)"."""
    _record(name, columns, values)


def measure(quantity, at, value, expected, tolerance):
    """A check that is a row of docs/validation.md."""
    _record("checks", "quantity,at,value,expected,tolerance",
            [(quantity, at, repr(value), repr(expected), repr(tolerance))])
    assert abs(value - expected) <= tolerance, (
        f"{quantity} {at} = {value!r}, expected {expected!r} within {tolerance!r}")


def bounces(trace):
    """Pairs (last row before a contact, first row after it), by the force on the particle."""
    found, before = [], None
    for a, b in zip(trace, trace[1:]):
        free = [row["fx_n"] == row["fy_n"] == row["fz_n"] == 0 for row in (a, b)]
        if free == [True, False]:
            before = a
        if free == [False, True] and before:
            found.append((before, b))
    return found


def speed_at(row, height, gravity=9.81):
    """Vertical speed a freely falling or rising particle has where its centre is at `height`."""
    return (row["vy_m_s"] ** 2 + 2 * gravity * (row["y_m"] - height)) ** 0.5


def main(tests):
    """Runs the tests, says of each how it went; exits with 1 where one failed."""
    failed = 0
    for test in tests:
        try:
            test()
            print("ok  ", test.__name__)
        except AssertionError as error:
            failed += 1
            print("FAIL", test.__name__, error)
    sys.exit(failed > 0)
