#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hunting of a sprung wheelset and its way into a curve, by librollfem_c. README.md has the results.

Call: hunting.py rollfem.h librollfem_c.so [--table DIR] [-o DIR] [--short]; DIR of `rollfem table`, then of figures."""
import argparse
import json
import math
import pathlib
import tempfile

import numpy

import rollfem_c
import runs
import table_forces
import wheelset

CURVE = 600.0       # m, radius, to the right
HALF_WHEELBASE = 1.25  # m, of the bogie whose leading wheelset this is


def tell(results, name, value):
    results[name] = value
    print(f"{name:58s} {value:.5g}" if isinstance(value, float) else f"{name:58s} {value}", flush=True)


def waves(contact, results, short):
    """The cone's wave against Klingel's, with its equivalent conicity in closed form."""
    slow = runs.free(1.0)
    half = runs.half_distance(slow, contact)
    # Wickens: of a cone on a rail head of 300 mm.
    closed = runs.CONICITY * (half + 0.3 * runs.CONICITY) / (half - slow.radius * runs.CONICITY)
    tell(results, "cone: equivalent conicity, closed form", closed)
    tell(results, "cone: equivalent conicity, rolling radii", runs.harmonic_conicity(slow, contact, 3e-3, 8))
    tell(results, "cone: wave of Klingel, m", runs.klingel(slow.radius, half, closed))
    _, frequency = runs.mode_of(slow, contact)
    tell(results, "cone: wave, linear at 1 m/s, m", 2.0 * math.pi / frequency)
    if not short:
        tell(results, "cone: wave, time series at 10 m/s, m", runs.wave_length(runs.free(10.0), contact, 3e-3, closed))


def hunting(contact, results, short, name):
    """Critical speed, growth of small oscillations against the linear one, and the series."""
    critical = runs.critical_speed(contact, 60.0, 90.0)
    tell(results, f"{name}: critical speed, linear, m/s", critical)
    series = {}
    for factor in (0.9, 1.1):
        vehicle = wheelset.Vehicle(speed=factor * critical)
        start = runs.rolling(vehicle, contact, 1e-4)
        t, y, per_second = runs.integrate(vehicle, contact, start, 0.5 if short else 1.6, 0.004)
        tell(results, f"{name}: growth at {factor} of it, time series, 1/s", runs.growth(t, y[0]))
        tell(results, f"{name}: growth at {factor} of it, linear, 1/s", runs.mode_at(vehicle.speed, contact)[0])
        tell(results, f"{name}: seconds simulated per second of CPU", per_second)
        series[factor] = (t, y)
    return critical, series


def into_curve(lib, results):
    """S1002 on 60E1: lateral shift, and the forces of both wheels, in the full curve."""
    contact = wheelset.ContactForces(lib)
    vehicle = wheelset.Vehicle(speed=20.0)
    ramp = 1.0  # s

    def curve(t):
        part = math.sin(0.5 * math.pi * min(t / ramp, 1.0)) ** 2
        return part / CURVE, -part * HALF_WHEELBASE / CURVE

    t, y, per_second = runs.integrate(vehicle, contact, runs.rolling(vehicle, contact), 2.5, 0.005, curve,
                                      jacobian_every=10)
    tell(results, "curve: seconds simulated per second of CPU", per_second)
    tell(results, "curve: lateral shift, mm", 1e3 * y[0, -1])
    tell(results, "curve: yaw, mrad", 1e3 * y[2, -1])
    vehicle.curvature, vehicle.frame_yaw = curve(t[-1])
    left, right = contact.results(vehicle, y[:, -1])
    difference = left.patch[0].rolling_radius - right.patch[0].rolling_radius
    tell(results, "curve: difference of radii, mm", 1e3 * difference)
    tell(results, "curve: difference of radii for pure rolling, mm", 1e3 * 1.505 * vehicle.radius / CURVE)
    for name, wheel in (("outer", left), ("inner", right)):
        tell(results, f"curve: {name} wheel: patches", wheel.patch_count)
        tell(results, f"curve: {name} wheel: forces along and across, kN",
             " ".join(f"{1e-3 * wheel.force[d]:.2f}" for d in (0, 1)))
        tell(results, f"curve: {name} wheel: T-gamma, N", wheel.creepage_work)
    forces = numpy.array([[[w.force[0], w.force[1]] for w in contact.results(vehicle_at(vehicle, curve, t[k]), y[:, k])]
                          for k in range(0, len(t), 10)])
    return t, y, t[::10], forces


def vehicle_at(vehicle, curve, time):
    vehicle.curvature, vehicle.frame_yaw = curve(time)
    return vehicle


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("header")
    parser.add_argument("library")
    parser.add_argument("--table")
    parser.add_argument("-o", "--output", default=None)
    parser.add_argument("--short", action="store_true", help="a minute's part of it, without the curve and figures")
    given = parser.parse_args()
    lib = rollfem_c.Library(given.header, given.library)
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        contact = wheelset.ContactForces(lib, **runs.cone_profile(pathlib.Path(folder)))
    waves(contact, results, given.short)
    critical, series = hunting(contact, results, given.short, "cone")
    if given.table:
        table = table_forces.TableForces(contact, lib.table(given.table), wheelset.Vehicle(speed=20.0))
        hunting(table, results, given.short, "table")
    if given.output:
        folder = pathlib.Path(given.output)
        folder.mkdir(parents=True, exist_ok=True)
    if not given.short:
        curve = into_curve(lib, results)
        if given.output:
            import figures  # pylint: disable=import-outside-toplevel

            speeds = numpy.linspace(20.0, 110.0, 10)
            figures.draw(folder, contact, critical, series, speeds, curve)
    if given.output:
        (folder / "results.json").write_text(json.dumps(results, indent=1))


if __name__ == "__main__":
    main()
