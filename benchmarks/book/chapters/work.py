# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frictional work over the profile, and forces in place of creepages: rows for chapters."""
import numpy as np

from .. import closed_forms
from ..chapter import Row, at_most, closest
from .carter import FRICTION, LOAD, ROLLERS, STEEL

A, B, P0, _ = closed_forms.hertz(1 / 810, 1 / 1000, 50e3, 210e3 / (2 * (1 - 0.3**2)))  # of case b
_CASE = """[load]
{load}
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 405.0
transverse_radius = {across_wheel}
young_modulus = {modulus}
[rail]
transverse_radius = {rail}
[rolling]
{rolling}
[contact_grid]
elements_across = {across}
{more}
"""


def run_case(bench, name, motion, across, models=("halfspace",), rail=500.0, modulus=210e3, load="normal_force = 50e3", more="",
             across_wheel="inf"):
    """Case b, or a on a rail of 2000 mm; `motion`: (xi, eta, spin) by load point, or lists by their keys."""
    lists = motion if isinstance(motion, dict) else dict(zip(("longitudinal_creepage", "lateral_creepage", "spin"), map(list, zip(*motion))))
    text = _CASE.format(load=load, rail=rail, modulus=modulus, across=across, more=more, across_wheel=across_wheel,
                        rolling="\n".join(f"{key} = {values}" for key, values in lists.items()))
    return bench.run_text(f"work_{name}_{across}", text, models)


def _power(point):
    """What the creep forces do per length."""
    return -sum(point[creepage] * point[force] for creepage, force in (
        ("longitudinal_creepage", "longitudinal_force"), ("lateral_creepage", "lateral_force"), ("spin", "spin_moment")))


def _whole(model):
    """The model, whose work over the rows must add up to the frictional work."""
    width = np.full(len(model.y), model.dy) if model.width is None else model.width
    for point in model.points:
        assert abs(point.pass_work @ width / point["frictional_work"] - 1) < 1e-12
        assert point.pass_work.max() == point["max_pass_work"]
    return model


def _sliding_rows(bench):
    """w(y) = mu p0 a pi/2 xi (1 - y^2/b^2) in full sliding: elastic slip does no work in a symmetric strip. FASTSIM's parabolic bound
    has 16/9 and the power 3/2."""
    rows, result = [], run_case(bench, "sliding", [(0.05, 0.0, 0.0)], 40, ["halfspace", "fastsim"])
    for name, factor, power, within in (("halfspace", np.pi / 2, 1.0, 2e-3), ("fastsim", 16 / 9, 1.5, 5e-3)):
        model = _whole(result[name])
        t = model.y / B
        work = model.points[0].pass_work / (factor * 0.55 * P0 * A * 0.05)
        exact = np.maximum(0, 1 - t * t) ** power
        rows.append(closest([Row("full sliding: work of a row", "mu p0 a xi", e, w, 6e-3 if abs(at) > 0.95 else within, of=1.0,
                                 of_words="the largest", by=name) for e, w, at in zip(exact, work, t)]))  # the last have few elements
    return rows


def _line_rows(bench):
    """The work per width of Carter's cylinders is what the creep force does, also where slip is a fiftieth of an element."""
    parts, rows = (0.002, 0.02, 0.1, 0.3, 0.6, 0.9, 1.5), []
    for name in ("halfspace", "carter"):
        for across in (16, 64):
            text = ROLLERS.format(load=LOAD, friction=FRICTION, wheel=STEEL, geometry="", across=across,
                                  rolling=f"longitudinal_creepage = {[part * 6e-4 for part in parts]}")
            model, here = _whole(bench.run_text(f"work_line_{name}_{across}", text, [name])[name]), []
            for part, point in zip(parts, model.points):
                exact = FRICTION * LOAD * (1 - max(0.0, 1 - part) ** 2) * part * 6e-4
                bar = point.bar("frictional_work")
                here.append(Row(f"cylinders at {part:g} of the creepage of sliding: work", "N", exact, point["frictional_work"],
                                min(0.5 / across, bar / exact if bar else 1.0), by=f"{name}, {across} elements"))
                assert "revolution_work" not in point.scalars
            rows.append(closest(here))
    return rows


