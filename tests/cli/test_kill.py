# SPDX-License-Identifier: Apache-2.0
"""Runs that are killed, interrupted or continued end as if nothing had happened."""
import pathlib
import random
import re
import shutil
import signal
import time

from common import (INPUT, INTERRUPTED, MILL, PROGRAM, changed, check_same_recordings, check_tidy,
                    checkpoints, main, run, start, state_hash, summary, test, wait, wait_until,
                    write)

KILLS = 20
OFTEN = changed(MILL, ("checkpoint: 60 s", "checkpoint: 50 ms"))
HALF = ("end: 0.06 s", "end: 0.03 s")


def partial_seen(folder):
    return any(p.name.endswith(".partial") for p in (folder / "checkpoints").glob("*")) or any(
        p.name.endswith(".partial") for p in folder.glob("*"))


def wait_for_partial(child, folder, seconds):
    """Until a file is being written, which is gone within a millisecond or so."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and child.poll() is None:
        if partial_seen(folder):
            return True
    return False


def steps_gone_on_from(folder):
    return [int(step) for step in re.findall(r"going on at step (\d+)",
                                             (folder / "log.txt").read_text())]


@test("kill -9 at twenty random moments, each followed by --resume, changes nothing")
def kill_at_random():
    scene = write("mill.yaml", OFTEN)
    run(scene, "whole").expect(0)
    wall = summary("whole")["wall_s"]
    folder = pathlib.Path("killed")
    moments = random.Random(20)
    kills = amid_write = 0
    gone_on = []
    while kills < KILLS:
        child = start(scene, folder, "--resume")
        time.sleep(moments.uniform(0.02, 1.5 * wall / KILLS))
        if kills % 3 == 2:
            amid_write += wait_for_partial(child, folder, 0.5)
        child.kill()
        done = wait(child)
        if done.code == 0:  # the end came before the kill: once more from the start
            check_same_recordings("whole", folder)
            gone_on += steps_gone_on_from(folder)
            shutil.rmtree(folder)
            continue
        assert done.code == -signal.SIGKILL, done.err
        kills += 1
    run(scene, folder, "--resume").expect(0)
    check_same_recordings("whole", folder)
    check_tidy(folder)
    assert len(checkpoints(folder)) == 3
    gone_on += steps_gone_on_from(folder)
    assert len(gone_on) >= KILLS // 2, f"hardly any run went on from a checkpoint: {gone_on}"
    assert len(set(gone_on)) >= 4, f"the run has not come forward: {gone_on}"
    assert amid_write >= 2, "hardly any kill amid a write"


@test("a run killed before its first checkpoint starts again from the beginning")
def kill_early():
    scene = write("mill.yaml", changed(MILL, ("end: 0.06 s", "end: 0.02 s")))
    run(scene, "whole").expect(0)
    folder = pathlib.Path("killed")
    child = start(scene, folder)
    wait_until(lambda: (folder / "frames" / "frame_000001.hdf").exists())
    child.kill()
    wait(child)
    assert not checkpoints(folder)
    run(scene, folder, "--resume").expect(0)
    check_same_recordings("whole", folder)
    check_tidy(folder)


@test("a damaged newest checkpoint is put aside and the one before it is used")
def damaged_checkpoint():
    scene = write("mill.yaml", changed(OFTEN, HALF))
    run(scene, "whole").expect(0)
    run(scene, "hurt").expect(0)
    newest = checkpoints("hurt")[-1]
    newest.write_bytes(newest.read_bytes()[:5000])
    run(scene, "hurt", "--resume").expect(0, newest.name, "older checkpoint")
    check_same_recordings("whole", "hurt")
    assert newest.exists() and newest.with_name(newest.name + ".damaged").exists()


def interrupt_by(which):
    scene = write("mill.yaml", changed(MILL, HALF))
    run(scene, "whole").expect(0)
    folder = pathlib.Path("stopped")
    for frame, more in ((1, []), (3, ["--resume"])):
        child = start(scene, folder, *more)
        wait_until(lambda: (folder / "frames" / f"frame_{frame:06d}.hdf").exists())
        child.send_signal(which)
        stopped = wait(child).expect(
            INTERRUPTED, f"go on with: {PROGRAM} run {scene} -o {folder} --resume", "checkpoint")
        newest = checkpoints(folder)[-1]
        step = int(newest.stem.split("_")[1])
        assert 0 < step < summary("whole")["steps"], step
        assert f"step {step})" in stopped.err, stopped.err
        assert summary(folder)["finished"] is False and summary(folder)["steps"] == step
    run(scene, folder, "--resume").expect(0)
    assert steps_gone_on_from(folder)[-1] == step
    assert summary(folder)["finished"] is True
    check_same_recordings("whole", folder)
    check_tidy(folder)


@test("SIGTERM stops with a checkpoint and says how to go on, and the resumed run is the whole one")
def terminate():
    interrupt_by(signal.SIGTERM)


@test("SIGINT does the same")
def interrupt():
    interrupt_by(signal.SIGINT)


@test("a finished run continued with more --steps is the long run")
def continued():
    scene = write("mill.yaml", MILL)
    run(scene, "whole", "--steps", 3001).expect(0)
    for steps in (0, 1, 1234, 1235, 2000, 3001):
        run(scene, "parts", "--steps", steps, *(["--resume"] if steps else [])).expect(0)
        assert summary("parts")["steps"] == steps and summary("parts")["finished"] is True
        assert int(checkpoints("parts")[-1].stem.split("_")[1]) == steps
    assert steps_gone_on_from(pathlib.Path("parts")) == [0, 1, 1234, 1235, 2000]
    check_same_recordings("whole", "parts")


@test("a finished run resumed to the same end stays as it is")
def resumed_in_vain():
    scene = write("mill.yaml", MILL)
    run(scene, "whole", "--steps", 3000).expect(0)
    run(scene, "again", "--steps", 3000).expect(0)
    run(scene, "again", "--steps", 3000, "--resume").expect(0)
    check_same_recordings("whole", "again")


@test("a run that is past the asked end is refused and left alone")
def past_the_end():
    scene = write("mill.yaml", MILL)
    run(scene, "run", "--steps", 1700).expect(0)
    before = state_hash("run")
    rows = pathlib.Path("run/series.csv").read_text()
    run(scene, "run", "--steps", 1699, "--resume").expect(INPUT, "step 1700", "1699")
    assert state_hash("run") == before
    assert pathlib.Path("run/series.csv").read_text() == rows, "series.csv has lost rows"
    run(scene, "run", "--steps", 1800, "--resume").expect(0)
    run(scene, "whole", "--steps", 1800).expect(0)
    check_same_recordings("whole", "run")


@test("series.csv of a run has neither gap nor repeat")
def series_steps():
    scene = write("mill.yaml", MILL)
    run(scene, "run", "--steps", 130).expect(0)
    run(scene, "run", "--steps", 255, "--resume").expect(0)
    lines = pathlib.Path("run/series.csv").read_text().splitlines()
    steps = [int(line.split(",")[0]) for line in lines[1:]]
    assert steps == [*range(0, 255, 20), 255], steps


main()
