// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolation along one axis of a table: cubic between two nodes, with slopes from parabolas
// through three nodes, so that first derivatives are continuous where values pass 0 smoothly.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace rollfem::tables {

/// Four consecutive nodes and their weights; missing nodes have weight 0.
struct AxisWeights {
  int first = 0;  ///< -1: the mirror image of node 1
  std::array<double, 4> weight{};
};

/// Calls visit(node, weight, slot) for the nodes with a weight.
template <class Visit>
void each_node(const AxisWeights& weights, const Visit& visit) {
  for (std::size_t n = 0; n < 4; ++n)
    if (weights.weight[n] != 0.0) {
      const int node = weights.first + static_cast<int>(n);
      visit(static_cast<std::size_t>(node), weights.weight[n], n);
    }
}

/// The two nodes around the place, of `count`: slots 1 and 2, if they exist.
inline std::array<std::size_t, 2> around(const AxisWeights& axis, std::size_t count) {
  if (count == 1) return {0, 0};
  const int below = axis.first + 1;
  const auto lower = static_cast<std::size_t>(below);
  return {lower, lower + 1};
}

/// Behaviour at 0: smooth, or with a jump of the second derivative, like a force that falls below
/// its linear part by the square of the creepage for either sign. The slope at node 0 is then
/// one-sided.
enum class AtZero { smooth, bent };

/// Weights for a place between the first and the last node (increasing). `mirrored`: node 0 is 0
/// and the interpolated values continue as a mirror image beyond it.
AxisWeights axis_weights(const std::vector<double>& nodes, double place, bool mirrored,
                         AtZero zero = AtZero::smooth);

}  // namespace rollfem::tables
