#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""rollfem.wear: laws against hand calculation and their sources, the removed area after smoothing and new points, a
cylinder that stays one, the order in steps and grid, and examples/wear_in_python in short. Call: wear.py SOURCE_FOLDER"""
import json
import math
import pathlib
import sys
import tempfile
import unittest
import warnings
from unittest import mock

import numpy as np

import rollfem
from rollfem import wear

ROOT = pathlib.Path(sys.argv[1]).resolve()
WIDE = {"load": {"normal_force": 60e3}, "friction": {"coefficient": 0.3},
        "wheel": {"rolling_radius": 460.0, "transverse_radius": math.inf}, "rail": {"transverse_radius": 300.0}}
PAIR = {"load": {"vertical_force": 60e3}, "friction": {"coefficient": 0.3}, "track": {"inclination": "1:40"},
        "wheel": {"rolling_radius": 460.0, "profile": "S1002"}, "rail": {"profile": "60E1"},
        "wheelset": {"side": "both", "rotation_change": 1e-3}}


def sliding(work, pressure=1000.0, slip=0.01, speed=0.0):
    work = np.atleast_2d(np.asarray(work, dtype=float))
    return wear.Sliding(np.full_like(work, pressure), work, np.full_like(work, slip), speed)


class Laws(unittest.TestCase):
    def test_work_in_regimes_at_the_limits_of_the_tests(self):
        law = wear.WorkInRegimes()
        np.testing.assert_allclose(law.per_metre(np.array([0.0, 5.0, 10.4, 50.0, 77.2, 87.2])),
                                   [0.0, 26.5, 55.12, 55.0, 55.0, 55.0 + 619.0], rtol=1e-12)
        # 61.9 I - 4778.7 + 55.0, as the constant is printed: 4778.7 is 61.9 times 77.2.
        self.assertAlmostEqual(float(law.per_metre(np.array(100.0))), 61.9 * 100.0 - 4778.7 + 55.0, delta=0.05)

    def test_one_pass_of_one_element_by_hand(self):
        # 5 N/mm^2: 26.5 micrograms a metre and mm^2; 1 mm^2 of surface stays for 0.5 mm under an element of 0.5 mm.
        removal = wear.WorkInRegimes(density=7800.0)(sliding(5.0))
        self.assertAlmostEqual(float(removal[0, 0]) * 0.5, 26.5 / 1000.0 * 0.5 / 7800.0, delta=1e-18)
        self.assertAlmostEqual(float(wear.WorkInRegimes(factor=0.25)(sliding(5.0))[0, 0] / removal[0, 0]), 0.25)
        # In the mild regime the law is one of a constant coefficient.
        np.testing.assert_allclose(wear.ConstantCoefficient()(sliding([3.0, 9.0])), wear.WorkInRegimes()(sliding([3.0, 9.0])))

    def test_archard_takes_its_coefficient_from_the_map(self):
        law = wear.Archard(hardness=2500.0)
        pressure, velocity = np.array([1000.0, 1000.0, 1000.0, 2100.0]), np.array([100.0, 400.0, 800.0, 400.0])
        np.testing.assert_allclose(law.coefficient(pressure, velocity), [5.5e-4, 35e-4, 5.5e-4, 350e-4])
        # k p s / H: 35e-4 at 1 % of 40 m/s.
        self.assertAlmostEqual(float(law(sliding(1.0, speed=40e3))[0, 0]), 35e-4 * 1000.0 * 0.01 / 2500.0, delta=1e-15)
        with self.assertRaisesRegex(rollfem.InputError, "speed="):
            law(sliding(1.0))

    def test_names_the_hottest_place_and_warns_where_steel_transforms(self):
        case = rollfem.Case(**{**PAIR, "rolling": {"speed": 40e3}, "rail_heat": {"temperature": 20.0}, "contact_grid": {"elements_across": 10}})
        hot = rollfem.solve(case.with_(wheelset={"side": "both", "rotation_change": 0.2}), model="halfspace")
        mild = rollfem.solve(case, model="halfspace")
        found = wear.hottest(mild.models)
        self.assertEqual(len(found), len(mild.models))
        for model in mild.models:
            point, here = model.points[0], found[model.key]
            self.assertAlmostEqual(here["temperature"], point.temperature_rail[point.pressure > 0].max())
            self.assertLess(abs(here["y_rail"] - model.place["y_rail"]), 10.0)
        # The mirror image has the same temperature.
        left, right = (each["temperature"] for each in found.values())
        self.assertAlmostEqual(left, right, delta=1e-3 * left)
        for model in hot.models:
            with self.assertWarnsRegex(wear.HotSurfaceWarning, "above 700 degC steel transforms"):
                wear.depth_of_pass(model, wear.ConstantCoefficient())
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            seen = []
            wear.depth_of_pass(mild.models[0], lambda at: seen.append(at.temperature) or 0 * at.work)
            self.assertAlmostEqual(seen[0].max(), left)
            wear.depth_of_pass(rollfem.solve(case.with_(wheelset={"side": "both", "rotation_change": 0.2}, rail_heat={"limit": 9e3},
                                                        wheel_heat={"limit": 9e3}), model="halfspace").models[0], wear.ConstantCoefficient())
        with self.assertWarns(wear.HotSurfaceWarning):
            wear.depth_of_pass(rollfem.solve(case.with_(wheel_heat={"limit": 21.0}), model="halfspace").models[0], wear.ConstantCoefficient())
        self.assertEqual(wear.hottest(rollfem.solve(WIDE, model="halfspace").models), {})

    def test_beyond_the_range_of_the_tests_a_law_warns(self):
        with self.assertWarnsRegex(wear.WearRangeWarning, "work per area of 200 N/mm.2 is beyond 121"):
            wear.WorkInRegimes()(sliding(200.0))
        with self.assertWarnsRegex(wear.WearRangeWarning, "sliding velocity"):
            wear.Archard(hardness=2500.0)(sliding(1.0, slip=0.1, speed=20e3))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            wear.WorkInRegimes()(sliding(100.0))


class Depths(unittest.TestCase):
    def test_constant_coefficient_gives_the_work_per_pass(self):
        result = rollfem.solve(WIDE, model="halfspace", longitudinal_creepage=0.003, elements_across=16)
        model, point = result["halfspace"], result.points[0]
        depth = wear.depth_of_pass(model, wear.ConstantCoefficient(2e-6))
        np.testing.assert_allclose(depth, 2e-6 * point.pass_work, rtol=1e-5, atol=1e-12)
        self.assertAlmostEqual(float(point.pass_work @ model.width) / point.frictional_work, 1.0, 12)
        self.assertAlmostEqual(point.max_pass_work, point.pass_work.max(), 12)
        self.assertAlmostEqual(point.revolution_work, 1e-3 * point.frictional_work * 2 * math.pi * 460.0, 9)
        np.testing.assert_array_equal(model.y_wheel, model.y)
        # A law of one's own is a function.
        np.testing.assert_allclose(wear.depth_of_pass(model, lambda at: 2e-6 * at.work), depth)
        with self.assertRaisesRegex(rollfem.InputError, "every element"):
            wear.depth_of_pass(model, lambda at: -at.work)
        with self.assertRaisesRegex(rollfem.InputError, "without slip"):
            wear.depth_of_pass(rollfem.solve(WIDE, model="hertz")["hertz"], wear.WorkInRegimes())

    def test_a_slip_zone_within_an_element_wears_by_the_work_of_the_creep_force(self):
        model = rollfem.solve(WIDE, model="halfspace", longitudinal_creepage=1e-5, elements_across=12)["halfspace"]
        point = model.points[0]
        work = -1e-5 * point.longitudinal_force
        self.assertFalse((point.state == 2).any())
        depth = wear.depth_of_pass(model, wear.ConstantCoefficient(2e-6))
        self.assertAlmostEqual(float(depth @ model.width) / (2e-6 * work), 1.0, 9)
        # Archard's slip does the work under the traction that is there, so it has at least that under the bound.
        archard = wear.depth_of_pass(model, wear.Archard(hardness=2500.0), speed=1e3)
        self.assertGreater(float(archard @ model.width), 0.99 * 5.5e-4 / 2500.0 * work / 0.3)

    def test_results_that_are_read_and_pickled_have_the_same_work(self):
        import pickle
        result = rollfem.solve(WIDE, model="halfspace", longitudinal_creepage=[0.001, 0.003], elements_across=12)
        with tempfile.TemporaryDirectory() as folder:
            result.write(f"{folder}/run")
            read = rollfem.read(f"{folder}/run")
            rows = (pathlib.Path(folder) / "run/pass_work.csv").read_text().splitlines()
        for other in (read, pickle.loads(pickle.dumps(result))):
            for at, found in zip(result.points, other.points):
                np.testing.assert_array_equal(found.pass_work, at.pass_work)
            np.testing.assert_array_equal(other["halfspace"].y_rail, result["halfspace"].y_rail)
        self.assertNotIn("pass_work", read.points[0].fields)
        self.assertEqual(rows[0], "model,point,y [mm],y_wheel [mm],y_rail [mm],width [mm],pass_work [N/mm],"
                         "error_estimate [N/mm]")
        self.assertEqual(len(rows) - 1, sum(int((p.pass_work != 0).sum()) for p in result.points))

    def test_of_a_sweep_the_place_is_that_of_the_patch_that_wears_most(self):
        sweep = rollfem.sweep(rollfem.Case({**PAIR, "contact_grid": {"elements_across": 10}}).with_({"wheelset.side": "right"}),
                              {"wheelset.lateral_shift": [0.0, 5.0, 7.0]}, model="halfspace")
        for place, most, patches in zip(sweep.pass_work_y_wheel.ravel(), sweep.max_pass_work.ravel(), sweep.patches()):
            worst = max(patches, key=lambda point: point.max_pass_work)
            self.assertEqual((place, most), (worst.pass_work_y_wheel, worst.max_pass_work))

    def test_area_of_both_wheels_and_all_patches_is_the_depth_times_the_width(self):
        result = rollfem.solve(PAIR, model="halfspace", elements_across=12,
                               wheelset={"side": "both", "lateral_shift": [0.0, 6.0], "rotation_change": 1e-3})
        for body in ("wheel", "rail"):
            profile = wear.WornProfile.of(rollfem.Profile("S1002" if body == "wheel" else "60E1"))
            area = profile.area_of(result.models, wear.ConstantCoefficient(1.0))
            total = sum(point.frictional_work for point in result.points) if len(result.models) == 1 else \
                sum(model.points[0].frictional_work for model in result)
            self.assertAlmostEqual(area.sum() / total, 1.0, 7)
            self.assertGreaterEqual(area.min(), 0.0)
        self.assertIn("work per pass", result.figure("work_right_2").seen)
        self.assertIn("work per pass", result.figure("s1_pass_work").seen)
        self.assertTrue(all((model.points[0].pass_work_y_rail > model.y_rail.min()) for model in result))
        # In the middle both wheels wear at the same places.
        profile = wear.WornProfile.of(rollfem.Profile("S1002"))
        left, right = (sum(profile.area_of_pass(m, m.points[0].pass_work) for m in result
                           if (m.place["wheel"], m.place["position"]) == (side, 1)) for side in ("left", "right"))
        np.testing.assert_allclose(left, right, atol=1e-3 * left.max())
        short = wear.WornProfile(np.linspace(20.0, 60.0, 201), np.zeros(201), "wheel")
        with self.assertRaisesRegex(rollfem.InputError, "beyond the wheel's profile"):
            short.area_of(result.models, wear.WorkInRegimes())


    def test_a_worn_root_that_planes_do_not_fit_wears_on(self):
        # Worn by 0.5 mm, less around y = -22: contacts at tread and root, 0.38 rad apart, grow into each other.
        whole = wear.WornProfile.of(rollfem.Profile("S1002"))
        worn = wear.WornProfile(whole.y, whole.z + 0.2 * np.exp(-((whole.y + 22.0) / 5.0) ** 2)
                                - 0.5 / (1.0 + np.exp(-(whole.y + 33.4))), "wheel")
        with tempfile.TemporaryDirectory() as folder:
            for side, sign in (("left", -1.0), ("right", 1.0)):
                case = rollfem.Case(PAIR).with_({
                    "load.vertical_force": 100e3, "wheel.profile": worn.write(f"{folder}/worn.csv"),
                    "contact_grid.elements_across": 10,
                    "wheelset": {"side": side, "lateral_shift": 5.87 * sign, "roll": 0.0, "rotation_change": 0.0}})
                with self.assertRaisesRegex(rollfem.SolveError, "another contact of the same wheel"):
                    rollfem.solve(case.with_({"halfspace.surface": "planar"}), model="halfspace")
                result = rollfem.solve(case, model="halfspace")
                area = worn.area_of(result.models, wear.ConstantCoefficient(1.0))
                self.assertAlmostEqual(area.sum() / result.models[0].points[0].frictional_work, 1.0, 6)
                self.assertTrue(any(note.about == "surface" for note in result.models[0].notes))


def bump(profile, middle, half, depth):
    """Areas of a smooth wear scar."""
    share = np.clip(np.abs(profile.y - middle) / half, 0.0, 1.0)
    return depth * np.cos(0.5 * np.pi * share) ** 2 * profile.widths


class Updates(unittest.TestCase):
    def test_cylinder_and_circle_worn_evenly_stay_themselves(self):
        y = np.linspace(-40.0, 40.0, 401)
        cone = wear.WornProfile(y, 0.05 * y, "wheel")
        cone = cone.worn(0.05 * cone.widths)
        self.assertLess(np.ptp(cone.z - 0.05 * cone.y), 1e-12)
        angle = np.linspace(-0.3, 0.3, 601)
        rail = wear.WornProfile(300.0 * np.sin(angle), 300.0 * (1.0 - np.cos(angle)), "rail", 0.3)
        even = rail.worn(0.05 * rail.widths)
        radius = np.hypot(even.y, even.z - 300.0)
        self.assertAlmostEqual(radius.mean(), 299.95, delta=2e-5)
        self.assertLess(np.ptp(radius), 2e-6)

    def test_removed_area_is_the_laws_after_smoothing_and_new_points(self):
        for name, middle in (("S1002", 5.0), ("S1002", -38.0), ("60E1", 0.0), ("60E1", -28.0)):
            profile = wear.WornProfile.of(rollfem.Profile(name))
            for smoothing in (0.0, 1.0, 4.0):
                area = bump(profile, middle, 6.0, 0.02)
                new = profile.worn(area, smoothing=smoothing)
                self.assertAlmostEqual(profile.area_to(new) / area.sum(), 1.0, delta=1e-9)
                # The polygon between both curves, by its corners.
                y, z = np.concatenate([profile.y, new.y[::-1]]), np.concatenate([profile.z, new.z[::-1]])
                polygon = 0.5 * abs(float(np.sum(y * np.roll(z, -1) - np.roll(y, -1) * z)))
                self.assertAlmostEqual(polygon / area.sum(), 1.0, delta=1e-8)
                self.assertLess(np.diff(new.along).std(), 1e-3)

    def test_removed_area_is_the_laws_for_single_passes_too(self):
        profile = wear.WornProfile.of(rollfem.Profile("S1002"))
        shape = bump(profile, -10.0, 6.0, 1.0)
        for total in (1e-6, 3e-5, 1e-4):
            for smoothing in (0.0, 2.0):
                new = profile.worn(shape / shape.sum() * total, smoothing=smoothing)
                self.assertAlmostEqual(profile.area_to(new) / total, 1.0, delta=1e-9)
        tiny = profile.worn(shape / shape.sum() * 1e-9)
        self.assertAlmostEqual(profile.area_to(tiny), 1e-9, delta=1e-16)

    def test_smoothing_conserves_spreads_and_makes_no_hollow(self):
        profile = wear.WornProfile.of(rollfem.Profile("S1002"))
        area = bump(profile, 0.0, 2.0, 0.1)
        smooth = profile.smoothed(area, 3.0)
        self.assertAlmostEqual(smooth.sum() / area.sum(), 1.0, 13)
        self.assertGreaterEqual(smooth.min(), 0.0)
        along = profile.along
        spread = [math.sqrt((part * (along - (part * along).sum() / part.sum()) ** 2).sum() / part.sum()) for part in (area, smooth)]
        self.assertAlmostEqual(math.sqrt(spread[1] ** 2 - spread[0] ** 2), 3.0, delta=0.01)

    def test_wear_in_many_small_steps_is_wear_in_one(self):
        # Of order 1 in the depth of a step: normals turn as the profile wears.
        profile, found = wear.WornProfile.of(rollfem.Profile("60E1")), []
        for steps in (1, 2, 4, 8):
            new = profile
            for _ in range(steps):
                new = new.worn(bump(new, -25.0, 8.0, 0.24 / steps))
            found.append(np.interp(-25.0, new.y, new.z))
        change = np.abs(np.diff(found))
        self.assertLess(change[2], 0.7 * change[1])
        self.assertLess(change[2], 2e-4)

    def test_finer_points_change_less_and_less(self):
        rail = rollfem.Profile("60E1")
        found = []
        for step in (0.8, 0.4, 0.2, 0.1):
            profile = wear.WornProfile.of(rail, step)
            new = profile.worn(bump(profile, 5.0, 10.0, 0.2))
            found.append(np.interp(5.0, new.y, new.z))
        change = np.abs(np.diff(found))
        self.assertLess(change[2], 0.5 * change[0])
        self.assertLess(change[2], 2e-4)

    def test_what_is_not_sensible_is_rejected(self):
        profile = wear.WornProfile.of(rollfem.Profile("60E1"))
        with self.assertRaisesRegex(rollfem.InputError, "shorter steps"):
            profile.worn(bump(profile, 0.0, 5.0, 1.0))
        with self.assertRaisesRegex(rollfem.InputError, "kink"):
            profile.worn(np.where(np.abs(profile.y - 0.1) < 0.15, 0.25, 0.0) * profile.widths)
        with self.assertRaisesRegex(rollfem.InputError, "for each of the"):
            profile.worn(np.zeros(3))
        self.assertIs(profile.worn(np.zeros(len(profile.y))), profile)

    def test_arguments_are_finite_and_in_their_range(self):
        rail = rollfem.Profile("60E1")
        profile = wear.WornProfile.of(rail)
        area = bump(profile, 0.0, 5.0, 0.01)
        depth_of = lambda speed: wear.depth_of_pass(None, wear.WorkInRegimes(), speed=speed)
        calls = [("smoothing", lambda value: profile.worn(area, smoothing=value), (-1.0, math.nan, math.inf, 1e4)),
                 ("smoothing", lambda value: profile.smoothed(area, value), (-1.0, math.nan, math.inf)),
                 ("largest", lambda value: profile.worn(area, largest=value), (0.0, -1.0, math.nan, math.inf)),
                 ("step", lambda value: wear.WornProfile.of(rail, value), (0.0, -1.0, 5.0, 1e3, math.nan, math.inf, "1")),
                 ("passes", lambda value: profile.area_of([], wear.WorkInRegimes(), value), (-1.0, math.nan, math.inf)),
                 ("speed", depth_of, (-1.0, math.nan, math.inf)),
                 ("distance", lambda value: wear.passes_of_wheel(value, 460.0), (-1, math.nan, math.inf)),
                 ("radius", lambda value: wear.passes_of_wheel(1.0, value), (0, -1, math.nan, math.inf)),
                 ("hardness", wear.Archard, (0.0, -1.0, math.nan, math.inf)),
                 ("factor", lambda value: wear.WorkInRegimes(factor=value), (-1.0, math.nan, math.inf)),
                 ("upper_limit", lambda value: wear.WorkInRegimes(limits=(77.2, value)), (10.4, math.nan, math.inf)),
                 ("upper_velocity", lambda value: wear.Archard(2500.0, velocities=(200.0, value)), (100.0, math.nan)),
                 ("coefficient", wear.ConstantCoefficient, (-1.0, math.nan, math.inf))]
        for name, call, wrong in calls:
            for value in wrong:
                with self.subTest(name=name, value=value), \
                        self.assertRaisesRegex(rollfem.InputError, f"wear: {name} = .*; allowed: a finite number .*; do: "):
                    call(value)
        self.assertEqual(wear.passes_of_wheel(0.0, 460.0), 0.0)

    def test_the_program_reads_what_is_written(self):
        profile = wear.WornProfile.of(rollfem.Profile("S1002"))
        new = profile.worn(bump(profile, 0.0, 15.0, 0.2))
        with tempfile.TemporaryDirectory() as folder:
            read = rollfem.Profile(new.write(f"{folder}/worn.csv"), "wheel")
        np.testing.assert_allclose(np.interp(new.y[5:-5], read.y, read.z), new.z[5:-5], atol=2e-4)
        self.assertAlmostEqual(float(np.interp(0.0, new.y, new.z)), -0.2, delta=2e-3)


class Example(unittest.TestCase):
    def test_in_short_it_wears_as_much_as_the_law_says(self):
        sys.path.insert(0, str(ROOT / "examples/wear_in_python"))
        import wear_loop
        with tempfile.TemporaryDirectory() as folder:
            call = ["wear_loop.py", "-o", folder, "--steps", "2", "--positions", "4", "--tractions", "2", "--distance", "500"]
            with mock.patch.object(sys, "argv", call):
                wear_loop.main()
            history = json.loads((pathlib.Path(folder) / "history.json").read_text())
            first, last = (np.loadtxt(f"{folder}/wheel_{step:02}.csv") for step in (0, 2))
            self.assertTrue(all((pathlib.Path(folder) / f"{name}.svg").exists() for name in ("profile", "depth", "conicity", "rate")))
        y, z = np.concatenate([first, last[::-1]]).T
        removed = -0.5 * float(np.sum((y - y[0]) * np.roll(z - z[0], -1) - np.roll(y - y[0], -1) * (z - z[0])))
        self.assertAlmostEqual(removed / (history[0]["area"] + history[1]["area"]), 1.0, delta=1e-6)
        self.assertGreater(history[2]["conicity"], 0.1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
