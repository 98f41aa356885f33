#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""contact_addon.py ROOT LIBRARY PROGRAM: CONTACT's functions by rollfem, called from Python, C and Fortran: closed forms
in every unit convention, both sides of a wheelset, steps of a history, bad calls, threads, leaks."""

import ctypes as C
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT, LIBRARY, PROGRAM = (pathlib.Path(name).resolve() for name in sys.argv[1:4])
HEADER = ROOT / "bindings/contact/rollfem/contact_addon.h"
LIB = C.CDLL(str(LIBRARY))
UNITS, CNTC, SPCK, SI = 1933, 1934, 1935, 1936
CONFIG, PVTIME, TANG, NORM, FORCE, DISCNS, SENS, BOUND = 1967, 1970, 1972, 1973, 1974, 1977, 1988, 1971
E, NU, MU = 206000.0, 0.28, 0.3
G = E / (2 + 2 * NU)


def call(name, *arguments):
    """Numbers by reference, lists as arrays, texts with their length."""
    given = []
    for value in arguments:
        if isinstance(value, bool) or value is None:
            given.append(None)
        elif isinstance(value, int):
            given.append(C.byref(C.c_int(value)))
        elif isinstance(value, float):
            given.append(C.byref(C.c_double(value)))
        elif isinstance(value, (list, tuple)):
            kind = C.c_int if all(isinstance(v, int) for v in value) and value else C.c_double
            given.append((kind * max(len(value), 1))(*value))
        elif isinstance(value, str):
            given.append(value.encode())
        else:
            given.append(value)
    getattr(LIB, name)(*given)


def reals(name, *arguments, count=1):
    out = [C.c_double() for _ in range(count)]
    call(name, *arguments, *[C.byref(value) for value in out])
    values = [value.value for value in out]
    return values[0] if count == 1 else values


def array(name, *arguments, length, kind=C.c_double):
    out = (kind * length)()
    call(name, *arguments, length, out)
    return list(out)


def flags(ire, icp, values):
    call("cntc_setflags", ire, icp, len(values), list(values), list(values.values()))


def begin(ire, module):
    version, error = C.c_int(), C.c_int(-1)
    call("cntc_initialize", ire, module, C.byref(version), C.byref(error), " ", 1)
    assert error.value == 0 and version.value > 0


def calculate(ire, icp=-1, name="cntc_calculate"):
    error = C.c_int(-999)
    call(name, ire, icp, C.byref(error))
    return error.value


def near(found, wanted, tolerance, what=""):
    assert abs(found - wanted) <= tolerance * abs(wanted), f"{what}: {found}, not {wanted}"


def sphere(ire, icp=1, units=CNTC, force=1000.0, mx=33, radius=50.0, tang=3):
    """Spheres of one material on MX by MX elements; lengths in the client's units."""
    length = 1.0 if units == CNTC else 1000.0
    stress = length**2
    flags(ire, icp, {UNITS: units, PVTIME: 2, TANG: tang, NORM: 1, FORCE: 0})
    call("cntc_setmaterialparameters", ire, icp, 0, 4, [NU, NU, G * stress, G * stress])
    call("cntc_setfrictionmethod", ire, icp, 0, 2, [MU, MU])
    call("cntc_setnormalforce", ire, icp, force)
    curvature = length / (2.0 * radius)
    call("cntc_sethertzcontact", ire, icp, -1, 5, [float(mx), float(mx), curvature, curvature, mx / (mx - 4.0)])
    call("cntc_setrollingstepsize", ire, icp, 0.0, 0.1 / length)
    call("cntc_setreferencevelocity", ire, icp, 10000.0 / length)


def hertz(force, radius=50.0):
    """Radius of the patch, largest pressure, approach of a sphere on a plane of one material."""
    modulus = E / (2 * (1 - NU**2))
    a = (0.75 * force * radius / modulus)**(1 / 3)
    return a, 1.5 * force / (math.pi * a * a), a * a / radius


