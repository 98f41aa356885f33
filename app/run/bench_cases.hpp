// SPDX-License-Identifier: LGPL-2.1-or-later
// The cases of `rollfem bench`, with their solutions free of grid error.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::app {

/// A force in the limit of ever finer grids, at a load point.
struct BenchLimit {
  std::size_t point = 0;  ///< from 0
  std::string quantity;   ///< a name of contact/result/quantities.hpp
  double value = 0.0;     ///< in its unit
  double whole = 0.0;     ///< what full sliding gives: errors are parts of it
};

struct BenchCase {
  std::string name;
  std::string sentence;       ///< what it is
  std::string text;           ///< a case file without models
  double max_pressure = 0.0;  ///< MPa, Hertz's; 0: it is given
  /// Of half-spaces: extrapolated from 160 and 320 elements across, to about 2e-4 of the whole.
  /// tests/unit/app/bench_cases.cpp solves them anew.
  std::vector<BenchLimit> limits;
  bool of_bodies = false;  ///< finite elements and the hybrid solve it as well
};

const std::vector<BenchCase>& bench_cases();

}  // namespace rollfem::app
