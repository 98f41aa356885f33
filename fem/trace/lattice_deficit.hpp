// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite elements on a regular lattice of cells as deep as a half-space, under tractions constant
// on every contact element: the error of their mean element displacement relative to the elastic
// half-space. The response of a lattice to a wave of tractions is a wave (Bloch), so one column of
// cells with sides joined by the wave's phase is sufficient, without mesh or fit.
#pragma once

#include "base/material.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <array>
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

/// Mean displacement of the half-space less that of the lattice.
std::vector<ElementResponse> lattice_deficit(const Lattice& lattice);

}  // namespace rollfem::fem
