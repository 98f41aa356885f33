"""Pictures over the patch: zones of adhesion and slip of each model, oblique views of tractions."""
import numpy as np
from matplotlib import patches
from matplotlib import pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.path import Path
from matplotlib.ticker import MaxNLocator

from . import selection, style
from .outline import edge_function, extent, padded
from .reader import ADHESION


def outline_of(panel, model, point, **options):
    """Draws the edge of the patch; returns it as one path in data coordinates, or None."""
    pressure = point.fields.get("pressure")
    if pressure is None or not (pressure > 0).any():
        return None
    x, y, values = padded(model, edge_function(pressure), -pressure.max() ** 2)
    contours = panel.contour(x, y, values, levels=[0.0], **options)
    paths = contours.collections[0].get_paths()
    return Path.make_compound_path(*paths) if paths else None


def spread(state):
    """1 in adhesion, 0 in slip, averaged over neighbours so that the border between the zones runs
    through the steps of the elements, and continued beyond the edge of the patch."""
    values = np.where(state == ADHESION, 1.0, 0.0)
    known = (state > 0).astype(float)
    for _ in range(2):
        total, weight = np.zeros_like(values), np.zeros_like(values)
        wide, mask = np.pad(values * known, 1), np.pad(known, 1)
        for j, weight_j in enumerate((1, 2, 1)):
            for i, weight_i in enumerate((1, 2, 1)):
                part = (slice(j, j + values.shape[0]), slice(i, i + values.shape[1]))
                total += weight_j * weight_i * wide[part]
                weight += weight_j * weight_i * mask[part]
        values = total / np.maximum(weight, 1e-9)
        known = (weight > 0).astype(float)
    return values


def _zones(panel, model, point):
    edge = outline_of(panel, model, point, colors="black", linewidths=0.9, linestyles="solid")
    state = point.fields.get("state")
    if edge is None or state is None:
        return
    clip = patches.PathPatch(edge, facecolor="none", edgecolor="none")
    panel.add_patch(patches.PathPatch(edge, facecolor=style.SLIP_COLOUR, edgecolor="none", zorder=1))
    panel.add_patch(clip)
    if (state == ADHESION).any():
        x, y, values = padded(model, spread(state), 0.0)
        filled = panel.contourf(x, y, values, levels=[0.5, 2.0], colors=[style.ADHESION_COLOUR],
                                zorder=2)
        for part in filled.collections:
            part.set_clip_path(clip)


def contact_area(result):
    """Adhesion and slip of every model with friction at a few creepages. None when no model has
    them."""
    zoned = [m for m in selection.friction_models(result)
             if m.has_bound and {"pressure", "state"} <= set(m.points[0].fields)]
    chosen = selection.chosen_keys(zoned, 4) if zoned else []
    if not chosen:
        return None
    texts, shared = style.key_texts(chosen)
    half_x, half_y = extent(zoned)
    # Tall patches and few models: a row for each model; else a row for each creepage.
    tall = half_x <= 1.3 * half_y and len(zoned) <= max(3, len(chosen))
    rows, columns = (len(zoned), len(chosen)) if tall else (len(chosen), len(zoned))
    scale = min(1.75 / half_x, 3.4 / half_y) / 2 if tall else min(2.9 / half_x, 2.2 / half_y) / 2
    width, height = max(2 * half_x * scale, 1.25), 2 * half_y * scale  # inches
    figure, panels = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True,
                                  figsize=(max((width + 0.35) * columns + 0.9, 3.2),
                                           (height + (0.55 if tall else 0.8)) * rows + 0.75))
    for j, model in enumerate(zoned):
        for i, creepages in enumerate(chosen):
            panel = panels[(j, i) if tall else (i, j)]
            point = model.at(creepages)
            if point is not None:
                _zones(panel, model, point)
                panel.set_title(f"{style.label(model)}\n{texts[creepages]}")
            panel.set_aspect("equal")
            panel.xaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10]))
    panels[0, 0].set_xlim(-half_x, half_x)
    panels[0, 0].set_ylim(-half_y, half_y)
    for panel in panels[-1]:
        panel.set_xlabel(r"$x$ [mm]")
    panels[-1, 0].set_xlabel(r"$x$ [mm], rolling $\rightarrow$" if width > 1.6 else r"$x$ [mm]")
    for panel in panels[:, 0]:
        panel.set_ylabel(r"$y$ [mm]")
    handles = [patches.Patch(color=style.ADHESION_COLOUR, label="adhesion"),
               patches.Patch(color=style.SLIP_COLOUR, label="slip")]
    if shared:
        handles.append(style.entry(shared))
    style.legend_above(figure, panels, handles, max(1, int(figure.get_figwidth() / 1.45)), titles=2,
                       between=(0.2, 0.5))
    return figure


