# SPDX-License-Identifier: LGPL-2.1-or-later
"""300 typical user scenes of every kind, from a seed: texts of case files without model and accuracy, as written by a
user who has not read about `auto`."""

import math
import random
import sys
from dataclasses import dataclass
from pathlib import Path

import scene_sets
from pin_cases import with_keys

CASES = scene_sets.CASES
sys.path.insert(0, str(CASES / "profiles"))
import hollow_s1002  # noqa: E402  (the formula of a worn wheel is beside its profile)

BARE = {"models": None, "accuracy": None}
# Pairs of ../reference/measured from its table: wheel, its section, rail, its section, rolling radius.
ROUNDED = "rounding = 1.0\nlargest_kink = 60\n"
MEASURED = {
    "siteb": ("worn_high_mileage.prw", "shift = [-70.0, 0.0]\n" + ROUNDED, "site_b_hr.prr", ROUNDED, 444.0),
    "avgHR": ("avg_wheel.whl", "shift = [-70.0, 0.0]\ndrop_zigzag = true\n" + ROUNDED,
              "avg_HR.BAN", "flip = true\nmirror = true\ndrop_zigzag = true\n" + ROUNDED, 457.2),
    "it795": ("whl_left_iter795.whl", "shift = [-70.0, 0.0]\ndrop_zigzag = true\n" + ROUNDED,
              "rail_left_iter795.ban", "flip = true\nmirror = true\n" + ROUNDED, 457.2),
}


@dataclass
class DefaultScene:
    name: str
    kind: str
    text: str


def listed(values):
    return "[" + ", ".join(f"{value:.6g}" for value in values) + "]"


def examples():
    for path in sorted(CASES.glob("*.toml")):
        yield DefaultScene(f"example_{path.stem}", "example", with_keys(path.read_text("utf-8"), BARE))


def ellipse(draw, number, kind="ellipse"):
    """Radii, materials, load, creepages or forces; one third are creep curves."""
    scene = scene_sets.random_scene(draw.randrange(10**6), number)
    keys = {}
    if draw.random() < 1 / 3:
        top = scene_sets.log_uniform(draw, 1e-3, 1e-2)
        keys["rolling.longitudinal_creepage"] = listed([top * k / 6 for k in range(7)])
    elif draw.random() < 0.2:
        keys = {"rolling.longitudinal_creepage": None, "rolling.longitudinal_force": "500.0"}
    return DefaultScene(f"{kind}_{number}", kind, with_keys(scene.text, keys))


def roller(draw, number):
    """Small wheels and rollers of any two materials, possibly one rigid body; light or heavy loads."""
    radius = scene_sets.log_uniform(draw, 5, 150)
    across = scene_sets.log_uniform(draw, 5, 500)
    moduli = [draw.choice(["210e3", "70e3", "3000.0", "200.0"]), draw.choice(["210e3", "70e3", "inf"])]
    softest = min(float(young) for young in moduli)
    # p0 up to a hundredth of the softer body's modulus, the range of linear elasticity.
    pressure = softest * scene_sets.log_uniform(draw, 5e-4, 8e-3)
    load = math.pi**3 / 6 * pressure**3 * radius * across / softest**2  # of a sphere, by Hertz
    return DefaultScene(f"roller_{number}", "roller", f"""title = "roller {number}"
[load]
normal_force = {load:.5g}
[friction]
coefficient = {draw.uniform(0.05, 0.8):.3f}
[wheel]
rolling_radius = {radius:.5g}
transverse_radius = {draw.choice([across, math.inf]):.5g}
young_modulus = {moduli[0]}
poisson_ratio = {draw.uniform(0.2, 0.45):.3f}
[rail]
transverse_radius = {across:.5g}
young_modulus = {moduli[1]}
poisson_ratio = {draw.uniform(0.2, 0.45):.3f}
[rolling]
longitudinal_creepage = {draw.choice([-1, 1]) * scene_sets.log_uniform(draw, 1e-4, 5e-3):.4g}
lateral_creepage = {draw.uniform(-1e-3, 1e-3):.4g}
""")


