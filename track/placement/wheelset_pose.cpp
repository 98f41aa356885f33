// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/placement/wheelset_pose.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::track {

using contact::Axle;
using contact::Case;

std::string file_of(const Case& input) {
  return input.file.empty() ? "case" : input.file;
}

namespace {

contact::FailurePlace where(const Case& input, int position, bool left) {
  return {
      file_of(input),
      fmt::format("{} = {:.6g} (position {}), {} wheel",
                  input.wheelset.on_rail ? "placement.lateral_position" : "wheelset.lateral_shift",
                  input.wheelset.lateral_shift.at(static_cast<std::size_t>(position - 1)), position,
                  contact::side_word(left))};
}

/// Keys that a user may have set wrongly, for messages.
const char* place_keys(const Case& input) {
  return input.wheelset.on_rail ? "lateral_position"
                                : "gauge, flange_back_distance and lateral_shift";
}

constexpr int most_lowerings = 10;

/// The tape line, wherever the profile has its origin; that origin where the profile does not reach
/// the tape line, as treads of rigs may.
double tread_of(const contact::Wheelset& wheelset, const profiles::ProfileCurve& wheel) {
  constexpr double tape_line = 70.0;  // mm from the back of the flange
  const double y = wheelset.flange_back_position + tape_line;
  return y > wheel.at(wheel.first()).y && y < wheel.at(wheel.last()).y ? y : 0.0;
}

/// Rejects a wheel that stands on the end of a profile or on its flange.
void check_support(const Case& input, const SearchScene& scene, const VerticalGap& gap,
                   int position, bool left) {
  const GapEnd end = gap.end();
  if (end != GapEnd::none)
    fail_at_end(input, gap, end == GapEnd::inner, position, left,
                "wheel and rail would first touch at");
  const OutlinePoint first = gap.wheel().at(gap.lowest().y);
  const auto& knots = scene.profiles.wheel.knots();
  const auto tip = std::max_element(knots.begin(), knots.end(),
                                    [](const auto& a, const auto& b) { return a.z < b.z; });
  // A profile without flange is highest at its end.
  const bool has_flange = tip != knots.begin() && tip->y < scene.tread_y && tip->z > 10.0;
  // Contact further down the flange (climbing) is a valid position.
  constexpr double tip_height = 2.0;
  const double height = first.radius - input.wheel.rolling_radius;
  if (has_flange && first.profile_y < scene.tread_y && height > tip->z - tip_height)
    throw contact::SolveError(
        where(input, position, left),
        "the wheel stands on the tip of its flange (wheel y = {:.2f} mm) and has "
        "left the rail; do: check {}",
        first.profile_y, place_keys(input));
}

}  // namespace

std::shared_ptr<const BodiesAlongWay> bodies_along_way(const Case& input, const SearchScene& scene,
                                                       const Axle& axle, int position, bool left) {
  const auto k = static_cast<std::size_t>(position - 1);
  const contact::Wheelset& wheelset = input.wheelset;
  const auto at = [k](const std::vector<double>& list) { return list.empty() ? 0.0 : list.at(k); };
  return std::make_shared<const BodiesAlongWay>(
      BodiesAlongWay::Sections{scene.rail(left).surface, scene.profiles.wheel_sections,
                               at(wheelset.track_position), at(wheelset.wheel_angle),
                               input.rail.rolling_radius,
                               roller_axle(scene.rail(left).place, input.rail.rolling_radius)},
      scene.rail(left).curve, scene.profiles.wheel, input.wheel.rolling_radius, axle,
      scene.tread_y);
}

