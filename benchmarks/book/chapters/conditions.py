# SPDX-License-Identifier: LGPL-2.1-or-later
"""The conditions of contact, with distance and displacement recomputed: the book's own coefficients summed element by element, without
the transforms, differences and solvers that found the solution."""
import numpy as np
from rollfem.point import ADHESION, EXTERIOR

from .. import turned_half_space
from ..chapter import at_most
from .work import run_case

MOTION = [(0.0, 0.0, 0.0), (1e-3, -5e-4, 2e-4), (5e-3, 0.0, 0.0)]
STEEL = (210e3, 0.3)


def _displacement(model, point, wheel=STEEL, rail=STEEL, tangential=True):
    """(u_x, u_y, u_n) of the wheel less the rail by the sum over all elements."""
    (g1, nu1), (g2, nu2) = ((young / (2 * (1 + nu)), nu) for young, nu in (wheel, rail))
    shear = 2 / (1 / g1 + 1 / g2)
    poisson = shear * (nu1 / g1 + nu2 / g2) / 2
    unlike = ((1 - 2 * nu1) / g1 - (1 - 2 * nu2) / g2) / (4 * np.pi)
    y, x = (axis.ravel() for axis in np.meshgrid(model.y, model.x, indexing="ij"))
    away = x[:, None] - x, y[:, None] - y
    xx, yy, xy, nn = turned_half_space.coefficients(*away, model.dx, model.dy, shear, poisson)
    xn, yn = (-unlike * integral for integral in turned_half_space.coupling(*away, model.dx, model.dy))
    px, py, pn = (point.fields[name].ravel() * (tangential or name == "pressure") for name in ("traction_x", "traction_y", "pressure"))
    u = xx @ px + xy @ py + xn @ pn, xy @ px + yy @ py + yn @ pn, nn @ pn - xn @ px - yn @ py
    return [part.reshape(point.fields["pressure"].shape) for part in u]


def _gap_left(model, point, normal):
    """Violation of p >= 0, gap >= 0 and p gap = 0 on the parabolas of case b, over the approach."""
    gap = model.x[None, :] ** 2 / 810 + model.y[:, None] ** 2 / 1000 + normal - point["approach"]
    assert np.abs(point.fields["gap"] - gap).max() < 1e-9 * point["approach"] and point.fields["pressure"].min() >= 0
    return np.where(point.fields["pressure"] > 0, np.abs(gap), -gap).max() / point["approach"]


def _coulomb_left(model, point):
    """Slip in adhesion and slip that the traction does not oppose, over the largest slip; tractions beyond or below the bound, over the
    largest bound; by first-order differences of the sum, with the spin where CONTACT has it."""
    u_x, u_y, _ = _displacement(model, point)
    fields, inside = point.fields, point.fields["state"][:, :-1] != EXTERIOR
    xi, eta, phi = point.creepages
    w_x = (xi - phi * model.y[:, None] + (u_x[:, :-1] - u_x[:, 1:]) / model.dx)[inside]
    w_y = (eta + phi * (model.x[None, :-1] + model.dx / 6) + (u_y[:, :-1] - u_y[:, 1:]) / model.dx)[inside]
    p_x, p_y, bound, adheres = (fields[name][:, :-1][inside] for name in ("traction_x", "traction_y", "pressure", "state"))
    bound, adheres, slip, size = 0.55 * bound, adheres == ADHESION, np.hypot(w_x, w_y), np.hypot(p_x, p_y)
    assert 0.2 < point["adhesion_area"] / point["contact_area"] < 0.9 or point.number == 2
    off = np.maximum(np.abs(w_x + slip * p_x / bound), np.abs(w_y + slip * p_y / bound))[~adheres]
    beyond = np.where(adheres, size - bound, np.abs(size - bound)).max()
    return max(slip[adheres].max(initial=0.0), off.max()) / slip.max(), beyond / fields["traction_bound"].max()


def condition_rows(bench):
    alike = run_case(bench, "gap", MOTION, 16)["halfspace"]
    rows = [at_most("gap of like materials by Love's sum", "", max(_gap_left(alike, p, _displacement(alike, p)[2]) for p in alike.points),
                    2e-8, by="over the approach")]
    soft = (70e3, 0.33)
    model = run_case(bench, "gap_unlike", MOTION, 12, modulus=f"{soft[0]}\npoisson_ratio = {soft[1]}")["halfspace"]
    rows.append(at_most("gap of unlike materials by the sum of all tractions", "", max(
        _gap_left(model, p, _displacement(model, p, soft)[2]) for p in model.points), 1e-6, by="over the approach"))
    for point in model.points:  # friction moves the surfaces apart and together: without it the gap is not closed
        without, whole = (_displacement(model, point, soft, tangential=both)[2] for both in (False, True))
        assert point["max_traction"] == 0 or np.abs(without - whole).max() > 1e-3 * point["approach"]
    curved = run_case(bench, "gap_curved", MOTION, 24, rail=50.0, more='[halfspace]\nsurface = "curved"', across_wheel=-51.282)["halfspace"]
    rows.append(at_most("gap of a curved patch", "", max(np.where(p.fields["pressure"] > 0, np.abs(p.fields["gap"]), -p.fields["gap"]).max()
                                                        / p["approach"] for p in curved.points), 1e-7, by="over the approach"))
    assert all(p.fields["gap"].max() > 0.05 * p["approach"] for p in curved.points)
    motion = dict(zip(("longitudinal_creepage", "lateral_creepage", "spin"), map(list, zip(*MOTION))))
    model = run_case(bench, "coulomb", {**motion, "upwind_order": '"first"'}, 16)["halfspace"]
    slip, bound = map(max, zip(*(_coulomb_left(model, point) for point in model.points[1:])))
    return [*rows, at_most("Coulomb's law by differences of the sum: slip", "", slip, 1e-5, by="over the largest"),
            at_most("Coulomb's law by differences of the sum: bound", "", bound, 1e-5, by="over the largest")]
