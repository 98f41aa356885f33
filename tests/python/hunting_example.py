#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""examples/hunting_in_python, in short: the wave of a cone against Klingel and its conicity in closed form, derivatives
against differences, critical speed and growth against a time series, and the same by a table of creep forces.
Status 77 without NumPy. Call: hunting_example.py EXAMPLES rollfem.h librollfem_c.so PROGRAM CASES"""
import math
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("NumPy is not installed: skipped")
    sys.exit(77)

examples, header, library, program, cases = sys.argv[1:]
sys.path.insert(0, str(pathlib.Path(examples) / "hunting_in_python"))
import rollfem_c
import runs
import table_forces
import wheelset


def near(what, value, expected, within):
    print(f"{what}: {value:.6g}, expected {expected:.6g} within {100 * within:g} %")
    assert abs(value / expected - 1.0) <= within, what


def derivatives(contact):
    """Of the rates by the unknowns beside the middle, against differences."""
    vehicle, at = wheelset.Vehicle(speed=30.0), numpy.array([1e-3, 0.02, 5e-4, 0.01, 0.02])
    matrix = wheelset.jacobian(vehicle, contact, at)
    steps = numpy.array([2e-5, 1e-3, 3e-5, 1e-3, 2e-3])
    found = numpy.zeros((5, 5))
    for k, step in enumerate(steps):
        moved = step * numpy.eye(5)[k]
        found[:, k] = (wheelset.rates(vehicle, contact, at + moved) - wheelset.rates(vehicle, contact, at - moved)) / (2 * step)
    for row in (1, 3, 4):
        error = numpy.abs(matrix[row] - found[row]).max() / numpy.abs(found[row]).max()
        print(f"row {row}: {error:.3%} of its largest entry")
        assert error < 0.02


def main():
    lib = rollfem_c.Library(header, library)
    folder = pathlib.Path(tempfile.mkdtemp())
    contact = wheelset.ContactForces(lib, **runs.cone_profile(folder))
    slow = runs.free(1.0)
    half = runs.half_distance(slow, contact)
    closed = runs.CONICITY * (half + 0.3 * runs.CONICITY) / (half - slow.radius * runs.CONICITY)  # Wickens
    near("conicity", runs.harmonic_conicity(slow, contact, 3e-3, 8), closed, 0.002)
    frequency = runs.mode_of(slow, contact)[1]
    near("wave, m", 2.0 * math.pi / frequency, runs.klingel(slow.radius, half, closed), 0.002)
    derivatives(contact)
    critical = runs.critical_speed(contact, 60.0, 90.0)
    vehicle = wheelset.Vehicle(speed=1.1 * critical)
    t, y, _ = runs.integrate(vehicle, contact, runs.rolling(vehicle, contact, 1e-4), 0.5, 0.004)
    near("growth, 1/s", runs.growth(t, y[0]), runs.mode_at(vehicle.speed, contact)[0], 0.05)
    subprocess.run([program, "table", f"{cases}/thesis_a.toml", "--set", "table.axis_ratio=[1.2,1.5]", "--set",
                    "table.points=[6,6,7]", "--set", "table.check_points=5", "-q", "-o", folder / "table"], check=True)
    table = table_forces.TableForces(contact, lib.table(folder / "table"), wheelset.Vehicle(speed=20.0))
    near("critical speed by the table, m/s", runs.critical_speed(table, 60.0, 90.0), critical, 0.02)
    try:
        contact.wheels[0].solve(lib.state(lateral_shift=math.nan))
    except rollfem_c.RollfemError as error:
        assert "out of bounds" in str(error)
    else:
        raise AssertionError("a shift that is no number is solved")


main()
