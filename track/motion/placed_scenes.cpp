// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/motion/placed_scenes.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "profiles/profiles.hpp"
#include "profiles/section_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

namespace rollfem::track {

using contact::Case;
using contact::Creepage;

namespace {

/// Along the normal of the contact's plane, mm: at a given height, or as estimated.
double approach_of(const Case& input, const WheelRailContact& contact) {
  const contact::ContactPlace& place = contact.place;
  if (input.wheelset.height.empty()) return contact.approach;
  const double height = input.wheelset.height.at(static_cast<std::size_t>(place.position) - 1);
  return (height - contact.pose.height) * halfspace::upwards(place)[1] - place.separation;
}

/// The case's approach applies to the first patch; the others have the same sinking.
contact::NormalLoad load_of(const Case& input, const WheelRailContact& contact) {
  const contact::Load& load = input.load;
  if (input.sinks()) return {{}, approach_of(input, contact)};
  if (contact.place.patches > 1 && !load.vertical_force)
    throw contact::InputError(
        {file_of(input)},
        "load.normal_force: the {} wheel at position {} touches in {} patches, among which a "
        "normal force cannot be divided; allowed: load.vertical_force, carried by all of them "
        "together; do: write `vertical_force = {:.6g}` under [load]",
        contact.place.side(), contact.place.position, contact.place.patches,
        load.normal_force.value_or(0.0));
  if (contact.place.patches > 1) return {contact.normal_force, {}};
  if (load.vertical_force) return {load.vertical_force, {}, halfspace::upwards(contact.place)};
  return {load.normal_force, {}};
}

/// Below this spread of the normals (rad, standard deviation) the contact is treated as plane:
/// forces differ from those on the surface by at most 0.3 % of the load. From twice that on, every
/// row takes its own normal.
constexpr double spread_on_plane = 0.03;

/// Subsurface stresses use a plane half-space.
double follows_surface(const PlacedScene& placed) {
  const contact::Scene& scene = placed.scene;
  if (!scene.geometry.has_surfaces() || scene.given_pressure || scene.asks_for_stress()) return 0.0;
  return track::follows_surface(placed.contact.spread_of_normals);
}

PlacedScene make_scene(const Case& input, WheelRailContact contact) {
  PlacedScene placed{contact::Scene(input), std::move(contact)};
  const auto patch = std::make_shared<const contact::PatchGeometry>(placed.contact.geometry);
  placed.scene.geometry.surface = contact::ContactSurface::of(patch);
  placed.scene.place = placed.contact.place;
  if (!input.friction_variation.points.empty())
    placed.scene.friction_law =
        contact::friction_of(input, static_cast<std::size_t>(placed.contact.place.position) - 1,
                             [patch, place = placed.contact.place](double y) {
                               return contact::rail_inclination(*patch, place, y);
                             });
  if (input.surface == contact::SurfaceForm::automatic)
    placed.scene.follows_surface = follows_surface(placed);
  for (std::size_t k = 0; k < placed.scene.points.size(); ++k) {
    const bool by_step =
        k < input.history.size() && (input.history[k].normal_force || input.history[k].approach);
    if (!by_step) placed.scene.points[k].load = load_of(input, placed.contact);
  }
  set_rotation_changes(placed, input, rotation_changes(input));
  return placed;
}

// The height of a wheel under its load. Contacts are found at first touch with the rail; from there
// the wheel sinks vertically, and distances of several patches in one plane change by microns in
// addition to the approach along the plane's normal (docs/track.md).

/// Relative change of the approaches at which the iteration has converged.
constexpr double near_enough = 0.1;
constexpr int most_rounds = 4;

/// Approaches of the contacts along their normals, mm; 0 without contact.
std::vector<double> approaches(const contact::Case& input, const std::vector<PlacedScene>& wheel) {
  std::vector<double> found;
  if (wheel.size() == 1 || !input.load.vertical_force) {
    for (const PlacedScene& placed : wheel)
      found.push_back(input.sinks() ? approach_of(input, placed.contact)
                                    : halfspace::PatchSearch(placed.scene).patch().approach);
    return found;
  }
  std::vector<contact::Scene> scenes;
  for (const PlacedScene& placed : wheel) scenes.push_back(placed.scene);
  const double sinking = halfspace::share_load(scenes, *input.load.vertical_force).sinking;
  for (const PlacedScene& placed : wheel) {
    const contact::ContactPlace& place = placed.contact.place;
    found.push_back(std::max(0.0, sinking * std::cos(place.contact_angle) - place.separation));
  }
  return found;
}

void stand_at(double approach, PlacedScene& placed) {
  contact::Scene& scene = placed.scene;
  const auto& along = scene.points.front().load.direction;
  scene.geometry.surface = contact::ContactSurface::of(
      std::make_shared<contact::PatchGeometry>(placed.contact.geometry.under_load(
          approach, halfspace::upwards(placed.contact.place), along)));
}

/// Moves the undeformed distances of one wheel's contacts at one position to the loaded height, for
/// contacts in which several humps overlap the rail; a single patch keeps the distances of first
/// touch. (For a single patch the lateral displacement, microns, is equivalent to a lateral shift
/// of that size.) The height comes from the half-space under the largest load, without friction.
void stand_under_load(const contact::Case& input, std::vector<PlacedScene>& wheel) {
  if (std::none_of(wheel.begin(), wheel.end(), [](const PlacedScene& placed) {
        return std::isfinite(placed.contact.next_hump) && !placed.scene.given_pressure;
      }))
    return;
  std::vector<double> stands(wheel.size(), 0.0), found;
  for (const PlacedScene& placed : wheel) found.push_back(placed.contact.approach);
  try {
    // Starts from the estimates: one search to half a per cent is enough where they are close.
    for (int round = 0; round < most_rounds; ++round) {
      double change = 0.0;
      for (std::size_t i = 0; i < wheel.size(); ++i) {
        const double wanted = found[i] > wheel[i].contact.next_hump ? found[i] : 0.0;
        if (wanted == stands[i]) continue;
        change = std::max(change, std::abs(wanted - stands[i]) / std::max(wanted, stands[i]));
        stand_at(stands[i] = wanted, wheel[i]);
      }
      if (round > 0 && change <= near_enough) return;
      found = approaches(input, wheel);
    }
  } catch (const contact::Failure&) {
    // Errors of the contact are reported when it is solved.
  }
}

}  // namespace

ProfilePair profiles_of(const Case& input) {
  ProfilePair pair;
  pair.wheel_sections = profiles::make_sections(input.wheel.profile, true, input.file);
  pair.rail_sections = profiles::make_sections(input.rail.profile, false, input.file);
  const bool turns = pair.wheel_sections && !input.wheelset.wheel_angle.empty();
  const bool moves = pair.rail_sections && !input.wheelset.track_position.empty();
  if (!turns) pair.wheel = profiles::profile_of_case(input, true);
  if (!moves) pair.rail = profiles::profile_of_case(input, false);
  take_first_sections(input, pair);
  return pair;
}

void take_first_sections(const Case& input, ProfilePair& pair) {
  const auto take = [](const auto& sections, const std::vector<double>& places, auto& profile) {
    if (sections && !places.empty()) profile = sections->section(places.front());
  };
  take(pair.wheel_sections, input.wheelset.wheel_angle, pair.wheel);
  take(pair.rail_sections, input.wheelset.track_position, pair.rail);
}

SearchScene search_scene_of(const Case& input) {
  return contact::at_place({file_of(input)},
                           [&] { return make_search_scene(input, profiles_of(input)); });
}

Case case_at(const Case& input, std::size_t k) {
  Case here = input;
  if (!input.is_wheel_history()) return here;
  const auto keep = [k](auto& entries) {
    if (!entries.empty()) entries = {entries.at(k)};
  };
  keep(here.rolling.creepages);
  keep(here.rolling.forces);
  keep(here.history);
  contact::Wheelset& wheelset = here.wheelset;
  for (auto* list :
       {&wheelset.rotation_change, &wheelset.longitudinal_force, &wheelset.axle_torque})
    keep(*list);
  here.starts_steady = input.starts_steady && k == 0;
  contact::HistoryStep& step = here.history.front();
  if (step.vertical_force) here.load.vertical_force = step.vertical_force;
  if (!input.moves_by_positions) return here;
  const bool rolls = input.rolling.problem == contact::Problem::transient;
  const auto change = [&](const std::vector<double>& list) {
    if (list.empty() || k == 0) return 0.0;
    return (list.at(k) - list.at(k - 1)) / (rolls ? step.step_length : 1.0);
  };
  here.wheelset.lateral_velocity = change(input.wheelset.lateral_shift);
  here.wheelset.yaw_velocity = change(input.wheelset.yaw);
  here.wheelset.roll_velocity = change(input.wheelset.roll);
  // Nothing rolls in a shift: the wheel turns as its position says.
  if (!rolls)
    here.wheelset.rotation_change = {
        change(input.wheelset.wheel_angle) * input.wheel.rolling_radius - 1.0};
  return here;
}

/// Blends from the plane to the surface as the spread of the normals grows, so that forces change
/// continuously.
double follows_surface(double spread_of_normals) {
  const double part = std::clamp(spread_of_normals / spread_on_plane - 1.0, 0.0, 1.0);
  return part * part * (3.0 - 2.0 * part);
}

std::vector<double> rotation_changes(const Case& input) {
  const auto& given = input.wheelset.rotation_change;
  std::vector<double> changes(input.rolling.creepages.size(), given.empty() ? 0.0 : given.front());
  if (given.size() > 1)
    for (std::size_t k = 0; k < changes.size(); ++k) changes[k] = given.at(k);
  return changes;
}

void set_rotation_changes(PlacedScene& placed, const Case& input,
                          const std::vector<double>& rotation_change) {
  std::vector<contact::LoadPoint>& points = placed.scene.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    Creepage& creepage = points[k].creepage;
    const Motion motion = motion_of(input, rotation_change[k]);
    const Creepage moving = input.rolling.extra_slip == contact::ExtraSlip::none ||
                                    input.rolling.problem == contact::Problem::shift
                                ? creepage_on_rail(placed.contact, motion)
                                : creepage_of(placed.contact, motion);
    const contact::HistoryStep step =
        k < input.history.size() ? input.history[k] : contact::HistoryStep();
    const double part = step.wheel_way ? *step.wheel_way / step.step_length : 1.0;
    if (!input.rolling.given.longitudinal) creepage.longitudinal = part * moving.longitudinal;
    if (!input.rolling.given.lateral) creepage.lateral = part * moving.lateral;
    if (!input.rolling.given.spin) creepage.spin = part * moving.spin;
    if (input.moves_by_positions && input.rolling.problem == contact::Problem::shift) {
      const Creepage rest = creepage_on_rail(placed.contact, {});  // of forward motion alone
      points[k].longitudinal_shift =
          step.longitudinal_shift + moving.longitudinal - rest.longitudinal;
      points[k].lateral_shift = step.lateral_shift + moving.lateral - rest.lateral;
      points[k].spin_shift = step.spin_shift + moving.spin - rest.spin;
    }
    // A prescribed force replaces the creepage in its direction.
    if (points[k].force.longitudinal) creepage.longitudinal = 0.0;
    if (points[k].force.lateral) creepage.lateral = 0.0;
  }
}

