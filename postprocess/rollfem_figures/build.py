"""All figures and the report of one result folder."""
import os

from . import curves, maps, stresses, style
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
    yield ("contact_area.svg", "Contact area of every model, and its zones of adhesion and slip. "
           "Material enters on the right.", lambda: maps.contact_area(result))
    for model in result.models:
        yield (f"oblique_px_{model.name}.svg",
               f"Pressure and tangential traction over the patch: {style.label(model)}.",
               lambda model=model: maps.oblique(result, model))
    for number, kind, body in stresses.lines(result):
        yield (f"stress_{number + 1}.svg", stresses.caption(kind, body),
               lambda number=number: stresses.along_line(result, number))


def build(directory, png_folder=None):
    """Draws what the result has and writes the report; figures for which it has no data are left
    out."""
    result = read_result(directory)
    style.use()
    folder = os.path.join(result.directory, "figures")
    os.makedirs(folder, exist_ok=True)
    if png_folder:
        os.makedirs(png_folder, exist_ok=True)
    figures = []
    for name, caption, draw in captions(result):
        figure = draw()
        if figure is not None:
            style.save(figure, os.path.join(folder, name), png_folder)
            figures.append((name, caption))
    write_report(result, figures)
