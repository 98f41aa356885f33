"""The contact areas of all models on one picture, with their zones of adhesion and slip."""
from matplotlib import patches
from matplotlib import pyplot as plt
from matplotlib.ticker import MaxNLocator

from . import selection, style
from .maps import outline_of, spread
from .outline import extent, padded
from .reader import ADHESION, SLIP


def _has_both(model, key):
    """Whether the model adheres in one part of the patch and slips in another."""
    point = model.at(key)
    state = point.fields.get("state") if point else None
    return state is not None and (state == ADHESION).any() and (state == SLIP).any()


def _keys(zoned):
    """Up to three load points with a border between the zones; else one at which something is drawn."""
    partly = [k for k in selection.all_keys(zoned) if any(_has_both(m, k) for m in zoned)]
    if len(partly) > 3:
        partly = [partly[0], partly[len(partly) // 2], partly[-1]]
    return partly or selection.chosen_keys(zoned, 1)


def _shade(panel, model, point):
    """The zones of one model as areas in the background."""
    edge = outline_of(panel, model, point, colors="none")
    state = point.fields.get("state")
    if edge is None or state is None:
        return
    clip = patches.PathPatch(edge, facecolor=style.SLIP_COLOUR, edgecolor="none", alpha=0.28, zorder=0)
    panel.add_patch(clip)
    if not (state == ADHESION).any():
        return
    x, y, values = padded(model, spread(state), 0.0)
    for colour, alpha in (("white", 1.0), (style.ADHESION_COLOUR, 0.28)):
        for part in panel.contourf(x, y, values, levels=[0.5, 2.0], colors=[colour], alpha=alpha,
                                   zorder=0.5).collections:
            part.set_clip_path(clip)


def _draw(panel, model, point):
    """Outline, and the border between the zones within it, in the colour and dash of the model."""
    ink = style.line(model)
    pen = {"colors": ink["color"], "linewidths": 1.2, "linestyles": [ink["linestyle"]]}
    edge = outline_of(panel, model, point, **pen)
    state = point.fields.get("state")
    if edge is None or state is None or not ((state == ADHESION).any() and (state == SLIP).any()):
        return
    clip = patches.PathPatch(edge, facecolor="none", edgecolor="none")
    panel.add_patch(clip)
    x, y, values = padded(model, spread(state), 0.0)
    if values.max() <= 0.5:  # adhesion that its neighbours outweigh
        return
    for part in panel.contour(x, y, values, levels=[0.5], **pen).collections:
        part.set_clip_path(clip)


def _legend(figure, panels, models, shaded, shared):
    handles = [style.entry(style.label(m), **style.line(m)) for m in models]
    if shaded is not None:
        name = style.label(shaded)
        handles += [patches.Patch(color=style.ADHESION_COLOUR, alpha=0.28, label=f"adhesion ({name})"),
                    patches.Patch(color=style.SLIP_COLOUR, alpha=0.28, label=f"slip ({name})")]
    if shared:
        handles.append(style.entry(shared))
    style.legend_above(figure, panels, handles, max(2, int(figure.get_figwidth() / 1.45)), between=(0.2, 0))


def outlines(result):
    """Outlines of all models on each other, at up to three creepages with the border between adhesion
    (on the leading side) and slip of each; shaded are the zones of the reference model. None when no
    model has a pressure field."""
    models = [m for m in result.models if m.points and "pressure" in m.points[0].fields]
    if not models:
        return None
    zoned = [m for m in models if m.has_friction and m.has_bound and "state" in m.points[0].fields]
    keys = _keys(zoned) if zoned else []
    reference = selection.reference_for_forces(result)
    shaded = reference if keys and reference in zoned else None
    texts, shared = style.key_texts(keys)
    half_x, half_y = extent(models)
    scale = min(3.1 / half_x, 3.1 / half_y) / 2
    width, height = max(2 * half_x * scale, 1.5), max(2 * half_y * scale, 1.0)
    count = max(1, len(keys))
    figure, panels = plt.subplots(1, count, squeeze=False, sharey=True,
                                  figsize=(max((width + 0.45) * count + 0.7, 4.4), height + 1.7))
    for panel, key in zip(panels.flat, keys or [None]):
        if shaded is not None and shaded.at(key) is not None:
            _shade(panel, shaded, shaded.at(key))
        for model in models:
            # Hertz has one load point, whatever the others have.
            point = (model.at(key) if key else None) or (model.points[0] if model not in zoned else None)
            if point is not None:
                _draw(panel, model, point)
        panel.set_title(texts[key] if key else "")
        panel.set_aspect("equal")
        panel.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
        panel.set_xlim(-half_x, half_x)
        panel.set_ylim(-half_y, half_y)
        panel.set_xlabel(r"$x$ [mm], rolling $\rightarrow$")
    panels.flat[0].set_ylabel(r"$y$ [mm], lateral")
    _legend(figure, panels, models, shaded, shared)
    return figure
