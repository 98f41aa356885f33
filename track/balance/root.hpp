// SPDX-License-Identifier: LGPL-2.1-or-later
// Roots of several functions of one variable each that are evaluated together: one
// half-space run gives the forces of all load points.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rollfem::track {

/// Values of all functions, each at its argument.
using Functions = std::function<std::vector<double>(const std::vector<double>&)>;

struct RootOptions {
  double step = 1e-3;            ///< first step of the search for a change of sign
  double largest = 0.1;          ///< arguments stay between -largest and largest
  double value_tolerance = 0.0;  ///< on the size of the value
  double tolerance = 1e-9;       ///< on the argument
};

/// Zeros of decreasing functions, from `start`: brackets first, then regula falsi with the Illinois
/// rule. Throws contact::SolveError with `what` when a function keeps its sign.
std::vector<double> falling_roots(const Functions& functions, const std::vector<double>& start,
                                  const RootOptions& options, const std::string& what);

}  // namespace rollfem::track