def closed_forms():
    for ire, units, length in ((11, CNTC, 1.0), (12, SI, 1000.0), (13, SPCK, 1000.0)):
        begin(ire, 3)
        sphere(ire, units=units)
        body = -1.0 if units == SPCK else 1.0
        a, p0, approach = hertz(1000.0)
        call("cntc_setcreepages", ire, 1, 0.05, 0.0, 0.0)  # slides everywhere
        assert calculate(ire, 1) == 0
        near(reals("cntc_getmaximumpressure", ire, 1) / length**2, p0, 0.01, "p0")
        near(reals("cntc_getpenetration", ire, 1) * length, approach, 0.005, "approach")
        near(reals("cntc_getcontactpatchareas", ire, 1, count=3)[0] * length**2, math.pi * a * a, 0.03, "area")
        fn, fx, fy, mz = reals("cntc_getcontactforces", ire, 1, count=4)
        near(fn, 1000.0, 1e-6)
        near(fx, -body * MU * 1000.0, 1e-4, "sliding")
        assert abs(fy) < 1e-6 and abs(mz) < 1e-3
        # Kalker's coefficient C11 = 4.12 + 0.2 at nu = 0.28 (tables: 4.12 at 0.25, 4.78 at 0.5).
        call("cntc_setcreepages", ire, 1, 1e-7, 0.0, 0.0)
        assert calculate(ire, 1) == 0
        near(reals("cntc_getcontactforces", ire, 1, count=4)[1], -body * 4.19 * G * a * a * 1e-7, 0.05, "C11")
        lateral = reals_of_creepage(ire, 0.0, 1e-7)
        near(lateral, -body * 3.74 * G * a * a * 1e-7, 0.05, "C22")
        hertzian = array("cntc_gethertzcontact", ire, 1, length=10)
        near(hertzian[2] * length, a, 1e-6, "semi-axis")
        mx, my = C.c_int(), C.c_int()
        call("cntc_getnumelements", ire, 1, C.byref(mx), C.byref(my))
        assert (mx.value, my.value) == (33, 33)
        n = mx.value * my.value
        pn = array("cntc_getfielddata", ire, 1, 5, length=n)
        dx, dy = reals("cntc_getgriddiscretization", ire, 1, count=2)
        near(sum(pn) * dx * dy, 1000.0, 1e-6, "pressure over the elements")
        state = array("cntc_getelementdivision", ire, 1, length=n, kind=C.c_int)
        assert {s for s, p in zip(state, pn) if p > 0} <= {1, 2} and set(state) <= {0, 1, 2}
        for field in (1, 2, 3, 4, 7, 8, 9, 15, 16, 22, 23):
            assert all(map(math.isfinite, array("cntc_getfielddata", ire, 1, field, length=n))), field
        # Largest von Mises stress 0.62 p0 at a depth of 0.48 a (Johnson 1985, nu = 0.3).
        call("subs_addblock", ire, 1, 1, 9, 1, 1, 40, [0.0], [0.0], [0.02 * a * (k + 1) / length for k in range(40)])
        assert calculate(ire, 1, "subs_calculate") == 0
        values = (C.c_double * 80)()
        call("subs_getresults", ire, 1, 1, 40, 2, [3, 8], values)
        most = max(range(40), key=lambda k: values[40 + k])
        near(values[40 + most] / length**2, 0.62 * p0, 0.02, "von Mises")
        near(values[most] * length, 0.48 * a, 0.1, "its depth")
        call("cntc_finalize", ire)


def creep_curves():
    """A creepage after others, on few elements or many, gives the forces and fields of the first call of an element."""
    for mx in (15, 41):
        begin(14, 3)
        sphere(14, mx=mx)
        for k in range(5):
            reals_of_creepage(14, 1e-4 * k, 2e-4)
        fields = {}
        for ire in (14, 15):
            if ire == 15:
                begin(15, 3)
                sphere(15, mx=mx)
            call("cntc_setcreepages", ire, 1, 3e-4, -1e-4, 2e-4)
            assert calculate(ire, 1) == 0
            fields[ire] = [array("cntc_getfielddata", ire, 1, field, length=mx * mx) for field in (3, 4, 5, 7, 8, 15, 16)]
            fields[ire] += [reals("cntc_getcontactforces", ire, 1, count=4), array("cntc_getelementdivision", ire, 1, length=mx * mx, kind=C.c_int)]
        for after, first in zip(fields[14], fields[15]):
            scale = max(map(abs, first))
            assert max(abs(a - b) for a, b in zip(after, first)) <= 2e-4 * scale, (mx, after[:5], first[:5])
        call("cntc_finalize", 14)
        call("cntc_finalize", 15)


