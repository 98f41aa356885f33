// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels and rails for tests of placement and contact search: built-in pairs, profiles from
// formulas, and the distance of wheel and rail found by brute force.
#pragma once

#include "case/case.hpp"
#include "profiles/formula_profiles.hpp"
#include "track/search/contact_search.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// z(y) with its slope at every step, exact between knots up to the fourth power of the step.
inline profiles::ProfileCurve profile_of(const std::function<double(double)>& z,
                                         const std::function<double(double)>& slope, double first,
                                         double last, double step = 0.25) {
  std::vector<profiles::ProfileKnot> knots;
  const int count = static_cast<int>(std::round((last - first) / step));
  for (int k = 0; k <= count; ++k) {
    const double y = first + (last - first) * k / count;
    knots.push_back({y, y, z(y), 1.0, slope(y)});
  }
  return profiles::ProfileCurve(knots);
}

/// Head of radius `rail_radius` under a sphere-shaped wheel, whose surface is the same about any
/// axle through its centre: contact lies on the line between the centres.
inline track::ProfilePair sphere_on_cylinder(double radius, double rail_radius) {
  const auto circle = [](double r) { return [r](double y) { return std::sqrt(r * r - y * y); }; };
  const auto wheel = circle(radius), rail = circle(rail_radius);
  return {profile_of([=](double y) { return wheel(y) - radius; },
                     [=](double y) { return -y / wheel(y); }, -70.0, 60.0),
          profile_of([=](double y) { return rail_radius - rail(y); },
                     [=](double y) { return y / rail(y); }, -60.0, 60.0)};
}

/// S1002 on the Manchester benchmark's rail, inclined 1:40.
inline track::ProfilePair manchester_pair() {
  return {profiles::find_built_in_profile("S1002")->make(),
          profiles::find_built_in_profile("UIC60-manchester")->make()};
}

inline contact::Case manchester_case(double shift, double yaw) {
  contact::Case input;
  input.wheel.rolling_radius = 460.0;
  for (contact::Material* material : {&input.wheel.material, &input.rail.material}) {
    material->poisson_ratio = 0.28;
    material->young_modulus = 2.0 * 1.28 * 82000.0;
  }
  input.friction_coefficient = 0.3;
  input.load.vertical_force = 10e3;
  input.track.inclination = 1.0 / 40.0;
  input.wheelset.lateral_shift = {shift};
  input.wheelset.yaw = {yaw};
  return input;
}

/// Contacts of one wheel at the first position.
inline std::vector<track::WheelRailContact> contacts_of(const contact::Case& input,
                                                        const track::SearchScene& scene, bool left,
                                                        const track::SearchOptions& options = {}) {
  return find_contacts(input, scene, find_pose(input, scene, 1), 1, left, options);
}

inline std::vector<track::WheelRailContact> contacts_of(const contact::Case& input,
                                                        bool left = true,
                                                        const track::SearchOptions& options = {}) {
  return contacts_of(input, track::make_search_scene(input, manchester_pair()), left, options);
}

/// Smallest height of the wheel's surface above the rail, mm: points of the surface of revolution
/// about the axle, to 0.02 mm across and as finely along as matters. No outline, no tangents.
inline double brute_force_distance(const track::SearchScene& scene, double rolling_radius,
                                   const contact::Axle& axle) {
  const profiles::ProfileCurve& wheel = scene.profiles.wheel;
  const auto& d = axle.direction;
  // Any two directions across the axle serve.
  const double length = std::hypot(d[1], d[2]);
  const contact::Vector3 down{0.0, -d[2] / length, d[1] / length};
  const contact::Vector3 ahead{d[1] * down[2] - d[2] * down[1], d[2] * down[0] - d[0] * down[2],
                               d[0] * down[1] - d[1] * down[0]};
  double least = std::numeric_limits<double>::infinity();
  for (double t = wheel.first(); t < wheel.last(); t += 0.02) {
    const profiles::ProfilePoint at = wheel.at(t);
    const auto height = [&](double angle) {
      contact::Vector3 place{};
      for (int i = 0; i < 3; ++i)
        place[i] =
            axle.point[i] + at.y * d[i] +
            (rolling_radius + at.z) * (std::cos(angle) * down[i] + std::sin(angle) * ahead[i]);
      if (!scene.rail(true).head.contains(place[1])) return 1e3;
      return scene.rail(true).head.at(place[1]).value - place[2];
    };
    for (double angle = -0.1; angle <= 0.1; angle += 0.0005) least = std::min(least, height(angle));
  }
  return least;
}

}  // namespace rollfem::testing
