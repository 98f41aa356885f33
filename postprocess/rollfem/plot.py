# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of results; each returns matplotlib axes, created here unless given."""
from typing import Any

import numpy as np

from .frames import package
from .point import ADHESION, QUANTITIES, SLIP, known


def _axes(ax: Any, x: str, y: str) -> Any:
    """The axes to draw on, with their labels."""
    if ax is None:
        ax = package("matplotlib.pyplot", "figures need").subplots(layout="constrained")[1]
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    return ax


def _describe(name: str) -> str:
    return str(QUANTITIES[known(name, QUANTITIES)].label)


def _edges(centres: Any, size: float) -> Any:
    return np.append(centres - 0.5 * size, centres[-1] + 0.5 * size)


def _curve(ax: Any, x: Any, values: Any, bars: Any, **style: Any) -> None:
    """Numbers with their error bars, where there are any."""
    bars = np.nan_to_num(bars)
    ax.errorbar(x, values, bars if bars.any() else None, **{"marker": "o", "markersize": 4, "capsize": 2, **style})


def creep_curve(model: Any, x: str = "longitudinal_creepage", y: str = "traction_coefficient", ax: Any = None, **style: Any) -> Any:
    """One quantity over another, by their names, with error bars where there are any."""
    ax = _axes(ax, _describe(x), _describe(y))
    _curve(ax, model.values(x), model.values(y), model.bars(y), **{"label": model.label or model.name, **style})
    return ax


def creep_curves(result: Any, x: str = "longitudinal_creepage", y: str = "traction_coefficient", ax: Any = None, **style: Any) -> Any:
    """The same for every model and patch with more than one load point; for all if none has."""
    ax = _axes(ax, _describe(x), _describe(y))
    several = [model for model in result if len(model) > 1] or list(result)
    for model in several:
        label = model.label or model.name
        creep_curve(model, x, y, ax, **{"label": label if model.place is None else f"{label}: {model.key}", **style})
    ax.legend()
    return ax


def _map(model: Any, values: Any, ax: Any, label: str, **style: Any) -> Any:
    ax = _axes(ax, "x along rolling (mm)", "y (mm)")
    drawn = ax.pcolormesh(_edges(model.x, model.dx), _edges(model.y, model.dy), values, **style)
    ax.figure.colorbar(drawn, ax=ax, label=label)
    ax.set_aspect("equal")
    return ax


def pressure(model: Any, point: int = 0, ax: Any = None, **style: Any) -> Any:
    """Pressure over the patch at a load point (from 0)."""
    values = model.points[point]["pressure"]
    return _map(model, np.where(values > 0.0, values, np.nan), ax, "pressure (MPa)", **{"cmap": "viridis", **style})


def traction(model: Any, point: int = 0, ax: Any = None, arrows: int = 12, **style: Any) -> Any:
    """Size of the tangential traction over the patch, with arrows of its direction on the wheel, some `arrows` each
    way, and the border between adhesion and slip."""
    at = model.points[point]
    px, py = at["traction_x"], at["traction_y"]
    outside = at["pressure"] <= 0.0
    ax = _map(model, np.where(outside, np.nan, np.hypot(px, py)), ax, "tangential traction (MPa)",
              **{"cmap": "viridis", **style})
    steps = [max(1, round(n / arrows)) for n in px.shape]
    some = tuple(slice(step // 2, None, step) for step in steps)
    kept = ~outside[some]
    grid = np.meshgrid(model.x, model.y)
    ax.quiver(grid[0][some][kept], grid[1][some][kept], px[some][kept], py[some][kept], color="white", angles="xy",
              width=0.008)
    if at.state is not None and (at.state == ADHESION).any() and (at.state == SLIP).any():
        ax.contour(model.x, model.y, (at.state == ADHESION).astype(float), levels=[0.5], colors="black", linewidths=1.0)
    return ax


def path(model: Any, axis: str = "x", point: int = 0, ax: Any = None) -> Any:
    """Tangential traction and its bound along the middle line of the patch: axis "x" or "y"."""
    ax = _axes(ax, f"{axis} (mm)", "traction (MPa)")
    for field, label, line in (("traction_bound", "bound", "--"), ("traction_x", "$p_x$", "-"),
                               ("traction_y", "$p_y$", "-")):
        if field in model.points[point].fields:
            ax.plot(*model.middle(field, axis, point), line, label=label)
    ax.legend()
    return ax


def surface(sweep: Any, quantity: str = "traction_coefficient", ax: Any = None, **style: Any) -> Any:
    """A quantity with its error bars over the first axis of a sweep, a curve for each value of the second, if there is
    one."""
    values, bars = sweep.values(quantity), sweep.bars(quantity)
    names = list(sweep.axes)
    if values.ndim > 2:
        raise ValueError(f"a sweep over {values.ndim} keys does not fit one figure; do: plot slices of sweep.values({quantity!r})")
    from .case import with_unit
    ax = _axes(ax, with_unit(names[0]), _describe(quantity))
    first = np.asarray(sweep.axes[names[0]])
    if values.ndim == 1:
        _curve(ax, first, values, bars, **style)
    else:
        for k, other in enumerate(sweep.axes[names[1]]):
            _curve(ax, first, values[:, k], bars[:, k], **{"label": f"{names[1]} {other:g}", **style})
        ax.legend()
    return ax


def profile(found: Any, ax: Any = None, **style: Any) -> Any:
    """Shape of a profile, z down."""
    ax = _axes(ax, "y, to the field side (mm)", "z, down (mm)")
    ax.plot(found.y, found.z, **style)
    ax.set_aspect("equal")
    ax.invert_yaxis()
    return ax


def curvature(found: Any, ax: Any = None, **style: Any) -> Any:
    """Curvature of a profile over y."""
    ax = _axes(ax, "y, to the field side (mm)", "curvature (1/mm)")
    ax.plot(found.y, found.curvature, **style)
    ax.set_yscale("symlog", linthresh=1e-3)
    return ax
