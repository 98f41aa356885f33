# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flash temperature, and friction that follows it."""
import numpy as np
from matplotlib import pyplot as plt

from .. import published
from ..chapter import Chapter, Cost, Row, at_most

FORCE, A, B, MU, SPEED, XI = 100e3, 5.88, 10.54, 0.3, 30e3, 1 / 30
LARGEST = 1.5 * FORCE / (np.pi * A * B)
EFFUSIVITY = np.sqrt(50.0 * 7.85e-9 * 450e6)  # N/(mm K s^0.5), of steel

_CASE = """[load]
normal_force = {force!r}
[friction]
{friction}
[wheel]
rolling_radius = 460.0
transverse_radius = inf
{wheel}
[rail]
transverse_radius = 300.0
{rail}
[given_pressure]
semi_axis_x = 5.88
semi_axis_y = 10.54
[rolling]
longitudinal_creepage = {creepages}
speed = 30e3
{rolling}
[wheel_heat]
temperature = {temperatures[0]}
[rail_heat]
temperature = {temperatures[1]}
[contact_grid]
{grid}
"""
# No elastic slip, as the closed forms have it.
STIFF = "young_modulus = 210e6"


def _run(bench, name, across=40, friction="coefficient = 0.3", creepages=(XI,), wheel=STIFF, rail=STIFF, temperatures=(0.0, 0.0),
         rolling="", grid="elements_across = {}"):
    text = _CASE.format(force=FORCE, friction=friction, creepages=list(creepages), wheel=wheel, rail=rail, temperatures=temperatures,
                        rolling=rolling, grid=grid.format(across))
    return bench.run_text(f"heat_{name}", text, ["halfspace"])["halfspace"]


def _by_temperature(hot, cold=0.0, until=400.0, mu=MU):
    return f'coefficient = {mu}\nlaw = "temperature"\ncold_temperature = {cold}\nhot_temperature = {until}\nhot_coefficient = {hot!r}'


def _sliding(hot, doubled=0.0, dx=0.01, dy=0.25, bend=0.0):
    """(F/(mu F_n), largest rise) in full sliding of rigid bodies with mu linear to `hot` at 400 K, row by row on a grid of its own:
    T = K * (mu(T) p V xi (1 + bend x)), Abel's integral. `doubled`: times that an element's own heat counts once more; `bend`, 1/mm: by
    elastic slip."""
    x = np.arange(A - 0.5 * dx, -A, -dx)
    weights = 2 * np.sqrt(dx / (np.pi * SPEED)) * np.diff(np.sqrt(np.concatenate([[0.0], np.arange(len(x)) + 0.5])))
    rate = SPEED * XI / (2 * EFFUSIVITY)
    force = top = 0.0
    for y in np.arange(0.5 * dy, B, dy):
        pressure = LARGEST * np.sqrt(np.maximum(0.0, 1 - (x / A) ** 2 - (y / B) ** 2))
        flow, slope = np.zeros_like(x), (hot - MU) / 400.0
        for k, p in enumerate(pressure * (1 + bend * x)):
            before = rate * weights[k:0:-1] @ flow[:k]
            own = rate * weights[0] * (1 + doubled) * p
            warm = (before + own * MU) / (1 - own * slope)  # of mu(T) = MU + slope T
            warm = warm if warm < 400.0 else before + own * hot
            flow[k] = (MU + slope * min(warm, 400.0)) * p
            top = max(top, warm)
        force += (flow / (1 + bend * x)).sum() * dx * 2 * dy
    return force / (MU * FORCE), top


