// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement at the centres of the contact elements, needed by the contact solvers, from the
// element means given by finite elements. The difference is confined to one or two elements around
// kinks of the tractions, such as the leading edge of a patch: without this correction the mean
// moves the edge of the discrete solution by a tenth of an element, and changes forces by 0.2 to
// 0.4 % of mu at eight elements per semi-axis (docs/theory.md). On this scale curvature and far
// boundary have no influence: the difference is that of the half-space, on which both displacements
// are known.
#pragma once

#include "fem/trace/lattice_deficit.hpp"
#include "halfspace/elasticity/circulant.hpp"

#include <optional>

namespace rollfem::fem {

class MiddleDisplacement {
 public:
  /// For one body on this grid. `stretch`: of its elements (PatchShape), empty: plane. `lattice`:
  /// cells of the body if they are regular under the elements; the difference of their mean
  /// displacement to the half-space's is then corrected, too.
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
