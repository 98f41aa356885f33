"""The contact areas of all models on one picture, with their zones of adhesion and slip."""
from . import keys, looks, selection
from .figure import Figure
from .outline import extent, patch_panel, zones
from .reader import ADHESION
from .seen import adhering, patch_size


def _adheres(model, key):
    """Whether the model adheres anywhere."""
    point = model.at(key)
    state = point.fields.get("state") if point else None
    return state is not None and (state == ADHESION).any()


def _keys(zoned):
    """Up to three load points: those with a border between the zones, of which the last is followed by
    full slip where the curve gets there."""
    loaded = selection.chosen_keys(zoned, 10 ** 6)
    partly = [k for k in loaded if any(_adheres(m, k) for m in zoned)]
    full = [k for k in loaded if k not in partly][:1]
    room = 3 - len(full)
    if len(partly) > room:
        partly = [partly[0], partly[len(partly) // 2], partly[-1]] if room == 3 else [
            partly[len(partly) // 3], partly[-1]]
    return partly + full


def _draw(panel, model, point, shaded):
    """Outline, and the border between the zones within it, in the colour and dash of the model; its
    zones in the background if it is `shaded`."""
    found = zones(model, point)
    if found is None:
        return
    if shaded and found.has_state:
        panel.area(found.outline, "slip", 0.3, 0)
        panel.area(found.adhesion, "ground", 1, 0)
        panel.area(found.adhesion, "adhesion", 0.35, 0)
    look = looks.line(model)
    panel.paths([*found.outline, *found.borders], look["colour"], 1.3, look["dash"])


def outlines(result):
    """Outlines of all models overlaid, at up to three creepages with the border between adhesion
    (on the leading side) and slip of each; shaded are the zones of the reference model. None when no
    model has a pressure field."""
    models = selection.with_pressure(result)
    if not models:
        return None
    zoned = [m for m in models if m.has_friction and m.has_bound and "state" in m.points[0].fields]
    chosen = _keys(zoned) if zoned else []
    reference = selection.reference_for_forces(result)
    shaded = reference if chosen and reference in zoned else None
    texts, shared = keys.key_texts(chosen)
    half = extent(models)
    figure = Figure(3)
    for key in chosen or [None]:
        panel = patch_panel(figure, texts[key] if key else "", ("$x$ [mm], rolling $\\rightarrow$", "$y$ [mm], lateral"),
                            half, min(135 / half[0], 150 / half[1]), 115)
        for model in models:
            # Hertz has one load point, whatever the others have.
            point = (model.at(key) if key else None) or (model.points[0] if model not in zoned else None)
            if point is not None:
                _draw(panel, model, point, model is shaded)
    for model in models:
        figure.model(model)
    if shaded is not None:
        figure.entry(f"adhesion ({looks.label(shaded)})", fill="adhesion", opacity=0.35)
        figure.entry(f"slip ({looks.label(shaded)})", fill="slip", opacity=0.3)
    figure.heading_entry(shared)
    said = [f"{looks.label(m)} {patch_size(m, m.points[0])}" for m in models]
    figure.seen = f"Contact areas, along rolling by across: {'; '.join(said)}."
    if shaded is not None:
        figure.seen += f" {looks.label(shaded)} " + "; ".join(
            f"{adhering(shaded.at(k))} at {texts[k]}" for k in chosen if shaded.at(k)) + "."
    return figure
