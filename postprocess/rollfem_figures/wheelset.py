"""A wheelset over its lateral shift: the difference of its rolling radii, its contact angles and its
equivalent conicity, from the table that `rollfem wheelset` wrote."""
import csv
import os

import numpy

from .figure import Figure
from .reader import ResultError

BOTH = (("left", "blue", ()), ("right", "slip", (5, 2)))
KINDS = (("wave", "blue", ()), ("harmonic", "slip", (5, 2)))


def read(path):
    """Columns by name, without units; what is not there is nan."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or "conicity_wave [-]" not in rows[0]:
        raise ResultError(f"{path}: not a table of rollfem wheelset")
    return {name.split(" [")[0]: numpy.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def drawn(table):
    """The figure of a table."""
    shift, difference = table["lateral_shift"], table["radius_difference"]
    figure = Figure(3)
    radii = figure.add(290, 210, "rolling radii", "shift to the right [mm]", "right less left [mm]")
    radii.line(shift, difference)
    angles = figure.add(290, 210, "contact angles", "shift to the right [mm]", "contact angle [°]")
    for side, colour, dash in BOTH:
        angles.line(shift, numpy.degrees(table[f"angle_{side}"]), colour, 1.6, dash)
        figure.entry(f"{side} wheel", colour, dash)
    conicity = figure.add(290, 210, "equivalent conicity", "amplitude [mm]", "conicity [-]")
    for kind, colour, dash in KINDS:
        known = numpy.isfinite(table[f"conicity_{kind}"])
        conicity.line(shift[known], table[f"conicity_{kind}"][known], colour, 1.6, dash)
        figure.entry(f"conicity, {kind}", colour, dash)
    figure.seen = (f"Wheelset shifted by 0 to {shift[-1]:.3g} mm: the right rolling radius grows to {difference[-1]:.3g} mm "
                   f"more than the left, the right contact angle to "
                   f"{numpy.degrees(table['angle_right']).max():.3g} degrees.")
    return figure


def draw(path):
    """NAME.svg of a table NAME.csv that `rollfem wheelset` wrote."""
    drawn(read(path)).save(os.path.splitext(path)[0] + ".svg")
