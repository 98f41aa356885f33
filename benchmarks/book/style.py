# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look of the program's figures (styles.py) for matplotlib, which only the verification book uses: text as
outlines, so that it looks the same everywhere."""
import os
import re

import matplotlib
from matplotlib import pyplot as plt

from rollfem.figures import styles
from rollfem.figures.styles import know, label  # noqa: F401
from rollfem.files import whole

BLUE = styles.COLOURS["blue"][0]
GREY = "#666666"
LINE = 1.5  # points; the unit of dashes in matplotlib


def _dash(pixels):
    return (0, tuple(d / LINE for d in pixels)) if pixels else "-"


class _Looks(dict):
    """{name of a model: (colour, dash, marker)} in matplotlib's form."""

    def __missing__(self, name):
        colour, dash, marker = styles.MODELS[name]
        return styles.COLOURS[colour][0], _dash(dash), marker


LOOKS = _Looks()


def colour(model):
    styles.of_model(model)
    return LOOKS[model.name][0]


def line(model):
    """Keyword arguments of a curve of this model."""
    return {"color": colour(model), "linestyle": LOOKS[model.name][1], "linewidth": LINE}


def marker(model):
    return styles.of_model(model)[2]


def use():
    """Sets matplotlib up. Call before drawing."""
    matplotlib.use("Agg")
    matplotlib.rcParams.update({
        "font.size": 9, "axes.titlesize": 9.5, "axes.labelsize": 9, "legend.fontsize": 8.5,
        "font.family": "DejaVu Sans", "mathtext.fontset": "dejavusans",
        "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7,
        "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.axisbelow": True,
        "xtick.major.width": 0.7, "ytick.major.width": 0.7, "legend.frameon": False,
        "svg.fonttype": "path", "svg.hashsalt": "rollfem", "figure.dpi": 100,
    })


def _shorten(path):
    """Rounds coordinates of curves to a hundredth of a point, which halves the file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r' d="[^"]*"', lambda found: re.sub(
        r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", found[0]), text)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def save(figure, path, png_folder=None):
    """Writes the SVG completely or not at all; `png_folder` also gets a bitmap for a quick look."""
    frame = {"bbox_inches": "tight", "pad_inches": 0.05}
    with whole(path) as part:
        figure.savefig(part, format="svg", metadata={"Date": None, "Creator": None}, **frame)
        _shorten(part)
    if png_folder:
        name = os.path.splitext(os.path.basename(path))[0] + ".png"
        figure.savefig(os.path.join(png_folder, name), dpi=110, **frame)
    plt.close(figure)
