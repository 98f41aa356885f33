#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands compute, as functions of the Python module: against closed forms and the files of the program.
Call: commands.py SOURCE_FOLDER PROGRAM; rollfem is found by PYTHONPATH."""
import inspect
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np

import rollfem
from module import PROGRAM, ROOT, SMALL

CASES = ROOT / "cases"


def run(*arguments):
    """The text that the program prints."""
    return subprocess.run([PROGRAM, *map(os.fspath, arguments)], check=True, capture_output=True, text=True).stdout


def rows_of(path):
    """A CSV file by its columns without units."""
    found = np.genfromtxt(path, delimiter=",", names=None, dtype=None, encoding="utf-8", comments=None)
    return {name.split(" [")[0]: found[1:, k] for k, name in enumerate(found[0])}


class Stresses(unittest.TestCase):
    def test_measures_of_plain_states_are_those_of_textbooks(self):
        states = np.zeros((2, 3, 6))
        states[0, :, 0] = 100, -100, 0  # pull, push
        states[1, :, 5] = 0, 40, -40  # shear xz
        found = rollfem.stress_measures(states)
        self.assertEqual(found["principal"].shape, (2, 3, 3))
        np.testing.assert_allclose(found["hydrostatic"][0], [100 / 3, -100 / 3, 0], rtol=1e-14)
        np.testing.assert_allclose(found["von_mises"], [[100, 100, 0], [0, 40 * 3**0.5, 40 * 3**0.5]], atol=1e-12)
        np.testing.assert_allclose(found["tresca"], [[100, 100, 0], [0, 80, 80]], atol=1e-12)
        np.testing.assert_allclose(found["orthogonal_shear"][1], [0, 40, 40], rtol=1e-14)
        np.testing.assert_allclose(found["principal"][1, 1], [40, 0, -40], atol=1e-12)

    def test_wrong_shapes_are_refused(self):
        with self.assertRaisesRegex(ValueError, "six components"):
            rollfem.stress_measures(np.zeros((6, 3)))


class Ellipses(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("ignore", rollfem.UnitWarning)  # wheels that no train has

    def test_hertz_finds_the_ellipse_that_a_case_was_made_of(self):
        for a, b in ((6.0, 6.0), (3.0, 12.0), (12.0, 3.0), (5.0, 5.001), (16.0, 1.5)):
            for modulus in (210e3, 70e3):
                case = rollfem.Case.from_ellipse(a, b, 30e3, friction={"coefficient": 0.3}, rail={"young_modulus": modulus})
                point = rollfem.solve(case, model="hertz").points[0]
                self.assertAlmostEqual(point.semi_axis_x / a, 1.0, 6)
                self.assertAlmostEqual(point.semi_axis_y / b, 1.0, 6)
                self.assertAlmostEqual(point.max_pressure / (1.5 * 30e3 / (math.pi * a * b)), 1.0, 6)

    def test_a_circle_has_the_radius_of_hertz(self):
        # a^3 = 3 F R / (4 E*), of two steel bodies.
        radius = 4.0**3 * 4 * (210e3 / (2 * (1 - 0.3**2))) / (3 * 30e3)
        case = rollfem.Case.from_ellipse(4.0, 4.0, 30e3, friction__coefficient=0.3)
        self.assertAlmostEqual(case["wheel.rolling_radius"] / radius, 1.0, 9)
        self.assertAlmostEqual(case["rail.transverse_radius"] / radius, 1.0, 9)

    def test_what_is_no_ellipse_is_refused(self):
        for numbers in ((0.0, 1.0, 1.0), (1.0, -1.0, 1.0), (1.0, 1.0, math.inf), (math.nan, 1.0, 1.0)):
            self.assertRaises(rollfem.InputError, rollfem.Case.from_ellipse, *numbers)


class Keys(unittest.TestCase):
    def test_none_removes_a_key_everywhere(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=[0.0, 0.001], spin=1e-4)
        for other in (case.with_(spin=None), rollfem.Case(case, spin=None), rollfem.Case(case, rolling={"spin": None}),
                      rollfem.solve(case, model="fastsim", spin=None).case):
            self.assertEqual(other["rolling"], {"longitudinal_creepage": [0.0, 0.001]})
        self.assertNotIn("rolling", rollfem.Case(case, rolling=None).data)

    def test_problems_of_files_are_those_of_the_system(self):
        with tempfile.TemporaryDirectory() as folder:
            result = rollfem.solve(SMALL, model="hertz")
            blocked = os.path.join(folder, "file")
            pathlib.Path(blocked).write_text("")
            for call in (lambda: rollfem.Case("nothing.toml"), lambda: rollfem.read(folder), lambda: rollfem.Table(folder),
                         lambda: rollfem.read(blocked), lambda: result.write(f"{blocked}/x"),
                         lambda: rollfem.Case(SMALL).write(f"{blocked}/x.toml"), lambda: rollfem.stress(folder),
                         lambda: rollfem.Profile("nothing.prw")):
                self.assertRaises(OSError, call)
                self.assertRaises(rollfem.InputError, call)
        with self.assertRaises(rollfem.InputError) as caught:
            rollfem.solve(SMALL, model="hertz", load={"normal_force": -1})
        self.assertNotIsInstance(caught.exception, OSError)


class Sweeps(unittest.TestCase):
    def test_load_points_of_the_case_are_an_axis(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=[0.0005, 0.001, 0.03])
        for sweep in (rollfem.sweep(case, spin=[0.0, 3e-4], model="fastsim"),
                      rollfem.sweep(SMALL, spin=[0.0, 3e-4], longitudinal_creepage=[0.0005, 0.001, 0.03], model="fastsim")):
            self.assertEqual(list(sweep.axes), ["spin", "longitudinal_creepage"])
            self.assertEqual(sweep.axes["longitudinal_creepage"].tolist(), [0.0005, 0.001, 0.03])
            for k, spin in enumerate((0.0, 3e-4)):
                alone = rollfem.solve(case, model="fastsim", spin=spin)[0]
                np.testing.assert_allclose(sweep.longitudinal_force[k], alone.longitudinal_force, rtol=1e-12)
        pairs = rollfem.sweep(case.with_(lateral_creepage=[0.0, 0.0, 0.001]), friction__coefficient=[0.3, 0.5], model="fastsim")
        self.assertEqual(pairs.axes["point_index"].tolist(), [0, 1, 2])
        # Full sliding at the last, along both creepages.
        forces = np.hypot(pairs.longitudinal_force, pairs.lateral_force)[:, 2]
        np.testing.assert_allclose(forces, [0.3 * 50e3, 0.5 * 50e3], rtol=1e-3)

    def test_forces_of_a_wheel_are_sums_over_its_patches(self):
        # At -4.29 mm the left wheel touches on tread and flange.
        shifts = [0.0, -2.0, -4.29]
        case = rollfem.Case(
            models=["halfspace"], load={"vertical_force": 60e3}, friction={"coefficient": 0.3}, rail={"profile": "60E1"},
            wheel={"rolling_radius": 460.0, "profile": "arcs"}, track={"inclination": "1:40"},
            wheel_profile={"radii": [12.0, math.inf, -10.0, math.inf], "ends": [-52.5, -37.5, -34.898, -26.0, 60.0],
                           "slope": -0.05},
            wheelset={"side": "left", "lateral_shift": shifts, "roll": 0.0}, contact_grid={"elements_across": 10})
        with tempfile.TemporaryDirectory() as folder:
            run("run", case.write(f"{folder}/case.toml"), "-o", f"{folder}/run", "--no-report", "-q")
            rows = rows_of(f"{folder}/run/wheelset.csv")
        sweep = rollfem.sweep(case, {"wheelset.lateral_shift": shifts})
        patches = sweep.patches("halfspace_left")
        self.assertEqual([len(each) for each in patches], [1, 1, 2])
        self.assertEqual(rows["left patches"].tolist(), ["1", "1", "2"])
        np.testing.assert_allclose(sweep.vertical_force, 60e3, rtol=1e-5)
        for name, column in (("longitudinal_force", "longitudinal_force"), ("lateral_force_track",) * 2):
            np.testing.assert_allclose(sweep.values(name), rows[f"left {column}"].astype(float), rtol=1e-6, err_msg=name)
        for k, each in enumerate(patches):
            self.assertAlmostEqual(sweep.contact_area[k], sum(p.contact_area for p in each), 9)
            self.assertEqual(sweep.max_pressure[k], max(p.max_pressure for p in each))
            self.assertEqual(sweep.points()[k].place["patch"], 1)
        self.assertEqual(np.isnan(sweep.lateral_force).tolist(), [False, False, True])
        self.assertLess(abs(sweep.traction_coefficient[2]), 0.3)

    def test_columns_and_plots_have_bars_and_progress_counts_combinations(self):
        told = []
        sweep = rollfem.sweep(SMALL, normal_force=[4e4, 8e4, 12e4], model="halfspace",
                              progress=lambda event: told.append((event.point, event.points, event.fraction)))
        bars = sweep.columns()["max_pressure_bar"]
        np.testing.assert_array_equal(bars, sweep.bars("max_pressure"))
        self.assertTrue((bars > 0).all())
        self.assertEqual({points for _, points, _ in told}, {3})
        self.assertEqual({point for point, *_ in told} - {0}, {1, 2, 3})
        self.assertTrue(all(0.0 <= fraction <= 1.0 for *_, fraction in told))
        self.assertGreaterEqual(told[-1][2], 2 / 3)
        axes = sweep.plot("max_pressure")
        self.assertEqual(axes.get_xlabel(), "normal_force (N)")
        self.assertEqual(len(axes.containers), 1)  # points with bars


class Track(unittest.TestCase):
    def test_cones_have_their_conicity_and_the_wave_of_klingel(self):
        # A cone of 1:20 that does not roll sideways, on a narrow rail head: lambda = 0.05, L = 2 pi sqrt(e r / (2 lambda)).
        case = rollfem.Case(CASES / "manchester_A22.toml").with_(
            {"wheel.profile": "polynomial", "wheel_profile.coefficients": [0.0, -0.05], "wheel_profile.limits": [-60.0, 60.0],
             "rail.profile": "arcs", "rail_profile.radii": [20.0], "rail_profile.ends": [15.0],
             "rail_profile.symmetric": True, "track.inclination": 0.0, "track.gauge_height": 5.0,
             "wheelset.lateral_shift": 0.0, "wheelset.yaw": 0.0, "wheelset.roll": 0.0})
        found = rollfem.wheelset(case, reach=3.0)
        inner = slice(1, None)
        np.testing.assert_allclose(found.conicity_wave[inner], 0.05, rtol=1e-4)
        np.testing.assert_allclose(found.conicity_harmonic[inner], 0.05, rtol=1e-4)
        np.testing.assert_allclose(found.radius_difference, 2 * 0.05 * found.lateral_shift, atol=1e-5)
        radius, distance = case["wheel.rolling_radius"], 1500.0  # on a gauge of 1435 mm
        length = 2 * math.pi * math.sqrt(distance * radius / (2 * 0.05))
        np.testing.assert_allclose(found.wave_length[inner], length, rtol=1e-4)

    def test_numbers_are_those_of_the_program(self):
        case = CASES / "manchester_A22.toml"
        with tempfile.TemporaryDirectory() as folder:
            run("wheelset", case, "-o", folder)
            rows = rows_of(f"{folder}/wheelset.csv")
        found = rollfem.wheelset(case)
        for name, values in found.columns().items():
            there = np.array([float(text or "nan") for text in rows[name]])
            np.testing.assert_allclose(values, there, rtol=1e-12, err_msg=name)
        self.assertIn("</svg>", found.figure().svg())

    def test_no_empty_panel_for_a_wheelset_without_a_wave(self):
        found = rollfem.wheelset(CASES / "manchester_A22.toml", reach=2.0)
        whole = found.figure()
        found.conicity_wave, found.wave_length = (np.full_like(found.roll, np.nan) for _ in range(2))
        hollow = found.figure()
        self.assertEqual((len(whole.panels), len(hollow.panels)), (4, 3))
        self.assertNotIn("conicity, wave", [entry[0] for entry in hollow.legend])

    def test_contact_points_are_where_the_solution_has_its_patches(self):
        case = rollfem.Case(CASES / "s1002_uic60_left.toml").with_(contact_grid={"elements_across": 8})
        places = rollfem.contact_points(case)
        self.assertEqual(places[0]["patch"], 1)
        solved = rollfem.solve(case, model="hertz")[0].place
        for name in ("contact_angle", "rolling_radius", "y_rail", "y_wheel"):
            self.assertAlmostEqual(places[0][name], solved[name], 6, name)
        self.assertRaises(rollfem.InputError, rollfem.contact_points, SMALL)
        self.assertRaises(rollfem.InputError, rollfem.wheelset, SMALL)


class Profiles(unittest.TestCase):
    def test_a_measured_arc_is_mended_to_its_radius(self):
        # Points of a head of 300 mm, upward and in inches, with a duplicate.
        y = np.linspace(-30.0, 30.0, 121)
        z = 300.0 - np.sqrt(300.0**2 - y**2)
        points = np.stack([y, -z], axis=1) / 25.4
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "worn.txt")
            np.savetxt(file, np.insert(points, 40, points[40], axis=0), "%.9f")
            with self.assertRaisesRegex(rollfem.InputError, "drop_duplicates"):
                rollfem.Profile(file, "rail", unit="inch", flip=True)
            profile = rollfem.Profile(file, "rail", unit="inch", flip=True, drop_duplicates=True)
            again = rollfem.Profile(profile.write(os.path.join(folder, "mended.csv")), "rail")
        self.assertEqual(profile.points, 121)
        middle = abs(profile.y) < 25.0
        np.testing.assert_allclose(profile.curvature[middle], 1 / 300.0, rtol=2e-3)
        self.assertAlmostEqual(profile.length, 2 * 300.0 * math.asin(0.1), 4)
        np.testing.assert_allclose(np.interp(5.0, again.y, again.z), 300.0 - math.sqrt(300.0**2 - 25.0), atol=2e-5)

    def test_rows_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            run("profile", "S1002", "-o", folder)
            there = np.genfromtxt(f"{folder}/profile.csv", delimiter=",", skip_header=2)
        profile = rollfem.Profile("S1002")
        self.assertEqual(profile.body, "wheel")
        np.testing.assert_allclose(np.stack(list(profile.columns().values()), axis=1), there, rtol=1e-7, atol=1e-6)
        self.assertIn("</svg>", profile.figure().svg())
        for axes in (profile.plot(), profile.plot_curvature()):
            self.assertEqual(len(axes.lines), 1)
        self.assertRaises(rollfem.InputError, rollfem.Profile, "worn.txt")


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_a_study_tends_to_hertz(self):
        study = rollfem.study(SMALL, levels=3, vary="grid")
        rows = study.columns()
        pressure = (rows["quantity"] == "max_pressure") & (rows["model"] == "halfspace")
        # Second order, against the closed form.
        orders = rows["order [-]"][pressure]
        self.assertAlmostEqual(orders[-1], 2.0, delta=0.5)
        self.assertIn("</svg>", study.figure("error_unknowns").svg())
        study.write(self.path("study"))
        self.assertEqual(rollfem.read(self.path("study")).data, study.data)
        with self.assertRaisesRegex(rollfem.InputError, "^levels 99"):
            rollfem.study(SMALL, levels=99)

    def test_a_comparison_lists_what_is_missing(self):
        comparison = rollfem.compare({"circle": rollfem.Case(SMALL).with_(longitudinal_creepage=0.002, spin=1e-4)},
                                     models=["hertz", "carter", "fastsim", "halfspace"])
        result = comparison.results["circle"]
        self.assertEqual([name for name, _, failed in result.missing if not failed], ["carter"])
        self.assertEqual([model.name for model in result], ["hertz", "fastsim", "halfspace"])
        rows = comparison.columns()
        exact = rows["value"][(rows["model"] == "hertz") & (rows["quantity"] == "max_pressure")].astype(float)
        self.assertEqual(exact[0], result["hertz"].max_pressure[0])
        comparison.write(self.path("compared"))
        read = rollfem.read(self.path("compared"))
        self.assertEqual(read.results["circle"]["fastsim"].longitudinal_force[0], result["fastsim"].longitudinal_force[0])
        self.assertRaises(rollfem.InputError, rollfem.compare, SMALL, models=["hertz"], reference="fem")

    def test_stresses_of_a_result_are_stored_and_read(self):
        result = rollfem.solve(SMALL, model="halfspace")
        result.write(self.path("stored"))
        stored = rollfem.stress(self.path("stored"), yield_strength=500.0)
        self.assertIn("</svg>", stored.figure("shakedown_map").svg())
        stored.write(self.path("stress"))
        again = rollfem.read(self.path("stress"))
        self.assertEqual([s.name for s in again.models[0].sets], [s.name for s in stored.models[0].sets])
        with self.assertRaisesRegex(rollfem.InputError, "^point 7"):
            rollfem.stress(result, point_index=6)

    def test_a_table_is_filled_with_progress_as_by_the_program(self):
        case = rollfem.Case(SMALL, table={"axis_ratio": [0.5, 2.0], "points": [3, 3, 3], "largest": [2.0, 2.0, 2.0],
                                          "check_points": 10})
        seen = []
        table = rollfem.table(case, progress=lambda event: seen.append((event.point, event.points)))
        self.assertEqual(seen[-1][0], seen[-1][1])
        run("table", case.write(self.path("case.toml")), "-o", self.path("of_program"), "--no-report", "-q")
        table.write(self.path("table"))
        for folder in ("table", "of_program"):
            read = rollfem.read(self.path(folder))
            np.testing.assert_array_equal(read.longitudinal_force, table.longitudinal_force)
            np.testing.assert_array_equal(read.force_bar, table.force_bar)

        def stop(event):
            raise KeyError(event.stage)
        self.assertRaises(KeyError, rollfem.table, case, progress=stop)


class Shown(unittest.TestCase):
    def test_figures_are_those_of_the_report(self):
        result = rollfem.solve(SMALL, models=["fastsim", "halfspace"], longitudinal_creepage=[0.0, 0.001, 0.004])
        placed = rollfem.solve(CASES / "s1002_uic60_left.toml", model="halfspace", contact_grid={"elements_across": 8})
        with tempfile.TemporaryDirectory() as folder:
            for name, each in (("run", result), ("placed", placed)):
                each.write(f"{folder}/{name}", report=True)
                drawn = list(pathlib.Path(folder, name, "figures").iterdir())
                self.assertGreater(len(drawn), 5)
                for path in drawn:
                    self.assertEqual(path.read_text(encoding="utf-8"), each.figure(path.stem).svg(), path.name)
            self.assertEqual(rollfem.read(f"{folder}/run").figure("path_x").svg(), result.figure("path_x").svg())
        with self.assertRaisesRegex(KeyError, "path_x"):
            result.figure("nothing")
        self.assertEqual(result.columns()["point_index"].tolist(), [0, 1, 2, 0, 1, 2])

    def test_stored_results_are_read_and_drawn_without_the_compiled_module(self):
        result = rollfem.solve(SMALL, model="fastsim", longitudinal_creepage=[0.0, 0.002])
        script = ("import sys, rollfem\nfrom rollfem.reader import read_result\n"
                  "print(read_result(sys.argv[1])['fastsim'].nearest(0.002)['traction_coefficient'])\n"
                  "try:\n    rollfem.solve\nexcept ImportError as error:\n    print(error)")
        with tempfile.TemporaryDirectory() as folder:
            result.write(folder)
            alone = {**os.environ, "PYTHONPATH": os.fspath(ROOT / "postprocess")}  # sources only
            said = [subprocess.run([sys.executable, *arguments, folder], env=alone, check=True, capture_output=True, text=True).stdout
                    for arguments in (["-c", script], ["-m", "rollfem"])]
            self.assertIn("creep_curve.svg", os.listdir(f"{folder}/figures"))
        number, message = said[0].splitlines()
        self.assertEqual(float(number), result.points[1].traction_coefficient)
        self.assertIn("ROLLFEM_PYTHON=ON", message)

    def test_notebooks_show_numbers(self):
        result = rollfem.solve(SMALL, model="hertz")
        sweep = rollfem.sweep(SMALL, spin=[0.0, 1e-4], model="fastsim")
        for thing in (result, result[0], result.case, sweep, rollfem.Profile("S1002"),
                      rollfem.wheelset(CASES / "manchester_A22.toml", reach=2.0)):
            self.assertIn("</", thing._repr_html_())
        self.assertIn(f"{result.points[0].max_pressure:.4g}", result._repr_html_())

    def test_labelled_arrays_have_units(self):
        result = rollfem.solve(SMALL, model="halfspace", longitudinal_creepage=[0.0, 0.001])
        sweep = rollfem.sweep(SMALL, spin=[0.0, 1e-4], model="fastsim")
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.assertRaisesRegex(ImportError, "python3-xarray", result[0].to_xarray)
            self.skipTest("needs xarray")
        data = result[0].to_xarray()
        self.assertEqual((data.pressure.dims, data.pressure.attrs["units"]), (("point_index", "y", "x"), "MPa"))
        np.testing.assert_array_equal(data.pressure[1], result.points[1].pressure)
        self.assertEqual(sweep.to_xarray().longitudinal_force.sel(spin=1e-4).item(), sweep.longitudinal_force[1])

    def test_public_functions_say_what_they_take_and_give(self):
        # Types stand in the signature; what returns a class of rollfem needs no more words.
        for where, function in self.functions():
            text, signature = inspect.getdoc(function) or "", inspect.signature(function, eval_str=True)
            self.assertRegex(text, r"(?m)^>>> ", where)
            if getattr(signature.return_annotation, "__name__", None) not in rollfem.__all__:
                self.assertRegex(text, r"(?m)^Returns:\n    \w", where)
            section = re.search(r"(?m)^Args:\n((?:    .+\n?)+)", text)
            entries = dict(re.findall(r"(?m)^    ([\w, *]+): (.+(?:\n     .+)*)$", section[1] if section else ""))
            said = {name.strip(" *"): words for names, words in entries.items() for name in names.split(",")}
            for name, parameter in signature.parameters.items():
                if name != "self":
                    self.assertIn(name, said, where)
                    self.assertIsNot(parameter.annotation, parameter.empty, f"{where}: the type of {name}")
                if re.search("float|ArrayLike|_SupportsArray", str(parameter.annotation)):
                    self.assertRegex(said[name], r"(?<!\w)(mm|N|MPa|rad|s|-)(?!\w)", f"{where}: the unit of {name}")

    @staticmethod
    def functions():
        """(name, function) of the package, but properties and what displays something."""
        short = {"models", "Progress", "InputError", "FileError", "SolveError", "AccuracyWarning", "UnitWarning", "TableForces"}
        for name in rollfem.__all__:
            thing = getattr(rollfem, name)
            if inspect.isfunction(thing) and name not in short:
                yield name, thing
            if inspect.isclass(thing) and name not in short:
                for each, method in inspect.getmembers(thing, inspect.isfunction):
                    if not each.startswith(("_", "of", "plot")) and method.__doc__:
                        yield f"{name}.{each}", method


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