def few_elements():
    """Sums over few elements find what transforms find on the same elements of a larger potential contact area."""
    begin(17, 3)
    begin(18, 3)
    few, many, margin = 15, 31, 8
    for radius, (xi, eta) in ((50.0, (3e-4, -1e-4)), (80.0, (1e-4, 2e-4)), (80.0, (5e-2, 0.0))):
        for ire in (17, 18):
            sphere(ire, mx=few, radius=radius)
        mx, my, x, y, dx, dy = array("cntc_getpotcontact", 17, 1, length=6) if solved(17) else [0.0] * 6
        assert (mx, my) == (few, few)
        call("cntc_setpotcontact", 18, 1, 1, 6, [float(many), float(many), x - (margin + 0.5) * dx, y - (margin + 0.5) * dy, dx, dy])
        call("cntc_setundeformeddistc", 18, 1, 1, 6, [0.5 / radius, 0.0, 0.5 / radius, 0.0, 0.0, 0.0])
        for ire in (17, 18):
            call("cntc_setcreepages", ire, 1, xi, eta, 1e-4)
            assert calculate(ire, 1) == 0
        for field in (1, 3, 4, 5, 7, 8, 9, 15, 16):
            here, there = (array("cntc_getfielddata", ire, 1, field, length=n * n) for ire, n in ((17, few), (18, many)))
            inside = [there[(j + margin) * many + i + margin] for j in range(few) for i in range(few)]
            scale = max(map(abs, inside))
            assert max(abs(a - b) for a, b in zip(here, inside)) < 1e-4 * scale, (radius, xi, field)
        for a, b in zip(*(reals("cntc_getcontactforces", ire, 1, count=4) for ire in (17, 18))):
            assert abs(a - b) < 1e-2, (radius, xi, a, b)
        near(reals("cntc_getpenetration", 17, 1), reals("cntc_getpenetration", 18, 1), 1e-6, "approach")
    call("cntc_finalize", 17)
    call("cntc_finalize", 18)


def extra_slip():
    """A uniform extra slip is a creepage, in both directions of rolling; one that turns is spin, which the first-order
    difference takes a sixth of an element upstream."""
    for mx, method in ((15, 0), (41, 0), (41, 3)):  # sums, transforms and FASTSIM, whose spin has its own flexibility
        for chi in (0.0, math.pi):
            for xi, eta, phi in ((4e-4, -2e-4, 0.0), (4e-4, -2e-4, 3e-4))[:1 if method else 2]:
                begin(19, 3)
                sphere(19, mx=mx)
                flags(19, 1, {BOUND: 2 if method else 0})
                call("cntc_setmaterialparameters", 19, 1, method, 7, [NU, NU, G, G, 1.0, 1.0, 1.0])
                call("cntc_setrollingstepsize", 19, 1, chi, 0.1)
                call("cntc_setcreepages", 19, 1, xi, eta, phi)
                assert calculate(19, 1) == 0
                forces = reals("cntc_getcontactforces", 19, 1, count=4)
                _, _, x, y, dx, dy = array("cntc_getpotcontact", 19, 1, length=6)
                places = [(x + i * dx, y + j * dy) for j in range(mx) for i in range(mx)]
                slips = [xi - phi * v for _, v in places], [eta + phi * u for u, _ in places]
                call("cntc_setextrarigidslip", 19, 1, mx * mx, *slips)
                call("cntc_setcreepages", 19, 1, 0.0, 0.0, 0.0)
                assert calculate(19, 1) == 0
                allowed = (1e-6 if phi == 0.0 else 0.03 * dx) * MU * 1000.0
                for here, there in zip(forces, reals("cntc_getcontactforces", 19, 1, count=4)):
                    assert abs(here - there) < allowed, (mx, chi, phi, here, there)
                call("cntc_setextrarigidslip", 19, 1, 3, [0.0] * 3, [0.0] * 3)
                assert calculate(19, 1) != 0  # three values for all elements
                call("cntc_setextrarigidslip", 19, 1, 0, [], [])
                assert calculate(19, 1) == 0 and abs(reals("cntc_getcontactforces", 19, 1, count=4)[1]) < 1e-3
                call("cntc_finalize", 19)


