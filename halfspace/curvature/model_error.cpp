#include "halfspace/curvature/model_error.hpp"

#include "contact/result/quantities.hpp"
#include "halfspace/curvature/curved_level.hpp"

namespace rollfem::halfspace {

namespace {

/// The surface that curved bodies meet on. A pressure that is given lies in the plane.
contact::Scene on_common_surface(contact::Scene scene) {
  scene.subsurface.clear();
  scene.output.stress_maxima = false;
  if (!scene.given_pressure) scene.follows_surface = 1.0;
  return scene;
}

std::map<std::string, double> changes(const contact::PrescribedForce& force,
                                      const contact::PointResult& from,
                                      const contact::PointResult& to) {
  std::map<std::string, double> result;
  for (const contact::Quantity& quantity : contact::quantities()) {
    if (quantity.scale == contact::ErrorScale::none) continue;
    const auto before = quantity.value(from), after = quantity.value(to);
    if (before && after) result[quantity.name] = *after - *before;
  }
  if (force.longitudinal)
    result["longitudinal_creepage"] = to.creepage.longitudinal - from.creepage.longitudinal;
  if (force.lateral) result["lateral_creepage"] = to.creepage.lateral - from.creepage.lateral;
  return result;
}

}  // namespace

std::optional<ModelErrors> model_errors(const contact::Scene& scene,
                                        const contact::LevelResult& plain,
                                        const contact::Progress& progress) {
  const contact::Scene curved = on_common_surface(scene);
  const auto level = solve_curved_level(curved, plain.grid, "model error: ", progress);
  if (!level) return {};
  ModelErrors errors;
  for (std::size_t k = 0; k < plain.points.size(); ++k)
    errors.push_back(changes(scene.points[k].force, plain.points[k], level->points[k]));
  return errors;
}

}  // namespace rollfem::halfspace
