"""Figures of what `rollfem stress` wrote: depth profiles, lines, planes, the shakedown map."""
import os

import numpy as np
from matplotlib import pyplot as plt

from . import style
from .stress_reader import read_stress

# measure: (column, label, colour). One colour a measure where they share a panel.
MEASURES = [("von_mises", "von Mises", "#0072B2"), ("tresca", "Tresca", "#D55E00"),
            ("orthogonal_shear", "orthogonal shear", "#009E73"),
            ("hydrostatic", "hydrostatic", "#666666")]
DASHES = ["-", (0, (5, 1.5)), (0, (1, 1)), (0, (4, 1, 1, 1))]
MOST_FIGURES = 40  # of each kind


def _load_point(model):
    """Which load point of the model is drawn."""
    if model.data["step"]:
        return f"step {model.data['step']}"
    texts = []
    for name, form, factor in (("longitudinal_creepage", r"$\xi$ = {:.4g} %", 100),
                               ("lateral_creepage", r"$\eta$ = {:.4g} %", 100),
                               ("spin", r"$\varphi$ = {:.4g} rad/mm", 1)):
        if model.data[name] or name == "longitudinal_creepage":
            texts.append(form.format(factor * model.data[name]))
    return ", ".join(texts)


def _names(result, prefix):
    """Names of the sets that begin so, in order."""
    found = []
    for model in result.models:
        found += [s.name for s in model.sets if s.name.startswith(prefix) and s.name not in found]
    return found[:MOST_FIGURES]


def _bodies(result, name):
    return [b for b in ("wheel", "rail") if any(m.set(name, b) for m in result.models)]


def _legend(figure, result, with_measures):
    """Measures by colour and models by dash, four in a row over the panels; and the load point.
    Returns the number of rows."""
    handles = []
    if with_measures:
        handles += [style.entry(label, color=ink, linewidth=1.6) for _, label, ink in MEASURES]
        if len(result.models) > 1:
            handles += [style.entry(style.label(m), color="black", linewidth=1.3, linestyle=dash)
                        for m, dash in zip(result.models, DASHES)]
    else:
        handles += [style.entry(style.label(m), **style.line(m)) for m in result.models]
    handles.append(style.entry("; ".join(sorted({_load_point(m) for m in result.models}))))
    figure.legend(handles=handles, loc="upper center", ncol=min(len(handles), 4),
                  bbox_to_anchor=(0.5, 1.0))
    return 1 + (len(handles) - 1) // 4


def depth_profile(result, name):
    """Stresses down from the surface, one panel for each body. `name`: depth_centre, ..."""
    bodies = _bodies(result, name)
    figure, axes = plt.subplots(1, len(bodies), sharey=True, squeeze=False,
                                figsize=(3.6 * len(bodies), 4.4))
    for panel, body in zip(axes[0], bodies):
        for model, dash in zip(result.models, DASHES):
            part = model.set(name, body)
            if part is None:
                continue
            for column, _, ink in MEASURES:
                panel.plot(part[column], part["distance"], color=ink, linestyle=dash, linewidth=1.5)
        panel.axvline(0, color=style.GREY, linewidth=0.7, zorder=1)
        panel.set_title(f"{body}, {_where(result, name, body)}")
        panel.set_xlabel("stress [MPa]")
    axes[0, 0].set_ylabel("depth below the surface [mm]")
    axes[0, 0].set_ylim(bottom=0)
    axes[0, 0].invert_yaxis()
    axes[0, 0].margins(y=0)
    rows = _legend(figure, result, True)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.055 * rows))
    return figure


def _where(result, name, body):
    part = next(m.set(name, body) for m in result.models if m.set(name, body))
    texts = [f"{v:.2f}".replace("-", "−") if abs(v) >= 5e-3 else "0" for v in (part["x"][0], part["y"][0])]
    return f"under x = {texts[0]}, y = {texts[1]} mm"


