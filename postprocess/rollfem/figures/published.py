# SPDX-License-Identifier: LGPL-2.1-or-later
"""Published values for a case (published.json)."""
import json
import math
import os
from functools import lru_cache


@lru_cache(maxsize=1)
def _all_published():
    with open(os.path.join(os.path.dirname(__file__), "published.json"), encoding="utf-8") as file:
        return json.load(file)


def _is(value, wanted):
    """Whether an input matches the entry: null means flat, a list holds all allowed values; near and within give a
    range."""
    if value is None:
        return False
    if wanted is None:
        return math.isinf(value)
    if isinstance(wanted, list):
        return value in wanted
    if isinstance(wanted, dict):
        return abs(value - wanted["near"]) <= wanted["within"]
    return value == wanted


def _has(values, wanted):
    return all(_is(values.get(name), value) for name, value in wanted.items())


def _published_case(result):
    """The entry whose inputs match the result and whose place matches its patch; empty if there is none. A result with
    several patches has none; pass one of its scenes."""
    places = {m.place["wheel"]: m.place for m in result.models if m.place}
    if len(result.scenes()) > 1 or math.isfinite(result.inputs["rail.rolling_radius"]) or result.prescribed_forces:
        return {}
    for entry in _all_published()["cases"].values():
        wanted = entry.get("place")
        at_place = not places if wanted is None else any(_has(p, wanted) for p in places.values())
        if at_place and _has(result.inputs, {**_all_published()["common"], **entry["inputs"]}):
            return entry
    return {}


def published(result):
    """Published data for the case: `creep_curve`, rows name, source, xi (list), traction_coefficient (list, -F_x/F_z);
    `patch`, rows name, source, and the known ones of semi_axis_x, semi_axis_y, contact_length, contact_width (mm),
    contact_area (mm²), max_pressure (MPa), approach (mm), max_traction_x ({"xi", "value" in MPa}); `says`, remarks of
    the 2012 study; `sources`, one sentence for each. Empty if nothing is published."""
    found = {"creep_curve": [], "patch": [], "says": "", **_published_case(result)}
    used = dict.fromkeys(row["source"] for row in found["patch"] + found["creep_curve"])
    return {**found, "sources": "; ".join(_all_published()["sources"][name] for name in used)}
