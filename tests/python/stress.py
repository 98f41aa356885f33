#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""rollfem.stress, `rollfem stress` and the shakedown map: closed forms, values of the literature and of CONTACT, half-space
elements, stored bodies with known stresses, wrong calls. Call: stress.py SOURCE_FOLDER PROGRAM; rollfem is found by PYTHONPATH."""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

import numpy as np

import rollfem
from module import PROGRAM
from rollfem import _core
from rollfem.node import Node
from rollfem.result import ModelResult
from rollfem.shakedown import Ellipse, circle_limits, line_limits, sliding_circle_surface, surface_fatigue_index, yield_shear_stress
from rollfem.stresses import von_mises

STEEL = {"young_modulus": 210e3, "poisson_ratio": 0.3}
P0, A, B = 578.967, 3.79236, 10.87295  # of the thesis's case a: MPa, mm
CASE_A = {"load": {"normal_force": 50e3}, "friction": {"coefficient": 0.55},
          "wheel": {"rolling_radius": 405.0, "transverse_radius": math.inf}, "rail": {"transverse_radius": 2000.0}}
# CONTACT (Vollebregt) below the middle of case a without friction: depth, displacement of the wheel (mm); von Mises, xx, yy, zz (MPa)
CONTACT = np.array([[0.5, 2.2868e-2, 214.689, -383.311, -340.510, -573.375], [1.0, 2.1976e-2, 277.423, -276.966, -283.211, -557.459],
                    [2.0, 2.0064e-2, 341.384, -137.465, -194.151, -503.644], [3.0, 1.8190e-2, 344.171, -64.6025, -132.593, -437.695],
                    [4.0, 1.6481e-2, 319.047, -28.1380, -90.6904, -373.829], [6.0, 1.3655e-2, 251.454, -1.13786, -42.7999, -270.821],
                    [8.0, 1.1514e-2, 193.498, 5.22582, -20.2541, -199.750], [12.0, 8.6137e-3, 118.350, 5.77334, -3.95558, -117.141]])


def fields(n, ratio, places):
    """Stress at places [n, 3] by the pressure and by the same traction along x, from elements on the rectangle around the
    ellipse with semi-axes 1 and `ratio` (0: the strip of half width 1) with the mean of Hertz's pressure."""
    d, line = 2.0 / n, ratio == 0.0
    x = (np.arange(n) + 0.5) * d - 1.0
    y, width = (np.zeros(1), 4000.0) if line else (ratio * x, ratio * d)
    fine = ((np.arange(16) + 0.5) / 16 - 0.5) * d
    u = (x[:, None] + fine).ravel()
    v = np.zeros(16) if line else u
    mean = np.sqrt(np.maximum(0.0, 1 - u**2 - v[:, None]**2)).reshape(len(y), 16, n, 16).mean(axis=(1, 3))
    zero = np.zeros_like(mean)
    return [_core.Loaded(x, y, d, width, 0.0, *loads).below(True, 210e3, 0.3, places)[1]
            for loads in ((mean, zero, zero), (zero, mean, zero))]


def section(x, depths):
    """Places [depth, x, 3] in the plane y = 0."""
    return np.stack(np.broadcast_arrays(x, 0.0, np.asarray(depths)[:, None]), axis=-1)


