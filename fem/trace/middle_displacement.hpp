// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement at the middles of the contact elements, as the contact solvers need it, from the
// element means that finite elements give. The difference is confined to an element or two of where
// tractions bend, such as the leading edge of a patch: without this correction the mean moves the
// edge of the discrete solution by a tenth of an element, and with it forces by 0.2 to 0.4 % of mu
// at eight elements a semi-axis (docs/theory.md). So short a wave sees no curvature and no
// far boundary: the difference is that of the half-space, on which both displacements are known.
#pragma once

#include "fem/trace/lattice.hpp"
#include "halfspace/elasticity/circulant.hpp"

#include <optional>

namespace rollfem::fem {

class MiddleDisplacement {
 public:
  /// For one body on this grid. `stretch`: of its elements (PatchShape), empty: plane. `lattice`:
  /// cells of the body if they lie under the elements in a regular way; then what these cells lack
  /// of the half-space's mean is made good as well.
  MiddleDisplacement(const contact::ContactGrid& grid, const contact::Material& material,
                     const contact::Field& stretch, const std::optional<Lattice>& lattice);
  /// Adds middle less mean under tractions on the body (MPa) to its mean displacement (mm).
  /// Symmetric in the inner product over the true areas of elements.
  void add(const contact::SurfaceField& traction, contact::SurfaceField& displacement) const;

 private:
  halfspace::PaddedFft fft_;
  contact::Field root_stretch_;
  halfspace::Symbols symbols_;
};

}  // namespace rollfem::fem
