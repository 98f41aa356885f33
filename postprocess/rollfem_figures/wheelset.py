"""A wheelset over its lateral shift: the difference of its rolling radii, its contact angles and its
equivalent conicity, from the table that `rollfem wheelset` wrote (wheelset.csv) or a run of a row of shifts
(wheelset_rigid.csv; its own wheelset.csv has the loaded patches of each position)."""
import csv
import os

import numpy

from . import looks, places, tables
from .figure import Figure
from .reader import ResultError

BOTH = (("left", "blue", (), "o"), ("right", "slip", (5, 2), "s"))
KINDS = (("wave", "blue", ()), ("harmonic", "slip", (5, 2)))
SHIFT = "shift to the right [mm]"
# Least spans of the scales, so that cones, which have one conicity and one angle, are straight lines.
LEAST_RADIUS, LEAST_ANGLE, LEAST_CONICITY, LEAST_LENGTH = 0.2, 0.5, 0.05, 5.0


def _rows(path):
    """[{column without its unit: text}]."""
    with open(path, encoding="utf-8", newline="") as file:
        return [{name.split(" [")[0]: value for name, value in row.items()} for row in csv.DictReader(file)]


def read(path):
    """Columns by name, without units; what is not there is nan."""
    rows = _rows(path)
    if not rows or "conicity_wave" not in rows[0]:
        raise ResultError(f"{path}: not a table of rollfem wheelset")
    return {name: numpy.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def _conicity(figure, table):
    """Both conicities over the amplitude, and the wave length."""
    panel = figure.add(270, 200, "equivalent conicity", "amplitude [mm]", "conicity [-]")
    panel.y.least = LEAST_CONICITY
    for kind, colour, dash in KINDS:
        known = numpy.isfinite(table[f"conicity_{kind}"])
        panel.line(table["lateral_shift"][known], table[f"conicity_{kind}"][known], colour, 1.6, dash)
        figure.entry(f"conicity, {kind}", colour, dash)
    panel = figure.add(270, 200, "length of the wave", "amplitude [mm]", "[m]")
    panel.y.least = LEAST_LENGTH
    known = numpy.isfinite(table["wave_length"])
    panel.line(table["lateral_shift"][known], 1e-3 * table["wave_length"][known])


def _conicity_seen(table):
    """The conicity in words, at the amplitude nearest to 3 mm that has one."""
    known = numpy.flatnonzero(numpy.isfinite(table["conicity_wave"]))
    if not known.size:
        return "The wheelset does not oscillate."
    at = known[numpy.argmin(abs(table["lateral_shift"][known] - 3.0))]
    return (f"The equivalent conicity at an amplitude of {table['lateral_shift'][at]:.3g} mm is "
            f"{table['conicity_wave'][at]:.3g} by the wave and {table['conicity_harmonic'][at]:.3g} by "
            f"harmonic linearisation.")


def drawn(table):
    """The figure of a table."""
    shift, difference = table["lateral_shift"], table["radius_difference"]
    figure = Figure(2)
    radii = figure.add(270, 200, "rolling radii", SHIFT, "right less left [mm]")
    radii.y.least = LEAST_RADIUS
    radii.line(shift, difference)
    angles = figure.add(270, 200, "contact angles", SHIFT, "contact angle [°]")
    angles.y.least = LEAST_ANGLE
    for side, colour, dash, _ in BOTH:
        angles.line(shift, numpy.degrees(table[f"angle_{side}"]), colour, 1.6, dash)
        figure.entry(f"{side} wheel", colour, dash)
    _conicity(figure, table)
    figure.seen = (f"Wheelset shifted by 0 to {shift[-1]:.3g} mm: the right rolling radius grows to "
                   f"{difference[-1]:.3g} mm "
                   f"more than the left, the right contact angle to "
                   f"{numpy.degrees(table['angle_right']).max():.3g} degrees. {_conicity_seen(table)}")
    return figure


def draw(path):
    """NAME.svg of a table NAME.csv that `rollfem wheelset` wrote."""
    drawn(read(path)).save(os.path.splitext(path)[0] + ".svg")


def _stored(result, name):
    """The path of a table of a run; None where it has none."""
    path = os.path.join(result.directory, name)
    return path if os.path.exists(path) else None


def _both_sides(shift, values, odd):
    """The row and its mirror image: `odd` changes sign, else the other wheel's values are given."""
    mirror = -values if odd is None else odd
    return numpy.concatenate([-shift[:0:-1], shift]), numpy.concatenate([mirror[:0:-1], values])


def of_run(result):
    """Radii, angles and conicity of a run over its row of shifts: lines rigid, markers the loaded patches.
    None without such a row."""
    path = _stored(result, "wheelset_rigid.csv")
    if path is None:
        return None
    table = read(path)
    shift = table["lateral_shift"]
    reference = places.reference_of_row(result)
    loaded = [m.place for m in result.models if m.name == reference and m.place["patch"] == 1]
    lowest = min(place["lateral_shift"] for place in loaded)
    figure = Figure(2)
    radii = figure.add(270, 200, "rolling radii", SHIFT, "right less left [mm]")
    angles = figure.add(270, 200, "contact angles", SHIFT, "contact angle [°]")
    radii.y.least, angles.y.least = LEAST_RADIUS, LEAST_ANGLE

    def line(panel, values, other, colour, dash):
        at, drawn_values = _both_sides(shift, values, other) if lowest < 0 else (shift, values)
        panel.line(at, drawn_values, colour, 1.6, dash)

    line(radii, table["radius_difference"], None, "ink", ())
    for side, colour, dash, marker in BOTH:
        other = "right" if side == "left" else "left"
        line(angles, *(numpy.degrees(table[f"angle_{s}"]) for s in (side, other)), colour, dash)
        here = sorted((p["lateral_shift"], numpy.degrees(p["contact_angle"])) for p in loaded if p["wheel"] == side)
        if here:
            angles.line(*zip(*here), colour, 1.2, marker=marker, joined=False, order=5)
            figure.entry(f"{side} wheel (markers: under load)", colour, dash, marker=marker)
    both = places.radius_differences(loaded)
    if both:
        radii.line(*zip(*both), "ink", 1.2, marker="D", size=2.8, joined=False, order=5)
    figure.entry("right less left (markers: under load)", "ink", marker="D")
    _conicity(figure, table)
    figure.seen = ("Rolling radii, contact angles and equivalent conicity over the lateral shift, up to "
                   f"{shift[-1]:.3g} mm. "
                   + _conicity_seen(table))
    return figure


# Columns of the table of a report: (heading, column of wheelset.csv, factor, significant digits).
COLUMNS = (("shift [mm]", "lateral_shift", 1, None), ("r right − left, rigid [mm]", "rigid_radius_difference", 1, 4),
           ("loaded [mm]", "radius_difference", 1, 4), ("conicity, harmonic", "conicity_harmonic", 1, 4),
           ("wave", "conicity_wave", 1, 4), ("wave length [m]", "wave_length", 1e-3, 4))
OF_WHEEL = (("angle [°]", "contact_angle", 180 / numpy.pi, 4), ("length [mm]", "contact_length", 1, 4),
            ("width [mm]", "contact_width", 1, 4), ("p<sub>0</sub> [MPa]", "max_pressure", 1, 5),
            ("F<sub>x</sub> [kN]", "longitudinal_force", 1e-3, 4), ("F<sub>y</sub> [kN]", "lateral_force", 1e-3, 4))


def _cell(row, column, factor, digits):
    if not row[column]:
        return "–"
    value = factor * float(row[column])
    if digits is None:
        return tables.plain(value)
    return tables.number(0 if abs(value) < 1e-9 else value, digits)


def table_of_run(result):
    """HTML: one line a position, by the model that row figures have; empty without a row of shifts."""
    path = _stored(result, "wheelset.csv")
    rows = _rows(path) if path else []
    if not rows or "wave_length" not in rows[0]:  # of an earlier version
        return ""
    reference = places.reference_of_row(result)
    rows = [row for row in rows if row["model"] == reference and row["point"] == "1"]
    wheels = [side for side in ("left", "right") if any(row[f"{side} patches"] for row in rows)]
    columns = COLUMNS + tuple((f"{side}: {head}", f"{side} {name}", factor, digits)
                              for side in wheels for head, name, factor, digits in OF_WHEEL)
    label = looks.label(next(m for m in result.models if m.name == reference))
    return (tables.table([column[0] for column in columns],
                         [[_cell(row, *column[1:]) for column in columns] for row in rows])
            + f"<p class=hint>Patches by {label} at the first load point; length and width: most loaded patch of a wheel; "
            "forces on the wheel, along the track and to the right. Rigid: without a load. Conicity at the "
            "amplitude of the "
            "shift: by harmonic linearisation, and that of cones with the same wave (UIC 519, EN 15302).</p>")