def solved(ire):
    return calculate(ire, 1) == 0


def reals_of_creepage(ire, xi, eta):
    call("cntc_setcreepages", ire, 1, xi, eta, 0.0)
    assert calculate(ire, 1) == 0
    return reals("cntc_getcontactforces", ire, 1, count=4)[2]


def steps():
    """Cattaneo: a force grows in steps of a shift, each of which continues the one before."""
    begin(21, 3)
    sphere(21, tang=1)
    flags(21, 1, {FORCE: 2})
    a = hertz(1000.0)[0]
    whole = 0.0
    for number, share in enumerate((0.2, 0.4, 0.6, 0.8)):
        flags(21, 1, {PVTIME: 2 if number == 0 else 0})
        call("cntc_settangentialforces", 21, 1, -share, 0.0)
        assert calculate(21, 1) == 0
        whole += reals("cntc_getcreepages", 21, 1, count=3)[0]
        mindlin = 3 * MU * 1000.0 * (2 - NU) / (8 * G * a) * (1 - (1 - share)**(2 / 3))
        near(whole, mindlin, 0.01, f"Mindlin's shift at {share}")
    # From rest, rolling ends in the steady state (Kalker).
    sphere(21, mx=21)
    flags(21, 1, {FORCE: 0})
    call("cntc_setcreepages", 21, 1, 2e-4, 1e-4, 1e-4)
    assert calculate(21, 1) == 0
    steady = reals("cntc_getcontactforces", 21, 1, count=4)
    flags(21, 1, {TANG: 2})
    spacing = reals("cntc_getgriddiscretization", 21, 1, count=2)[0]
    call("cntc_setrollingstepsize", 21, 1, 0.0, spacing)
    for number in range(60):
        flags(21, 1, {PVTIME: 2 if number == 0 else 0})
        assert calculate(21, 1) == 0
    for found, wanted in zip(reals("cntc_getcontactforces", 21, 1, count=4), steady):
        near(found, wanted, 0.01, "after 60 steps of one element")
    # After steady rolling it stays as it is.
    for number, tang in enumerate((3, 2, 2, 2)):
        flags(21, 1, {TANG: tang})
        assert calculate(21, 1) == 0
        for found, wanted in zip(reals("cntc_getcontactforces", 21, 1, count=4), steady):
            near(found, wanted, 1e-4, f"step {number} after steady rolling")
    call("cntc_finalize", 21)


def heat_and_no_friction():
    """Like bodies have one temperature, above theirs where friction heats them."""
    begin(23, 3)
    sphere(23)
    steel = [20.0, 450.0, 0.05, 7.85e-6]
    call("cntc_settemperaturedata", 23, 1, 3, 9, steel + steel + [1.0])
    call("cntc_setcreepages", 23, 1, 0.02, 0.0, 0.0)
    assert calculate(23, 1) == 0
    first, second = reals("cntc_getmaximumtemperature", 23, 1, count=2)
    near(first, second, 1e-9)
    # A band of half width a under 8/9 of the mean flow of the disc: Jaeger's 2 q sqrt(t / pi) / beta, half into each.
    a, p0, _ = hertz(1000.0)
    flow = MU * 2 / 3 * p0 * 0.02 * 10000.0
    beta = math.sqrt(50.0 * 7850.0 * 450.0) * 1e-3
    near(first - 20.0, flow / beta * math.sqrt(2 * a / 10000.0 / math.pi), 0.4, "flash temperature")
    flags(23, 1, {TANG: 0})
    assert calculate(23, 1) == 0
    assert reals("cntc_getcontactforces", 23, 1, count=4)[1:] == [0.0, 0.0, 0.0]
    assert reals("cntc_getmaximumtraction", 23, 1) == 0.0
    call("cntc_finalize", 23)