def history(draw, number):
    """Shifts, transients and pressing in steps."""
    unlike = draw.random() < 0.4
    radii = [scene_sets.log_uniform(draw, 100, 1000), scene_sets.log_uniform(draw, 100, 1000)]
    load = scene_sets.log_uniform(draw, 1e3, 1e5)
    kind = draw.choice(["shift", "transient", "pressing"])
    steps = draw.randrange(2, 12)
    if kind == "shift":
        size = 1e-3 * scene_sets.log_uniform(draw, 0.5, 10)
        rest = f'[rolling]\nproblem = "shift"\n[history]\nlongitudinal_shift = {listed([size] * steps)}\n'
        loads = f"[load]\nnormal_force = {load:.5g}\n"
    elif kind == "transient":
        rest = (f'[rolling]\nproblem = "transient"\nlongitudinal_creepage = {draw.uniform(-3e-3, 3e-3):.4g}\n'
                f"[history]\nsteps = {steps}\nstep_length = {draw.uniform(0.3, 2.0):.3g}\n")
        loads = f"[load]\nnormal_force = {load:.5g}\n"
    else:
        rest = ('[rolling]\nproblem = "shift"\n[history]\nnormal_force = '
                + listed([load * ((k + 1) / steps) ** 3 for k in range(steps)]) + "\n")
        loads = ""
    return DefaultScene(f"history_{number}", "history", f"""title = "{kind} {number}"
{loads}[friction]
coefficient = {draw.uniform(0.1, 0.6):.3f}
[wheel]
rolling_radius = {draw.uniform(200, 600):.4g}
transverse_radius = {radii[0]:.5g}
young_modulus = {"70e3" if unlike else "210e3"}
[rail]
transverse_radius = {radii[1]:.5g}
{rest}""")


def other(draw, number):
    """Line contact, a given pressure, a given distance, no friction, an approach."""
    kind = draw.choice(["line", "pressure", "quadratic", "file", "frictionless", "approach", "stress"])
    friction = f"[friction]\ncoefficient = {draw.uniform(0.05, 0.6):.3f}\n"
    rolling = f"[rolling]\nlongitudinal_creepage = {scene_sets.log_uniform(draw, 1e-4, 5e-3):.4g}\n"
    young = draw.choice(["210e3", "210e3", "70e3"])
    wheel = f"[wheel]\nyoung_modulus = {young}\n"
    load = f"[load]\nnormal_force = {scene_sets.log_uniform(draw, 1e3, 1e5):.5g}\n"
    radii = (f"{wheel}rolling_radius = {draw.uniform(200, 600):.4g}\ntransverse_radius = inf\n"
             f"[rail]\ntransverse_radius = {scene_sets.log_uniform(draw, 150, 1500):.5g}\n")
    rest = {
        "line": f"[load]\nnormal_force = {scene_sets.log_uniform(draw, 50, 800):.4g}\n{friction}{wheel}[geometry]\n"
                f'shape = "line"\nrelative_radius = {draw.uniform(20, 400):.4g}\n{rolling}',
        "pressure": f"{load}{friction}{wheel}[given_pressure]\nsemi_axis_x = {draw.uniform(2, 8):.3g}\n"
                    f"semi_axis_y = {draw.uniform(2, 8):.3g}\n{rolling}",
        "quadratic": f"{load}{friction}{wheel}[undeformed_distance]\nquadratic = "
                     f"{listed([scene_sets.log_uniform(draw, 5e-4, 5e-3) for _ in range(2)])}\n{rolling}",
        "file": f'{load.split("=")[0]}= {draw.uniform(20e3, 60e3):.5g}\n{friction}{wheel}[undeformed_distance]\n'
                f'file = "distance.csv"\n{rolling}',
        "frictionless": f'{load}{friction}{radii}[rolling]\nproblem = "frictionless"\n',
        "approach": f"[load]\napproach = {scene_sets.log_uniform(draw, 0.01, 0.2):.4g}\n{friction}{radii}{rolling}",
        "stress": f"{load}{friction}{radii}{rolling}[output]\nstress_maxima = true\n",
    }[kind]
    return DefaultScene(f"other_{number}", "other", f'title = "{kind} {number}"\n{rest}')


def wheelset(draw, shifts, side):
    """Motion and place on the track."""
    free = draw.random() < 0.5
    rolling = "" if free else f"[rolling]\nlongitudinal_creepage = {draw.uniform(-2e-3, 2e-3):.4g}\n"
    return (f'[wheelset]\nside = "{side}"\nlateral_shift = {listed(shifts)}\nyaw = {draw.uniform(0, 0.005):.4g}\n'
            + (f'free_rolling = "{"torque" if side == "both" else "force"}"\n' if free else "") + rolling)


def profile_text(draw, wheel, wheel_section, rail, rail_section, track, placed, radius=460.0):
    return (f"[load]\nvertical_force = {draw.uniform(30e3, 120e3):.5g}\n[friction]\n"
            f"coefficient = {draw.uniform(0.1, 0.55):.3f}\n[wheel]\nrolling_radius = {radius}\nprofile = \"{wheel}\"\n"
            f"[wheel_profile]\n{wheel_section}[rail]\nprofile = \"{rail}\"\n[rail_profile]\n{rail_section}"
            f"[track]\n{track}{placed}")


