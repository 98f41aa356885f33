// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/balance.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "result/record.hpp"
#include "track/balance/flange_bending.hpp"
#include "track/balance/position.hpp"
#include "track/balance/springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace rollfem::track {

using contact::Case;
using contact::FreeRolling;
using contact::ModelResult;
using contact::PointResult;
using contact::Record;
using contact::WheelSide;

namespace {

bool asked_for(const Case& input, bool left) {
  return input.wheelset.side == WheelSide::both || (input.wheelset.side == WheelSide::left) == left;
}

/// A failure in a long sweep names its position.
contact::FailurePlace where(const Case& input, int position) {
  return {file_of(input),
          input.wheelset.positions() > 1 ? fmt::format("position {}", position) : ""};
}

std::vector<contact::Note> notes_of(const Case& input) {
  std::vector<contact::Note> notes;
  const std::string by_the_balance =
      "found by the half-space with 24 elements across; other models and grids retain a small "
      "force at these creepages";
  if (input.load.vertical_force)
    notes.push_back({"vertical_force", "the vertical force of each wheel includes friction"});
  if (input.wheelset.free_rolling == FreeRolling::torque)
    notes.push_back(
        {"free_rolling",
         fmt::format("the rotation is that at which the wheelset has {} torque about "
                     "its axle, {}",
                     input.wheelset.axle_torque.empty() ? "no" : "the given", by_the_balance)});
  if (input.wheelset.free_rolling == FreeRolling::force)
    notes.push_back({"free_rolling",
                     fmt::format("each wheel turns so that it transmits {} longitudinal force, {}",
                                 input.wheelset.longitudinal_force.empty() ? "no" : "the given",
                                 by_the_balance)});
  return notes;
}

/// All values of a placed scene that the balance changes.
void exchange(Record& record, contact::Scene& scene) {
  record.values(scene.place->patch, scene.place->patches, scene.turns_freely,
                scene.neighbour_loads);
  for (contact::LoadPoint& point : scene.points)
    record.values(point.load.force, point.load.approach, point.load.direction, point.creepage,
                  point.creepage_error);
}

/// Index of the placed patch from which a scene was made: its position on the track stays the same.
std::size_t source_of(const std::vector<PlacedScene>& placed, const contact::Scene& scene) {
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const contact::ContactPlace& place = *placed[i].scene.place;
    if (place.left == scene.place->left && place.y_track == scene.place->y_track) return i;
  }
  throw std::runtime_error("a balanced patch was not placed");
}

/// The scenes of a balance, made of the patches `placed` of its position: their record, or the same
/// scenes from it, bit for bit.
void exchange(Record& record, const std::vector<PlacedScene>& placed,
              std::vector<contact::Scene>& balanced) {
  std::size_t count = balanced.size();
  record.value(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t source = record.reading() ? 0 : source_of(placed, balanced[k]);
    record.value(source);
    if (record.reading()) balanced.push_back(placed.at(source).scene);
    exchange(record, balanced[k]);
  }
}

/// The balance of one position, restored or computed; balances that are faster to recompute than to
/// read are not stored.
std::vector<contact::Scene> kept_or_balanced(const Case& input, int position,
                                             const std::vector<PlacedScene>& here,
                                             contact::Checkpoint* kept) {
  const std::string name = fmt::format("balance-{}", position);
  std::vector<contact::Scene> scenes;
  if (kept != nullptr &&
      contact::found(*kept, name, [&](Record& record) { exchange(record, here, scenes); }))
    return scenes;
  constexpr auto worth_keeping = std::chrono::milliseconds(50);
  const auto begin = std::chrono::steady_clock::now();
  scenes = contact::at_place(where(input, position), [&] {
    return balanced_position(case_at(input, static_cast<std::size_t>(position) - 1), here);
  });
  if (kept != nullptr && std::chrono::steady_clock::now() - begin > worth_keeping) {
    Record record;
    exchange(record, here, scenes);
    kept->keep(name, record.bytes());
  }
  return scenes;
}

/// One position.
struct Balanced {
  std::vector<PlacedScene> here;
  std::vector<contact::Scene> patches;
  std::vector<contact::Note> notes;
  RailVector rail_moved{};
};

}  // namespace

std::vector<WheelRailContact> place_wheels(const Case& input, const SearchScene& scene) {
  std::vector<std::vector<WheelRailContact>> at(input.wheelset.positions());
  contact::for_each_index(at.size(), [&](std::size_t k) {
    const int position = static_cast<int>(k) + 1;
    at[k] = contact::at_place(where(input, position),
                              [&] { return find_contacts(input, scene, position); });
  });
  std::vector<WheelRailContact> all;
  for (std::vector<WheelRailContact>& here : at)
    std::move(here.begin(), here.end(), std::back_inserter(all));
  return all;
}

