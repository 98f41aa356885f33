#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Lets libFuzzer look for inputs that break a target: search.sh [SECONDS [TARGET ...]], 20 s for each
# of case_file, profile, lattice and contact_input, and of pose, sections and plasticity, which solve; FUZZ_SEED is libFuzzer's, another every time without it. Needs
# clang with libFuzzer. Begins with the corpus and the cases of the source; what it finds goes to
# build-fuzz/found, with the call that shows it again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds=${1:-20}
targets=("${@:2}")
if [ ${#targets[@]} -eq 0 ]; then targets=(case_file profile lattice contact_input pose sections plasticity); fi
cmake --preset fuzz >build-fuzz.log || { cat build-fuzz.log >&2; exit 1; }
mv build-fuzz.log build-fuzz/configure.log
nice ninja -C build-fuzz --quiet "${targets[@]/#/fuzz_}"
for target in "${targets[@]}"; do
  mkdir -p "build-fuzz/seeds/$target" "build-fuzz/found"
  seeds=("build-fuzz/seeds/$target")
  if [ -d "tests/fuzz/corpus/$target" ]; then seeds+=("tests/fuzz/corpus/$target"); fi
  if [ "$target" = case_file ]; then seeds+=(cases); fi
  echo "fuzzing $target for $seconds s"
  if ! "build-fuzz/tests/fuzz/fuzz_$target" -max_total_time="$seconds" -seed="${FUZZ_SEED:-0}" -timeout=60 -rss_limit_mb=2048 \
      -max_len=8000 -artifact_prefix="build-fuzz/found/$target-" "${seeds[@]}" \
      >"build-fuzz/found/$target.log" 2>&1; then
    tail -n 40 "build-fuzz/found/$target.log" >&2
    exit 1
  fi
  tail -n 1 "build-fuzz/found/$target.log"
done
