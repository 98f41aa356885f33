// SPDX-License-Identifier: LGPL-2.1-or-later
// Influence coefficients of half-spaces, computed once for a pair of bodies: they are proportional
// to the size of the elements, so that a series of aspect ratios, and interpolation between them,
// covers every patch.
#pragma once

#include "base/material.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::halfspace {

// Inner loops of few_elements.hpp, compiled for each width of vector registers; the widest
// supported by the processor is chosen at run time.

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
  /// M of n <= most_rows rows becomes its inverse (Gauss and Jordan).
  void (*invert)(double* matrix, std::ptrdiff_t stride, std::ptrdiff_t n);
  static constexpr int most_rows = 64;
};

const ElementSums& element_sums();

/// For elements of 1 by `ratio`; an element's effect `i` columns and `j` rows farther is at
/// row(j)[i], |i| <= nx, 0 <= j < ny. The normal coefficient times dx applies to elements of dx;
/// the tangential ones are for the dimensionless difference (u_i - u_{i+1}) / dx. All are even in j
/// except xy, which is odd.
struct InfluenceTable {
  double ratio = 1.0;     ///< dy / dx
  double diagonal = 0.0;  ///< mean of the second-order difference under the element itself
  int nx = 0, ny = 0;
  std::vector<double> nn, xx, yy, xy;

  InfluenceRows rows(const std::vector<double>& list) const {
    return {list.data() + nx, 2 * nx + 1};
  }
  /// Middle of a row of a list.
  const double* row(const std::vector<double>& list, int j) const {
    const InfluenceRows of = rows(list);
    return of.middle + of.to_next * j;
  }
};

/// The table of one aspect ratio.
InfluenceTable influence_table(int nx, int ny, double ratio,
                               const contact::CombinedMaterial& material);

class InfluenceTables {
 public:
  /// For grids of up to nx by ny elements.
  InfluenceTables(int nx, int ny, const contact::CombinedMaterial& material);

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  /// Interpolates the table of an aspect ratio: a cubic through the four nearest on a logarithmic
  /// scale, accurate to 1e-4. False outside 1:64 to 64:1.
  bool interpolate(double ratio, InfluenceTable& table) const;

 private:
  int nx_, ny_;
  std::vector<InfluenceTable> tables_;
};

}  // namespace rollfem::halfspace
