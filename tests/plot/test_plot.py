# SPDX-License-Identifier: Apache-2.0
"""Tests of the plotting script on invented run folders (fake_run.py).

    /usr/bin/python3 tests/plot/test_plot.py [build/quern] [NAME]

With the path of the program, `quern plot` itself is tried too; with a name, only tests like it.
"""
import contextlib
import filecmp
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace

HERE = os.path.dirname(os.path.abspath(__file__))
PLOT = os.path.join(HERE, "..", "..", "plot")
PROGRAM = next((os.path.abspath(word) for word in sys.argv[1:] if os.path.isfile(word)), None)
sys.dont_write_bytecode = True
sys.path[:0] = [HERE, PLOT]

import fake_run  # noqa: E402
import h5py  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.axis import Axis  # noqa: E402
from matplotlib.text import Text  # noqa: E402

from figures import energy, figure_list, liner, paths, power, ring, scenery, traces  # noqa: E402
from figures.folder import NotRun, Run  # noqa: E402
from figures.ledger import STORED, Ledger  # noqa: E402
from figures.particles import cut_circles  # noqa: E402
from figures.style import Gallery, colour_limits, round_limit  # noqa: E402
from figures.table import NotRecorded, read_table  # noqa: E402


SCENE = """\
format: quern-scene/1
time: {end: 40 steps, step: 10 us}
materials: {glass: {young: 64 MPa, poisson: 0.23, density: 2500 kg/m3}}
contacts: {glass-glass: {law: hertz-mindlin, friction: 0.2, restitution: 0.6}}
walls:
  room: {shape: box, material: glass, low: -50 -50 -50 mm, high: 50 50 50 mm}
  ramp: {shape: plane, material: glass, point: -40 0 0 mm, normal: 3 4 0}
particles:
  ball: {material: glass, diameter: 20 mm, at: 20 -20 0 mm}
  anvil: {material: glass, diameter: 4 mm, at: 0 20 0 mm, fixed: yes}
measure: {traces: {ids: 1, every: 1 steps}}
output: {frames: 20 steps, pictures: no}
"""


MOVING = """\
walls:
  floor:
    shape: plane
    point: 0 0 0 m
    normal: 0 1 0
  lid:
    shape: plane
    point: 0 0.1 0 m
    normal: 0 -1 0
    motion:
      kind: translate
      direction: 0 2 0
      schedule:
        - {duration: 1 s, from: 0 m/s, to: 0 m/s}
        - {duration: 1 s, from: 0 m/s, to: 0.5 m/s}
        - {at: 0.5 m/s}
  net:
    shape: mesh
    motion:
      kind: translate
      direction: 0 1 0
      schedule:
        - {at: 9 m/s}
  flap:
    shape: plane
    point: 2 0 0 m
    normal: 1 0 0
    motion:
      kind: rotate
      axis: 0 0 1
      through: 1 0 0 m
      schedule:
        - {at: 0.523598775598 rad/s}
  side:
    shape: plane
    point: 0 0 0 m
    normal: 1 0 0
    motion:
      kind: oscillate
      direction: 1 0 0
      amplitude: 0.01 m
      frequency: 0.33333333333333 Hz
      phase: 0.52359877559829882 rad
      settle: 2 s
particles:
"""


def draw_all(folder, pictures):
    """Names of the pictures drawn, and of the figures skipped."""
    run, gallery, skipped = Run(folder), Gallery(pictures, dpi=30), []
    for name, draw in figure_list():
        try:
            draw(run, gallery)
        except NotRecorded:
            skipped.append(name)
    return [os.path.basename(path) for path in gallery.written], skipped