def along_line(result, name, body):
    """Four measures along a line, every model in its own colour."""
    figure, axes = plt.subplots(2, 2, sharex=True, figsize=(7.2, 5.0))
    text = ""
    for model in result.models:
        part = model.set(name, body)
        if part is None:
            continue
        at, text = _position(part)
        for panel, (column, _, _) in zip(axes.flat, MEASURES):
            panel.plot(at, part[column], **style.line(model))
    for panel, (column, label, _) in zip(axes.flat, MEASURES):
        panel.set_ylabel(f"{label} stress [MPa]" if column != "orthogonal_shear" else f"{label} [MPa]")
        panel.margins(x=0)
        if column == "hydrostatic":
            panel.axhline(0, color=style.GREY, linewidth=0.7, zorder=1)
        else:
            panel.set_ylim(bottom=0)
    for panel in axes[1]:
        panel.set_xlabel(text)
    figure.align_ylabels()
    rows = _legend(figure, result, False)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.05 * rows))
    return figure


def _position(part):
    """Along which coordinate a line is drawn: (values, axis label)."""
    points = np.array([part["x"], part["y"], part["z"]]).T
    change = points[-1] - points[0]
    labels = (r"$x$ [mm], rolling $\rightarrow$", "$y$ [mm], lateral", "$z$ [mm], into the wheel")
    for axis in range(3):
        if abs(change[axis]) > 0.995 * np.linalg.norm(change):
            return points[:, axis], labels[axis]
    return part["distance"], "distance along the line [mm]"


def _lattice(part):
    """In-plane coordinates [across, along] of a plane, with their labels: that of the global frame
    for a side that follows an axis, else the distance along it; of a skew parallelogram the
    distance across its first side."""
    points = np.array([part[c].reshape(part.shape) for c in ("x", "y", "z")])
    offset = points - points[:, :1, :1]
    sides, found = [], []
    for change, name in ((offset[:, 0, -1], "first side [mm]"), (offset[:, -1, 0], "second side [mm]")):
        side = change / np.linalg.norm(change)
        axis = int(np.argmax(np.abs(side)))
        if abs(side[axis]) > 0.999999:
            found.append((axis, points[axis], f"${'xyz'[axis]}$ [mm]"))
        else:
            found.append((-1, np.tensordot(side, offset, 1), name))
        sides.append(side)
    if abs(np.dot(*sides)) > 1e-6:
        along = np.tensordot(sides[0], offset, 1)
        across = np.linalg.norm(offset - sides[0][:, None, None] * along, axis=0)
        return along, across, "first side [mm]", "across it [mm]"
    if found[0][0] > found[1][0] >= 0:  # x to the right, z up
        found.reverse()
    return found[0][1], found[1][1], found[0][2], found[1][2]


def plane(result, model, part):
    """Filled contours of four measures on a plane."""
    right, up, right_label, up_label = _lattice(part)
    wide, high = np.ptp(right), max(np.ptp(up), 1e-9)
    height = np.clip(2.75 * high / wide + 0.75, 1.6, 4.5)
    figure, axes = plt.subplots(2, 2, sharex=True, sharey=True, figsize=(7.4, 2 * height),
                                layout="constrained")
    for panel, (column, label, _) in zip(axes.flat, MEASURES):
        values = part[column].reshape(part.shape)
        drawn = panel.contourf(right, up, values, 14, cmap="viridis")
        if column != "hydrostatic":
            peak = np.unravel_index(np.argmax(values), values.shape)
            panel.plot(right[peak], up[peak], marker="x", color="white", markersize=7,
                       markeredgewidth=3, clip_on=False)
            panel.plot(right[peak], up[peak], marker="x", color="black", markersize=6,
                       markeredgewidth=1.3, clip_on=False)
        panel.set_title(label + (" stress" if column != "orthogonal_shear" else ""))
        panel.set_aspect("equal")
        panel.grid(False)
        figure.colorbar(drawn, ax=panel, label="MPa", aspect=14)
    for panel in axes[1]:
        panel.set_xlabel(right_label)
    for panel in axes[:, 0]:
        panel.set_ylabel(up_label)
    figure.suptitle(f"{style.label(model)}, {part.body}, {_load_point(model)}", fontsize=9.5)
    return figure


