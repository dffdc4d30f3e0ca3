# SPDX-License-Identifier: Apache-2.0
"""`quern run`: what it refuses, and that it then writes nothing; its options."""
import os
import pathlib
import re

from common import (INPUT, IO, MILL, changed, check_same_recordings, check_tidy, checkpoints, main,
                    quern, run, start, state_hash, summary, test, tree, wait, wait_until, write)

LIFTERS = "  lifters: {count: 6, height: 4 mm, top: 4 mm, face_angle: 70 deg}\n"
SHORT = changed(MILL, ("end: 0.06 s", "end: 60 steps"))

# What is wrong, the change that makes it so, and the message: place and what it must hold. Each is the
# only error told.
WRONG = [
    ("an unknown key", "title:", "tilte:", "2:1", "unknown key 'tilte' in the scene; did you mean 'title'?"),
    ("an unknown material in a pair", "ball-liner:", "ball-linear:", "10:3",
     "'ball-linear' in contacts is not a pair of materials; did you mean 'ball-liner'?"),
    ("an unknown material", "material: liner", "material: linear", "14:13",
     "drum.material = linear is not a material; did you mean 'liner'?"),
    ("a missing key", "poisson: 0.3, ", "", "6:3", "materials.ball lacks the key 'poisson'"),
    ("a missing unit", "length: 15 mm", "length: 15", "13:11",
     "drum.length = 15 needs a unit: m, mm, cm, um, in"),
    ("a wrong unit", "length: 15 mm", "length: 15 kg", "13:11",
     "drum.length = 15 kg should be a length (m, mm, cm, um, in), but kg is the unit of a mass"),
    ("an unknown unit", "length: 15 mm", "length: 15 nm", "13:11",
     "drum.length = 15 nm has no known unit: 'nm'; did you mean mm?"),
    ("a unit on a pure number", "seed: 7", "seed: 7 m", "3:7",
     "seed = 7 m is a pure number and takes no unit"),
    ("trailing junk", "density: 2500 kg/m3", "density: 25oo kg/m3", "6:49",
     "materials.ball.density = 25oo kg/m3 is not a number: 'o' is a letter, not the digit 0"),
    ("a decimal comma", "diameter: 2.5 mm", "diameter: 2,5 mm", "19:37",
     "particles.balls.diameter = 2,5 mm has a comma: decimals follow a '.'"),
    ("a negative diameter", "diameter: 2.5 mm", "diameter: -2.5 mm", "19:37",
     "particles.balls.diameter = -2.5 mm must be above 0 mm"),
    ("nan", "density: 2500 kg/m3", "density: nan kg/m3", "6:49",
     "materials.ball.density = nan kg/m3 is not a number"),
    ("1e400", "density: 2500 kg/m3", "density: 1e400 kg/m3", "6:49",
     "materials.ball.density = 1e400 kg/m3 is too large for a number"),
    ("a Poisson's ratio of 0.7", "poisson: 0.3", "poisson: 0.7", "6:35",
     "materials.ball.poisson = 0.7 must be above -1 and at most 0.5 (Poisson's ratio)"),
    ("a restitution of 0", "restitution: 0.7", "restitution: 0", "9:44",
     "contacts.ball-ball.restitution = 0 must be above 0 and at most 1"),
    ("a restitution of 1.2", "restitution: 0.7", "restitution: 1.2", "9:44",
     "contacts.ball-ball.restitution = 1.2 must be above 0 and at most 1"),
    ("a filling of 30", "filling: 30 %", "filling: 30", "19:54", "; did you mean 30 %?"),
    ("a duplicate key", "seed: 7", "seed: 7\nseed: 8", "4:1",
     "key 'seed' appears twice in the scene; it is first in line 3"),
    ("more particles than fit", "filling: 30 %", "count: 500000", "19:52",
     "particles.balls.count: 500000 do not fit, at most 2630 do"),
    ("a missing geometry file", LIFTERS, "  profile: no.txt\n", "17:12",
     "drum.profile = no.txt cannot be used: no.txt: cannot be opened: No such file or directory"),
    ("a missing mesh", "particles:", "walls: {a: {shape: mesh, material: liner, file: no.stl}}\nparticles:",
     "18:49", "walls.a.file = no.stl cannot be used: no.stl: cannot be opened: No such file or directory"),
    ("no law for a pair", "  ball-liner: {friction: 0.5, restitution: 0.5}\n", "", "8:1",
     "contacts lacks 'ball-liner': particles 'balls' and the drum can touch"),
    ("a step above the Rayleigh time", "step: auto", "step: 1 ms", "4:29",
     "time.step = 0.001 s is 13.07 of the Rayleigh time (7.64911e-05 s); allowed is up to 1"),
    ("a missing colon", "length: 15 mm", "length 15 mm", "13:3", "a ':' is missing"),
    ("a missing space", "length: 15 mm", "length:15 mm", "13:9", "a space is missing behind the ':'"),
    ("a wrong indentation", "  length: 15 mm", "   length: 15 mm", "13:4", "begins in column 4"),
    ("a tab", "  length: 15 mm", "\tlength: 15 mm", "13:1", "a tab cannot be used to indent"),
]


