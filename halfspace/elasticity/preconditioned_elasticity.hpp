// SPDX-License-Identifier: LGPL-2.1-or-later
// The elasticity of half-spaces and of bodies close to them: any compliance, with the half-space on
// the same grid as its preconditioner, and the displacement due to other contacts of the wheel.
#pragma once

#include "contact/solve/contact_run.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "result/patch_size.hpp"
#include "scene/geometry.hpp"

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace rollfem::halfspace {

/// The half-spaces of a grid, which several solutions may share.
struct Halfspaces {
  Halfspaces(const contact::CombinedMaterial& of, const contact::ContactGrid& grid);
  /// Whether they are those of this grid, wherever it lies.
  bool fit(const contact::CombinedMaterial& other, const contact::ContactGrid& grid) const;

  contact::CombinedMaterial material;
  std::shared_ptr<const HalfspaceCompliance> like;     ///< without coupling
  std::shared_ptr<const HalfspaceCompliance> coupled;  ///< null: like materials
};

class PreconditionedElasticity : public contact::Elasticity {
 public:
  /// The scene must outlive this object. `whole`: null for half-spaces.
  PreconditionedElasticity(const contact::Scene& scene, const contact::ContactGrid& grid,
                           std::unique_ptr<const contact::Compliance> whole = nullptr)
      : PreconditionedElasticity(scene, Halfspaces(scene.material, grid), std::move(whole)) {}
  PreconditionedElasticity(const contact::Scene& scene, Halfspaces halfspaces,
                           std::unique_ptr<const contact::Compliance> whole = nullptr)
      : scene_(scene), whole_(std::move(whole)), halfspaces_(std::move(halfspaces)) {}

  bool is_halfspace() const override { return whole_ == nullptr; }
  const contact::Compliance& compliance() const override {
    return whole_ ? *whole_ : halfspaces_.coupled ? *halfspaces_.coupled : *halfspaces_.like;
  }
  const contact::SolvableCompliance& halfspace() const override { return *halfspaces_.like; }
  const contact::Compliance* coupled_halfspace() const override {
    return halfspaces_.coupled.get();
  }
  contact::Field extra_distance() const override;
  contact::TangentialField extra_slip() const override;
  Eigen::Vector2d rolling_stiffness(const contact::PatchSize& patch) const override;
  Eigen::Vector2d shift_stiffness(const contact::PatchSize& patch) const override;

 private:
  const contact::Scene& scene_;
  std::unique_ptr<const contact::Compliance> whole_;
  Halfspaces halfspaces_;
};

// Start of the search for the creepage or shift of a prescribed force: Kalker's linear theory
// and Mindlin's tangential stiffness on the computed patch, in series with a layer between the
// bodies whose tractions grow linearly behind the leading edge.

/// -dF/d(creepage) of steady rolling without slip, N: G c^2 C11 and G c^2 C22.
Eigen::Vector2d rolling_stiffness(const contact::PatchSize& patch,
                                  const contact::CombinedMaterial& material);

/// -dF/d(shift) without slip, N/mm: 4 c G / (2 - nu) of a circle with c = sqrt(a b) (Johnson 1985,
/// eq. 7.43), an estimate for other shapes.
Eigen::Vector2d shift_stiffness(const contact::PatchSize& patch,
                                const contact::CombinedMaterial& material);

}  // namespace rollfem::halfspace
