# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases with pinned numbers: case files of cases/ with changed keys, coarse enough to run in seconds."""
import math
import pathlib
import re
from dataclasses import dataclass, field

THEORIES = ["hertz", "linear", "vermeulen-johnson", "polach", "carter", "fastsim", "fastrip", "strip"]
CREEP = "[0.0, 0.001, 0.003]"
NO_SLIP = {"rolling.extra_slip": '"none"'}
# Slip of the rolling radius across: its key has had two values.
SLIP = [{"rolling.extra_slip": '"rolling-radius"'}, {"rolling.extra_slip": '"auto"'}]
CURVED = {"halfspace.surface": '"curved"'}


@dataclass
class Case:
    """A case file of cases/ with changed keys; None removes a key. Of several `ways` to write it, for programs with
    other keys, the first one that a program reads is run."""

    name: str
    file: str
    meaning: str
    models: list = field(default_factory=lambda: ["halfspace"])
    keys: dict = field(default_factory=dict)
    ways: list = field(default_factory=lambda: [{}])

    def texts(self, cases):
        text = (pathlib.Path(cases) / self.file).read_text("utf-8")
        for way in self.ways:
            yield with_keys(text, {"output.fields": "false", **self.keys, **way})


def without_key(lines, section, key):
    """The lines without the key of the section, which may span several lines."""
    kept, current, depth = [], "", 0
    for line in lines:
        bare = line.split("#")[0]
        if depth > 0:
            depth += bare.count("[") - bare.count("]")
            continue
        header = re.match(r"\s*\[+([\w.]+)\]+\s*$", bare)
        if header:
            current = header[1]
        elif current == section and re.match(rf"\s*{key}\s*=", bare):
            depth = bare.count("[") - bare.count("]")
            continue
        kept.append(line)
    return kept


def with_keys(text, keys):
    """A case file with changed values of keys ("section.key", or "key" before the first section)."""
    lines = text.splitlines()
    for path, value in keys.items():
        section, _, key = path.rpartition(".")
        lines = without_key(lines, section, key)
        if value is None:
            continue
        heads = [i for i, line in enumerate(lines) if re.match(rf"\s*\[{re.escape(section)}\]", line)]
        if not section:
            lines.insert(0, f"{key} = {value}")
        elif heads:
            lines.insert(heads[0] + 1, f"{key} = {value}")
        else:
            lines += ["", f"[{section}]", f"{key} = {value}"]
    return "\n".join(lines) + "\n"


def write_files(folder, cases):
    """Files named by the cases: profiles, a distance and a slip on lattices."""
    profiles = pathlib.Path(folder) / "profiles"
    profiles.mkdir()
    for path in (pathlib.Path(cases) / "profiles").glob("*.csv"):
        (profiles / path.name).write_bytes(path.read_bytes())
    lattice = [(-9.0 + 0.3 * i, -9.0 + 0.3 * k) for k in range(61) for i in range(61)]
    with open(pathlib.Path(folder) / "distance.csv", "w", encoding="utf-8") as file:
        for x, y in lattice:  # case b with a shallow groove along the rail
            groove = 0.002 * math.exp(-(((y - 1.0) / 1.5) ** 2))
            file.write(f"{x:.6f}, {y:.6f}, {x * x / 810.0 + y * y / 1000.0 + groove:.15e}\n")
    with open(pathlib.Path(folder) / "slip.csv", "w", encoding="utf-8") as file:
        for x, y in lattice:
            file.write(f"{x:.6f}, {y:.6f}, {1e-5 * (y * y - 4.0):.15e}, {2e-6 * x * y:.15e}\n")


def thesis(letter):
    return f"thesis_{letter}.toml"


def coarse(across, **keys):
    """Keys of a coarse grid; in names of arguments `__` is the dot of section.key."""
    return {"contact_grid.elements_across": str(across), **{k.replace("__", "."): v for k, v in keys.items()}}


def creep_curves():
    for letter, models in zip("abcdef", [THEORIES] * 3 + [["hertz", "carter", "fastsim", "fastrip", "strip"]] * 3):
        yield Case(f"{letter}", thesis(letter), "creep curve in the tangent plane, no slip of the surface",
                   [*models, "halfspace"], coarse(24, rolling__longitudinal_creepage=CREEP, **NO_SLIP))
    for letter in "ad":
        yield Case(f"{letter}_default", thesis(letter), "unchanged, without a key for the slip of the surface",
                   ["fastsim", "strip", "halfspace"],
                   coarse(20, rolling__longitudinal_creepage="[0.0, 0.001]", rolling__extra_slip=None))
    for letter in "ef":
        yield Case(f"{letter}_slip", thesis(letter), "the rolling radius across, in the tangent plane",
                   ["fastsim", "strip", "halfspace"], coarse(24, rolling__longitudinal_creepage=CREEP), SLIP)
    yield Case("a_spin", thesis("a"), "longitudinal, lateral creepage and spin",
               ["linear", "fastsim", "strip", "halfspace"],
               coarse(24, rolling__longitudinal_creepage="0.0005", rolling__lateral_creepage="[0.0004, -0.001]",
                      rolling__spin="[0.0002, 0.0004]", **NO_SLIP))
    yield Case("a_stress", thesis("a"), "largest stresses", ["halfspace"],
               coarse(20, rolling__longitudinal_creepage="[0.0, 0.002]", output__stress_maxima="true", **NO_SLIP))
    yield Case("b_accuracy", thesis("b"), "cells halved until the error is small enough", ["halfspace"],
               coarse(10, rolling__longitudinal_creepage="[0.0, 0.001]", accuracy="4e-3", **NO_SLIP))
    yield Case("carter_line", "carter_line.toml", "a very wide patch", ["carter", "strip", "halfspace"],
               coarse(16, rolling__longitudinal_creepage="[0.0002, 0.0004]", **NO_SLIP))