def refuses(what, code, *parts, more=()):
    """The run says so and leaves no trace."""
    before = tree(".")
    done = quern("run", what, "-o", "out/run", "--threads", "1", *more).expect(code, *parts)
    assert tree(".") == before, f"written: {sorted(set(tree('.')) - set(before))}"
    assert done.out == "", done.out
    return done


def declare(what, old, new, place, sentence):
    @test(f"{what} is told with its place, with exit code 2 and nothing written")
    def _():
        text = changed(SHORT, (old, new))
        done = refuses(write("mill.yaml", text), INPUT, f"mill.yaml:{place}: error: ", sentence)
        assert done.err.count(": error: ") == 1, done.err
        first, shown, caret, last, *rest = done.err.split("\n")
        assert first.startswith(f"mill.yaml:{place}: error: ") and sentence in first, done.err
        line, column = map(int, place.split(":"))
        assert shown == text.splitlines()[line - 1] and caret.expandtabs(1).index("^") == column - 1
        assert last == "quern run: nothing was started or written" and rest == [""], done.err


for case in WRONG:
    declare(*case)


@test("an error shows file, line and column, the source line and a caret under the value")
def caret():
    scene = write("mill.yaml", changed(SHORT, ("young: 20 MPa", "young: 20 MPb")))
    done = refuses(scene, INPUT)
    lines = done.err.splitlines()
    first = next(i for i, line in enumerate(lines) if "mill.yaml:6:" in line)
    line, column = map(int, re.search(r"mill\.yaml:(\d+):(\d+)", lines[first]).groups())
    source = SHORT.splitlines()[line - 1].replace("20 MPa", "20 MPb")
    shown = next(i for i in range(first, len(lines)) if source in lines[i])
    indent = lines[shown].index(source)
    assert lines[shown + 1][indent + column - 1] == "^", done.err
    assert source[column - 1:].startswith(("20 MPb", "MPb")), source[column - 1:]


@test("all errors are told in one go")
def all_errors():
    scene = write("mill.yaml", changed(SHORT, ("seed: 7", "sead: 7"), ("15 mm", "15"),
                                       ("friction: 0.5", "friction: -1")))
    done = refuses(scene, INPUT)
    for place in ("mill.yaml:3:", "mill.yaml:13:", "mill.yaml:10:"):
        assert place in done.err, done.err


@test("files that are no scenes are told")
def no_scenes():
    pathlib.Path("folder").mkdir()
    refuses("folder", INPUT, "folder: error: is a folder, not a scene")
    refuses(write("empty.yaml", ""), INPUT, "empty.yaml: error: the file is empty")
    refuses(write("binary.yaml", bytes(range(256)) * 64), INPUT,
            "binary.yaml: error: not a text file: byte 1 is 0x00")
    with open("huge.yaml", "wb") as file:
        file.truncate(100_000_000)
    refuses("huge.yaml", INPUT, "huge.yaml: error: is larger than 1 MB, which no scene needs")
    refuses("missing.yaml", INPUT, "missing.yaml: error: No such file or directory")
    assert not pathlib.Path("out").exists()