def _small_rows(bench):
    """Where hardly an element slips the work is that of the linear theory, and its place that of fine grids."""
    creepages, rows = [(1e-5, 0.0, 0.0), (1e-4, 0.0, 0.0), (5e-4, 0.0, 0.0)], []
    linear = _power(run_case(bench, "linear", creepages[:1], 40, ["linear"])["linear"].points[0])
    fine = run_case(bench, "small", creepages, 96)["halfspace"]
    for across in (12, 20, 40):
        model = _whole(run_case(bench, "small", creepages, across)["halfspace"])
        rows.append(Row(f"xi = 1e-5, {across} across: work", "N", linear, model.points[0]["frictional_work"], 0.5 / across, by="linear theory"))
        overlap = 0.5 * (model.dy + fine.dy) - np.abs(fine.y[None, :] - model.y[:, None])
        overlap = np.clip(overlap, 0, fine.dy) / model.dy
        held = []
        for point, right in zip(model.points, fine.points):
            at = f"xi = {point['longitudinal_creepage']:g}, {across} across: "
            held.append(Row(f"{at}work in its bar", "N", right["frictional_work"], point["frictional_work"], 1.0,
                            of=point.bar("frictional_work"), of_words="the bar", by="96 across"))
            held += [Row(f"{at}work of a row in its bar", "N/mm", one, other, 1.0, of=point.bar("max_pass_work"), of_words="the bar",
                         by="96 across") for one, other in zip(overlap @ right.pass_work, point.pass_work)]
            assert abs(point["frictional_work"] / point["creepage_work"] - 1) < 1e-9 and point.fields["work"].min() >= 0
        rows.append(closest(held))
    return rows


def _converging_rows(bench):
    """The power of the creep forces on any grid, and the largest work of a row."""
    points = {across: _whole(run_case(bench, "all", [(0.002, 0.001, 1e-4)], across)["halfspace"]).points[0] for across in (20, 40, 80)}
    fine, rows = points[80], []
    for across, allowed in ((20, 0.01), (40, 0.005), (80, None)):
        point = points[across]
        rows.append(Row(f"work, {across} across", "N", point["creepage_work"], point["frictional_work"], 1e-9, by="creep forces"))
        if allowed:
            rows.append(Row(f"largest work of a row, {across} across", "N/mm", fine["max_pass_work"], point["max_pass_work"],
                            min(allowed, point.bar("max_pass_work") / fine["max_pass_work"]), by="80 across"))
            assert abs(point.bar("revolution_work") / point["revolution_work"] - point.bar("frictional_work") / point["frictional_work"]) < 1e-12
    # What elements sum up by themselves lacks what they do not resolve.
    missing = []
    for across in (20, 40):
        model = run_case(bench, "all", [(0.002, 0.001, 1e-4)], across)["halfspace"]
        fields = model.points[0].fields
        own = -model.dx * model.dy * sum(np.sum(fields[f"traction_{axis}"] * fields[f"slip_{axis}"]) for axis in "xy")
        missing.append(abs(model.points[0]["creepage_work"] / own - 1))
    point = points[40]
    alone = 0.4 * point["normal_force"] * point["approach"]
    # Hertz's pressure stores 2/5 F delta; tractions at most mu^2 of it times the ratio of the compliances, which is below 2.
    assert 0.999 * alone < point["elastic_energy"] < (1 + 2 * 0.55**2) * alone
    return [*rows, at_most("work that 40 elements across by themselves lack", "", missing[1], min(0.02, missing[0]))]


