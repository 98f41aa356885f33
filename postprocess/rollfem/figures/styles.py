# SPDX-License-Identifier: LGPL-2.1-or-later
"""One look for all figures: colours that colour-blind readers can distinguish (Okabe and Ito), on white and black
ground, and a marker and a dash for each model. Model labels come with the results, from the program's registry."""

# name: (on light ground, on dark ground).
COLOURS = {
    "ink": ("#1a1a1a", "#e6e6e6"), "soft": ("#5c5c5c", "#a9a9a9"), "grid": ("#dddddd", "#3b3d40"),
    "ground": ("#ffffff", "#17191c"), "band": ("#e6e6e6", "#34373b"),
    "adhesion": ("#56B4E9", "#3f97c9"), "slip": ("#E69F00", "#c98a00"), "plastic": ("#CC79A7", "#a85f88"),
    "blue": ("#0072B2", "#4fa8e0"), "green": ("#009E73", "#2dc79a"), "red": ("#D55E00", "#ff8b45"),
    "pink": ("#CC79A7", "#e39bc4"), "amber": ("#C98A00", "#e6ac2e"), "sky": ("#3f9fd4", "#7cc8f2"),
    "brown": ("#8B5A2B", "#c08d5a"), "grey": ("#8c8c8c", "#9a9a9a"), "wine": ("#882255", "#cc6699"),
    "forest": ("#117733", "#55bb77"), "violet": ("#6A3D9A", "#a981d6"),
}
# name: (colour, dash in px, marker), so that a model looks the same in all figures.
MODELS = {
    "hertz": ("ink", (7.5, 3), "x"),
    "halfspace": ("blue", (), "o"),
    "hybrid": ("green", (6, 1.5, 1.5, 1.5), "^"),
    "fem": ("red", (9, 2.3), "s"),
    "fastsim": ("pink", (4.5, 1.5), "v"),
    "fastrip": ("violet", (4.5, 1.5, 1.5, 1.5), "<"),
    "polach": ("wine", (1.5, 1.5, 4.5, 1.5), "h"),
    "strip": ("amber", (3, 1.5), "D"),
    "carter": ("sky", (1.5, 1.5), ">"),
    "vermeulen-johnson": ("brown", (1.5, 3), "*"),
    "linear": ("grey", (7.5, 7.5), "+"),
}
# Looks of other models, in order of appearance.
SPARE = [("wine", (10, 1.5, 1.5, 1.5), "<"), ("forest", (4.5, 1.5, 1.5, 1.5, 1.5, 1.5), ">"),
         ("violet", (3, 3), "h")]
LABELS = {}


def know(labels):
    """Sets model labels, {name: label}. Call before drawing; later calls add labels."""
    LABELS.update((name, label) for name, label in labels.items() if label)


def _name(model):
    return model if isinstance(model, str) else model.name


def label(model):
    """Label of a model or of a model name."""
    return LABELS.get(_name(model), _name(model))


def of_model(model):
    """(colour, dash, marker) of a model or of a model name."""
    return MODELS.setdefault(_name(model), SPARE[len(MODELS) % len(SPARE)])


def line(model, marked=False):
    """Keyword arguments of a curve of this model (Panel.line), with its markers if `marked`."""
    colour, dash, marker = of_model(model)
    return {"colour": colour, "dash": dash, "name": label(model), **({"marker": marker} if marked else {})}


def css():
    """The classes s-NAME (stroke) and f-NAME (fill) of all colours, for light and dark ground."""
    def rules(which):
        return "".join(f".s-{name}{{stroke:{both[which]}}}.f-{name}{{fill:{both[which]}}}"
                       for name, both in COLOURS.items())

    return (f"{rules(0)}@media screen and (prefers-color-scheme:dark){{{rules(1)}}}"
            ".plot{font:12px system-ui,'Segoe UI',Roboto,'DejaVu Sans',sans-serif}"
            ".plot .n{fill:none}.plot text.t{font-size:12.5px}.plot .sm{font-size:10.5px}"
            ".plot .sub{font-size:9px}.plot .it{font-style:italic}"
            ".plot path{stroke-linejoin:round}")
