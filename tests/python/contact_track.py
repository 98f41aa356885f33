#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""contact_track.py ROOT LIBRARY PROGRAM: wheels on rails by CONTACT's functions against the program's run of an input of
CONTACT with the same settings, left and right: profiles that vary, forces along and across, rails on springs, several
patches."""
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile

import contact_addon as addon
from contact_addon import CONFIG, DISCNS, FORCE, G, MU, NORM, NU, PVTIME, TANG, UNITS, call

INPUT = """ 1 MODULE
 {C}20{T}1{F}0  C-P-B-T-N-F-S
 0022033        V-L-D-C-M-Z-E
 0000321        H-G-I-A-O-W-R
 999 100 30 1 1e-5      MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 {mu} {mu}              FSTAT, FKIN
 {nu} {nu} {g} {g}      POISS 1,2, GG 1,2
 0.5 0.5 1.0 90d 8.0 4.0
 {track}
 '{rail}' 0 1.0 0.0
 0.0 0.0 0.0 0.0 0.0 0.0
 {springs}
 1360.0 -70.0 460.0
 '{wheel}' 0 1.0 0.0
 {position}
 {velocity}

"""
STEP = """ 1 MODULE
 {C}00{T}1{F}0
 0101002        V-L-D-C-M-Z-E
 0101321        H-G-I-A-O-W-R
 {position}
 {velocity}

