# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes for statistical benchmarks: cases a to f at two loads, patches of true profiles and random curved bodies from
a seed; and runs of a program on them, stored in files and reused."""

import argparse
import json
import math
import os
import random
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from pin_cases import with_keys, write_files

CASES = Path(__file__).resolve().parent.parent / "cases"

# Limits of random scenes, beyond which linear elasticity or a single patch would not represent wheel and rail.
LARGEST_PRESSURE = 3000.0  # MPa
LARGEST_PART_OF_RADIUS = 0.3  # half the patch over a transverse radius; 0.21 in case f
MOST_UNLIKE_AXES = 8.0


@dataclass
class Scene:
    """A case file without models, grid and accuracy."""

    name: str
    kind: str  # "thesis", "profile" or "random"
    text: str

    def with_keys(self, **keys):
        """In arguments, `__` is the dot of section.key; strings carry their own quotes."""
        return with_keys(self.text, {key.replace("__", "."): value for key, value in keys.items()})


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def of_case(name, kind, file, keys):
    bare = {"models": None, "contact_grid.elements_across": None, "contact_grid.cell_size": None, "output.paths": None,
            "fem.cell_size": None, "fem.degree": None, "output.fields": "false"}
    return Scene(name, kind, with_keys((CASES / file).read_text("utf-8"), {**bare, **keys}))


def thesis_scenes():
    for letter in "abcdef":
        for load in (20, 100):
            yield of_case(f"{letter}_{load}", "thesis", f"thesis_{letter}.toml",
                          {"load.normal_force": f"{load}e3", "rolling.longitudinal_creepage": "[0.0, 0.001]"})


def profile_scenes():
    """One patch each: a ball on the head, at the gauge corner, a hollow wheel."""
    for side in ("left", "right"):
        for load in (50, 100):
            yield of_case(f"s1002_{side}_{load}", "profile", f"s1002_uic60_{side}.toml",
                          {"load.vertical_force": f"{load}e3", "rolling.longitudinal_creepage": "[0.0, 0.002]"})
    free = {"wheelset.free_rolling": None, "rolling.extra_slip": None}
    for shift, yaw in ((0.0, 0.0), (3.0, 0.0072)):
        yield of_case(f"manchester_{shift:g}", "profile", "manchester_A22.toml",
                      {**free, "load.vertical_force": "40e3", "wheelset.side": '"left"', "wheelset.yaw": str(yaw),
                       "wheelset.lateral_shift": str(shift), "rolling.longitudinal_creepage": "0.001"})
    for side in ("left", "right"):
        yield of_case(f"worn_{side}", "profile", "worn_hollow.toml",
                      {**free, "wheelset.side": f'"{side}"', "wheelset.lateral_shift": "2.0",
                       "rolling.longitudinal_creepage": "0.001"})


def transverse_radii(draw):
    """Transverse radii of rail and wheel, mm; negative if concave."""
    kind = draw.choice(["flat", "convex", "groove of the wheel", "groove of the wheel", "groove of the rail"])
    small = log_uniform(draw, 40, 1000)
    groove = -draw.uniform(1.03, 3.0) * small
    return {"flat": (small, math.inf), "convex": (small, log_uniform(draw, 80, 2000)),
            "groove of the wheel": (small, groove), "groove of the rail": (groove, small)}[kind]


def materials(draw):
    """Young's moduli and Poisson's ratios; one third unlike."""
    if draw.random() < 2 / 3:
        nu = draw.uniform(0.25, 0.33)
        return (210e3, 210e3), (nu, nu)
    return (draw.choice([70e3, 110e3, 210e3]), 210e3), (draw.uniform(0.2, 0.4), draw.uniform(0.2, 0.4))


def is_sensible(wheel, radii, moduli, ratios, load):
    """Hertz's patch with the exponents of Hamrock and Brewe (1983) for the ellipse."""
    along, across = 1 / wheel, sum(1 / radius for radius in radii)
    if across <= 0:
        return False
    stiffness = 1 / sum((1 - nu**2) / young for young, nu in zip(moduli, ratios))
    mean = (0.75 * load / math.sqrt(along * across) / stiffness) ** (1 / 3)
    slender = (along / across) ** (2 / math.pi)
    half_width = mean * math.sqrt(slender)
    tightest = min(abs(radius) for radius in radii)
    return (1 / MOST_UNLIKE_AXES < slender < MOST_UNLIKE_AXES and half_width < LARGEST_PART_OF_RADIUS * tightest
            and 1.5 * load / math.pi / mean**2 < LARGEST_PRESSURE)


