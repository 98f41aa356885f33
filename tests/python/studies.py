#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orders, limits and uncertainties against sequences with known limit and order, and differences of models against numbers
worked out by hand: what studies and comparisons make of their results, their files and pages.
rollfem is found by PYTHONPATH."""
import json
import math
import os
import sys
import tempfile
import unittest

import numpy as np

import rollfem
from rollfem.commands import benching, comparing, refinement
from rollfem.commands.refinement import limit_of, order_of_errors
from rollfem.figures.page import build
from rollfem.figures.published import published
from rollfem.files import json_is_sound, rows_of, sealed_json
from rollfem.node import Node
from rollfem.outputs import Study
from rollfem.result import ModelResult, Result, models_of


def sequence(order, levels, ratio=2.0, limit=3.0):
    return [limit + 0.1 * ratio ** (-order * k) for k in range(levels)]


class Limits(unittest.TestCase):
    def test_pure_orders_are_found_exactly(self):
        for ratio in (1.5, 2.0, 4.0):
            for order in (0.7, 1.0, 2.0, 3.0):
                limit = limit_of(sequence(order, 4, ratio), ratio)
                self.assertAlmostEqual(limit.order, order, 9)
                self.assertAlmostEqual(limit.value, 3.0, 12)
                self.assertEqual(limit.reason, "")

    def test_the_uncertainty_of_the_grid_is_roaches_index(self):
        # Order 2, ratio 2: 1.25 |f3 - f2| / 3, which is 1.25 times the true error.
        values = sequence(2.0, 3)
        limit = limit_of(values, 2.0)
        self.assertAlmostEqual(limit.uncertainty_of_finest, 1.25 * (values[2] - 3.0), 12)
        self.assertEqual(limit.uncertainty, limit.uncertainty_of_finest)

    def test_a_quick_order_is_not_believed_in_the_uncertainty(self):
        # Order 3 is chance: half of the change before, which is 0.1 (1/8 - 1/64), over 1, times 1.25.
        limit = limit_of(sequence(3.0, 4), 2.0)
        self.assertAlmostEqual(limit.uncertainty_of_finest, 1.25 * 0.5 * 0.1 * (1 / 8 - 1 / 64), 12)
        self.assertEqual(limit.uncertainty, limit.uncertainty_of_finest)

    def test_bars_hold_where_fast_convergence_is_chance(self):
        # Sequences that fall fast and then stay on the other side of their limit: semi-axes of Hertz's ellipses by the
        # half-space with 20, 40, ... elements across, relative to the exact ones.
        exact = 5.001008
        for off in ([1.99e-4, 2.42e-6, -1.90e-5, -1.59e-5], [3.01e-4, 2.26e-5, -1.40e-5, -1.51e-5],
                    [3.22e-4, 2.75e-5, -1.26e-5, -1.48e-5], [7.14e-5, -1.66e-5, -2.27e-5, -1.62e-5],
                    [2.72e-4, 1.62e-5, -1.57e-5, -1.54e-5]):
            for levels in (3, 4):
                values = [exact * (1 + error) for error in off[:levels]]
                limit = limit_of(values, 2.0)
                self.assertLessEqual(abs(limit.value - exact), limit.uncertainty)
                self.assertLessEqual(abs(values[-1] - exact), limit.uncertainty_of_finest)
                self.assertLessEqual(limit.uncertainty, 1e-3)

    def test_bars_hold_for_sums_of_two_orders(self):
        # f + a h^p + b h^q with signs and sizes of every kind.
        covered = [abs((limit := limit_of([3 + 0.1 * (2 ** (-order * k) + second * 2 ** (-(order + more) * k))
                                           for k in range(1, levels + 1)], 2.0)).value - 3) <= limit.uncertainty
                   for order in (1, 1.5, 2) for more in (0.5, 1, 2) for second in (-3, -1, -0.3, -0.1, 0.1, 0.3, 1, 3)
                   for levels in (3, 4, 5)]
        self.assertGreaterEqual(np.mean(covered), 0.95)

    def test_a_value_converged_to_rounding_has_no_order_but_a_bar(self):
        a, bit = 5.001008, 8.9e-16
        for values in ([a, a, a], [a + 4 * bit, a, a + 2 * bit, a - bit, a]):
            limit = limit_of(values, 2.0)
            self.assertEqual((limit.settled, limit.order, limit.reason), (True, None, "converged to rounding"))
            self.assertTrue(1e-12 * a <= limit.uncertainty < 1e-11 * a)
        # A solver with a tolerance of 1e-6 does not resolve changes of 3e-7.
        rough = limit_of([1.0, 1 + 3e-7, 1 + 4e-7], 2.0, 1e-6)
        self.assertTrue(rough.settled and rough.uncertainty >= 1e-6)
        self.assertFalse(limit_of([1.0, 1 + 3e-7, 1 + 4e-7], 2.0).settled)

    def test_four_levels_of_a_mixed_sequence_enclose_their_limit(self):
        values = [1 + 0.2 * 4.0**-k + 0.05 * 8.0**-k for k in range(5)]
        limit = limit_of(values, 2.0)
        self.assertAlmostEqual(limit.order, 2.0, delta=0.05)
        self.assertLess(abs(limit.value - 1), limit.uncertainty)
        self.assertLess(limit.uncertainty, 0.5 * limit.uncertainty_of_finest)
        self.assertLess(abs(values[-1] - 1), limit.uncertainty_of_finest)

    def test_no_order_is_claimed_where_there_is_none(self):
        for values, reason in (([1.0, 1.2, 1.1], "the sequence is not monotone"), ([1.0, 1.1, 1.3], "its changes do not decrease"),
                               ([1.0, 1.1, 1.1], "the last two values are the same"), ([1.0, 1.1], "two levels cannot show an order"),
                               (sequence(0.2, 3), "too slowly"), (sequence(8.0, 3), "coincidence")):
            limit = limit_of(values, 2.0)
            self.assertEqual((limit.order, limit.value), (None, values[-1]))
            self.assertIn(reason, limit.reason)
        # Three times the largest of the last two changes.
        self.assertAlmostEqual(limit_of([1.0, 1.2, 1.1], 2.0).uncertainty_of_finest, 0.6, 12)
        for values, ratio in (([1.0], 2.0), ([1.0, 2.0], 1.0)):
            with self.assertRaises(AssertionError):
                limit_of(values, ratio)

    def test_a_little_scatter_does_not_hide_the_order_of_many_levels(self):
        # The last three changes do not fall, but all five values follow 3 + 0.1 / 4^k within 2e-3.
        values = sequence(2.0, 5)
        values[3] += 2e-3
        limit = limit_of(values, 2.0)
        self.assertTrue(limit.fitted and limit.reason)
        self.assertAlmostEqual(limit.order, 2.0, delta=0.2)
        self.assertLess(abs(limit.value - 3), limit.uncertainty)
        self.assertLess(limit.uncertainty, 5e-3)
        # As much scatter as change, or an order that no method here has, is no curve.
        self.assertIsNone(limit_of([3.1, 3.0, 3.05, 2.98, 3.06], 2.0).order)
        self.assertIsNone(limit_of([3.1, 3.001, 3.0, 2.9995, 3.0001], 2.0).order)

    def test_orders_of_errors_on_any_ratio(self):
        self.assertAlmostEqual(order_of_errors(9.0, 1.0, 3.0), 2.0, 12)
        self.assertAlmostEqual(order_of_errors(-2.0, 4.0, 2.0), -1.0, 12)
        self.assertIsNone(order_of_errors(1.0, 0.0, 2.0))


HEAD = {"program": {"version": "1", "commit": "0"}, "host": "h", "started": "now", "command": "rollfem", "processes": 1,
        "labels": {"halfspace": "half-space", "fem": "FEM", "hertz": "Hertz"}}


def study():
    """Pressure of order 2 towards 100, a coefficient of order 1 towards 0.2."""
    series = refinement.Series("halfspace", "grid", "contact grid", 2.0, measures_others=True, levels=[refinement.Level(
        str(10 << k), 0.0, 100 << 2 * k, 0, 0.1 * 4.0**k,
        {"max_pressure": 100 + 4.0**-k, "traction_coefficient:2": 0.2 - 0.01 * 2.0**-k}) for k in range(4)])
    place = refinement.Place([(0.0, 0.0, 0.0), (0.001, 0.0, 0.0)], series=[series])
    return refinement.Record(HEAD, "a <case>", "a.toml", "", 0.4, places=[place])


def references(record, k=0):
    return record.references(record.places[0], record.places[0].series[k])


class Studies(unittest.TestCase):
    def setUp(self):
        self.record = study()
        self.place = self.record.places[0]
        self.place.exact = {"max_pressure": 100.0}

    def with_fem(self):
        """Finite bodies whose limits differ from those of half-spaces by 1.5 MPa of 100.5 and 0.012 of mu = 0.4."""
        self.place.exact = {"max_pressure": 100.5}
        fem = study().places[0].series[0]
        fem.model, fem.limit_of_its_own, fem.measures_others = "fem", True, False
        for level in fem.levels:
            level.values = {"max_pressure": level.values["max_pressure"] + 2,
                            "traction_coefficient:2": level.values["traction_coefficient:2"] + 0.012}
        self.place.series.insert(0, fem)
        return fem

    def test_exact_values_are_references_and_the_others_are_extrapolated(self):
        found = references(self.record)
        self.assertEqual(found["max_pressure"].kind, "exact")
        self.assertEqual(found["traction_coefficient:2"].kind, "extrapolated")
        self.assertAlmostEqual(found["traction_coefficient:2"].value, 0.2, 12)
        self.record.rule = "finest"
        found = references(self.record)["max_pressure"]
        self.assertEqual((found.kind, found.value), ("finest", 100 + 1 / 64))
        self.place.given = {"max_pressure": 99.0}
        self.assertEqual(references(self.record)["max_pressure"].kind, "given")
        self.record.rule = "exact"
        self.assertNotIn("traction_coefficient:2", references(self.record))

    def test_finite_bodies_are_measured_against_their_own_limit(self):
        fem = self.with_fem()
        self.assertIs(self.place.base, self.place.series[1])
        self.assertEqual(references(self.record, 1)["max_pressure"].kind, "exact")
        own = references(self.record)["max_pressure"]
        self.assertEqual(own.kind, "extrapolated")
        self.assertAlmostEqual(own.value, 102.0, 9)
        self.assertAlmostEqual(self.record.error("max_pressure", fem.levels[-1].values["max_pressure"], own), 1 / 64 / 102, 9)
        found = self.record.differences(self.place, fem)
        self.assertAlmostEqual(found["max_pressure"][0], 1.5 / 100.5, 9)
        self.assertAlmostEqual(found["traction_coefficient:2"][0], 0.012 / 0.4, 9)
        self.assertEqual(self.record.differences(self.place, self.place.base), {})
        self.assertIn("Model differences from halfspace: fem (grid) p0 1.5 %, -F_x/F_z 3 % of mu.",
                      refinement.verdict(self.record))
        self.assertIn("model difference from halfspace: +1.5 % +- ", refinement.table(self.record))
        written = json.loads(refinement.study_json(self.record))["places"][0]
        self.assertEqual(written["reference"], "halfspace")
        self.assertAlmostEqual(written["series"][0]["model_differences"]["max_pressure"]["value"], 1.5 / 100.5, 9)

    def test_errors_of_coefficients_are_relative_to_friction(self):
        found = references(self.record)
        self.assertAlmostEqual(self.record.error("max_pressure", 101.0, found["max_pressure"]), 0.01, 12)
        key = "traction_coefficient:2"
        self.assertAlmostEqual(self.record.error(key, 0.19, found[key]), 0.025, 12)

    def test_orders_come_from_errors_only_where_the_reference_is_known(self):
        def orders(key):
            return self.record.orders(self.place.series[0], key, references(self.record)[key])

        first, *others = orders("max_pressure")
        self.assertIsNone(first)
        np.testing.assert_allclose(others, 2.0, atol=1e-9)
        force = orders("traction_coefficient:2")
        self.assertIsNone(force[1])
        self.assertAlmostEqual(force[3], 1.0, 9)

    def test_files_hold_values_errors_orders_and_the_verdict(self):
        limits = json.loads(refinement.study_json(self.record))["places"][0]["series"][0]["limits"]
        self.assertAlmostEqual(limits["traction_coefficient:2"]["value"], 0.2, 9)
        text = refinement.study_csv(self.record)
        rows = rows_of(text)[1]
        self.assertEqual(len(rows), 8)
        self.assertEqual(rows[6]["quantity"], "max_pressure")
        self.assertAlmostEqual(float(rows[6]["error"]), 1 / 6400, 12)
        self.assertAlmostEqual(float(rows[6]["order"]), 2.0, 9)
        self.assertIn(",halfspace,grid,10,0,100,0,0.1,max_pressure,101,,100,0,exact,0.01,value,\n", text)
        self.assertIn("order 1.00 from the last three levels", refinement.table(self.record))
        # 101, 100.25, ... and 0.19, 0.195, ...: the finest is off by 1/64 and, of mu = 0.4, 0.00125.
        self.assertEqual(refinement.verdict(self.record), "Finest levels against their references: halfspace (grid) p0 0.016 %, "
                         "-F_x/F_z 0.31 % of mu. Of 2 sequences of levels 2 show an order.")

    def test_a_finer_level_gives_the_finest_an_error(self):
        # 0.19, 0.196, ... scatter, so that the finest of them would be its own reference.
        series, key = self.place.series[0], "traction_coefficient:2"
        for level, value in zip(series.levels, (0.19, 0.196, 0.1945, 0.1962)):
            level.values[key] = value
        self.assertEqual(references(self.record)[key].kind, "finest")
        self.assertTrue(self.record.ends_in_itself(self.place, series))
        series.reference = refinement.Level("<160>", 0.0, 25600, 0, 25.6, {"max_pressure": 100 + 4.0**-4, key: 0.1958})
        found = references(self.record)[key]
        self.assertEqual((found.kind, found.value), ("finer level", 0.1958))
        self.assertFalse(self.record.ends_in_itself(self.place, series))
        rows = [row for row in rows_of(refinement.study_csv(self.record))[1] if row["quantity"] == key]
        np.testing.assert_allclose([float(row["error"]) for row in rows], np.abs([0.0058, -0.0002, 0.0013, -0.0004]) / 0.4, rtol=1e-9)
        self.assertIn("0.1 % of mu", refinement.table(self.record))  # 0.0004 of 0.4
        written = json.loads(refinement.study_json(self.record))["places"][0]["series"][0]
        self.assertEqual([level["label"] for level in written["reference_level"]], ["<160>"])
        self.assertEqual(len(written["levels"]), 4)
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {"study.json": refinement.study_json(self.record), "study.csv": refinement.study_csv(self.record)}.items():
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            build(folder)
            with open(os.path.join(folder, "study.html"), encoding="utf-8") as file:
                self.assertIn("reference, finer level &lt;160&gt;", file.read())

    def test_one_level_has_no_order_and_breaks_nothing(self):
        series = self.place.series[0]
        series.levels, series.ratio, self.place.exact = series.levels[:1], 0.0, {}
        self.assertIsNone(series.limit("max_pressure"))
        self.assertEqual(references(self.record)["max_pressure"].kind, "finest")
        self.assertTrue(refinement.table(self.record))

    def test_the_page_has_figures_and_tables_of_every_series(self):
        fem = self.with_fem()
        fem.failure, fem.vary = "ran out of memory", "cell"
        for k, level in enumerate(fem.levels):
            level.values["traction_coefficient:2"] = 0.22 + (-0.001 if k % 2 else 0.002)  # 0.219 against 0.2 at mu = 0.4
        self.place.series.append(refinement.Series("hertz", levels=[refinement.Level("as in the case", 0.0, values={"max_pressure": 100.5})]))
        made = Study({"study.json": refinement.study_json(self.record), "study.csv": refinement.study_csv(self.record)})
        with tempfile.TemporaryDirectory() as folder:
            for name, text in made.contents.items():
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            build(folder)
            with open(os.path.join(folder, "study.html"), encoding="utf-8") as file:
                page = file.read()
            drawn = sorted(os.listdir(os.path.join(folder, "figures")))
        for said in ("a &lt;case&gt;", "half-space, refined in grid", "FEM, refined in cell", "ran out of memory",
                     "half-space (grid) ", "order 2", "no order", "exact", "extrapolated", "model difference from half-space",
                     "+4.75 % of μ", "<th scope=col>largest pressure p<sub>0</sub> [MPa]"):
            self.assertIn(said, page)
        self.assertEqual(drawn, ["error_unknowns.svg", "speed_error.svg", "values.svg"])


def point(xi, pressure, traction, largest, bars, **more):
    scalars = {"longitudinal_creepage": xi, "lateral_creepage": 0.0, "spin": 0.0, "normal_force": 1000.0, "lateral_force": 0.0,
               "longitudinal_force": -1000.0 * traction, "traction_coefficient": traction, "max_pressure": pressure,
               "max_traction": largest, "max_traction_x": largest, "semi_axis_x": 2.0, "semi_axis_y": 3.0, "contact_area": 18.8}
    return {"scalars": {**scalars, **more}, "fields": {}, "error_estimate": bars, "no_bar": {}, "model_error": {}}


def model(name, points, place=None):
    return {"name": name, "label": name, "key": name, "seconds": {"total": 0.5}, "place": place, "points": points}


def made(record):
    """The result that such a record stands for."""
    points = {f"{number:04}": Node(each["scalars"], each["fields"], {name: Node(each[name], {}, {}) for name in (
        "error_estimate", "no_bar", "model_error")}) for number, each in enumerate(record["points"])}
    parts = {"seconds": Node(record["seconds"], {}, {}), "grid": Node({"dx": 1.0, "dy": 1.0}, {}, {}), "points": Node({}, {}, points),
             "notes": Node({}, {"severity": [], "about": [], "text": []}, {})}
    if record["place"]:
        parts["place"] = Node(record["place"], {}, {})
    about = {"model": record["name"], "label": record["label"], "unknowns": 1, "contact_elements": 1}
    return ModelResult(record["key"], Node(about, {}, parts))


REFERENCES = ["halfspace", "fem"]
BARS = {"max_pressure": 1.0, "traction_coefficient": 0.004}


def example():
    """Half-space with error bars, FASTSIM without, Hertz with one point."""
    return [model("hertz", [point(0.0, 101.0, 0.0, 0.0, {})]),
            model("fastsim", [point(0.0, 100.0, 0.0, 0.0, {}), point(0.001, 100.0, 0.19, 30.0, {})]),
            model("halfspace", [point(0.0, 100.0, 0.0, 0.0, dict(BARS)), point(0.001, 100.0, 0.20, 25.0, dict(BARS))])]


def compared(records, name="a"):
    return comparing.Compared(name, "", f"{name}.toml", 0.5, [made(record) for record in records])


def numbers(records, references=REFERENCES):
    return {(n.model, n.point, n.quantity): n for n in comparing.numbers_of(compared(records), references)}


def standings(records, references=REFERENCES):
    return comparing.CaseStandings.of(compared(records), references)


class Comparisons(unittest.TestCase):
    def test_differences_are_relative_to_reference_friction_and_its_pressure(self):
        found = numbers(example())
        pressure = found["hertz", 1, "max_pressure"]
        self.assertEqual((pressure.reference, pressure.error, pressure.differs), ("halfspace", None, False))
        self.assertAlmostEqual(pressure.difference, 0.01, 12)
        self.assertAlmostEqual(pressure.allowed, 0.01, 12)
        force = found["fastsim", 2, "traction_coefficient"]
        self.assertAlmostEqual(force.difference, -0.01 / 0.5, 12)
        self.assertAlmostEqual(force.allowed, 0.004 / 0.5, 12)
        self.assertTrue(force.differs)
        # mu p0 = 50 MPa
        self.assertAlmostEqual(found["fastsim", 2, "max_traction_x"].difference, 5.0 / 50.0, 12)
        # A force that vanishes has its bar; it is the reference.
        force = found["halfspace", 1, "traction_coefficient"]
        self.assertEqual((force.error, force.reference_value), (0.004, None))

    def test_what_a_model_does_not_give_is_not_compared(self):
        for name, _, quantity in numbers(example()):
            self.assertNotIn(quantity, ("approach", "lateral_coefficient"))  # not given; nothing lateral in this case
            self.assertNotEqual((name, quantity), ("hertz", "traction_coefficient"))

    def test_the_lateral_coefficient_rises_against_the_force_on_the_wheel(self):
        sideways = example()
        # -F_y/F_z of 0.12 and 0.15, as positive lateral creepage makes.
        for record, force in zip(sideways[1:], (-120.0, -150.0)):
            record["points"][1]["scalars"]["lateral_force"] = force
        force = numbers(sideways)["fastsim", 2, "lateral_coefficient"]
        self.assertAlmostEqual(force.value, 0.12, 12)
        self.assertAlmostEqual(force.reference_value, 0.15, 12)

    def test_of_a_prescribed_force_the_creepage_is_the_result(self):
        forced = example()
        for record, creepage in zip(forced[1:], (1.0e-3, 1.25e-3)):
            last = record["points"][1]
            last["scalars"].update(traction_coefficient=0.2, longitudinal_creepage=creepage)
            last["no_bar"] = {"lateral_creepage": "given", "spin": "given"}
        forced[1]["points"][1]["no_bar"]["longitudinal_creepage"] = "theory"
        forced[2]["points"][1]["error_estimate"]["longitudinal_creepage"] = 1e-4
        found = numbers(forced)
        creepage = found["fastsim", 2, "longitudinal_creepage"]
        self.assertAlmostEqual(creepage.difference, -0.2, 12)
        self.assertAlmostEqual(creepage.allowed, 0.08, 12)
        self.assertTrue(creepage.differs)
        self.assertEqual(found["halfspace", 2, "longitudinal_creepage"].error, 1e-4)
        self.assertFalse({quantity for _, number, quantity in found if number == 2} & {"traction_coefficient", "lateral_creepage"})
        self.assertIn("xi 20 %", comparing.verdict([standings(forced)]))

    def test_the_wished_reference_is_taken_where_it_has_the_number(self):
        found = numbers(example(), ["hertz", "halfspace"])
        self.assertEqual(found["halfspace", 1, "max_pressure"].reference, "hertz")
        self.assertAlmostEqual(found["halfspace", 1, "max_pressure"].difference, -1 / 101, 12)
        self.assertEqual(found["fastsim", 2, "traction_coefficient"].reference, "halfspace")
        strip, fem = (made(model(name, [])) for name in ("strip", "fem"))
        self.assertIs(comparing.reference_of([strip, fem], REFERENCES), fem)
        self.assertIs(comparing.reference_of([strip], REFERENCES), strip)
        self.assertIsNone(comparing.reference_of([], REFERENCES))

    def test_an_exact_value_is_the_reference_unless_the_other_one_resolves_its_model_error(self):
        def pressure(model_error, name, wished):
            exact = example()
            exact[0]["points"][0].update(no_bar={"max_pressure": "exact"}, model_error={"max_pressure": model_error})
            return numbers(exact, [wished, "halfspace"])[name, 1, "max_pressure"]

        # The half-space's bar is 1 MPa.
        self.assertEqual(pressure(0.9, "halfspace", "").reference, "hertz")
        self.assertAlmostEqual(pressure(0.9, "halfspace", "").difference, -1 / 101, 12)
        self.assertIsNone(pressure(0.9, "hertz", "").reference_value)
        self.assertEqual(pressure(1.1, "hertz", "").reference, "halfspace")
        self.assertEqual(pressure(0.9, "hertz", "halfspace").reference, "halfspace")  # as requested

    def test_the_table_marks_differences_beyond_the_error_bars(self):
        lines = [" ".join(line.split()) for line in comparing.table(standings(example())).splitlines()]
        self.assertEqual(lines, ["p0 semi-axis x semi-axis y -F_x/F_z |p_x| seconds", "% % % % of mu % of mu p0",
                                 "hertz 1.0 0 0 - - 0.5", "fastsim 0 0 0 -2.0* 10* 0.5", "halfspace - - - - - 0.5"])

    def test_the_verdict_names_the_largest_difference_beyond_the_error_bars_of_all_cases(self):
        good, bad = standings(example()), standings(example())
        self.assertEqual(comparing.verdict([good]), "Within the error bars of halfspace: hertz. Beyond them: fastsim "
                         "(-F_x/F_z 2.0 % of mu, |p_x| 10 % of mu p0).")
        for standing in bad.standings:
            if (standing.model, standing.quantity) == ("hertz", "max_pressure"):
                standing.differ = 1
            if standing.quantity == "max_traction_x":
                standing.beyond.value += 10.0  # of mu p0 = 50 MPa
        self.assertEqual(comparing.verdict([good, bad]), "Within the error bars of halfspace: none. Beyond them: hertz "
                         "(p0 1.0 %), fastsim (-F_x/F_z 2.0 % of mu, |p_x| 30 % of mu p0).")
        self.assertEqual(comparing.verdict([]), "")

    def test_places_stand_for_themselves(self):
        # Of the worn wheel: the first patch agrees, the second does not.
        records = [model(name, [point(0.0, 110.0 if (name, patch) == ("fem", 2) else 100.0, 0.0, 0.0, {"max_pressure": 1.0})],
                         {"wheel": "left", "position": 1, "patch": patch, "patches": 2})
                   for patch in (1, 2) for name in ("halfspace", "fem")]
        stand = standings(records)
        of_pressure = [(s.patch, s.compared, s.differ) for s in stand.standings if s.quantity == "max_pressure"]
        self.assertEqual(of_pressure, [(f"left wheel, position 1, patch {k} of 2", 1, k - 1) for k in (1, 2)])
        self.assertEqual(comparing.verdict([stand]), "Within the error bars of halfspace: none. Beyond them: fem (p0 10 %).")
        self.assertIn("10*", comparing.table(stand))

    def test_the_verdict_tells_the_difference_that_the_error_bars_allow_least(self):
        # Point 1 is off by 3 with bars of 4, point 2 by 2 with bars of 1.
        wide, narrow = (comparing.Number("", "fem", k, (0.0, 0.0, 0.0), "traction_coefficient", value, error, None, "halfspace", 0.0,
                                         0.0, 1.0) for k, value, error in ((1, 0.03, 0.04), (2, 0.02, 0.01)))
        one = comparing.CaseStandings("a", comparing.standings_of([wide, narrow]), {"fem": 1.0})
        self.assertEqual(comparing.verdict([one]),
                         "Within the error bars of halfspace: none. Beyond them: fem (-F_x/F_z 2.0 % of mu).")

    def test_files_hold_every_number_and_the_missing_models(self):
        failed = comparing.Compared("=b", "", "b.toml", 0.5, missing=[("fem", "did not converge", True)])
        record = comparing.Record(HEAD, ["hertz", "fastsim", "halfspace", "fem"], "", REFERENCES, [compared(example()), failed])
        found = json.loads(comparing.compare_json(record))
        self.assertEqual([case["complete"] for case in found["cases"]], [True, False])
        self.assertEqual(found["cases"][1]["missing"][0], {"model": "fem", "reason": "did not converge", "failed": True})
        rows = rows_of(comparing.compare_csv(record))[1]
        self.assertEqual(len(rows), len(numbers(example())))
        self.assertEqual({len(row) for row in rows}, {18})


class Published(unittest.TestCase):
    """Published values stand beside the case and the place that they belong to only."""

    STEEL = {f"{body}.{name}": value for body in ("wheel", "rail") for name, value in
             (("young_modulus", 210e3), ("poisson_ratio", 0.3))}
    CASE = {**STEEL, "friction.coefficient": 0.55, "rolling.problem": "steady", "load.normal_force": 50e3, "rail.rolling_radius": math.inf,
            "wheel.rolling_radius": 405.0, "rail.transverse_radius": 2000.0, "wheel.transverse_radius": math.inf}
    PLACED = {"load.vertical_force": 100e3, "wheel.rolling_radius": 450.0, "wheel.profile": "S1002",
              "rail.profile": "UIC60-manchester"}
    LEFT = {"wheel": "left", "position": 1, "patch": 1, "patches": 1, "lateral_shift": 2.0, "yaw": 0.0, "roll": 0.0,
            "y_track": -755.7}

    def names(self, inputs, place=None):
        found = published(Result("", "", "", [made(model("hertz", [], place))], inputs={**self.CASE, **inputs}))
        return [row["name"] for row in found["patch"] + found["creep_curve"]]

    def test_cases_of_the_thesis_are_known_by_their_numbers(self):
        self.assertIn("thesis: Hertz, from a diagram", self.names({}))
        for rail, wheel in ((500.0, math.inf), (2000.0, 105.263), (50.0, -51.282)):
            self.assertEqual(self.names({"rail.transverse_radius": rail, "wheel.transverse_radius": wheel})[:1], ["Hertz, exact"])
        for other in ({"rail.transverse_radius": 501.0}, {"load.normal_force": 60e3}):
            self.assertEqual(self.names(other), [])

    def test_values_of_profiles_belong_to_a_place(self):
        self.assertIn("thesis: SRS (FE)", self.names(self.PLACED, self.LEFT))
        # Another shift; another gauge or inclination.
        for other in ({"lateral_shift": 3.0}, {"y_track": -750.0}):
            self.assertEqual(self.names(self.PLACED, {**self.LEFT, **other}), [])


class Seals(unittest.TestCase):
    def test_a_damaged_file_does_not_fit_its_checksum(self):
        sound = sealed_json({"a": [1, 2.5, {}], "b": "}", "c": "é"})
        self.assertTrue(json_is_sound(sound))
        self.assertEqual({name: value for name, value in json.loads(sound).items() if name != "checksum"},
                         {"a": [1, 2.5, {}], "b": "}", "c": "é"})
        random = np.random.default_rng(1)
        for _ in range(2000):
            at, other = int(random.integers(len(sound))), chr(random.integers(32, 127))
            damaged = (sound[:at], sound[:at] + other + sound[at:], sound[:at] + sound[at + 1:])[random.integers(3)]
            self.assertFalse(json_is_sound(damaged))


class Benches(unittest.TestCase):
    def solved(self, given, name, across):
        case = rollfem._core.parse_case(f"{given.text}[contact_grid]\nelements_across = {across}\n", "bench")
        return models_of(rollfem._core.solve(case, [name], None, False)[0])[0]

    def test_known_pressures_are_those_of_hertz(self):
        for given in benching.CASES[:2]:
            self.assertAlmostEqual(self.solved(given, "hertz", 20)[0]["max_pressure"] / given.max_pressure, 1.0, delta=1e-6)

    def test_known_limits_are_reached_by_fine_grids(self):
        # CONTACT's values, extrapolated, agree with the first case within 0.0005 (README.md), and with the circle's F_x to
        # 0.1 % of full sliding: verification.HalfspaceRolling and .LeadingEdge.
        for given in benching.CASES:
            fine = self.solved(given, "halfspace", 64)
            for number, name, limit, whole in given.limits:
                self.assertAlmostEqual(fine[number][name], limit, delta=1e-3 * whole)

    def test_errors_are_parts_of_the_whole(self):
        given = benching.CASES[1]  # limits 0.13237 and 0.40478, full sliding 0.55
        found = benching.errors_of(given, made(model("m", [point(0.001, 1548.581 * 1.01, 0.13237 - 0.011, 1.0, {}),
                                                                  point(0.004, 1548.581, 0.40478 + 0.0055, 1.0, {})])))
        self.assertAlmostEqual(found["pressure_error"], 0.01, 9)
        self.assertAlmostEqual(found["force_error"], -0.02, 9)
        self.assertTrue(all(abs(value) < whole for case in benching.CASES for *_, value, whole in case.limits))
        self.assertTrue(math.isfinite(found["force_error"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
