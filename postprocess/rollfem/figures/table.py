# SPDX-License-Identifier: LGPL-2.1-or-later
"""table.html: a table of creep forces of `rollfem table` (Table) as surfaces and curves, at the middle load and speed, with its
interpolation error."""
from html import escape

import numpy as np

from .figure import Figure
from .page import hint, section
from .tables import number, plain, table

# For each panel: the force, its name, the axis to the right and the axis to the back.
VIEWS = (("longitudinal_force", "$-F_x/μF_n$", "longitudinal", "spin"),
         ("lateral_force", "$-F_y/μF_n$", "lateral", "spin"),
         ("spin_moment", "$-M_z/(μF_n$ $c)$", "spin", "longitudinal"))
LETTER = {"longitudinal": "ξ′", "lateral": "η′", "spin": "φ′", "axis_ratio": "a/b", "lateral_shift": "lateral shift [mm]",
          "load": "load [N]", "speed": "speed [mm/s]"}
COLOURS = ("blue", "slip", "green", "red", "pink", "sky", "wine")


def _middle(axis):
    """Index of the creepage nearest to 0; of two equally near ones the right one."""
    return int(np.argmin(np.abs(axis) - 1e-12 * np.sign(axis)))


def _first(found):
    """Index of the drawn axis ratio or shift: the middle one."""
    return len(found.axes[found.over]) // 2


