"""A profile of wheel or rail: its shape with equal axes, and below it the curvature over y."""
import os

import numpy
from matplotlib import pyplot as plt

from . import style


def read(path):
    """Title and columns s, y, z, angle, curvature of a table that `rollfem profile` wrote."""
    with open(path, encoding="utf-8") as table:
        title = table.readline().lstrip("# ").strip()
    columns = numpy.loadtxt(path, delimiter=",", skiprows=2, ndmin=2)
    if columns.shape[1] != 5:
        raise OSError(f"{path}: not a table of a profile")
    return title, columns.T


def joints(s):
    """Indices of the first of the two rows that every joint of the curvature has."""
    return numpy.flatnonzero(numpy.diff(s) == 0.0)


def draw(path, png_folder=None):
    style.use()
    title, (s, y, z, _, curvature) = read(path)
    places = joints(s)
    width, height = max(numpy.ptp(y), 1.0), max(numpy.ptp(z), 1.0)
    shape_height = min(max(6.5 * height / width, 1.2), 6.0)
    figure, (shape, bend) = plt.subplots(
        2, 1, figsize=(7.0, shape_height + 3.0), sharex=True,
        gridspec_kw={"height_ratios": [shape_height, 2.4]}, layout="constrained")
    ink = style.BLUE
    shape.plot(y, z, color=ink, linewidth=1.5)
    shape.plot(y[places], z[places], "o", color=style.SLIP_COLOUR, markeredgecolor="black",
               markeredgewidth=0.5, markersize=4.5, linestyle="none",
               label="joint: the radius changes")
    shape.set_aspect("equal", adjustable="datalim")
    shape.invert_yaxis()
    shape.set_ylabel("z, down [mm]")
    shape.set_title(title)
    shape.tick_params(labelbottom=False)
    for place in places:
        bend.axvline(y[place], color=style.GREY, linewidth=0.6, linestyle=(0, (3, 2)))
    bend.plot(y, curvature, color=ink, linewidth=1.3)
    # Radii from 10 mm to 10 m in one figure: linear about 0, logarithmic beyond.
    bend.set_yscale("symlog", linthresh=1e-3, linscale=0.6)
    bend.set_ylabel("curvature [1/mm]")
    bend.set_xlabel("y, to the field side [mm]")
    largest = max(numpy.abs(curvature).max(), 1e-3)
    exponents = range(-3, int(numpy.ceil(numpy.log10(largest))) + 1)
    ticks = [10.0**e for e in exponents if 10.0**e <= 2.0 * largest]
    shown = [-t for t in reversed(ticks) if -t >= 2.0 * min(curvature.min(), 0.0)]
    shown += [0.0] + [t for t in ticks if t <= 2.0 * max(curvature.max(), 0.0)]
    bend.set_yticks(shown, [f"{t:g}" for t in shown])
    bend.yaxis.set_minor_locator(plt.NullLocator())
    if len(places):
        shape.legend(loc="best")
    style.save(figure, os.path.splitext(path)[0] + ".svg", png_folder)
