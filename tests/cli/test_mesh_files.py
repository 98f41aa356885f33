# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that cannot be used: files that are wrong (tests/refusals/mesh.txt), and hexahedra of the wrong size, folded, in parts,
without sides, off the surface."""

import math
import struct
from types import SimpleNamespace

import numpy as np
import pytest
from program import needs_fem, package, says, solved
from test_refusals import changed as edited
from test_refusals import rows

pytestmark = needs_fem
RAIL = {"load.normal_force": 5e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 400.0, "wheel.transverse_radius": math.inf,
        "rail.transverse_radius": 100.0}
LINES, DEPTHS = [-16, -7, -3, 1, 4, 8, 16], [-12, -5, -2, 0]


def block(x, y, z, place=lambda points: points, symmetric=False):
    """Cells between these coordinates: the top is `contact`, other sides are `fixed`, or `symmetry` at the first of y."""
    n = np.arange(len(x) * len(y) * len(z)).reshape(len(z), len(y), len(x))
    low, high = slice(None, -1), slice(1, None)
    turns = (low, low), (low, high), (high, high), (high, low)

    def quads(*faces):
        return [list(quad) for face in faces for quad in np.stack([face[turn] for turn in turns], -1).reshape(-1, 4)]

    cells = np.stack([n[(level, *turn)] for level in (low, high) for turn in turns], -1).reshape(-1, 8)
    sides = {"contact": quads(n[-1]), "fixed": quads(n[0], n[:, -1], n[:, :, 0], n[:, :, -1])}
    sides.setdefault("symmetry" if symmetric else "fixed", []).extend(quads(n[:, 0]))
    points = np.stack(np.meshgrid(z, y, x, indexing="ij")[::-1], -1).reshape(-1, 3)
    return SimpleNamespace(points=[list(map(float, point)) for point in place(points)], cells=cells.tolist(), sides=sides)


def msh(mesh):
    """In gmsh's format 2.2."""
    elements = [(3, group, quad) for group, quads in enumerate(mesh.sides.values(), 1) for quad in quads]
    elements += [(5, 9, cell) for cell in mesh.cells]
    return "\n".join([
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", str(len(mesh.sides)),
        *(f'2 {group} "{name}"' for group, name in enumerate(mesh.sides, 1)), "$EndPhysicalNames\n$Nodes", str(len(mesh.points)),
        *(f"{number} {x!r} {y!r} {z!r}" for number, (x, y, z) in enumerate(mesh.points, 1)), "$EndNodes\n$Elements",
        str(len(elements)),
        *(f"{number} {kind} 2 {group} {group} " + " ".join(str(corner + 1) for corner in corners)
          for number, (kind, group, corners) in enumerate(elements, 1)), "$EndElements\n"])


def refused(mesh, folder):
    """The message about a mesh or the text of one."""
    file = folder / "rail.msh"
    file.write_bytes(mesh if isinstance(mesh, bytes) else msh(mesh).encode())
    with pytest.raises(package().InputError) as refusal:
        solved(RAIL | {"rail.mesh": str(file)}, "fem")
    says(str(refusal.value), "rail.mesh = ", "do: ")
    return str(refusal.value)


@pytest.mark.parametrize("base, change, parts", rows("mesh.txt"))
def test_files_are_refused_with_the_line(tmp_path, base, change, parts):
    says(refused(edited(base, change), tmp_path), *parts)


NUMBERS = b"$MeshFormat\n4.1 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Nodes\n"


@pytest.mark.parametrize("binary, said", [
    (b"$MeshFormat\n4.1 1 8\n" + struct.pack(">i", 1), "byte 20: the numbers are in another byte order"),
    (b"$MeshFormat\n4.1 1 8\n", "byte 20: the file ends before the number 1"),
    (NUMBERS + struct.pack("<qq", 1, 2**63 - 1) + 40 * b" ",
     f"byte {len(NUMBERS) + 8}: the number of nodes is 9223372036854775807, but the rest")])
def test_binary_files_are_refused_with_the_byte(tmp_path, binary, said):
    assert said in refused(binary, tmp_path)


def small():
    return block([-15, 0, 15], [-15, 0, 15], [-30, -15, 0])