class Map(unittest.TestCase):
    def test_without_friction_the_boundaries_are_those_of_the_literature(self):
        # Johnson 1985, sections 6.1 and 9.2; Ponter, Hearle & Johnson 1985.
        self.assertAlmostEqual(line_limits(0.0).elastic, math.sqrt(3) / 0.5575, delta=3e-3)
        self.assertAlmostEqual(line_limits(0.0).shakedown, 4.0, delta=4e-3)
        self.assertAlmostEqual(circle_limits(0.0).elastic, math.sqrt(3) / 0.62004, delta=3e-3)
        self.assertAlmostEqual(circle_limits(0.0).shakedown, 4.68, delta=0.01)

    def test_with_much_friction_the_surface_decides(self):
        for friction in (0.4, 0.5, 0.6, 1.0):
            self.assertAlmostEqual(line_limits(friction).shakedown * friction, 1.0, delta=1e-3)
            self.assertAlmostEqual(circle_limits(friction).shakedown * friction, 1.0, delta=1e-6)
            self.assertLess(circle_limits(friction).elastic, circle_limits(friction).shakedown)

    def test_boundaries_fall_with_friction_and_have_no_jumps(self):
        for limits in (line_limits, circle_limits):
            found = np.array([[limits(0.01 * k).elastic, limits(0.01 * k).shakedown] for k in range(61)])
            self.assertTrue(((np.diff(found, axis=0) < 0) & (np.diff(found, axis=0) > -0.12)).all())

    def test_below_the_surface_they_are_those_of_half_space_elements(self):
        places = section(np.linspace(-1, 1, 41), np.linspace(0.2, 0.8, 31)).reshape(-1, 3)
        for ratio, limits in ((1.0, circle_limits), (0.0, line_limits)):
            pressed, rubbed = fields(80, ratio, places)
            for friction in (0.0, 0.1, 0.2, 0.27):
                stress = pressed + friction * rubbed
                if ratio or friction < 0.25:  # the surface of a line yields first from some 0.26 on
                    self.assertAlmostEqual(limits(friction).elastic * von_mises(stress).max(), math.sqrt(3), delta=4e-3)
                self.assertAlmostEqual(limits(friction).shakedown * np.abs(stress[:, 5]).max(), 1.0, delta=2e-3)

    def test_of_the_line_it_is_melans_limit(self):
        # Plane strain: residual xx and yy, functions of the depth alone. yy can make the stress across the intermediate one; xx
        # must keep the circle of every passage within k. Largest load for which such an xx exists at a depth, by bisection.
        friction, depths = 0.2, np.linspace(0.2, 0.8, 61)
        places = section(np.linspace(-3, 3, 241), depths)
        stress = np.reshape([1, friction] @ np.stack(fields(80, 0.0, places.reshape(-1, 3)), axis=1), (*places.shape[:2], 6))
        difference, shear = stress[..., 0] - stress[..., 2], stress[..., 5]
        low, high = np.zeros((61, 1)), np.full((61, 1), 10.0)
        for _ in range(40):
            load = 0.5 * (low + high)
            room = 1 - (load * shear) ** 2
            half = 2 * np.sqrt(np.maximum(0.0, room))
            fits = ((-load * difference - half).max(axis=1) <= (-load * difference + half).min(axis=1)) & (room >= 0).all(axis=1)
            low, high = np.where(fits[:, None], load, low), np.where(fits[:, None], high, load)
        self.assertAlmostEqual(low.min(), line_limits(friction).shakedown, delta=0.01)

    def test_the_surface_of_the_circle_is_that_of_half_space_elements(self):
        # Middles of elements inside the circle; the steps of the traction make an error of first order.
        x = 2.0 / 161 * np.arange(-72, 73, 4)
        pressed, rubbed = fields(161, 1.0, section(x, [0.0])[0])
        np.testing.assert_allclose(pressed + 0.5 * rubbed, sliding_circle_surface(x, 0.5), atol=0.006)

    def test_regions_and_index_follow_from_the_boundaries(self):
        limits = circle_limits(0.2)
        for factor, region in ((0.99 * limits.elastic, "elastic"), (1.01 * limits.elastic, "elastic shakedown"),
                               (1.01 * limits.shakedown, "beyond shakedown")):
            self.assertEqual(limits.region(factor), region)
        self.assertAlmostEqual(yield_shear_stress(520.0), 300.22, delta=0.01)
        self.assertAlmostEqual(surface_fatigue_index(0.4, 2.5), 0.0, 12)
        self.assertAlmostEqual(surface_fatigue_index(0.4, 4.0), 0.15, 12)

    def test_of_an_ellipse_it_is_that_of_circle_and_line_at_its_ends(self):
        circle, wide, between = Ellipse(1.0), Ellipse(50.0), Ellipse(3.0)
        self.assertAlmostEqual(wide.limit(0.0), 4.0, delta=0.02)
        self.assertAlmostEqual(circle.limit(0.0), 4.68, delta=0.02)
        for friction in (0.0, 0.1, 0.2, 0.3, 0.5):
            round_, line = circle_limits(friction).shakedown, line_limits(friction).shakedown
            self.assertEqual(Ellipse(math.inf).limit(friction), line)
            self.assertAlmostEqual(circle.limit(friction) / round_, 1.0, delta=5e-3)
            self.assertAlmostEqual(wide.limit(friction) / line, 1.0, delta=5e-3)
            self.assertTrue(line * (1 - 5e-3) <= between.limit(friction) <= round_ * (1 + 5e-3))

    def test_of_the_line_it_is_johnsons_map(self):
        for k, limit in enumerate((4.00, 3.56, 3.20, 2.90, 2.50)):
            self.assertAlmostEqual(Ellipse(math.inf).limit(0.1 * k), limit, delta=6e-3)

    def test_of_narrow_ellipses_it_is_melans_limit_of_two_instants(self):
        # 5.75 and 5.9 k by point loads (scipy); the largest xz alone would allow 9.3 and 14.9 k.
        self.assertAlmostEqual(Ellipse(0.2).limit(0.0), 5.75, delta=0.02)
        self.assertAlmostEqual(Ellipse(0.1).limit(0.0), 5.93, delta=0.02)
        for ratio in (0.1, 0.2, 0.5):
            # Also beside y = 0; one of the instants perhaps without load.
            places = np.stack(np.meshgrid([0.1 * ratio * k for k in range(4, 9)], [0.0, 0.4 * ratio, 0.8 * ratio],
                                          np.linspace(-1.2, 1.2, 37), indexing="ij")[::-1], axis=-1)
            pressed, rubbed = (np.reshape(each, (15, 37, 6)) for each in fields(60, ratio, places.reshape(-1, 3)))
            for friction in (0.0, 0.1):
                instants = np.concatenate([np.zeros((15, 1, 6)), pressed + friction * rubbed], axis=1)
                bound = 2 * math.sqrt(3) / von_mises(instants[:, :, None] - instants[:, None]).max()
                limit = Ellipse(ratio).limit(friction)
                self.assertLess(limit, 1.01 * bound)
                if ratio < 0.4:  # otherwise friction lets xz decide
                    self.assertAlmostEqual(limit / bound, 1.0, delta=0.01)


