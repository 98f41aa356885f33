# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as numpy arrays, read by `reader` or made by the solution.

Units mm, N, MPa, s, rad. Arrays over the contact grid are [ny, nx]; x is the rolling direction,
material enters the patch at large x. Tractions and forces act on the wheel.
"""
import math
from dataclasses import dataclass, field, replace

import numpy as np

EXTERIOR, ADHESION, SLIP, PLASTIC = 0, 1, 2, 3

# Quantities whose error is twice that of another one.
TWICE = {"contact_length": "semi_axis_x", "contact_width": "semi_axis_y"}


class PointRecord:
    """One load point of one model, from a file or from the solution (rollfem.Point).

    `scalars`: longitudinal_creepage, normal_force (N), traction_coefficient = -F_x/F_z, ... as in summary.json.
    `fields`: pressure, traction_x, traction_y, traction_bound (MPa), slip_x, slip_y, gap (mm), state (0 exterior, 1
    adhesion, 2 slip, 3 plastic), ...; fields not given by the model are missing. By quantity: `error_estimate`, the error bar, in
    its unit; `no_bar`, why it has none ("exact", "given", ...);
    `model_error`, in its unit; `richardson`, the value extrapolated to element size 0.
    `subsurface`: dicts for every [[subsurface.*]]: kind, body, points [n, 3], displacement [n, 3], stress [n, 6];
    `stress_maxima`, the largest stresses: dicts body, measure, value (MPa), place [x, y, z] (mm); `bodies`: Bodies of finite
    elements, if stored; otherwise empty. `pass_work` [ny]: frictional work per pass and area of the rows (N/mm), or None.
    `yielded`: {"wheel": ..., "rail": ...} of the bodies that yield, after this pass of the load: dicts of `verdict` ("elastic",
    "elastic shakedown", "plastic shakedown", "ratchetting", "settling"), which holds since `from_pass`; `increment`,
    `net_increment`, of the last whole cycle of load points `cycle_increment`, `cycle_net_increment`; `plastic_strain`,
    `plastic_work` (N mm per mm), `utilisation`, `iterations`, `residual`; of the section behind the load `y`, `depth` (mm)
    and `accumulated` [down, across], plastic `strain` and residual `stress` (MPa) [down, across, 6] (xx, yy, zz, xy, yz, xz;
    x along rolling, tension positive); on the surface `surface_y`, `groove` (negative into the body), `forward_flow`
    [across] (mm). Only y > 0 where half of a symmetric body is modelled. Otherwise empty.
    `x`, `y`, `place`: those of its model.
    """

    yielded = {}  # of records without it

    def __init__(self, record, x, y, place):
        self.__dict__.update(record)
        self.x, self.y, self.place = x, y, place

    @property
    def tangential_coefficient(self):
        """T/F_z, of the tangential tractions alone, as in stress.json: the pressure of a curved patch acts across, too."""
        across = self.scalars["lateral_force"] - self.scalars["lateral_pressure"]
        return math.hypot(self.scalars["longitudinal_force"], across) / self.scalars["normal_force"]


class Point(PointRecord):
    """A load point as figures need it. `number`: of the load point, from 0; `by_number`: what this number counts if it
    identifies the load point, "load point" (steps of a history, prescribed forces) or "pass" (bodies that yield)."""

    def __getitem__(self, name):
        return self.scalars[name]

    def bar(self, quantity):
        """The error bar of a quantity; None if it has none."""
        if quantity not in self.error_estimate and TWICE.get(quantity) in self.error_estimate:
            return 2 * self.error_estimate[TWICE[quantity]]
        return self.error_estimate.get(quantity)

    def found(self, quantity):
        """Whether a creepage or shift is a result: found for a prescribed force. Its statement of the error tells."""
        if word := self.no_bar.get(quantity):
            return word not in ("given", "balance")
        return quantity in self.error_estimate and "spin" not in self.error_estimate  # free rolling has a bar of the spin

    @property
    def creepages(self):
        """(xi, eta, spin)."""
        return tuple(self[n] for n in ("longitudinal_creepage", "lateral_creepage", "spin"))

    @property
    def key(self):
        """Key of a load point within its case, equal in every model: (xi, eta, spin), or (number from 1, what it counts)
        where creepages are results or repeat."""
        return (self.number + 1, self.by_number) if self.by_number else self.creepages


class ModelRecord:
    """All load points of one model on its contact grid, from a file or from the solution (rollfem.ModelResult).

    `name`, `label` (in figures), `key` (name of its group in results.h5: the name, with profiles followed by the patch);
    `seconds`, `unknowns`, `contact_elements`, `notes`; `model_error_source`, source of the model errors, or why there are
    none; `x`, `y`, element centres, and `dx`, `dy` (mm); `y_wheel`, `y_rail`, `width` [ny] of the rows on the profiles
    and along the surface (mm), or None; `place`, with profiles that of the patch: a dict of wheel,
    position, patch, y_track (mm), contact_angle (rad), ...; otherwise None.
    """

    of_point = PointRecord  # type of its load points

    def __init__(self, record):
        self.__dict__.update(record)
        self.points = [self.of_point(point, self.x, self.y, self.place) for point in record["points"]]

    def middle(self, values, axis, at=0.0):
        """`values` [ny, nx] along a line: axis "x" for the line y = at, "y" for x = at.

        The row or column nearest to it; the mean of two if they are equally near.
        """
        across = self.y if axis == "x" else self.x
        distance = np.abs(across - at)
        lines = np.flatnonzero(distance < distance.min() + 1e-6 * (self.dy if axis == "x" else self.dx))
        return values[lines, :].mean(axis=0) if axis == "x" else values[:, lines].mean(axis=1)


class Model(ModelRecord):
    """A model as figures need it."""

    of_point = Point
    _found = None  # points by key, created on first use

    @property
    def has_friction(self):
        """Whether the model covers friction."""
        return any(p["max_traction"] > 0 or any(p.creepages) for p in self.points)

    @property
    def has_bound(self):
        """Whether its tractions have a bound; those of the linear theory do not."""
        return self.name != "linear"

    def at(self, key):
        """The point with that key, (xi, eta, spin) in steady rolling; or None."""
        if self._found is None:
            self._found = {point.key: point for point in reversed(self.points)}
        return self._found.get(key) or next(
            (p for p in self.points if len(p.key) == len(key) == 3
             and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-15) for a, b in zip(p.key, key))), None)

    def nearest(self, longitudinal_creepage):
        """The point whose xi is nearest."""
        return min(self.points, key=lambda p: abs(p["longitudinal_creepage"] - longitudinal_creepage))


@dataclass(frozen=True)
class Quantity:
    """Description of a scalar of a load point."""

    title: str  # for headings: "largest pressure"
    symbol: str  # "F_x", "xi"; empty if there is none
    unit: str  # "-" if it has none
    meaning: str = ""
    percent_of: str = ""  # reference of errors and differences in percent: "value", "mu F_z", ...

    @property
    def label(self):
        """For an axis: "largest pressure (MPa)"."""
        return self.title if self.unit == "-" else f"{self.title} ({self.unit})"


def full_sliding(point, percent_of, friction):
    """Full-sliding value of a quantity whose errors are in percent of `percent_of`; 0 for other quantities."""
    if not percent_of.startswith("mu"):
        return 0.0
    size = {"mu": 1.0, "mu F_z": point["normal_force"], "mu p_0": point["max_pressure"],
            "mu F_z sqrt(ab)": point["normal_force"] * math.sqrt(point["semi_axis_x"] * point["semi_axis_y"])}
    return friction * abs(size[percent_of])


@dataclass
class Result:
    """A whole run."""

    directory: str
    title: str
    case_file: str
    case_text: str
    case: dict
    provenance: dict
    models: list
    quantities: dict = field(default_factory=dict)  # {name: Quantity}, in the order of summary.json
    # with profiles: {(wheel, position): {"rail": [n, 2], "wheel": [n, 2]}}, y and z on the track
    profiles: dict = field(default_factory=dict)
    # name of the reference model, if the user has chosen one
    reference: str = ""
    default_reference: str = ""  # name of the reference model of the command, otherwise the best one of the run
    verdict: str = ""  # one sentence on results that miss the accuracy; otherwise empty

    def scenes(self):
        """(label, Result) of every patch, in the order of the run; ("", self) without profiles."""
        found = {}
        for model in self.models:
            found.setdefault(place_label(model.place), []).append(model)
        if list(found) == [""]:
            return [("", self)]
        return [(label, replace(self, models=models)) for label, models in found.items()]

    def model(self, name):
        """The (first) model of that name; KeyError if the result does not contain it."""
        return {model.name: model for model in reversed(self.models)}[name]


def place_label(place):
    """Label of a patch within a run; empty without profiles."""
    if not place:
        return ""
    text = f"{place['wheel']} wheel, position {place['position']}"
    if place["patches"] > 1:
        text += f", patch {place['patch']} of {place['patches']}"
    return text