class Proof:
    """In place of a gallery: keeps, by name, how far words reach beyond the page (inches), the last
    legend, and the titles."""

    def __init__(self):
        self.over, self.legends, self.titles = {}, {}, {}

    def save(self, figure, name):
        figure.draw_without_rendering()
        pen, page = figure.canvas.get_renderer(), figure.get_size_inches()
        words = [text for text in figure.texts if text.get_text()]
        for axes in figure.axes:
            if axes.get_visible():
                words += [part for part in axes.get_children() if isinstance(part, (Axis, Text))]
            legend = axes.get_legend()
            if legend:
                words.append(legend)
                self.legends[name] = [text.get_text() for text in (legend.get_title(),
                                                                   *legend.get_texts())]
        self.titles[name] = [axes.get_title(loc) for axes in figure.axes for loc in ("left", "center",
                                                                                     "right")]
        boxes = [box for box in (one.get_tightbbox(pen) for one in words) if box and box.width > 0]
        ends = np.array([box.extents for box in boxes]) / figure.dpi
        self.over[name] = max(-ends[:, :2].min(), *(ends[:, 2:].max(axis=0) - page))
        plt.close(figure)


def script(*arguments, python=("/usr/bin/python3",)):
    return subprocess.run([*python, os.path.join(PLOT, "quern_plot.py"), *arguments],
                          capture_output=True, text=True, check=False)


