// SPDX-License-Identifier: LGPL-2.1-or-later
// Inner loops of few_elements.hpp, compiled for each width of vector registers; the widest that the
// processor has is taken at run time.
#pragma once

#include <cstddef>

namespace rollfem::halfspace {

/// An element that is not 0.
struct Source {
  int i = 0, j = 0;  ///< column, row
  double value = 0.0;
};

/// Values read beyond the end of a list of influence coefficients, which count for nothing.
inline constexpr std::size_t read_beyond = 16;
/// Columns of a grid at most.
inline constexpr int most_columns = 28;

/// Influence coefficients by distance, as InfluenceTable has them.
struct InfluenceRows {
  const double* middle = nullptr;  ///< of the row of distance 0
  std::ptrdiff_t to_next = 0;      ///< from row to row
};

struct ElementSums {
  /// result[l nx + m] = sum over sources of value influence(|l - j|)[m - i].
  void (*convolve)(const InfluenceRows& influence, const Source* first, const Source* last, int nx,
                   int ny, double* result);
  /// y = M x, M row by row with `stride` between rows.
  void (*multiply)(const double* matrix, std::ptrdiff_t stride, std::ptrdiff_t rows,
                   std::ptrdiff_t columns, const double* x, double* y);
};

const ElementSums& element_sums();

}  // namespace rollfem::halfspace
