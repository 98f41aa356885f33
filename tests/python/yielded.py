#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies that yield: what is read of them, and their figures and table in the report.
Call: yielded.py SOURCE_FOLDER PROGRAM; rollfem is found by PYTHONPATH."""
import base64
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

import numpy as np

import rollfem

PROGRAM = pathlib.Path(sys.argv[2]).resolve()
# Coarse, in equal rows of cells: wheel and rail yield below a round patch, slipping in the first and third pass only.
CASE = """title = "two bodies that yield"
models = ["fem"]
[load]
normal_force = 100e3
[friction]
coefficient = 0.3
[wheel]
rolling_radius = 450.0
transverse_radius = inf
[rail]
transverse_radius = 450.0
[rail_plasticity]
yield_stress = 450.0
hardening = [20e3]
residual_depth = [0.0, 10.0]
residual_along = [100.0, 0.0]
[wheel_plasticity]
yield_stress = 520.0
hardening = [20e3]
residual_file = "measured.csv"
[rolling]
longitudinal_creepage = [0.03, 0.001]
[fem]
cell_size = 4.0
passes = 3
surface_layer = 0.0
[output]
body_fields = "last"
"""


def vtu_arrays(path):
    """The floating-point arrays of a ParaView file by name."""
    found = {}
    for array in xml.etree.ElementTree.parse(path).getroot().iter("DataArray"):
        text = array.text.strip()
        blocks = struct.unpack("<Q", base64.b64decode(text[:12])[:8])[0]
        length = (8 * (3 + blocks) + 2) // 3 * 4
        sizes, data = struct.unpack(f"<{3 + blocks}Q", base64.b64decode(text[:length]))[3:], base64.b64decode(text[length:])
        raw, at = b"", 0
        for size in sizes:
            raw, at = raw + zlib.decompress(data[at:at + size]), at + size
        if array.get("type").startswith("Float"):
            found[array.get("Name")] = np.frombuffer(raw, array.get("type").lower()).reshape(-1, int(array.get("NumberOfComponents", 1)))
    return found


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


class Yielded(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        (cls.path / "case.toml").write_text(CASE, encoding="utf-8")
        (cls.path / "measured.csv").write_text("0, -50, -20\n10, 0, 0\n", encoding="utf-8")
        run("run", cls.path / "case.toml", "-o", cls.path / "run", "-q")
        cls.result = rollfem.read(cls.path / "run")
        cls.points = cls.result.models[0].points

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_sections_have_the_scalars_of_the_load_point(self):
        self.assertEqual([p.step for p in self.points], [1, 2, 3])
        for point in self.points:
            bodies = point.yielded.values()
            self.assertEqual(list(point.yielded), ["rail", "wheel"])
            for name, quantity in (("plastic_strain", "plastic_strain"), ("increment", "plastic_increment"),
                                   ("net_increment", "net_plastic_increment")):
                self.assertEqual(max(body[name] for body in bodies), point[quantity])
            self.assertAlmostEqual(sum(body["plastic_work"] for body in bodies) / point.plastic_work, 1.0, 12)
            self.assertEqual(max(-body["groove"].min() for body in bodies), point.groove_depth)
            self.assertEqual(max(-body["stress"][..., 0].min() for body in bodies), point.residual_stress)

    def test_what_is_solved_here_has_what_is_read(self):
        solved = rollfem.solve(rollfem.Case(self.path / "case.toml")).models[0].points
        for here, there in zip(solved, self.points):
            for body, read in there.yielded.items():
                self.assertEqual(set(here.yielded[body]), set(read))
                for name in ("stress", "strain", "groove", "depth"):
                    np.testing.assert_allclose(here.yielded[body][name], read[name], rtol=1e-6, atol=1e-9)

    def test_passes_may_go_to_their_limit_by_extrapolation(self):
        # Passes alone leave 0.09 of what the third has gained in the fifth.
        points = rollfem.solve(rollfem.Case(self.path / "case.toml", rolling={"longitudinal_creepage": 0.001},
                                            fem={"passes": 5, "limit_state": True})).models[0].points
        increments = [p.yielded["rail"]["increment"] for p in points]
        self.assertLess(increments[4], 0.02 * increments[2])

    def test_streamlines_are_rows_of_one_depth(self):
        for body in self.points[-1].yielded.values():
            shape = body["y"].shape
            self.assertEqual(body["strain"].shape, (*shape, 6))
            self.assertEqual(body["groove"].shape, shape[1:])
            self.assertTrue((np.diff(body["depth"], axis=0) > 0).all() and (np.diff(body["y"], axis=1) > 0).all())
            np.testing.assert_array_equal(body["surface_y"], body["y"][0])
            self.assertLess(np.abs(body["strain"][..., :3].sum(axis=-1)).max(), 1e-6 * body["plastic_strain"])  # no volume
            self.assertAlmostEqual(float(body["accumulated"].max()) / body["plastic_strain"], 1.0, 6)

    def test_what_has_flowed_stays(self):
        for body in ("wheel", "rail"):
            sums = np.array([p.yielded[body]["accumulated"] for p in self.points])
            self.assertTrue((np.diff(sums, axis=0) >= -1e-9).all())
        # Braking drags the surface of the rail forwards, that of the wheel backwards.
        self.assertGreater(self.points[0].yielded["rail"]["forward_flow"].max(), 0)
        self.assertLess(self.points[0].yielded["wheel"]["forward_flow"].min(), 0)

    def test_the_report_shows_passes_instead_of_a_creep_curve(self):
        figures = {path.stem for path in (self.path / "run/figures").glob("*.svg")}
        self.assertEqual({name for name in figures if name.startswith("yielded")},
                         {"yielded_passes", "yielded_shakedown_map", *(f"yielded_{what}_{body}" for body in ("wheel", "rail")
                                                                       for what in ("stress", "section", "groove"))})
        self.assertNotIn("creep_curve", figures)
        for body in ("wheel", "rail"):  # one has it from a file, one from lists
            self.assertIn("before the first pass", (self.path / f"run/figures/yielded_stress_{body}.svg").read_text(encoding="utf-8"))
        page = (self.path / "run/report.html").read_text(encoding="utf-8")
        for words in ("Steel that yields</h2>", "<th scope=col>pass</th>", f"rail: {self.points[-1].yielded['rail']['verdict']}",
                      "Shakedown map with the passes", "yield stress in shear k = 300.2 MPa (wheel), k = 259.8 MPa (rail)",
                      "before the first pass", "Section of the rail after pass 3", ">pass 2<", "after the last pass (3)"):
            self.assertIn(words, page)

    def test_the_last_pass_is_the_headline(self):
        last, answer = self.points[-1], (self.path / "run/report.html").read_text(encoding="utf-8")
        answer = answer[answer.index('<h2 id="the-answer"'):answer.index("<details>")]
        for words in ("after the last pass of 3", f"{last.max_pressure:#.5g}".rstrip("."), "residual compression", "shakedown",
                      f"rail: {last.yielded['rail']['verdict']}"):
            self.assertIn(words, answer)
        with open(self.path / "run/summary.json", encoding="utf-8") as file:
            self.assertEqual(json.load(file)["models"][0]["headline"], 2)

    def test_paraview_has_plastic_strain_at_the_nodes(self):
        for name, body in self.points[-1].yielded.items():
            at_nodes = vtu_arrays(self.path / f"run/fields/fem_{name}_0002.vtu")
            strain, accumulated = at_nodes["plastic strain [-]"], at_nodes["accumulated plastic strain [-]"][:, 0]
            self.assertEqual(len(strain), len(at_nodes["displacement [mm]"]))
            # Cells are nearly as large as the plastic zone: lines through their points reach beyond the largest value.
            self.assertLess(abs(accumulated.max() / body["plastic_strain"] - 1), 0.2)
            largest = np.abs(body["strain"]).max()
            self.assertLess(np.abs(strain[:, :3].sum(axis=1)).max(), 1e-6 * largest)  # no volume
            beside = np.abs(at_nodes["Points"][:, 1]) > 1e-6
            self.assertLess(np.abs(strain[beside][:, [3, 4]].sum(axis=0)).max(), 1e-3 * largest)  # the halves mirror each other
            for component in (0, 1, 2, 5):
                there = body["strain"][..., component]
                self.assertLess(abs(strain[:, component].max() - there.max()), 0.2 * largest)
                self.assertLess(abs(strain[:, component].min() - there.min()), 0.2 * largest)
            self.assertLess(at_nodes["residual stress [MPa]"][:, 0].min(), 0.9 * body["stress"][..., 0].min())

    def test_bodies_that_stay_elastic_have_none(self):
        run("run", self.path / "case.toml", "--model", "halfspace", "-o", self.path / "elastic", "-q")
        self.assertEqual(rollfem.read(self.path / "elastic").points[0].yielded, {})
        self.assertFalse(list((self.path / "elastic/figures").glob("yielded*")))


class Pressed(unittest.TestCase):
    """The same bodies, pressed and left without load."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        case = CASE.replace("normal_force = 100e3\n", "").replace("longitudinal_creepage = [0.03, 0.001]", 'problem = "shift"\n'
                            "[history]\nnormal_force = [100e3, 0.0]").replace("passes = 3\n", "")
        (cls.path / "case.toml").write_text(case, encoding="utf-8")
        (cls.path / "measured.csv").write_text("0, -50, -20\n10, 0, 0\n", encoding="utf-8")
        run("run", cls.path / "case.toml", "-o", cls.path / "run", "-q")
        cls.points = rollfem.read(cls.path / "run").models[0].points

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_steps_have_imprint_and_residual_stress_but_nothing_of_what_rolls(self):
        pressed, left = self.points
        self.assertEqual((pressed.by_number, left.step, left.max_pressure), ("load point", 2, 0.0))
        for body in ("wheel", "rail"):
            self.assertEqual([p.yielded[body]["verdict"] for p in self.points], ["yields", "nothing new yields"])
            self.assertEqual(pressed.yielded[body]["forward_flow"].size, 0)
            self.assertLess(left.yielded[body]["groove"].min(), 0)
        self.assertEqual(left.groove_depth, max(-body["groove"].min() for body in left.yielded.values()))
        self.assertLess(left.approach, pressed.approach)
        for name in ("forward_flow", "plastic_work", "net_plastic_increment"):
            self.assertIsNone(getattr(left, name))

    def test_the_report_speaks_of_steps(self):
        figures = {path.stem for path in (self.path / "run/figures").glob("yielded*.svg")}
        self.assertEqual(figures, {"yielded_passes", *(f"yielded_{what}_{body}" for body in ("wheel", "rail")
                                                       for what in ("stress", "section", "groove"))})
        page = (self.path / "run/report.html").read_text(encoding="utf-8")
        for words in ("<th scope=col>step</th>", "rail: nothing new yields", "before the first step", "imprint"):
            self.assertIn(words, page)
        self.assertNotIn("Shakedown map with the passes", page)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
