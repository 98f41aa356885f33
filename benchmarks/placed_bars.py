#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the error bars of the half-space hold on profiles? Random placed wheels, rollers, rings, crossings, layers, discs
with ends and, for comparison, ellipses, on the default grid against one three times as fine: numbers within their bars
by kind of scene and by quantity.

    benchmarks/placed_bars.py --program build/app/rollfem --seed 2 --number 25 -o /tmp/placed_bars

Existing runs are reused. --rows lists every number instead, --kinds takes some of the kinds, --grids other grids.
"""

import collections
import random
import statistics

import scene_sets
from scene_sets import log_uniform

RADII = {"roller": lambda draw: log_uniform(draw, 150, 1500), "ring": lambda draw: -log_uniform(draw, 700, 5000)}
LAYER = "\n[layer]\nthickness = {:.4g}\nshear_modulus = {:.4g}\n"


def rolling(draw):
    """Creepages besides those of the pose, or none."""
    kind = draw.random()
    if kind < 0.3:
        return "[rolling]\n"
    along = draw.choice([-1, 1]) * log_uniform(draw, 2e-4, 5e-3)
    return f"[rolling]\nlongitudinal_creepage = {along:.5g}\n"


def bodies(draw, radius="inf", rails=("60E1", "UIC60-manchester")):
    young = [210e3, 210e3 if draw.random() < 0.7 else draw.uniform(150e3, 280e3)]
    return (f"[load]\nvertical_force = {log_uniform(draw, 15e3, 120e3):.6g}\n[friction]\n"
            f"coefficient = {draw.uniform(0.1, 0.6):.4g}\n[wheel]\nrolling_radius = {draw.uniform(380, 500):.6g}\n"
            f'profile = "{draw.choice(["S1002", "S1002-smooth"])}"\nyoung_modulus = {young[1]:.6g}\n[rail]\n'
            f'profile = "{draw.choice(rails)}"\nrolling_radius = {radius}\nyoung_modulus = {young[0]:.6g}\n')


def placed(draw, radius="inf"):
    """A wheelset on its track, shifted and yawed; at times a rail displaced by itself."""
    text = bodies(draw, radius) + rolling(draw)
    text += f'[track]\ninclination = "{draw.choice(["1:20", "1:40"])}"\n[wheelset]\nside = "{draw.choice(["left", "right"])}"\n'
    text += f"lateral_shift = {draw.uniform(-6, 6):.6g}\nyaw = {draw.uniform(-0.01, 0.01):.6g}\n"
    if draw.random() < 0.3:
        text += f"[rail_displacement]\nroll = [{draw.uniform(-0.01, 0.01):.5g}, {draw.uniform(-0.01, 0.01):.5g}]\n"
    return text


def single(draw, radius):
    """One wheel in the coordinates of the rail's profile."""
    return bodies(draw, radius) + rolling(draw) + (
        f'[placement]\nside = "{draw.choice(["left", "right"])}"\nlateral_position = {draw.uniform(-4, 4):.6g}\n'
        f"yaw = {draw.uniform(-0.01, 0.01):.6g}\nroll = {draw.uniform(-0.02, 0.02):.6g}\n")


def rolled(draw, kind):
    radius = f"{RADII[kind](draw):.6g}"
    return placed(draw, radius) if draw.random() < 0.5 else single(draw, radius)


def crossing(draw):
    sections = scene_sets.CASES / "profiles" / "crossing.sections"
    return bodies(draw, rails=(sections,)) + rolling(draw) + (
        f'[placement]\nside = "{draw.choice(["left", "right"])}"\nlateral_position = {draw.uniform(31, 34):.6g}\n'
        f"track_position = {draw.uniform(5, 235):.6g}\nyaw = {draw.uniform(-0.004, 0.004):.6g}\n")


def layer(draw):
    text = placed(draw) + LAYER.format(log_uniform(draw, 0.005, 0.1), log_uniform(draw, 300, 10e3))
    return text + (f"yield_stress = {draw.uniform(50, 400):.4g}\n" if draw.random() < 0.5 else "")


