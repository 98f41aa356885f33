#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""contact_clients.py ROOT LIBRARY CLIENT: runs a client of CONTACT's library on rollfem's and compares with the output
of CONTACT that lies beside it. CLIENT: test_caddon or test_mbench (Fortran), python_mbench or python_tractcurv (Python).

The clients are not in the repository: they lie in the folder contact_library of $ROLLFEM_REFERENCE, or of
../shared/reference beside the repository; without them, or without gfortran for those in Fortran, status 77."""

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
    for number, (ours, theirs) in enumerate(zip(found, wanted), 1):
        for name, a, b in zip(("first", "second", "third"), ours, theirs):
            if abs(a - b) / load > worst.get(name, (0.0,))[0]:
                worst[name] = (abs(a - b) / load, number)
    print(worst)
    return {name: value for name, (value, _) in worst.items()}, {name: 0.0125 for name in worst}


def main():
    if not GIVEN.is_dir():
        skip(f"{GIVEN} is not there")
    with tempfile.TemporaryDirectory() as folder:
        worst, limits = (python if CLIENT.startswith("python") else fortran)(pathlib.Path(folder)) or ({}, {})
    for name, value in sorted(worst.items()):
        print(f"{name}: {100 * value:.3f} %")
    wrong = [name for name, value in worst.items() if value > limits[name]]
    sys.exit(f"differ by more: {', '.join(wrong)}" if wrong else 0)


main()
