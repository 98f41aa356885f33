// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/stress/corrected_stress.hpp"

#include "base/errors.hpp"
#include "hybrid/stresses.hpp"
#include "modelling/fem/fem_models.hpp"
#include "modelling/solving/case_scenes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::modelling {
namespace {

/// The scene of the patch.
contact::Scene scene_of(const contact::Case& input,
                        const std::optional<contact::ContactPlace>& place) {
  if (!place) return input;
  for (const contact::Case& how : {input, on_common_surface(input)}) {
    const auto scenes = contact::attempt([&] { return scenes_of(how, placed_wheels(how)).list; });
    if (!scenes) continue;
    for (const contact::Scene& scene : *scenes)
      if (scene.place && scene.place->same_patch(*place) && scene.place->patches == place->patches)
        return scene;
  }
  throw contact::InputError(fmt::format(
      "{}: patch {} of the result is no longer found in its case; do: run the case again",
      input.file, place->label()));
}

}  // namespace

void add_corrected_stress(const contact::Case& input,
                          const std::optional<contact::ContactPlace>& place,
                          const contact::ContactGrid& grid,
                          const std::vector<StoredRequest>& requests, contact::PointResult& point) {
  contact::Scene scene = scene_of(input, place);
  scene.subsurface.clear();
  scene.output.stress_maxima = true;
  scene.follows_surface = 1.0;
  const hybrid::SmoothParts parts = find_smooth_parts(scene, {});
  const hybrid::Stresses stresses(scene, parts);
  for (const StoredRequest& one : requests) {
    contact::SubsurfaceRequest places = one.places;
    if (one.along_normal) {
      const auto& spot = one.places.from;
      places.from = stresses.place(places.wheel, spot[0], spot[1], 0.0);
      places.to = stresses.place(places.wheel, spot[0], spot[1], std::abs(one.places.to[2]));
    }
    scene.subsurface.push_back(places);
  }
  stresses.add(grid, point);
  stresses.finish(grid, 0.0, 0.0, point);
}

}  // namespace rollfem::modelling