class HalfSpaces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.a = rollfem.solve(CASE_A, model="halfspace", contact_grid={"elements_across": 40},
                              rolling={"longitudinal_creepage": [0.0, 0.002, 0.006]})

    def test_the_axis_of_a_circle_is_that_of_hertz(self):
        # Johnson 1985, section 3.4: stresses on the axis; largest shear 0.3100 p0 at 0.481 a for nu = 0.3.
        result = rollfem.solve(CASE_A, model="halfspace", rail={"transverse_radius": 405.0}, contact_grid={"elements_across": 80})
        a = (0.75 * 50e3 * 405.0 / (210e3 / (2 * 0.91))) ** (1 / 3)
        p0 = 1.5 * 50e3 / (math.pi * a * a)
        self.assertAlmostEqual(result[0].max_pressure[0] / p0, 1.0, delta=2e-3)
        found = rollfem.stress(result, depth_profile=True).models[0]
        for axis in (found.set("depth_centre", body) for body in ("wheel", "rail")):
            z = np.abs(axis["z"]) / a
            self.assertEqual(len(z), 121)
            np.testing.assert_allclose(axis["distance"], z * a, atol=1e-12)
            with np.errstate(divide="ignore"):
                radial = -(1.3 * (1 - z * np.arctan(1 / z)) - 0.5 / (1 + z * z))
            radial[0] = -0.8
            for name, expected in (("xx", radial), ("yy", radial), ("zz", -1 / (1 + z * z)), ("xz", np.zeros(121))):
                np.testing.assert_allclose(axis[name] / p0, expected, atol=2e-3, err_msg=name)
            self.assertAlmostEqual(0.5 * axis["tresca"].max() / p0, 0.3100, delta=1e-3)
            self.assertAlmostEqual(z[axis["tresca"].argmax()], 0.481, delta=0.015)  # points are 0.025 a apart
        # The largest of the bodies are found between the points, too.
        for each in found.data["maxima"]:
            if expected := {"tresca": 0.6200, "orthogonal_shear": 0.2137, "xz_range": 0.4274}.get(each["measure"]):
                self.assertAlmostEqual(each["value"] / p0, expected, delta=2e-3)
            if each["measure"] == "tresca":
                self.assertAlmostEqual(abs(each["place"][2]) / a, 0.481, delta=0.01)

    def test_case_a_is_that_of_contact(self):
        result = rollfem.solve(CASE_A, model="halfspace", contact_grid={"elements_across": 60})
        points = [{"at": [0, 0, side * row[0]], "body": body} for row in CONTACT for body, side in (("wheel", 1), ("rail", -1))]
        found = rollfem.stress(result, places={"point": points}).models[0]
        for k, part in enumerate(found.sets):
            row = CONTACT[k // 2]
            self.assertEqual((part.name, part.body), (f"point_{k + 1}", points[k]["body"]))
            for name, expected in zip(("von_mises", "xx", "yy", "zz"), row[2:]):
                self.assertAlmostEqual(part[name][0], expected, delta=2e-3 * P0)
            self.assertAlmostEqual(part["displacement_z"][0], row[1] * (-1) ** k, delta=5e-5)

    def test_on_the_surface_the_stress_is_the_traction(self):
        plane = {"from": [-3, 0, 0], "to": [3, 0, 0], "across": [-3, 0, -4], "points": [31, 5], "body": "rail"}
        lines = {"line": {"from": [-3, 0.1, 0], "to": [3, 0.1, 0], "points": 7, "body": "wheel"},
                 "surface": {"from": [-3, 0.1], "to": [3, 0.1], "points": 7, "body": "rail"}}
        found = rollfem.stress(self.a, places={"plane": [plane], **{name: [each] for name, each in lines.items()}}).models[0]
        part = found.set("plane_1", "rail")
        self.assertEqual(part.shape, (5, 31))
        pressure = P0 * np.sqrt(1 - (part["x"][:31] / A) ** 2)
        np.testing.assert_array_equal(part["z"][:31], 0.0)
        np.testing.assert_allclose(part["zz"][:31], -pressure, atol=6)
        # xi > 0 brakes: p_x = -mu p on the wheel, xz = -p_x in both bodies.
        np.testing.assert_allclose(part["xz"][:31], 0.55 * pressure, atol=4)
        np.testing.assert_allclose([part["x"][-1], part["z"][-1]], [3, -4], atol=1e-12)
        for name, each in lines.items():
            self.assertAlmostEqual(found.set(f"{name}_1", each["body"])["zz"][3], -P0, delta=4)

    def test_points_of_the_map_follow_from_the_curve(self):
        stress = rollfem.stress(self.a, yield_strength=520.0)
        self.assertIn("shakedown map, k = 300.2 MPa", stress.text)
        first, _, last = stress.models[0].data["shakedown"]
        self.assertAlmostEqual(first["load_factor"], P0 / 300.22, delta=0.01)
        self.assertAlmostEqual(first["tangential_coefficient"], 0.0, delta=1e-9)
        self.assertAlmostEqual(last["tangential_coefficient"], 0.5495, delta=1e-3)
        self.assertEqual((first["circle"]["region"], last["line"]["region"]), ("elastic", "beyond shakedown"))
        self.assertAlmostEqual(last["surface_fatigue_index"], 0.5495 - 300.22 / P0, delta=5e-3)
        self.assertAlmostEqual(last["max_traction_over_k"], 0.55 * P0 / 300.22, delta=0.01)
        # One verdict, with the ellipse of case a.
        self.assertAlmostEqual(first["ellipse"]["ratio"], B / A, delta=0.01)
        self.assertTrue(first["line"]["shakedown"] < first["ellipse"]["shakedown"] < first["circle"]["shakedown"])
        self.assertEqual((first["verdict"], last["verdict"]), ("elastic", "beyond shakedown"))
        above = 100 * (last["load_factor"] / last["ellipse"]["shakedown"] - 1)
        self.assertAlmostEqual(float(last["margin"].split()[2]) / above, 1.0, delta=0.05)
        self.assertEqual(len(stress.data["shakedown_map"]["circle_shakedown"]), 61)
        self.assertNotIn("shakedown_map", rollfem.stress(self.a).data)

    def test_largest_stresses_have_the_bars_of_the_run(self):
        # A single stored grid has none.
        for maxima in (True, False):
            result = rollfem.solve(CASE_A, model="halfspace", contact_grid={"elements_across": 20}, output={"stress_maxima": maxima})
            data = rollfem.stress(result, places={"point": [{"at": [0, 0, -2], "body": "rail"}]}).models[0].data
            first = data["maxima"][0]
            self.assertEqual(first["measure"], "von_mises")
            self.assertEqual(data["sets"][0]["largest"][0]["no_bar"], "one grid")
            if maxima:
                self.assertTrue(0 < first["error_estimate"] < 0.05 * first["value"])
            else:
                self.assertEqual(first["no_bar"], "one grid")

    def test_several_load_points_are_those_of_single_calls(self):
        places = {"point": [{"at": [0, 0, -2], "body": "rail"}]}
        alone = rollfem.stress(self.a, places=places, point_index=1)
        both = rollfem.stress(self.a, places=places, point_index=[0, 1, 1], yield_shear_stress=300.0)
        self.assertEqual([model.data["point"] for model in both.models], [1, 2])
        for name in ("sets", "maxima"):
            self.assertEqual(both.models[1].data[name], alone.models[0].data[name])
            self.assertNotEqual(both.models[0].data[name], alone.models[0].data[name])
        # One map for both, with what is known of either.
        self.assertEqual(both.text.count("shakedown map"), 1)
        known = both.models[0].data["shakedown"]
        self.assertEqual(known, both.models[1].data["shakedown"])
        self.assertEqual(["yield_ratio" in each for each in known], [True, True, False])

    def test_below_a_line_contact_it_is_plane_strain(self):
        # Norton, Machine Design, example 7-2: 484.31 MPa, half width 1.3157 mm; one mm of its width.
        steel = {"young_modulus": 206843.0, "poisson_ratio": 0.28}
        result = rollfem.solve({"geometry": {"shape": "line"}, "load": {"max_pressure": 484.31}, "friction": {"coefficient": 0.0},
                                "wheel": {"rolling_radius": 152.4, **steel}, "rail": steel}, models=["halfspace", "hertz"])
        for model in ("halfspace", "hertz"):
            stress = rollfem.stress(result, model=model, yield_shear_stress=131.0)
            self.assertIn("limit of p0/k of the line contact", stress.text)
            for each in (each for each in stress.models[0].data["maxima"] if each["measure"] == "tresca"):
                self.assertAlmostEqual(each["over_max_pressure"], 0.6006, delta=2e-3)
                self.assertAlmostEqual(abs(each["place"][2]), 0.786 * 1.3157, delta=0.02)
            point = stress.models[0].data["shakedown"][0]
            self.assertAlmostEqual(point["ellipse"]["shakedown"], 4.0, delta=4e-3)
            self.assertIsNone(point["ellipse"]["ratio"])
            self.assertEqual(point["verdict"], "elastic shakedown")

    def test_narrow_patches_yield_at_every_passage(self):
        # b/a = 0.2, p0 = 9 k: the elastic stress itself goes from 0 to 3 times the yield value.
        result = rollfem.solve({"given_pressure": {"semi_axis_x": 5.0, "semi_axis_y": 1.0, "max_pressure": 2520.0},
                                "friction": {"coefficient": 0.0}}, model="halfspace")
        point = rollfem.stress(result, yield_shear_stress=280.0).models[0].data["shakedown"][0]
        self.assertAlmostEqual(point["ellipse"]["shakedown"], 5.75, delta=0.05)
        self.assertGreater(point["yield_ratio"], 2.0)
        self.assertEqual(point["verdict"], "beyond shakedown")

    def test_the_tangential_force_of_a_curved_patch_is_that_of_friction_alone(self):
        # The pressure acts across as well, here with 0.9 % of the load.
        result = rollfem.solve({
            "load": {"vertical_force": 60e3}, "friction": {"coefficient": 0.01}, "wheel": {"rolling_radius": 460.0, "profile": "S1002"},
            "rail": {"profile": "UIC60"}, "track": {"gauge": 1435.0, "inclination": "1:40"}, "contact_grid": {"elements_across": 12},
            "wheelset": {"side": "left", "roll": 0.0, "flange_back_distance": 1360.0, "lateral_shift": -5.0},
            "halfspace": {"surface": "curved"}}, model="halfspace")
        found = rollfem.stress(result, yield_strength=520.0).models[0].data["shakedown"]
        self.assertEqual(len(found), 1)
        self.assertLessEqual(found[0]["tangential_coefficient"], 0.01 * 1.001)


def block(side):
    """A body of 2 x 2 x 2 cells of 2 mm below (-1: above) the surface, in which stress is a linear function of the place."""
    axis = np.array([-2.0, 0.0, 2.0])
    z, y, x = (part.ravel() for part in np.meshgrid(side * np.array([-4.0, -2.0, 0.0]), axis, axis, indexing="ij"))
    corner = np.array([9 * k + 3 * j + i for k in (0, 1) for j in (0, 1) for i in (0, 1)])
    order = np.array([0, 1, 4, 3, 9, 10, 13, 12]) if side > 0 else np.array([9, 10, 13, 12, 0, 1, 4, 3])
    return {"points": np.stack([x, y, z], axis=1), "cells": corner[:, None] + order, "stress": np.stack(
        [10 * x, -3 * y, 7 * z - 50, x + z, np.full_like(x, 2.0), y], axis=1), "displacement": np.stack([x + y, 0 * x, 0 * x], axis=1)}


def of_bodies(places=(None,), elastic=("wheel", "rail")):
    """A result of finite elements with four load points, of which the second and the last keep their bodies, and a theory."""
    grid, both, none = np.linspace(-3, 3, 13), {"wheel": block(-1), "rail": block(1)}, Node({}, {}, {})
    pressure = np.sqrt(np.maximum(0.0, 1 - (grid / 2.9) ** 2 - (grid[:, None] / 2.9) ** 2))

    def part_of(names, load=0.0):
        return Node({}, {}, {body: Node({}, {name: both[body][name] + load * (np.arange(6) == 4)
                                             if name == "stress" else both[body][name] for name in names}, {}) for body in elastic})

    models = []
    for number, (name, place) in enumerate((name, place) for name in ("fem", "hertz") for place in places):
        points = {}
        for load in range(4):
            scalars = {"longitudinal_creepage": 0.001 * load, "lateral_creepage": 0.0, "spin": 0.0, "normal_force": 1e4, "step": 0,
                       "max_pressure": 1.0, "max_traction": 0.0, "longitudinal_force": 0.0, "lateral_force": 0.0,
                       "lateral_pressure": 0.0, "semi_axis_x": 2.0, "semi_axis_y": 2.0}
            kept = {"bodies": part_of(("displacement", "stress"), load)} if name == "fem" and load in (1, 3) else {}
            points[f"{load:04}"] = Node(scalars, {"pressure": pressure}, kept)
        models.append(ModelResult(f"{name}_{number}", Node(
            {"model": name, "label": name, "unknowns": 1, "contact_elements": 1}, {},
            {"grid": Node({"dx": 0.5, "dy": 0.5}, {"x": grid, "y": grid}, {}), "seconds": none, "points": Node({}, {}, points),
             "notes": Node({}, {name: [] for name in ("severity", "about", "text")}, {}),
             "bodies": part_of(("points", "cells")), **({"place": Node(place, {}, {})} if place else {})})))
    inputs = {f"{body}.{name}": value for body in ("wheel", "rail") for name, value in STEEL.items()}
    return rollfem.Result("a block", "", "", models, folder="r", inputs=inputs)


def point_at(*place):
    return {"point": [{"at": list(place), "body": "wheel" if place[2] > 0 else "rail"}]}


class Bodies(unittest.TestCase):
    def test_stress_is_interpolated_between_the_nodes(self):
        places = {"point": [{"at": [0.3, 0.6, -1.7], "body": "rail"}, {"at": [0.3, 0.6, 1.7], "body": "wheel"}],
                  "line": [{"from": [0.5, 0.5, 0.2], "to": [0.5, 0.5, -1], "points": 5, "body": "rail"}],
                  "surface": [{"from": [0.5, 0.5], "to": [1, 0.5], "depth": 0.7, "points": 3, "body": "rail"}]}
        found = rollfem.stress(of_bodies(), places=places, model="fem").models[0]
        rail, wheel = found.set("point_1", "rail"), found.set("point_2", "wheel")
        for name, expected in (("xx", 3.0), ("yy", -1.8), ("zz", -61.9), ("xy", -1.4), ("yz", 5.0), ("xz", 0.6), ("displacement_x", 0.9)):
            self.assertAlmostEqual(rail[name][0], expected, 12, name)
        self.assertAlmostEqual(wheel["zz"][0], 7 * 1.7 - 50, 12)
        # A place beyond the surface is moved onto it and reported there.
        line = found.set("line_1", "rail")
        np.testing.assert_allclose([line["z"][0], line["zz"][0], line["z"][4]], [0, -50, -1], atol=1e-12)
        self.assertAlmostEqual(line.moved, 0.2, 12)
        np.testing.assert_allclose(found.set("surface_1", "rail")["z"], -0.7, atol=1e-7)

    def test_it_is_that_of_the_load_point_asked_for(self):
        result = of_bodies()
        for asked, expected, heading in (({"point_index": 1}, 3.0, "fem_0: load point 2, xi = 0.001"),
                                         ({}, 5.0, "fem_0: load point 4 (the last of 4; others: --point 1 to 4, --creepage), xi")):
            found = rollfem.stress(result, places=point_at(0, 0, -1), model="fem", **asked)
            self.assertAlmostEqual(found.models[0].sets[0]["yz"][0], expected, 12)
            self.assertIn(heading, found.text)
        # Down from the surface at any of them.
        down = rollfem.stress(result, model="fem", point_index=1, depth=1.5).models[0].set("depth_centre", "rail")
        self.assertAlmostEqual(down["zz"][-1], 7 * -1.5 - 50, 7)
        self.assertAlmostEqual(down["yz"][-1], 3.0, 12)

    def test_largest_stresses_are_those_of_the_nodes(self):
        found = rollfem.stress(of_bodies(), places=point_at(0, 0, -1), model="fem").models[0].data["maxima"]
        block_of = block(1)
        block_of["stress"][:, 4] += 3
        largest = next(each for each in found if (each["body"], each["measure"]) == ("rail", "von_mises"))
        self.assertAlmostEqual(largest["value"], von_mises(block_of["stress"]).max(), 12)
        self.assertEqual(len({(each["body"], each["measure"]) for each in found}), 12)
        # xz = y is the same all along rolling.
        self.assertAlmostEqual(next(each["value"] for each in found if each["measure"] == "xz_range"), 0.0, 12)

    def test_load_points_without_bodies_are_refused(self):
        result = of_bodies()
        with self.assertRaisesRegex(rollfem.InputError, "load point 1: model fem_0 stores its bodies only for these load points: 2, 4; do: "):
            rollfem.stress(result, model="fem", point_index=0)
        with self.assertWarnsRegex(UserWarning, "left out: load point 1: model fem_0"):
            both = rollfem.stress(result, models=["fem", "hertz"], point_index=0, places=point_at(0, 0, -1))
        self.assertEqual([model.name for model in both.models], ["hertz"])
        with self.assertRaisesRegex(rollfem.InputError, r"point_1: the point \(0, 0, -9\) mm is 5 mm outside the computed rail"):
            rollfem.stress(result, model="fem", places=point_at(0, 0, -9))
        with self.assertRaisesRegex(rollfem.InputError, "point_1: the wheel is rigid"):
            rollfem.stress(of_bodies(elastic=("rail",)), model="fem", places=point_at(0, 0, 1))

    def test_patches_are_told_apart(self):
        result = of_bodies([{"wheel": "left", "position": 1, "patch": patch, "patches": 2} for patch in (1, 2)])
        for asked, key in (({}, "fem_0"), ({"model": "hertz"}, "hertz_2"), ({"patch": "left,1,2"}, "fem_1")):
            self.assertEqual(rollfem.stress(result, places=point_at(0.1, 0.1, -1), **asked).models[0].key, key)
        with self.assertRaisesRegex(rollfem.InputError, "allowed: left,1,1, left,1,2; do: "):
            rollfem.stress(result, patch="right,1,1")


PLANE = '[[subsurface.plane]]\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nacross = [0, 0, -1]\npoints = [2000, 2000]\nbody = "rail"\n'
LINE = '[[subsurface.line]]\nfrom = {}\nto = {}\npoints = {}\nbody = "{}"\n'
#: (arguments or the text of --places, part of the message)
WRONG = [
    (["--model", "fem"], "--model fem: it is not in r; allowed: halfspace"),
    (["--point", "4"], "load points 1 to 3"), (["--point", "0"], "load points 1 to 3"), (["--creepage", "0.003"], "allowed: 0, 0.002, 0.006"),
    (["--point", "1", "--creepage", "0"], "exclude each other"), (["--places", "none.toml"], "none.toml: there is no such file"),
    (["--patch", "left,1,1"], "without profiles"), (["--yield-strength", "0"], "a stress > 0"),
    (["--yield-strength", "3", "--yield-shear-stress", "4"], "exclude each other"), (["--depth", "-1"], "a depth > 0"),
    (["-o", "r/results.h5/x"], "cannot create the folder"), ("", "has no section [[subsurface.point]]"),
    ("[[subsurface.point]]\nat = [1, 2]\n", "subsurface.point.at"),
    ("[[subsurface.line]]\nfrom = [0, 0, 1]\npoints = 2\n", "subsurface.line.to: is missing"),
    (LINE.format([0, 0, 1], [0, 0, 1], 3, "wheel"), "two of its points coincide"),
    (LINE.format([0, 0, 0], [0, 0, -5], 1, "rail"), "subsurface.line.points = 1"), (PLANE, "at most 1000000 points"),
    (LINE.format([0, 0, -1], [0, 0, 1], 3, "rail"), "is not in the rail of model halfspace"),
    ('[[subsurface.point]]\nat = [0, 0, 1]\nbody = "sleeper"\n', "sleeper")]


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        # A narrow patch.
        cls.result = rollfem.solve(CASE_A, model="halfspace", rail={"transverse_radius": 100.0}, contact_grid={"elements_across": 16},
                                   rolling={"longitudinal_creepage": [0.0, 0.002, 0.006]})
        cls.result.write(cls.folder / "r")

    def call(self, *arguments):
        return subprocess.run([PROGRAM, "stress", *arguments], cwd=self.folder, capture_output=True, text=True)

    def test_files_and_text_are_those_of_python(self):
        (self.folder / "line.toml").write_text(LINE.format([-3, 0, -1], [3, 0, -1], 21, "rail"))
        done = self.call("r", "--yield-shear-stress", "250", "--depth-profile", "--places", "line.toml", "--creepage", "0,0.006")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            same = rollfem.stress(rollfem.read(self.folder / "r"), yield_shear_stress=250.0, depth_profile=True, point_index=[0, 2],
                                  places=self.folder / "line.toml")
        stored = rollfem.read(self.folder / "r_stress")
        self.assertEqual(stored.models[1].data, same.models[1].data)
        self.assertEqual(stored.contents["stress.csv"], same.contents["stress.csv"])
        self.assertEqual(done.stdout.splitlines()[2:-2], same.text.splitlines()[2:])
        names = {path.name for path in (self.folder / "r_stress/figures").iterdir()}
        self.assertEqual(names, {"shakedown_map.svg", "depth_centre.svg", "line_1_rail.svg", "depth_most_loaded.svg"} & names
                         | {"shakedown_map.svg", "depth_centre.svg", "line_1_rail.svg"})
        page = (self.folder / "r_stress/stress.html").read_text(encoding="utf-8")
        for words in ("Largest stresses", "half-space, ", "Shakedown, k = 250.0 MPa", "<figure>", 'aria-label="Shakedown map'):
            self.assertIn(words, page)
        # Figures that a later call does not draw are removed.
        self.assertEqual(self.call("r", "--no-figures", "-q").stdout, "")
        self.assertFalse((self.folder / "r_stress/figures/shakedown_map.svg").exists())
        self.assertFalse((self.folder / "r_stress/stress.html").exists())

    def test_json_is_printed_alone(self):
        done = self.call("r", "--json", "--point", "3,1")
        self.assertEqual([model["point"] for model in json.loads(done.stdout)["models"]], [3, 1])
        self.call("r", "--json", "-o", "told", "--no-figures")
        self.assertEqual(sorted(os.listdir(self.folder / "told")), ["stress.csv", "stress.json"])

    def test_wrong_calls_are_refused(self):
        before = sorted(os.listdir(self.folder))
        for asked, part in WRONG:
            with self.subTest(part):
                places = self.folder / "wrong.toml"
                places.write_text(asked if isinstance(asked, str) else "")
                done = self.call("r", "--no-figures", *(["--places", "wrong.toml"] if isinstance(asked, str) else asked))
                places.unlink()
                self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
                self.assertIn(part, done.stderr)
                self.assertIn("do: ", done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_files_that_are_no_results_are_refused(self):
        whole = (self.folder / "r/results.h5").read_bytes()
        (self.folder / "cut.h5").write_bytes(whole[:len(whole) // 2])
        for path, part in (("missing", "missing: there is no such file"), ("r/summary.json", "not a result of rollfem"),
                           ("cut.h5", "truncated or damaged"), ("/dev/null", "is not a regular file")):
            done = self.call(path)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
            self.assertIn(part, done.stderr)
        self.assertIn("result is required", self.call().stderr)


if __name__ == "__main__":
    unittest.main(argv=["stress.py"])
