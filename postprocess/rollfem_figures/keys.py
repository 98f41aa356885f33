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
