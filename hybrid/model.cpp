#include "hybrid/model.hpp"

#include "contact/base/stopwatch.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/beside.hpp"
#include "halfspace/model/force_search.hpp"
#include "halfspace/model/model.hpp"
#include "hybrid/compliance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace rollfem::hybrid {

using contact::ContactGrid;
using contact::ModelResult;
using contact::PatchSize;
using contact::PointResult;
using contact::Scene;

namespace {

/// What cells, polynomials and segments leave uncertain of the correction, as a part of it: from
/// three cells in the semi-axis to five it changes by 2 to 6 %.
constexpr double uncertain_part = 0.1;

class HybridElasticity : public contact::Elasticity {
 public:
  HybridElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                   const ContactGrid& grid, const halfspace::SmoothParts& parts)
      : scene_(scene),
        whole_(scene, geometry, grid, parts),
        half_(grid, scene.material.uncoupled()) {
    if (scene.material.couples())
      coupled_half_ = std::make_unique<halfspace::HalfspaceCompliance>(grid, scene.material);
  }

  const contact::Compliance& whole() const override { return whole_; }
  const contact::SolvableCompliance& standin() const override { return half_; }
  const contact::Compliance* coupled_standin() const override { return coupled_half_.get(); }
  contact::Field extra_distance() const override {
    if (scene_.beside.empty()) return {};
    return halfspace::displacement_beside(scene_.beside, scene_.material, half_.grid());
  }
  contact::TangentialField extra_slip() const override {
    if (scene_.beside.empty()) return {};
    return halfspace::slip_beside(scene_.beside, scene_.material, half_.grid());
  }
  Eigen::Vector2d rolling_stiffness(const PatchSize& patch) const override {
    return halfspace::rolling_stiffness(patch, scene_.material);
  }
  Eigen::Vector2d shift_stiffness(const PatchSize& patch) const override {
    return halfspace::shift_stiffness(patch, scene_.material);
  }

 private:
  const Scene& scene_;
  HybridCompliance whole_;
  halfspace::HalfspaceCompliance half_;
  std::unique_ptr<halfspace::HalfspaceCompliance> coupled_half_;  ///< null: like materials
};

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
    return std::make_unique<HybridElasticity>(of, geometry, grid, parts);
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
