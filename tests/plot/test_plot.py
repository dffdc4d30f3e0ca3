# SPDX-License-Identifier: Apache-2.0
"""Tests of the plotting script on invented run folders (fake_run.py).

    /usr/bin/python3 tests/plot/test_plot.py [build/quern] [NAME]

With the path of the program, `quern plot` itself is tried too; with a name, only tests like it.
"""
import filecmp
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
PLOT = os.path.join(HERE, "..", "..", "plot")
PROGRAM = next((os.path.abspath(word) for word in sys.argv[1:] if os.path.isfile(word)), None)
sys.dont_write_bytecode = True
sys.path[:0] = [HERE, PLOT]

import fake_run  # noqa: E402
import h5py  # noqa: E402
import numpy as np  # noqa: E402

from figures import figure_list, power, ring, section, traces  # noqa: E402
from figures.folder import NotRecorded, NotRun, Run, read_table  # noqa: E402
from figures.ledger import Ledger  # noqa: E402
from figures.particles import cut_particles  # noqa: E402
from figures.style import Gallery, round_limit  # noqa: E402


def draw_all(folder, pictures):
    """Names of the pictures drawn, and of the figures skipped."""
    run, gallery, skipped = Run(folder), Gallery(pictures, dpi=30), []
    for name, draw in figure_list():
        try:
            draw(run, gallery)
        except NotRecorded:
            skipped.append(name)
    return [os.path.basename(path) for path in gallery.written], skipped


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
        self.assertEqual(skipped, ["traces", "contact forces"])

    def test_a_drop_gives_its_traces_and_says_what_is_skipped(self):
        result = script(self.drop, "--dpi", "30", "-o", os.path.join(self.root, "drop-pictures"))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("traces.png", result.stdout)
        self.assertIn("contact_forces.png", result.stdout)
        self.assertIn("did not record them: porosity maps", result.stdout)

    def test_the_same_recordings_give_the_same_bytes(self):
        for folder in (self.mill, self.drop):
            first, second = tempfile.mkdtemp(dir=self.root), tempfile.mkdtemp(dir=self.root)
            names, _ = draw_all(folder, first)
            draw_all(folder, second)
            for name in names:
                self.assertTrue(filecmp.cmp(os.path.join(first, name), os.path.join(second, name),
                                            shallow=False), name)

    def test_any_missing_part_costs_only_its_own_pictures(self):
        lost = {"fields.h5": ("porosity maps", "velocity quivers", "component maps",
                              "charge around the shell"),
                "series.csv": ("power", "energy"), "summary.json": (), "frames": ("particles",)}
        for part, figures in lost.items():
            folder = self.copy_of(self.mill)
            path = os.path.join(folder, part)
            shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
            _, skipped = draw_all(folder, os.path.join(folder, "new"))
            self.assertEqual(set(skipped) - {"traces", "contact forces"}, set(figures), part)

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
            file.write("step,time_s\n1,2\n")
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
            cut = section.slice_cells(points, np.ravel(quads), 4 * np.arange(5), z)
            lengths = np.hypot(*(cut[:, 1] - cut[:, 0]).T)
            np.testing.assert_allclose(lengths, (2, 1, 2, 1))
        split = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
        cut = section.slice_cells(points, np.ravel(split), 3 * np.arange(9), 0.3)
        self.assertAlmostEqual(np.hypot(*(cut[:, 1] - cut[:, 0]).T).sum(), 6)

    def test_only_particles_the_plane_cuts_are_drawn_the_nearest_last(self):
        position = np.array([(0, 0, 0.9), (0, 0, 2.1), (0, 0, 1.5), (0, 0, 0.2)], float)
        self.assertEqual(list(cut_particles(position, np.ones(4), 1.0)), [3, 0, 2])

    def test_contacts_are_told_apart_by_partner_and_by_gaps(self):
        table = {"step": np.array([1, 2, 3, 7, 8, 2.0]), "id": np.ones(6),
                 "partner": np.array(["floor"] * 5 + ["lid"])}
        self.assertEqual([list(rows) for rows in traces.episodes(table)], [[0, 1, 2], [5], [3, 4]])

    def test_angles_come_in_order_from_minus_180(self):
        angle, solidity = ring.from_minus_180(np.array([0, 90, 190, 270.0]), np.arange(4))
        np.testing.assert_allclose(angle, (-170, -90, 0, 90))
        np.testing.assert_array_equal(solidity, (2, 3, 0, 1))

    def test_a_colour_scale_ends_at_a_round_number_above_the_data(self):
        self.assertEqual(round_limit(np.array([0.1, -1.21, np.nan]), 100), 1.5)
        self.assertEqual(round_limit(np.array([np.nan])), 1.0)

    def test_a_table_without_a_row_is_not_recorded(self):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("step,time_s\n")
            file.flush()
            self.assertRaises(NotRecorded, read_table, file.name)


if __name__ == "__main__":
    names = [f"-k{word}" for word in sys.argv[1:] if not os.path.isfile(word)]
    unittest.main(argv=[sys.argv[0]] + names)
