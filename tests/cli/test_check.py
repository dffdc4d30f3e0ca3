# SPDX-License-Identifier: Apache-2.0
"""`quern check`: the reference document's numbers come out of its mills; what it refuses."""
import json
import pathlib

from common import INPUT, MILL, SOURCE, changed, main, quern, test, write

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


@test("a scene with errors, a missing one and bad options have exit code 2")
def errors():
    wrong = write("mill.yaml", changed(MILL, ("15 mm", "15")))
    done = quern("check", wrong, "--json").expect(INPUT, "mill.yaml:13:11:")
    assert done.out == "", done.out
    quern("check").expect(INPUT, "which scene?", "usage: quern check")
    quern("check", wrong, "two").expect(INPUT, "'two' is one word too many", "usage: quern check")
    quern("check", wrong, "--jason").expect(INPUT, "'--jason' is not an option", "--json")


main()