PlacedWheels place_for_balance(const Case& input) {
  Case all_sides = input;
  if (input.wheelset.free_rolling == FreeRolling::torque && input.wheelset.axle_torque.empty())
    all_sides.wheelset.side = WheelSide::both;
  SearchOptions options;
  options.with_reserve = input.load.vertical_force.has_value();
  PlacedWheels placed;
  placed.search = search_scene_of(input);
  // Where springs hold the rail is found in the balance.
  if (!input.track.rail_stiffness) placed.scenes = make_scenes(all_sides, placed.search, options);
  return placed;
}

bool asked_for(const Case& input, const PlacedScene& scene) {
  const contact::ContactPlace& place = scene.contact.place;
  return place.patch > 0 && asked_for(input, place.left);
}

BalancedCase balance(const Case& input) {
  return balance(input, place_for_balance(input));
}

BalancedCase balance(const Case& input, const PlacedWheels& placed,
                     const contact::Progress& progress, contact::Checkpoint* kept,
                     contact::RunPart own) {
  BalancedCase result;
  result.notes = notes_of(input);
  const int count = static_cast<int>(input.wheelset.positions());
  contact::ProgressEvent event;
  event.model = "wheelset";
  event.stage = "balance";
  std::vector<Balanced> positions(static_cast<std::size_t>(count));
  contact::for_each_index(positions.size(), [&](std::size_t k) {
    if (!own.holds(k)) return;
    const int position = static_cast<int>(k) + 1;
    contact::ProgressEvent begins = event;
    begins.note = fmt::format("position {} of {}", position, count);
    contact::report(progress, begins);
    Balanced& at = positions[k];
    for (const PlacedScene& scene : placed.scenes)
      if (scene.contact.place.position == position) at.here.push_back(scene);
    if (input.track.rail_stiffness) {
      RailVector& moved = at.rail_moved;
      WheelOnRail wheel = contact::at_place(where(input, position), [&] {
        return on_springs(case_at(input, k), placed.search, position, moved);
      });
      at.here = std::move(wheel.placed);
      at.patches = std::move(wheel.balanced);
      if (!input.is_wheel_history()) at.notes.push_back({"rail_springs", springs_text(moved)});
    } else {
      at.patches = kept_or_balanced(input, position, at.here, kept);
    }
    for (contact::Note& note : bending_notes(input, at.patches))
      at.notes.push_back(std::move(note));
  });
  for (Balanced& at : positions) {
    result.rail_moved = at.rail_moved;
    std::move(at.notes.begin(), at.notes.end(), std::back_inserter(result.notes));
    for (contact::Scene& patch : at.patches)
      if (asked_for(input, patch.place->left)) result.scenes.push_back(std::move(patch));
    for (const PlacedScene& scene : at.here)
      if (asked_for(input, scene)) result.placed.push_back(scene);
  }
  event.finished = true;
  contact::report(progress, event);
  return result;
}

std::vector<std::string> untouched_wheels(const Case& input, const PlacedWheels& placed) {
  std::vector<std::string> texts;
  if (input.track.rail_stiffness) return texts;
  for (std::size_t k = 0; k < input.wheelset.height.size(); ++k)
    for (const bool left : {true, false}) {
      const int position = static_cast<int>(k) + 1;
      const auto is_here = [&](const PlacedScene& scene) {
        return scene.contact.place.left == left && scene.contact.place.position == position;
      };
      if (!asked_for(input, left) ||
          std::any_of(placed.scenes.begin(), placed.scenes.end(), is_here))
        continue;
      WheelsetPose pose = find_pose(input, placed.search, position);
      touching_gap(input, placed.search, pose, position, left);
      texts.push_back(
          fmt::format("{}the {} wheel is {:.4g} mm above its rail and carries no load",
                      input.wheelset.positions() > 1 ? fmt::format("position {}: ", position) : "",
                      contact::side_word(left), pose.height - input.wheelset.height[k]));
    }
  return texts;
}