class _Oblique:
    """Cavalier projection: x to the right, y to the back and up, the traction upwards."""

    def __init__(self, half_x, half_y, values):
        self.half_x, self.half_y = half_x, half_y
        self.low, self.top = min(0.0, float(values.min())), max(0.0, float(values.max()))
        if self.top - self.low < 1e-9:
            self.top = self.low + 1e-9
        self.skew = 0.75 * half_x / half_y  # all in units of half_x, whatever the patch's shape
        self.rise = 0.6 * half_x / half_y
        self.lift = 1.5 * half_x / (self.top - self.low)

    def __call__(self, x, y, value=0.0):
        return x + self.skew * y, self.rise * y + self.lift * value


def _strips(panel, view, model, values, state, count=26):
    """The surface as strips y = constant, drawn from the back to the front."""
    loaded = np.flatnonzero((np.abs(model.y) <= view.half_y))
    rows = loaded[::-max(1, len(loaded) // count)]
    columns = np.flatnonzero(np.abs(model.x) <= view.half_x)
    for depth, j in enumerate(rows):
        along, up = view(model.x[columns], model.y[j], values[j, columns])
        base = view(model.x[columns], model.y[j], np.zeros(len(columns)))
        corners = np.concatenate([np.stack([along, up], 1), np.stack(base, 1)[::-1]])
        panel.add_collection(PolyCollection([corners], facecolor="white", edgecolor="none",
                                            zorder=2 + depth), autolim=False)
        ends = np.stack([along, up], 1)
        kinds = state[j, columns] if state is not None else np.zeros(len(columns))
        both = np.maximum(kinds[:-1], kinds[1:])
        inks = np.where(both == 1, style.ADHESION_COLOUR, np.where(both == 2, style.SLIP_COLOUR, "#aaaaaa"))
        if state is None:
            inks = np.where(values[j, columns][:-1] + values[j, columns][1:] > 0, "#333333", "#aaaaaa")
        starts = np.flatnonzero(np.concatenate([[True], inks[1:] != inks[:-1]]))
        runs = list(zip(starts, [*starts[1:], len(inks)]))  # segments of one colour are one line
        panel.add_collection(LineCollection([ends[a:b + 1] for a, b in runs],
                                            colors=[inks[a] for a, _ in runs], linewidths=1.1,
                                            capstyle="round", snap=False, zorder=2 + depth),
                             autolim=False)


def _ticks(half):
    step = next(s for s in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100) if half / s <= 2.5 or s == 100)
    return np.arange(-np.floor(half / step), np.floor(half / step) + 1) * step


def _frame(panel, view, title, unit_label):
    """Axes of the projection: x in front, y on the right, the traction on the left."""
    ink = {"color": style.GREY, "linewidth": 0.8, "zorder": 1}
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]
    panel.plot(*zip(*[view(a * view.half_x, b * view.half_y) for a, b in corners]), **ink)
    text = {"fontsize": 8, "color": "#333333", "zorder": 1000}
    small = 0.05 * view.half_x
    below = view.lift * view.low  # labels stand under what hangs below the plane
    for tick in _ticks(view.half_x):
        x, y = view(tick, -view.half_y)
        panel.plot([x, x], [y, y - small], **ink)
        panel.text(x, y + below - 1.6 * small, f"{tick:g}".replace("-", "−"), ha="center", va="top", **text)
    x, y = view(0, -view.half_y)
    panel.text(x, y + below - 6.5 * small, r"$x$ [mm], rolling $\rightarrow$", ha="center", va="top", **text)
    for tick in _ticks(view.half_y):
        x, y = view(view.half_x, tick)
        panel.plot([x, x + small], [y, y], **ink)
        panel.text(x + 1.6 * small, y, f"{tick:g}".replace("-", "−"), ha="left", va="center", **text)
    x, y = view(view.half_x, 0)
    panel.text(x + 9 * small, y, r"$y$ [mm]", ha="left", va="top", **text)
    x, y = view(-view.half_x, -view.half_y)
    x -= 2 * small
    step = next(s for power in range(300) for s in (10.0**power, 2 * 10.0**power, 5 * 10.0**power)
                if (view.top - view.low) / s <= 5)
    values = np.arange(np.ceil(view.low / step), np.floor(view.top / step) + 1) * step
    panel.plot([x, x], [y + view.lift * view.low, y + view.lift * view.top], **ink)
    for value in values:
        height = y + view.lift * value
        panel.plot([x - small, x], [height, height], **ink)
        panel.text(x - 1.6 * small, height, f"{value:g}".replace("-", "−"), ha="right", va="center", **text)
    panel.text(x, y + view.lift * view.top + 3 * small, unit_label, ha="center", va="bottom", **text)
    left, bottom = view(-view.half_x, -view.half_y)
    right, back = view(view.half_x, view.half_y)
    panel.set_xlim(left - 8 * small, right + 10 * small)
    panel.set_ylim(bottom - 12 * small + below, max(back, view.lift * view.top) + 6 * small)
    panel.set_title(title, pad=14)
    panel.set_aspect("equal")
    panel.axis("off")


