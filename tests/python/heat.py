#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heat below the surface against integrals of its own, and through the package.
Call: heat.py SOURCE_FOLDER PROGRAM; rollfem is found by PYTHONPATH."""
import sys
import tempfile
import types
import unittest

import numpy as np

import rollfem
from rollfem.heat import HeatedBody

CASE = rollfem.Case(load={"normal_force": 100e3}, friction={"coefficient": 0.3}, wheel={"rolling_radius": 460.0, "transverse_radius": np.inf},
                    rail={"transverse_radius": 300.0}, rolling={"longitudinal_creepage": 0.02, "speed": 30e3},
                    rail_heat={"temperature": 20.0}, contact_grid={"elements_across": 24})
SOURCE = sys.argv[1] if len(sys.argv) > 1 else "."
EFFUSIVITY, DIFFUSIVITY, SPEED = 13.29, 14.0, 30e3


class Below(unittest.TestCase):
    def test_heat_that_has_gone_in_is_the_integral_of_its_flow(self):
        # f(t') exp(-z^2/(4 kappa (t - t'))) / (beta sqrt(pi (t - t'))) over the time since contact, for a flow that falls along x.
        count, dx = 400, 0.025
        grid = types.SimpleNamespace(x=-5 + dx * (np.arange(count) + 0.5), y=np.zeros(1), dx=dx, dy=1.0)
        flow = 1e5 * (1 + grid.x / 10)
        edges = np.sqrt(np.concatenate([[0.0], np.arange(count) + 0.5]) * dx / SPEED)
        weights = 2 * np.diff(edges) / np.sqrt(np.pi) / EFFUSIVITY
        surface = np.array([[weights[:count - i] @ flow[i:] for i in range(count)]])
        body = HeatedBody((EFFUSIVITY, DIFFUSIVITY, 0.0, 1.2e-5, SPEED), (210e3, 0.3), grid, surface)
        i = 60
        for depth in (0.0, 0.005, 0.02, 0.1, 0.4):
            # s = sqrt(t - t') takes the root away.
            s = np.sqrt((5 - grid.x[i]) / SPEED) * (np.arange(200000) + 0.5) / 200000
            there = 1e5 * (1 + (grid.x[i] + SPEED * s**2) / 10)
            exact = np.sum(there * np.exp(-depth**2 / (4 * DIFFUSIVITY * s**2))) * 2 * (s[1] - s[0]) / np.sqrt(np.pi) / EFFUSIVITY
            found = body.rise(np.array([[grid.x[i], 0.0, -depth]]))[0]
            self.assertAlmostEqual(found / exact, 1.0, delta=1e-4 if exact > 1 else 1e-2)
        # Behind the grid it goes on, as the material that has passed it cools down; ahead it is cold, and between elements it is linear.
        for depth in (0.0, 0.1):
            since = (5 - -6.0) / SPEED
            t = since - 10 / SPEED * (np.arange(200000) + 0.5) / 200000  # since the flow
            there = 1e5 * (1 + (SPEED * t - 6) / 10)
            exact = np.sum(there * np.exp(-depth**2 / (4 * DIFFUSIVITY * t)) / np.sqrt(t)) * 10 / SPEED / 200000 / np.sqrt(np.pi) / EFFUSIVITY
            self.assertAlmostEqual(body.rise(np.array([[-6.0, 0.0, depth]]))[0] / exact, 1.0, delta=2e-3)
        self.assertEqual(body.rise(np.array([[7.0, 0.0, 0.0]]))[0], 0.0)
        both = body.rise(np.array([[grid.x[i] + share * dx, 0.0, -0.01] for share in (0.0, 0.5, 1.0)]))
        self.assertAlmostEqual(both[1], 0.5 * (both[0] + both[2]), places=6)
        stress = body.stress(np.array([100.0]))[0]
        self.assertAlmostEqual(stress[0], -210e3 * 1.2e-5 * 100 / 0.7)
        self.assertEqual(stress[0], stress[1])
        self.assertFalse(stress[2:].any())

    def test_stresses_have_the_thermal_part(self):
        hot = rollfem.solve(CASE, model="halfspace")
        cold = rollfem.solve(CASE, model="halfspace", rail_heat={"temperature": 20.0, "expansion": 0.0}, wheel_heat={"expansion": 0.0})
        point = hot.models[0].points[0]
        made = [rollfem.stress(result, yield_shear_stress=300.0) for result in (hot, cold)]
        for body in ("wheel", "rail"):
            warm, plain = (each.models[0].set("depth_hottest", body) for each in made)
            self.assertAlmostEqual(warm["temperature"][0], point["max_temperature"], places=6)
            thermal = -210e3 * 1.2e-5 / 0.7 * (warm["temperature"] - 20)
            np.testing.assert_allclose(warm["xx"] - plain["xx"], thermal, rtol=1e-9, atol=1e-9)
            np.testing.assert_allclose(warm["zz"], plain["zz"], rtol=1e-12)
            self.assertLess(warm["temperature"][-1] - 20, 1e-3 * (warm["temperature"][0] - 20))
        # Results say what their own stresses leave out.
        named = rollfem.solve(CASE.with_(output={"stress_maxima": True}), model="halfspace").models[0]
        [note] = [each for each in named.notes if each.about == "thermal_stress"]
        left_out = 210e3 * 1.2e-5 / 0.7 * (named.points[0]["max_temperature"] - 20)
        self.assertIn(f"up to {left_out:.0f} MPa", note.text)
        self.assertFalse([each for each in (*hot.models[0].notes, *cold.models[0].notes) if each.about == "thermal_stress"])
        ranges = [each.data["models"][0]["shakedown"][0]["heated_range"] for each in made]
        self.assertGreater(abs(ranges[0] - ranges[1]), 0.0)

    def test_steps_reach_steady_rolling(self):
        # Closed for a state that stays in full sliding, whatever the length of the steps; friction by temperature with a memory.
        law = {"coefficient": 0.36, "law": "temperature", "hot_temperature": 300.0, "hot_coefficient": 0.12, "memory_distance": 0.05}
        for friction, allowed in (({"coefficient": 0.3}, 2e-3), (law, 2e-2)):
            case = CASE.with_(friction=friction)
            dx = rollfem.solve(case, model="halfspace").models[0].dx
            for length, sign in ((dx, 1), (2 * dx, -1)):
                # The wheel that runs the other way about y is its mirror image.
                more = {"lateral_creepage": 0.003 * sign, "spin": 1e-4 * sign}
                rolled = rollfem.solve(case.with_(rolling={**more, "longitudinal_creepage": [0.02] * int(18 / length), "speed": 30e3,
                                                           "problem": "transient"}, history={"step_length": length}), model="halfspace").models[0]
                alike = rollfem.solve(case.with_(rolling={**more, "longitudinal_creepage": 0.02, "speed": 30e3}), model="halfspace").models[0]
                last, end = rolled.points[-1], alike.points[0]
                self.assertLess(rolled.points[0]["max_temperature"] - 20, 0.3 * (last["max_temperature"] - 20))
                self.assertAlmostEqual((last["max_temperature"] - 20) / (end["max_temperature"] - 20), 1.0, delta=allowed)
                self.assertAlmostEqual(last["longitudinal_force"] / end["longitudinal_force"], 1.0, delta=allowed)
                self.assertAlmostEqual(last["max_temperature_y"], end["max_temperature_y"], delta=alike.dy * 1.01)
                # Heat in is the work of friction: tractions times slip.
                point = last.fields
                work = -(point["traction_x"] * point["slip_x"] + point["traction_y"] * point["slip_y"]).sum() * rolled.dx * rolled.dy
                self.assertAlmostEqual((last["heat_wheel"] + last["heat_rail"]) / work, 1.0, delta=1e-9)
                self.assertLess(abs(last["max_temperature"] - end["max_temperature"]), last.bar("max_temperature") + end.bar("max_temperature"))

    def test_wheels_that_move_reach_it_too(self):
        # Positions that stay are steady rolling in the end; the other wheel is the mirror image.
        ends = []
        for side, sign, length in (("left", 1, 0.9), ("right", -1, 0.9), ("left", 1, 2.5)):
            case = rollfem.Case(f"{SOURCE}/cases/s1002_uic60_left.toml").with_(
                friction={"coefficient": 0.3}, wheelset={"side": side, "lateral_shift": 2.0 * sign}, rail_heat={"temperature": 20.0},
                wheel_heat={"temperature": 60.0}, elements_across=10, rolling={"speed": 20e3, "longitudinal_creepage": 0.02}, output={"paths": []})
            steady = rollfem.solve(case, model="halfspace").models[0].points[0]
            moving = case.with_(wheelset={"side": side, "lateral_shift": [2.0 * sign] * int(30 / length)},
                                rolling={"problem": "transient", "speed": 20e3, "longitudinal_creepage": 0.02}, history={"step_length": length})
            first, last = (model.points[0] for model in rollfem.solve(moving, model="halfspace").models[::int(30 / length) - 1])
            self.assertLess(first["max_temperature"] - 40, 0.5 * (last["max_temperature"] - 40))
            self.assertAlmostEqual((last["max_temperature"] - 40) / (steady["max_temperature"] - 40), 1.0, delta=0.02)
            self.assertAlmostEqual((last["heat_wheel"] + last["heat_rail"]) / steady["frictional_work"], 1.0, delta=0.02)
            ends.append(last["max_temperature"])
        self.assertAlmostEqual(ends[0], ends[1], delta=0.01)

    SMALL = {"axis_ratio": [1.3293], "longitudinal_values": [0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.5, 5.0, 8.0, 12.0], "points": [2, 2, 2], "lateral_values": [0.0, 1.0],
             "spin_values": [0.0, 1.0], "check_points": 0}

    def test_tables_hold_the_rise_at_any_load_and_speed(self):
        made = rollfem.table(CASE.with_(table=self.SMALL))
        with tempfile.TemporaryDirectory() as folder:
            made.write(folder)
            table = rollfem.Table(folder)
        self.assertEqual(table.heat["speed"], 30e3)
        # Full sliding: 0.5 mu p0 xi V sqrt(a/V) / (beta sqrt(pi)) 2.1883, both of steel.
        for load, speed, xi in ((50e3, 10e3, 0.05), (120e3, 40e3, -0.1)):
            point = rollfem.solve(CASE.with_(load={"normal_force": load}), model="hertz").models[0].points[0]
            a, b = point["semi_axis_x"], point["semi_axis_y"]
            exact = 0.5 * 0.3 * 1.5 * load / (np.pi * a * b) * abs(xi) * speed * np.sqrt(a / speed) / (EFFUSIVITY * np.sqrt(np.pi)) * 2.1883
            found = table.forces(semi_axis_x=a, semi_axis_y=b, shear_modulus=210e3 / 2.6, friction_bound=0.3 * load, speed=speed,
                                 longitudinal_creepage=xi)
            self.assertAlmostEqual(found.temperature_rise / exact, 1.0, delta=0.02)
            other = table.forces(semi_axis_x=a, semi_axis_y=b, shear_modulus=70e3, friction_bound=0.3 * load, longitudinal_creepage=xi)
            self.assertTrue(np.isnan(other.temperature_rise))

    def test_tables_of_friction_by_temperature_are_of_any_body(self):
        law = {"coefficient": 0.36, "law": "temperature", "hot_temperature": 300.0, "hot_coefficient": 0.12}
        case = CASE.with_(friction=law)
        table = rollfem.table(case.with_(table={**self.SMALL, "speed": [5e3, 10e3, 20e3, 40e3]}))
        self.assertIn("friction by temperature", table.only_for)
        # Bodies of half the size under another load have the friction of those of the table at another speed.
        for size, load, speed, xi in ((1.0, 100e3, 30e3, 0.003), (0.5, 30e3, 20e3, 0.02)):
            point = rollfem.solve(case.with_(load={"normal_force": load}, wheel={"rolling_radius": 460 * size, "transverse_radius": np.inf},
                                             rail={"transverse_radius": 300 * size}, rolling={"longitudinal_creepage": xi, "speed": speed}),
                                  model="halfspace").models[0].points[0]
            hertz = {name: point[name] for name in ("semi_axis_x", "semi_axis_y")}
            found = table.forces(**hertz, shear_modulus=210e3 / 2.6, friction_bound=0.36 * load, speed=speed, longitudinal_creepage=xi)
            self.assertLess(abs(point["longitudinal_force"] - found.longitudinal_force), 0.012 * 0.36 * load)
            self.assertAlmostEqual((point["max_temperature"] - 20) / found.temperature_rise, 1.0, delta=0.04)

    def test_tables_of_a_wheel_have_the_rise_on_both_sides(self):
        found = []
        for side, sign in (("left", 1), ("right", -1)):
            case = rollfem.Case(f"{SOURCE}/cases/s1002_uic60_left.toml").with_(
                wheelset={"side": side}, rail_heat={"temperature": 20.0}, elements_across=12, rolling={"speed": 20e3},
                table={"lateral_shift": [2.0 * sign], "longitudinal_values": [0.0, 1.0, 3.0], "lateral_values": [0.0, 1.0],
                       "spin_values": [0.0, 1.0], "check_points": 0})
            table = rollfem.table(case)
            found.append(table.forces(lateral_shift=2.0 * sign, longitudinal_creepage=[0.002, 0.01], speed=10e3))
            here = rollfem.solve(case.with_(wheelset={"side": side, "lateral_shift": 2.0 * sign},
                                            rolling={"speed": 10e3, "longitudinal_creepage": [0.002, 0.01]}), model="halfspace")
            rise = np.array([point["max_temperature"] - 20 for point in here.models[0].points])
            np.testing.assert_array_less(np.abs(found[-1].temperature_rise / rise - 1), [0.15, 0.02])
        np.testing.assert_allclose(found[0].temperature_rise, found[1].temperature_rise, rtol=2e-3)

    def test_mirror_images_and_models_agree(self):
        more = {"lateral_creepage": 0.004, "spin": 2e-4, "longitudinal_creepage": 0.01, "speed": 30e3}
        one = rollfem.solve(CASE, model="halfspace", rolling=more).models[0].points[0]
        other = rollfem.solve(CASE, model="halfspace", rolling={**more, "lateral_creepage": -0.004, "spin": -2e-4}).models[0].points[0]
        self.assertAlmostEqual(one["max_temperature"], other["max_temperature"], places=4)
        self.assertAlmostEqual(one["max_temperature_y"], -other["max_temperature_y"], places=9)
        strip = rollfem.solve(CASE, model="strip", rolling=more).models[0].points[0]
        self.assertAlmostEqual((strip["max_temperature"] - 20) / (one["max_temperature"] - 20), 1.0, delta=0.25)
        self.assertEqual(strip.no_bar["max_temperature"], "one grid")
        for point in (one, other, strip):
            self.assertAlmostEqual(point["heat_wheel"] + point["heat_rail"], point["frictional_work"], delta=2e-5 * point["frictional_work"])


if __name__ == "__main__":
    unittest.main(argv=["heat"])
