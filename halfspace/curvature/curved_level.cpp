#include "halfspace/curvature/curved_level.hpp"

#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/level.hpp"
#include "halfspace/patch/scene_chart.hpp"

namespace rollfem::halfspace {

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
  const bool inside = run.solve(grid, [&] {
    return std::make_unique<PreconditionedElasticity>(
        scene, grid, std::make_unique<CurvedCompliance>(scene, grid));
  });
  if (!inside) return {};
  return run.take_result();
}

}  // namespace rollfem::halfspace