def _line_rows(bench):
    """Rollers: Hertz in full sliding has the same row."""
    radius, load = 460.0, 700.0
    modulus = 210e6 / (2 * (1 - 0.3**2))
    a = np.sqrt(4 * load * radius / (np.pi * modulus))
    text = (f"[load]\nnormal_force = {load}\n[geometry]\nshape = \"line\"\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = {radius}\n"
            f"{STIFF}\n[rail]\n{STIFF}\n[rolling]\nlongitudinal_creepage = 0.05\nspeed = 30e3\n[rail_heat]\ntemperature = 0.0\n"
            "[wheel_heat]\ntemperature = 0.0\n[contact_grid]\nelements_across = 160\n")
    point = bench.run_text("heat_line", text, ["halfspace"])["halfspace"].points[0]
    exact = 0.5 * 0.3 * (2 * load / (np.pi * a)) * 0.05 * SPEED * np.sqrt(a / SPEED) / (EFFUSIVITY * np.sqrt(np.pi)) * 2.1883
    return [Row("rollers in full sliding: largest rise", "K", exact, point["max_temperature"], 2e-3, by="160 across"),
            at_most("the same, difference over its bar", "", abs(exact - point["max_temperature"]) / point.bar("max_temperature"), 1.0)]


def _temperature_rows(bench):
    """The ellipse in full sliding, on three grids; heat; bodies of unlike steel and temperature."""
    exact = 0.5 * MU * LARGEST * SPEED * XI * np.sqrt(A / SPEED) / (EFFUSIVITY * np.sqrt(np.pi)) * 2.1883
    rows = []
    for across, allowed in ((20, 6e-3), (40, 2e-3), (80, 7e-4)):
        point = _run(bench, f"ellipse_{across}", across).points[0]
        rows += [Row("ellipse in full sliding: largest rise", "K", exact, point["max_temperature"], allowed, by=f"{across} across"),
                 at_most("the same, difference over its bar", "", abs(exact - point["max_temperature"]) / point.bar("max_temperature"), 1.0,
                         by=f"{across} across")]
    rows += [Row("where it lies, x/a", "", -0.65, point["max_temperature_x"] / A, 0.02, of=1.0, of_words="a", by="80 across")]
    unlike = _run(bench, "unlike", rail=STIFF + "\ndensity = 1e-9", temperatures=(150.0, 0.0), creepages=(0.0, XI), rolling="")
    rest, point = unlike.points
    share = np.sqrt(1 / 7.85)
    rows += [Row("unlike bodies at rest: temperature in contact", "degC", 150 / (1 + share), rest["max_temperature"], 1e-6),
             Row("unlike bodies in full sliding: largest temperature", "degC", 150 / (1 + share) + exact * 2 / (1 + share),
                 point["max_temperature"], 2e-3)]
    return rows + [Row("heat into both bodies", "N", p["frictional_work"], p["heat_wheel"] + p["heat_rail"], 1e-12,
                       by=f"xi = {100 * p['longitudinal_creepage']:.2g} %; against the work of friction", of=MU * FORCE * XI, of_words="mu F_z xi")
                   for p in unlike.points]


def _friction_rows(bench):
    """Friction that falls by 0.18 over 400 K, or rises, against the integral on a grid of its own."""
    rows = []
    for hot, words in ((0.12, "falls"), (0.48, "rises")):
        point = _run(bench, words, 80, _by_temperature(hot)).points[0]
        force, top = _sliding(hot)
        rows += [Row(f"friction {words} with temperature: F_x/(mu F_z)", "", force, point["traction_coefficient"] / MU, 1e-3, by="80 across"),
                 Row(f"friction {words} with temperature: largest rise", "K", top, point["max_temperature"], 2e-3, by="80 across")]
    # A law that does not change is Coulomb's, to the last bit, and slow memory keeps the coefficient of cold surfaces.
    creepages = (0.001, 0.01)
    same = [[p["longitudinal_force"] for p in _run(bench, name, 24, friction, creepages, "", "").points]
            for name, friction in (("coulomb", "coefficient = 0.3"), ("constant", _by_temperature(0.3)),
                                   ("remembers", _by_temperature(0.1) + "\nmemory_distance = 1e6"))]
    assert same[0] == same[1], same
    rows += [Row(f"friction with endless memory, xi = {100 * xi:g} %", "N", cold, slow, 1e-6, by="against Coulomb's")
             for xi, cold, slow in zip(creepages, same[0], same[2])]
    # A memory of the length of the slip in the patch is between both.
    fast, slow = (_run(bench, f"memory_{d:g}", 40, _by_temperature(0.12) + f"\nmemory_distance = {d}").points[0]["traction_coefficient"]
                  for d in (1e-6, 0.2))
    rows.append(Row("friction with a memory of 1 nm", "", _sliding(0.12)[0] * MU, fast, 2e-3))
    assert fast < slow < MU, (fast, slow)
    return rows


