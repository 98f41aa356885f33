# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conditions on every result at status 0, from the numbers in its files alone: an independent version of the checks
that the program makes before writing (result/validity.cpp)."""
import json
import math

import h5py
import numpy as np

ROUNDING = 1e-6


def not_finite(value):
    if isinstance(value, float):
        return not math.isfinite(value)
    if isinstance(value, dict):
        return any(not_finite(v) for v in value.values())
    return isinstance(value, list) and any(not_finite(v) for v in value)


def _point(point, cell, asked, flat):
    """Sentence on errors in the fields and forces of a load point; empty if there are none."""
    fields = {name: item[()] for name, item in point.items() if isinstance(item, h5py.Dataset)}
    if not all(np.isfinite(field).all() for field in fields.values() if field.dtype.kind == "f"):
        return "a field is not finite"
    if not point.attrs["converged"]:
        return "not converged"
    pressure, bound = fields["pressure"], fields.get("traction_bound")
    if pressure.min() < -ROUNDING * pressure.max():
        return "a tensile pressure"
    under = pressure > 0.0
    if min(under.any(axis=0).sum(), under.any(axis=1).sum()) < 4:
        return "fewer than 4 elements across the patch"
    if under[0].any() or under[-1].any() or under[:, 0].any() or under[:, -1].any():
        return "the patch ends at the border of the grid"
    if bound is not None:
        excess = np.hypot(fields["traction_x"], fields["traction_y"]) - bound
        if excess.max() > ROUNDING * max(bound.max(), 0.0):
            return "a traction beyond the bound of friction"
    force = point.attrs["normal_force"]
    if flat and abs(pressure.sum() * cell - force) > ROUNDING * abs(force):
        return f"the pressures carry {pressure.sum() * cell:.9g} N, not {force:.9g} N"
    if flat and asked is not None and abs(force - asked) > ROUNDING * abs(asked):
        return f"{force:.9g} N are carried where {asked:.9g} N were asked for"
    if asked is not None and point.attrs["approach"] <= 0.0 and "undeformed_distance.quadratic" not in point.file["case/keys"]:
        return "bodies under load that have not come together"
    return ""


def unsound(folder):
    """Errors in a result folder of the model halfspace; empty if there are none."""
    if not_finite(json.loads((folder / "summary.json").read_text())):
        return "a number in summary.json that is not finite"
    with h5py.File(folder / "results.h5") as file:
        keys = file["case/keys"].attrs
        asked = keys.get("load.normal_force")
        if b"given_pressure" in file["case/text"][()]:
            asked = None  # the pressure is the load
        for name, model in file["models"].items():
            flat = b"curved" not in model["notes/about"][()] and "load.vertical_force" not in keys
            cell = model["grid"].attrs["dx"] * model["grid"].attrs["dy"]
            for number, point in model["points"].items():
                wrong = _point(point, cell, asked, flat)
                if wrong:
                    return f"{name}, load point {number}: {wrong}"
    return ""
