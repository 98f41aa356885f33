// SPDX-License-Identifier: LGPL-2.1-or-later
// The temperature below the surface of a body while it rolls, from that of the surface: conduction
// into the depth alone (Carslaw and Jaeger 1959, 2.9).
#pragma once

#include "base/grid.hpp"
#include "scene/surface_heat.hpp"

#include <array>
#include <vector>

namespace rollfem::contact {

class HeatBelow {
 public:
  /// `surface`: degC, of the elements of the grid.
  HeatBelow(const ContactGrid& grid, const HeatedBody& body, double speed, const Field& surface);
  /// K above the temperature before contact at places (x, y, depth >= 0), linear between the
  /// middles of elements; 0 ahead of and beside the grid, and more than its length behind it.
  std::vector<double> rise(const std::vector<std::array<double, 3>>& places) const;

 private:
  /// K at a depth by a heat flow of 1 N/(mm s) through an element so many elements ahead.
  Field warming(double depth, Eigen::Index count) const;

  ContactGrid grid_;
  HeatedBody body_;
  double speed_;
  Field flow_;  ///< N/(mm s), which leads to the temperatures of the surface
};

}  // namespace rollfem::contact
