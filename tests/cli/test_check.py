# SPDX-License-Identifier: Apache-2.0
"""`quern check`: the reference document's numbers come out of its mills; what it refuses."""
import json
import math
import pathlib
import re

from common import INPUT, MILL, SOURCE, changed, main, quern, run, test, write

# The document's table of run-time coefficients (its Fig 5.23), with more digits where it has few.
# Its tangential stiffness has the time step of 1e-6 s folded in.
COEFFICIENTS = {
    "glass-glass": {
        "normal_stiffness": 2335488985, "normal_damping": 59.56369,
        "tangential_stiffness": 5696.3146, "tangential_damping": 75.952846,
    },
    "glass-liner": {
        "normal_stiffness": 32147663, "normal_damping": 9.963325,
        "tangential_stiffness": 67.917597, "tangential_damping": 11.824291,
    },
}


def near(found, expected, relative):
    assert abs(found - expected) <= relative * abs(expected), f"{found!r}, not {expected!r}"


def checked(scene):
    done = quern("check", scene, "--json").expect(0)
    return json.loads(done.out), done


@test("the eight coefficients of the document come out of thesis-mill-80 to its printed digits")
def coefficients():
    found, _ = checked(SOURCE / "scenes" / "thesis-mill-80.yaml")
    near(found["dt_s"], 1e-6, 1e-12)
    for pair, values in COEFFICIENTS.items():
        for name, expected in values.items():
            near(found["pairs"][pair][name], expected, 5e-8)
    # and as printed, with six digits
    near(found["pairs"]["glass-glass"]["normal_stiffness"], 2335490000, 1e-6)
    near(found["pairs"]["glass-liner"]["normal_stiffness"], 32147700.0, 2e-6)


@test("the document's mills have its speeds, its particles and its time step")
def mills():
    for percent, speed in ((60, 4.85), (70, None), (80, 6.46991)):
        found, done = checked(SOURCE / "scenes" / f"thesis-mill-{percent}.yaml")
        assert found["particles"] == 253125
        near(found["critical_speed_rad_s"], 8.087, 1e-4)
        near(found["speed_rad_s"] / found["critical_speed_rad_s"], percent / 100, 1e-3)
        if speed:
            near(found["speed_rad_s"], speed, 1e-3)
        near(found["rayleigh_time_s"], 1.60e-6, 5e-3)
        near(found["rayleigh_fraction"], 0.63, 2e-2)
        assert "Rayleigh" in done.err, "no warning of a step above 0.3 of the Rayleigh time"
        near(found["mass_kg"], 253125 * 3.534292e-5, 1e-6)
        near(found["time_s"] * found["speed_rad_s"] / 6.283185307179586, 4, 1e-6)


@test("a size distribution becomes a table of diameters, numbers and shares of mass")
def sizes():
    scene = write("sizes.yaml", changed(MILL, (
        "diameter: 2.5 mm, filling: 30 %",
        "mass: 20 g, distribution: {kind: rosin-rammler, d63: 3 mm, n: 2, min: 1.5 mm, max: 4 mm, classes: 5}")))
    found, _ = checked(scene)
    rows = found["sizes"]["balls"]
    assert len(rows) == 5 and sum(row["number"] for row in rows) == found["particles"]
    mass = [row["number"] * row["diameter_m"] ** 3 * 2500 * 3.141592653589793 / 6 for row in rows]
    near(sum(mass), 20e-3, 5e-4)
    near(found["mass_kg"], sum(mass), 1e-9)
    below = 0.0
    for k, row in enumerate(rows):
        near(row["mass_share"], mass[k] / sum(mass), 1e-9)
        below += row["mass_share"]
        passing = [1 - math.exp(-(d / 3e-3) ** 2) for d in (1.5e-3, 1.5e-3 * (4 / 1.5) ** ((k + 1) / 5), 4e-3)]
        assert abs(below - (passing[1] - passing[0]) / (passing[2] - passing[0])) < 5e-3
    text = quern("check", scene).expect(0).out
    assert "sizes of balls" in text and f"{rows[0]['number']}" in text
    assert "sizes of" not in quern("check", write("one.yaml", MILL)).expect(0).out


