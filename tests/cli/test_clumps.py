# SPDX-License-Identifier: Apache-2.0
"""Clumps from the scene to the recording: what check says of them, runs, goings on, frames."""
import json
import math
import pathlib

import h5py

from common import MILL, INPUT, UNSTABLE, changed, main, quern, run, state_hash, summary, test, write

ROD = "x,y,z,radius\n-10,0,0,1\n0,3,0,1\n10,0,0,1\n"  # spheres far apart, so that all is known
CLUMPS = changed(
    MILL, ("end: 0.06 s", "end: 800 steps"), ("ids: 1 50 100", "ids: 1 3 100"),
    ("  balls: {material: ball, diameter: 2.5 mm, filling: 30 %, jitter: 50 %}",
     "  grains: {material: ball, shape: tetrahedron, diameter: 2 mm, count: 120}\n"
     "  rods: {material: ball, shape: file, shape_file: rod.csv, diameter: 2 mm, count: 40}\n"
     "  balls: {material: ball, diameter: 2.5 mm, count: 50}"))
COMPACT = ROD.replace("10", "1.5").replace("0,3,", "0,0.3,")


def scene(rod=COMPACT):
    write("rod.csv", rod)
    return write("clumps.yaml", CLUMPS)


@test("check tells mass, moments and diameters of a clump")
def told():
    path = scene()
    report = json.loads(quern("check", path, "--json").expect(0).out)
    assert (report["particles"], report["spheres"]) == (210, 4 * 120 + 3 * 40 + 50)
    grain, rod = report["clumps"]
    mass = 2500 * math.pi / 6 * 0.002 ** 3
    for clump, group, count in (grain, "grains", 4), (rod, "rods", 3):
        assert (clump["group"], clump["spheres"]) == (group, count), clump
        assert abs(clump["mass_kg"] / mass - 1) < 1e-12, clump
        assert clump["bounding_diameter_m"] > clump["diameter_m"] > 0.0019999, clump
        assert clump["error"] < 1e-9
    assert grain["moments_kg_m2"][0] == grain["moments_kg_m2"][2]
    assert 3 * min(rod["moments_kg_m2"]) < max(rod["moments_kg_m2"])
    words = quern("check", path).expect(0).out
    assert "3 spheres, 1.0472e-05 kg" in words and "moments of inertia" in words, words


@test("a clump of spheres apart has the moments of three balls")
def apart():
    write("rod.csv", ROD)
    drum = ("diameter: 60 mm", "diameter: 600 mm"), ("length: 15 mm", "length: 150 mm")
    path = write("clumps.yaml", changed(CLUMPS, *drum))
    rod = json.loads(quern("check", path, "--json").expect(0).out)["clumps"][1]
    r = rod["diameter_m"] / 2 / 3 ** (1 / 3)  # of one of the three
    m = rod["mass_kg"] / 3
    moments = sorted(rod["moments_kg_m2"])
    along, across = 3 * 0.4 * m * r * r, 3 * 0.4 * m * r * r + m * r * r * 200
    assert abs(moments[0] / (along + m * r * r * 6) - 1) < 1e-9, moments
    assert abs(moments[1] / across - 1) < 1e-9, moments
    assert abs(moments[2] / (across + m * r * r * 6) - 1) < 1e-9, moments


@test("a run of clumps that was interrupted goes on to the same bits, on other threads too")
def resumed():
    path = scene()
    run(path, "whole").expect(0)
    run(path, "parts", "--steps", 333).expect(0)
    run(path, "parts", "--resume", "--steps", 500, threads=2).expect(0)
    run(path, "parts", "--resume", threads=3).expect(0)
    assert state_hash("whole") == state_hash("parts")
    log = pathlib.Path("parts/log.txt").read_text()
    assert "going on at step 333" in log and "going on at step 500" in log, log
    assert summary("whole")["particles"] == 210
    assert abs(summary("whole")["energy_residual_relative"]) < 0.01


@test("frames say which spheres belong together, and these move as one")
def frames():
    run(scene(), "out").expect(0)
    last = sorted(pathlib.Path("out/frames").glob("frame_*.hdf"))[-1]
    with h5py.File(last) as file:
        data = {name: file["VTKHDF/PointData"][name][:] for name in ("id", "body", "radius")}
        places = file["VTKHDF/Points"][:]
    own = data["id"] == data["body"]
    assert own.sum() == 210 and len(own) == 650
    for body in data["body"][~own]:
        spheres = places[data["body"] == body]
        assert len(spheres) in (3, 4)
        size = [math.dist(a[:2], b[:2]) for a in spheres for b in spheres]
        assert max(size) < 4e-3, body


@test("what is wrong with a clump's file is told with its place")
def wrong():
    for text, told in (("x,y,z\n0,0,0\n", "'radius'"), ("x,y,z,radius\n0,0,0,0\n", "radius = 0"),
                       ("x,y,z,radius\n" + "0,0,0,1\n" * 65, "at most 64")):
        failed = quern("check", scene(text)).expect(INPUT, "rods.shape_file", told)
        assert "clumps.yaml:20:" in failed.err, failed.err


@test("a guard names the clump")
def guarded():
    path = write("deep.yaml", changed(
        scene().read_text(), ("  grains:", "  one: {material: ball, shape: tetrahedron, diameter: 3 mm, "
                              "at: 0 20 2 mm}\n  two: {material: ball, diameter: 2 mm, at: 0 20 2 mm}\n"
                              "  grains:")))
    run(path, "out").expect(UNSTABLE, "of clump 1)")


main()
