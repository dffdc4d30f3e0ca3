# SPDX-License-Identifier: Apache-2.0
"""`quern info` and `quern plot` on the recordings of a short run."""
import importlib.util
import pathlib
import shutil

from common import (INPUT, IO, MILL, Skip, changed, checkpoints, main, quern, run, start, summary,
                    test, tree, wait, wait_until, write)

SCENE = changed(MILL, ("end: 0.06 s", "end: 1800 steps"))
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1)) + """\
f 1 2 4
f 1 4 3
"""


@test("info tells what is in a run folder, a checkpoint, a frame, fields and series")
def info():
    scene = write("mill.yaml", SCENE)
    run(scene, "out").expect(0)
    before = tree(".")
    text = quern("info", "out").expect(0).out
    for part in ("checkpoint at step 1800", "--resume", "series.csv", "state_hash", "particles"):
        assert part in text, text
    text = quern("info", checkpoints("out")[-1]).expect(0).out
    for part in ("1800", "particles/position", "890", "Small mill"):
        assert part in text, text
    text = quern("info", "out/frames/frame_000001.hdf").expect(0).out
    for part in ("radius", "velocity", "890"):
        assert part in text, text
    text = quern("info", "out/fields.h5").expect(0).out
    for part in ("grid_0", "voxels of 1.25 mm", "porosity"):
        assert part in text, text
    assert "kinetic" in quern("info", "out/series.h5").expect(0).out
    assert tree(".") == before, "info has written something"


@test("info of a run has a row for each part of the walls: name, power, force")
def parts():
    run(write("mill.yaml", SCENE), "out").expect(0)
    text = quern("info", "out").expect(0).out
    rows = {line.split()[0]: line.split()[1:] for line in text.splitlines() if line.startswith("    ")}
    walls = summary("out")["walls"]
    assert len(walls) == 7 and max(abs(wall["mean_power_w"]) for wall in walls.values()) > 0
    for name, wall in walls.items():
        expected = [wall[f"mean_{key}"] for key in ("power_w", "force_x_n", "force_y_n", "force_z_n")]
        assert rows[name] == [f"{number:.4g}" for number in expected], (name, text)
    assert "finnie" not in text and "power_parts_w" not in text, text
    assert text.index("lifter_06") < text.index("state_hash"), text


@test("info tells what is in a mesh")
def mesh():
    text = quern("info", write("plate.obj", CUBE)).expect(0).out
    assert "triangles    2" in text, text


@test("info tells what it can't read")
def not_readable():
    pathlib.Path("empty").mkdir()
    quern("info", "empty").expect(INPUT, "empty", "log.txt")
    quern("info", "nothing").expect(IO, "nothing")
    junk = quern("info", write("junk.h5", b"\x89HDF\r\n\x1a\n" + bytes(range(256))))
    assert junk.code in (INPUT, IO) and "junk.h5" in junk.err, junk.err
    quern("info").expect(INPUT, "usage: quern info")
    quern("info", "a", "b").expect(INPUT, "usage: quern info")


def need_modules():
    for module in ("h5py", "matplotlib", "numpy"):
        if not importlib.util.find_spec(module):
            raise Skip(f"Python has no {module}")


@test("plot draws pictures from a run, and run does so at its end unless told not to")
def plot():
    need_modules()
    scene = write("mill.yaml", changed(SCENE, ("pictures: no", "pictures: yes")))
    run(scene, "out", "--no-pictures").expect(0)
    assert not list(pathlib.Path("out").rglob("*.png"))
    quern("plot", "out").expect(0)
    pictures = sorted(p.name for p in pathlib.Path("out/pictures").glob("*.png"))
    assert len(pictures) >= 6, pictures
    for path in pathlib.Path("out/pictures").glob("*.png"):
        assert path.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n" and path.stat().st_size > 5000, path
    shutil.rmtree("out/pictures")
    run(scene, "out", "--resume").expect(0)
    assert sorted(p.name for p in pathlib.Path("out/pictures").glob("*.png")) == pictures


def plotted(folder):
    """Names of the pictures, and what was said."""
    text = quern("plot", folder, "--dpi", "40").expect(0).out
    return {p.name for p in (pathlib.Path(folder) / "pictures").glob("*.png")}, text


@test("plot of a run that was killed draws what there is and tells what is missing and why")
def plot_killed():
    need_modules()
    folder = pathlib.Path("killed")
    child = start(write("mill.yaml", MILL), folder)
    wait_until(lambda: (folder / "frames" / "frame_000002.hdf").exists())
    child.kill()
    wait(child)
    assert not (folder / "summary.json").exists() and not (folder / "fields.h5").exists()
    pictures, text = plotted(folder)
    assert pictures >= {"particles.png", "energy.png", "power.png", "paths.png"}, pictures
    assert "not drawn: porosity maps, velocity quivers, component maps, charge around the shell " \
           "(no fields.h5" in text, text


@test("plot of a run with one frame, one row and no fields draws the particles alone")
def plot_one_frame():
    need_modules()
    run(write("mill.yaml", MILL), "out", "--steps", 0).expect(0)
    pictures, text = plotted("out")
    assert pictures == {"particles.png"}, pictures
    for reason in ("no fields.h5", "single row", "single moment", "fewer than three rows"):
        assert reason in text, text


@test("too few samples give neither maps nor a shoulder, and the summary says why")
def plot_few_samples():
    need_modules()
    run(write("mill.yaml", MILL), "out", "--steps", 300).expect(0)
    found = summary("out")
    assert found["shoulder_deg"] is None and found["toe_deg"] is None
    assert found["solidity_bulk"] is None, found
    assert "samples that bulk solidity, shoulder and toe need" in found["charge_note"], found
    assert found["charge_note"] in pathlib.Path("out/log.txt").read_text()
    pictures, text = plotted("out")
    assert "particles.png" in pictures and "ring.png" not in pictures, pictures
    assert "samples that a mean needs)" in text, text


@test("plot tells what is not a run's folder")
def plot_nothing():
    pathlib.Path("empty").mkdir()
    for what in ("empty", "nothing"):
        done = quern("plot", what)
        assert done.code != 0 and what in done.err, done.err
        assert "Traceback" not in done.err, done.err


main()
