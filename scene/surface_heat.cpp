// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/surface_heat.hpp"

#include "base/pi.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

HeatedBody heated(const Body& body) {
  const BodyHeat heat = body.heat.value_or(BodyHeat{});
  constexpr double per_tonne = 1e6;                                             // J/kg in N mm/t
  const double volumetric = body.material.density * per_tonne * heat.capacity;  // N/(mm^2 K)
  return {std::sqrt(heat.conductivity * volumetric), heat.conductivity / volumetric, heat.expansion,
          heat.temperature, heat.limit};
}

}  // namespace

Field SurfaceHeat::warming(double dx, int count) const {
  return Field::NullaryExpr(count, [&](Eigen::Index passed) {
    const double middle = static_cast<double>(passed);
    return 2.0 * std::sqrt(dx / (pi * speed)) *
           (std::sqrt(middle + 0.5) - std::sqrt(std::max(0.0, middle - 0.5)));
  });
}

std::optional<SurfaceHeat> surface_heat(const Case& input) {
  if (!input.wheel.heat && !input.rail.heat && !input.friction_fall.shape.by_temperature) return {};
  return SurfaceHeat{heated(input.wheel), heated(input.rail), input.rolling.speed};
}

}  // namespace rollfem::contact
