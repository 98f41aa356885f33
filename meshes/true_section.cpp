// SPDX-License-Identifier: LGPL-2.1-or-later
// Outlines of true sections in the frame of a patch.
#include "meshes/true_section.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

/// Spacing of the points of a dense profile, mm.
constexpr double profile_step = 0.1;

/// Right half of a rail 60E1 below the side of its head: p from the middle of the web, q below the
/// top. Each fillet consists of two lines; slopes of the underside 1:2.75, of the foot 1:2.75 and
/// 1:14.
constexpr std::array<SectionPoint, 12> below_head{{{20.0, 43.7},
                                                   {12.5, 47.9},
                                                   {9.3, 55.0},
                                                   {8.25, 64.0},
                                                   {8.25, 118.0},
                                                   {9.6, 131.0},
                                                   {13.5, 141.5},
                                                   {22.0, 149.4},
                                                   {47.0, 158.5},
                                                   {75.0, 160.5},
                                                   {75.0, 172.0},
                                                   {0.0, 172.0}}};
constexpr double underside = 37.5;   // mm, where the side of the head ends
constexpr double head_half = 36.6;   // mm, half width of the head at mid height
constexpr double steep_side = 0.97;  // cosine between the side of a head and the vertical

/// Outline from one end (p, q) of the profile down to the cut, without that end; `side` is +1 or
/// -1.
std::vector<SectionPoint> side_below(const SectionPoint& end, double middle, double side,
                                     double cut) {
  std::vector<SectionPoint> points;
  SectionPoint last = end;
  const auto add = [&](const SectionPoint& next) {
    if (last[1] >= cut) return;
    SectionPoint p = next;
    if (next[1] > cut) {
      const double share = (cut - last[1]) / (next[1] - last[1]);
      p = {last[0] + share * (next[0] - last[0]), cut};
    }
    points.push_back(p);
    last = p;
  };
  const double half = side * (end[0] - middle);
  // Avoids a sliver where the profile ends close to this point.
  if (end[1] < underside - 1.5) add({end[0], underside});
  for (const SectionPoint& p : below_head) {
    const bool under_narrow_head = p[1] < 60.0 && p[0] > half - 2.0;
    if (under_narrow_head || p[0] == 0.0) continue;
    add({middle + side * p[0], p[1]});
  }
  return points;
}

}  // namespace

AxleTrace axle_trace(const contact::Axle& axle) {
  const double across = std::hypot(axle.direction[1], axle.direction[2]);
  const double way = -axle.point[1] / axle.direction[1];
  return {axle.direction[1] / across, axle.direction[2] / across,
          axle.point[2] + way * axle.direction[2], way};
}