def _step_rows(bench):
    """Full sliding from rest in steps: the closed form once the material has passed the patch."""
    exact = 0.5 * MU * LARGEST * SPEED * XI * np.sqrt(A / SPEED) / (EFFUSIVITY * np.sqrt(np.pi)) * 2.1883
    rows = []
    for length in (0.2, 0.6):
        steps = int(2.2 * A / length)
        points = _run(bench, f"steps_{length}", 40, creepages=[XI] * steps,
                      rolling=f'problem = "transient"\n[history]\nstep_length = {length}').points
        assert len(points) == steps and points[0]["max_temperature"] < 0.5 * exact
        rows.append(Row(f"ellipse in full sliding from rest, steps of {length} mm: largest rise at the end", "K", exact,
                        points[-1]["max_temperature"], 3e-3, by="40 across"))
    return rows


def _contact_rows(bench):
    """CONTACT's numbers: by its rule, an element's own heat counts twice."""
    order = 'upwind_order = "first"'
    size = "extent = [43.2, 22.5]\ncell_size = [0.2, 0.5]\nmiddle = [-13.7, 0.0]"
    rows, models = [], []
    for name, temperatures, creepage in (("sliding", (0.0, 0.0), 0.03333), ("hot wheel, sliding", (150.0, 0.0), 0.03333),
                                         ("hot wheel, partial slip", (150.0, 0.0), (0.002, 0.001, 0.0002))):
        partial = isinstance(creepage, tuple)
        model = _run(bench, f"contact_{len(rows)}", creepages=(creepage[0] if partial else creepage,), wheel=published.CONTACT_STEEL,
                     rail=published.CONTACT_STEEL, temperatures=temperatures,
                     rolling=order + ("\nlateral_creepage = -0.001\nspin = 0.0002" if partial else ""), grid=size)
        models.append(model)
        point = model.points[0]
        rise = SPEED * point.fields["work"] / (2 * EFFUSIVITY) * 2 * np.sqrt(0.5 * model.dx / (np.pi * SPEED))
        by_rule = (point.fields["temperature_rail"] + rise)[point.fields["pressure"] > 0].max()
        rows += [Row(f"{name}: largest temperature by CONTACT's rule", "degC", published.CONTACT_TEMPERATURES[name], by_rule, 5e-3,
                     by="from our work of friction"),
                 Row(f"{name}: largest temperature", "degC", published.CONTACT_TEMPERATURES[name], point["max_temperature"],
                     by="without its rule")]
    middle = len(models[0].y) // 2
    inside = models[0].points[0].fields["pressure"][middle] > 0
    bend = np.polyfit(models[0].x[inside], models[0].points[0].fields["slip_x"][middle, inside] / 0.03333, 1)[0]
    for hot in (0.12, 0.48):
        force, top = _sliding(hot, 1.0, 0.2, 0.5, bend)
        rows += [Row(f"friction to {hot:g} at 400 K: F_x/(mu F_z) by CONTACT's rule", "", published.CONTACT_HEATED[hot][0], force, 5e-3),
                 Row(f"friction to {hot:g} at 400 K: largest rise by CONTACT's rule", "K", published.CONTACT_HEATED[hot][1], top, 5e-3)]
    return rows


_LOCOMOTIVE = """[load]
normal_force = 106700
[friction]
{friction}
[wheel]
{steel}
[rail]
{steel}
[rail_heat]
temperature = 20.0
[undeformed_distance]
quadratic = [0.0008, 0.000281417313827]
[rolling]
longitudinal_creepage = {creepages}
speed = {speed}
[contact_grid]
elements_across = 24
"""


