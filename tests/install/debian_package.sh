#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the Debian package into a new Debian 12 that has no compiler, runs case a there with all its models, draws
# the report, imports the module and removes the package. Needs root, debootstrap and a network; takes some minutes.
# Call: debian_package.sh PACKAGE.deb
set -eu
package=$(realpath "$1")
# The mounts below vanish with this process.
[ "${2:-}" = inside ] || exec unshare --mount --propagation private sh "$0" "$package" inside
mirror=${MIRROR:-http://deb.debian.org/debian}
root=$(mktemp -d /tmp/rollfem-debian.XXXX)
chmod 755 "$root"  # apt downloads as a user of its own
trap 'umount "$root/proc" "$root/sys" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" || { tail "$root.log"; exit 1; }
rm "$root.log"
mount -t proc proc "$root/proc"
mount -t sysfs sysfs "$root/sys"  # MPI looks for cores there
cp "$package" "$root/tmp/rollfem.deb"
before=$(du -sm --one-file-system "$root" | cut -f1)

start=$(date +%s)
chroot "$root" sh -eu <<'INSTALL'
export DEBIAN_FRONTEND=noninteractive
{ apt-get update && apt-get install -y --no-install-recommends /tmp/rollfem.deb; } >/tmp/apt.log 2>&1 ||
  { tail -n 20 /tmp/apt.log; exit 1; }
grep '^Need to get' /tmp/apt.log
apt-get clean
if command -v cc c++ gcc g++ clang; then echo 'there is a compiler'; exit 1; fi
INSTALL
echo "installed in $(($(date +%s) - start)) s; $(($(du -sm --one-file-system "$root" | cut -f1) - before)) MB with what it depends on"

start=$(date +%s)
chroot "$root" sh -eu <<'RUN'
cd /tmp
rollfem --version
rollfem run /usr/share/rollfem/cases/thesis_a.toml --quiet -o case_a
test -s case_a/report.html
python3 - <<'PYTHON'
import rollfem

result = rollfem.read("case_a")
for model in result:
    # The exact pressure of Hertz. Finite elements on the case's grid are within 0.3 % of it (README).
    error = model.points[0].max_pressure / 578.967 - 1
    print(f"{model.name}: largest pressure {100 * error:+.2f} % off the exact one")
    assert abs(error) < 3e-3, model.name
assert {model.name for model in result} >= {"hertz", "halfspace"}
assert abs(rollfem.solve(result.case, model="hertz").points[0].max_pressure - 578.967) < 1e-3
PYTHON
RUN
echo "case a, all models, with report: $(($(date +%s) - start)) s"
chroot "$root" dpkg --purge rollfem >/dev/null
if find "$root/usr" -name '*rollfem*' | grep .; then echo 'the package has left these behind'; exit 1; fi