def layer_that_yields():
    """Where it yields nothing slides, and tractions are the yield stress tau_c0 + k u*."""
    begin(24, 3)
    for hardening in (0.0, 2000.0, -500.0):
        sphere(24)
        call("cntc_setmaterialparameters", 24, 1, 4, 8, [NU, NU, G, G, G, 0.02, 100.0, hardening])
        call("cntc_setcreepages", 24, 1, 3e-3, 2e-3, 0.0)
        assert calculate(24, 1) == 0
        px, py, stress, ux, uy, sx = (array("cntc_getfielddata", 24, 1, field, length=33 * 33) for field in (3, 4, 11, 12, 13, 15))
        state = array("cntc_getelementdivision", 24, 1, length=33 * 33, kind=C.c_int)
        assert state.count(3) > 500 and state.count(2) > 50
        for e, of in enumerate(state):
            if of == 3:
                near(ux[e] * px[e] + uy[e] * py[e], math.hypot(ux[e], uy[e]) * stress[e], 1e-3, "along the traction")
                near(math.hypot(px[e], py[e]), stress[e], 1e-5, "traction")
                near(stress[e], 100.0 + hardening * math.hypot(ux[e], uy[e]), 0.005, "yield stress")
            assert of < 2 or (abs(sx[e]) > 1e-4) == (of == 2)
    call("cntc_finalize", 24)


def sensitivities():
    begin(22, 3)
    sphere(22)
    flags(22, 1, {SENS: 3})
    call("cntc_setcreepages", 22, 1, 1e-5, 0.0, 0.0)
    assert calculate(22, 1) == 0
    out = (C.c_double * 16)()
    call("cntc_getsensitivities", 22, 1, 4, 4, out)
    a, _, approach = hertz(1000.0)
    near(out[0], 1.5 * 1000.0 / approach, 0.02, "dFN/dPEN")
    near(out[4 + 1], -4.19 * G * a * a / (MU * 1000.0), 0.06, "dFX/dCKSI")
    call("cntc_finalize", 22)


def profiles():
    """(y, z) of the program's own wheel and rail."""
    made = []
    for name in ("S1002", "60E1"):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "profile", name, "-q", "-o", folder], check=True, capture_output=True)
            rows = (pathlib.Path(folder) / "profile.csv").read_text().splitlines()[2:]
        points = [tuple(map(float, row.split(",")[1:3])) for row in rows]
        made.append([points[0]] + [b for a, b in zip(points, points[1:]) if math.dist(a, b) > 1e-3])
    return made


def wheel_on_rail(ire, side, shift, wheel, rail, units=CNTC, rail_shift=0.0):
    """Numbers in the client's units."""
    m = 1.0 if units == CNTC else 1e-3
    begin(ire, 1)
    flags(ire, -1, {UNITS: units, CONFIG: side, TANG: 3, PVTIME: 2, NORM: 1, DISCNS: 2})
    call("cntc_setmaterialparameters", ire, -1, 0, 4, [NU, NU, G / m**2, G / m**2])
    call("cntc_setfrictionmethod", ire, -1, 0, 2, [MU, MU])
    call("cntc_setpotcontact", ire, -1, -1, 5, [0.5 * m, 0.5 * m, 1.57, 8.0 * m, 4.0 * m])
    call("cntc_setrollingstepsize", ire, -1, 0.0, 1.0)
    call("cntc_settrackdimensions", ire, 3, 11, [14.0 * m, 0.0, 1435.0 * m, 0.025, 0.0, rail_shift * m] + [0.0] * 5)
    call("cntc_setwheelsetdimensions", ire, 3, 3, [1360.0 * m, -70.0 * m, 460.0 * m])
    for kind, points in ((1, wheel), (0, rail)):
        values = [value for point in points for value in point]
        call("cntc_setprofileinputvalues", ire, len(points), values, 3, [kind, 0, 0], 2, [1.0, 0.0])
    call("cntc_setverticalforce", ire, 80000.0)
    sign = 1.0 if side == 1 else -1.0
    call("cntc_setwheelsetposition", ire, 2, 6, [0.0, sign * shift * m, 0.0, 0.0, sign * 0.002, 0.0])
    call("cntc_setwheelsetvelocity", ire, 2, 6, [2000.0 * m, 0.0, 0.0, 0.0, 0.0, -2000.0 / 460.0])
    assert calculate(ire) == 0
    return results_on_track(ire)


