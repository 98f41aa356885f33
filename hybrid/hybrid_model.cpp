// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/hybrid_model.hpp"

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/hybrid_compliance.hpp"
#include "hybrid/stresses.hpp"
#include "result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

namespace rollfem::hybrid {

using contact::ContactGrid;
using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

namespace {

/// Relative uncertainty of the correction from cells, polynomials and segments: between three and
/// five cells in the semi-axis it changes by 2 to 6 %.
constexpr double uncertain_part = 0.1;

/// Grid for the difference to the half-space, which is as smooth as the correction.
constexpr int elements_of_difference = 10;

/// Refuses contact where the correction is only continued.
class HybridElasticity : public halfspace::PreconditionedElasticity {
 public:
  HybridElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                   const ContactGrid& grid, const SmoothParts& parts)
      : PreconditionedElasticity(scene, grid,
                                 std::make_unique<HybridCompliance>(scene, geometry, grid, parts)),
        scene_(scene),
        parts_(parts) {}

  void check_patch(const contact::PatchSize& patch) const override {
    for (const SmoothMap* map : {&parts_.wheel, &parts_.rail}) {
      const SmoothBox& box = map->fields;
      if (map->empty() ||
          (std::max(-patch.x_lower, patch.x_upper) <= box.half_length &&
           std::max(box.middle - patch.y_lower, patch.y_upper - box.middle) <= box.half_width))
        continue;
      throw contact::SolveError(
          scene_.where(),
          "the contact reaches over x = {:.4g} to {:.4g} mm, y = {:.4g} to {:.4g} mm, the "
          "correction for wheel and rail over {:.4g} to {:.4g} mm, {:.4g} to {:.4g} mm; do: "
          "run with --model fem",
          patch.x_lower, patch.x_upper, patch.y_lower, patch.y_upper, -box.half_length,
          box.half_length, box.middle - box.half_width, box.middle + box.half_width);
    }
  }

 private:
  const Scene& scene_;
  const SmoothParts& parts_;
};

halfspace::GridElasticity elasticity_of(const SmoothParts& parts) {
  halfspace::GridElasticity elasticity;
  elasticity.model = "hybrid";
  elasticity.independent_points = false;
  elasticity.make = [&parts](const Scene& scene, const contact::ChartedGeometry& geometry,
                             const ContactGrid& grid) -> std::unique_ptr<contact::Elasticity> {
    return std::make_unique<HybridElasticity>(scene, geometry, grid, parts);
  };
  return elasticity;
}

/// Adds the uncertainty of the difference to the half-space to the error estimates.
void widen(PointResult& point, const PointResult& hybrid, const PointResult& half) {
  for (auto& [name, error] : point.error_estimate) {
    if (contact::find_quantity(name) == nullptr) continue;  // stresses widen their own
    const double change = contact::quantity(hybrid, name) - contact::quantity(half, name);
    error = std::hypot(error, uncertain_part * change);
  }
}

/// The same for all load points. Where the coarse grid has no solution, the half-space on the grid
/// of the result gives the difference.
void widen(const Scene& scene, const halfspace::GridElasticity& elasticity,
           const Stresses* stresses, ModelResult& result) {
  ModelResult corrected, half;
  try {
    const Scene rough = halfspace::on_few_elements(scene, elements_of_difference);
    corrected = halfspace::run_halfspace(rough, {}, nullptr, elasticity);
    half = halfspace::run_halfspace(rough, {});
  } catch (const contact::Failure&) {
    half = halfspace::run_halfspace(scene, {});
  }
  const bool rough = !corrected.points.empty() && corrected.points.size() == half.points.size();
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const PointResult& hybrid = rough ? corrected.points[k] : result.points[k];
    widen(result.points[k], hybrid, half.points[k]);
    if (stresses == nullptr) continue;
    const double change = hybrid.max_pressure - half.points[k].max_pressure;
    stresses->finish(result.grid, uncertain_part, change / hybrid.max_pressure, result.points[k]);
  }
}

/// At the end of a body its compliance differs from the half-space's by what no smooth correction
/// follows.
void refuse_free_ends(const Scene& scene) {
  if (!scene.has_profiles()) return;
  const halfspace::PatchBox patch = halfspace::PatchSearch(scene).box();
  constexpr double beyond = 1.1;
  for (const contact::FreeEnd& end : scene.geometry.surface.profiles->free_ends())
    if (std::abs(end.y - patch.middle) < beyond * patch.half_width)
      throw contact::SolveError(fmt::format(
          "the {} ends at y = {:.4g} mm, inside the patch (free_ends), where the correction is "
          "not smooth; do: run with --model halfspace, or with fem and [fem] mesh = \"gmsh\"",
          end.of_wheel ? "wheel" : "rail", end.y));
}

}  // namespace

ModelResult run_hybrid(const Scene& scene, const contact::Progress& progress,
                       contact::Checkpoint* checkpoint, const FindParts& find) {
  const contact::Stopwatch watch;
  refuse_free_ends(scene);
  Scene curved = scene;
  curved.follows_surface = 1.0;
  // Cells that no grid takes are refused before the finite elements begin.
  static_cast<void>(halfspace::PatchSearch(curved).grid(0));
  const SmoothParts parts = find(curved, progress);
  const double seconds = watch.seconds();
  halfspace::GridElasticity elasticity = elasticity_of(parts);
  const halfspace::GridElasticity without_stress = elasticity;
  std::optional<Stresses> stresses;
  if (curved.asks_for_stress()) {
    stresses.emplace(curved, parts);
    elasticity.add_stresses = [&](const ContactGrid& grid, PointResult& point) {
      stresses->add(grid, point);
    };
  }
  Scene plain = curved;
  plain.subsurface.clear();
  plain.output.stress_maxima = false;
  ModelResult result = halfspace::run_halfspace(plain, progress, checkpoint, elasticity);
  widen(plain, without_stress, stresses ? &*stresses : nullptr, result);
  result.unknowns += parts.unknowns;
  result.seconds["correction"] = seconds;
  result.seconds["total"] = watch.seconds();
  result.notes.insert(result.notes.end(), parts.notes.begin(), parts.notes.end());
  contact::add_note(result.notes, "correction",
                    "the correction for wheel and rail as curved, finite bodies comes from {} "
                    "finite-element "
                    "unknowns; the error estimates include a tenth of the change it causes",
                    parts.unknowns);
  return result;
}

}  // namespace rollfem::hybrid
