#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Makes a wheel, installs it into another virtual environment, uses it from a folder of its own and removes it, all
# without a network. Status 77 (skipped) without python3-venv.
# Call: pip.sh SOURCE_DIR [BUILD_DIR], a finished build; without it pip compiles, as for a user.
set -eu
source=$(realpath "$1")
if [ $# -gt 1 ]; then ROLLFEM_BUILD=$(realpath "$2"); export ROLLFEM_BUILD; fi
/usr/bin/python3 -c 'import ensurepip' 2>/dev/null || { echo 'python3-venv is not installed: skipped'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1
unset PYTHONPATH PIP_FIND_LINKS

/usr/bin/python3 -m venv maker
maker/bin/pip wheel --quiet --no-deps "$source"
rm -r maker
ls -sh rollfem-*.whl

# NumPy, h5py and Matplotlib are Debian's; the h5py has no name that pip knows.
/usr/bin/python3 -m venv --system-site-packages user
user/bin/pip install --quiet --no-deps rollfem-*.whl
user/bin/python - <<'PYTHON'
import importlib.metadata
import pathlib
import sys

import rollfem

prefix = pathlib.Path(sys.prefix)
case = prefix / "share/rollfem/cases/thesis_a.toml"
assert importlib.metadata.version("rollfem") == rollfem.__version__
assert pathlib.Path(rollfem._core.figures_directory()).is_relative_to(prefix), rollfem._core.figures_directory()
result = rollfem.solve(case, model="hertz")
assert abs(result.points[0].max_pressure - 578.967) < 1e-3  # Hertz, in closed form
result.write("written", report=True)
assert rollfem.read("written").points[0].max_pressure == result.points[0].max_pressure
PYTHON
case=user/share/rollfem/cases/thesis_a.toml
user/bin/rollfem --version
user/bin/rollfem run "$case" --model halfspace --set contact_grid.elements_across=10 --quiet -o results
ls written/report.html results/report.html

user/bin/pip uninstall --quiet --yes rollfem
if find user -type f -name '*rollfem*' | grep .; then echo 'pip has left these behind' >&2; exit 1; fi