namespace {

/// The gap under a wheel at a pose. Throws contact::SolveError when it is not above its rail.
VerticalGap make_gap(const Case& input, const SearchScene& scene, const WheelsetPose& pose,
                     int position, bool left) {
  const Axle axle = place_axle(pose, input, left);
  try {
    if (scene.varies()) return VerticalGap(bodies_along_way(input, scene, axle, position, left));
    return {scene.wheel, input.wheel.rolling_radius, axle, scene.rail(left).head,
            roller_axle(scene.rail(left).place, input.rail.rolling_radius).point[2]};
  } catch (const contact::SolveError& error) {
    throw contact::SolveError(where(input, position, left), "{}; do: check {}", error.what(),
                              place_keys(input));
  }
}

/// Roll at which both wheels touch at the same height: the possible sinking of the left wheel less
/// that of the right wheel increases with roll, by twice the distance of the rails per radian.
double touching_roll(const Case& input, const SearchScene& scene, WheelsetPose pose, int position) {
  const auto difference = [&](double roll) {
    pose.roll = roll;
    return make_gap(input, scene, pose, position, true).smallest() -
           make_gap(input, scene, pose, position, false).smallest();
  };
  // The first step is according to the expected slope.
  const double slope = input.track.gauge + 65.0, upright = difference(0.0);
  constexpr double largest_roll = 0.1;
  const auto roll = contact::root_from(difference, 0.0, upright, -1.2 * upright / slope,
                                       largest_roll, 1e-13, "roll of the wheelset");
  if (roll) return *roll;
  throw contact::SolveError(
      where(input, position, true),
      "no roll of the wheelset below {} rad lets both wheels touch their rails; do: check "
      "gauge, flange_back_distance and lateral_shift, or give wheelset.roll",
      largest_roll);
}

}  // namespace

void fail_where_head_ends(const Case& input, int position, bool left) {
  throw contact::SolveError(
      where(input, position, left),
      "under its load the patch reaches the place along the track where a head of the rail "
      "begins or ends; allowed: patches on heads that go on; do: let the sections of the head "
      "begin earlier or end later, or change track_position");
}

[[noreturn]] void fail_at_end(const Case& input, const VerticalGap& gap, bool inner, int position,
                              bool left, const std::string& what) {
  const contact::HeightCurve& wheel = gap.wheel().curve();
  const bool wheel_ends =
      inner ? wheel.first() > gap.rail().first() : wheel.last() < gap.rail().last();
  throw contact::InputError(
      where(input, position, left),
      "{} the {} end of the {} profile, {:.2f} mm from the {}; allowed: "
      "profiles that extend beyond the contact on both sides, as a height over y; do: use a "
      "longer {} profile, or check {}, or put `free_ends = true` under [{}_profile] if the body "
      "ends there",
      what, inner ? "flange-side" : "field-side", wheel_ends ? "wheel" : "rail",
      inner ? gap.first() : gap.last(),
      input.wheelset.on_rail ? "origin of the rail's profile" : "middle of the track",
      wheel_ends ? "wheel" : "rail", place_keys(input), wheel_ends ? "wheel" : "rail");
}

VerticalGap touching_gap(const Case& input, const SearchScene& scene, WheelsetPose& pose,
                         int position, bool left) {
  pose.height = 0.0;
  VerticalGap gap = make_gap(input, scene, pose, position, left);
  check_support(input, scene, gap, position, left);
  pose.height = gap.smallest();
  gap.lower_wheel(pose.height);
  // On a roller ahead or behind its top the gap is not vertical.
  const auto off_top = [&] {
    return !gap.bodies() && gap.wheel().at(gap.lowest().y).along.sine != 0.0;
  };
  constexpr double touching = 1e-9;  // mm
  for (int step = 0; off_top() && std::isfinite(gap.lowest().gap); ++step) {
    gap = make_gap(input, scene, pose, position, left);
    const double left_over = gap.smallest();
    pose.height += left_over;
    gap.lower_wheel(left_over);
    if (std::abs(left_over) < touching) break;
    if (step == most_lowerings)
      throw contact::SolveError(
          where(input, position, left),
          "the height at which it touches its roller is not found in {} steps", most_lowerings);
  }
  return gap;
}

