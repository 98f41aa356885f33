#include "track/balance/patch_forces.hpp"

#include "halfspace/model/model.hpp"

namespace rollfem::track {

std::vector<PatchForce> patch_forces(const contact::Scene& scene, int elements_across) {
  contact::Scene coarse = scene;
  coarse.accuracy.relative.reset();
  coarse.contact_grid = {};
  coarse.contact_grid.elements_across = elements_across;
  const contact::ModelResult result = halfspace::run_halfspace(coarse, {});
  std::vector<PatchForce> forces;
  for (const contact::PointResult& point : result.points)
    forces.push_back(
        {point.longitudinal_force, point.lateral_force, point.normal_force, point.spin_moment});
  return forces;
}

}  // namespace rollfem::track
