#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python module against closed forms, the program's own files, and its promises about errors, threads and Ctrl-C.
Call: module.py SOURCE_FOLDER PROGRAM; rollfem is found by PYTHONPATH."""
import json
import math
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
from unittest import mock

import numpy as np

import rollfem

ROOT, PROGRAM = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SMALL = {"load": {"normal_force": 50e3}, "friction": {"coefficient": 0.5},
         "wheel": {"rolling_radius": 400.0, "transverse_radius": math.inf}, "rail": {"transverse_radius": 400.0},
         "contact_grid": {"elements_across": 12}}


class Cases(unittest.TestCase):
    def test_hertz_between_a_cylinder_and_a_crossed_one_is_the_circle(self):
        # Equal radii crossed: a sphere of 400 mm on a plane. E = 210 GPa, nu = 0.3 by default.
        modulus = 210e3 / (2 * (1 - 0.3**2))
        radius = (3 * 50e3 * 400.0 / (4 * modulus)) ** (1 / 3)
        point = rollfem.solve(SMALL, model="hertz").points[0]
        self.assertAlmostEqual(point.semi_axis_x / radius, 1.0, 6)
        self.assertAlmostEqual(point.max_pressure / (1.5 * 50e3 / (math.pi * radius**2)), 1.0, 6)

    def test_file_dict_and_keywords_are_one_case(self):
        with tempfile.TemporaryDirectory() as folder:
            file = rollfem.Case(SMALL).write(os.path.join(folder, "small.toml"))
            texts = {rollfem.Case(source).text for source in (file, SMALL)} | {rollfem.Case(**SMALL).text}
        self.assertEqual(len(texts), 1)

    def test_written_elsewhere_a_case_finds_its_files(self):
        with tempfile.TemporaryDirectory() as folder:
            profiles = {"wheel": {"profile": "S1002", "rolling_radius": 460.0}, "rail": {"profile": "here/rail.csv"}}
            os.makedirs(f"{folder}/here")
            placed = {"load": {"vertical_force": 1e5}, "track": {"inclination": "1:40"}}
            case = rollfem.Case.of(f"{folder}/case.toml", {**SMALL, **profiles, **placed})
            there = rollfem.Case(case.write(f"{folder}/here/case.toml"))
        self.assertEqual((there["wheel.profile"], there["rail.profile"]), ("S1002", "rail.csv"))

    def test_every_committed_case_goes_through_a_dict(self):
        for file in sorted((ROOT / "cases").glob("*.toml")):
            case = rollfem.Case(file)
            # Only the title is another; files that the case names are found beside it.
            self.assertEqual(case.with_(title="x").describe().split("\n", 1)[1:],
                             rollfem.Case(file).with_(title="x").describe().split("\n", 1)[1:])
            self.assertEqual(case.with_().data, case.data, file)

    def test_with_changes_one_key_and_not_the_case(self):
        case = rollfem.Case(SMALL)
        other = case.with_({"load.normal_force": 60e3}, friction__coefficient=np.float64(0.3), spin=np.array([0, 1e-4]))
        self.assertEqual((other["load.normal_force"], other["friction.coefficient"]), (60e3, 0.3))
        self.assertEqual((case["load.normal_force"], other.load_points), (50e3, 2))
        self.assertNotIn("rolling", case.data)
        self.assertEqual(other.with_(spin=None).load_points, 1)
        self.assertEqual(pickle.loads(pickle.dumps(other)), other)

    def test_errors_are_those_of_files_without_lines_nobody_wrote(self):
        for change, words in (({"friction.coeficient": 1}, "case: friction.coeficient: is not a key"),
                              ({"load.normal_force": -1}, "case: load.normal_force = -1: is out of bounds"),
                              ({"nonsense": 1}, "case: nonsense: is not a key"),
                              ({"extent": 1}, "several sections have this key")):
            with self.assertRaises(rollfem.InputError) as caught:
                rollfem.Case(SMALL).with_(change)
            self.assertIn(words, str(caught.exception))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "case.toml")
            file.write_text("[load]\nnormal_forc = 1\n")
            with self.assertRaises(rollfem.InputError) as caught:
                rollfem.Case(file)
        self.assertIn("case.toml:2:1: load.normal_forc: is not a key", str(caught.exception))
        for call in (lambda: rollfem.solve(SMALL, model="none"), lambda: rollfem.solve(SMALL, model="a", models=["b"]),
                     lambda: rollfem.read(ROOT), lambda: rollfem.sweep(SMALL)):
            self.assertRaises(rollfem.InputError, call)

    def test_a_name_that_fits_several_keys_or_none_of_the_call_is_refused(self):
        case, track = rollfem.Case(SMALL), ROOT / "cases/manchester_A22.toml"
        for call, words in ((lambda: rollfem.solve(case, load=100e3), ("load is a section", "normal_force", "table.load")),
                            (lambda: rollfem.sweep(case, load=[50e3, 100e3]), ("load is a section", "table.load")),
                            (lambda: case.with_(friction=0.1), ("friction is a section", "coefficient")),
                            (lambda: case.with_(table={"axis_ratio": 1.0}, speed=1e4), ("rolling.speed, table.speed",)),
                            (lambda: case.with_({"rolling.spin": 0.1}, spin=0.2), ("same key",)),
                            (lambda: rollfem.sweep(case, {"rolling.spin": 0.1}, spin=0.2), ("same key",)),
                            (lambda: rollfem.solve(case, table={"load": 1e5}), ("table.load: rollfem.solve does not use",)),
                            (lambda: rollfem.sweep(case, axis_ratio=[1.0]), ("table.axis_ratio: rollfem.sweep does not",)),
                            (lambda: rollfem.table(case, spin=1e-4), ("rolling.spin: rollfem.table does not use",)),
                            (lambda: rollfem.wheelset(track, coefficient=0.1), ("friction.coefficient: rollfem.wheelset",)),
                            (lambda: rollfem.contact_points(track, spin=0.1), ("rolling.spin: rollfem.contact_points",))):
            with self.assertRaises(rollfem.InputError) as caught:
                call()
            for word in words:
                self.assertIn(word, str(caught.exception))
        self.assertEqual(case.with_(speed=1e4)["rolling.speed"], 1e4)
        loads = rollfem.sweep(case, normal_force=[50e3, 400e3], model="hertz")  # Hertz: p0 as the cube root
        self.assertAlmostEqual(loads.max_pressure[1] / loads.max_pressure[0], 2.0, 9)

    def test_an_unknown_quantity_is_an_error_with_a_suggestion(self):
        result, sweep = rollfem.solve(SMALL, model="fastsim"), rollfem.sweep(SMALL, spin=[0.0], model="fastsim")
        for call in (result.points[0].bar, result.points[0].__getitem__, result[0].bars, result[0].values, sweep.bars,
                     sweep.values):
            with self.assertRaisesRegex(KeyError, "did you mean max_pressure?"):
                call("max_presure")
        self.assertRaisesRegex(KeyError, "not an axis", result[0].middle, "pressure", "z")
        self.assertRaises(rollfem.InputError, rollfem.Profile.of, ROOT / "cases/manchester_A22.toml", "weel")

    def test_calls_that_make_no_sense_are_refused_at_once(self):
        endless = {}
        endless["load"] = endless
        for call in (lambda: rollfem.solve(SMALL, models=[]), lambda: rollfem.solve(SMALL, models=5),
                     lambda: rollfem.Case(5), lambda: rollfem.Case(endless), lambda: rollfem.Case(SMALL).with_(5),
                     lambda: rollfem.Case(SMALL).with_({5: 1}), lambda: rollfem.Case(SMALL).with_(models={"x": None}),
                     lambda: rollfem.read("/dev/zero"), lambda: rollfem.Case(SMALL)[1],
                     lambda: rollfem.stress_measures("abc"), lambda: rollfem.stress_measures([{}] * 6),
                     lambda: rollfem.study(SMALL, levels="a"), lambda: rollfem.study(SMALL, levels=1e1),
                     lambda: rollfem.study(SMALL, levels=10**12), lambda: rollfem.study(SMALL, vary=5),
                     lambda: rollfem.study(SMALL, reference=[1.0])):
            self.assertRaises(rollfem.InputError, call)
        self.assertRaises(KeyError, rollfem.Case(SMALL).__getitem__, "load.normal_force.value")
        for call in (rollfem.Table, rollfem.read, rollfem.Case):
            self.assertRaises(rollfem.FileError, call, "x" * 300)

    def test_a_slip_of_units_warns(self):
        with self.assertWarns(rollfem.UnitWarning):
            rollfem.solve({**SMALL, "wheel": {"rolling_radius": 0.4, "transverse_radius": math.inf}}, model="hertz")


class Results(unittest.TestCase):
    def test_numbers_and_arrays_are_those_of_the_program(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=[0.0, 0.002])
        result = rollfem.solve(case, model="halfspace")
        with tempfile.TemporaryDirectory() as folder:
            file = case.write(os.path.join(folder, "small.toml"))
            subprocess.run([PROGRAM, "run", file, "--model", "halfspace", "-q", "--no-report", "-o", f"{folder}/run"],
                           check=True)
            result.write(f"{folder}/written")
            of_program, of_module = rollfem.read(f"{folder}/run"), rollfem.read(f"{folder}/written/results.h5")
            summary = json.loads(pathlib.Path(folder, "run/summary.json").read_text())
        for stored in (of_program, of_module):
            for here, there in zip(result.points, stored.points):
                for name, value in here.scalars.items():
                    if name != "seconds":
                        self.assertEqual(value, there.scalars[name], name)
                self.assertEqual(here.fields.keys(), there.fields.keys())
                for name, values in here.fields.items():
                    np.testing.assert_array_equal(values, there.fields[name], name)
                self.assertEqual(here.error_estimate, there.error_estimate)
                self.assertEqual(here.richardson, there.richardson)
        self.assertEqual(summary["models"][0]["points"][1]["max_pressure"], result.points[1].max_pressure)
        self.assertEqual(of_program.case.with_(spin=1e-4)["rolling.spin"], 1e-4)

    def test_tractions_sum_to_the_forces_and_outlive_the_result(self):
        model = rollfem.solve(rollfem.Case(SMALL).with_(longitudinal_creepage=0.002), model="halfspace")[0]
        point, area = model.points[0], model.dx * model.dy
        pressure = point.pressure
        self.assertAlmostEqual(point.traction_x.sum() * area / point.longitudinal_force, 1.0, 9)
        self.assertLess(point.longitudinal_force, 0.0)
        force = point.normal_force
        del model, point
        self.assertAlmostEqual(pressure.sum() * area / force, 1.0, 9)
        self.assertFalse(pressure.flags.writeable)

    def test_columns_make_a_data_frame(self):
        result = rollfem.solve(SMALL, models=["hertz", "fastsim"])
        pandas = types.SimpleNamespace(DataFrame=lambda columns: columns)
        with mock.patch.dict(sys.modules, {"pandas": pandas}):
            frame = result.to_dataframe()
        self.assertEqual(frame["model"].tolist(), ["hertz", "fastsim"])
        self.assertEqual(frame["max_pressure"][0], result["hertz"].points[0].max_pressure)
        with mock.patch.dict(sys.modules, {"pandas": None}), self.assertRaisesRegex(ImportError, "python3-pandas"):
            result.to_dataframe()
        self.assertRaises(ValueError, lambda: result.points)

    def test_every_quantity_says_what_it_is(self):
        for name, quantity in rollfem.QUANTITIES.items():
            self.assertIn(f"[{quantity.unit}]", getattr(rollfem.Point, name).__doc__)
        for name, field in rollfem.FIELDS.items():
            self.assertIn(field.unit, getattr(rollfem.Point, name).__doc__)

    def test_patches_of_wheels_have_their_place(self):
        result = rollfem.solve(ROOT / "cases/s1002_uic60_left.toml", model="hertz")
        self.assertEqual(result[0].place["wheel"], "left")
        self.assertEqual(result["hertz"].key, result[0].key)
        self.assertEqual(result.columns()["patch"][0], 1)


class Sweeps(unittest.TestCase):
    def test_axes_are_in_the_order_of_the_keys(self):
        sweep = rollfem.sweep(SMALL, {"friction.coefficient": [0.2, 0.4]}, longitudinal_creepage=[0.001, 0.002, 0.03],
                              model="fastsim")
        self.assertEqual(sweep.traction_coefficient.shape, (2, 3))
        # Full sliding at the last: mu, to what 100 strips make of the ellipse.
        np.testing.assert_allclose(sweep.traction_coefficient[:, 2], [0.2, 0.4], rtol=1e-4)
        alone = rollfem.solve(rollfem.Case(SMALL).with_(longitudinal_creepage=0.002, friction__coefficient=0.4),
                              model="fastsim")
        self.assertAlmostEqual(sweep.values("longitudinal_force")[1, 1], alone.points[0].longitudinal_force, 6)
        columns = sweep.columns()
        self.assertEqual(columns["friction.coefficient"].tolist(), [0.2] * 3 + [0.4] * 3)

    def test_combinations_without_a_solution_are_skipped_only_when_asked(self):
        with mock.patch("rollfem.sweeping.solve", side_effect=self.failing(rollfem.sweeping.solve)):
            self.assertRaises(rollfem.SolveError, rollfem.sweep, SMALL, spin=[0.0, 1e-4], model="fastsim")
            sweep = rollfem.sweep(SMALL, spin=[0.0, 1e-4], model="fastsim", skip_failures=True)
        self.assertEqual(sweep.failures, {(1,): "no solution"})
        np.testing.assert_array_equal(np.isnan(sweep.max_pressure), [False, True])

    @staticmethod
    def failing(solve):
        def some(case, **how):
            if 1e-4 in np.atleast_1d(case["rolling.spin"]):
                raise rollfem.SolveError("no solution")
            return solve(case, **how)
        return some


class Solving(unittest.TestCase):
    def test_what_progress_raises_ends_the_solution(self):
        seen = []

        def stop(event):
            seen.append(event.stage)
            if len(seen) == 3:
                raise KeyError("enough")
        with self.assertRaises(KeyError):
            rollfem.solve(SMALL, model="halfspace", progress=stop)
        self.assertEqual(len(seen), 3)

    def test_ctrl_c_is_heard_within_a_solution(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=list(np.linspace(0, 0.01, 400)), elements_across=60)
        main = threading.main_thread().ident
        timer = threading.Timer(0.3, lambda: signal.pthread_kill(main, signal.SIGINT))
        timer.start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            rollfem.solve(case, model="halfspace")
        self.assertLess(time.monotonic() - begin, 5.0)

    def test_other_threads_run_meanwhile(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=list(np.linspace(0, 0.01, 20)))
        found, turns = [], 0
        worker = threading.Thread(target=lambda: found.append(rollfem.solve(case, model="halfspace")))
        worker.start()
        while worker.is_alive():
            turns += 1
            time.sleep(0.001)
        self.assertGreater(turns, 10)
        again = rollfem.solve(case, model="halfspace")
        np.testing.assert_array_equal(found[0][0].traction_coefficient, again[0].traction_coefficient)


class MadeTables(unittest.TestCase):
    """Those that the program makes of `case` once for all tests of a class."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = os.path.join(cls.folder.name, "out")
        file = cls.case().write(os.path.join(cls.folder.name, "case.toml"))
        subprocess.run([PROGRAM, "table", file, "-o", cls.path, "--no-report", "-q"], check=True)
        cls.table = rollfem.Table(cls.path)

    def expect_columns(self, numbers):
        rows, columns = np.genfromtxt(os.path.join(self.path, "table.csv"), delimiter=",", skip_header=1), self.table.columns()
        for number, name in numbers.items():
            np.testing.assert_allclose(rows[:, number], columns[name], rtol=1e-6, atol=1e-9)


