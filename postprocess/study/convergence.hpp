// SPDX-License-Identifier: LGPL-2.1-or-later
// Convergence of a sequence of values on successively finer levels: the observed order,
// Richardson's limit and the reliability of both. P. J. Roache, Verification and Validation in
// Computational Science and Engineering (1998); L. Eca, M. Hoekstra, J. Comput. Phys. 262 (2014),
// for sequences without an order.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

/// f(h) = limit + C h^p, from the three finest of the values; where these show no order, from all
/// of them by least squares if they are four or more and follow such a curve.
struct Limit {
  /// Observed order p; none where neither the three values nor all allow one.
  std::optional<double> order;
  bool fitted = false;   ///< to all values
  bool settled = false;  ///< the last changes are rounding, or what solvers end at
  /// Why the three values show no order; empty when they do.
  std::string reason;
  /// Richardson value with an order; the finest value without.
  double value = 0.0;
  /// Of `value`, absolute. With orders of at most 2.5 from the last three and from the three
  /// before: 1.5 times the spread of what is extrapolated to by both, and from the last two values
  /// by either order, at least a fourth of the distance to the finest value; with three values
  /// grid_uncertainty; with a fitted order that of Eca and Hoekstra: 1.25 times the distance to the
  /// finest value, the scatter about the curve and the finest value's own distance from it; without
  /// an order three times the largest change. Never below the noise.
  double uncertainty = 0.0;
  /// Of the finest value itself, absolute: Roache's grid convergence index with the factor 1.25 and
  /// an order of at most 2 (what the methods of this program have). Changes that fall faster than
  /// an order of 2.5 do so by chance: then the last is believed to be no less than half of the one
  /// before, and the order 1. Without an order as above.
  double grid_uncertainty = 0.0;
};

/// Orders outside of this are not those of a method: changes that fall too slowly or vanish by
/// chance.
inline constexpr double least_order = 0.5;
inline constexpr double largest_order = 6.0;

/// `values` coarsest first, each on cells smaller by `ratio` > 1 than the one before; two at least
/// (two give no order). `noise`: absolute, what a solver leaves uncertain in a value; below it, and
/// below rounding, changes are none. Throws std::logic_error otherwise.
Limit limit_of(const std::vector<double>& values, double ratio, double noise = 0.0);

/// Order that two errors show on cells that are smaller by `ratio`; none where one is 0.
std::optional<double> order_of_errors(double coarse, double fine, double ratio);

}  // namespace rollfem::postprocess