def _oblique_pressure(model):
    """p_n alone, of the first load point."""
    pressure = model.points[0].fields.get("pressure") if model.points else None
    if pressure is None or not (pressure > 0).any():
        return None
    figure, panel = plt.subplots(figsize=(4.8, 4.4))
    view = _Oblique(*extent([model]), pressure)
    _frame(panel, view, "contact pressure", r"$p_n$ [MPa]")
    _strips(panel, view, model, pressure, None)
    _title_obliques(figure, np.array([[panel]]), model)
    return figure


def _title_obliques(figure, axes, model):
    figure.suptitle(style.label(model), fontsize=10.5, fontweight="bold")
    style.arrange(figure, axes, between=(0.1, 0), left=0.05, right=0.05, bottom=0.2, top=0.5)


def oblique(result, model):
    """p_n and -p_x over the patch at one creepage, the same for every model, strip by strip; p_n alone
    of a model without friction. None without fields."""
    if not model.has_friction:
        return _oblique_pressure(model)
    shown = selection.reference_for_forces(result)
    creepages = selection.typical_key([shown]) if shown else None
    point = model.at(creepages) if creepages else None
    if point is None or not {"pressure", "traction_x"} <= set(point.fields):
        return None
    pressure, state = point.fields["pressure"], point.fields.get("state")
    traction = -point.fields["traction_x"]
    text = style.key_texts([creepages])[0][creepages]
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 4.4))
    half_x, half_y = extent([model])
    view = _Oblique(half_x, half_y, pressure)
    _frame(axes[0], view, "contact pressure", r"$p_n$ [MPa]")
    _strips(axes[0], view, model, pressure, None)
    view = _Oblique(half_x, half_y, traction)
    _frame(axes[1], view, f"tangential traction, {text}", r"$-p_x$ [MPa]")
    _strips(axes[1], view, model, traction, state)
    handles = [style.entry("adhesion", color=style.ADHESION_COLOUR), style.entry("slip", color=style.SLIP_COLOUR)]
    figure.legend(handles=handles, loc="lower center", ncol=2)
    _title_obliques(figure, axes[None, :], model)
    return figure