class Folders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = tempfile.mkdtemp(prefix="quern-plot-")
        cls.mill, cls.drop = os.path.join(cls.root, "mill"), os.path.join(cls.root, "drop")
        fake_run.make_mill(cls.mill, cells=(4, 8))
        fake_run.make_drop(cls.drop)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def copy_of(self, folder):
        copy = tempfile.mkdtemp(dir=self.root)
        return shutil.copytree(folder, copy, dirs_exist_ok=True)

    def test_a_mill_gives_every_picture_it_recorded(self):
        written, skipped = draw_all(self.mill, os.path.join(self.mill, "pictures"))
        self.assertEqual(written, [
            "porosity_4R.png", "porosity_8R.png", "porosity.png", "velocity_4R.png",
            "velocity_8R.png", "velocity.png", "velocity_components.png", "particles.png",
            "power.png", "energy.png", "ring.png"])
        self.assertEqual(skipped, ["paths", "traces", "contact forces"])

    def test_a_drop_gives_its_traces_and_says_what_is_skipped(self):
        result = script(self.drop, "--dpi", "30", "-o", os.path.join(self.root, "drop-pictures"))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("traces.png", result.stdout)
        self.assertIn("contact_forces.png", result.stdout)
        self.assertIn("not drawn: particles (no frames/frame_*.hdf)", result.stdout)
        self.assertIn("charge around the shell (no fields.h5", result.stdout)

    def test_the_same_recordings_give_the_same_bytes(self):
        for folder in (self.mill, self.drop):
            first, second = tempfile.mkdtemp(dir=self.root), tempfile.mkdtemp(dir=self.root)
            names, _ = draw_all(folder, first)
            draw_all(folder, second)
            for name in names:
                self.assertTrue(filecmp.cmp(os.path.join(first, name), os.path.join(second, name),
                                            shallow=False), name)

    def test_nothing_runs_off_the_page(self):
        unsteady = self.copy_of(self.mill)
        with open(os.path.join(unsteady, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"speed_rad_s": fake_run.SPEED, "power_torque_w": 1.4032, "steady": False,
                       "power_stderr_w": 0.031, "power_drift_w": -17.3}, file)
        slow = self.copy_of(self.mill)
        with h5py.File(os.path.join(slow, "frames", "frame_000042.hdf"), "a") as file:
            speed = file["VTKHDF/PointData/speed"]
            speed[:] = 0.014 * speed[:] / np.max(speed[:])
        figures = dict(figure_list())
        for folder, names in ((self.mill, figures), (unsteady, ["power"]), (slow, ["particles"]),
                              (self.drop, figures)):
            proof = Proof()
            for name in names:
                with contextlib.suppress(NotRecorded):
                    figures[name](Run(folder), proof)
            over = {name: inches for name, inches in proof.over.items() if inches > 0.005}
            with self.subTest(folder):
                self.assertGreater(len(proof.over), 0)
                self.assertEqual(over, {})

    def test_the_legend_of_the_power_tells_what_is_drawn(self):
        folder = self.copy_of(self.mill)
        for name, told in (("", "grey: window of the mean"), ("summary.json", "window of the fields"),
                           ("fields.h5", "pale: each row")):
            if name:
                os.remove(os.path.join(folder, name))
            proof = Proof()
            power.power(Run(folder), proof)
            self.assertTrue(proof.legends["power"][0].endswith(told), proof.legends["power"])
            self.assertEqual(len(proof.legends["power"]), 3 + (name == ""))

    def test_any_missing_part_costs_only_its_own_pictures(self):
        lost = {"fields.h5": ("porosity maps", "velocity quivers", "component maps",
                              "charge around the shell"),
                "series.csv": ("power", "energy"), "summary.json": (), "frames": ("particles",)}
        for part, figures in lost.items():
            folder = self.copy_of(self.mill)
            path = os.path.join(folder, part)
            shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
            _, skipped = draw_all(folder, os.path.join(folder, "new"))
            self.assertEqual(set(skipped) - {"paths", "traces", "contact forces"}, set(figures), part)

    def test_maps_are_drawn_only_from_enough_samples(self):
        folder = self.copy_of(self.mill)
        with h5py.File(os.path.join(folder, "fields.h5"), "a") as file:
            file.attrs["samples_least"] = 401
        for name, draw in figure_list():
            if name in ("porosity maps", "velocity quivers", "component maps",
                        "charge around the shell"):
                with self.assertRaisesRegex(NotRecorded, "400 of the 401 samples"):
                    draw(Run(folder), None)
        _, skipped = draw_all(folder, os.path.join(folder, "new"))
        self.assertNotIn("power", skipped)
        with h5py.File(os.path.join(folder, "fields.h5"), "a") as file:
            del file.attrs["samples_least"]
        self.assertEqual(len(Run(folder).means), 2)

    def test_the_tips_of_the_lifters_run_on_a_circle(self):
        half = np.arcsin(fake_run.HEIGHT / 2 / fake_run.DRUM)  # the middle of a flat top is nearest
        tips = (fake_run.DRUM - fake_run.HEIGHT) * np.cos(half)
        self.assertAlmostEqual(Run(self.mill).lifter_tips, tips, 7)
        self.assertAlmostEqual(Run(self.mill).liner.drum_radius(), fake_run.DRUM, 6)
        self.assertIsNone(Run(self.drop).lifter_tips)
        smooth = Run(self.mill).liner
        radius = np.hypot(*smooth.profile.reshape(-1, 2).T).reshape(-1, 2).min(axis=1)
        smooth.profile = smooth.profile[radius > fake_run.DRUM * 0.9999]
        self.assertIsNone(smooth.tips())

    def test_planes_and_fixed_balls_come_from_the_scene(self):
        scene = Run(self.drop).scene
        self.assertEqual([plane.name for plane in scene.planes], ["floor", "my box_low"])
        np.testing.assert_allclose(scene.planes[0].normal, (0, 1, 0))
        np.testing.assert_allclose(scene.planes[1].point, (0.5, 0, 1))
        self.assertEqual(scene.radius, 0.0015)
        self.assertEqual(len(scene.fixed), 1)
        np.testing.assert_allclose(scene.fixed[0].centre, (0.1, 0, 0))
        self.assertEqual(Run(self.mill).scene, ([], [], None))

    def test_paths_leave_room_for_balls_and_what_stands_around(self):
        low, high = paths.window(Run(self.drop), np.zeros(2), np.array((0.0015, 0.1)), 0.0)
        np.testing.assert_allclose((low[1], high[1]), (-0.00418, 0.103))
        self.assertAlmostEqual(low[0], -0.003)
        self.assertGreater(high[0], 0.1 + 0.0015)

    def test_solid_ground_is_drawn_behind_a_plane(self):
        figure, (low, high) = plt.subplots(2)
        for axes, z in ((low, 0.0), (high, 0.97)):  # m
            axes.set(xlim=(-200, 700), ylim=(-100, 400))
            scenery.draw_scenery(axes, Run(self.drop).scene, z)
        floor, _, anvil = (patch for patch in low.patches if patch.get_fill())
        _, side = high.patches
        for patch, solid, free in ((floor, (0, -1), (0, 1)), (side, (461, 0), (459, 0)),
                                   (anvil, (101, 0), (102, 0))):
            inside = patch.get_path().transformed(patch.get_patch_transform()).contains_point
            self.assertTrue(inside(solid) and not inside(free))
        plt.close(figure)

    def test_files_cut_off_while_being_written_are_survived(self):
        folder = self.copy_of(self.mill)
        with open(os.path.join(folder, "frames", "frame_000043.hdf"), "wb") as file:
            file.write(b"\x89HDF")
        os.truncate(os.path.join(folder, "fields.h5"), 1000)
        with open(os.path.join(folder, "series.csv"), "a", encoding="utf-8") as file:
            file.write("90000,4.")
        written, skipped = draw_all(folder, os.path.join(folder, "new"))
        self.assertIn("particles.png", written)
        self.assertIn("power.png", written)
        self.assertIn("porosity maps", skipped)

    def test_what_is_not_a_run_folder_ends_with_code_2(self):
        empty = tempfile.mkdtemp(dir=self.root)
        for folder in (empty, os.path.join(self.root, "nowhere")):
            result = script(folder)
            self.assertEqual(result.returncode, 2)
            self.assertIn(folder, result.stderr)
            self.assertRaises(NotRun, Run, folder)
        self.assertEqual(os.listdir(empty), [])

    def test_a_missing_module_is_told_in_one_line(self):
        result = script(self.drop, python=("/usr/bin/python3", "-I", "-S"))
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertIn("apt install", result.stderr)

    def test_a_recording_that_makes_no_sense_ends_with_code_3(self):
        folder = self.copy_of(self.drop)
        with open(os.path.join(folder, "traces.csv"), "w", encoding="utf-8") as file:
            file.write("step,time_s\n1,2\n2,3\n")
        result = script(folder, "--dpi", "30")
        self.assertEqual(result.returncode, 3)
        self.assertIn("traces: KeyError", result.stderr)
        self.assertIn("contact_forces.png", result.stdout)

    def test_nothing_is_shown_outside_the_drum(self):
        folder = self.copy_of(self.mill)
        with h5py.File(os.path.join(folder, "fields.h5"), "a") as file:
            for name in ("count", "solidity", "velocity_x"):
                values = file["grid_0"][name]
                values[...] = np.where(file["grid_0/open_volume_m3"][:] == 0, 7, values[:])
        grid = Run(folder).grids[0]
        rho = np.hypot(*np.meshgrid(*grid.centres()))
        outside, inside = rho > fake_run.DRUM + grid.cell, rho < fake_run.DRUM - grid.cell
        for values in (grid.porosity(), grid.motion("velocity_x")):
            self.assertTrue(np.all(np.isnan(values[outside])))
        self.assertTrue(np.all(np.isfinite(grid.porosity()[inside])))

    def test_layers_are_averaged_by_open_volume_and_by_count(self):
        folder = self.copy_of(self.mill)
        fake_run.write_fields(folder, (8,), 2, np.random.default_rng(2))
        with h5py.File(os.path.join(folder, "fields.h5"), "a") as file:
            group = file["grid_0"]
            group["open_volume_m3"][:, 19, 9] = (1e-6, 3e-6)
            group["solidity"][:, 19, 9] = (0.4, 0.6)
            group["count"][:, 19, 9] = (30, 10)
            group["speed"][:, 19, 9] = (1.0, 2.0)
        grid = Run(folder).grids[0]
        self.assertAlmostEqual(grid.porosity()[19, 9], 1 - (0.4 + 3 * 0.6) / 4)
        self.assertAlmostEqual(grid.motion("speed")[19, 9], (3 * 1 + 2) / 4)

    def test_the_energy_channels_of_the_series_are_all_found(self):
        ledger = Ledger(Run(self.mill).series)
        left = ledger.work() - (ledger.stored() - ledger.stored()[0]) - ledger.losses()
        self.assertGreater(ledger.turnover(), 1)
        self.assertLess(np.ptp(left), 1e-9 * ledger.turnover())


