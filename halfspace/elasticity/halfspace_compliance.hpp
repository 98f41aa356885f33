// SPDX-License-Identifier: LGPL-2.1-or-later
// The half-space as a compliance: FFT convolution with the influence coefficients, plans kept.
// Normal, tangential and steady-rolling blocks for the contact solvers, and the whole map.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "scene/geometry.hpp"

#include <memory>

namespace rollfem::halfspace {

/// Half-space compliance of a grid. Keeps FFTW plans and transformed kernels; apply() is const and
/// exact to rounding (the convolution is padded, not periodic).
class HalfspaceCompliance : public contact::SolvableCompliance {
 public:
  HalfspaceCompliance(const contact::ContactGrid& grid, const contact::CombinedMaterial& material);
  ~HalfspaceCompliance() override;

  const contact::ContactGrid& grid() const override;
  /// All components, with the normal-tangential coupling K of unlike materials.
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;

  const contact::NormalOperator& normal() const override;
  /// T = A_tt: shift problems.
  const contact::TangentialOperator& shift() const override;
  /// T = D A_tt: steady rolling. Created at the first call for each order and kept.
  const contact::TangentialOperator& rolling(contact::UpwindOrder order) const override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::halfspace