class Tables(MadeTables):
    @staticmethod
    def case():
        return rollfem.Case(SMALL, table={"axis_ratio": [0.5, 2.0], "points": [4, 3, 5], "largest": [2.0, 2.0, 2.0],
                                          "check_points": 10})

    def test_arrays_are_those_of_the_csv(self):
        self.assertEqual(self.table.shape, (2, 4, 3, 5))
        self.expect_columns(dict(enumerate(("axis_ratio", "longitudinal", "lateral", "spin", "longitudinal_force",
                                            "lateral_force", "spin_moment"))))
        self.assertEqual(self.table.interpolation["points"], 10)
        self.assertIn("2 x 4 x 3 x 5", repr(self.table))
        self.assertIn("</svg>", self.table.figure().svg())

    def test_points_are_found_again_and_arrays_broadcast(self):
        axes = self.table.axes
        found = self.table.scaled(axes["longitudinal"][:, None], axes["lateral"], axes["spin"][1], axis_ratio=2.0)
        np.testing.assert_allclose(found.lateral_force, self.table.lateral_force[1, :, :, 1], atol=1e-12)
        one = self.table.scaled(-axes["longitudinal"][2], axis_ratio=0.5)
        self.assertAlmostEqual(one.longitudinal_force, -self.table.longitudinal_force[0, 2, 0, 2], 12)
        with self.assertRaises(ValueError):
            self.table.scaled(1.0)
        with self.assertRaises(rollfem.InputError):
            self.table.scaled(1.0, axis_ratio=3.0)

    def test_large_creepage_slides(self):
        known = {"semi_axis_x": 5.0, "semi_axis_y": 5.0, "shear_modulus": 80e3, "friction_bound": 15e3}
        slide = self.table.forces(longitudinal_creepage=[0.5, 0.3], lateral_creepage=[0.0, 0.4], **known)
        self.assertAlmostEqual(slide.longitudinal_force[0] / -15e3, 1.0, 2)
        self.assertTrue((np.hypot(slide.longitudinal_force, slide.lateral_force) <= 15e3 * (1 + 1e-12)).all())
        self.assertTrue((slide.force_bar > 0).all())
        self.assertLess(len(repr(self.table.scaled(np.linspace(0.0, 2.0, 1000), axis_ratio=2.0))), 800)

    def test_other_files_are_refused(self):
        with self.assertRaises(rollfem.InputError):
            rollfem.Table(os.path.join(self.folder.name, "nothing"))


