#include "track/motion/loaded_height.hpp"

#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace rollfem::track {

namespace {

/// mm, of the way sideways: separations are known to a third of that or better.
constexpr double way_tolerance = 1e-5;
constexpr int most_rounds = 4;

/// Approaches of the contacts along their normals, mm; 0 where one does not touch.
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
  std::vector<double> stands(wheel.size(), 0.0);
  try {
    for (int round = 0; round < most_rounds; ++round) {
      const std::vector<double> found = approaches(input, wheel);
      double change = 0.0;
      for (std::size_t i = 0; i < wheel.size(); ++i) {
        const WheelRailContact& contact = wheel[i].contact;
        if (found[i] > contact.next_hump)
          change = std::max(change, std::abs(found[i] - stands[i]) *
                                        std::tan(std::abs(contact.place.contact_angle)));
      }
      if (change <= way_tolerance) return;
      for (std::size_t i = 0; i < wheel.size(); ++i)
        if (found[i] > wheel[i].contact.next_hump) stand_at(stands[i] = found[i], wheel[i]);
    }
  } catch (const std::runtime_error&) {
    // What is wrong with the contact is said where it is solved.
  }
}

}  // namespace rollfem::track
