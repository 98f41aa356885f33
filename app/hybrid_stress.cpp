#include "app/hybrid_stress.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "hybrid/stresses.hpp"
#include "models/fem/hybrid_model.hpp"
#include "models/solving/case_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rollfem::app {

namespace {

/// Of the patch that the result is of.
contact::Scene scene_of(const contact::Case& input, const contact::ModelResult& model) {
  if (!model.place) return input;
  for (const contact::Scene& scene : modelling::scenes_of(input, {}).list)
    if (scene.place && scene.place->left == model.place->left &&
        scene.place->position == model.place->position && scene.place->patch == model.place->patch)
      return scene;
  throw contact::InputError(fmt::format(
      "{}: patch {} of the result is no longer found in its case; do: run the case again",
      input.file, model.place->label()));
}

}  // namespace

HybridStress hybrid_stress(const contact::Case& input, const contact::ModelResult& model,
                           std::size_t point, const std::vector<NamedRequest>& requests) {
  // What the file says of the case is not all that its bodies are laid out by.
  contact::Scene scene = scene_of(contact::parse_case(input.text, input.file), model);
  scene.subsurface.clear();
  scene.output.stress_maxima = true;
  scene.follows_surface = 1.0;
  const halfspace::SmoothParts parts = modelling::smooth_parts_finder()(scene, {});
  const hybrid::Stresses stresses(scene, parts);
  for (const NamedRequest& named : requests) {
    contact::SubsurfaceRequest request = named.request;
    if (named.depth_profile) {
      const auto& spot = named.request.from;
      request.from = stresses.place(request.wheel, spot[0], spot[1], 0.0);
      request.to = stresses.place(request.wheel, spot[0], spot[1], std::abs(named.request.to[2]));
    }
    scene.subsurface.push_back(request);
  }
  contact::PointResult solved = model.points.at(point);
  stresses.add(model.grid, solved);
  stresses.finish(model.grid, 0.0, 0.0, solved);
  HybridStress found;
  for (std::size_t k = 0; k < requests.size(); ++k)
    found.sets.push_back({requests[k].name, std::move(solved.subsurface[k]), 0.0});
  found.maxima = std::move(solved.stress_maxima);
  return found;
}

}  // namespace rollfem::app
