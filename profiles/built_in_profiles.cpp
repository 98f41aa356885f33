#include "profiles/built_in_profiles.hpp"

#include "profiles/profile_pieces.hpp"
#include "profiles/wheel_s1002.hpp"

#include <cmath>
#include <utility>

namespace rollfem::profiles {

namespace {

/// Angle of the side of the rail head, 1:20 off the vertical.
const double side_angle = std::atan(20.0);
constexpr double top_radius = 300.0, middle_radius = 80.0, corner_radius = 13.0;  // mm
constexpr double deepest = 37.5;  // mm below the crown, where the side ends

/// Head of tangent arcs 300, 80, 13 and the side 1:20, symmetric; angles of the two upper joints.
ProfileCurve uic_head(double first, double second) {
  const double y80 = (top_radius - middle_radius) * std::sin(first);
  const double z80 = top_radius - (top_radius - middle_radius) * std::cos(first);
  const double y13 = y80 + (middle_radius - corner_radius) * std::sin(second);
  const double z13 = z80 - (middle_radius - corner_radius) * std::cos(second);
  const double side_y = y13 + corner_radius * std::sin(side_angle);
  const double side_z = z13 - corner_radius * std::cos(side_angle);
  const double end_y = side_y + (deepest - side_z) / 20.0;
  ProfileKnots knots;
  append_line(knots, -end_y, deepest, -side_y, side_z);
  append_arc(knots, -y13, z13, corner_radius, -side_angle, -second);
  append_arc(knots, -y80, z80, middle_radius, -second, -first);
  append_arc(knots, 0.0, top_radius, top_radius, -first, first);
  append_arc(knots, y80, z80, middle_radius, first, second);
  append_arc(knots, y13, z13, corner_radius, second, side_angle);
  append_line(knots, side_y, side_z, end_y, deepest);
  return ProfileCurve(std::move(knots));
}

/// Widths 20.456 and 52.053 of the bands of the radii 300 and 80 (Gensys, create_UIC60).
ProfileCurve rail_60e1() {
  const double first = std::asin(0.5 * 20.456 / top_radius);
  const double y80 = (top_radius - middle_radius) * std::sin(first);
  return uic_head(first, std::asin((0.5 * 52.053 - y80) / middle_radius));
}

/// Band of 21 mm at the top and the head 72 mm wide where the side begins: fits the benchmark's
/// list of points within 4.4e-5 mm.
ProfileCurve rail_uic60_manchester() {
  const double first = std::asin(0.5 * 21.0 / top_radius);
  const double y80 = (top_radius - middle_radius) * std::sin(first);
  const double y13 = 0.5 * 72.0 - corner_radius * std::sin(side_angle);
  return uic_head(first, std::asin((y13 - y80) / (middle_radius - corner_radius)));
}

}  // namespace

const std::vector<BuiltInProfile>& built_in_profiles() {
  static const std::vector<BuiltInProfile> profiles{
      {"S1002", true, "wheel of EN 13715 and UIC 510-2, h 28, e 32.5", [] { return s1002(false); }},
      {"S1002-smooth", true, "S1002 with zone C moved by up to 1.2e-4 mm to meet its neighbours",
       [] { return s1002(true); }},
      {"60E1", false, "rail head of EN 13674-1, not inclined", &rail_60e1},
      {"UIC60", false, "the same as 60E1", &rail_60e1},
      {"UIC60-manchester", false, "rail head of the Manchester contact benchmark, not inclined",
       &rail_uic60_manchester},
  };
  return profiles;
}

const BuiltInProfile* find_built_in_profile(const std::string& name) {
  for (const BuiltInProfile& profile : built_in_profiles())
    if (profile.name == name) return &profile;
  return nullptr;
}

}  // namespace rollfem::profiles