def random_scene(seed, number):
    draw = random.Random(1000003 * seed + number)
    while True:
        wheel = log_uniform(draw, 100, 300) if draw.random() < 0.25 else draw.uniform(300, 600)
        radii = transverse_radii(draw)
        moduli, ratios = materials(draw)
        load = log_uniform(draw, 5e3, 150e3)
        if is_sensible(wheel, radii, moduli, ratios, load):
            break
    size = log_uniform(draw, 1e-4, 4e-3)
    creepage = [size * draw.choice([-1, 1]), 0.0, 0.0]
    if draw.random() < 0.5:
        creepage = [size * draw.uniform(-1, 1), size * draw.uniform(-1, 1), 0.2 * size * draw.uniform(-1, 1)]
    return Scene(f"random_{seed}_{number}", "random", f"""title = "random contact {number} of seed {seed}"
[load]
normal_force = {load:.6g}
[friction]
coefficient = {draw.uniform(0.1, 0.6):.4f}
[wheel]
rolling_radius = {wheel:.6g}
transverse_radius = {radii[1]:.6g}
young_modulus = {moduli[0]:g}
poisson_ratio = {ratios[0]:.3f}
[rail]
transverse_radius = {radii[0]:.6g}
young_modulus = {moduli[1]:g}
poisson_ratio = {ratios[1]:.3f}
[rolling]
longitudinal_creepage = {creepage[0]:.5g}
lateral_creepage = {creepage[1]:.5g}
spin = {creepage[2]:.5g}
[output]
fields = false
""")


def scenes(seed, randoms):
    """The 20 fixed scenes and a number of random ones."""
    return [*thesis_scenes(), *profile_scenes(), *(random_scene(seed, number) for number in range(randoms))]


def parser(description):
    """The options of every benchmark on scenes."""
    options = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", required=True, help="the program rollfem, built with finite elements")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("-o", "--output", type=Path, required=True)
    return options


def prepare(folder):
    """The folder of runs with the files named by the case files."""
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / "profiles").exists():
        write_files(folder, CASES)


def run(program, folder, name, text, *arguments):
    """The result of a case (summary.json) with its CPU seconds as `cpu`; an earlier run with the same text and
    arguments is reused. Without a result: {"failed": message}."""
    case, kept = folder / f"{name}.toml", folder / f"{name}.json"
    text = f"# run {' '.join(arguments)}\n{text}"
    if kept.exists() and case.exists() and case.read_text("utf-8") == text:
        return json.loads(kept.read_text("utf-8"))
    case.write_text(text, "utf-8")
    before = os.times()
    with tempfile.TemporaryDirectory() as cache:  # no run reuses the corrections of another: seconds of a cold start
        done = subprocess.run([program, "run", str(case), *arguments, "--no-report", "-q", "-o", str(folder / name)],
                              capture_output=True, text=True, check=False, env={**os.environ, "ROLLFEM_CACHE": cache})
    after = os.times()
    summary = folder / name / "summary.json"
    if done.returncode in (0, 1) and summary.exists():
        result = json.loads(summary.read_text("utf-8"))
    else:
        result = {"failed": (done.stderr.strip() or done.stdout.strip() or "no message").splitlines()[-1]}
    result["cpu"] = after.children_user + after.children_system - before.children_user - before.children_system
    result["status"] = done.returncode
    kept.write_text(json.dumps(result), "utf-8")
    return result
