# SPDX-License-Identifier: Apache-2.0
"""A disk that fills up during a run: told, nothing lost, and the run goes on once there is room.

The disk is a small tmpfs; where this process may not mount one, the tests are skipped.
"""
import contextlib
import pathlib
import subprocess

from common import (IO, MILL, Skip, changed, check_same_recordings, check_tidy, checkpoints,
                    main, quern, run, test, write)

OFTEN = changed(MILL, ("checkpoint: 60 s", "checkpoint: 50 ms"))


def mount(*options):
    return subprocess.run(["mount", *options], capture_output=True).returncode == 0


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
    scene = write("mill.yaml", OFTEN)
    run(scene, "whole").expect(0)
    with small_disk(size) as disk:
        folder = disk / "run"
        done = run(scene, folder).expect(IO, "No space left on device", str(folder))
        assert len(done.err.strip().splitlines()) == 1, done.err
        kept = checkpoints(folder)
        assert len(kept) >= least_checkpoints, kept
        for path in kept:
            quern("info", path).expect(0)
        check_tidy(folder)
        run(scene, folder, "--resume").expect(IO, "No space left on device")
        assert checkpoints(folder)[-1] >= kept[-1] if kept else True
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
