// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolates fields from one contact grid to another, as first guesses from a coarser level, and
// along a line.
#pragma once

#include "base/grid.hpp"

#include <array>
#include <cstddef>

namespace rollfem::contact {

/// Bilinear between element centres of `from`, zero beyond its outermost ones. With `weights` (one
/// per element of `from`) the average counts only elements of positive weight, so that values next
/// to the edge of a patch are not drawn to zero from outside.
Field interpolated(const ContactGrid& from, const Field& values, const ContactGrid& to,
                   const Field& weights = {});

/// Tractions over their bounds, between -1 and 1; 0 where the bound is 0.
TangentialField relative_to_bound(const TangentialField& traction, const Field& bound);

/// Initial tractions of a finer grid: `relative` (tractions over bounds of the coarser grid under
/// `pressure`) times the bounds of the finer grid.
TangentialField finer_tractions(const ContactGrid& coarse, const Field& pressure,
                                const TangentialField& relative, const ContactGrid& fine,
                                const Field& bound);

/// Weights of the values at `nodes` in the value at a place, by the polynomial through them.
template <std::size_t count>
std::array<double, count> lagrange_weights(const std::array<double, count>& nodes, double place) {
  std::array<double, count> weights;
  for (std::size_t k = 0; k < count; ++k) {
    weights[k] = 1.0;
    for (std::size_t m = 0; m < count; ++m)
      if (m != k) weights[k] *= (place - nodes[m]) / (nodes[k] - nodes[m]);
  }
  return weights;
}

}  // namespace rollfem::contact