def curved():
    """The slip of the surface is included: its key is left out."""
    along = {**CURVED, "rolling.extra_slip": None}
    for letter in "abdef":
        few = {"rolling.longitudinal_creepage": CREEP if letter in "ef" else "[0.0, 0.001]"}
        yield Case(f"{letter}_curved", thesis(letter), "along the common surface", ["halfspace"],
                   {**coarse(24), **few, **along})
    for force in ("longitudinal", "lateral"):
        yield Case(f"e_curved_{force}", thesis("e"), f"{force} force given along the common surface", ["halfspace"],
                   {**coarse(20), "rolling.longitudinal_creepage": None, "rolling.lateral_creepage": None,
                    f"rolling.{force}_force": "-8000.0", **along})
    yield Case("e_curved_approach", thesis("e"), "approach along the common surface", ["halfspace"],
               {**coarse(20), "load.normal_force": None, "load.approach": "0.047",
                "rolling.longitudinal_creepage": "0.001", **along})
    yield Case("e_curved_frictionless", thesis("e"), "the normal problem along the common surface", ["halfspace"],
               {**coarse(20), "rolling.problem": '"frictionless"', "rolling.longitudinal_creepage": None,
                "rolling.lateral_creepage": None, "rolling.spin": None, **along})


def forces():
    b = coarse(24, **NO_SLIP)
    free = {**b, "rolling.longitudinal_creepage": None, "rolling.lateral_creepage": None}
    yield Case("b_force_x", thesis("b"), "longitudinal force given", ["halfspace"],
               {**free, "rolling.longitudinal_force": "[-5000.0, -20000.0]"})
    yield Case("b_force_y", thesis("b"), "lateral force given, with spin", ["halfspace"],
               {**free, "rolling.lateral_force": "6000.0", "rolling.spin": "0.0003"})
    yield Case("b_force_xy", thesis("b"), "both forces given", ["halfspace"],
               {**free, "rolling.longitudinal_force": "[-8000.0, -12000.0]",
                "rolling.lateral_force": "[4000.0, -9000.0]"})
    yield Case("b_approach", thesis("b"), "approach given", ["hertz", "fastsim", "strip", "halfspace"],
               {**b, "load.normal_force": None, "load.approach": "0.05", "rolling.longitudinal_creepage": "0.001"})
    yield Case("b_frictionless", thesis("b"), "the normal problem alone", ["hertz", "halfspace"],
               {**b, "rolling.problem": '"frictionless"', "rolling.longitudinal_creepage": None,
                "rolling.lateral_creepage": None, "rolling.spin": None})
    files = {**b, "contact_grid.elements_across": None, "contact_grid.cell_size": "[0.5, 0.5]",
             "rolling.longitudinal_creepage": "[0.0, 0.001]"}
    yield Case("b_distance_file", thesis("b"), "undeformed distance from a file", ["halfspace"],
               {**files, "contact_grid.cell_size": None, "undeformed_distance.file": '"distance.csv"'})
    yield Case("b_slip_file", thesis("b"), "slip of the surface from a file", ["halfspace"],
               {**files, "rolling.extra_slip": '"file"', "rolling.extra_slip_file": '"slip.csv"'})
    yield Case("unlike_rollers", "unlike_rollers.toml", "aluminium on steel, no force", ["halfspace"],
               coarse(24, **NO_SLIP))
    yield Case("unlike_creep", "unlike_rollers.toml", "aluminium on steel, creepage given", ["halfspace"],
               coarse(20, rolling__longitudinal_force=None, rolling__longitudinal_creepage="[0.0, 0.0005]",
                      **NO_SLIP))


def given_pressure():
    yield Case("benchmark9", "benchmark9.toml", "combined creepage and spin",
               ["linear", "fastsim", "strip", "halfspace"], coarse(40))
    for key, value in (("upwind_order", "first"), ("leading_edge", "plain")):
        yield Case(f"benchmark9_{value}", "benchmark9.toml", f"{key} = {value}", ["halfspace"],
                   coarse(20, **{f"rolling.{key}": f'"{value}"'}))
    yield Case("benchmark9_force", "benchmark9.toml", "force under a given pressure", ["halfspace"],
               coarse(20, load__normal_force=None, given_pressure__max_pressure="1000.0",
                      rolling__longitudinal_creepage=None, rolling__longitudinal_force="9000.0"))