@unittest.skipUnless(PROGRAM, "no path of the program given")
class Program(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp(prefix="quern-plot-")
        self.drop = os.path.join(self.root, "drop")
        fake_run.make_drop(self.drop)

    def tearDown(self):
        shutil.rmtree(self.root)

    def plot(self, program, *arguments):
        return subprocess.run([program, "plot", *arguments], capture_output=True, text=True,
                              check=False)

    def place(self, folder):
        os.makedirs(os.path.join(self.root, folder))
        return shutil.copy(PROGRAM, os.path.join(self.root, folder, "quern"))

    def test_the_program_draws_and_passes_the_exit_code_on(self):
        done = self.plot(PROGRAM, self.drop, "--dpi", "30")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.exists(os.path.join(self.drop, "pictures", "traces.png")))
        self.assertEqual(self.plot(PROGRAM, "/nowhere").returncode, 2)

    def test_planes_boxes_and_fixed_balls_are_found_in_what_the_program_writes(self):
        scene, folder = os.path.join(self.root, "scene.yaml"), os.path.join(self.root, "out")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(SCENE)
        subprocess.run([PROGRAM, "run", scene, "-o", folder, "--quiet"], check=True)
        found = Run(folder).scene
        self.assertEqual(len(found.planes), 7)
        np.testing.assert_allclose(found.planes[-1].normal, (0.6, 0.8, 0))
        np.testing.assert_allclose(found.fixed[0].centre, (0, 0.02, 0))
        self.assertEqual((len(found.fixed), found.fixed[0].radius, found.radius),
                         (1, 0.002, None))
        done = self.plot(PROGRAM, folder, "--dpi", "30")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("particles.png", "paths.png", "traces.png"):
            self.assertIn(name, done.stdout)
        run = Run(folder)
        np.testing.assert_array_equal(run.frame["id"], (1,))  # the anvil is fixed
        self.assertAlmostEqual(run.section, 0.0)
        self.assertLess(run.extent()[0][1], -0.05)  # the floor is seen

    def test_an_installed_program_finds_the_script_in_its_own_prefix(self):
        program = self.place("prefix/bin")
        shutil.copytree(PLOT, os.path.join(self.root, "prefix", "share", "quern"))
        done = self.plot(program, self.drop, "--dpi", "30", "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_missing_script_is_told_in_one_line(self):
        done = self.plot(self.place("alone/bin"), self.drop)
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stderr.count("\n"), 1)


