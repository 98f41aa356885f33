// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement at the centres of the contact elements, needed by the contact solvers, from the
// element means given by finite elements. The difference is confined to one or two elements around
// kinks of the tractions, such as the leading edge of a patch: without this correction the mean
// moves the edge of the discrete solution by a tenth of an element, and changes forces by 0.2 to
// 0.4 % of mu at eight elements per semi-axis (docs/theory.md). On this scale curvature and far
// boundary have no influence: the difference is that of the half-space, on which both displacements
// are known.
#pragma once

#include "base/material.hpp"
#include "halfspace/elasticity/circulant.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::fem {

/// Cells under a contact element: `cells` by `cells`.
struct Lattice {
  contact::Material material;
  int degree = 2;                   ///< of the elements, FE_Q(degree)^3
  int cells = 1;                    ///< along each side of a contact element
  std::array<double, 3> cell_size;  ///< mm: along x, along y, inwards
};

/// Displacements (mm) of one element under unit traction (MPa) on another; without the coupling of
/// normal and tangential directions.
using ElementResponse = halfspace::Influence;

/// For elements (i, j) from the loaded one, 0 <= i, j <= lattice_reach, index j * (lattice_reach +
/// 1) + i; xy is odd in i and in j, the others are even. Beyond the reach the value is below 1e-5
/// of that of the loaded element.
inline constexpr int lattice_reach = 8;

/// Finite elements on a regular lattice of cells as deep as a half-space, under tractions constant
/// on every contact element: mean displacement of the half-space's elements less that of the
/// lattice's. The response of a lattice to a wave of tractions is a wave (Bloch), so one column of
/// cells with sides joined by the wave's phase is sufficient, without mesh or fit.
std::vector<ElementResponse> lattice_deficit(const Lattice& lattice);

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
