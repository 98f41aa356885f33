# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases of `rollfem bench`, with their known solutions."""
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from .. import _core
from ..result import ModelResult, models_of
from .levels import known, reference_model

# Elements across of the half-space, of theories and the hybrid, cells across of finite elements.
GRIDS, QUICK_GRIDS = (24, 40, 80), (24, 40)
OF_THEORIES, OF_HYBRID, CELLS_OF_FEM = 40, 24, 16


@dataclass(frozen=True)
class BenchCase:
    """A case with values of its solution."""

    name: str
    sentence: str
    text: str  #: without its grid
    max_pressure: float | None  #: Hertz's, MPa
    #: Load point, quantity, limit of converged half-spaces (CONTACT's extrapolations agree), value of full sliding.
    limits: tuple[tuple[int, str, float, float], ...]
    of_bodies: bool = False  #: also solved by models that mesh bodies


def _crowned_rail(title: str, radius: float, creepages: str) -> str:
    """Cases of the study of 2012 (cases/thesis_a.toml, thesis_c.toml)."""
    return f"""title = "{title}"
[load]
normal_force = 50e3
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 405.0
transverse_radius = inf
young_modulus = 210e3
poisson_ratio = 0.3
[rail]
transverse_radius = {radius}
young_modulus = 210e3
poisson_ratio = 0.3
[rolling]
longitudinal_creepage = [{creepages}]
"""


CIRCLE = """title = "circle with creepage and spin"
[load]
normal_force = 82e3
[friction]
coefficient = 0.3
[wheel]
young_modulus = 209920.0
poisson_ratio = 0.28
[rail]
young_modulus = 209920.0
poisson_ratio = 0.28
[given_pressure]
semi_axis_x = 6.0
semi_axis_y = 6.0
[rolling]
longitudinal_creepage = -1e-3
lateral_creepage = 5e-4
spin = 1e-4
"""  # cases/benchmark9.toml

_T = "traction_coefficient"
CASES = (
    BenchCase("wide", "ellipse of 7.6 by 21.7 mm, 50 kN, braking at 0.05, 0.2 and 0.4 %",
              _crowned_rail("wide ellipse", 2000.0, "0.0005, 0.002, 0.004"), 578.967,
              ((0, _T, 0.11533, 0.55), (1, _T, 0.37212, 0.55), (2, _T, 0.53012, 0.55)), True),
    BenchCase("narrow", "ellipse of 12.5 by 4.9 mm, 50 kN, braking at 0.1 and 0.4 %",
              _crowned_rail("narrow ellipse", 100.0, "0.001, 0.004"), 1548.581,
              ((0, _T, 0.13237, 0.55), (1, _T, 0.40478, 0.55))),
    BenchCase("spin", "circle of 12 mm under Hertz's pressure, 82 kN, creepage both ways and spin", CIRCLE, None,
              ((0, "longitudinal_force", 10250.5, 24600.0), (0, "lateral_force", -7073.0, 24600.0))))


def case_of(given: BenchCase, model: str, across: int) -> _core.Case:
    """The case with this resolution for the model."""
    def parsed(keys: str) -> _core.Case:
        return _core.parse_case(given.text + keys, f"bench {given.name}")

    if not known()[model]["keeps_bodies"]:
        return parsed(f"[contact_grid]\nelements_across = {across}\n")
    closed_form = next(name for name, of in known().items() if of["frictionless"])
    ellipse = _core.solve(parsed(""), [closed_form], None, False)[0]
    axes = [models_of(ellipse)[0][0][name] for name in ("semi_axis_x", "semi_axis_y")]
    return parsed(f"[fem]\ncell_size = {2 * min(axes) / across!r}\n")


def errors_of(given: BenchCase, result: ModelResult) -> dict[str, float]:
    """pressure_error against Hertz, and force_error, the largest of the forces over full sliding, where there are any."""
    found = {}
    if given.max_pressure and len(result):
        found["pressure_error"] = float(result[0]["max_pressure"] / given.max_pressure - 1)
    if any(point["max_traction"] > 0 for point in result):
        errors = [(float(result[point][name]) - value) / whole for point, name, value, whole in given.limits
                  if point < len(result)]
        found["force_error"] = max(errors, key=abs)
    return found


def _resolutions(model: str, given: BenchCase, quick: bool) -> tuple[int, ...]:
    of = known()[model]
    if model == reference_model():
        return QUICK_GRIDS if quick else GRIDS
    if not of["has_stress"]:
        return (OF_THEORIES,)
    if quick or not given.of_bodies:
        return ()
    return (CELLS_OF_FEM if of["keeps_bodies"] else OF_HYBRID,)


def rows(given: BenchCase, work: _core.Computation, quick: bool) -> Iterator[dict[str, Any]]:
    """{case, model, elements_across, pressure_error, force_error, seconds} of every model and resolution."""
    for name, model in known().items():
        for across in _resolutions(name, given, quick) if model["built"] and not model["chooses"] else ():
            case, begin = case_of(given, name, across), time.perf_counter()
            result, _ = work.solve(case, [name])
            seconds = time.perf_counter() - begin
            if models := models_of(result):  # otherwise it cannot take the case
                grid = {"elements_across": across} if model["ways"] else {}
                yield {"case": given.name, "model": name, **grid, **errors_of(given, models[0]), "seconds": seconds}


def _percent(part: float | None) -> str:
    return "-" if part is None else f"{100 * part if abs(part) >= 5e-6 else 0.0:+.3f} %"


def bench(work: _core.Computation, quick: bool, tell: Callable[[str], object]) -> list[dict[str, Any]]:
    """Errors and seconds of all models, which are also told as text."""
    found = []
    tell(f"rollfem bench: errors and seconds of the models on this machine, {os.cpu_count()} processors\n")
    for given in CASES[:1] if quick else CASES:
        tell(f"\n{given.name}: {given.sentence}\n{'model':<20}{'across':>8}{'p0':>13}{'force':>13}{'seconds':>10}\n")
        for row in rows(given, work, quick):
            found.append(row)
            tell(f"{row['model']:<20}{row.get('elements_across', '-'):>8}{_percent(row.get('pressure_error')):>13}"
                 f"{_percent(row.get('force_error')):>13}{row['seconds']:>10.3f}\n")
    tell("\np0: error against Hertz; force: largest difference from the converged half-space,\nin percent of full sliding; "
         "seconds: all load points of the case together\n")
    return found
