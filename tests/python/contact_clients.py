#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""contact_clients.py ROOT LIBRARY CLIENT: runs a client of CONTACT's library on rollfem's and compares with the output
of CONTACT that lies beside it. CLIENT: test_caddon or test_mbench (Fortran), python_mbench or python_tractcurv (Python), or
inputs: CONTACT's own inputs, read whole; steps: those of wheels in time, step by step.

The clients are not in the repository: they lie in the folder contact_library of $ROLLFEM_REFERENCE, or of
../shared/reference beside the repository; without them, or without gfortran for those in Fortran, status 77."""

import ctypes
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT, LIBRARY, CLIENT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
REFERENCE = pathlib.Path(os.environ.get("ROLLFEM_REFERENCE") or ROOT.parent / "shared/reference")
GIVEN = REFERENCE / "contact_library"
NAMES = {"python_mbench": ("Fx", "Fy", "Fz"), "python_tractcurv": ("Fn", "Fx", "Fy")}
PROFILES = ["MBench_UIC60_v3.prr", "MBench_S1002_v3.prw"]
# Of the examples, which an older version of the package had.
OLDER = """
import ctypes, sys
import python_intfc as cntc
_last = {}
def _materials(ire, icp, g1, nu1, g2, nu2):
    _last[ire] = [nu1, nu2, float(g1), float(g2)]
    cntc.setmaterialparameters(ire, icp, 0, list(_last[ire]))
cntc.setmaterialproperties = _materials
cntc.setinterfaciallayer = lambda ire, icp, m, given: cntc.setmaterialparameters(ire, icp, m, _last[ire] + list(given))
forces = {"getcontactforces": [], "getglobalforces": []}
def _recorded(name, function):
    def call(*arguments):
        values = function(*arguments)
        forces[name].append([float(value) for value in values])
        return values
    return call
for name in forces:
    setattr(cntc, name, _recorded(name, getattr(cntc, name)))
import runpy
runpy.run_path(sys.argv[1])
import json
json.dump(forces, open("forces.json", "w"))
"""


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def numbers(text):
    """(name, value) for each `name= value` but the times."""
    lines = [line for line in text.splitlines() if "CPU=" not in line]
    return [(name, float(value)) for name, value in re.findall(r"(\w+)\s*=\s*(-?\d+\.\d+)", "\n".join(lines))]


def fortran(work):
    if not shutil.which("gfortran"):
        skip("gfortran is not installed")
    interface = [re.sub(r"CNAME_\((\w+)\)", r'"\1"', line) for line in (GIVEN / "clients/contact_addon.ifc").read_text()
                 .splitlines() if not line.startswith("#define")]
    (work / "contact_addon.ifc").write_text("\n".join(interface) + "\n")
    shutil.copy(GIVEN / "clients/caddon_flags.inc", work)
    shutil.copy(GIVEN / f"clients/{CLIENT}.f90", work / f"{CLIENT}.F90")
    subprocess.run(["gfortran", "-w", "-ffree-line-length-none", "-o", CLIENT, f"{CLIENT}.F90", f"-L{LIBRARY.parent}",
                    f"-Wl,-rpath,{LIBRARY.parent}", "-lrollfem_addon"], cwd=work, check=True)
    (work / "profiles").mkdir()
    for name in PROFILES:
        shutil.copy(REFERENCE / name, work / "profiles")
    out = subprocess.run([work / CLIENT], cwd=work, check=True, capture_output=True, text=True).stdout
    found, wanted = numbers(out), numbers((GIVEN / f"clients/{CLIENT}.ref_out").read_text())
    assert [name for name, _ in found] == [name for name, _ in wanted], "other lines are printed"
    load = max(value for name, value in wanted if name in ("Tn", "Fz"))
    worst = {}
    for (name, ours), (_, theirs) in zip(found, wanted):
        size = load if name in ("Fx", "Fy", "Fz", "Tn") else abs(theirs) or 1.0
        # Micro-slip is that of one element at the edge of the patch.
        if abs(ours - theirs) > 0.6e-1 and name not in ("Sx", "Sy") or name in ("C", "H", "S", "Pen"):
            worst[name] = max(worst.get(name, 0.0), abs(ours - theirs) / size)
    return worst, {name: 0.02 for name in worst}


def miniprof(source, target):
    """The rail in MiniProf's format, for a rail that the client mirrors."""
    body = source.read_text().split("point.begin")[1].split("point.end")[0]
    points = [line.split()[:2] for line in body.splitlines() if line.strip() and not line.strip().startswith("!")]
    rows = [f"{-float(y):.6f} {-float(z):.6f}" for y, z in reversed(points)]
    target.write_text("ProgramName=test\nColumnDef=X,Y\nXOffset=0\n\n" + "\n".join(rows) + "\n")


