// SPDX-License-Identifier: LGPL-2.1-or-later
// Inner loops of few_elements.hpp, compiled for each width of vector registers; the widest
// supported by the processor is chosen at run time.
#pragma once

#include <cstddef>

namespace rollfem::halfspace {

/// A nonzero element.
struct Source {
  int i = 0, j = 0;  ///< column, row
  double value = 0.0;
};

/// Padding read beyond the end of a list of influence coefficients, without effect on results.
inline constexpr std::size_t read_beyond = 16;
/// Largest number of columns of a grid.
inline constexpr int most_columns = 28;

/// Influence coefficients by distance, as in InfluenceTable.
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
