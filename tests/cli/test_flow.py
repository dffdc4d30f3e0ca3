# SPDX-License-Identifier: Apache-2.0
"""Particles that come and go while running: amounts, energy, and going on after a stop."""
import json

from common import INPUT, MILL, changed, check_same_recordings, main, quern, run, summary, test, write

# A mill with a screen as its end and a chute that feeds rock; balls are too large for the screen.
SCENE = changed(MILL,
    ("end: 0.06 s, step: auto", "end: 3000 steps, step: 10 us"),
    ("ends: periodic", "ends: turning"),
    ("start: 100 steps", "start: 1500 steps"),
    ("measure:\n", """\
  rock:
    material: ball
    fill: feed
    distribution: {kind: rosin-rammler, d63: 1.8 mm, n: 2, min: 1.2 mm, max: 2.4 mm, classes: 3}
feeds:
  chute: {particles: rock, rate: 9000 1/s, low: -10 10 1 mm, high: 10 15 8 mm, velocity: 0 -1 0.3 m/s, stop: 25 ms}
outlets:
  screen: {point: 0 0 15 mm, normal: 0 0 1, aperture: 1.9 mm}
measure:
"""))


@test("what comes in and goes out adds up, in the summary and in the series")
def amounts():
    run(write("mill.yaml", SCENE), "out").expect(0)
    found = summary("out")
    fed, screen = found["feeds"]["chute"], found["outlets"]["screen"]
    assert fed["particles"] > 100 and screen["particles"] > 5, (fed, screen)
    assert all(row["diameter_m"] < 1.9e-3 and row["group"] == "rock" for row in screen["classes"])
    assert sum(row["particles"] for row in fed["classes"]) == fed["particles"]
    rows = (line.split(",") for line in open("out/series.csv"))
    header = next(rows)
    last = dict(zip(header, [row for row in rows][-1]))
    assert int(float(last["fed"])) == fed["particles"]
    assert abs(float(last["removed_kg"]) - screen["mass_kg"]) < 1e-12
    assert abs(float(last["brought_in_j"]) - found["brought_in_j"]) < 1e-12
    start = found["particles"] - fed["particles"] + screen["particles"]
    assert str(start) + " particles" in open("out/log.txt").read()
    assert abs(found["energy_residual_relative"]) < 0.02, found["energy_residual_relative"]


@test("a run that is stopped and goes on, with other threads, is the same run")
def resumed():
    scene = write("mill.yaml", SCENE)
    run(scene, "whole").expect(0)
    run(scene, "parts", "--steps", 1234, threads=2).expect(0)
    run(scene, "parts", "--steps", 1235, "--resume").expect(0)
    run(scene, "parts", "--resume", threads=3).expect(0)
    check_same_recordings("whole", "parts")
    assert summary("whole")["feeds"] == summary("parts")["feeds"]
    assert summary("whole")["outlets"] == summary("parts")["outlets"]
    # and what the run understood is itself a scene that runs the same
    run("whole/resolved.yaml", "again").expect(0)
    assert summary("again")["outlets"] == summary("whole")["outlets"]


@test("check lists feeds and outlets, and the run's cost counts what will come")
def checked():
    done = quern("check", write("mill.yaml", SCENE)).expect(0)
    assert "feed chute           9000 1/s from 0 s on: about 225 spheres, " in done.out, done.out
    assert "outlet screen        takes what is smaller than 1.9 mm" in done.out, done.out
    some = json.loads(quern("check", "--json", "mill.yaml").expect(0).out)
    assert abs(some["feeds"]["chute"]["particles"] - 225) < 1e-6 and some["feeds"]["chute"]["rate_1_s"] == 9000
    assert some["outlets"]["screen"]["aperture_m"] == 1.9e-3
    scene = changed(SCENE, ("9000 1/s", "90 kg/s"), ("stop: 25 ms", "start: 5 ms, stop: 25 ms"))
    much = json.loads(quern("check", "--json", write("much.yaml", scene)).expect(0).out)
    assert abs(much["feeds"]["chute"]["mass_kg"] - 1.8) < 1e-9
    assert all(much[key] > 5 * some[key] for key in ("wall_s", "disk_bytes", "memory_bytes")), (some, much)