def python(work):
    shutil.copytree(GIVEN / "python_intfc", work / "python_intfc")
    (work / "bin").mkdir()
    (work / "bin/contact_addon_linux64.so").symlink_to(LIBRARY)
    for name in PROFILES:
        shutil.copy(REFERENCE / name, work)
    miniprof(REFERENCE / PROFILES[0], work / "MBench_UIC60_v3.ban")
    (work / "older.py").write_text(OLDER)
    environment = {**os.environ, "CONTACTDIR": str(work), "LD_LIBRARY_PATH": str(work / "bin"), "MPLBACKEND": "Agg",
                   "PYTHONPATH": str(work)}
    out = subprocess.run([sys.executable, "older.py", GIVEN / f"examples/{CLIENT}.py"], cwd=work, env=environment,
                         capture_output=True, text=True)
    log = work / "contact_addon.out"
    assert out.returncode == 0 and "Done" in out.stdout, out.stdout + out.stderr
    assert not log.exists(), log.read_text()
    forces = json.loads((work / "forces.json").read_text())
    if CLIENT == "python_mbench":
        text = (GIVEN / "clients/test_mbench.ref_out").read_text()
        rows = [[float(x) for x in re.findall(r"=\s*(-?[\d.]+)", line)] for line in text.splitlines() if "Total" in line]
        wanted, found = rows[::2] + rows[1::2], forces["getglobalforces"]
        load = 10000.0
    else:
        text = (REFERENCE / "contact_examples/tractcurv.ref_out").read_text()
        wanted = [[float(x) for x in row.split()[:3]] for row in re.findall(r"ELAST.EN.   FRIC.POWER\n(.*)\n", text)]
        found, load = forces["getcontactforces"], 106700.0
    assert len(found) == len(wanted), f"{len(found)} cases, not {len(wanted)}"
    worst = {}
    for ours, theirs in zip(found, wanted):
        for name, a, b in zip(NAMES[CLIENT], ours, theirs):
            worst[name] = max(worst.get(name, 0.0), abs(a - b) / load)
    # One position of the benchmark, where the curvature of the rail jumps, is 1.2 % off (docs/contact_library.md).
    return worst, {name: 0.0125 if CLIENT == "python_mbench" else 0.002 for name in worst}


# Inputs whose last case continues no other, and the error of theirs in FX and FY (docs/coming_from_contact.md).
INPUTS = {"contact_examples/bentall": 0.001, "contact_examples/carter2d": 0.001, "contact_examples/ertz_temperature": 0.002,
          "contact_testbank/contact_nonhz": 0.002, "contact_examples/tractcurv": 0.003,
          "contact_examples/mbench_a22_left": 0.004, "contact_testbank/dry_10mph_13750lbs": 0.004}


def inputs(work):
    """Forces, approach and, but for FASTSIM, whose bound is another one, pressures of the last case."""
    library = ctypes.CDLL(str(LIBRARY))
    whole, real = (lambda v: ctypes.byref(ctypes.c_int(v))), ctypes.c_double
    worst = {}
    for number, (name, limit) in enumerate(INPUTS.items(), 1):
        file = REFERENCE / f"{name}.inp"
        text = file.with_suffix(".ref_out").read_text(errors="replace")
        if "mbench" in name:  # its profiles lie elsewhere
            for needed in (file, *(REFERENCE / profile for profile in PROFILES)):
                shutil.copy(needed, work)
            file = work / file.name
        module = 1 if "WHEEL-R" in text else 3
        error = ctypes.c_int(-1)
        library.cntc_initialize(whole(number), whole(module), whole(0), ctypes.byref(error), b" ", whole(1))
        library.cntc_readinpfile(whole(number), whole(1988), str(file).encode(), whole(len(str(file))), ctypes.byref(error))
        assert error.value == 0, name
        library.cntc_calculate(whole(number), whole(-1 if module == 1 else 1), ctypes.byref(error))
        assert error.value >= 0, f"{name}: {error.value}"
        rows = re.findall(r"ELAST.EN.   FRIC.POWER.*\n(.*)\n.*\n(.*)\n", text[text.rfind("Case "):])
        wanted = [float(x) for x in rows[0][0].split()[:4]]
        approach = float(rows[0][1].split()[3])
        forces = [real() for _ in range(4)]
        library.cntc_getcontactforces(whole(number), whole(1), *[ctypes.byref(value) for value in forces])
        depth = real()
        library.cntc_getpenetration(whole(number), whole(1), ctypes.byref(depth))
        off = max(abs(a.value - b) for a, b in zip(forces[:3], wanted)) / wanted[0]
        worst[name] = max(off, abs(depth.value / approach - 1.0) / 5.0) / limit
    return worst, {name: 1.0 for name in worst}


