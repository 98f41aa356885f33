#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wheelset that wears: S1002 on 60E1 over 100 000 km in 20 steps. docs/wear.md explains it, README.md has the results.

Call: wear_loop.py [-o DIR] [--steps N] [--positions N] [--tractions N] [--distance KM] [--threads N] [--no-figures]"""
import argparse
import json
import math
import pathlib
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import rollfem
from rollfem import wear

RADIUS = 460.0              # mm, at the tape line
BETWEEN_CONTACTS = 1500.0   # mm
CASE = rollfem.Case(
    title="a wheelset that wears",
    load={"vertical_force": 60e3},                      # N on each wheel
    friction={"coefficient": 0.35},
    wheel={"rolling_radius": RADIUS, "profile": "S1002"},
    rail={"profile": "60E1"},
    track={"gauge": 1435.0, "inclination": "1:40"},
    wheelset={"side": "both", "lateral_shift": 0.0, "rotation_change": 0.0},
    contact_grid={"elements_across": 10})
# How the wheelset runs, as standard deviations: lateral shift, with which it steers along its own curve; angle of attack;
# longitudinal creepage of driving and braking.
SHIFT, YAW, TRACTION = 2.5, 3e-4, 3e-4  # mm, rad, -
FARTHEST = 5.0              # mm; beyond, the flange would lead
LAW = wear.WorkInRegimes(factor=0.25)  # a line that is not always dry
SMOOTHING = 2.0             # mm; states between those that are solved wear the places between


def normal_quantile(share):
    """The value below which this share of a normal distribution lies, by Newton's method."""
    value = 0.0
    for _ in range(60):
        below = 0.5 * math.erfc(-value / math.sqrt(2.0))
        slope = math.exp(-0.5 * value * value) / math.sqrt(2.0 * math.pi)
        value += max(-1.0, min(1.0, (share - below) / slope))
    return value


def running_states(step, positions, tractions):
    """(lateral shifts, yaws, creepages) of equal weight, evenly spread (Kronecker's sequence) and others at each step.
    Every state has its mirror image, as the wheelset runs to the left as much as to the right."""
    half = np.arange(step * positions // 2, (step + 1) * positions // 2)
    shares = [(0.5 + number * (half + 1)) % 1.0 for number in (0.7548776662, 0.5698402910)]
    beyond = 0.5 * math.erfc(FARTHEST / SHIFT / math.sqrt(2.0))
    shift = np.array([normal_quantile(beyond + (1.0 - 2.0 * beyond) * share) for share in shares[0]])
    yaw = np.array([normal_quantile(share) for share in shares[1]])
    creepages = [TRACTION * normal_quantile((k + 0.5) / tractions) for k in range(tractions)]
    return (np.round(np.concatenate([SHIFT * shift, -SHIFT * shift]), 4),
            np.round(np.concatenate([YAW * yaw, -YAW * yaw]), 7), creepages)


def rolling(case):
    """(rotation_change, yaw_velocity) with which both wheels roll without slip: they turn with V over their mean radius,
    and the wheelset along the curve of a cone with their radii."""
    left, right = (place["rolling_radius"] for place in rollfem.contact_points(case) if place["patch"] == 1)
    mean = 0.5 * (left + right)
    return RADIUS / mean - 1.0, (left - right) / (mean * BETWEEN_CONTACTS)


def wear_of_step(case, profile, step, given):
    """What each point of the profile loses over a distance (km), mm^2, the mean of both wheels; and the mean frictional
    work on a wheel, J/m."""
    shifts, yaws, creepages = running_states(step, given.positions, given.tractions)
    states = 2 * len(shifts) * given.tractions  # of single wheels
    passes = wear.passes_of_wheel(1e6 * given.distance, RADIUS) / states

    def at(position):
        there = case.with_({"wheelset.lateral_shift": position[0], "wheelset.yaw": position[1]})
        rotation, steering = rolling(there)
        result = rollfem.solve(there.with_({"wheelset.yaw_velocity": steering,
                                            "wheelset.rotation_change": [rotation + creepage for creepage in creepages]}),
                               model="halfspace")
        return (sum(profile.area_of(result.models, LAW, passes, point=k) for k in range(given.tractions)),
                sum(point.frictional_work for patch in result for point in patch) / states)

    with ThreadPoolExecutor(given.threads) as pool:
        areas, works = zip(*pool.map(at, zip(shifts, yaws)))
    return sum(areas), sum(works)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", default="worn")
    for name, default, what in (("steps", 20, "of wear"), ("positions", 40, "of the wheelset in a step, even"),
                                ("tractions", 5, "of driving and braking at each"), ("threads", 2, "")):
        parser.add_argument(f"--{name}", type=int, default=default, help=what)
    parser.add_argument("--distance", type=float, default=5000.0, help="km of a step")
    parser.add_argument("--no-figures", action="store_true")
    given = parser.parse_args()
    folder = pathlib.Path(given.output)
    folder.mkdir(parents=True, exist_ok=True)
    profile = wear.WornProfile.of(rollfem.Profile("S1002-smooth", "wheel"))
    case, history, profiles = CASE, [], [profile]
    for step in range(given.steps + 1):
        case = CASE.with_({"wheel.profile": str(profile.write(folder / f"wheel_{step:02}.csv"))})
        rigid = rollfem.wheelset(case, reach=6.0)
        row = {"distance": step * given.distance, "lateral_shift": list(rigid.lateral_shift),
               "conicity": float(np.interp(3.0, rigid.lateral_shift, rigid.conicity_harmonic)),
               "y_wheel": list(rigid.y_wheel_right)}
        history.append(row)
        if step == given.steps:
            break
        begin = time.perf_counter()
        area, work = wear_of_step(case, profile, step, given)
        profile = profile.worn(area, smoothing=SMOOTHING)
        profiles.append(profile)
        row.update(area=float(area.sum()), deepest=float((area / profiles[-2].widths).max()), work=float(work),
                   seconds=time.perf_counter() - begin)
        print(f"{row['distance']:8.0f} km: conicity {row['conicity']:.4f}, {row['area']:.3f} mm2 and {row['deepest']:.4f} mm at "
              f"the deepest, {row['work']:.2f} N of friction, {row['seconds']:.1f} s", flush=True)
    (folder / "history.json").write_text(json.dumps(history, indent=1))
    if not given.no_figures:
        import figures  # pylint: disable=import-outside-toplevel

        figures.draw(folder, profiles, history, given.distance)


if __name__ == "__main__":
    main()
