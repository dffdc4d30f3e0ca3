# SPDX-License-Identifier: Apache-2.0
"""`quern run --resume` with a scene that was changed since: what it goes on with, what it refuses."""
import pathlib

from common import (INPUT, MILL, changed, main, quern, run, state_hash, summary, test, tree, write)

SHORT = changed(MILL, ("end: 0.06 s", "end: 150 steps"))

# Keys that neither motion nor checkpoints depend on: what is changed, and how it is told.
HARMLESS = [
    ("Small mill for tests of the program", "Another title", "title = Another title, was Small mill"),
    ("end: 150 steps", "end: 300 steps", "time.end = 300 steps, was 150 steps"),
    ("series: 20 steps", "series: 7 steps", "measure.series = 7 steps, was 20 steps"),
    ("ids: 1 50 100, every: 50 steps", "ids: 2 3, every: 30 steps",
     "measure.traces.ids = 2 3, was 1 50 100"),
    ("frames: 5 ms", "frames: none", "output.frames = none, was 0.005 s"),
    ("checkpoint: 60 s", "checkpoint: 10 s, keep: 7", "output.keep = 7, was 3"),
    ("output: {", "numerics: {skin: 0.3}\noutput: {", "numerics.skin = 0.3, was auto"),
    ("seed: 7\n", "# a comment\nseed:   7   # and another\n", ""),
]

# Keys that matter: what is changed, the place in the scene, and what the message must hold.
HARMFUL = [
    ("seed: 7", "seed: 8", 3, ["seed = 8", "began with 7"]),
    ("friction: 0.3", "friction: 0.31", 9, ["contacts.ball-ball.friction = 0.31", "with 0.3:"]),
    ("young: 20 MPa", "young: 30 MPa", 6, ["materials.ball.young = 3e+07 Pa", "with 2e+07 Pa"]),
    ("speed: 70 %critical", "speed: 1 rad/s", 11, ["drum.schedule[1].at = 1 rad/s", "12.65"]),
    ("height: 4 mm", "height: 3 mm", 17, ["drum.lifters.height = 0.003 m", "with 0.004 m"]),
    ("filling: 30 %", "filling: 29 %", 19, ["particles.balls.filling = 0.29", "with 0.3:"]),
    ("step: auto", "step: 1 us", 4, ["time.step = 1e-06 s", "with auto"]),
    ("cells: 1 2 4", "cells: 1 2", 22, ["measure.fields.cells = 1 2,", "with 1 2 4"]),
    ("start: 100 steps", "start: 90 steps", 22, ["measure.fields.start = 90 steps"]),
    (", restitution: 0.7}", ", restitution: 0.7, rolling_friction: 0.01}", 9,
     ["contacts.ball-ball.rolling = constant", "began with none:"]),
]


@test("a run goes on with a scene whose title, end, output or comments changed, to the same bits")
def harmless():
    run(write("whole.yaml", changed(SHORT, ("end: 150 steps", "end: 300 steps"))), "whole").expect(0)
    expected = state_hash("whole")
    for number, (old, new, told) in enumerate(HARMLESS):
        scene, folder = write("mill.yaml", SHORT), f"out{number}"
        run(scene, folder).expect(0)
        write("mill.yaml", changed(SHORT, (old, new)))
        more = [] if "300" in new else ["--steps", "300"]
        done = run(scene, folder, "--resume", *more).expect(0)
        assert done.err == "", done.err
        assert state_hash(folder) == expected, f"{new}: other bits"
        assert summary(folder)["steps"] == 300
        log = pathlib.Path(folder, "log.txt").read_text()
        assert not told or f"going on with {told}" in log, log
        assert pathlib.Path(folder, "scene.yaml").read_text() == scene.read_text()


@test("a later end in the scene is told on the terminal, and again a third time the run goes on")
def later_end():
    scene = write("mill.yaml", SHORT)
    run(scene, "out", "--steps", 50).expect(0)
    quern("run", scene, "-o", "out", "--threads", "1", "--resume").expect(
        0, "going on with time.end = 150 steps, was 50 steps", "going on from step 50, ")
    run(scene, "out", "--steps", 200, "--resume").expect(0)
    run(scene, "out", "--resume").expect(INPUT, "at step 200 already, past the end asked for (150)")


@test("a changed key that matters is named with both values, its place and the remedy")
def harmful():
    scene = write("mill.yaml", SHORT)
    run(scene, "out").expect(0)
    before = tree("out")
    for old, new, line, parts in HARMFUL:
        write("mill.yaml", changed(SHORT, (old, new)))
        done = run(scene, "out", "--resume", "--steps", 300)
        done.expect(INPUT, f"mill.yaml:{line}:", "error: ", *parts, "Put that back", "--force", "-o")
        assert tree("out") == before, f"{new}: the folder was touched"
    write("mill.yaml", SHORT)
    run(scene, "out", "--resume", "--steps", 300).expect(0)


@test("a key that matters and is gone or new is named too")
def gone():
    without = changed(SHORT, ("  lifters: {count: 6, height: 4 mm, top: 4 mm, face_angle: 70 deg}\n", ""))
    scene = write("mill.yaml", SHORT)
    run(scene, "with").expect(0)
    write("mill.yaml", without)
    run(scene, "without").expect(0)
    run(scene, "with", "--resume").expect(INPUT, "drum.lifters.count = not there", "began with 6")
    write("mill.yaml", SHORT)
    run(scene, "without", "--resume").expect(INPUT, "drum.lifters.count = 6", "began with not there")


@test("a changed file of points is seen, and so is another order of the groups")
def contents():
    square = "-30 -30\n30 -30\n30 30\n-30 30\n"
    write("points.txt", square)
    scene = write("mill.yaml", changed(
        SHORT, ("  lifters: {count: 6, height: 4 mm, top: 4 mm, face_angle: 70 deg}\n",
                "  profile: points.txt\n"), ("filling: 30 %", "count: 300")))
    run(scene, "out").expect(0)
    write("points.txt", square + "-31 0\n")
    run(scene, "out", "--resume").expect(INPUT, "drum.profile = (5 points from a file, hash ",
                                         "began with (4 points")
    write("points.txt", square)
    run(scene, "out", "--resume", "--steps", 200).expect(0)
    group = "  other: {material: ball, diameter: 3 mm, count: 5}\n"
    line = "  balls: {material: ball, diameter: 2.5 mm, filling: 30 %, jitter: 50 %}\n"
    few = line.replace("filling: 30 %", "count: 200")
    write("mill.yaml", changed(SHORT, (line, few + group)))
    run(scene, "order").expect(0)
    write("mill.yaml", changed(SHORT, (line, group + few)))
    run(scene, "order", "--resume").expect(INPUT, "particles.other.material stands where",
                                           "particles.balls.material", "order")


main()