def results_on_track(ire):
    return array("cntc_getglobalforces", ire, -1, length=24), array("cntc_getcontactlocation", ire, 1, length=38)


def both_sides():
    wheel, rail = profiles()
    for shift in (0.0, 5.0):
        (left, at_left), (right, at_right) = (wheel_on_rail(31 + side, side, shift, wheel, rail) for side in (0, 1))
        near(left[2], 80000.0, 1e-4, "vertical force on the rail")
        # Mirror images: x and z agree, y and turns about x and z change their signs.
        for k, sign in enumerate((1, -1, 1, -1, 1, -1)):
            for first in (0, 6, 12, 18):
                scale = 80000.0 * (1.0 if k < 3 else 500.0)
                assert abs(left[first + k] - sign * right[first + k]) < 2e-4 * scale, (shift, first + k, left, right)
        for k, sign in enumerate((1, -1, 1, -1, 1, -1, 1)):
            assert abs(at_left[k] - sign * at_right[k]) < 1e-3, (shift, k, at_left, at_right)
        # The moment about the rail's marker is that of the force at the centre of the pressure.
        arm = (at_left[15] - at_left[25], at_left[2] - at_left[26])
        moment = arm[0] * left[2] - arm[1] * left[1]
        assert abs(moment - left[3]) < 0.01 * 80000.0, (moment, left[3])
    other_ways(wheel, rail)
    points = C.c_double()
    call("cntc_getprofilevalues", 31, 0, 2, [0, 0], 1, [1.0], 1, C.byref(points))
    assert points.value > 100
    for ire in (31, 32):
        call("cntc_finalize", ire)


def other_ways(wheel, rail):
    """The same contact by other functions: units, height instead of force, the rail moved instead of the wheel."""
    forces, place = wheel_on_rail(33, 1, 1.0, wheel, rail)
    for units, body in ((SI, 1.0), (SPCK, -1.0)):
        other, there = wheel_on_rail(34, 1, 1.0, wheel, rail, units=units)
        for k in range(24):
            near(other[k] * (1.0 if k % 6 < 3 else 1000.0) + 1.0, body * forces[k] + 1.0, 1e-6, f"force {k} in {units}")
        near(there[1] * 1000.0, place[1], 1e-9, "place")
        near(there[3], place[3], 1e-9, "angle")
    position = array("cntc_getwheelsetposition", 33, length=6)
    flags(33, -1, {NORM: 0})
    call("cntc_setwheelsetposition", 33, 2, 6, position)
    assert calculate(33) == 0
    by_height = array("cntc_getglobalforces", 33, -1, length=24)
    near(by_height[2], 80000.0, 1e-3, "force by height")
    call("cntc_setwheelsetposition", 33, 2, 6, position[:2] + [position[2] - 1.0] + position[3:])
    patches = C.c_int(-1)
    assert calculate(33) == 0
    call("cntc_getnumcontactpatches", 33, C.byref(patches))
    assert patches.value == 0 and array("cntc_getglobalforces", 33, -1, length=3) == [0.0] * 3, "above its rail"
    moved, _ = wheel_on_rail(35, 1, 0.0, wheel, rail, rail_shift=-1.0)
    for k in range(3):
        assert abs(moved[k] - forces[k]) < 20.0, ("the rail moved", moved[:3], forces[:3])
    # Friction over the inclination, the same everywhere.
    call("cntc_setfrictionmethod", 35, -1, 10, 7, [2.0, -0.3, MU, MU, 0.3, MU, MU])
    assert calculate(35) == 0
    assert abs(array("cntc_getglobalforces", 35, -1, length=3)[0] - moved[0]) < 1.0
    assert flag(35, TANG) == 3 and flag(35, 2005) == 2
    # A wheel that is moved back by itself.
    call("cntc_setwheelsetflexibility", 35, 4, 12, [0.0, -1.0] + [0.0] * 10)
    assert calculate(35) == 0
    back, _ = results_on_track(35)
    start, _ = wheel_on_rail(36, 1, 0.0, wheel, rail)
    assert abs(back[1] - wheel_on_rail(36, 1, -1.0, wheel, rail, rail_shift=-1.0)[0][1]) < 20.0 and start[2] > 0.0
    for ire in (33, 34, 35, 36):
        call("cntc_finalize", ire)