class Parts(unittest.TestCase):
    def test_the_running_mean_of_a_steady_rate_is_that_rate(self):
        time = np.sort(np.random.default_rng(3).random(200))
        middle, rate = power.running_mean(time, 5 * time, 0.1)
        self.assertGreater(len(middle), 100)
        np.testing.assert_allclose(rate, 5, rtol=1e-12)
        np.testing.assert_allclose(power.interval_rate(time, 5 * time)[1], 5, rtol=1e-9)

    def test_a_value_is_rounded_to_the_digit_of_its_error(self):
        self.assertEqual(power.with_error(1.40321, 0.031), "(1.40 ± 0.03)")
        self.assertEqual(power.with_error(123.4, 5.0), "(123 ± 5)")
        self.assertEqual(power.with_error(1.40321, None), "1.403")

    def test_a_prism_is_cut_in_its_outline(self):
        base = np.array([(0, 0), (2, 0), (2, 1), (0, 1)], float)
        points = np.concatenate([np.c_[base, np.zeros(4)], np.c_[base, np.ones(4)]])
        quads = [(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i) for i in range(4)]
        for z in (0.5, 1.0):
            cut = liner.slice_cells(points, np.ravel(quads), 4 * np.arange(5), z)
            lengths = np.hypot(*(cut[:, 1] - cut[:, 0]).T)
            np.testing.assert_allclose(lengths, (2, 1, 2, 1))
        split = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
        cut = liner.slice_cells(points, np.ravel(split), 3 * np.arange(9), 0.3)
        self.assertAlmostEqual(np.hypot(*(cut[:, 1] - cut[:, 0]).T).sum(), 6)

    def test_particles_are_drawn_as_the_circles_the_plane_cuts(self):
        position = np.array([(0, 0, 1.0), (0, 0, 2.1), (0, 0, 1.6), (0, 0, 0.2)], float)
        which, radius = cut_circles(position, np.array((1, 1, 1, 2.0)), 1.0)
        self.assertEqual(list(which), [0, 2, 3])
        np.testing.assert_allclose(radius, (1, 0.8, np.sqrt(4 - 0.64)))

    def test_components_that_are_zero_have_no_panel(self):
        table = {f"{name}{axis}_{unit}": np.zeros(3) for axis in "xyz"
                 for name, unit in (("", "m"), ("v", "m_s"), ("w", "rad_s"))}
        table["vy_m_s"] = np.array((0, -1, 0.5))
        table["vz_m_s"] = np.full(3, 1e-17)
        table["wx_rad_s"] = np.array((0, 0, 3.0))
        panels, zero = traces.panels_of(table)
        self.assertEqual([label for label, _ in panels], [
            "height $y$ (mm)", "speed (m/s)", "$v_y$ (m/s)", "$\\omega_x$ (rad/s)"])
        self.assertEqual(zero, ["$v_x$", "$v_z$", "$\\omega_y$", "$\\omega_z$"])

    def test_energies_that_never_change_are_left_out(self):
        series = {"time_s": np.arange(3.0), "gravity_j": np.array((5, 5, 4.0)),
                  "kinetic_rotation_j": np.full(3, 7.0)}
        names = [name for name, _, _ in energy.moving(Ledger(series).channels(STORED))]
        self.assertEqual(names, ["gravity"])

    def test_what_feeds_bring_and_outlets_take_is_drawn_and_the_residual_has_its_sign(self):
        series = {"time_s": np.arange(3.0), "gravity_j": np.array((0, 2, 5.0)),
                  "brought_in_j": np.array((0, 2, 4.0)), "work_j": np.zeros(3),
                  "taken_out_j": np.zeros(3), "residual_j": np.array((0, 0, -1.0))}
        proof = Proof()
        energy.energy(SimpleNamespace(series=series), proof)
        self.assertEqual(proof.legends["energy"], ["", "work of the walls", "brought in by feeds"])
        self.assertIn("residual at the end: −2.0e−01 of the turnover", proof.titles["energy"])
        proof = Proof()
        energy.energy(SimpleNamespace(series={**series, "taken_out_j": np.arange(3.0)}), proof)
        self.assertEqual(proof.legends["energy"][-1], "taken out by outlets")

    def test_a_rebound_is_the_ratio_of_speeds_along_the_normal(self):
        time, n = np.arange(5.0), np.array((0.6, 0.8))
        speed = np.array((-2, -2, 0, 1, 1.0))  # along the normal
        moved = {"time_s": time, "id": np.ones(5), "vx_m_s": speed * n[0] + 3 * n[1],
                 "vy_m_s": speed * n[1] - 3 * n[0], "vz_m_s": 0 * time}
        touch = {"time_s": np.array((2.0,)), "id": np.ones(1), "partner": np.array(["plate"]),
                 "normal_x": n[:1], "normal_y": n[1:], "normal_z": np.zeros(1)}
        self.assertAlmostEqual(traces.rebound(moved, touch, np.array((0,))), 0.5)
        self.assertIsNone(traces.rebound(moved, {**touch, "partner": np.array(["7"])}, [0]))
        self.assertIsNone(traces.rebound(moved, {**touch, "time_s": np.array((4.0,))}, [0]))

    def test_contacts_are_told_apart_by_partner_and_by_gaps(self):
        table = {"step": np.array([1, 2, 3, 7, 8, 2.0]), "id": np.ones(6),
                 "partner": np.array(["floor"] * 5 + ["lid"])}
        self.assertEqual([list(rows) for rows in traces.episodes(table)], [[0, 1, 2], [5], [3, 4]])

    def test_planes_that_move_stand_where_the_time_has_brought_them(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write(MOVING)
            file.flush()
            scene = scenery.read_scene(file.name)
        self.assertEqual([plane.name for plane in scenery.standing(scene, None).planes], ["floor"])
        at = {plane.name: plane for plane in scenery.standing(scene, 3.0).planes}
        np.testing.assert_allclose(at["floor"].point, (0, 0, 0))
        np.testing.assert_allclose(at["lid"].point, (0, 0.1 + 0.25 * 1 + 0.5 * 1, 0))
        np.testing.assert_allclose(at["lid"].normal, (0, -1, 0))
        np.testing.assert_allclose(at["flap"].point, (1, 1, 0), atol=1e-12)
        np.testing.assert_allclose(at["flap"].normal, (0, 1, 0), atol=1e-12)
        before, after = (scenery.standing(scene, time).planes[-1].point for time in (1.9, 2.25))
        np.testing.assert_allclose(before, (0, 0, 0))
        np.testing.assert_allclose(after, (0.01 * (np.sin(np.pi / 3) - 0.5), 0, 0))

    def test_a_contact_traced_too_rarely_has_no_loop(self):
        depth = np.sin(np.pi * np.linspace(0, 1, 21))
        self.assertTrue(traces.resolved(depth))
        self.assertFalse(traces.resolved(depth[::3]))
        self.assertFalse(traces.resolved(np.tile((0.2, 1, 0.5), 20)))
        with tempfile.TemporaryDirectory() as folder:
            fake_run.write_bounces(folder)
            table = read_table(os.path.join(folder, "trace_contacts.csv"))
        for every, panels in ((1, 3), (4, 2)):
            rare = {name: values[::every] for name, values in table.items()}
            proof = Proof()
            traces.contacts(SimpleNamespace(trace_contacts=rare, drum_radius=1.0), proof)
            titles = [title for title in proof.titles["contact_forces"] if title]
            self.assertEqual(len(titles), panels)
            self.assertEqual("too rarely" in titles[0], every > 1)

    def test_a_window_is_widened_to_walls_that_are_near(self):
        low, high = np.array((-1.0, -1)), np.array((1.0, 1))
        wall = scenery.Plane("wall", np.array((1.5, 9, 9.0)), np.array((-1.0, 0, 0)))
        slope = scenery.Plane("slope", np.array((0, 0, 5.0)), np.array((0, 0.8, 0.6)))
        far = scenery.Plane("far", np.array((0, -4, 0.0)), np.array((0.0, 1, 0)))
        ball = scenery.Ball(np.array((0, 1, 0.0)), 0.5)
        found = scenery.with_scenery(scenery.Scene([wall, far], [ball], None), low, high, 0.0)
        np.testing.assert_allclose(found, ((-1, -1), (1.58, 1.6)))
        found = scenery.with_scenery(scenery.Scene([slope], [], None), low, high, 7.0)
        np.testing.assert_allclose(found, ((-1, -1.58), (1, 1)))

    def test_angles_come_in_order_from_minus_180(self):
        angle, solidity = ring.from_minus_180(np.array([0, 90, 190, 270.0]), np.arange(4))
        np.testing.assert_allclose(angle, (-170, -90, 0, 90))
        np.testing.assert_array_equal(solidity, (2, 3, 0, 1))

    def test_a_colour_scale_ends_at_a_round_number_above_the_data(self):
        self.assertEqual(round_limit(np.array([0.1, -1.21, np.nan]), 100), 1.5)
        self.assertEqual(round_limit(np.array([np.nan])), 1.0)

    def test_a_colour_scale_of_nearly_equal_values_starts_near_them(self):
        self.assertEqual(colour_limits(np.array([0.31, 0.014])), (0.0, 0.4))
        np.testing.assert_allclose(colour_limits(np.array([1.9603, 1.9648])), (1.96, 1.965))
        self.assertEqual(colour_limits(np.array([1.96, 1.960001])), (0.0, 2.0))
        self.assertEqual(colour_limits(np.array([0.0])), (0.0, 1.0))

    def test_a_table_without_a_row_is_not_recorded(self):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("step,time_s\n")
            file.flush()
            self.assertRaises(NotRecorded, read_table, file.name)


if __name__ == "__main__":
    names = [f"-k{word}" for word in sys.argv[1:] if not os.path.isfile(word)]
    unittest.main(argv=[sys.argv[0]] + names)
