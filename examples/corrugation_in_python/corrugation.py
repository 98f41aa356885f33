#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Waves of a rail that friction lets grow or wears away, by the work of every step. README.md has the results.

Call: corrugation.py [WAVELENGTH ...], in mm."""
import sys

import numpy as np
import rollfem

AMPLITUDE = 0.01  # mm
STEP = 1.0        # mm
WHEEL = {
    "title": "a braked wheel on a rail with a wave",
    "wheel": {"profile": "arcs", "rolling_radius": 460.0}, "wheel_profile": {"radii": [1e6], "ends": [40.0], "symmetric": True},
    "rail": {"profile": "arcs"}, "rail_profile": {"radii": [300.0], "ends": [36.0], "symmetric": True, "free_ends": True},
    "load": {"vertical_force": 80e3}, "friction": {"coefficient": 0.3}, "rolling": {"problem": "transient"},
    "history": {"start": "steady"}, "contact_grid": {"elements_across": 16},
    "output": {"paths": [], "fields": False, "grid_fields": "all"}}


def work_over_rail(wave):
    """Work of friction on each mm^2 of rail in the plane y = 0, N/mm, over places along the rail, mm: that of one wave."""
    ways = np.arange(0.0, 2.0 * wave + 40.0, STEP)
    pose = {"lateral_position": 0.0, "rotation_change": -0.001, "track_position": ways.tolist()}
    result = rollfem.solve({**WHEEL, "placement": pose, "rail_corrugation": {"wavelength": wave, "amplitude": AMPLITUDE}},
                           model="halfspace")
    places, work = [], []
    for way, step in zip(ways, result):
        point = step.points[0]
        middle = np.argmin(np.abs(step.y))
        density = -(point.traction_x * point.slip_x + point.traction_y * point.slip_y)[middle]
        places.append(way + step.place["x_track"] + step.x)
        work.append(density * STEP)
    # On places that all steps know: each step is a curve over the rail.
    along = np.linspace(20.0 + wave, 20.0 + 2.0 * wave, 64, endpoint=False)
    return along, sum(np.interp(along, x, w, left=0.0, right=0.0) for x, w in zip(places, work))


def growth(wave):
    """How fast the wave grows, in mm per mm that the rail wears on average, and the work at the wave over the mean work."""
    along, work = work_over_rail(wave)
    turn = np.exp(-2j * np.pi * along / wave)
    height = np.cos(2.0 * np.pi * along / wave)  # up; wear lowers it
    ripple = 2.0 * np.mean(work * turn) / np.mean(work)
    shape = 2.0 * np.mean(height * turn)
    return -(ripple / shape).real / AMPLITUDE, abs(ripple)


def main():
    waves = [float(word) for word in sys.argv[1:]] or [60.0, 30.0, 20.0, 12.0, 8.0]
    print("wavelength mm, growth 1/mm of mean wear, ripple of the work")
    for wave in waves:
        rate, ripple = growth(wave)
        print(f"{wave:g} {rate:.4g} {ripple:.4g}", flush=True)


if __name__ == "__main__":
    main()