@test("a feed whose places are full says what it gave of what was asked")
def short():
    for rate, sentence in (("1 kg/s", " g of the 8 g asked"), ("2e6 1/s", " of the 1.6e+04 asked")):
        scene = write("mill.yaml", changed(SCENE, ("9000 1/s", rate), ("3000 steps", "800 steps")))
        done = quern("run", scene, "-o", "out", "--force", "--threads", 1).expect(0, sentence + ": its places were full")
        line = next(line for line in done.err.splitlines() if line.startswith("feed chute gave"))
        assert line in open("out/log.txt").read(), line
    scene = write("mill.yaml", changed(SCENE, ("3000 steps", "1500 steps")))
    assert "asked" not in quern("run", scene, "-o", "well", "--threads", 1).expect(0).err


@test("a world may begin empty")
def empty():
    scene = changed(SCENE, ("  balls: {material: ball, diameter: 2.5 mm, filling: 30 %, jitter: 50 %}\n", ""),
                    ("ids: 1 50 100", "ids: 1"))
    run(write("mill.yaml", scene), "out", "--steps", 1000).expect(0)
    found = summary("out")
    assert found["particles"] == found["feeds"]["chute"]["particles"] - found["outlets"]["screen"]["particles"]


@test("balls are fed among clumps; clumps themselves are refused")
def clumps():
    screen = "outlets:\n  screen: {point: 0 0 15 mm, normal: 0 0 1, aperture: 1.9 mm}\n"
    grains = changed(SCENE, ("filling: 30 %", "filling: 20 %, shape: tetrahedron"), ("3000 steps", "1500 steps"))
    scene = write("mill.yaml", changed(grains, (screen, "")))
    run(scene, "whole").expect(0)
    assert summary("whole")["feeds"]["chute"]["particles"] > 50
    run(scene, "parts", "--steps", 1234, threads=2).expect(0)
    run(scene, "parts", "--resume").expect(0)
    check_same_recordings("whole", "parts")
    quern("check", write("out.yaml", grains)).expect(INPUT, "the clumps of particles.balls cannot leave")
    quern("check", write("in.yaml", changed(SCENE, ("fill: feed", "fill: feed\n    shape: tetrahedron")))).expect(
        INPUT, "feeds.chute: clumps cannot be fed")


@test("what is wrong with a feed or an outlet is said where it stands")
def wrong():
    for old, new, sentence in (
            ("particles: rock, rate", "particles: rocks, rate",
             "feeds.chute.particles = rocks is not a group of particles; did you mean 'rock'?"),
            ("9000 1/s", "9000 kg", "feeds.chute.rate = 9000 kg should be a mass by time or a frequency"),
            ("stop: 25 ms", "start: 25 ms, stop: 20 ms", "feeds.chute.stop = 20 ms must be after start, 25 ms"),
            ("low: -10 10 1 mm, high: 10 15 8 mm", "low: -10 40 1 mm, high: 10 45 8 mm",
             "feeds.chute: its region has no room within the walls for a sphere of"),
            ("high: 10 15 8 mm", "high: 10 9 8 mm", "must be above low, -10 10 1 mm, in each coordinate"),
            ("low: -10 10 1 mm, ", "", "feeds.chute needs either the keys 'low' and 'high' or 'centre' and 'radius'"),
            ("low: -10 10 1 mm", "low: 9 14 7 mm", "feeds.chute: its region has no room for a sphere of"),
            (", normal: 0 0 1", "", "outlets.screen needs either the keys 'low' and 'high' or 'point' and 'normal'"),
            ("normal: 0 0 1", "normal: 0 0 0", "outlets.screen.normal = 0 0 0 has no direction"),
            ("point: 0 0 15 mm, normal: 0 0 1", "low: 0 0 0 mm, high: 1 1 1 mm",
             "outlets.screen.aperture = 1.9 mm means nothing for a box"),
            ("fill: feed", "fill: feed\n    count: 3", "particles.rock.count = 3 means nothing where fill is feed")):
        done = quern("check", write("wrong.yaml", changed(SCENE, (old, new)))).expect(INPUT, sentence)
        assert "wrong.yaml:" in done.err


main()
