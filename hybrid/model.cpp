#include "hybrid/model.hpp"

#include "contact/base/stopwatch.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/model.hpp"
#include "halfspace/model/preconditioned_elasticity.hpp"
#include "hybrid/compliance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace rollfem::hybrid {

using contact::ContactGrid;
using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

namespace {

/// What cells, polynomials and segments leave uncertain of the correction, as a part of it: from
/// three cells in the semi-axis to five it changes by 2 to 6 %.
constexpr double uncertain_part = 0.1;

/// Adds to the error estimates what is uncertain of the difference to the half-space.
void widen(PointResult& point, const PointResult& half) {
  for (auto& [name, error] : point.error_estimate) {
    const double change = contact::quantity(point, name) - contact::quantity(half, name);
    error = std::hypot(error, uncertain_part * change);
  }
}

}  // namespace

ModelResult run_hybrid(const Scene& scene, const contact::Progress& progress,
                       contact::Checkpoint* checkpoint, const FindParts& find) {
  const contact::Stopwatch watch;
  Scene curved = scene;
  curved.follows_surface = 1.0;
  curved.subsurface.clear();
  curved.output.stress_maxima = false;
  const halfspace::SmoothParts parts = find(curved, progress);
  const double seconds = watch.seconds();
  halfspace::GridElasticity elasticity;
  elasticity.model = "hybrid";
  elasticity.same_normal_block = false;
  elasticity.make = [&](const Scene& of, const contact::ChartedGeometry& geometry,
                        const ContactGrid& grid) -> std::unique_ptr<contact::Elasticity> {
    return std::make_unique<halfspace::PreconditionedElasticity>(
        of, grid, std::make_unique<HybridCompliance>(of, geometry, grid, parts));
  };
  ModelResult result = halfspace::run_halfspace(curved, progress, checkpoint, elasticity);
  const ModelResult half = halfspace::run_halfspace(curved, {});
  for (std::size_t k = 0; k < result.points.size(); ++k) widen(result.points[k], half.points[k]);
  result.unknowns += parts.unknowns;
  result.seconds["correction"] = seconds;
  result.seconds["total"] = watch.seconds();
  result.notes.insert(result.notes.end(), parts.notes.begin(), parts.notes.end());
  result.notes.push_back(
      fmt::format("what wheel and rail add to half-spaces is a smooth correction by {} "
                  "finite-element unknowns; "
                  "a tenth of what it changes is in the error estimates",
                  parts.unknowns));
  return result;
}

}  // namespace rollfem::hybrid