class TablesOfFallingFriction(MadeTables):
    @staticmethod
    def case():
        falling = {"coefficient": 0.3, "law": "exponential", "kinetic_coefficient": 0.1, "half_velocity": 300.0,
                   "memory_distance": 0.003}
        return rollfem.Case({**SMALL, "friction": falling, "rolling": {"speed": 20e3}}, table={
            "load": [50e3, 60e3], "speed": [10e3, 20e3], "check_points": 0, "longitudinal_values": [0.0, 2.0],
            "lateral_values": [0.0, 1.0], "spin_values": [0.1]})

    def test_load_and_speed_are_axes(self):
        self.assertEqual(list(self.table.axes)[:3], ["load", "speed", "axis_ratio"])
        self.assertEqual(self.table.shape, (2, 2, 1, 2, 2, 2))
        self.expect_columns({0: "load", 1: "speed", 6: "longitudinal_force"})
        found = self.table.scaled(2.0, 0.0, 0.1, load=60e3, speed=[10e3, 20e3])
        np.testing.assert_allclose(found.longitudinal_force, self.table.longitudinal_force[1, :, 0, 1, 0, 1], atol=1e-12)

    def test_it_holds_for_its_law_alone(self):
        self.assertIn("falling friction at speeds of 10000 to 20000 mm/s", self.table.only_for)
        ellipse = {"semi_axis_x": 5.0, "semi_axis_y": 5.0, "shear_modulus": 210e3 / 2.6, "friction_bound": 0.3 * 55e3}
        self.assertGreater(0.0, self.table.forces(longitudinal_creepage=1e-4, speed=15e3, **ellipse).longitudinal_force)
        for wrong in ({}, {"speed": 90e3}, {"speed": 15e3, "longitudinal_creepage": 1.0}):
            with self.assertRaises(rollfem.InputError):
                self.table.forces(**wrong, **ellipse)


