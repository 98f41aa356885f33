// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/motion/loaded_height.hpp"

#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace rollfem::track {

namespace {

/// Relative change of the approaches at which the iteration has converged.
constexpr double near_enough = 0.1;
constexpr int most_rounds = 4;

/// Approaches of the contacts along their normals, mm; 0 without contact.
std::vector<double> approaches(const contact::Case& input, const std::vector<PlacedScene>& wheel) {
  std::vector<double> found;
  if (wheel.size() == 1 || !input.load.vertical_force) {
    for (const PlacedScene& placed : wheel)
      found.push_back(input.load.approach ? placed.contact.approach
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
  scene.geometry.surface = contact::ContactSurface::of(std::make_shared<contact::PatchGeometry>(
      placed.contact.geometry.under_load(approach, upwards(placed.contact.place), along)));
}

}  // namespace

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
  } catch (const std::runtime_error&) {
    // Errors of the contact are reported when it is solved.
  }
}

}  // namespace rollfem::track
