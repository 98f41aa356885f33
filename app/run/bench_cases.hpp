// SPDX-License-Identifier: LGPL-2.1-or-later
// The cases of `rollfem bench`, with their solutions free of grid error.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::app {

/// Limit of a force under grid refinement, at a load point.
struct BenchLimit {
  std::size_t point = 0;  ///< counted from 0
  std::string quantity;   ///< a name of contact/result/quantities.hpp
  double value = 0.0;     ///< in the unit of the quantity
  double whole = 0.0;     ///< value at full sliding; errors are relative to it
};

struct BenchCase {
  std::string name;
  std::string sentence;       ///< description
  std::string text;           ///< a case file without models
  double max_pressure = 0.0;  ///< Hertz's, MPa; 0: the pressure is given
  /// Limits of the half-space, extrapolated from 160 and 320 elements across to about 2e-4 of the
  /// whole; tests/unit/app/bench_cases.cpp recomputes them.
  std::vector<BenchLimit> limits;
  bool of_bodies = false;  ///< true: finite elements and the hybrid solve it too
};

const std::vector<BenchCase>& bench_cases();

}  // namespace rollfem::app