def flag(ire, code):
    values = (C.c_int * 1)()
    call("cntc_getflags", ire, -1, 1, [code], values)
    return values[0]


def threads():
    """The same table on an element of each thread."""
    found = {}

    def table(ire):
        begin(ire, 3)
        sphere(ire, mx=15)
        found[ire] = [reals_of_creepage(ire, 1e-4 * k, 2e-5 * k) for k in range(40)]
        call("cntc_finalize", ire)

    begin(40, 3)
    workers = [threading.Thread(target=table, args=(41 + k,)) for k in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(found) == 4 and all(values == found[41] for values in found.values())
    call("cntc_finalize", 40)


def bad_calls(log):
    error = C.c_int()
    call("cntc_calculate", 99, 1, C.byref(error))
    assert error.value == -31, "an unknown element"
    assert math.isnan(reals("cntc_getpenetration", 99, 1))
    begin(50, 3)
    assert calculate(50, 1) == -31, "an unknown problem"
    sphere(50)
    assert math.isnan(reals("cntc_getpenetration", 50, 1)), "not solved"
    call("cntc_setmaterialparameters", 50, 1, 1, 8, [NU, NU, G, G, 1.0, 1.0, 1.0, 1.0])
    assert calculate(50, 1) < 0, "viscoelastic"
    sphere(50)
    call("cntc_setmaterialparameters", 50, 1, 0, 2, [NU, NU])
    call("cntc_setfrictionmethod", 50, 1, 0, 2, None)
    call("cntc_setcreepages", 50, 1, None, 0.0, 0.0)
    call("cntc_setcreepages", None, 1, 0.0, 0.0, 0.0)
    call("cntc_sethertzcontact", 50, 1, -1, 5, [1e9, 3.0, 0.01, 0.01, 1.0])
    call("cntc_setundeformeddistc", 50, 1, 9, 4, [0.0, 0.0, 0.0, math.nan])
    call("cntc_setprofileinputfname", 50, "nothing.prw", 11, 1, [1], 1, [1.0])
    assert calculate(50, 1) == 0, "wrong settings change nothing"
    assert all(map(math.isnan, array("cntc_getfielddata", 50, 1, 5, length=10))), "too short"
    call("cntc_finalize", 50)
    call("cntc_finalize", 50)
    call("cntc_finalizelast")
    text = log.read_text()
    for words in ("no such result element", "viscoelastic", "is null", "values are given", "not finite", "the array has 10 values"):
        assert words in text, (words, text)


def fuzz(rounds):
    """Random functions with random numbers of the right kind and length; some pointers are null."""
    rng = random.Random(7)
    declared = re.findall(r"void (\w+)\((.*?)\);", HEADER.read_text(), re.S)
    small, words = [-7, -1, 0, 1, 2, 3, 4, 5, 9, 10, 33, 60], [1933, 1935, 1972, 1973, 1967, 1988, 2000, 3, 0]
    for _ in range(rounds):
        name, arguments = rng.choice(declared)
        given = []
        for argument in arguments.split(","):
            kind = argument.split()[-2].rstrip("*") if "*" in argument else "void"
            if rng.random() < 0.02 or kind == "void":
                given.append(None)
            elif kind == "int":
                among = words if argument.split()[-1] in ("params", "values") else small
                given.append((C.c_int * 4096)(*[rng.choice(among) for _ in range(64)]))
            elif kind == "double":
                numbers = [rng.choice((0.0, 1.0, 5.0, 0.3, -1.0, 1e3, 8e4, math.nan, 1e300, rng.random())) for _ in range(64)]
                given.append((C.c_double * 4096)(*numbers))
            else:
                given.append(C.create_string_buffer(b"no such file.prr", 64))
        getattr(LIB, name)(*given[:0 if arguments == "void" else None])
    call("cntc_finalizelast")


C_PROGRAM = r"""
#include <stdio.h>
#include "rollfem/contact_addon.h"

/* Elements begin, are solved and end, with bad calls between. Prints failures and the pressure. */
int main(void) {
  int icp = 1, module = 3, version, error, zero = 0, one = 1, two = 2, four = 4, five = 5, curvature = -1, failures = 0;
  int params[] = {1933, 1973}, values[] = {1934, 1}, unknown = 77, elements = 81;
  double material[] = {0.28, 0.28, 80468.75, 80468.75}, friction[] = {0.3, 0.3}, hertz[] = {9, 9, 0.01, 0.01, 1.3};
  double force = 1000, still = 0, speed = 1000, pressure = 0, field[81];
  for (int round = 0; round < 300; ++round) {
    int ire = 1 + round % 3;
    double slip = 1e-4 * (round % 11);
    cntc_initialize(&ire, &module, &version, &error, " ", &one);
    cntc_setflags(&ire, &icp, &two, params, values);
    cntc_setmaterialparameters(&ire, &icp, &zero, &four, material);
    cntc_setfrictionmethod(&ire, &icp, &zero, &two, friction);
    cntc_setreferencevelocity(&ire, &icp, &speed);
    hertz[2] = hertz[3] = 0.01 + 0.001 * (round % 7);
    cntc_sethertzcontact(&ire, &icp, &curvature, &five, hertz);
    cntc_setnormalforce(&ire, &icp, &force);
    cntc_setcreepages(&ire, &icp, &slip, &still, &still);
    cntc_calculate(&ire, &icp, &error);
    failures += error < 0;
    for (int code = 1; code < 24; ++code) cntc_getfielddata(&ire, &icp, &code, &elements, field);
    cntc_getmaximumpressure(&ire, &icp, round % 7 == 0 ? &pressure : field);
    cntc_calculate(&unknown, &icp, &error);
    cntc_getpenetration(&ire, NULL, field);
    if (round % 5 == 4) cntc_finalize(&ire);
  }
  printf("%d %.3f\n", failures, pressure);
  cntc_finalizelast();
  return 0;
}
"""
FORTRAN_PROGRAM = """
program client
  implicit none
  interface
    subroutine numbers(ire, icp, pnmax) bind(c, name="cntc_getmaximumpressure")
      integer, intent(in) :: ire, icp
      real(kind=8), intent(out) :: pnmax
    end subroutine
    subroutine finish() bind(c, name="cntc_finalizelast")
    end subroutine
  end interface
  real(kind=8) :: pressure
  pressure = 1d0
  call numbers(5, 1, pressure)
  print '(l1)', pressure /= pressure
  call finish()
end program
"""


def programs(work):
    """A program in C that makes 10 000 calls, without leaks, and one in Fortran that asks too early."""
    link = [f"-L{LIBRARY.parent}", f"-Wl,-rpath,{LIBRARY.parent}", "-lrollfem_addon"]
    for compiler, name, text in (("cc", "client.c", C_PROGRAM), ("gfortran", "client.f90", FORTRAN_PROGRAM)):
        if not shutil.which(compiler):
            print(f"{compiler}: not installed, skipped")
            continue
        (work / name).write_text(text)
        include = [f"-I{HEADER.parent.parent}"] if compiler == "cc" else []
        subprocess.run([compiler, "-o", "client", name, *include, *link], cwd=work, check=True)
        watch = ["valgrind", "-q", "--leak-check=full", "--show-leak-kinds=definite,indirect",
                 "--errors-for-leak-kinds=definite,indirect", "--error-exitcode=9"]
        watched = watch if compiler == "cc" and shutil.which("valgrind") else []
        done = subprocess.run([*watched, "./client"], cwd=work, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
        if compiler == "gfortran":
            assert done.stdout.strip() == "T", done.stdout
        else:
            failures, pressure = done.stdout.split()
            assert failures == "0"
            near(float(pressure), hertz(1000.0)[1], 0.05, "p0 in C, on 7 elements across")


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        work = pathlib.Path(folder)
        for test in (closed_forms, creep_curves, few_elements, extra_slip, steps, heat_and_no_friction, layer_that_yields, sensitivities, both_sides, threads):
            test()
            print(f"{test.__name__}: ok")
        bad_calls(work / "contact_addon.out")
        fuzz(int(sys.argv[4]) if len(sys.argv) > 4 else 2000)
        programs(work)
        os.chdir("/")


if __name__ == "__main__":
    main()
