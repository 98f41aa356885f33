// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of built-in profiles, and as text in files.
#pragma once

#include "profiles/formula_profiles.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

using Points = std::vector<std::array<double, 2>>;

inline Points points_of(const std::string& name, double spacing = 0.5) {
  const profiles::ProfileCurve curve = profiles::find_built_in_profile(name)->make();
  Points points;
  for (double p = curve.first(); p <= curve.last(); p += spacing) {
    const profiles::ProfilePoint place = curve.at(p);
    points.push_back({place.y, place.z});
  }
  return points;
}

inline std::string columns(const Points& points) {
  std::ostringstream text;
  text.precision(12);
  for (const auto& [y, z] : points) text << y << ' ' << z << '\n';
  return text.str();
}

}  // namespace rollfem::testing