def histories():
    yield Case("cattaneo", "cattaneo.toml", "pushed back and forth", ["hertz", "halfspace"], coarse(24))
    yield Case("cattaneo_force", "cattaneo.toml", "pushed by a force", ["halfspace"],
               coarse(24, history__longitudinal_shift=None, history__steps="4",
                      rolling__longitudinal_force="[1.0, 2.5, 3.2, -1.0]"))
    yield Case("spence", "spence.toml", "unlike bodies pressed together", ["halfspace"],
               coarse(24, history__normal_force="[0.0137, 0.0376, 0.08, 0.146, 0.241, 0.37]"))
    yield Case("transient", "cattaneo_to_carter.toml", "from rest towards steady rolling", ["halfspace"],
               coarse(16, history__steps="8", history__step_length="2.4", **NO_SLIP))
    yield Case("transient_load", "cattaneo_to_carter.toml", "with varying load and creepage", ["halfspace"],
               coarse(16, history__steps=None, history__step_length="1.2", load__normal_force=None,
                      history__normal_force="[40e3, 45e3, 50e3, 45e3]",
                      rolling__longitudinal_creepage="[0.001, 0.001, 0.0, -0.0005]", **NO_SLIP))


def profiles():
    for side in ("left", "right"):
        yield Case(f"s1002_{side}", f"s1002_uic60_{side}.toml", f"the {side} wheel",
                   ["hertz", "fastsim", "strip", "halfspace"],
                   coarse(24, rolling__longitudinal_creepage="[0.0, 0.001, 0.004]", **NO_SLIP))
        yield Case(f"s1002_{side}_curved", f"s1002_uic60_{side}.toml", f"the {side} wheel along the common surface",
                   ["halfspace"], {**coarse(20), "rolling.longitudinal_creepage": "[0.0, 0.001]", **CURVED})
    yield Case("s1002_forces", "s1002_uic60_left.toml", "longitudinal force given", ["halfspace"],
               coarse(20, rolling__longitudinal_creepage=None, rolling__longitudinal_force="-20000.0", **NO_SLIP))
    shift = {"wheelset.lateral_shift": "[0.0, 3.0, 7.0]", "wheelset.yaw": "[0.0, 0.0072, 0.0168]"}
    yield Case("manchester", "manchester_A22.toml", "both wheels roll without torque", ["fastsim", "halfspace"],
               {"contact_grid.cell_size": "[0.4, 0.2]", **shift, **NO_SLIP})
    yield Case("manchester_curved", "manchester_A22.toml", "near the flange, along the common surface", ["halfspace"],
               {"contact_grid.cell_size": "[0.4, 0.4]", "load.vertical_force": "80e3",
                "wheelset.lateral_shift": "-5.0", "wheelset.yaw": "0.0", "wheelset.free_rolling": None, **CURVED})
    yield Case("two_planes", "manchester_A22.toml", "flange and root, which displace each other around a corner",
               ["fastsim", "halfspace"],
               {"contact_grid.cell_size": "[0.6, 0.15]", "load.vertical_force": "50e3", "wheelset.lateral_shift": "5.9",
                "wheelset.yaw": "0.03", "wheelset.roll": "-0.00087", "wheelset.side": '"right"',
                "wheelset.free_rolling": None})
    yield Case("worn", "worn_hollow.toml", "patches that share the load", ["strip", "halfspace"],
               coarse(20, wheelset__lateral_shift="[0.0, 2.0]", **NO_SLIP))


def finite_elements():
    bare = {"rolling.extra_slip": None, "output.body_fields": '"none"'}
    for letter in "aef":
        yield Case(f"{letter}_fem", thesis(letter), "coarse cells, without a key for the slip of the surface", ["fem"],
                   {"fem.cell_size": "0.95", "rolling.longitudinal_creepage": "[0.0, 0.002]", **bare})
    one = {"fem.cell_size": "1.2", "rolling.longitudinal_creepage": "0.001", **bare}
    yield Case("a_fem_spin", thesis("a"), "creepage both ways and spin, approach given", ["fem"],
               {**one, "rolling.lateral_creepage": "0.0004", "rolling.spin": "0.0002", "load.normal_force": None,
                "load.approach": "0.047"})
    yield Case("a_fem_unlike", thesis("a"), "aluminium on steel", ["fem"], {**one, "wheel.young_modulus": "70e3"})
    # Before inertia had a key, the speed alone switched it on.
    yield Case("a_fem_speed", thesis("a"), "inertia of wheel and rail", ["fem"], {**one, "rolling.speed": "80e3"},
               [{"fem.inertia": "true"}, {}])


ALL = [case for group in (creep_curves, curved, forces, given_pressure, histories, profiles, finite_elements)
       for case in group()]
