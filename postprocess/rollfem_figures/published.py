"""What others have published or computed for a case (published.json), to stand beside our values."""
import json
import math
import os
from functools import lru_cache


@lru_cache(maxsize=1)
def _all():
    with open(os.path.join(os.path.dirname(__file__), "published.json"), encoding="utf-8") as file:
        return json.load(file)


def _is(value, wanted):
    if wanted is None:
        return value is not None and math.isinf(value)
    return value == wanted


def _case(result):
    """The entry whose inputs are all those of the result; empty when there is none."""
    for entry in _all()["cases"].values():
        wanted = {**_all()["common"], **entry["radii"]}
        if all(_is(result.case.get(name), value) for name, value in wanted.items()):
            return entry
    return {}


def creep_curves(result):
    """Rows name, source, xi (list), traction_coefficient (list, -F_x/F_z)."""
    return _case(result).get("creep_curve", [])


def patches(result):
    """Rows name, source, and of semi_axis_x, semi_axis_y (mm), max_pressure (MPa), approach (mm),
    max_traction_x ({"xi", "value" in MPa}) those that are known."""
    return _case(result).get("patch", [])


def sources(result):
    """One sentence for each source of what the case has."""
    rows = patches(result) + creep_curves(result)
    used = dict.fromkeys(row["source"] for row in rows)
    return "; ".join(_all()["sources"][name] for name in used)
