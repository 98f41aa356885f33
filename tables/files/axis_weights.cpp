// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/axis_weights.hpp"

#include "base/knots.hpp"

#include <algorithm>
#include <cstddef>

namespace rollfem::tables {

namespace {

/// Weights of three values in the slope of their parabola at the middle value.
std::array<double, 3> middle_slope(double before, double after) {
  const double both = before + after;
  return {-after / (before * both), (after - before) / (before * after), before / (after * both)};
}

/// The same at the first value; `near` and `far` are the distances to the next one and between the
/// others.
std::array<double, 3> end_slope(double near, double far) {
  const double both = near + far;
  return {-(2.0 * near + far) / (near * both), both / (near * far), -near / (far * both)};
}

}  // namespace

AxisWeights axis_weights(const std::vector<double>& nodes, double place, bool mirrored,
                         AtZero zero) {
  const std::size_t count = nodes.size();
  AxisWeights found;
  if (count == 1) {
    found.weight[0] = 1.0;
    return found;
  }
  const auto [i, h, t] = contact::piece_of(nodes, place);
  found.first = static_cast<int>(i) - 1;
  auto& weight = found.weight;
  weight[1] = (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t);
  weight[2] = t * t * (3.0 - 2.0 * t);
  const double left = h * t * (1.0 - t) * (1.0 - t), right = -h * t * t * (1.0 - t);
  const auto add = [&](int slot, int step, double scale, const std::array<double, 3>& slope) {
    for (int n = 0; n < 3; ++n) weight[slot + n * step] += scale * slope[n];
  };
  const bool bent = zero == AtZero::bent;
  const bool has_left = (i > 0 || mirrored) && !(bent && nodes[i] == 0.0);
  const bool has_right = i + 2 < count && !(bent && nodes[i + 1] == 0.0);
  const double h_left = i > 0 ? nodes[i] - nodes[i - 1] : h;
  const double h_right = i + 2 < count ? nodes[i + 2] - nodes[i + 1] : h;
  if (!has_left && !has_right) {
    weight[1] = 1.0 - t;
    weight[2] = t;
    return found;
  }
  add(has_left ? 0 : 1, 1, left, has_left ? middle_slope(h_left, h) : end_slope(h, h_right));
  if (has_right)
    add(1, 1, right, middle_slope(h, h_right));
  else
    add(2, -1, -right, end_slope(h, h_left));
  return found;
}

}  // namespace rollfem::tables
