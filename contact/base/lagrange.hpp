// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolation by the polynomial through a few nodes.
#pragma once

#include <array>
#include <cstddef>

namespace rollfem::contact {

/// Weights of the values at `nodes` in the value at a place.
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
