# SPDX-License-Identifier: Apache-2.0
"""Meshes as walls: what is odd about them is told, how they move is recorded."""
import csv

from common import main, quern, run, summary, test, write

MESH = """\
8 5
-20 0 -20
20 0 -20
20 0 20
-20 0 20
-20 0 0
20 0.000001 20
60 0 20
60 0 60
1 2 3
1 6 4
3 4 1
1 4 5
6 7 8
"""
SCENE = """\
format: quern-scene/1
time: {end: 0.05 s}
materials:
  glass: {young: 5 MPa, poisson: 0.23, density: 2500 kg/m3}
contacts: {glass-glass: {friction: 0.2, restitution: 0.5}}
particles:
  ball: {material: glass, diameter: 3 mm, at: 0 1.5 0 mm}
walls:
  floor:
    shape: mesh
    file: floor.txt
    material: glass
    motion: {kind: oscillate, direction: 0 1 0, amplitude: 1 mm, frequency: 10 Hz, phase: 90 deg}
output: {frames: 10 ms, pictures: no}
"""
TOLD = ("1 vertex lies a hair's breadth from another: joined with it; it is vertex 6 at 20 1e-06 20",
        "1 triangle has no area: left out; it is triangle 4",
        "1 triangle is given more than once and used once; it is triangle 3",
        "7 edges belong to one triangle only")


@test("check, run and info tell what is odd about a mesh, and where")
def odd():
    write("floor.txt", MESH)
    scene = write("floor.yaml", SCENE)
    told = quern("check", scene).expect(0).err
    run(scene, "out").expect(0)
    log = open("out/log.txt", encoding="utf-8").read()
    info = quern("info", "floor.txt").expect(0).out
    for part in TOLD:
        assert "note: mesh 'floor': " + part in told, told
        assert "note: mesh 'floor': " + part in log, log
        assert part in info, info


@test("a moving mesh has its force, power and wear in the series, the summary and the frames")
def moving():
    import h5py
    write("floor.txt", MESH)
    run(write("floor.yaml", SCENE), "out").expect(0)
    rows = list(csv.DictReader(open("out/series.csv", encoding="utf-8")))
    weight = 2500 * 3.14159265 / 6 * 0.003 ** 3 * 9.81
    force = [float(row["force_y_floor_n"]) for row in rows[5:]]
    assert min(force) < 0.9 * weight and max(force) < 3 * weight and max(force) > 0.2 * weight, force
    total = sum(float(row["power_floor_w"]) * 1e-3 for row in rows[1:-1])
    work = float(rows[-2]["work_floor_j"])
    assert abs(total - work) < 0.02 * abs(work), (total, work)
    floor = summary("out")["walls"]["floor"]
    assert floor["normal_work_j"] > 0 and floor["mean_force_y_n"] > 0, floor
    low = []
    for frame in range(6):
        with h5py.File(f"out/frames/liner_{frame:06}.hdf") as file:
            low.append(file["VTKHDF/Points"][:, 1].min())
            wear = file["VTKHDF/CellData/normal_work"][:]
    assert abs(low[5] - low[0] + 0.002) < 1e-5, low  # half a period: down by twice the amplitude
    assert wear.max() > 0 and len(wear) == 3, wear


main()