def _name_ends(axis, model, curve):
    """Creepages (number of the step in a history) of the first and the last load point of a path."""
    if len(curve) < 2:
        return
    for point, side in ((curve[0], "left"), (curve[-1], "right")):
        text = f"step {point['point'] + 1}" if model.data["step"] else (
            rf"$\xi$ = {100 * point['longitudinal_creepage']:.4g} %")
        axis.annotate(text, (point["tangential_coefficient"], point["load_factor"]),
                      (5, 6), textcoords="offset points", ha=side, va="bottom", fontsize=8)


def shakedown_map(result):
    """Load factor against tangential coefficient: boundaries of line and circular contact, and every
    load point of every model. None without a yield stress."""
    bounds = result.shakedown_map
    if bounds is None:
        return None
    figure, axis = plt.subplots(figsize=(6.4, 4.6))
    at = bounds["tangential_coefficient"]
    points = [p for m in result.models for p in m.data["shakedown"]]
    top = max([5.2] + [1.15 * p["load_factor"] for p in points])
    for kind, dash, name in (("line", (0, (5, 2)), "line contact"), ("circle", "-", "circular contact")):
        axis.plot(at, bounds[f"{kind}_shakedown"], color="black", linestyle=dash, linewidth=1.5,
                  label=f"shakedown limit, {name}")
        axis.plot(at, bounds[f"{kind}_elastic"], color=style.GREY, linestyle=dash, linewidth=1.2,
                  label=f"elastic limit, {name}")
    for size, model in zip((8, 5, 4, 3), result.models):  # models that agree stay visible
        curve = model.data["shakedown"]
        axis.plot([p["tangential_coefficient"] for p in curve], [p["load_factor"] for p in curve],
                  marker=style.marker(model), markersize=size, markerfacecolor="white",
                  **style.line(model), label=style.label(model), clip_on=False, zorder=4)
        if model is result.models[0]:
            _name_ends(axis, model, curve)
        here = curve[model.data["point"]]
        axis.plot(here["tangential_coefficient"], here["load_factor"], marker=style.marker(model),
                  markersize=size, linestyle="none", color=style.colour(model), clip_on=False, zorder=5)
    axis.set_xlim(0, max(at))
    axis.set_ylim(0, top)
    axis.set_xlabel(r"tangential force over normal force $T/F_z$ [-]")
    axis.set_ylabel(r"load factor $p_0/k$ [-]")
    axis.text(0.02, 0.35, "elastic", color=style.GREY)
    if top < 6:  # else there is no room between the limits
        axis.text(0.01, 3.17, "elastic shakedown", color=style.GREY, fontsize=8.5)
    axis.text(0.45, 0.93, "material flows at every passage", transform=axis.transAxes, color=style.GREY)
    figure.tight_layout(rect=(0, 0, 1, 0.87))
    handles, labels = axis.get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=2,
                  title=f"yield stress in shear $k$ = {result.yield_shear_stress:.4g} MPa; filled: the load "
                        "point of the stresses", title_fontsize=8.5)
    figure.tight_layout(rect=(0, 0, 1, 0.93 - 0.045 * ((len(handles) + 1) // 2)))
    return figure


def figures(result):
    """(file name, function that draws it or returns None) of everything."""
    for name in _names(result, "depth_"):
        yield f"{name}.svg", lambda name=name: depth_profile(result, name)
    for name in _names(result, "line_"):
        for body in _bodies(result, name):
            yield f"{name}_{body}.svg", lambda name=name, body=body: along_line(result, name, body)
    for name in _names(result, "plane_"):
        for model in result.models:
            for part in model.sets:
                if part.name == name:
                    yield (f"{name}_{part.body}_{model.name}.svg",
                           lambda model=model, part=part: plane(result, model, part))
    yield "shakedown_map.svg", lambda: shakedown_map(result)


def build(directory, png_folder=None):
    """Draws what the folder has to its figures/."""
    result = read_stress(directory)
    folder = style.figures_folder(directory, png_folder)
    style.know({model.name: model.label for model in result.models})
    for name, draw in figures(result):
        figure = draw()
        if figure is not None:
            style.save(figure, os.path.join(folder, name), png_folder)