std::vector<PlacedScene> scenes_at(const Case& here, const SearchScene& scene, int position,
                                   const SearchOptions& options) {
  std::vector<PlacedScene> left, right;
  for (WheelRailContact& contact : find_contacts(here, scene, position, options))
    if (contact.place.patch > 0 || (contact.reserve && options.with_reserve))
      (contact.place.left ? left : right).push_back(contact::at_place({file_of(here)}, [&] {
        return make_scene(here, std::move(contact));
      }));
  for (std::vector<PlacedScene>* wheel : {&left, &right}) stand_under_load(here, *wheel);
  std::move(right.begin(), right.end(), std::back_inserter(left));
  return left;
}

std::vector<PlacedScene> make_scenes(const Case& input, const SearchScene& scene,
                                     const SearchOptions& options) {
  std::vector<std::vector<PlacedScene>> at(input.wheelset.positions());
  contact::for_each_index(at.size(), [&](std::size_t k) {
    at[k] = scenes_at(case_at(input, k), scene, static_cast<int>(k) + 1, options);
  });
  std::vector<PlacedScene> scenes;
  for (std::vector<PlacedScene>& here : at)
    std::move(here.begin(), here.end(), std::back_inserter(scenes));
  return scenes;
}

const WheelRailContact& contact_of(const contact::Scene& scene,
                                   const std::vector<PlacedScene>& placed) {
  const auto found = std::find_if(placed.begin(), placed.end(), [&](const PlacedScene& one) {
    const contact::ContactPlace& place = one.contact.place;
    return place.y_track == scene.place->y_track && place.position == scene.place->position;
  });
  if (found == placed.end()) throw std::logic_error("a contact in balance that was not found");
  return found->contact;
}

std::vector<PlacedScene> make_scenes(const Case& input, const SearchOptions& options) {
  return make_scenes(input, search_scene_of(input), options);
}

double track_y(const contact::ContactPlace& place, double y) {
  // y of the patch frame points to the field on the left and to the middle on the right: always
  // to smaller y_track.
  return place.y_track - y * std::cos(place.contact_angle);
}

}  // namespace rollfem::track
