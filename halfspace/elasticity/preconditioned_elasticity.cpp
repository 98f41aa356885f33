#include "halfspace/elasticity/preconditioned_elasticity.hpp"

#include "halfspace/elasticity/loads_beside.hpp"
#include "halfspace/elasticity/tangential_stiffness.hpp"

#include <utility>

namespace rollfem::halfspace {

PreconditionedElasticity::PreconditionedElasticity(const contact::Scene& scene,
                                                   const contact::ContactGrid& grid,
                                                   std::unique_ptr<const contact::Compliance> whole)
    : scene_(scene), whole_(std::move(whole)), standin_(grid, scene.material.uncoupled()) {
  if (scene.material.couples())
    coupled_ = std::make_unique<HalfspaceCompliance>(grid, scene.material);
}

contact::Field PreconditionedElasticity::extra_distance() const {
  return displacement_beside(scene_.beside, scene_.material, standin_.grid());
}

contact::TangentialField PreconditionedElasticity::extra_slip() const {
  return slip_beside(scene_.beside, scene_.material, standin_.grid());
}

Eigen::Vector2d PreconditionedElasticity::rolling_stiffness(const contact::PatchSize& patch) const {
  return halfspace::rolling_stiffness(patch, scene_.material);
}

Eigen::Vector2d PreconditionedElasticity::shift_stiffness(const contact::PatchSize& patch) const {
  return halfspace::shift_stiffness(patch, scene_.material);
}

}  // namespace rollfem::halfspace
