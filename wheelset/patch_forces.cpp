#include "wheelset/patch_forces.hpp"

#include "halfspace/model/model.hpp"

namespace rollfem::wheelset {

namespace {

/// Forces to about half a percent of mu F_z (docs/accuracy.md); what of it enters the balance is
/// smaller by the sine of the contact angle, and the rotation feels it in both wheels alike.
constexpr int elements_across = 24;

}  // namespace

std::vector<meshes::PatchForce> patch_forces(const contact::Scene& scene) {
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