namespace {

/// Whether an upright wheelset can run on the placed rails: whether, at some lateral shift within
/// the play of a track, the wheel first touches above the lower part of its flange.
bool tread_touches(const Case& input, const SearchScene& scene) {
  constexpr double play = 10.0, step = 1.0;  // mm
  constexpr double flange = 10.0;            // mm below the tread
  for (double shift = -play; shift <= play; shift += step) {
    WheelsetPose pose;
    pose.lateral_shift = shift;
    try {
      const VerticalGap gap = touching_gap(input, scene, pose, 1, true);
      if (gap.wheel().at(gap.lowest().y).radius < input.wheel.rolling_radius + flange) return true;
    } catch (const contact::Failure&) {
      // The wheel cannot stand here.
    }
  }
  return false;
}

profiles::SectionSurface the_same_everywhere(const profiles::ProfileCurve& profile, double turn) {
  return {{{0.0, profile, {}}, {1.0, profile, {}}}, profiles::SectionSpline::through, turn};
}

/// Adds an irregularity to the sections of a body or, where it has none, to its profile.
void add_irregularity(const profiles::Irregularity& irregularity,
                      const profiles::ProfileCurve& profile, double turn,
                      std::shared_ptr<const profiles::SectionSurface>& sections) {
  if (!irregularity.height) return;
  const auto plain =
      sections
          ? sections
          : std::make_shared<const profiles::SectionSurface>(the_same_everywhere(profile, turn));
  sections = std::make_shared<const profiles::SectionSurface>(plain->with(irregularity));
}

}  // namespace

SearchScene make_search_scene(const Case& input, ProfilePair profiles) {
  SearchScene scene;
  add_irregularity(profiles::irregularity_of(input.wheel), profiles.wheel, 2.0 * contact::pi,
                   profiles.wheel_sections);
  add_irregularity(profiles::irregularity_of(input.rail), profiles.rail, 0.0,
                   profiles.rail_sections);
  scene.tread_y = tread_of(input.wheelset, profiles.wheel);
  scene.wheel = wheel_points(profiles.wheel, scene.tread_y);
  scene.profiles = std::move(profiles);
  contact::Track track = input.track;
  if (input.wheelset.on_rail) {
    track.inclination = 0.0;
    track.rail_position = {0.0, 0.0};
  }
  const auto place_at = [&](RailPlace place) {
    // A roller has its radius where its profile has z = 0.
    if (std::isfinite(input.rail.rolling_radius) && !track.rail_position) place.shift_z = 0.0;
    for (const bool left : {true, false}) {
      SearchScene::Rail& rail = scene.rails[left ? 0 : 1];
      rail.place = displaced(place, input, left);
      rail.curve = place_rail(scene.profiles.rail, rail.place);
      rail.head = rail_heights(rail.curve, rail.place.tops_and_grooves);
      if (const auto& sections = scene.profiles.rail_sections)
        rail.surface = std::make_shared<const profiles::SectionSurface>(
            sections->moved(rail.place.angle, rail.place.shift_y, rail.place.shift_z));
      else if (scene.profiles.wheel_sections && std::isfinite(input.rail.rolling_radius))
        rail.surface =
            std::make_shared<const profiles::SectionSurface>(the_same_everywhere(rail.curve, 0.0));
    }
  };
  const RailPlace found = rail_place(scene.profiles.rail, track, [&](const RailPlace& place) {
    place_at(place);
    return tread_touches(input, scene);
  });
  place_at(found);
  if (!track.rail_position)
    scene.gauge_face = profile_coordinates(found, 0.5 * track.gauge, track.gauge_height)[0];
  const profiles::ProfileCurve& wheel = scene.profiles.wheel;
  try {
    scene.wheel_tread = profiles::height_over_y(wheel, parameter_near(wheel, scene.tread_y, 0.0));
  } catch (const contact::SolveError&) {
    scene.wheel_tread = {};
  }
  return scene;
}

WheelsetPose find_pose(const Case& input, const SearchScene& scene, int position) {
  const auto k = static_cast<std::size_t>(position - 1);
  WheelsetPose pose;
  const contact::Wheelset& given = input.wheelset;
  const double sign = frame_sign(given);
  pose.lateral_shift = sign * given.lateral_shift.at(k);
  pose.yaw = sign * given.yaw.at(k);
  if (!given.roll.empty())
    pose.roll = sign * given.roll.at(k);
  else if (!given.on_rail)
    pose.roll = touching_roll(input, scene, pose, position);
  return pose;
}

}  // namespace rollfem::track
