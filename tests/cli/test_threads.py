# SPDX-License-Identifier: Apache-2.0
"""Neither the number of threads nor the processor's instructions change a bit of a result."""
from common import MILL, changed, check_same_recordings, main, run, summary, test, write

# Long enough for many rebuilds of the pair list, and for balls that cross the periodic ends.
SCENE = changed(MILL, ("end: 0.06 s", "end: 2500 steps"), ("start: 100 steps", "start: 1500 steps"))


@test("1, 2, 3 and 8 threads give the same state, series, traces, fields and frames")
def threads():
    scene = write("mill.yaml", SCENE)
    run(scene, "1").expect(0)
    for count in (2, 3, 8):
        run(scene, str(count), threads=count).expect(0)
        assert summary(str(count))["threads"] == count
        check_same_recordings("1", str(count))


@test("each set of instructions gives the same")
def instructions():
    scene = write("mill.yaml", SCENE)
    run(scene, "own").expect(0)
    for isa in ("base", "v3", "v4"):
        run(scene, isa, env={"QUERN_ISA": isa}).expect(0)
        check_same_recordings("own", isa)


@test("a run that goes on with another number of threads is the same run")
def change_of_threads():
    scene = write("mill.yaml", SCENE)
    run(scene, "whole").expect(0)
    run(scene, "parts", "--steps", 700, threads=3).expect(0)
    run(scene, "parts", "--steps", 1600, "--resume", threads=1).expect(0)
    run(scene, "parts", "--resume", threads=2, env={"QUERN_ISA": "base"}).expect(0)
    check_same_recordings("whole", "parts")


@test("another seed gives another state")
def seeds():
    run(write("a.yaml", SCENE), "a", "--steps", 100).expect(0)
    run(write("b.yaml", changed(SCENE, ("seed: 7", "seed: 8"))), "b", "--steps", 100).expect(0)
    assert summary("a")["state_hash"] != summary("b")["state_hash"]


main()