def changed(change):
    mesh = small()
    change(mesh)
    return mesh


def joined(*others):
    """Meshes in one file."""
    mesh = small()
    for other in others:
        first = len(mesh.points)
        mesh.points += other.points
        mesh.cells += [[first + corner for corner in cell] for cell in other.cells]
        for name, quads in other.sides.items():
            mesh.sides[name] += [[first + corner for corner in quad] for quad in quads]
    return mesh


def folded():
    """A second cell under the same top face, but deeper."""
    mesh = block([-15, 15], [-15, 15], [-30, 0])
    mesh.points += [[x, y, -40.0] for x, y, z in mesh.points[:4]]
    mesh.cells.append([8, 9, 11, 10, *mesh.cells[0][4:]])
    return mesh


def joined_by_an_edge():
    mesh, other = block([-15, 0], [-15, 0], [-30, 0]), block([0, 15], [0, 15], [-30, 0])
    mesh.points += other.points
    mesh.cells.append([3, 9, 11, 10, 7, 13, 15, 14])
    return mesh


@pytest.mark.parametrize("mesh, said", [
    (changed(lambda m: m.points.__setitem__(13, [0.0, 0.0, 14.0])), "inverted"),  # the node in the middle, through the top
    (changed(lambda m: m.sides.pop("contact")), "no surface group `contact`"),
    (changed(lambda m: m.sides.pop("fixed")), "no surface group `fixed`"),
    (changed(lambda m: m.sides["contact"].append([9, 10, 13, 12])), "inside the body"),
    (changed(lambda m: m.sides["contact"].append([0, 1, 2, 26])), "not a face of a hexahedron"),
    (changed(lambda m: m.cells.clear()), "not a face of a hexahedron"),
    (changed(lambda m: (m.cells.clear(), m.sides.clear())), "no hexahedra"),
    (changed(lambda m: m.cells.extend(m.cells[0][k:4] + m.cells[0][:k] + m.cells[0][4 + k:] + m.cells[0][4:4 + k] for k in (1, 2))), "cells share the face"),
    (folded(), "two cells lie on the same side of the face they share"),
    # Apart; side by side with doubled nodes; side by side with nodes in the middle of edges; joined by an edge only.
    (joined(block([45, 60], [0, 15], [-30, 0])), "consists of 2 parts"),
    (joined(block([15, 30, 45], [-15, 0, 15], [-30, -15, 0])), "do not match"),
    (joined(block([15, 45], [-15, 15], [-30, 0])), "do not match"), (joined_by_an_edge(), "consists of 2 parts")])
def test_unusable_meshes_are_refused(tmp_path, mesh, said):
    assert said in refused(mesh, tmp_path)


def on_surface(points, radius=100.0, scale=1.0, shift=(0, 0, 0)):
    """On the running surface of a rail of this radius, then moved."""
    x, y, z = points.T
    return scale * np.transpose([x, y, z - radius + np.sqrt(radius**2 - y**2)]) + shift


def given(y=LINES, symmetric=False, **moved):
    return block(LINES, y, DEPTHS, lambda points: on_surface(points, **moved), symmetric)


def on_the_other_side():
    """Of the plane of symmetry."""
    mesh = given([-16, -4, 0])
    plane = [quad for quad in mesh.sides["fixed"] if all(mesh.points[corner][1] == 0 for corner in quad)]
    mesh.sides["symmetry"] = plane
    mesh.sides["fixed"] = [quad for quad in mesh.sides["fixed"] if quad not in plane]
    return mesh


@pytest.mark.parametrize("mesh, said", [
    (given(scale=1e-3), "coordinates in mm"), (given(scale=1e6), "coordinates in mm"),
    (given(shift=(0, 0, -1)), "away from the surface"), (given(radius=130), "away from the surface"),
    (given(shift=(25, 0, 0)), "the contact needs"),
    (given([0, 4, 16], symmetric=True, shift=(0, 0.5, 0)), "`symmetry` lies at y = 0.5"),
    (on_the_other_side(), "on the other side")])
def test_meshes_off_the_surface_are_refused(tmp_path, mesh, said):
    assert said in refused(mesh, tmp_path)