def disc(draw):
    """Two discs with chamfers, roundings or sharp ends, of unlike widths."""
    sections = ""
    for body, free in (("wheel", draw.random() < 0.4), ("rail", False)):
        half, edge = draw.uniform(3, 6) if body == "wheel" else draw.uniform(6, 9), draw.uniform(0.4, 1.2)
        crown = f"{log_uniform(draw, 30, 3000):.5g}" if draw.random() < 0.6 else "inf"
        radii, ends = ((crown,), (-half, half)) if free else ((f"{edge:.4g}", crown, f"{edge:.4g}"),
                                                             (-half - 0.75 * edge, -half, half, half + 0.75 * edge))
        sections += f'[{body}]\nrolling_radius = {draw.uniform(20, 60):.5g}\nprofile = "arcs"\n[{body}_profile]\n'
        sections += f"radii = [{', '.join(radii)}]\nends = [{', '.join(f'{end:.5g}' for end in ends)}]\n"
        sections += "free_ends = true\n" if free else ""
    return sections + rolling(draw) + (
        f"[load]\nvertical_force = {log_uniform(draw, 1e3, 8e3):.5g}\n[friction]\ncoefficient = {draw.uniform(0.1, 0.6):.4g}\n"
        f"[placement]\nlateral_position = {draw.uniform(-0.5, 0.5):.5g}\n")


KINDS = {"ellipse": lambda draw: scene_sets.random_scene(draw.randrange(10**6), 0).text, "placed wheel": placed,
         "roller": lambda draw: rolled(draw, "roller"), "ring": lambda draw: rolled(draw, "ring"), "crossing": crossing,
         "layer": layer, "disc": disc}


def points_of(result):
    """The first load points, by wheel and patch."""
    return {(model.get("place") or {}).get("patch"): model["points"][0] for model in result.get("models", [])}


def rounding(name, point, friction):
    """The size of a number that stands for 0."""
    bound = friction * point["normal_force"]
    size = bound if "force" in name else bound * point["semi_axis_x"] if "moment" in name else abs(point[name])
    size = max(size, 1e-3 * bound if "work" in name else 0.0)
    return 1e-6 * max(size, point["contact_length"] if "middle" in name else 0.0)


def numbers(options, kind, number):
    """Name, value, error and bar of every number that has a bar."""
    text = KINDS[kind](random.Random(f"{options.seed} {kind} {number}"))
    name = f"{kind.replace(' ', '_')}_{options.seed}_{number}"
    coarse, fine = (scene_sets.run(options.program, options.output, f"{name}_{across}", text, "--model", "halfspace",
                                   "--set", f"contact_grid.elements_across={across}") for across in options.grids)
    if "failed" in coarse or "failed" in fine:
        print(f"{name}: {coarse.get('failed') or fine.get('failed')}")
        return
    friction = float(text.split("\ncoefficient = ")[1].split()[0])
    right = points_of(fine)
    for patch, point in points_of(coarse).items():
        for quantity, bar in point["error_estimate"].items():
            if patch not in right or quantity not in right[patch]:
                print(f"{name}: no {quantity} of patch {patch} on the fine grid")
                continue
            error = abs(point[quantity] - right[patch][quantity])
            if error > rounding(quantity, point, friction):
                yield quantity, name, point[quantity], error, bar


def print_table(head, samples):
    print(f"\n| {head} | numbers | held, % | median of bar / error |\n|---|---|---|---|")
    for name, pairs in samples.items():
        held = sum(error <= bar for error, bar in pairs) / len(pairs)
        print(f"| {name} | {len(pairs)} | {100 * held:.1f} | {statistics.median(bar / error for error, bar in pairs):.1f} |")


def main():
    parser = scene_sets.parser(__doc__)
    parser.add_argument("--number", type=int, default=25, help="scenes of every kind")
    parser.add_argument("--kinds", nargs="+", default=list(KINDS), choices=list(KINDS))
    parser.add_argument("--grids", type=int, nargs=2, default=(40, 120))
    parser.add_argument("--rows", action="store_true")
    options = parser.parse_args()
    scene_sets.prepare(options.output)
    of_kind, of_quantity = collections.defaultdict(list), collections.defaultdict(list)
    for kind in options.kinds:
        for number in range(options.number):
            for quantity, name, value, error, bar in numbers(options, kind, number):
                if options.rows:
                    print(f"{name} {quantity} {value:.7g} {error:.4g} {bar:.4g}")
                for samples in (of_kind[kind], of_quantity[quantity], of_quantity["all"]):
                    samples.append((error, bar))
    print_table("kind", of_kind)
    print_table("quantity", dict(sorted(of_quantity.items())))


if __name__ == "__main__":
    main()
