"""All figures and the report of one result folder."""
import multiprocessing
import os

from . import curves, lateral, maps, overlay, places, stresses, style
from .reader import read_result
from .report import write_report


def captions(result):
    """(file name, caption, function that draws it or returns None) of every figure."""
    yield ("creep_curve.svg", "Creep curve: traction coefficient of every model with friction, and "
           "below its difference to the reference model where there are several. Bars: error "
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
           "material sideways and the patch is symmetric.", lambda: lateral.paths(result))
    yield ("strip_force.svg",
           "Force per strip: pressure and tangential traction summed along rolling, for each mm of "
           "width. Thin: the same strip sliding fully.", lambda: curves.strip_forces(result))
    yield ("outlines.svg", "Contact areas of all models on each other, with the border between adhesion "
           "and slip of each; shaded: the zones of the reference model. Material enters on the right.",
           lambda: overlay.outlines(result))
    yield ("contact_area.svg", "Zones of adhesion and slip, model by model.",
           lambda: maps.contact_area(result))
    for model in result.models:
        what = ("px", "Pressure and tangential traction") if model.has_friction else ("pn", "Pressure")
        yield (f"oblique_{what[0]}_{model.name}.svg",
               f"{what[1]} over the patch: {style.label(model)}.",
               lambda model=model: maps.oblique(result, model))
    for number, kind, body in stresses.lines(result):
        yield (f"stress_{number + 1}.svg", stresses.caption(kind, body),
               lambda number=number: stresses.along_line(result, number))


def place_captions(result):
    """The same for what comes before the patches when wheel and rail have profiles."""
    numbers = places.positions(result)
    for (wheel, position) in result.profiles:
        if position in (numbers[0], numbers[-1]):
            yield (f"pair_{wheel}_{position:.0f}.svg",
                   f"The {wheel} wheel on its rail at position {position:.0f}, with the contact "
                   "points. Right: how far apart the two are beside them before they are pressed together.",
                   lambda wheel=wheel, position=position: places.pair(result, wheel, position))
    yield ("positions.svg", "Along the row of positions: where wheel and rail touch, and what comes of "
           "it at the first load point. Lines: the most loaded patch; single points: further patches. "
           "Full: left wheel, open: right wheel.", lambda: places.sweep(result))


# Of a row of positions, so many patches get figures of their own; the table has all.
MOST_DRAWN = 4


def all_captions(result):
    """Of a whole run: the places of the patches, then the figures of each patch, whose names begin
    with s1_, s2_, ... when there are several."""
    scenes = result.scenes()
    if result.models and result.models[0].place:
        yield from place_captions(result)
    for number, (label, scene) in enumerate(scenes[:MOST_DRAWN], 1):
        for name, caption, draw in captions(scene):
            if len(scenes) > 1:
                name, caption = f"s{number}_{name}", f"{label[0].upper()}{label[1:]}. {caption}"
            yield name, caption, draw


def draw_all(captioned, folder, png_folder=None):
    """Draws figures, an iterable of (file name, caption, function that draws or returns None), on all
    cores; returns (file name, caption) of those that there are, in their order."""
    captioned = list(captioned)

    def draw(number):
        name, _, function = captioned[number]
        figure = function()
        if figure is not None:
            style.save(figure, os.path.join(folder, name), png_folder)
        return figure is not None

    workers = min(len(os.sched_getaffinity(0)), len(captioned))
    drawn = _spread(draw, len(captioned), workers) if workers > 1 else map(draw, range(len(captioned)))
    return [(name, caption) for (name, caption, _), there in zip(captioned, drawn) if there]


_task = None  # of the processes that draw: they get it as they are forked, results and all


def _spread(task, count, workers):
    """task(0), ..., task(count - 1) by forked processes, the next number to whoever is free."""
    global _task
    _task = task
    with multiprocessing.get_context("fork").Pool(workers) as pool:
        return pool.map(_do_task, range(count), chunksize=1)


def _do_task(number):
    return _task(number)


def build(directory, png_folder=None, reference=""):
    """Draws what the result has and writes the report; figures for which it has no data are left
    out. `reference`: name of the model that the others are compared with, where it is there. Returns
    the result and the figures, (file name, caption)."""
    result = read_result(directory)
    result.reference = reference
    folder = style.figures_folder(result.directory, png_folder)
    style.know({model.name: model.label for model in result.models})
    figures = draw_all(all_captions(result), folder, png_folder)
    write_report(result, figures)
    return result, figures
