# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pip and python3 -m build call (PEP 517): builds by CMake and packs what `cmake --install` writes into a wheel.

The wheel keeps the installed tree: program, libraries and cases go to the prefix of the environment, the Python package
to its site-packages. It needs nothing beyond Python itself, so that pip works without a network.

Environment: ROLLFEM_FEM=ON|OFF with or without finite elements (default: where deal.II is found), ROLLFEM_JOBS=N compile
N files at once, ROLLFEM_BUILD=FOLDER pack that finished build instead of making one in build-pip/."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
VERSION = re.search(r"^project\(rollfem VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
NAME = f"rollfem-{VERSION}"
INFO = f"{NAME}.dist-info"
TAG = "cp{0.major}{0.minor}-cp{0.major}{0.minor}-{1}".format(sys.version_info, re.sub(r"\W", "_", sysconfig.get_platform()))
# What compiles others' programs: its symbolic links have no place in a wheel.
DEVELOPER = re.compile(r"include/|lib\w*/(.*/)?(cmake|pkgconfig)/|.*/installed\.txt$|lib\w*/.*\.so(\.\d+\.\d+\.\d+)?$")


def call(*command):
    try:
        subprocess.run(command, cwd=ROOT, check=True)
    except FileNotFoundError:
        sys.exit(f"{command[0]} is not installed; do: apt install cmake ninja-build (docs/install.md names all packages)")
    except subprocess.CalledProcessError as error:
        sys.exit(f"{' '.join(map(str, command))} failed with status {error.returncode}")


def jobs():
    """As many as cores and memory allow: a file of finite elements takes some 2.5 GB to compile."""
    kilobytes = int(re.search(r"MemAvailable:\s+(\d+)", pathlib.Path("/proc/meminfo").read_text())[1])
    return os.environ.get("ROLLFEM_JOBS") or str(max(1, min(len(os.sched_getaffinity(0)), kilobytes // 2_500_000)))


def built():
    """The folder of a finished build for this Python."""
    given = os.environ.get("ROLLFEM_BUILD")
    if given:
        return pathlib.Path(given).resolve()
    build = ROOT / "build-pip"
    call("cmake", "--preset", "package", "-B", build, f"-DPython_EXECUTABLE={sys.executable}",
         f"-DROLLFEM_FEM={os.environ.get('ROLLFEM_FEM', 'AUTO')}")
    call("cmake", "--build", build, "--parallel", jobs())
    return build


def metadata():
    lines = ["Metadata-Version: 2.1", "Name: rollfem", f"Version: {VERSION}", f"Summary: {PROJECT['description']}",
             f"License: {PROJECT['license']['text']}", f"Author: {PROJECT['authors'][0]['name']}",
             f"Keywords: {','.join(PROJECT['keywords'])}", f"Requires-Python: {PROJECT['requires-python']}",
             *(f"Requires-Dist: {name}" for name in PROJECT["dependencies"]),
             *(f"Classifier: {name}" for name in PROJECT["classifiers"]), "Description-Content-Type: text/markdown"]
    return "\n".join(lines) + "\n\n" + (ROOT / PROJECT["readme"]).read_text(encoding="utf-8")


def described():
    """Names in the wheel and texts that say what it is."""
    return {f"{INFO}/METADATA": metadata(),
            f"{INFO}/WHEEL": f"Wheel-Version: 1.0\nGenerator: rollfem\nRoot-Is-Purelib: false\nTag: {TAG}\n",
            f"{INFO}/LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8")}


def packed(stage):
    """(name in the wheel, file) of everything installed in `stage`."""
    core = next(stage.rglob(f"rollfem/_core{sysconfig.get_config_var('EXT_SUFFIX')}"), None)
    if core is None:
        sys.exit("the build has no module for this Python; do: remove its folder, or build with ROLLFEM_PYTHON=ON")
    packages = core.parent.parent
    for path in sorted(stage.rglob("*")):
        name = path.relative_to(stage).as_posix()
        if path.is_relative_to(packages) and path.is_file():
            yield path.relative_to(packages).as_posix(), path
        elif path.is_file() and not DEVELOPER.match(name):
            yield f"{NAME}.data/data/{name}", path


def prepare_metadata_for_build_wheel(folder, config_settings=None):
    (pathlib.Path(folder) / INFO).mkdir()
    for name, text in described().items():
        (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")
    return INFO


def build_wheel(folder, config_settings=None, metadata_directory=None):
    wheel, record = f"{NAME}-{TAG}.whl", []
    with tempfile.TemporaryDirectory() as stage, \
            zipfile.ZipFile(pathlib.Path(folder) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        call("cmake", "--install", built(), "--prefix", stage, "--strip")
        for name, path in packed(pathlib.Path(stage)):
            archive.write(path, name)
            record.append((name, path.read_bytes()))
        for name, text in described().items():
            archive.writestr(name, text)
            record.append((name, text.encode()))
        digests = ((name, base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode(), len(content))
                   for name, content in record)
        archive.writestr(f"{INFO}/RECORD", "".join(f"{name},sha256={digest},{size}\n" for name, digest, size in digests)
                         + f"{INFO}/RECORD,,\n")
    return wheel


def build_sdist(folder, config_settings=None):
    with tempfile.TemporaryDirectory() as stage, \
            tarfile.open(pathlib.Path(folder) / f"{NAME}.tar.gz", "w:gz") as archive:
        for name in subprocess.check_output(["git", "ls-files", "-z"], cwd=ROOT, text=True).split("\0")[:-1]:
            archive.add(ROOT / name, f"{NAME}/{name}")
        information = pathlib.Path(stage) / "PKG-INFO"
        information.write_text(metadata(), encoding="utf-8")
        archive.add(information, f"{NAME}/PKG-INFO")
    return f"{NAME}.tar.gz"
