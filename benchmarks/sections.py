#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shares of the contacts of a wheel by finite elements of the sections of wheel and rail in place of half-spaces: all
contacts at once, each pressed after Hertz, without friction. The rail is held 36 mm below its top, the wheel 65 mm
above its tread. Needs scipy and gmsh (python3-scipy, python3-gmsh); some ten seconds:

    rollfem profile S1002 -o wheel; rollfem profile UIC60-manchester -o rail
    rollfem run case.toml --model halfspace -o result
    benchmarks/sections.py result rail/profile.csv wheel/profile.csv 50e3
"""

import json
import sys

import gmsh
import numpy as np
from corner import E, NU, Wedge
from scipy.optimize import root
from scipy.special import ellipk

RAIL_HEIGHT, WHEEL_HEIGHT, STEP, SPREAD = 36.0, 65.0, 1.5, 1.5  # mm
OWN_AT = 10.0  # mm along x, far enough from a load of that spread


class Section(Wedge):
    """A body of constant section; the nodes below or above `held` are clamped."""

    def __init__(self, polygon, places, held):
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        corners = [gmsh.model.geo.addPoint(*p, 0) for p in polygon]
        lines = [gmsh.model.geo.addLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
        gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])
        gmsh.model.geo.synchronize()
        distances = [f"Sqrt((x-({y:.9g}))^2+(y-({z:.9g}))^2)" for y, z in places]
        nearest = distances[0]
        for other in distances[1:]:
            nearest = f"(({nearest})+({other})-Fabs(({nearest})-({other})))/2"
        field = gmsh.model.mesh.field.add("MathEval")
        gmsh.model.mesh.field.setString(field, "F", f"0.5+0.25*({nearest})")
        gmsh.model.mesh.field.setAsBackgroundMesh(field)
        for source in ("SizeFromPoints", "SizeExtendFromBoundary", "SizeFromCurvature"):
            gmsh.option.setNumber("Mesh.Mesh" + source, 0)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(2)
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        self.points = coordinates.reshape(-1, 3)[:, :2]
        row_of = {tag: i for i, tag in enumerate(tags)}
        types, _, nodes = gmsh.model.mesh.getElements(2)
        triangles = np.array([row_of[t] for t in nodes[list(types).index(9)]]).reshape(-1, 6)
        gmsh.finalize()
        self.size = 3 * len(self.points)
        is_free = abs(self.points[:, 1] - held) > 1e-6
        self.free = np.flatnonzero(np.repeat(is_free, 3))
        self.parts = self.stiffness(self.points, triangles)
        self.place_of = np.full(self.size, -1)
        self.place_of[self.free] = np.arange(len(self.free))

    def node_at(self, place):
        return int(np.argmin(((self.points - place) ** 2).sum(1)))


def outline(profile, contacts):
    """Of rows s, y, z (upwards), angle: points some STEP apart, the contacts among them, and the contacts' tangents."""
    way, curve = profile[:, 0], profile[:, 1:3]
    steep = np.radians(abs(profile[:, 3]))
    at = np.array([way[np.argmin(abs(curve[:, 0] - y) + 5 * abs(steep - abs(angle)))] for y, angle in contacts])

    def point(s):
        return np.column_stack([np.interp(s, way, curve[:, c]) for c in (0, 1)])
    others = [s for s in np.arange(way[0], way[-1], STEP) if min(abs(s - at)) > 0.4 * STEP]
    tangents = (point(at + 0.2) - point(at - 0.2)) / 0.4
    return point(np.sort(np.concatenate([others, at, way[-1:]]))), point(at), tangents


def influence(profile, contacts, x, floor, inward):
    """Normal displacement at contact j per N at i; on the diagonal less that of the half-space, at OWN_AT."""
    beside, weights = np.polynomial.hermite_e.hermegauss(7)
    own = (1 - NU**2) / (np.pi * E) * (weights / (OWN_AT + SPREAD * beside)).sum() / weights.sum()
    polygon, places, tangents = outline(profile, contacts)
    polygon = np.vstack([polygon, [polygon[-1, 0] + 1e-3, floor], [polygon[0, 0] - 1e-3, floor]])
    body = Section(polygon, places, floor)
    normals = np.column_stack([-tangents[:, 1], tangents[:, 0]])
    normals *= np.sign(normals[:, 1] * inward)[:, None]
    nodes, count = [body.node_at(p) for p in places], len(places)
    found = np.zeros((count, count))
    for i in range(count):
        along = np.array([OWN_AT if i == j else x[j] - x[i] for j in range(count)])
        moved = body.displacements(nodes[i], nodes, along, longest=1e-4, spread=SPREAD)
        for j in range(count):
            found[i, j] = normals[i] @ moved[1:, j, 1:, j] @ normals[j]
        found[i, i] -= own
    return 0.5 * (found + found.T)


def shares(patches, influences, load):
    """Normal forces: w cos(angle) - separation = c N^(2/3) + influences N for each contact, vertically in balance."""
    modulus, count = E / (2 * (1 - NU**2)), len(patches)
    cosines, gaps = (np.array([p[key] for p in patches]) for key in ("cosine", "separation"))
    hertz = np.array([1.5 * p["force"] ** (1 / 3) / (np.pi * modulus * max(p["axes"]))
                      * ellipk(1 - (min(p["axes"]) / max(p["axes"])) ** 2) for p in patches])

    def defect(unknown):
        force, sinking = 1e4 * np.abs(unknown[:count]), 0.1 * unknown[count]
        return np.append(100 * (sinking * cosines - gaps - hertz * force ** (2 / 3) - influences @ force),
                         (force @ cosines - load) / load)
    found = root(defect, np.append([1e-4 * p["force"] for p in patches], 1.0))
    if not found.success:
        raise SystemExit(found.message)
    return 1e4 * np.abs(found.x[:count])


def main(folder, rail_file, wheel_file, load):
    patches = []
    for model in json.load(open(f"{folder}/summary.json", encoding="utf-8"))["models"]:
        place, point = model["place"], model["points"][0]
        patches.append({"force": point["normal_force"], "axes": (point["semi_axis_x"], point["semi_axis_y"]),
                        "cosine": np.cos(place["contact_angle"]), **place})
    x = [p["x_track"] for p in patches]
    rail, wheel = (np.unique(np.genfromtxt(f, delimiter=",", skip_header=2)[:, :4] * [1, 1, -1, 1], axis=0) for f in (rail_file, wheel_file))
    at = {body: [(p["y_" + body], p["contact_angle"]) for p in patches] for body in ("rail", "wheel")}
    floor = rail[:, 2].max() - RAIL_HEIGHT
    whole = influence(rail[rail[:, 2] > floor + 1], at["rail"], x, floor, -1)
    whole += influence(wheel, at["wheel"], x, WHEEL_HEIGHT, 1)
    for name, part in (("no interaction", 0 * whole), ("cross part", whole - np.diag(np.diag(whole))),
                       ("sections wholly", whole)):
        print(f"{name:16s} um/10 kN {(1e7 * part).round(2).tolist()}  N {shares(patches, part, load).round().tolist()}")


if __name__ == "__main__":
    main(*sys.argv[1:4], float(sys.argv[4]))