TrueSection rail_section(const contact::PatchGeometry& geometry, const RailStand& stand) {
  const AxleTrace axle = axle_trace(geometry.axle());
  const double lean = std::atan(stand.inclination) * (stand.field_at_left ? -1.0 : 1.0);
  // The normal of the axle, leaned so that the foot moves to the field side.
  const SectionPoint down{std::cos(lean) * axle.sine + std::sin(lean) * axle.cosine,
                          -std::cos(lean) * axle.cosine + std::sin(lean) * axle.sine};
  const SectionPoint across{-down[1], down[0]};

  TrueSection outline;
  outline.inwards = -1.0;
  const contact::HeightCurve& rail = geometry.rail();
  const int count = contact::count_of(std::ceil((rail.last() - rail.first()) / profile_step),
                                      "points along a profile");
  double top = HUGE_VAL;
  for (int k = 0; k <= count; ++k) {
    const double y = rail.first() + (rail.last() - rail.first()) * k / count;
    outline.profile.push_back({y, rail.at(y).value});
    top = std::min(top, down[0] * y + down[1] * outline.profile.back()[1]);
  }
  const auto upright = [&](const SectionPoint& p) -> SectionPoint {
    return {across[0] * p[0] + across[1] * p[1], down[0] * p[0] + down[1] * p[1] - top};
  };
  const auto patch = [&](const SectionPoint& p) -> SectionPoint {
    return {across[0] * p[0] + down[0] * (p[1] + top), across[1] * p[0] + down[1] * (p[1] + top)};
  };
  const SectionPoint left = upright(outline.profile.front());
  const SectionPoint right = upright(outline.profile.back());
  const auto is_side = [&](double y) {
    const double slope = rail.at(y).slope;
    return std::abs(down[0] + slope * down[1]) / std::hypot(1.0, slope) > steep_side;
  };
  const bool left_side = is_side(rail.first());
  const bool right_side = is_side(rail.last());
  double middle = 0.5 * (left[0] + right[0]);
  if (left_side && !right_side) middle = left[0] + head_half;
  if (right_side && !left_side) middle = right[0] - head_half;

  const double deepest_end = std::max({left[1], right[1], underside});
  const double cut = std::min(stand.cut_depth, below_head.back()[1]);
  if (!(cut > deepest_end))
    throw contact::InputError(
        fmt::format("fem.depth = {} mm cuts the rail inside its head; allowed: more than {:.4g} mm "
                    "below its top (172: the whole rail); do: enlarge it",
                    stand.cut_depth, deepest_end));
  outline.around.push_back(outline.profile.back());
  for (const SectionPoint& p : side_below(right, middle, 1.0, cut))
    outline.around.push_back(patch(p));
  outline.held = outline.around.size() - 1;
  auto up = side_below(left, middle, -1.0, cut);
  for (auto p = up.rbegin(); p != up.rend(); ++p) outline.around.push_back(patch(*p));
  outline.around.push_back(outline.profile.front());
  return outline;
}

TrueSection rim_section(const contact::PatchGeometry& geometry, bool is_wheel,
                        double rim_thickness) {
  const AxleTrace axle = axle_trace(is_wheel ? geometry.axle() : geometry.rail_axle());
  const contact::HeightCurve& body = is_wheel ? geometry.wheel_radius() : geometry.rail_radius();
  const bool axle_below = !is_wheel && geometry.rail_rolling_radius() > 0.0;
  const bool ring = !is_wheel && !axle_below;
  const auto place = [&](double axial, double radius) -> SectionPoint {
    const double along = axial - axle.axial, down = axle_below ? -radius : radius;
    return {along * axle.cosine + down * axle.sine,
            axle.height + along * axle.sine - down * axle.cosine};
  };
  TrueSection outline;
  outline.inwards = is_wheel ? 1.0 : -1.0;
  const int count = contact::count_of(std::ceil((body.last() - body.first()) / profile_step),
                                      "points along a profile");
  double smallest = HUGE_VAL, largest = 0.0;
  for (int k = 0; k <= count; ++k) {
    const double axial = body.first() + (body.last() - body.first()) * k / count;
    const double radius = body.at(axial).value;
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
    outline.profile.push_back(place(axial, radius));
  }
  const double here =
      is_wheel ? geometry.local_rolling_radius(0.0) : std::abs(geometry.local_rail_radius(0.0));
  const double inner = ring ? here + rim_thickness : here - rim_thickness;
  if (!(ring ? inner > largest + 5.0 : inner > 0.0 && inner < smallest - 5.0))
    throw contact::InputError(
        fmt::format("fem.rim_thickness = {} mm leaves no rim: the {}'s radius is {:.4g} mm at "
                    "the contact and {:.4g} mm at its {}; do: give a thickness between these",
                    rim_thickness, is_wheel ? "wheel" : "rail", here, ring ? largest : smallest,
                    ring ? "largest" : "smallest"));
  outline.around = {outline.profile.back(), place(body.last(), inner), place(body.first(), inner),
                    outline.profile.front()};
  outline.held = 1;
  return outline;
}

}  // namespace rollfem::meshes