def _unlike_rows(bench):
    """Pressure of unlike materials, shifted ahead by friction, closes the distance behind it: rolling resistance."""
    model = run_case(bench, "unlike", [(1e-3, -5e-4, 2e-4)], 40, modulus=1.5e5)["halfspace"]
    point = model.points[0]
    power = _power(point)
    resistance = model.dx * model.dy * np.sum(point.fields["pressure"] * model.x[None, :]) / 405.0
    assert abs(resistance) > 0.05 * power
    return [Row("unlike materials: work of creep forces and rolling resistance", "N", power + resistance, point["creepage_work"], 0.02,
                of=abs(resistance), of_words="the resistance"),
            Row("unlike materials: work of friction", "N", point["creepage_work"], point["frictional_work"], 1e-6, of=power,
                of_words="the power", by="the creepage's")]


def _model_rows(bench):
    """Every model with slip gives its work. Brushes of one flexibility and strips of half-planes obey the identity, three only
    without spin."""
    names, rows = ["carter", "fastsim", "fastrip", "strip"], []
    others = ["hertz", "linear", "vermeulen-johnson", "polach"]
    result = run_case(bench, "models", [(0.002, 0.0, 0.0)], 20, ["halfspace", *names, *others], 2000.0)
    half = result["halfspace"].points[0]["frictional_work"]
    rows = [Row("case a, xi = 0.2 %: work over the half-space's", "", 1.0, _whole(result[name]).points[0]["frictional_work"] / half, 0.15,
                by=name) for name in names]
    assert all("max_pass_work" not in result[name].points[0].scalars for name in others)
    for flexibilities in ("three", "one"):
        spinning = run_case(bench, f"spin_{flexibilities}", [(2e-5, 0.0, 0.0), (1e-3, 5e-4, 3e-4)], 12, names[1:], 2000.0,
                        more=f'[fastsim]\nflexibilities = "{flexibilities}"')
        for name in names[1:]:
            for point in _whole(spinning[name]).points:
                power = _power(point)
                obeys = point["spin"] == 0 or name == "fastrip" or (flexibilities, name) == ("one", "fastsim")
                rows.append(Row(f"case a, spin {point['spin']:g}: work, {flexibilities} flexibilities", "N", power, point["frictional_work"],
                                1e-9 if obeys else 0.3, by=name))
                assert abs(point["creepage_work"] / power - 1) < 1e-9 and point.fields["work"].min() >= 0
    return rows


def work_rows(bench):
    return [*_sliding_rows(bench), *_line_rows(bench), *_small_rows(bench), *_converging_rows(bench), *_unlike_rows(bench), *_model_rows(bench)]


def force_rows(bench):
    """Prescribed forces give back the creepages of their forces, also at a given approach."""
    creepages = [(1e-3, 0.0, 0.0), (2e-3, 1e-3, 2e-4), (-1e-3, 4e-3, 0.0)]
    points = run_case(bench, "forward", creepages, 20)["halfspace"].points
    along, across = ([point[f"{direction}_force"] for point in points] for direction in ("longitudinal", "lateral"))
    found = run_case(bench, "backward", {"longitudinal_force": along, "lateral_force": [float("nan"), *across[1:]],
                                     "spin": [spin for *_, spin in creepages]}, 20)["halfspace"].points
    rows = [closest([Row(f"creepage of given forces: {key}, load point {k + 1}", "", creepages[k][n], point[key], 2e-5,
                         of=float(np.hypot(*creepages[k][:2])), of_words="creepage") for k, point in enumerate(found)
                     for n, key in enumerate(("longitudinal_creepage", "lateral_creepage"))])]
    assert all(point.bar("longitudinal_creepage") > 0 for point in found)
    point = run_case(bench, "approach", {"longitudinal_force": -0.37221 * 50e3}, 20, rail=2000.0,
                 load="approach = 0.04731083")["halfspace"].points[0]
    return [*rows, Row("case a by its approach: F_z", "N", 50e3, point["normal_force"], 0.003),
            Row("case a by its approach: creepage of CONTACT's force at 0.2 %", "", 0.002, point["longitudinal_creepage"], 0.02, by="CONTACT")]
