// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/profile_rows.hpp"

#include "contact/base/count.hpp"
#include "contact/base/pi.hpp"

#include <cmath>

namespace rollfem::profiles {

double angle_of(const ProfilePoint& place) {
  constexpr double degrees = 180.0 / contact::pi;
  return std::atan2(place.tangent_z, place.tangent_y) * degrees;
}

std::vector<ProfileRow> profile_rows(const ProfileCurve& curve, bool wheel) {
  std::vector<ProfileRow> rows;
  const auto row = [&](double parameter, const ProfilePoint& place, double curvature) {
    rows.push_back({parameter, place.y, place.z, angle_of(place), curvature});
  };
  const auto joints = profile_features(curve, wheel).joints;
  const double length = curve.last() - curve.first();
  const int steps = contact::count_of(std::ceil(length / 0.1), "points along a profile");
  auto joint = joints.begin();
  for (int k = 0; k <= steps; ++k) {
    const double parameter = k == steps ? curve.last() : curve.first() + length * k / steps;
    for (; joint != joints.end() && joint->parameter <= parameter; ++joint) {
      row(joint->parameter, joint->place, joint->curvature_before);
      row(joint->parameter, joint->place, joint->place.curvature);
    }
    const ProfilePoint place = curve.at(parameter);
    row(parameter, place, place.curvature);
  }
  return rows;
}

}  // namespace rollfem::profiles