STANDARD_TRACK = 'gauge = {:.5g}\ninclination = "{}"\n'


def standard(draw, number):
    track = STANDARD_TRACK.format(draw.uniform(1432, 1440), draw.choice(["1:20", "1:40"]))
    placed = wheelset(draw, [draw.uniform(-6.5, 6.5)], draw.choice(["left", "right"]))
    text = profile_text(draw, draw.choice(["S1002", "S1002-smooth"]), "", draw.choice(["60E1", "UIC60-manchester"]), "",
                        track, placed)
    return DefaultScene(f"standard_{number}", "standard profiles", text)


def rows(draw, number):
    """Several positions or both wheels."""
    track = STANDARD_TRACK.format(1435, "1:40")
    count = draw.randrange(2, 6)
    placed = wheelset(draw, sorted(draw.uniform(-6, 6) for _ in range(count)), "both")
    text = profile_text(draw, "S1002", "", "60E1", "", track, placed)
    return DefaultScene(f"rows_{number}", "lateral sweeps", text)


def worn(draw, number):
    track = STANDARD_TRACK.format(1435, draw.choice(["1:20", "1:40"]))
    placed = wheelset(draw, [draw.uniform(-6, 6)], draw.choice(["left", "right"]))
    text = profile_text(draw, f"worn_{number}.csv", "smoothing = 0.01\n", "60E1", "", track, placed)
    return DefaultScene(f"worn_{number}", "worn, with scatter", text)


def write_worn(folder, draw, number):
    """S1002 with a hollow tread, a worn flange root, points that scatter and perhaps a step."""
    depth, middle, width = draw.uniform(0, 2.0), draw.uniform(-15, 15), draw.uniform(15, 35)
    scatter, step = draw.uniform(0, 0.01), draw.choice([0.0, 0.0, 0.01, 0.03])
    lines = ["y, z"]
    for k in range(-240, 221):
        y = 0.25 * k
        way = (y - middle) / width
        wear = 0.5 * depth * (1 + math.cos(math.pi * way)) if abs(way) < 1 else 0.0
        z = hollow_s1002.new(y) - wear + draw.gauss(0, scatter) + (step if y > middle + 5 else 0.0)
        lines.append(f"{y:.2f}, {z:.5f}")
    (folder / f"worn_{number}.csv").write_text("\n".join(lines) + "\n", "utf-8")


def measured(draw, number, folder):
    pair = draw.choice(sorted(MEASURED))
    wheel, wheel_section, rail, rail_section, radius = MEASURED[pair]
    smoothing = f"smoothing = {draw.uniform(0.005, 0.02):.3f}\n" if draw.random() < 0.5 else ""
    track = 'gauge = 1435.1\ngauge_height = 15.875\ninclination = "none"\n'
    placed = wheelset(draw, [draw.uniform(-4, 4)], "left").replace(
        "[wheelset]\n", "[wheelset]\nflange_back_distance = 1347.4\nroll = 0.0\n")
    text = profile_text(draw, folder / wheel, wheel_section + smoothing, folder / rail, rail_section + smoothing,
                        track, placed, radius)
    return DefaultScene(f"measured_{pair}_{number}", "measured pair", text)


def write_distance(folder):
    """A paraboloid whose curvature across changes at y = 2 mm."""
    lines = ["x, y, h"]
    for j in range(-40, 41):
        for i in range(-40, 41):
            x, y = 0.3 * i, 0.3 * j
            bend = 1e-3 * y * y + 1.5e-3 * max(0.0, y - 2.0) ** 2
            lines.append(f"{x:.4g}, {y:.4g}, {1.1e-3 * x * x + bend:.8g}")
    (folder / "distance.csv").write_text("\n".join(lines) + "\n", "utf-8")


COUNTS = {ellipse: 60, roller: 35, history: 30, other: 40, standard: 45, rows: 12, worn: 30}


def scenes(seed, folder, measured_folder):
    """The scenes, and in `folder` the files that they name. Without a folder of measured pairs (None) these are left
    out."""
    write_distance(folder)
    made = list(examples())
    for make, count in COUNTS.items():
        made += [make(random.Random(f"{seed} {make.__name__} {number}"), number) for number in range(count)]
    for number in range(COUNTS[worn]):
        write_worn(folder, random.Random(f"{seed} wear {number}"), number)
    if measured_folder is not None:
        made += [measured(random.Random(f"{seed} measured {number}"), number, measured_folder.resolve())
                 for number in range(300 - len(made))]
    return made
