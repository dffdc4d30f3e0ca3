# SPDX-License-Identifier: Apache-2.0
"""Runs that lose their footing stop with exit code 6: who, when, why, what to do; state kept."""
import pathlib

from common import UNSTABLE, changed, checkpoints, main, quern, run, test, tree, write

# A ball flies at a wall that is far softer than such an impact needs.
SHOT = """\
format: quern-scene/1
title: A ball shot at a soft wall
gravity: 0 0 0 m/s2
time: {end: 20 ms, step: 1 us}
materials:
  ball: {young: 1 MPa, poisson: 0.3, density: 2500 kg/m3}
contacts:
  ball-ball: {friction: 0.3, restitution: 0.7}
walls:
  floor: {shape: plane, material: ball, point: 0 0 0 m, normal: 0 1 0}
particles:
  still: {material: ball, diameter: 3 mm, at: 50 500 0 mm}
  shot: {material: ball, diameter: 3 mm, at: 0 600 0 mm, velocity: 0 -60 0 m/s}
measure: {series: 100 steps}
output: {frames: none, checkpoint: 5 ms, pictures: no}
"""


def fails(text, *parts):
    scene = write("shot.yaml", text)
    done = run(scene, "out").expect(UNSTABLE, *parts)
    failed = sorted(pathlib.Path("out").glob("failed_*.h5"))
    assert len(failed) == 1, failed
    step = int(failed[0].stem.split("_")[1])
    assert f"step {step})" in done.err and str(failed[0]) in done.err, done.err
    assert "failed at step" in pathlib.Path("out/log.txt").read_text()
    quern("info", failed[0]).expect(0)
    return step


@test("an overlap of 30 % stops the run: particle, wall, time, place, cause and remedy")
def overlap():
    step = fails(SHOT, "particle 2 overlaps wall floor", "of its radius", "m/s", "too soft",
                 "checkpoint")
    assert 9900 < step < 10200, step
    kept = checkpoints("out")
    assert 1 <= len(kept) <= 3 and int(kept[-1].stem.split("_")[1]) < step
    again = run("shot.yaml", "out", "--resume").expect(UNSTABLE, "particle 2")
    assert f"step {step})" in again.err, "a resumed run fails elsewhere"


@test("the last good checkpoint is kept, and the failed state is never resumed from")
def kept():
    fails(SHOT, "particle 2")
    before = {k: v for k, v in tree("out").items() if "checkpoint_" in k or "failed" in k}
    assert len(before) >= 2
    step = int(checkpoints("out")[-1].stem.split("_")[1])
    failed = int(next(pathlib.Path("out").glob("failed_*.h5")).stem.split("_")[1])
    assert step <= failed
    # A checkpoint may fall on the very step whose forces fail: good as a state, but not to be looked at.
    run("shot.yaml", "out", "--resume", "--steps", step).expect(0 if step < failed else UNSTABLE)
    after = tree("out")
    assert all(name in after for name in before), "the failed state or a checkpoint is gone"


@test("a large overlap below that is a warning, once")
def warning():
    scene = write("shot.yaml", changed(SHOT, ("young: 1 MPa", "young: 2000 MPa")))
    done = run(scene, "out", "--until", "12 ms").expect(0)
    assert done.err.count("warning") == 1 and "overlap" in done.err, done.err
    assert pathlib.Path("out/log.txt").read_text().count("overlap") == 1


@test("a ball that is squeezed between two walls is told as such, one that flies at a wall is not")
def squeezed():
    floor = "  floor: {shape: plane, material: ball, point: 0 0 0 m, normal: 0 1 0}\n"
    press = ("  press: {shape: plane, material: ball, point: 0 4 0 mm, normal: 0 -1 0, "
             "motion: {kind: translate, direction: 0 -1 0, speed: 0.5 m/s}}\n")
    fails(changed(SHOT, (floor, floor + press), ("at: 50 500 0 mm", "at: 50 1.5 0 mm"),
                  ("  shot: {material: ball, diameter: 3 mm, at: 0 600 0 mm, velocity: 0 -60 0 m/s}\n", "")),
          "particle 1 overlaps wall", "it is squeezed")
    done = run(write("shot.yaml", SHOT), "flown").expect(UNSTABLE)
    assert "squeezed" not in done.err, done.err


@test("a particle that is too fast for the time step stops the run")
def speed():
    fails(changed(SHOT, ("-60 0 m/s", "-400 0 m/s")), "particle 2", "too fast",
          "time step")


@test("particles placed into each other stop the run before it begins")
def placed():
    scene = write("shot.yaml", changed(SHOT, ("at: 50 500 0 mm", "at: 0.5 600 0 mm")))
    run(scene, "out").expect(UNSTABLE, "particle 1 overlaps particle 2", "placed into each other")
    assert not pathlib.Path("out").exists(), "a run that can't begin has left a folder"


main()
