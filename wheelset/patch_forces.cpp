#include "wheelset/patch_forces.hpp"

#include "halfspace/model/model.hpp"

namespace rollfem::wheelset {

std::vector<meshes::PatchForce> patch_forces(const contact::Scene& scene, int elements_across) {
  contact::Scene coarse = scene;
  coarse.accuracy.relative.reset();
  coarse.contact_grid = {};
  coarse.contact_grid.elements_across = elements_across;
  const contact::ModelResult result = halfspace::run_halfspace(coarse, {});
  std::vector<meshes::PatchForce> forces;
  for (const contact::PointResult& point : result.points)
    forces.push_back(
        {point.longitudinal_force, point.lateral_force, point.normal_force, point.spin_moment});
  return forces;
}

}  // namespace rollfem::wheelset
