"""What distinguishes load points: the coordinate of a creep curve, and its wording."""


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


# Of a key (xi, eta, spin): the symbol in figures and on pages, the factor, and the unit.
PARTS = ((r"$\xi$", "ξ", 100, "%"), (r"$\eta$", "η", 100, "%"), (r"$\varphi$", "φ", 1, "rad/mm"))


def varying(keys):
    """Which parts of the keys differ from load point to load point."""
    return [k for k in range(3) if len({key[k] for key in keys}) > 1]


def key_texts(creepages):
    """What distinguishes the load points, e.g. "ξ = 0.2 %", for each of a list of keys, (xi, eta, spin)
    or (number,); and what they share, e.g. "η = 0.1 %", empty when it is nothing."""
    if any(len(c) == 1 for c in creepages):
        return {c: f"load point {c[0]:.0f}" for c in creepages}, ""
    # One point: say what is not zero.
    told = varying(creepages) or [k for k in range(3) if any(c[k] for c in creepages)] or [0]

    def text(key, wanted):
        return ", ".join(f"{symbol} = {factor * key[k]:.4g} {unit}"
                         for k, (symbol, _, factor, unit) in enumerate(PARTS) if wanted(k))

    shared = text(creepages[0], lambda k: k not in told and creepages[0][k]) if creepages else ""
    return {c: text(c, told.__contains__) for c in creepages}, shared
