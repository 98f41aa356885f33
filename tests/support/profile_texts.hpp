// SPDX-License-Identifier: LGPL-2.1-or-later
// Built-in profiles as text in files, and what is read from them.
#pragma once

#include "base/errors.hpp"
#include "profiles/formula_profiles.hpp"
#include "profiles/profiles.hpp"

#include "support/temporary_folder.hpp"
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

inline std::string columns(const Points& points, const std::string& separator = " ",
                           double unit = 1.0) {
  std::ostringstream text;
  text.precision(12);
  for (const auto& [y, z] : points) text << y / unit << separator << z / unit << '\n';
  return text.str();
}

inline profiles::ProfileCurve read(const std::string& text, bool wheel,
                                   contact::ProfileSource source = {},
                                   const std::string& name = "profile.txt") {
  const TemporaryFolder folder;
  folder.file(name, text);
  source.name = name;
  return profiles::make_profile(source, wheel, folder.path("case.toml"));
}

inline std::string refusal(const std::string& text, bool wheel,
                           const contact::ProfileSource& source = {},
                           const std::string& name = "profile.txt") {
  return refusal<contact::InputError>([&] { read(text, wheel, source, name); });
}

/// Largest distance in z between a curve and a built-in profile where that is not steep.
inline double off(const profiles::ProfileCurve& curve, const std::string& name) {
  const profiles::ProfileCurve truth = profiles::find_built_in_profile(name)->make();
  const bool wheel = profiles::find_built_in_profile(name)->wheel;
  double worst = 0.0;
  for (double y = wheel ? -35.0 : -30.0; y <= (wheel ? 55.0 : 30.0); y += 0.7)
    worst = std::max(
        worst, std::abs(curve.at(curve.parameter_at(y)).z - truth.at(truth.parameter_at(y)).z));
  return worst;
}

inline std::string changed(const std::string& name, const std::function<void(Points&)>& change,
                           double unit = 1.0) {
  Points points = points_of(name);
  change(points);
  return columns(points, " ", unit);
}

// A spline through points 0.5 mm apart, where the radius jumps from 13 to 80 mm.
inline constexpr double spline_tolerance = 5e-4;

}  // namespace rollfem::testing
