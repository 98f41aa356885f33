#include "meshes/track/scenes.hpp"

#include "contact/base/errors.hpp"
#include "meshes/profiles/profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace rollfem::meshes {

using contact::Case;
using contact::Creepage;

namespace {

void set_creepages(Case& input, const WheelRailContact& contact,
                   const std::vector<double>& rotation_change) {
  auto& creepages = input.rolling.creepages;
  for (std::size_t k = 0; k < creepages.size(); ++k) {
    const Creepage moving = creepage_of(contact, motion_of(input, rotation_change[k]));
    if (!input.rolling.given.longitudinal) creepages[k].longitudinal = moving.longitudinal;
    if (!input.rolling.given.lateral) creepages[k].lateral = moving.lateral;
    if (!input.rolling.given.spin) creepages[k].spin = moving.spin;
  }
  // A prescribed force stands in place of the creepage of its direction.
  for (std::size_t k = 0; k < input.rolling.forces.size() && k < creepages.size(); ++k) {
    if (input.rolling.forces[k].longitudinal) creepages[k].longitudinal = 0.0;
    if (input.rolling.forces[k].lateral) creepages[k].lateral = 0.0;
  }
}

void set_load(Case& input, const WheelRailContact& contact) {
  contact::Load& load = input.load;
  load.normal_forces.clear();
  if (load.approach) {
    // The case's approach is that of the first patch; the others share its sinking.
    load.approach = contact.approach;
    return;
  }
  if (contact.place.patches > 1 && !load.vertical_force)
    throw contact::InputError(fmt::format(
        "{}: load.normal_force: the {} wheel at position {} touches in {} patches, between which "
        "one normal force cannot be shared; allowed: load.vertical_force, which their sum carries; "
        "do: write `vertical_force = {:.6g}` under [load]",
        input.file.empty() ? "case" : input.file, contact.place.left ? "left" : "right",
        contact.place.position, contact.place.patches, load.normal_force.value_or(0.0)));
  if (contact.place.patches > 1)
    load.normal_force = contact.normal_force;
  else if (load.vertical_force)
    load.normal_force = normal_force(*load.vertical_force, 0.0, contact.place);
}

Scene make_scene(const Case& input, WheelRailContact contact) {
  Scene scene;
  scene.input = input;
  scene.input.patch = std::make_shared<const contact::PatchGeometry>(contact.geometry);
  scene.input.place = contact.place;
  set_load(scene.input, contact);
  set_creepages(scene.input, contact, rotation_changes(input));
  scene.contact = std::move(contact);
  return scene;
}

}  // namespace

SearchScene search_scene_of(const Case& input) {
  return make_search_scene(input, {make_profile(input.wheel.profile, true, input.file),
                                   make_profile(input.rail.profile, false, input.file)});
}

std::vector<double> rotation_changes(const Case& input) {
  const auto& given = input.wheelset.rotation_change;
  std::vector<double> changes(input.rolling.creepages.size(), given.empty() ? 0.0 : given.front());
  if (given.size() > 1)
    for (std::size_t k = 0; k < changes.size(); ++k) changes[k] = given.at(k);
  return changes;
}

std::vector<Scene> make_scenes(const Case& input, const SearchScene& scene,
                               const SearchOptions& options) {
  std::vector<Scene> scenes;
  for (std::size_t k = 0; k < input.wheelset.positions(); ++k)
    for (WheelRailContact& contact : find_contacts(input, scene, static_cast<int>(k) + 1, options))
      if (contact.place.patch > 0) scenes.push_back(make_scene(input, std::move(contact)));
  return scenes;
}

std::vector<Scene> make_scenes(const Case& input, const SearchOptions& options) {
  return make_scenes(input, search_scene_of(input), options);
}

void set_rotation_changes(Scene& scene, const std::vector<double>& rotation_changes) {
  set_creepages(scene.input, scene.contact, rotation_changes);
}

}  // namespace rollfem::meshes