@test("the numbers of a scene are consistent, and those for people are the same")
def numbers():
    scene = write("mill.yaml", MILL)
    found, done = checked(scene)
    assert done.err == ""
    near(found["steps"] * found["dt_s"], found["time_s"], 1e-3)
    near(found["dt_s"] / found["rayleigh_time_s"], found["rayleigh_fraction"], 1e-9)
    near(found["critical_speed_rad_s"], (2 * 9.81 / 0.06) ** 0.5, 1e-9)
    near(found["speed_rad_s"], 0.7 * found["critical_speed_rad_s"], 1e-9)
    near(found["filling"], 0.30, 0.01)
    for key in ("wall_s", "memory_bytes", "disk_bytes"):
        assert found[key] > 0, key
    assert list(found["pairs"]) == ["ball-ball", "ball-liner"]
    report = quern("check", scene).expect(0).out
    for text in ("890", f"{found['critical_speed_rad_s']:.6g} rad/s", "ball-liner",
                 f"{found['pairs']['ball-ball']['normal_stiffness']:.8g}"):
        assert text in report, text
    assert sorted(p.name for p in pathlib.Path(".").iterdir()) == ["mill.yaml"], "files are written"


def size_of(folder):
    return sum(p.stat().st_size for p in pathlib.Path(folder).rglob("*") if p.is_file())


@test("the forecast of disk use is what runs write, within 30 %")
def disk():
    drop = (SOURCE / "scenes" / "drop.yaml").read_text()
    short = changed(MILL, ("end: 0.06 s", "end: 0.02 s"), ("duration: 50 ms", "duration: 15 ms"))
    for name, text in (
            ("mill", short),
            ("frames", changed(short, ("frames: 5 ms", "frames: 0.2 ms"))),
            ("drop", changed(drop, ("end: 0.2 s", "end: 0.1 s"))),
            ("untraced", "\n".join(l for l in drop.splitlines() if "traces:" not in l)),
            ("overlap", (SOURCE / "scenes" / "overlap.yaml").read_text())):
        scene = write(f"{name}.yaml", text)
        found, _ = checked(scene)
        run(scene, name, threads=2).expect(0)
        near(found["disk_bytes"], size_of(name), 0.3)


@test("sizes come in a unit that fits, and a tiny run takes less than a second")
def sizes():
    scene = write("mill.yaml", MILL)
    report = quern("check", scene).expect(0).out
    for pattern in (r"memory +about \d+ MB", r"disk +about [\d.]+ MB in out/mill"):
        assert re.search(pattern, report), report
    few = changed(MILL, ("end: 0.06 s", "end: 10 steps"), ("frames: 5 ms", "frames: none"),
                  ("  fields: {every: 10 steps, start: 100 steps, duration: 50 ms, cells: 1 2 4}\n", ""))
    report = quern("check", write("few.yaml", few)).expect(0).out
    for pattern in (r"disk +about \d+ kB in", r"wall time +less than a second"):
        assert re.search(pattern, report), report


@test("fields that are sampled after the end of the run, or beyond it, are a warning")
def window():
    scene = write("mill.yaml", MILL)
    assert quern("check", scene).expect(0).err == ""
    write("mill.yaml", changed(MILL, ("start: 100 steps", "start: 0.07 s")))
    quern("check", scene).expect(
        0, "warning: measure.fields starts at 0.07 s, after the end of the run (0.06 s)")
    write("mill.yaml", changed(MILL, ("start: 100 steps", "start: 0.02 s")))
    quern("check", scene).expect(0, "warning: measure.fields lasts until 0.07 s, but the run ends at 0.06 s")
    write("mill.yaml", changed(MILL, ("start: 100 steps", "start: 0 s"), ("50 ms", "1 rev")))
    found, done = checked(scene)
    turn = 2 * math.pi / found["speed_rad_s"]
    assert f"measure.fields lasts until {turn:.4g} s" in done.err, done.err