"""
LOAD = 80000.0
HISTORY = 2e-5  # of the load, between the library's and the program's steps


def row(values):
    return " ".join(f"{value:.12g}" for value in values)


def profile_file(path, points):
    path.write_text("".join(f"{y:.9f},{z:.9f}\n" for y, z in points))


def slices(path, count, step, points_at, unit):
    """A list of `count` slices along the rail (mm) or around the wheel (rad), by cubic interpolation."""
    lines = [f"0.0 1.0 {unit}", f"{count}", "0 0 0", "1"]
    for k in range(count):
        at = (k - (count - 1) / 2) * step
        name = f"{path.stem}_{k}.csv"
        profile_file(path.with_name(name), points_at(at))
        lines.append(f"{at:.9f} '{name}'")
    path.write_text("\n".join(lines) + "\n")


def set_pair(ire, side, rail, wheel, force, springs, track):
    addon.begin(ire, 1)
    addon.flags(ire, -1, {UNITS: addon.CNTC, CONFIG: side, TANG: 3, PVTIME: 2, NORM: 1, DISCNS: 2, FORCE: force})
    call("cntc_setmaterialparameters", ire, -1, 0, 4, [NU, NU, G, G])
    call("cntc_setfrictionmethod", ire, -1, 0, 2, [MU, MU])
    call("cntc_setpotcontact", ire, -1, -1, 5, [0.5, 0.5, 1.57, 8.0, 4.0])
    call("cntc_setrollingstepsize", ire, -1, 0.0, 1.0)
    call("cntc_settrackdimensions", ire, 3, 11, track + [0.0] * 7)
    if springs:
        call("cntc_settrackdimensions", ire, 32, 4, list(springs))
    call("cntc_setwheelsetdimensions", ire, 3, 3, [1360.0, -70.0, 460.0])
    for kind, name in enumerate((str(rail), str(wheel))):
        call("cntc_setprofileinputfname", ire, name, len(name), 3, [kind, 0, 0], 2, [1.0, 0.0])


def solve_at(ire, position, velocity):
    """Forces of the patches, the most loaded first."""
    call("cntc_setwheelsetposition", ire, 2, 6, position)
    call("cntc_setverticalforce", ire, LOAD)
    call("cntc_setwheelsetvelocity", ire, 2, 6, velocity)
    error = addon.calculate(ire)
    assert error == 0, (error, ire, pathlib.Path("contact_addon.out").read_text())
    patches = addon.C.c_int()
    call("cntc_getnumcontactpatches", ire, addon.C.byref(patches))
    found = [addon.reals("cntc_getcontactforces", ire, icp, count=4) for icp in range(1, patches.value + 1)]
    return sorted(found, reverse=True)


def by_library(ire, side, rail, wheel, position, velocity, force, springs, track):
    set_pair(ire, side, rail, wheel, force, springs, track)
    return solve_at(ire, position, velocity)


def input_of(side, rail, wheel, position, velocity, force, springs, track, tang=3):
    return INPUT.format(C=side, T=tang, F=force, mu=MU, nu=NU, g=G, rail=rail.name, wheel=wheel.name, springs=row(springs),
                        track=row(track), position=row(position), velocity=row(velocity))


def by_program(work, *given):
    """Forces of the patches at each position, the most loaded first."""
    return run(work, input_of(*given))[1]


def run(work, text):
    """The same by the numbers of the positions, of an input."""
    source = work / "case.inp"
    source.write_text(text + " 0 MODULE\n")
    made = work / "converted"
    for folder in (made, work / "run"):
        shutil.rmtree(folder, ignore_errors=True)
    convert = [addon.PROGRAM, "convert", source, "-q", "-o", made]
    for command in (convert, [addon.PROGRAM, "run", made / "case.toml", "-q", "-o", work / "run", "--no-report"]):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
    positions = {}
    for model in json.loads((work / "run/summary.json").read_text())["models"]:
        place = model["place"]["position"] if "place" in model else 1
        for p in model["points"]:
            positions.setdefault(p.get("step") or place, []).append(
                [p["normal_force"], -p["longitudinal_force"], p["lateral_force"], p["spin_moment"]])
    return {k: sorted(forces, reverse=True) for k, forces in positions.items()}


def compare(work, what, rail, wheel, shift=0.0, force=0, last=-2000.0 / 460.0, springs=(), patches=1, place=0.0,
            track=(14.0, 0.0, 1435.0, 0.025)):
    """Both sides, mirrored: forces of the patches by the functions, by the input read whole, and by the program."""
    found = {}
    for side, sign in ((0, -1.0), (1, 1.0)):
        position = [place, sign * shift, LOAD, 0.0, sign * 0.001, 0.0]
        velocity = [2000.0, 0.0, 0.0, 0.0, 0.0, last]
        springs_here = [springs[0], sign * springs[1], *springs[2:]] if springs else ()
        given = (side, rail, wheel, position, velocity, force, springs_here, list(track))
        found[side] = by_library(61 + side, *given)
        wanted = by_program(work, *given)
        assert len(found[side]) == len(wanted) == patches, (what, side, found[side], wanted)
        for ours, theirs in zip(found[side], wanted):
            for a, b in zip(ours[:3], theirs):
                assert abs(a - b) < 2e-4 * LOAD, (what, side, ours, theirs)
        by_file(what, side, work, found[side])
        sums(what, 61 + side, patches)
    for left, right in zip(found[0], found[1]):
        for k, mirror in enumerate((1.0, 1.0, -1.0, -1.0)):
            assert abs(left[k] - mirror * right[k]) < 2e-4 * LOAD * (1.0 if k < 3 else 10.0), (what, left, right)
    return found[1]


def history(work, what, rail, wheel, moves, force=0, springs=(), start=2, follow=2, cells=1, track=(14.0, 0.0, 1435.0, 0.025),
            place=0.0, layer=()):
    """Steps that continue each other, both sides, mirrored, against the program's run of the same steps. `moves`: of each
    step, shift, yaw and the last of the velocities; `cells`: rolled in a step; `start`, `follow`: digits T; `place`: S of the
    first step; `layer`: GG3, LAYTHK, TAU_C0, K_TAU."""
    found = {}
    way = 0.5 * cells
    speed = way if follow == 1 else 2000.0  # in a shift the wheel moves by VS
    for side, sign in ((0, -1.0), (1, 1.0)):
        ire = 71 + side
        springs_here = [springs[0], sign * springs[1], *springs[2:]] if springs else ()
        set_pair(ire, side, rail, wheel, force, springs_here, list(track))
        call("cntc_setrollingstepsize", ire, -1, 0.0, float(cells))
        if layer:
            call("cntc_setmaterialparameters", ire, -1, 4, 8, [NU, NU, G, G, *layer])
        text, found[side] = "", []
        for k, (shift, yaw, last) in enumerate(moves):
            position = [place + way * k if follow == 1 else place, sign * shift, LOAD, 0.0, sign * yaw, 0.0]
            velocity = [speed, 0.0, 0.0, 0.0, 0.0, last if force else last * speed]
            digits = {TANG: start if k == 0 else follow, PVTIME: 2 if k == 0 else 0}
            addon.flags(ire, -1, digits)
            found[side].append(solve_at(ire, position, velocity))
            text += (input_of(side, rail, wheel, position, velocity, force, springs_here, track, start) if k == 0 else
                     STEP.format(C=side, T=follow, F=force, position=row(position), velocity=row(velocity)))
        text = text.replace("0.5 0.5 1.0 90d", f"0.5 0.5 {cells} 90d")
        if layer:
            text = text.replace("022033 ", "022433 ").replace("101002 ", "101402 ").replace("GG 1,2\n", f"GG 1,2\n {row(layer)}\n")
        wanted = run(work, text)
        assert len(wanted) == len(moves), (what, side, list(wanted))
        for k, ours in enumerate(found[side]):
            assert len(ours) == len(wanted[k + 1]), (what, side, k, ours, wanted[k + 1])
            for a, b in zip(sum((one[:3] for one in ours), []), sum((one[:3] for one in wanted[k + 1]), [])):
                assert abs(a - b) < HISTORY * LOAD, (what, side, k, ours, wanted[k + 1])
    for left, right in zip(found[0], found[1]):
        for ours, theirs in zip(left, right):
            for k, mirror in enumerate((1.0, 1.0, -1.0)):
                assert abs(ours[k] - mirror * theirs[k]) < 2e-4 * LOAD, (what, left, right)
    return found[1]


def by_file(what, side, work, found):
    error, name = addon.C.c_int(-1), str(work / "case.inp")
    addon.begin(65, 1)
    call("cntc_readinpfile", 65, 1988, name, len(name), addon.C.byref(error))
    assert error.value == 0 and addon.calculate(65) == 0, (what, side)
    forces = sorted((addon.reals("cntc_getcontactforces", 65, icp + 1, count=4) for icp in range(len(found))), reverse=True)
    for a, b in zip(sum(forces, []), sum(found, [])):
        assert abs(a - b) < 1e-6 * LOAD, (what, side, forces, found)
    call("cntc_finalize", 65)


def sums(what, ire, patches):
    """Forces and areas of the patches make those of the wheel."""
    parts = [addon.array("cntc_getglobalforces", ire, icp + 1, length=24) for icp in range(patches)]
    whole = addon.array("cntc_getglobalforces", ire, -1, length=24)
    for k in range(24):
        assert abs(sum(part[k] for part in parts) - whole[k]) < 1e-9 * LOAD * 1000.0, (what, k)
    assert abs(whole[2] - LOAD) < 2e-4 * LOAD, (what, whole[2])  # friction on a slope carries a part
    for icp in range(1, patches + 1):
        contact, adhesion, slip = addon.reals("cntc_getcontactpatchareas", ire, icp, count=3)
        assert contact > 0.0 and abs(adhesion + slip - contact) < 1e-9 * contact, (what, icp)
    assert math.isnan(addon.reals("cntc_getpenetration", ire, patches + 1)), (what, "a patch too many")


def along(points, y):
    """Length of the polyline from y = 0 to this y."""
    total = 0.0
    for (y0, z0), (y1, z1) in zip(points, points[1:]):
        piece = [min(max(edge, y0), y1) for edge in sorted((0.0, y))]
        if y1 > y0:
            total += math.dist((y0, z0), (y1, z1)) * (piece[1] - piece[0]) / (y1 - y0)
    return math.copysign(total, y)


def height(points, y):
    """z of a polyline, in either order of its points."""
    for (y0, z0), (y1, z1) in zip(points, points[1:]):
        if min(y0, y1) <= y <= max(y0, y1) and y0 != y1:
            return z0 + (z1 - z0) * (y - y0) / (y1 - y0)
    raise AssertionError(f"no point at {y}")


def profile_values(ire, at, side, wheel, rail):
    """Points, arc lengths and places of the profiles; `at`: where they touch."""
    assert abs(at[7] - along(rail, side * at[5])) < 0.02, (at[7], at[5])
    assert abs(at[12] + along(wheel, side * at[10])) < 0.02, (at[12], at[10])
    assert at[17:19] == [0.0, 0.0], "no springs, no deflection"
    for kind, given in ((0, rail), (1, wheel)):
        order = -1.0 if kind else 1.0
        asked = 2, [kind, 1], 4, [0.5, 0.0, 0.0, 0.0]
        count = int(addon.array("cntc_getprofilevalues", ire, 0, *asked, length=1)[0])
        both = addon.array("cntc_getprofilevalues", ire, 1, *asked, length=2 * count)
        points = list(zip(both[:count], both[count:]))
        arc, angle, placed = (addon.array("cntc_getprofilevalues", ire, task, *asked, length=n * count) for task, n in ((4, 1), (5, 1), (2, 2)))
        assert abs(arc[count // 2 + 1] - arc[count // 2] - 0.5) < 1e-9 and all(b > a for a, b in zip(arc, arc[1:]))
        for k in range(1, count - 1, 7):
            if abs(points[k][0]) < 30.0:
                assert abs(points[k][1] - height(given, points[k][0])) < 0.01, (kind, points[k])
                assert abs(arc[k] - order * along(given, points[k][0])) < 0.02, (kind, points[k], arc[k])
                slope = math.atan2(points[k + 1][1] - points[k - 1][1], points[k + 1][0] - points[k - 1][0])
                assert abs(math.remainder(slope - angle[k], 2 * math.pi)) < 0.02, (kind, points[k], angle[k])
        on_track = list(zip(placed[:count], placed[count:]))
        assert abs(height(on_track, at[1]) - at[2]) < 0.15, ("where they touch", kind, at[1:3])
    y, z, aside, down, face, deep = addon.array("cntc_getprofilevalues", ire, 3, 1, [0], 1, [1.0], length=6)
    assert abs(side * y + aside - side * 717.5) < 0.005 and abs(deep + down - 14.0) < 1e-6 and z <= deep + 1e-6 and face >= y - 1e-6
    assert abs(at[26] - down) < 1e-6 and abs(at[25] - aside) < 1e-6, "the rail's marker"
    assert math.isnan(addon.array("cntc_getprofilevalues", ire, 3, 1, [1], 1, [1.0], length=6)[1]), "a wheel has no gauge point"
    assert math.isnan(addon.array("cntc_getprofilevalues", ire, 8, 1, [0], 1, [1.0], length=6)[1]), "one section has no way"


def located(rail_points, wheel_points):
    """After `compare`, which has solved elements 61 and 62."""
    for ire, side in ((61, -1.0), (62, 1.0)):
        profile_values(ire, addon.array("cntc_getcontactlocation", ire, 1, length=38), side, wheel_points, rail_points)


def slipping(rail, wheel):
    """A uniform extra slip is the creepage of another rotation and lateral velocity, but for the spin of that rotation."""
    for side, sign in ((0, -1.0), (1, 1.0)):
        ire, turning = 68 + side, -2000.0 / 460.0
        set_pair(ire, side, rail, wheel, 0, (), [14.0, 0.0, 1435.0, 0.025])
        at = [0.0, sign * 2.0, LOAD, 0.0, sign * 0.001, 0.0]
        ways = []
        for rotation, aside in ((turning * 1.0005, sign * 1.0), (turning, 0.0)):
            forces = solve_at(ire, at, [2000.0, aside, 0.0, 0.0, 0.0, rotation])[0]
            ways.append((forces, addon.reals("cntc_getcreepages", ire, 1, count=3)))
        (wanted, turned), (plain, straight) = ways
        mx, my = addon.C.c_int(), addon.C.c_int()
        call("cntc_getnumelements", ire, 1, addon.C.byref(mx), addon.C.byref(my))
        count = mx.value * my.value
        call("cntc_setextrarigidslip", ire, 1, count, [turned[0] - straight[0]] * count, [turned[1] - straight[1]] * count)
        assert addon.calculate(ire) == 0
        found = addon.reals("cntc_getcontactforces", ire, 1, count=4)
        assert min(abs(wanted[k] - plain[k]) for k in (1, 2)) > 0.02 * LOAD, (wanted, plain)
        for a, b in zip(found[:3], wanted):
            assert abs(a - b) < 1e-3 * LOAD, (side, found, wanted, plain)
        addon.flags(ire, -1, {DISCNS: 3})
        assert addon.calculate(ire) < 0, "D = 3"


def deflected(stiffness, force):
    """k d = F + F0 of the rail, to the right."""
    for ire, side in ((61, -1.0), (62, 1.0)):
        d = addon.array("cntc_getcontactlocation", ire, 1, length=38)[17]
        on_rail = addon.array("cntc_getglobalforces", ire, -1, length=24)[1]
        assert abs(stiffness * d - on_rail - side * force) < 2e-3 * LOAD, (ire, d, on_rail)


def along_the_way(ire, kind, y, step, points, rise):
    """A profile at one y, through its sections."""
    asked = 8, 2, [kind, 1], 2, [step, y]
    count = int(addon.array("cntc_getprofilevalues", ire, *asked, length=1)[0])
    values = addon.array("cntc_getprofilevalues", ire, *asked, length=3 * count)
    assert count > 3 and values[count:2 * count] == [y] * count
    for x, z in zip(values[:count], values[2 * count:]):
        assert abs(z - height(points, y) - rise * x * x) < 0.05, (x, z)


def histories(work, rail, wheel, rail_points):
    free, count = -1.0 / 460.0, 5
    moving = [(2.0 + 0.01 * k, 0.001 + 1e-4 * k, free * (1.0 + 1e-4 * k)) for k in range(count)]
    steps = history(work, "T = 2 from rest", rail, wheel, moving)
    started = history(work, "T = 2 after T = 3", rail, wheel, moving, start=3)
    assert abs(steps[1][0][1] - started[1][0][1]) > 0.001 * LOAD, "the steady past has no effect"
    history(work, "T = 1", rail, wheel, moving, start=1, follow=1)
    history(work, "in half an element", rail, wheel, moving, cells=0.5)
    # The same force in each step takes more and more creepage.
    pulled = history(work, "F = 1", rail, wheel, [(2.0, 0.001, 5000.0)] * count, force=1)
    for step in pulled:
        assert abs(step[0][1] - 5000.0) < 10.0, pulled
    history(work, "F = 3", rail, wheel, moving[:3], force=3, springs=(2e4, 1000.0, 1e5, 0.0))
    history(work, "two patches", rail, wheel, [(6.2 + 1e-3 * k, 0.001, free) for k in range(3)], track=(14.0, 0.0, 1435.0, 0.05))
    # What a layer has yielded goes with the material; the rail changes from step to step.
    history(work, "layer", rail, wheel, moving, layer=(1000.0, 0.01, 150.0, 3000.0))
    slices(work / "low.slcs", 5, 100.0, lambda at: [(y, z + 1e-4 * at * at) for y, z in rail_points], "U_OFFSET")
    history(work, "slices", work / "low.slcs", wheel, moving, follow=1, start=1, cells=4, place=50.0, track=(-1.0, 753.0, 0.0, 0.025))
    lifted(rail, wheel)
    endless(work, rail, wheel)


def lifted(rail, wheel):
    """A wheel that leaves its rail in a step forgets what it has left there."""
    for side, sign in ((0, -1.0), (1, 1.0)):
        set_pair(74 + side, side, rail, wheel, 0, (), [14.0, 0.0, 1435.0, 0.025])
        at = [0.0, sign * 2.0, LOAD, 0.0, sign * 0.001, 0.0], [2000.0, 0.0, 0.0, 0.0, 0.0, -2000.0 / 460.0]
        solve_at(74 + side, *at)
        down = addon.array("cntc_getwheelsetposition", 74 + side, length=6)
        up = down[:2] + [down[2] - 1.0] + down[3:]
        forces = []
        for number, position in enumerate((down, down, up, down, down)):
            addon.flags(74 + side, -1, {TANG: 2, NORM: 0, PVTIME: 2 if number == 0 else 0})
            call("cntc_setwheelsetposition", 74 + side, 2, 6, position)
            assert addon.calculate(74 + side) == 0
            forces.append(addon.array("cntc_getglobalforces", 74 + side, -1, length=3))
        assert forces[2] == [0.0] * 3 and abs(forces[1][0]) > 1.5 * abs(forces[0][0]), forces
        for before, after in ((0, 3), (1, 4)):
            for a, b in zip(forces[before], forces[after]):
                assert abs(a - b) < 1e-6 * LOAD, (side, forces)


def endless(work, rail, wheel):
    """Steady rolling stays steady in equal steps; what cannot be continued is refused and changes nothing."""
    set_pair(73, 1, rail, wheel, 0, (), [14.0, 0.0, 1435.0, 0.025])
    at = [0.0, 2.0, LOAD, 0.0, 0.001, 0.0], [2000.0, 0.0, 0.0, 0.0, 0.0, -2000.0 / 460.0]
    call("cntc_setrollingstepsize", 73, -1, 0.0, 1.0)
    steady = solve_at(73, *at)[0]
    addon.flags(73, -1, {TANG: 2, PVTIME: 0})
    for k in range(5):
        last = solve_at(73, *at)[0]
    for a, b in zip(last[:3], steady[:3]):
        assert abs(a - b) < 2e-5 * LOAD, ("steady rolling does not stay steady", last, steady)
    # The same by the height to which the load has led.
    position = addon.array("cntc_getwheelsetposition", 73, length=6)
    addon.flags(73, -1, {NORM: 0})
    call("cntc_setwheelsetposition", 73, 2, 6, position)
    assert addon.calculate(73) == 0
    for a, b in zip(addon.reals("cntc_getcontactforces", 73, 1, count=4)[:3], steady):
        assert abs(a - b) < 2e-3 * LOAD, ("by the height", a, b)
    call("cntc_setmaterialparameters", 73, -1, 0, 4, [NU, NU, 0.5 * G, G])
    assert addon.calculate(73) < 0, "other materials continue nothing"
    call("cntc_setmaterialparameters", 73, -1, 0, 4, [NU, NU, G, G])
    assert addon.calculate(73) == 0


def main():
    wheel_points, rail_points = addon.profiles()
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        os.chdir(work)
        rail, wheel = work / "rail.csv", work / "wheel.csv"
        profile_file(rail, rail_points)
        profile_file(wheel, wheel_points)
        plain = compare(work, "plain", rail, wheel, 2.0)[0]
        located(rail_points, wheel_points)
        slipping(rail, wheel)
        # Forces: along on the rail, a torque about the axle, rails on springs.
        pulled = compare(work, "F = 1", rail, wheel, 2.0, force=1, last=5000.0)[0]
        assert abs(pulled[1] - 5000.0) < 50.0, pulled
        turned = compare(work, "F = 2", rail, wheel, 2.0, force=2, last=5000.0 * 460.0)[0]
        assert abs(turned[1] - pulled[1]) < 200.0, (turned, pulled)
        sprung = compare(work, "F = 3", rail, wheel, 2.0, force=3, springs=(2e4, 1000.0, 1e5, 0.0))[0]
        assert abs(sprung[2] - plain[2]) > 20.0, (sprung, plain)
        deflected(2e4, 1000.0)
        # Without a gauge: a rail that rises along the way, a wheel with a flat.
        fixed = (-1.0, 753.0, 0.0, 0.025)
        slices(work / "dip.slcs", 5, 100.0, lambda at: [(y, z + 1e-5 * at * at) for y, z in rail_points], "U_OFFSET")
        risen = compare(work, "rail slices", work / "dip.slcs", wheel, 2.0, place=50.0, track=fixed)[0]
        assert abs(risen[0] - plain[0]) < 0.05 * LOAD
        along_the_way(62, 0, 3.0, 50.0, rail_points, 1e-5)
        slices(work / "flat.slcw", 5, 0.1, lambda at: [(y, z + 0.1 * at * at) for y, z in wheel_points], "TH_OFFSET")
        compare(work, "wheel slices", rail, work / "flat.slcw", 2.0, track=fixed)
        along_the_way(62, 1, 3.0, 0.05, wheel_points, 0.1)
        compare(work, "two patches", rail, wheel, 6.2, patches=2, track=(14.0, 0.0, 1435.0, 0.05))
        histories(work, rail, wheel, rail_points)
        print("plain, F = 1 to 3, slices, two patches: ok")


if __name__ == "__main__":
    main()
