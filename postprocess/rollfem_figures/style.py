"""One look for all figures: colours that colour-blind readers can tell apart (Okabe and Ito), a
marker and a dash for each model, vector output with text as outlines so that it looks the same
everywhere. How a model is called comes with the results, from the program's registry."""
import contextlib
import os
import re
import weakref

import matplotlib
from matplotlib import pyplot as plt

BLUE = "#0072B2"
# name: (colour, dash, marker), so that a model looks the same in every figure ever drawn.
LOOKS = {
    "hertz": ("#000000", (0, (5, 2)), "x"),
    "halfspace": (BLUE, "-", "o"),
    "hybrid": ("#009E73", (0, (4, 1, 1, 1)), "^"),
    "fem": ("#D55E00", (0, (6, 1.5)), "s"),
    "fastsim": ("#CC79A7", (0, (3, 1)), "v"),
    "strip": ("#E69F00", (0, (2, 1)), "D"),
    "carter": ("#56B4E9", (0, (1, 1)), "P"),
    "vermeulen-johnson": ("#8B5A2B", (0, (1, 2)), "*"),
    "linear": ("#999999", (0, (5, 5)), "+"),
}
# Those of other models, in the order in which they are met.
SPARE_LOOKS = [("#882255", (0, (7, 1, 1, 1)), "<"),
               ("#117733", (0, (3, 1, 1, 1, 1, 1)), ">"), ("#6A3D9A", (0, (2, 2)), "h")]
LABELS = {}
ADHESION_COLOUR, SLIP_COLOUR = "#56B4E9", "#E69F00"
GREY = "#666666"


def know(labels):
    """How models are called, {name: label}. Call before drawing; later calls add to it."""
    LABELS.update((name, label) for name, label in labels.items() if label)


def label(model):
    return LABELS.get(model.name, model.name)


def _look(model):
    if model.name not in LOOKS:
        LOOKS[model.name] = SPARE_LOOKS[len(LOOKS) % len(SPARE_LOOKS)]
    return LOOKS[model.name]


def colour(model):
    return _look(model)[0]


def line(model):
    """Keyword arguments of a curve of this model."""
    ink, dash, _ = _look(model)
    return {"color": ink, "linestyle": dash, "linewidth": 1.5}


def marker(model):
    return _look(model)[2]


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
    """Coordinates of curves to a hundredth of a point, which makes the file smaller by half."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r' d="[^"]*"', lambda found: re.sub(
        r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", found[0]), text)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


@contextlib.contextmanager
def whole(path):
    """The name to write a file under, which then stands at `path` whole or not at all."""
    part = f"{path}.part-{os.getpid()}"
    try:
        yield part
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)


def figures_folder(directory, png_folder):
    """Sets matplotlib up and makes the folders for figures; returns that of `directory`."""
    use()
    folder = os.path.join(directory, "figures")
    for wanted in filter(None, (folder, png_folder)):
        os.makedirs(wanted, exist_ok=True)
    return folder


def save(figure, path, png_folder=None):
    """Writes the SVG whole or not at all; `png_folder` gets a bitmap too, for a quick look. What
    `arrange` has laid out is as large as it says, others are cut to what they show, for which they
    are drawn twice."""
    frame = {} if figure in _ARRANGED else {"bbox_inches": "tight", "pad_inches": 0.05}
    with whole(path) as part:
        figure.savefig(part, format="svg", metadata={"Date": None, "Creator": None}, **frame)
        _shorten(part)
    if png_folder:
        name = os.path.splitext(os.path.basename(path))[0] + ".png"
        figure.savefig(os.path.join(png_folder, name), dpi=110, **frame)
    plt.close(figure)


_ARRANGED = weakref.WeakSet()


def arrange(figure, axes, between=(0.75, 0.72), *, left=0.7, right=0.14, bottom=0.48, top=0.32):
    """Lays panels (an array of rows and columns) out by margins and by the room `between` columns and
    rows, all in inches, for tick labels, labels and titles: matplotlib's tight_layout measures them,
    which takes as long as drawing."""
    rows, columns = axes.shape
    width, height = figure.get_size_inches()
    across = (width - left - right - (columns - 1) * between[0]) / columns
    down = (height - bottom - top - (rows - 1) * between[1]) / rows
    figure.subplots_adjust(left=left / width, right=1 - right / width, bottom=bottom / height,
                           top=1 - top / height, wspace=between[0] / across, hspace=between[1] / down)
    _ARRANGED.add(figure)


def entry(text, **look):
    """An entry of a legend: a line that looks so, or the text alone."""
    return plt.Line2D([], [], label=text, **(look or {"linestyle": "none"}))


def legend_above(figure, axes, handles, across, titles=1, **room):
    """The panels, with titles of so many lines, laid out (`arrange`) below a legend of at most `across`
    entries in a row."""
    rows = -(-len(handles) // across)
    arrange(figure, axes, top=0.16 + 0.16 * titles + 0.19 * rows, **room)
    figure.legend(handles=handles, loc="upper center", ncol=-(-len(handles) // rows), borderaxespad=0.2)


def creepage_axis(points):
    """What varies along the creep curve: (scalar, factor, axis label)."""
    if any(p.by_number and p["step"] for p in points):
        choices = [("longitudinal_shift", 1.0, "longitudinal shift since the beginning [mm]"),
                   ("lateral_shift", 1.0, "lateral shift since the beginning [mm]"),
                   ("spin_shift", 1.0, "rotation since the beginning [rad]"),
                   ("distance", 1.0, "distance rolled [mm]")]
        return next((c for c in choices if any(p[c[0]] for p in points)), ("step", 1.0, "step"))
    choices = [("longitudinal_creepage", 100.0, r"longitudinal creepage $\xi$ [%]"),
               ("lateral_creepage", 100.0, r"lateral creepage $\eta$ [%]"),
               ("spin", 1.0, r"spin $\varphi$ [rad/mm]")]
    for choice in choices:
        values = [p[choice[0]] for p in points]
        if values and max(values) > min(values):
            return choice
    return choices[0]


def key_texts(creepages):
    """What distinguishes the load points, e.g. "ξ = 0.2 %", for each of a list of keys, (xi, eta, spin)
    or (number,); and what they share, e.g. "η = 0.1 %", empty when it is nothing."""
    if any(len(c) == 1 for c in creepages):
        return {c: f"load point {c[0]:.0f}" for c in creepages}, ""
    forms = [(r"$\xi$ = {:.4g} %", 100), (r"$\eta$ = {:.4g} %", 100), (r"$\varphi$ = {:.4g} rad/mm", 1)]
    varies = [len({c[k] for c in creepages}) > 1 for k in range(3)]
    if not any(varies):  # one point: say what is not zero
        varies = [any(c[k] for c in creepages) for k in range(3)]
        varies[0] = varies[0] or not any(varies)

    def text(values, wanted):
        return ", ".join(forms[k][0].format(forms[k][1] * values[k]) for k in range(3) if wanted(k))

    shared = text(creepages[0], lambda k: not varies[k] and creepages[0][k]) if creepages else ""
    return {c: text(c, lambda k: varies[k]) for c in creepages}, shared
