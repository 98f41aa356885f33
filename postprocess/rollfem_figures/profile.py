"""A profile of wheel or rail: its shape with equal axes, and below it the curvature over y."""
import os

import numpy

from .figure import Figure
from .reader import read_columns

LINEAR = 1e-3  # 1/mm: the scale of curvature is linear below, logarithmic beyond: radii from 10 mm to 10 m
DECADE = 0.6  # how long the linear part is, in decades


def joints(s):
    """Indices of the first of the two rows that every joint of the curvature has."""
    return numpy.flatnonzero(numpy.diff(s) == 0.0)


def on_scale(curvature):
    """Where a curvature (1/mm) is on the scale: linear about 0, logarithmic beyond."""
    size = numpy.abs(numpy.asarray(curvature, dtype=float)) / LINEAR
    return numpy.sign(curvature) * numpy.where(size <= 1, DECADE * size, DECADE + numpy.log10(numpy.maximum(size, 1)))


def _ticks(curvature):
    largest = max(numpy.abs(curvature).max(), LINEAR)
    sizes = [10.0**e for e in range(-3, int(numpy.ceil(numpy.log10(largest))) + 1)]
    low, high = 2.0 * min(curvature.min(), 0.0), 2.0 * max(curvature.max(), 0.0)
    shown = [-t for t in sizes if -t >= low] + [0.0] + [t for t in sizes if t <= high]
    return [(float(on_scale(t)), f"{t:g}".replace("-", "−")) for t in sorted(shown)]


def drawn(title, columns):
    """The figure of a profile."""
    y, z, curvature = (columns[name] for name in ("y", "z", "curvature"))
    places = joints(columns["s"])
    figure = Figure(1, title)
    shape = figure.add(560, 0, "", "$y$, to the field side [mm]", "$z$, down [mm]", equal=True)
    shape.line(y, z, "blue", 1.8)
    shape.y.flipped = True
    if len(places):
        shape.line(y[places], z[places], "slip", marker="o", size=3.4, joined=False, order=4)
        figure.entry("joint: the radius changes", "slip", width=0, marker="o")
    bend = figure.add(560, 200, "", "$y$, to the field side [mm]", "curvature [1/mm]")
    for place in places:
        bend.level(y[place], "soft", (3, 2), 0.6, upright=True)
    bend.line(y, on_scale(curvature), "blue", 1.5)
    bend.y.ticks = _ticks(curvature)
    shape.room_left = bend.room_left = 84  # one below the other
    figure.seen = (f"{title}: shape from y = {y.min():.4g} to {y.max():.4g} mm, {numpy.ptp(z):.3g} mm high; curvature "
                   f"from {curvature.min():.3g} to {curvature.max():.3g} 1/mm, {len(places)} joints.")
    return figure


def build(path):
    """NAME.svg of a table NAME.csv that `rollfem profile` wrote."""
    drawn(*read_columns(path, "curvature")).save(os.path.splitext(path)[0] + ".svg")
