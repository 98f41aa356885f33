#include "track/balance/balance.hpp"

#include "contact/base/errors.hpp"
#include "track/balance/position.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace rollfem::track {

using contact::Case;
using contact::FreeRolling;
using contact::WheelSide;

namespace {

bool asked_for(const Case& input, bool left) {
  return input.wheelset.side == WheelSide::both || (input.wheelset.side == WheelSide::left) == left;
}

/// A long row says where it failed.
template <class Work>
auto at_position(const Case& input, int position, const Work& work) {
  const auto where = [&](const std::exception& error) {
    return input.wheelset.positions() > 1 ? fmt::format("position {}: {}", position, error.what())
                                          : std::string(error.what());
  };
  try {
    return work();
  } catch (const contact::SolveError& error) {
    throw contact::SolveError(where(error));
  } catch (const contact::InputError& error) {
    throw contact::InputError(where(error));
  }
}

std::vector<std::string> notes_of(const Case& input) {
  std::vector<std::string> notes;
  const std::string by_the_balance =
      "found by the half-space with 24 elements across; other models and grids retain a small "
      "force at these creepages";
  if (input.load.vertical_force)
    notes.emplace_back("the vertical force of each wheel includes friction");
  if (input.wheelset.free_rolling == FreeRolling::torque)
    notes.push_back("the rotation is that at which the wheelset has no torque about its axle, " +
                    by_the_balance);
  if (input.wheelset.free_rolling == FreeRolling::force)
    notes.push_back("each wheel turns so that it transmits no longitudinal force, " +
                    by_the_balance);
  return notes;
}

}  // namespace

std::vector<WheelRailContact> place_wheels(const Case& input, const SearchScene& scene) {
  std::vector<WheelRailContact> all;
  for (int position = 1; position <= static_cast<int>(input.wheelset.positions()); ++position) {
    auto contacts =
        at_position(input, position, [&] { return find_contacts(input, scene, position); });
    std::move(contacts.begin(), contacts.end(), std::back_inserter(all));
  }
  return all;
}

BalancedCase balance(const Case& input, const contact::Progress& progress) {
  BalancedCase result;
  result.notes = notes_of(input);
  const int count = static_cast<int>(input.wheelset.positions());
  Case all_sides = input;
  if (input.wheelset.free_rolling == FreeRolling::torque) all_sides.wheelset.side = WheelSide::both;
  result.search = search_scene_of(input);
  SearchOptions options;
  options.with_reserve = input.load.vertical_force.has_value();
  const std::vector<PlacedScene> placed = make_scenes(all_sides, result.search, options);
  for (int position = 1; position <= count; ++position) {
    contact::ProgressEvent event;
    event.model = "wheelset";
    event.stage = "balance";
    event.note = fmt::format("position {} of {}", position, count);
    contact::report(progress, event);
    std::vector<PlacedScene> here;
    for (const PlacedScene& scene : placed)
      if (scene.contact.place.position == position) here.push_back(scene);
    auto scenes = at_position(input, position, [&] { return balanced_position(input, here); });
    for (contact::Scene& patch : scenes)
      if (asked_for(input, patch.place->left)) result.scenes.push_back(std::move(patch));
    for (const PlacedScene& scene : here)
      if (asked_for(input, scene.contact.place.left)) result.placed.push_back(scene);
    event.finished = position == count;
    if (event.finished) contact::report(progress, event);
  }
  return result;
}

}  // namespace rollfem::track
