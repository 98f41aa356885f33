"""All figures and the report of one result folder."""
import os
from dataclasses import dataclass

from . import curves, looks, maps, overlay, places, selection, stresses, wheelset
from .figure import folder_of
from .reader import read_result
from .report import write_report


def captions(result):
    """(file name, caption, function that draws it or returns None) of every figure."""
    yield ("creep_curve.svg", "Creep curve: traction coefficient of every model with friction, and "
           "beside it the difference from the reference model if there are several. Bars: error "
           "estimates.",
           lambda: curves.creep_curve(result))
    for axis, across in (("x", "y"), ("y", "x")):
        yield (f"path_{axis}.svg",
               f"Along the middle line {across} = 0: contact pressure, and tangential traction under "
               "its bound (thin): μ pₙ, or the theory's own (FASTSIM, strip). Where the two "
               "coincide the surfaces slip.",
               lambda axis=axis: curves.path(result, axis))
    yield ("path_lateral.svg",
           "Lateral traction along both middle lines. It vanishes along y = 0 where nothing drives the "
           "material sideways and the patch is symmetric.", lambda: curves.lateral_paths(result))
    yield ("strip_force.svg",
           "Force per strip: pressure and tangential traction summed along rolling, for each mm of "
           "width. Thin: the same strip sliding fully.", lambda: curves.strip_forces(result))
    yield ("outlines.svg", "Contact areas of all models overlaid, with the border between adhesion "
           "and slip of each; shaded: the zones of the reference model. Material enters on the right.",
           lambda: overlay.outlines(result))
    yield ("contact_area.svg", "Zones of adhesion and slip, model by model.",
           lambda: maps.contact_area(result))
    for model in result.models:
        what = ("px", "Pressure and tangential traction") if model.has_friction else ("pn", "Pressure")
        yield (f"oblique_{what[0]}_{model.name}.svg",
               f"{what[1]} over the patch: {looks.label(model)}.",
               lambda model=model: maps.oblique(result, model))
    for number, kind, body in stresses.lines(result):
        yield (f"stress_{number + 1}.svg", stresses.caption(kind, body),
               lambda number=number: stresses.of_request(result, number))


def place_captions(result):
    """The same for the figures before the patches, when wheel and rail have profiles."""
    numbers = places.positions(result)
    for (wheel, position) in result.profiles:
        if position in (numbers[0], numbers[-1]):
            yield (f"pair_{wheel}_{position:.0f}.svg",
                   f"The {wheel} wheel on its rail{places.at_words(result, position)}, with the contact "
                   "points. Right: the undeformed distance between the two around them.",
                   lambda wheel=wheel, position=position: places.pair(result, wheel, position))
    yield ("wheelset.svg", "The wheelset over its lateral shift: rolling radii and contact angles, without a load "
           "(lines) and under load (markers); equivalent conicity over the amplitude, from the wave of the free "
           "wheelset (UIC 519, EN 15302) and by harmonic linearisation, and the wavelength.",
           lambda: wheelset.of_run(result))
    yield ("positions.svg", "Over the positions: where wheel and rail touch, and the results at the first load "
           "point. Lines: the most loaded patch; single points: further patches; forces: sum over the patches of a "
           "wheel. Filled: left wheel, open: right wheel.", lambda: places.sweep(result))


# With more patches than this, each gets only the most telling figures.
MOST_FULL = 8


def _telling(scene):
    """Beginnings of the names of the figures that every patch of a long row has."""
    reference = selection.reference_for_forces(scene) or selection.reference_for_patch(scene)
    return ("creep_curve", "path_x", "path_y", "outlines", "stress_",
            *(f"oblique_{what}_{reference.name}.svg" for what in ("px", "pn")))


def all_captions(result):
    """Of a whole run: the places of the patches, then the figures of each patch, whose names begin
    with s1_, s2_, ... when there are several."""
    scenes = result.scenes()
    if result.models and result.models[0].place:
        yield from place_captions(result)
    for number, (label, scene) in enumerate(scenes, 1):
        for name, caption, draw in captions(scene):
            if len(scenes) > MOST_FULL and not name.startswith(_telling(scene)):
                continue
            if len(scenes) > 1:
                name, caption = f"s{number}_{name}", f"{label[0].upper()}{label[1:]}. {caption}"
            yield name, caption, draw


@dataclass
class Drawn:
    """A figure: its file in figures/, its caption, and what a page holds of it (Figure.html)."""

    name: str
    caption: str
    html: str


# Fewer figures are drawn before other processes have started.
LEAST_SPREAD = 24


def draw_all(captioned, folder):
    """Draws figures, an iterable of (file name, caption, function that makes a Figure or returns None), and
    writes their files, many on all cores; returns those that there are (Drawn), in their order."""
    captioned = list(captioned)

    def draw(number):
        name, _, function = captioned[number]
        figure = function()
        if figure is None:
            return None
        figure.save(os.path.join(folder, name))
        return figure.html()

    workers = len(os.sched_getaffinity(0)) if len(captioned) >= LEAST_SPREAD else 1
    drawn = _spread(draw, len(captioned), workers) if workers > 1 else map(draw, range(len(captioned)))
    return [Drawn(name, caption, html) for (name, caption, _), html in zip(captioned, drawn) if html]


_task = None  # of the processes that draw: they get it as they are forked, results and all


def _spread(task, count, workers):
    """task(0), ..., task(count - 1) by forked processes, the next numbers to whoever is free."""
    import multiprocessing  # pylint: disable=import-outside-toplevel; half as long as a report takes

    global _task
    _task = task
    with multiprocessing.get_context("fork").Pool(workers) as pool:
        return pool.map(_do_task, range(count), chunksize=4)


def _do_task(number):
    return _task(number)


def build(directory, reference=""):
    """Draws what the result has and writes the report; figures for which it has no data are left
    out. `reference`: name of the model that the others are compared with, where it is there. Returns
    the result and the figures (Drawn)."""
    result = read_result(directory)
    result.reference = reference
    looks.know({model.name: model.label for model in result.models})
    figures = draw_all(all_captions(result), folder_of(result.directory))
    write_report(result, figures)
    return result, figures
