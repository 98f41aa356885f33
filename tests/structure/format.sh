#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Checks the C++ files against .clang-format. Status 77 (skipped) without clang-format.
# Call: format.sh SOURCE_DIR
cd "$1" || exit 1
command -v clang-format >/dev/null || { echo 'clang-format is not installed: skipped'; exit 77; }
find base case scene result contact halfspace theories hybrid profiles track meshes fem modelling tables convert app bindings examples tests benchmarks -name '*.[ch]pp' -print0 |
  xargs -0 clang-format --dry-run -Werror
