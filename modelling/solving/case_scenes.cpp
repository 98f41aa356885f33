// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/solving/case_scenes.hpp"

#include "track/motion/placed_scenes.hpp"
#include "track/placement/placement.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace rollfem::modelling {

namespace {

using contact::Case;

/// Points of a curve for drawing, moved into the track frame.
template <class Move>
std::vector<std::array<double, 2>> drawn(const profiles::ProfileCurve& curve, int pieces,
                                         const Move& moved) {
  std::vector<std::array<double, 2>> points;
  for (int k = 0; k <= pieces; ++k)
    points.push_back(moved(curve.at(curve.first() + (curve.last() - curve.first()) * k / pieces)));
  return points;
}

/// From the side frame (Y outward).
std::vector<std::array<double, 2>> on_track(const profiles::ProfileCurve& curve, bool left) {
  return drawn(curve, 600, [&](const profiles::ProfilePoint& at) {
    return std::array{track::side_sign(left) * at.y, at.z};
  });
}

/// Section of the wheel through its axle, tilted like the axle.
std::vector<std::array<double, 2>> wheel_on_track(const Case& input,
                                                  const profiles::ProfileCurve& wheel,
                                                  const track::WheelRailContact& contact) {
  const bool left = contact.place.left;
  const contact::Axle axle = track::place_axle(contact.pose, input, left);
  // Unit vector downwards from the axle, perpendicular to it.
  const double length = std::hypot(axle.direction[1], axle.direction[2]);
  const std::array<double, 2> along{axle.direction[1] / length, axle.direction[2] / length};
  const std::array<double, 2> down{-along[1], along[0]};
  return drawn(wheel, 800, [&](const profiles::ProfilePoint& at) {
    const double radius = input.wheel.rolling_radius + at.z;
    const double y = axle.point[1] + along[0] * at.y + down[0] * radius;
    const double z = axle.point[2] + along[1] * at.y + down[1] * radius;
    return std::array{track::side_sign(left) * y, z};
  });
}

std::vector<result::PlacedPair> drawn_pairs(const Case& input, const track::SearchScene& search,
                                            const std::vector<track::PlacedScene>& scenes) {
  std::vector<result::PlacedPair> pairs;
  for (const track::PlacedScene& scene : scenes) {
    const contact::ContactPlace& place = scene.contact.place;
    const bool wanted = !input.is_wheel_history() ||
                        input.output.keeps_grid(static_cast<std::size_t>(place.position) - 1,
                                                input.wheelset.positions());
    if (place.patch != 1 || !wanted) continue;
    // Of bodies that change along their way, the sections at the axle.
    const auto section = [&](const auto& surface, const std::vector<double>& ways,
                             const profiles::ProfileCurve& same) {
      if (!surface) return same;
      return surface->section(ways.empty() ? 0.0
                                           : ways.at(static_cast<std::size_t>(place.position) - 1));
    };
    const track::SearchScene::Rail& rail = search.rail(place.left);
    pairs.push_back(
        {place.left, place.position,
         on_track(section(rail.surface, input.wheelset.track_position, rail.curve), place.left),
         wheel_on_track(input,
                        section(search.profiles.wheel_sections, input.wheelset.wheel_angle,
                                search.profiles.wheel),
                        scene.contact)});
  }
  return pairs;
}

}  // namespace

Placed placed_wheels(const Case& input) {
  if (!input.has_profiles()) return {};
  return std::make_shared<const track::PlacedWheels>(track::place_for_balance(input));
}

Case on_common_surface(Case input) {
  input.surface = contact::SurfaceForm::curved;
  return input;
}

Scenes scenes_of(const Case& input, const Placed& placed, const contact::Progress& progress,
                 contact::Checkpoint* kept, contact::RunPart own) {
  if (!placed) return {{contact::Scene(input)}, {}, {}};
  track::BalancedCase balanced = track::balance(input, *placed, progress, kept, own);
  return {std::move(balanced.scenes), drawn_pairs(input, placed->search, balanced.placed),
          std::move(balanced.notes)};
}

std::vector<std::pair<std::string, std::string>> pair_tables(const Case& input,
                                                             const track::SearchScene& search) {
  Case first = input;
  first.wheelset.lateral_shift.resize(1);
  first.wheelset.yaw.resize(1);
  for (auto* list : {&first.wheelset.roll, &first.wheelset.height, &first.wheelset.track_position,
                     &first.wheelset.wheel_angle})
    if (!list->empty()) list->resize(1);
  const std::vector<track::PlacedScene> scenes = track::make_scenes(first, search);
  std::vector<std::pair<std::string, std::string>> tables;
  for (const result::PlacedPair& pair : drawn_pairs(first, search, scenes)) {
    const char* side = contact::side_word(pair.left);
    std::string text = fmt::format("# {} wheel, lateral shift {:g} mm\n", side,
                                   first.wheelset.lateral_shift.front());
    text += "part,y [mm],z [mm],angle [rad],radius [mm]\n";
    for (const auto& [part, points] : {std::pair{"rail", &pair.rail}, {"wheel", &pair.wheel}})
      for (const auto& point : *points)
        text += fmt::format("{},{:.6f},{:.6f},,\n", part, point[0], point[1]);
    for (const track::PlacedScene& scene : scenes) {
      const contact::ContactPlace& place = scene.contact.place;
      if (place.left == pair.left)
        text += fmt::format("patch {},{:.6f},{:.6f},{:.8f},{:.6f}\n", place.patch, place.y_track,
                            place.z_track, place.contact_angle, place.rolling_radius);
    }
    tables.emplace_back(fmt::format("pair_{}", side), std::move(text));
  }
  return tables;
}

std::string contacts_text(const Case& input, const track::SearchScene& search) {
  std::string text =
      fmt::format("{:<7}{:>9}{:>7}{:>11}{:>12}{:>12}{:>12}{:>11}{:>12}{:>15}\n", "wheel",
                  "position", "patch", "roll mrad", "y track mm", "y rail mm", "y wheel mm",
                  "angle rad", "radius mm", "separation mm");
  for (const track::WheelRailContact& contact : track::place_wheels(input, search)) {
    const contact::ContactPlace& at = contact.place;
    text += fmt::format(
        "{:<7}{:>9}{:>7}{:>11.4f}{:>12.4f}{:>12.4f}{:>12.4f}{:>11.5f}{:>12.4f}{:>15.4f}\n",
        at.side(), at.position, at.patch > 0 ? std::to_string(at.patch) : std::string("near"),
        1e3 * at.roll, at.y_track, at.y_rail, at.y_wheel, at.contact_angle, at.rolling_radius,
        at.separation);
  }
  return text;
}

std::vector<contact::Scene> unbalanced_scenes(const Case& input, const Placed& placed) {
  if (!placed) return {contact::Scene(input)};
  std::vector<contact::Scene> scenes;
  for (const track::PlacedScene& scene : placed->scenes)
    if (track::asked_for(input, scene)) scenes.push_back(scene.scene);
  return scenes;
}

}  // namespace rollfem::modelling