def _of_wheel(found, name):
    """Numbers of the wheel over the shifts."""
    return found.wheels[name][len(found.axes["load"]) // 2] if "load" in found.axes else found.wheels[name]


ALL = slice(None)


def _forces(found, force, **at):
    """-force at these indices of the axes, with the other creepages 0 and the middle of the other axes."""
    return -getattr(found, force)[tuple(
        at.get(name, _middle(axis) if name in ("longitudinal", "lateral", "spin") else len(axis) // 2)
        for name, axis in found.axes.items())]


def _plane(found, force, right, back):
    """-force over (back from 0 on, right), with the other creepages 0."""
    order, values = list(found.axes), _forces(found, force, **{right: ALL, back: ALL})
    return (values if order.index(back) < order.index(right) else values.T)[found.axes[back] >= 0]


def _some(count, most):
    """Up to `most` of the numbers below `count`, evenly spaced from the first to the last."""
    return np.unique(np.linspace(0, count - 1, min(most, count)).round().astype(int))


def _even(values):
    """Creepages in the coordinate of the table's axes: even up to 1, then in equal ratios."""
    size = np.abs(values)
    return np.sign(values) * np.where(size <= 1, size, 1 + np.log(np.maximum(size, 1)))


def _oblique(panel, x, y, z, names):
    """A surface as lines that hide what is behind them, from the back to the front."""
    def view(a, b, c):
        return np.stack(np.broadcast_arrays(a + 0.42 * b, 0.5 * b + 0.9 * c), axis=-1)

    a = (_even(x) - _even(x[0])) / np.ptp(_even(x))
    b = (_even(y) - _even(y[0])) / np.ptp(_even(y))
    low, high = min(0.0, z.min()) + 0.0, max(0.0, z.max())
    c = (z - low) / (high - low)
    corners = view(np.array([0, 1, 1, 0, 0]), np.array([0, 0, 1, 1, 0]), -low / (high - low))
    panel.paths([corners], "soft", 0.8, (3, 3), order=1)
    rows = [view(a, b[row], c[row]) for row in range(len(y))]
    for row in range(len(y) - 1, -1, -1):
        order = 2 + len(y) - row
        if row:
            panel.area([np.concatenate([rows[row], rows[row - 1][::-1]])], "ground", order=order)
            panel.paths(list(np.stack([rows[row], rows[row - 1]], axis=1)), "blue", 0.6, opacity=0.45, order=order)
        panel.paths([rows[row]], "blue", 1.3, order=order)
    panel.x.limits, panel.y.limits = (-0.2, 1.6), (-0.3, 1.52)
    text = {"order": 1000, "colour": "ink"}
    for place, axis, (start, end), shift in ((view(np.array([0, 1]), 0, 0), x, (0, -1), (0, 14)),
                                              (view(1, np.array([0, 1]), 0), y, (0, -1), (6, 4))):
        for spot, value in zip(place, (axis[start], axis[end])):
            panel.text(*spot, plain(value), "middle" if axis is x else "start", shift=shift, **text)
    panel.text(*view(0.5, 0, 0), names[0], "middle", shift=(0, 28), **text)
    panel.text(*view(1, 0.5, 0), names[1], shift=(14, 12), **text)
    for level in (low, high):
        spot = view(0, 0, (level - low) / (high - low))
        panel.text(*spot, f"{round(level, 2) + 0.0:.2f}".replace("-", "−"), "end", shift=(-4, 4), **text)
    panel.paths([view(0, 0, np.array([0, 1]))], "soft", 0.9, order=1000)


def _said_first(found, place):
    value = found.axes[found.over][place]
    return f"a/b = {value:.4g}" if found.over == "axis_ratio" else f"lateral shift {value:.4g} mm"


def surfaces(found):
    """The three forces over the creepage that causes them and a second one."""
    result = Figure(3)
    for force, name, right, back in VIEWS:
        panel = result.add(330, 270, name, bare=True)
        behind, across = found.axes[back], found.axes[right]
        shown = across >= (0 if found.over == "lateral_shift" else -np.inf)  # otherwise the surface hides its negative half
        _oblique(panel, across[shown], behind[behind >= 0], _plane(found, force, right, back)[:, shown],
                 (LETTER[right], LETTER[back]))
    result.entry(f"{_said_first(found, _first(found))}; creepages that are not shown are 0")
    return result.tell(f"Surfaces at {_said_first(found, _first(found))}: ", [
        f"{name} over {LETTER[right]} and {LETTER[back]}" for _, name, right, back in VIEWS])


def _charts(size, rows):
    """A figure with panels of that size: title, label of x, of y, and the curves."""
    result = Figure(4 if len(rows) > 3 else 3)
    result.charts(size, [(*row, 0.0, curves) for *row, curves in rows])
    return result


DOTS = {"width": 1.5, "marker": "o", "size": 1.8}


def curves(found):
    """The same as curves."""
    result = _charts((290, 220), [(name, LETTER[right], name, [
        (found.axes[right], values, {"colour": colour, **DOTS}) for values, _, colour in _rows(found, force, right, back)])
        for force, name, right, back in VIEWS])
    for panel, (force, _, right, back) in zip(result.panels, VIEWS):
        for place, (_, value, colour) in enumerate(_rows(found, force, right, back)):
            panel.text(0.97, 0.05 + 0.075 * place, f"{LETTER[back]} = {value:.3g}", "end", colour, share=(True, True))
    return result


def _rows(found, force, right, back):
    """(values over right, value of back, colour) of some curves."""
    behind, values = found.axes[back][found.axes[back] >= 0], _plane(found, force, right, back)
    return [(values[row], behind[row], colour) for row, colour in zip(_some(len(behind), 5), COLOURS)]


def ratios(found):
    """The forces of each creepage alone, with a curve for each axis ratio or some shifts. None for a single one."""
    count = len(found.axes[found.over])
    return None if count < 2 else _charts((290, 220), [(name, LETTER[right], name, [
        (found.axes[right], _forces(found, force, **{found.over: ratio, right: ALL}),
         {"colour": colour, "name": _said_first(found, ratio)}) for ratio, colour in zip(_some(count, 7), COLOURS)])
        for force, name, right, _ in VIEWS])


def _some_from_zero(axes):
    """For every axis, the indices of up to four creepages from 0 to the onset of full sliding, and of the largest."""
    rising = [np.flatnonzero((axis >= 0) & (axis <= 1.2)) for axis in axes]
    count = min(4, *map(len, rising))
    return [[*places[np.linspace(0, len(places) - 1, count).round().astype(int)], len(axis) - 1]
            for axis, places in zip(axes, rising)]


def _over_shifts(found, values, colour, **look):
    """Curves between the shifts where contact jumps."""
    jumps = _of_wheel(found, "jump_after")
    ends = np.flatnonzero(jumps) + 1
    for part in map(slice, [0, *ends], [*ends, len(jumps)]):
        yield found.axes["lateral_shift"][part], values[part], {"colour": colour, **DOTS, **look}


def _shifted(found):
    return found.over == "lateral_shift" and len(found.axes[found.over]) > 1


def shifts(found):
    """Forces of each creepage alone over the shift, gaps where contact jumps. None over axis ratios and for a single
    shift."""
    if not _shifted(found):
        return None
    rights = [right for _, _, right, _ in VIEWS]
    chosen = dict(zip(rights, _some_from_zero([found.axes[right] for right in rights])))
    names = [", ".join(f"{found.axes[right][at] + 0.0:.3g}" for right, at in zip(chosen, places))
             for places in zip(*chosen.values())]
    return _charts((290, 220), [(name, LETTER["lateral_shift"], name, [
        curve for at, colour, values in zip(chosen[right], COLOURS, names)
        for curve in _over_shifts(found, _forces(found, force, **{found.over: ALL, right: at}), colour,
                                  name=f"{', '.join(LETTER[each] for each in chosen)} = {values}")])
        for force, name, right, _ in VIEWS])


# For each panel over the shift: title, unit, factor, and for each curve the legend entry, member, colour and dash.
OF_WHEEL = (("contact angle", "mrad", 1e3, (("contact_angle", "", "blue", ()),)),
            ("rolling radius", "mm", 1, (("rolling_radius", "", "blue", ()),)),
            ("semi-axes of the ellipse", "mm", 1, (("semi_axis_x", "a, along rolling", "blue", ()),
                                                ("semi_axis_y", "b, across", "slip", (5, 2)))),
            ("largest pressure", "MPa", 1, (("max_pressure", "", "blue", ()),)))


def wheels(found):
    """Contact data of the wheel. None over axis ratios and for a single shift."""
    return _charts((230, 200), [(name, LETTER["lateral_shift"], f"{name} [{unit}]", [
        curve for entry, word, colour, dash in entries
        for curve in _over_shifts(found, factor * _of_wheel(found, entry), colour, dash=dash, name=word)])
        for name, unit, factor, entries in OF_WHEEL]) if _shifted(found) else None


def errors(found):
    """Distribution of the interpolation error over the random points. None without points."""
    if not len(found.checked):
        return None
    off = found.checked[:, 4:7] - found.checked[:, 7:10]
    result = Figure(1)
    panel = result.add(420, 220, "interpolation between the points", "error [%]", "fraction of points [%]")
    panel.x.log, panel.y.limits = True, (0, 100)
    share = 100 * (np.arange(len(off)) + 1) / len(off)
    for name, size, colour, dash in (("forces, of $μF_n$", np.hypot(off[:, 0], off[:, 1]), "blue", ()),
                                     ("moment, of $μF_n$ $c$", np.abs(off[:, 2]), "slip", (5, 2))):
        panel.line(np.maximum(100 * np.sort(size), 1e-3), share, colour, 1.6, dash, name=name)
    return result


def captioned(found):
    """The figures of everything."""
    varied = "the ratios of the ellipse's axes" if found.over == "axis_ratio" else "shifts of the wheelset"
    for draw, caption in (
            (surfaces, "Forces on the wheel of opposite sign, over scaled creepages in steps of the table."),
            (curves, "The same as curves; creepages that are not named are 0."),
            (ratios, f"One creepage alone, for {varied}."),
            (shifts, "One creepage alone over the shift; gaps where contact jumps."),
            (wheels, "Contact of the wheel, without friction."),
            (errors, "Fraction of random points with at most this interpolation error.")):
        yield f"table_{draw.__name__}.svg", caption, lambda draw=draw: draw(found)


def _axes(found):
    names = [LETTER[name].capitalize() if " " in LETTER[name] else LETTER[name] for name in found.axes]
    return "".join(f"<p><b>{name}</b> ({len(values)}): {', '.join(f'{v:.4g}' for v in values)}</p>".replace("-", "−")
                   for name, values in zip(names, found.axes.values()))


def _said(found):
    error = found.interpolation

    def percent(value):
        return number(100 * float(value), 2)

    rows = [["largest error bars at the points", percent(found.force_bar.max()), percent(found.moment_bar.max())]]
    said = "Interpolation was not checked."
    if error["points"]:
        rows += [[f"interpolation, {what}", percent(error["force_" + key]), percent(error["moment_" + key])]
                 for key, what in (("rms", "root mean square"), ("95", "95 of 100 points"), ("max", "largest"))]
        said = (f"Interpolation: {error['points']} random points between the grid points (seed {error['seed']}), each "
                "solved separately.")
    return table(["error", "forces [% of μF<sub>n</sub>]", "moment [% of μF<sub>n</sub>c]"], rows) + hint(said)


def _of_what(found):
    if found.over == "axis_ratio":
        return "Creep forces of Hertzian contacts"
    force = _of_wheel(found, "normal_force")
    return (f"Creep forces of a wheel on its rail, friction {number(found.friction_coefficient, 3)}, normal force "
            f"{number(float(force.min()), 6)} to {number(float(force.max()), 6)} N, creepages and forces of the main contact; "
            "a and b are the semi-axes of the equivalent ellipse")


def page(found, drawn):
    """The page of a table."""
    about = found.about
    made = f"{escape(about['program'])}, {escape(about['started'])}<br><code>{escape(about['command'])}</code>"
    return escape(about["title"]), made, [
        f"<p>{_of_what(found)}, {found.force_bar.size} points, Poisson's ratio {number(found.poisson_ratio, 4)}. "
        "Forces are over μF<sub>n</sub>, the moment over μF<sub>n</sub>c, c = √(ab); ξ′ = ξ G ab C<sub>11</sub>/(3μF<sub>n</sub>), "
        "η′ = η G ab C<sub>22</sub>/(3μF<sub>n</sub>), φ′ = φ G (ab)<sup>3/2</sup> √(C<sub>23</sub>² + C<sub>33</sub>²)/(μF<sub>n</sub>).</p>",
        section("Errors", _said(found)),
        section("Forces", "".join(f"<p>At a {name} of {values[len(values) // 2]:g} {LETTER[name].split()[1][1:-1]}.</p>"
                                  for name, values in found.axes.items() if name in ("load", "speed")) + drawn("")),
        section("Axes", _axes(found))], "Beside this file: table.h5, table.csv, interpolation.csv, figures/."
