// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/curvature/curvature_error.hpp"

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/quantities.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::halfspace {

namespace {

/// Tolerance for prescribed values such as the normal force, which have no model error.
constexpr double rounding = 1e-8;

/// Errors of a hundredth are needed to a hundredth of themselves. Where both tolerances converge,
/// the result agrees with that for 1e-6 to three digits; more cases converge with this one, and
/// none spends minutes in a cycle.
constexpr contact::OuterOptions of_estimate{1e-4, 60, 5};

/// Before the stage names of progress events.
constexpr const char* of_model_error = "model error: ";

/// The common surface of curved bodies. A given pressure lies in the plane.
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
    if (!before || !after || std::abs(*after - *before) <= rounding * std::abs(*before)) continue;
    result[quantity.name] = *after - *before;
  }
  if (force.longitudinal)
    result["longitudinal_creepage"] = to.creepage.longitudinal - from.creepage.longitudinal;
  if (force.lateral) result["lateral_creepage"] = to.creepage.lateral - from.creepage.lateral;
  return result;
}

/// The contact problem on gently curved bodies: the common driver on CurvedCompliance, by defect
/// correction on the half-space. All load points on the grid; empty if a patch reaches its border.
std::optional<contact::LevelResult> solve_curved_level(const contact::Scene& scene,
                                                       const contact::ContactGrid& grid,
                                                       const contact::Progress& progress) {
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  contact::RunOptions options;
  options.model = "halfspace";
  options.stage_prefix = of_model_error;
  options.accuracy.outer = of_estimate;
  options.force_accuracy = accuracy_of_force_search;
  contact::ContactRun run(scene, geometry, options, progress, nullptr);
  const bool inside = run.solve(grid, [&] {
    return std::make_unique<PreconditionedElasticity>(
        scene, grid, std::make_unique<CurvedCompliance>(scene, grid));
  });
  if (!inside) return {};
  return run.take_result();
}

std::optional<ModelErrors> errors_of_few_elements(const contact::Scene& scene,
                                                  const contact::Progress& progress, int across) {
  const contact::Scene few = on_few_elements(scene, across);
  const PatchSearch area(few);
  const auto [length, width] = area.extent();
  const contact::LevelResult plain =
      solve_level(few, area, length / across, width / across, nullptr, of_model_error, progress);
  return model_errors(few, plain, progress);
}

}  // namespace

std::optional<ModelErrors> model_errors(const contact::Scene& scene,
                                        const contact::LevelResult& plain,
                                        const contact::Progress& progress) {
  const contact::Scene curved = on_common_surface(scene);
  const auto level = solve_curved_level(curved, plain.grid, progress);
  if (!level) return {};
  ModelErrors errors;
  for (std::size_t k = 0; k < plain.points.size(); ++k)
    errors.push_back(changes(scene.points[k].force, plain.points[k], level->points[k]));
  return errors;
}

void add_model_error(const contact::Scene& scene, const contact::Progress& progress,
                     contact::ModelResult& result, int elements_across) {
  check_bodies_known(scene);
  const contact::Stopwatch watch;
  std::optional<ModelErrors> errors;
  std::string why = "the patch does not fit the grid";
  try {
    errors = errors_of_few_elements(scene, progress, elements_across);
  } catch (const contact::Failure& error) {  // the result stands without it
    why = error.what();
  }
  result.set_note(
      errors ? contact::Note{contact::about_model_error,
                             fmt::format("difference from bodies with their true curvature, to "
                                         "first order, with {} elements across",
                                         elements_across)}
             : contact::Note{contact::about_model_error,
                             fmt::format("not estimated: no result for curved bodies with {} "
                                         "elements across ({})",
                                         elements_across, why),
                             contact::Note::warning});
  for (std::size_t k = 0; errors && k < result.points.size(); ++k)
    for (const auto& [name, change] : errors->at(k))
      result.points[k].model_error[name] = std::abs(change);
  result.seconds["model error"] = watch.seconds();
}

}  // namespace rollfem::halfspace