namespace {

/// Relative to the load. Models balance their own load to 1e-6; shares of a wheel add another
/// rounding.
constexpr double sum_tolerance = 1e-5;

template <class Error = contact::SolveError>
[[noreturn]] void refuse(const contact::Case& input, const ModelResult& result,
                         const std::string& what) {
  throw Error(
      {file_of(input)},
      "{}: model {}: {}: this is not a valid result; do: please report the case as a defect of "
      "the program",
      result.place->label(), result.name, what);
}

/// Range of the elements with pressure, y of the grid in mm.
std::array<double, 2> loaded_rows(const ModelResult& result, const PointResult& point) {
  std::array<double, 2> rows{contact::infinity, -contact::infinity};
  const contact::ContactGrid& grid = result.grid;
  const contact::Field& pressure = point.fields.traction.n;
  if (pressure.size() != grid.size()) return rows;
  for (int j = 0; j < grid.ny; ++j) {
    if (!(pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0)) continue;
    rows[0] = std::min(rows[0], grid.y(j) - 0.5 * grid.dy);
    rows[1] = std::max(rows[1], grid.y(j) + 0.5 * grid.dy);
  }
  return rows;
}

/// The same across the track, from the middle outward; border elements count half because the
/// contact ends within them.
std::array<double, 2> across_track(const ModelResult& result, const PointResult& point) {
  const auto rows = loaded_rows(result, point);
  // y of the patch frame points to the field on the left and to the middle on the right.
  const double outward = result.place->left ? 1.0 : -1.0;
  const double cosine = std::cos(result.place->contact_angle);
  const double origin = std::abs(result.place->y_track);
  const double a = origin + outward * cosine * (rows[0] + 0.5 * result.grid.dy);
  const double b = origin + outward * cosine * (rows[1] - 0.5 * result.grid.dy);
  return {std::min(a, b), std::max(a, b)};
}

void check_alone(const contact::Case& input, const ModelResult& result) {
  const contact::ContactGrid& grid = result.grid;
  const auto holds = [](double first, double cell, int count) {
    return first - 0.5 * cell <= 1e-9 && first + (count - 0.5) * cell >= -1e-9;
  };
  if (grid.size() > 0 &&
      !(holds(grid.x_first, grid.dx, grid.nx) && holds(grid.y_first, grid.dy, grid.ny)))
    refuse(
        input, result,
        fmt::format("its grid, from y = {:.4g} to {:.4g} mm, does not contain its reference point",
                    grid.y_first, grid.y(grid.ny - 1)));
  for (const PointResult& point : result.points)
    if (!(point.approach >= 0.0))
      refuse(input, result, fmt::format("the approach is {:.4g} mm", point.approach));
}

std::optional<double> load_of(const contact::Case& input, const contact::ContactPlace& place) {
  const auto k = static_cast<std::size_t>(place.position) - 1;
  if (input.is_wheel_history() && input.history.at(k).vertical_force)
    return input.history[k].vertical_force;
  return input.load.vertical_force;
}

void check_wheel(const contact::Case& input, const std::vector<const ModelResult*>& contacts) {
  const ModelResult& first = *contacts.front();
  for (std::size_t k = 0; k < first.points.size(); ++k) {
    double vertical = 0.0;
    bool known = true;
    for (const ModelResult* result : contacts) {
      if (k >= result->points.size()) return;
      known = known && result->points[k].vertical_force.has_value();
      vertical += result->points[k].vertical_force.value_or(0.0);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i)
      for (std::size_t j = i + 1; j < contacts.size(); ++j) {
        const auto a = across_track(*contacts[i], contacts[i]->points[k]);
        const auto b = across_track(*contacts[j], contacts[j]->points[k]);
        if (std::max(a[0], b[0]) < std::min(a[1], b[1]))
          refuse<contact::ConformalContact>(
              input, *contacts[j],
              fmt::format("it overlaps {}: both have pressure between {:.3f} and {:.3f} mm from "
                          "the middle of the track",
                          contacts[i]->place->label(), std::max(a[0], b[0]), std::min(a[1], b[1])));
      }
    const std::optional<double> load = load_of(input, *first.place);
    if (known && load && std::abs(vertical - *load) > sum_tolerance * *load)
      refuse(
          input, first,
          fmt::format("the vertical forces of {} contacts add up to {:.6g} N, the load is {:g} N",
                      contacts.size(), vertical, *load));
  }
}

}  // namespace

void check_results(const contact::Case& input, const std::vector<ModelResult>& results) {
  for (const ModelResult& result : results) {
    if (!result.place) continue;
    check_alone(input, result);
    std::vector<const ModelResult*> wheel;
    for (const ModelResult& other : results)
      if (other.place && other.name == result.name && other.place->same_wheel(*result.place))
        wheel.push_back(&other);
    if (wheel.front() == &result) check_wheel(input, wheel);
  }
}

}  // namespace rollfem::track
