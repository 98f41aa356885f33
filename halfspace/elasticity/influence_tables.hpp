// Influence coefficients of half-spaces that are computed once for a pair: they are proportional to
// the size of the elements, so that a ladder of ratios of the sides serves every patch.
#pragma once

#include "contact/base/material.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::halfspace {

/// Of elements of 1 by `ratio`; an element's effect `i` columns and `j` rows farther is at
/// row(j)[i], |i| <= n, 0 <= j < n. The normal one times dx is that of elements of dx; the
/// tangential ones are those of the difference (u_i - u_{i+1}) / dx, which has no size. All are
/// even in j but xy, which is odd.
struct InfluenceTable {
  double ratio = 1.0;     ///< dy / dx
  double diagonal = 0.0;  ///< mean of the second-order difference under the element itself
  int n = 0;
  std::vector<double> nn, xx, yy, xy;

  /// Middle of a row of a list.
  const double* row(const std::vector<double>& list, int j) const {
    return list.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(2 * n + 1) + n;
  }
};

class InfluenceTables {
 public:
  /// For grids of n by n elements.
  InfluenceTables(int n, const contact::CombinedMaterial& material);

  int n() const { return n_; }
  /// The one nearest on a logarithmic scale, within a tenth; null beyond 1:64 and 64:1.
  const InfluenceTable* nearest(double ratio) const;

 private:
  int n_;
  std::vector<InfluenceTable> tables_;
};

}  // namespace rollfem::halfspace
