"""A wheelset over its lateral shift: the difference of its rolling radii, its contact angles and its
equivalent conicity, from the table that `rollfem wheelset` wrote (wheelset.csv) or a run of a row of shifts
(wheelset_rigid.csv; its own wheelset.csv has the loaded patches of each position)."""
import os

import numpy

from . import looks, places, tables
from .figure import Figure
from .reader import read_columns, read_rows

BOTH = (("left", "blue", (), "o"), ("right", "slip", (5, 2), "s"))
KINDS = (("wave", "blue", ()), ("harmonic", "slip", (5, 2)))
UNDER_LOAD = " (markers: under load)"
SHIFT = "shift to the right [mm]"
# Least spans of the scales, so that cones, which have one conicity and one angle, are straight lines.
LEAST_RADIUS, LEAST_ANGLE, LEAST_CONICITY, LEAST_LENGTH = 0.2, 0.5, 0.05, 5.0


def _conicity_seen(table):
    """The conicity in words, at the amplitude nearest to 3 mm that has one."""
    known = numpy.flatnonzero(numpy.isfinite(table["conicity_wave"]))
    if not known.size:
        return "The wheelset does not oscillate."
    at = known[numpy.argmin(abs(table["lateral_shift"][known] - 3.0))]
    return (f"The equivalent conicity at an amplitude of {table['lateral_shift'][at]:.3g} mm is "
            f"{table['conicity_wave'][at]:.3g} by the wave and {table['conicity_harmonic'][at]:.3g} by "
            f"harmonic linearisation.")


def _known(table, name, factor=1):
    """A column over the shift, where it has values."""
    known = numpy.isfinite(table[name])
    return table["lateral_shift"][known], factor * table[name][known]


def _radius_differences(loaded):
    """[(lateral shift, right less left rolling radius)]; empty for one wheel."""
    radius = {(p["position"], p["wheel"]): p["rolling_radius"] for p in loaded}
    return sorted((p["lateral_shift"], radius[p["position"], "right"] - radius[p["position"], "left"])
                  for p in loaded if p["wheel"] == "left" and (p["position"], "right") in radius)


def drawn(table, loaded=()):
    """Radii, angles and conicity over the shift: lines rigid; markers `loaded`, the places of the most loaded
    patches of a run. Where some of these are to the left, so are the lines, mirrored."""
    shift, difference = table["lateral_shift"], table["radius_difference"]
    angle = {side: numpy.degrees(table[f"angle_{side}"]) for side in ("left", "right")}
    to_the_left = min((place["lateral_shift"] for place in loaded), default=0) < 0

    def line(values, mirrored, **look):
        if not to_the_left:
            return shift, values, look
        return numpy.concatenate([-shift[:0:-1], shift]), numpy.concatenate([mirrored[:0:-1], values]), look

    def markers(spots, **look):
        return [(*zip(*spots), {**look, "joined": False, "order": 5})] if spots else []

    figure = Figure(2)
    differences = _radius_differences(loaded)
    radii = [line(difference, -difference), *markers(differences, marker="D", size=2.8)]
    angles = []
    for (side, colour, dash, marker), other in zip(BOTH, ("right", "left")):
        spots = sorted((p["lateral_shift"], numpy.degrees(p["contact_angle"])) for p in loaded if p["wheel"] == side)
        angles += [line(angle[side], angle[other], colour=colour, dash=dash), *markers(spots, colour=colour, marker=marker)]
        figure.entry(f"{side} wheel" + UNDER_LOAD * bool(spots), colour, dash, marker=marker if spots else None)
    if differences:
        figure.entry("right less left" + UNDER_LOAD, "ink", marker="D")
    for kind, colour, dash in KINDS:
        figure.entry(f"conicity, {kind}", colour, dash)
    figure.charts((270, 200), [
        ("rolling radii", SHIFT, "right less left [mm]", LEAST_RADIUS, radii),
        ("contact angles", SHIFT, "contact angle [°]", LEAST_ANGLE, angles),
        ("equivalent conicity", "amplitude [mm]", "conicity [-]", LEAST_CONICITY,
         [(*_known(table, f"conicity_{kind}"), {"colour": colour, "dash": dash}) for kind, colour, dash in KINDS]),
        ("length of the wave", "amplitude [mm]", "[m]", LEAST_LENGTH, [(*_known(table, "wave_length", 1e-3), {})])])
    figure.seen = (f"Wheelset shifted by 0 to {shift[-1]:.3g} mm: the right rolling radius grows to {difference[-1]:.3g} mm "
                   f"more than the left, the right contact angle to {angle['right'].max():.3g} degrees. "
                   f"{_conicity_seen(table)}")
    return figure


def build(path):
    """NAME.svg of a table NAME.csv that `rollfem wheelset` wrote."""
    drawn(read_columns(path, "conicity_wave")[1]).save(os.path.splitext(path)[0] + ".svg")


def of_run(result):
    """The figure of a run over its row of shifts. None without such a row."""
    path = os.path.join(result.directory, "wheelset_rigid.csv")
    if not os.path.exists(path):
        return None
    reference = places.reference_of_row(result)
    return drawn(read_columns(path, "conicity_wave")[1],
                 [m.place for m in result.models if m.name == reference and m.place["patch"] == 1])


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
    path = os.path.join(result.directory, "wheelset.csv")
    if not os.path.exists(path):
        return ""
    reference = places.reference_of_row(result)
    rows = [row for row in read_rows(path)[1] if row["model"] == reference and row["point"] == "1"]
    wheels = [side for side in ("left", "right") if any(row[f"{side} patches"] for row in rows)]
    columns = COLUMNS + tuple((f"{side}: {head}", f"{side} {name}", factor, digits)
                              for side in wheels for head, name, factor, digits in OF_WHEEL)
    return (tables.table([column[0] for column in columns],
                         [[_cell(row, *column[1:]) for column in columns] for row in rows])
            + f"<p class=hint>Patches by {looks.label(reference)} at the first load point; length and width: most loaded patch of a wheel; "
            "forces on the wheel, along the track and to the right. Rigid: without a load. Conicity at the "
            "amplitude of the "
            "shift: by harmonic linearisation, and that of cones with the same wave (UIC 519, EN 15302).</p>")
