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

/// f(h) = limit + C h^p from the three finest values; if these show no order, a least-squares fit
/// to all values, provided there are at least four and they follow such a curve.
struct Limit {
  /// Observed order p; empty if neither three values nor the fit give one.
  std::optional<double> order;
  bool fitted = false;   ///< to all values
  bool settled = false;  ///< the last changes are rounding or solver tolerance
  /// Why the three values show no order; otherwise empty.
  std::string reason;
  /// Richardson value if there is an order; otherwise the finest value.
  double value = 0.0;
  /// Uncertainty of `value`, absolute. If the last three values and the three before show orders of
  /// at most 2.5: 1.5 times the spread of the values extrapolated from both triples and from the
  /// last two values with either order, at least a fourth of the distance to the finest value. With
  /// three values: grid_uncertainty. With a fitted order, after Eca and Hoekstra: 1.25 times the
  /// distance to the finest value, plus the scatter about the curve and the finest value's distance
  /// from it. Without an order: three times the largest change. Never below the noise.
  double uncertainty = 0.0;
  /// Uncertainty of the finest value, absolute: Roache's grid convergence index with factor 1.25
  /// and an order of at most 2, the order of the methods here. Changes that fall faster than order
  /// 2.5 do so by coincidence: then the last change counts as at least half of the previous one,
  /// with order 1. Without an order as above.
  double grid_uncertainty = 0.0;
};

/// Range of plausible orders; outside it changes fall too slowly or vanish by coincidence.
inline constexpr double least_order = 0.5;
inline constexpr double largest_order = 6.0;

/// `values`: coarsest first, each on cells smaller by `ratio` > 1 than the previous one; at least
/// two (two give no order). `noise`: absolute uncertainty of a value from its solver; changes below
/// it or below rounding count as zero. Throws std::logic_error for other arguments.
Limit limit_of(const std::vector<double>& values, double ratio, double noise = 0.0);

/// Order from two errors on cells that differ by `ratio`; empty if one of them is 0.
std::optional<double> order_of_errors(double coarse, double fine, double ratio);

}  // namespace rollfem::postprocess
