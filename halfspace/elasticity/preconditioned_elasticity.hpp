// The elasticity of bodies close to half-spaces: any compliance, with the half-space on the same
// grid as its stand-in, and the displacement due to other contacts of the wheel.
#pragma once

#include "contact/solve/contact_run.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <memory>

namespace rollfem::halfspace {

class PreconditionedElasticity : public contact::Elasticity {
 public:
  /// The scene must outlive this.
  PreconditionedElasticity(const contact::Scene& scene, const contact::ContactGrid& grid,
                           std::unique_ptr<const contact::Compliance> whole);

  const contact::Compliance& whole() const override { return *whole_; }
  const contact::SolvableCompliance& standin() const override { return standin_; }
  const contact::Compliance* coupled_standin() const override { return coupled_.get(); }
  contact::Field extra_distance() const override;
  contact::TangentialField extra_slip() const override;
  Eigen::Vector2d rolling_stiffness(const contact::PatchSize& patch) const override;
  Eigen::Vector2d shift_stiffness(const contact::PatchSize& patch) const override;

 private:
  const contact::Scene& scene_;
  std::unique_ptr<const contact::Compliance> whole_;
  HalfspaceCompliance standin_;
  std::unique_ptr<HalfspaceCompliance> coupled_;  ///< null: like materials
};

}  // namespace rollfem::halfspace
