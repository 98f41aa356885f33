#include "halfspace/curvature/curved_level.hpp"

#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/model/beside.hpp"
#include "halfspace/model/force_search.hpp"
#include "halfspace/model/level.hpp"

namespace rollfem::halfspace {

namespace {

class CurvedElasticity : public contact::Elasticity {
 public:
  CurvedElasticity(const contact::Scene& scene, const contact::ContactGrid& grid)
      : scene_(scene), whole_(scene, grid), standin_(grid, scene.material.uncoupled()) {
    if (scene.material.couples())
      coupled_ = std::make_unique<HalfspaceCompliance>(grid, scene.material);
  }

  const contact::Compliance& whole() const override { return whole_; }
  const contact::SolvableCompliance& standin() const override { return standin_; }
  const contact::Compliance* coupled_standin() const override { return coupled_.get(); }
  Eigen::Vector2d rolling_stiffness(const contact::PatchSize& patch) const override {
    return halfspace::rolling_stiffness(patch, scene_.material);
  }
  Eigen::Vector2d shift_stiffness(const contact::PatchSize& patch) const override {
    return halfspace::shift_stiffness(patch, scene_.material);
  }
  contact::Field extra_distance() const override {
    return displacement_beside(scene_.beside, scene_.material, standin_.grid());
  }
  contact::TangentialField extra_slip() const override {
    return slip_beside(scene_.beside, scene_.material, standin_.grid());
  }

 private:
  const contact::Scene& scene_;
  CurvedCompliance whole_;
  HalfspaceCompliance standin_;
  std::unique_ptr<HalfspaceCompliance> coupled_;  ///< null: like materials
};

}  // namespace

std::optional<contact::LevelResult> solve_curved_level(const contact::Scene& scene,
                                                       const contact::ContactGrid& grid,
                                                       const std::string& stage_prefix,
                                                       const contact::Progress& progress) {
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  contact::RunOptions options;
  options.model = "halfspace";
  options.stage_prefix = stage_prefix;
  options.force_accuracy = accuracy_of_force_search;
  options.same_normal_block = false;
  contact::ContactRun run(scene, geometry, options, progress, nullptr);
  if (!run.solve(grid, [&] { return std::make_unique<CurvedElasticity>(scene, grid); })) return {};
  return run.take_result();
}

}  // namespace rollfem::halfspace