@test("bad options are told with the usage, and nothing is written")
def bad_options():
    scene = write("mill.yaml", SHORT)
    for more, part in ((["--threads", "0"], "--threads"), (["--threads", "two"], "two"),
                       (["--steps", "-1"], "-1"), (["--steps", "1.5"], "1.5"),
                       (["--steps", "10x"], "10x"), (["--until", "2 kg"], "2 kg"),
                       (["--until", "2"], "--until"), (["--until", "soon"], "soon"),
                       (["--until", "-1 s"], "-1 s"), (["--until", "nan s"], "nan"),
                       (["--frobnicate"], "--frobnicate"), (["--steps"], "'--steps' needs a value"),
                       (["-o"], "'-o' needs a value"), (["-x"], "'-x' is not an option"),
                       (["--forse"], "'--forse' is not an option; did you mean '--force'?"),
                       (["--steps", "3", "--until", "1 s"], "--until and --steps"),
                       (["--resume", "--force"], "--resume goes on with a run, --force"),
                       (["other.yaml"], "'other.yaml' is one word too many: give one scene")):
        refuses(scene, INPUT, part, "usage: quern run", more=more)
    quern("run").expect(INPUT, "which scene?", "usage: quern run")


@test("an unknown command is told, with the commands there are")
def unknown_command():
    done = quern("rum", "mill.yaml").expect(
        INPUT, "quern: there is no command 'rum'; did you mean 'run'?", "quern check")
    assert done.out == ""
    assert quern().expect(0).out.count("quern ") > 6


@test("the folder of a run is not written to without --resume or --force")
def existing_run():
    scene = write("mill.yaml", SHORT)
    run(scene, "out").expect(0)
    before = tree("out")
    run(scene, "out").expect(INPUT, "the folder out holds a run already", "(--resume)", "(--force)", "(-o)")
    assert tree("out") == before
    other = write("other.yaml", changed(SHORT, ("seed: 7", "seed: 8")))
    run(other, "out", "--resume").expect(INPUT, "other.yaml:3:7:", "seed = 8", "--force")
    assert tree("out") == before, "another scene has touched the run"


@test("a folder or file that is not a run's is never touched, not even by --force")
def foreign_folder():
    scene = write("mill.yaml", SHORT)
    pathlib.Path("mine").mkdir()
    write("mine/thesis.txt", "four years of work")
    write("file", "a file")
    before = tree(".")
    for more in ([], ["--force"], ["--resume"]):
        run(scene, "mine", *more).expect(INPUT, "mine")
        run(scene, "file", *more).expect(INPUT, "file")
    assert tree(".") == before


@test("--force makes the run anew and leaves what it did not make")
def force():
    scene = write("mill.yaml", MILL)
    run(scene, "whole", "--steps", 1800).expect(0)
    run(scene, "out", "--steps", 2000).expect(0)
    write("out/notes.txt", "mine")
    run(scene, "out", "--steps", 1800, "--force").expect(0)
    assert pathlib.Path("out/notes.txt").read_text() == "mine"
    pathlib.Path("out/notes.txt").unlink()
    check_same_recordings("whole", "out")
    check_tidy("out")
    assert len(checkpoints("out")) == 1


@test("--resume of a folder that is not there starts a run")
def resume_nothing():
    scene = write("mill.yaml", SHORT)
    run(scene, "one").expect(0)
    run(scene, "other", "--resume").expect(0)
    assert state_hash("one") == state_hash("other")


@test("two programs cannot write to one folder at once")
def locked():
    scene = write("mill.yaml", MILL)
    child = start(scene, "out")
    wait_until(lambda: pathlib.Path("out/log.txt").exists())
    for more in ("--resume", "--force"):
        run(scene, "out", more).expect(INPUT, "another program")
    child.terminate()
    wait(child)
    assert child.returncode == 7