class ShiftedTables(MadeTables):
    @staticmethod
    def case():
        return rollfem.Case(os.path.join(ROOT, "cases", "s1002_uic60_left.toml")).with_(
            contact_grid={"elements_across": 12},
            table={"lateral_shift": [1.0, 3.0], "lateral_shift_step": 1.0, "points": [2, 2, 3], "check_points": 10})

    def test_arrays_are_those_of_the_csv(self):
        self.assertEqual(self.table.shape, (3, 3, 3, 3))
        self.expect_columns({0: "lateral_shift", 1: "longitudinal", 4: "longitudinal_force", 6: "spin_moment",
                             10: "force_along_normal"})
        shifts = np.genfromtxt(os.path.join(self.path, "shifts.csv"), delimiter=",", names=True)
        np.testing.assert_allclose(shifts["rolling_radius_mm"], self.table.wheels["rolling_radius"], rtol=1e-8)
        np.testing.assert_allclose(self.table.wheel_at([1.0, 2.0])["contact_angle"], self.table.wheels["contact_angle"][:2])

    def test_points_are_found_again_in_newtons(self):
        wheels, axes = self.table.wheels, self.table.axes
        a, b = wheels["semi_axis_x"][1], wheels["semi_axis_y"][1]
        bound = self.table.friction_coefficient * wheels["normal_force"][1]
        slide = self.table.forces(lateral_shift=2.0, longitudinal_creepage=[0.5, -0.5])
        np.testing.assert_allclose(slide.longitudinal_force, [-bound, bound], rtol=0.01)
        doubled = self.table.forces(lateral_shift=2.0, friction_bound=2 * bound, longitudinal_creepage=[1.0, -1.0])
        np.testing.assert_allclose(doubled.longitudinal_force, 2 * slide.longitudinal_force, rtol=1e-12)
        at_rest = self.table.forces(lateral_shift=2.0)
        self.assertAlmostEqual(at_rest.longitudinal_force, bound * self.table.longitudinal_force[1, 1, 1, 1], 6)
        self.assertAlmostEqual(at_rest.spin_moment, bound * np.sqrt(a * b) * self.table.spin_moment[1, 1, 1, 1], 5)
        found = self.table.scaled(axes["longitudinal"], lateral_shift=3.0)
        np.testing.assert_allclose(found.lateral_force, self.table.lateral_force[2, :, 1, 1], atol=1e-12)

    def test_wrong_questions_are_refused(self):
        with self.assertRaises(rollfem.InputError):
            self.table.forces(lateral_shift=3.5)
        with self.assertRaisesRegex(TypeError, "it needs lateral_shift"):
            self.table.forces(longitudinal_creepage=0.001)
        with self.assertRaisesRegex(TypeError, "leave out semi_axis_x"):
            self.table.forces(lateral_shift=2.0, semi_axis_x=5.0)
        with self.assertRaisesRegex(ValueError, "over lateral_shift"):
            self.table.scaled(1.0, axis_ratio=1.0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