@test("an overlap to expect that is large is told, one that would stop the run is a warning")
def soft():
    for young, usual, stops in (("2 GPa", False, False), ("20 MPa", True, False), ("20 kPa", True, True)):
        done = quern("check", write("mill.yaml", changed(MILL, ("20 MPa", young)))).expect(0)
        assert ("(usual is below 5 %)" in done.out) == usual, (young, done.out)
        assert ("above 30 % the run stops" in done.err) == stops, (young, done.err)


@test("a drum above its critical speed is a warning")
def centrifuge():
    assert quern("check", write("mill.yaml", changed(MILL, ("70 %crit", "100 %crit")))).expect(0).err == ""
    for speed in ("170", "-170"):
        quern("check", write("mill.yaml", changed(MILL, ("70 %crit", f"{speed} %crit")))).expect(
            0, "warning: the drum turns at 170 %critical")


@test("a traced particle that there is none of is a warning")
def traced():
    done = quern("check", write("mill.yaml", changed(MILL, ("ids: 1 50 100", "ids: 1 890 900")))).expect(0)
    assert done.err == "warning: measure.traces.ids: there is no particle 900; the last is 890\n", done.err


@test("a restitution whose dashpot is too stiff for the time step is a warning, with a step that is not")
def dashpot():
    scene = write("mill.yaml", changed(MILL, ("restitution: 0.7", "restitution: 0.01")))
    found, done = checked(scene)
    assert done.err.count("warning") == 1, done.err
    for part in ("contacts.ball-ball.restitution = 0.01", "too stiff", "several percent"):
        assert part in done.err, done.err
    step = re.search(r"time.step: ([\d.]+) us", done.err)[1]
    assert 0.2 < float(step) * 1e-6 / found["dt_s"] < 0.5
    write("mill.yaml", changed(scene.read_text(), ("step: auto", f"step: {step} us")))
    assert checked(scene)[1].err == ""
    write("mill.yaml", changed(MILL, ("restitution: 0.7", "restitution: 0.002")))
    assert "may explode" in checked(scene)[1].err
    write("mill.yaml", changed(MILL, ("restitution: 0.7", "restitution: 0.1")))
    assert checked(scene)[1].err == ""


@test("the impact that a time step must resolve is head-on, and a turning mesh counts")
def impact():
    scene = write("mill.yaml", MILL)
    found, _ = checked(scene)
    shell = 0.03 * found["speed_rad_s"]
    near(found["impact_speed_m_s"], (shell**2 + 2 * 9.81 * 0.06) ** 0.5 + shell, 1e-9)
    write("blade.msh", "3 1\n0 0 0\n60 0 0\n0 5 5\n1 2 3\n")
    blade = "walls: {blade: {shape: mesh, material: liner, file: blade.msh, turning: yes}}\n"
    write("mill.yaml", changed(MILL, ("ends: periodic", "ends: fixed")) + blade)
    edge = 2 * shell
    near(checked(scene)[0]["impact_speed_m_s"], (edge**2 + 2 * 9.81 * 0.12) ** 0.5 + edge, 1e-9)
    two = (SOURCE / "scenes" / "two-spheres.yaml").read_text()
    speed = checked(write("two.yaml", two))[0]["impact_speed_m_s"]
    assert "fixed: yes" in two, "one is fixed"
    both = checked(write("both.yaml", changed(two, (", fixed: yes", ""))))[0]["impact_speed_m_s"]
    near(both, 2 * speed, 1e-9)


@test("a scene with errors, a missing one and bad options have exit code 2")
def errors():
    wrong = write("mill.yaml", changed(MILL, ("15 mm", "15")))
    done = quern("check", wrong, "--json").expect(INPUT, "mill.yaml:13:11:")
    assert done.out == "", done.out
    quern("check").expect(INPUT, "which scene?", "usage: quern check")
    quern("check", wrong, "two").expect(INPUT, "'two' is one word too many", "usage: quern check")
    quern("check", wrong, "--jason").expect(INPUT, "'--jason' is not an option", "--json")


main()