@test("--steps and --until count from the start of the run")
def ends():
    scene = write("mill.yaml", MILL)
    run(scene, "steps", "--steps", 100).expect(0)
    assert summary("steps")["steps"] == 100
    run(scene, "steps", "--until", "150 steps", "--resume").expect(0)
    assert summary("steps")["steps"] == 150
    dt = summary("steps")["dt_s"]
    run(scene, "time", "--until", "2 ms").expect(0)
    assert abs(summary("time")["time_s"] - 2e-3) <= dt
    run(scene, "time", "--until", "3 ms", "--resume").expect(0)
    assert abs(summary("time")["time_s"] - 3e-3) <= dt
    run(scene, "turns", "--until", "0.01 rev").expect(0)
    turn = summary("turns")["time_s"] * summary("turns")["speed_rad_s"] / 6.283185307179586
    assert abs(turn - 0.01) < 1e-4, turn


@test("the run goes to the scene's folder, or to out/ and the scene's name")
def folders():
    write("mill.yaml", SHORT)
    quern("run", "mill.yaml", "--threads", "1").expect(0)
    assert summary("out/mill")["steps"] == 60
    write("named.yaml", changed(SHORT, ("{frames", "{directory: here/there, frames")))
    quern("run", "named.yaml", "--threads", "1").expect(0)
    assert summary("here/there")["steps"] == 60


@test("--quiet says nothing, else progress lines with percent come on stderr")
def progress():
    scene = write("mill.yaml", SHORT)
    done = run(scene, "quiet").expect(0)
    assert done.out == "" and done.err == "", done.err
    done = quern("run", scene, "-o", "loud", "--threads", "1").expect(0)
    assert done.out == ""
    for part in ("890 particles", "100.0 %", "particle-steps/s", "left"):
        assert part in done.err, done.err
    assert "\r" not in done.err


@test("summary.json has what is promised")
def summary_keys():
    scene = write("mill.yaml", SHORT)
    run(scene, "out").expect(0)
    found = summary("out")
    for key in ("particles steps time_s dt_s wall_s particle_steps_per_s threads backend "
                "critical_speed_rad_s speed_rad_s power_torque_w power_stderr_w power_dissipated_w "
                "steady energy_residual_relative max_overlap_over_radius contacts_per_particle "
                "solidity_bulk shoulder_deg toe_deg state_hash").split():
        assert key in found, key
    assert found["particles"] == 890 and found["threads"] == 1 and found["backend"] == "cpu"
    assert abs(found["critical_speed_rad_s"] - (2 * 9.81 / 0.06) ** 0.5) < 1e-9


@test("the terminal and the log tell the power, over what it was counted, and the energy residual")
def result():
    few = changed(MILL, ("end: 0.06 s", "end: 0.12 s"), ("duration: 50 ms", "duration: 110 ms"),
                  ("filling: 30 %", "filling: 3 %"))
    for name, lifters, expected in (
            ("many", LIFTERS.replace("6", "24").replace("height: 4", "height: 2").replace("top: 4", "top: 2"),
             r"power \S+ \+- \S+ W over 5 lifter passages, (not )?steady \(drift [+-][\d.]+ %\)"),
            ("one", LIFTERS, r"power \S+ W over 1 lifter passage: too few for its error and drift"),
            ("none", "", r"power .* W over 3 sixteenths of a turn, .*steady")):
        scene = write(f"{name}.yaml", changed(few, (LIFTERS, lifters)))
        told = quern("run", scene, "-o", name, "--threads", "1").expect(0).err
        assert re.search(expected, told) and "nan" not in told, told
        log = pathlib.Path(name, "log.txt").read_text()
        for line in (l for l in told.splitlines() if l.startswith(("power ", "energy residual "))):
            assert line in log, line
        assert "energy residual" in log, log


@test("a folder that cannot be made is told, with exit code 3")
def unwritable():
    scene = write("mill.yaml", SHORT)
    run(scene, "/proc/quern/out").expect(IO, "/proc/quern")
    assert not os.path.exists("/proc/quern")


main()