# CONTACT's steps of wheels in time, with the largest difference of FX and FY from its output over FN.
STEPS = {"m1_catt_shift": 0.016, "m1_trans_roll": 0.0015, "m1_totforce": 0.0015}


def steps(work):
    """The first case from a file, the others by their positions, velocities and P = 0."""
    library = ctypes.CDLL(str(LIBRARY))
    whole, real = (lambda v: ctypes.byref(ctypes.c_int(v))), ctypes.c_double
    many = lambda line: (real * 6)(*[float(word) for word in line.split()[:6]])
    (work / "inputs").mkdir()
    shutil.copytree(REFERENCE / "contact_testbank/profiles", work / "profiles")
    worst = {}
    for number, name in enumerate(STEPS, 1):
        text = (REFERENCE / f"contact_testbank/{name}.inp").read_text()
        head, first, *later = text.split("  1 MODULE\n")
        file = work / f"inputs/{name}.inp"
        file.write_text(f"{head}  1 MODULE\n{first}\n 0 MODULE\n")
        error, wanted = ctypes.c_int(-1), []
        out = (REFERENCE / f"contact_testbank/{name}.ref_out").read_text(errors="replace")
        for row in re.findall(r"ELAST.EN.   FRIC.POWER.*\n(.*)\n", out):
            wanted.append([float(word) for word in row.split()[:3]])
        library.cntc_initialize(whole(number), whole(1), whole(0), ctypes.byref(error), b" ", whole(1))
        library.cntc_readinpfile(whole(number), whole(1988), str(file).encode(), whole(len(str(file))), ctypes.byref(error))
        assert error.value == 0 and len(wanted) == 1 + len(later), (name, error.value, len(wanted))
        off = 0.0
        for k, theirs in enumerate(wanted):
            if k > 0:
                position, velocity = [row for row in later[k - 1].splitlines() if row.strip() and row[0] != "%"][3:5]
                library.cntc_setflags(whole(number), whole(-1), whole(1), whole(1970), whole(0))
                library.cntc_setwheelsetposition(whole(number), whole(2), whole(6), many(position))
                if name == "m1_totforce":
                    library.cntc_setverticalforce(whole(number), ctypes.byref(real(many(position)[2])))
                library.cntc_setwheelsetvelocity(whole(number), whole(2), whole(6), many(velocity))
            library.cntc_calculate(whole(number), whole(-1), ctypes.byref(error))
            assert error.value == 0, (name, k, error.value)
            forces = [real() for _ in range(4)]
            library.cntc_getcontactforces(whole(number), whole(1), *[ctypes.byref(value) for value in forces])
            off = max(off, *(abs(a.value - b) / theirs[0] for a, b in zip(forces[:3], theirs)))
        worst[name] = off
    return worst, STEPS


def main():
    if not GIVEN.is_dir():
        skip(f"{GIVEN} is not there")
    client = {"inputs": inputs, "steps": steps}.get(CLIENT) or (python if CLIENT.startswith("python") else fortran)
    with tempfile.TemporaryDirectory() as folder:
        worst, limits = client(pathlib.Path(folder))
    for name, value in sorted(worst.items()):
        print(f"{name}: {100 * value:.3f} %")
    wrong = [name for name, value in worst.items() if value > limits[name]]
    sys.exit(f"differ by more: {', '.join(wrong)}" if wrong else 0)


main()
