// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolation along one axis of a table: cubic between two nodes with the slopes of parabolas
// through three, so that first derivatives are continuous where values pass 0 smoothly.
#pragma once

#include <array>
#include <vector>

namespace rollfem::tables {

/// Four nodes that follow each other and their weights; those that are not there have weight 0.
struct AxisWeights {
  int first = 0;  ///< -1: the mirror image of node 1
  std::array<double, 4> weight{};
};

/// How values pass 0: smoothly, or with a kink in their slope's growth as a force that falls short
/// of its linear part by the square of the creepage, whatever its sign. Then the slope at the node
/// 0 is taken from one side.
enum class AtZero { smooth, bent };

/// For a place between the first and the last node (increasing). `mirrored`: node 0 is 0 and what
/// is interpolated has a mirror image on its other side.
AxisWeights axis_weights(const std::vector<double>& nodes, double place, bool mirrored,
                         AtZero zero = AtZero::smooth);

}  // namespace rollfem::tables
