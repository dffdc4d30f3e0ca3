# SPDX-License-Identifier: Apache-2.0
"""A disk that fills up during a run: told, nothing lost, and the run goes on once there is room.

The disk is a small tmpfs; where this process may not mount one, the tests are skipped.
"""
import contextlib
import pathlib
import shutil
import subprocess

from common import (IO, MILL, PROGRAM, Skip, changed, check_same_recordings, check_tidy, checkpoints,
                    main, quern, run, test, write)

OFTEN = changed(MILL, ("checkpoint: 60 s", "checkpoint: 50 ms"),
                ("end: 0.06 s", "end: 0.03 s"))


def mount(*options):
    program = shutil.which("mount")
    return program and subprocess.run([program, *options], capture_output=True).returncode == 0


@contextlib.contextmanager
def small_disk(size):
    disk = pathlib.Path("disk").absolute()
    disk.mkdir()
    if not mount("-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk)):
        raise Skip("a tmpfs can't be mounted here")
    try:
        yield disk
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=True)


def fills_up(size, least_checkpoints):
    with small_disk(size) as disk:
        scene, folder = write("mill.yaml", OFTEN), disk / "run"
        run(scene, "whole").expect(0)
        done = run(scene, folder).expect(IO, "No space left on device", str(folder))
        assert len(done.err.strip().splitlines()) == 1, done.err
        done.expect(IO, f"; free some room, then: {PROGRAM} run {scene} -o {folder} --resume")
        failed = [line for line in (folder / "log.txt").read_text().splitlines() if "failed at step" in line]
        assert len(failed) == 1 and "No space left on device" in failed[0], failed
        kept = checkpoints(folder)
        done.expect(IO, f"safe up to step {int(kept[-1].stem[-12:])} (" if kept else "Nothing is safe yet")
        assert len(kept) >= least_checkpoints, kept
        for path in kept:
            quern("info", path).expect(0)
        check_tidy(folder)
        run(scene, folder, "--resume").expect(IO, "No space left on device")
        assert not kept or checkpoints(folder)[-1] >= kept[-1]
        assert mount("-o", "remount,size=64m", str(disk))
        run(scene, folder, "--resume").expect(0)
        check_same_recordings("whole", folder)
        check_tidy(folder)


@test("a disk that fills up after some checkpoints: told, they are intact, and the run goes on")
def after_checkpoints():
    fills_up("1600k", 1)


@test("a disk that is full before the first checkpoint: told, and the run goes on from the start")
def at_once():
    fills_up("300k", 0)


main()
