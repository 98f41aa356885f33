"""Which load points to draw when there are more than fit, and which model the others are compared
with."""


def friction_models(result):
    return [m for m in result.models if m.has_friction]


def with_pressure(result):
    """The models that have a field of pressure."""
    return [m for m in result.models if m.points and "pressure" in m.points[0].fields]


def reference_for_patch(result):
    """The requested one, otherwise Hertz if present: it is exact for what it describes."""
    return _first_of(result.models, (result.reference, "hertz", "halfspace"))


def reference_for_forces(result):
    return _first_of(friction_models(result), (result.reference, "halfspace", "fem"))


def _first_of(models, names):
    for name in names:
        for model in models:
            if model.name == name:
                return model
    return models[0] if models else None


def all_keys(models):
    """The key of every load point of the models, in the order of the first that has it."""
    return list(dict.fromkeys(point.key for model in models for point in model.points))


# Rows of a table of load points; of longer lists it has some, and files have all.
MOST_ROWS = 60


def shown_keys(models):
    """All keys, or of a long list some: the first, the last and those evenly between them."""
    found = all_keys(models)
    if len(found) <= MOST_ROWS:
        return found
    return [found[round(k * (len(found) - 1) / (MOST_ROWS - 1))] for k in range(MOST_ROWS)]


def chosen_keys(models, count):
    """Up to `count` load points with tractions, spread over the creep curve."""
    loaded = [c for c in all_keys(models)
              if any((p := m.at(c)) and p["max_traction"] > 0 for m in models)]
    # A long list keeps the fields of some.
    with_fields = [c for c in loaded if any((p := m.at(c)) and "pressure" in p.fields for m in models)]
    loaded = with_fields or loaded
    sticking = [any((p := m.at(c)) and p["adhesion_area"] > 0 for m in models) for c in loaded]
    if True in sticking:  # of those that slip everywhere the first tells all
        sliding = [c for c, sticks in zip(loaded, sticking) if not sticks]
        loaded = [c for c in loaded if c not in sliding[1:]]
    if len(loaded) <= count:
        return loaded
    if count == 1:
        return [loaded[len(loaded) // 2]]
    step = (len(loaded) - 1) / (count - 1)
    return [loaded[round(k * step)] for k in range(count)]


def typical_key(models):
    """One load point at which adhesion and slip are both there, else the middle one."""
    loaded = chosen_keys(models, 10 ** 6)
    if not loaded:
        return None

    def imbalance(key):
        points = [p for m in models if (p := m.at(key)) and p["contact_area"] > 0]
        return min((abs(p["adhesion_area"] / p["contact_area"] - 0.5) for p in points), default=1.0)

    return min(loaded, key=imbalance)