def _locomotive(bench):
    """A locomotive whose friction falls by heat alone, at three speeds, and the fitted law of slip velocity: (model by speed, fitted)."""
    creepages = [0.0, 0.001, 0.002, 0.003, 0.004, 0.006, 0.01, 0.02, 0.03, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25]

    def run(name, friction, speed):
        return bench.run_text(f"heat_{name}", _LOCOMOTIVE.format(friction=friction, steel=published.CONTACT_STEEL, creepages=creepages,
                                                                 speed=speed), ["halfspace"])["halfspace"]
    law = _by_temperature(0.12, 20.0, 300.0, 0.36)
    heated = {speed: run(f"locomotive_{speed:g}", law, 1e3 * speed) for speed in (5.0, 10.0, 20.0)}
    return heated, run("fitted", 'coefficient = 0.36\nlaw = "exponential"\nkinetic_coefficient = 0.1368\nhalf_velocity = 990.0', 10e3)


def _draw(bench, heated, fitted):
    figure, axes = plt.subplots(1, 2, figsize=(8.8, 3.4))
    for (speed, model), colour in zip(heated.items(), ("#56B4E9", "#0072B2", "#D55E00")):
        slip = [100 * p["longitudinal_creepage"] for p in model.points]
        axes[0].plot(slip, [p["traction_coefficient"] for p in model.points], color=colour, label=f"by temperature, {speed:g} m/s")
        axes[1].plot(slip, [p["max_temperature"] for p in model.points], color=colour)
    axes[0].plot([100 * p["longitudinal_creepage"] for p in fitted.points], [p["traction_coefficient"] for p in fitted.points],
                 color="black", linestyle=(0, (5, 2)), label="Polach's fit, 10 m/s")
    axes[0].set_ylabel("traction coefficient $-F_x/F_z$")
    axes[1].set_ylabel("largest temperature [°C]")
    axes[0].legend(loc="lower center")
    for axis in axes:
        axis.set_xlabel(r"$\xi$ [%]")
    figure.tight_layout()
    return bench.save(figure, "heat")


def heat(bench):
    """Heat: flash temperature, and friction that follows it"""
    heated, fitted = _locomotive(bench)
    speeds = list(heated)
    drop = {speed: heated[speed].points[-1]["traction_coefficient"] for speed in speeds}
    assert drop[5.0] > drop[10.0] > drop[20.0], drop
    apart = max(abs(p["traction_coefficient"] - q["traction_coefficient"]) for p, q in zip(heated[10.0].points, fitted.points)
                if p["longitudinal_creepage"] >= 0.01)
    return Chapter(
        "heat", "Heat: flash temperature, and friction that follows it",
        "An ellipse of 5.88 by 10.54 mm under 100 kN, mu = 0.3, 30 m/s, slip 1 m/s (Ertz and Knothe 2002); steel with 50 W/(m K), 450 J/(kg "
        "K), 7850 kg/m^3. Where closed forms have no elastic slip, bodies are a thousand times as stiff.",
        "Jaeger's integral in closed form; Abel's integral with friction on a grid of its own; CONTACT's printed temperatures, whose rule "
        "adds the heat of an element to its own temperature twice. The curves are those of a locomotive (106.7 kN, Polach 2005): friction "
        "from 0.36 at 20 degC to 0.12 at 300 degC (the last two fitted), against the law of slip velocity that Polach fitted to his measurement.",
        [*_temperature_rows(bench), *_line_rows(bench), *_friction_rows(bench), *_step_rows(bench), *_contact_rows(bench),
         Row("locomotive: -F_x/F_z by heat alone from the fitted law, farthest from xi = 1 %", "", 0.0, apart, 0.02, of=1.0, of_words="1")],
        figures=[(_draw(bench, heated, fitted), "Traction of a locomotive by heat alone, and its temperature")],
        cost=[Cost("a curve of 15 load points", heated[10.0].seconds["total"], heated[10.0].unknowns)],
        tests=["unit.FlashTemperature.OfAUniformSourceIsJaegersAtEveryElement",
               "unit.FlashTemperature.BodiesOfUnlikeTemperatureMeetInBetweenAndReturnToTheirOwn"])
