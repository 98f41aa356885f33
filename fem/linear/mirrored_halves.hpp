// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies symmetric about the plane x = 0, as segments of rails and wheels are: every displacement
// is the sum of an even and an odd one, each a separate problem on the half at x > 0. Two factors
// of half the size take half the work and four fifths of the memory.
#pragma once

#include "fem/discretisation/elasticity_assembly.hpp"

#include <optional>

namespace rollfem::fem {

/// u = C_even x_even + C_odd x_odd. The matrix of either is that of the cells at x > 0 (`cells`),
/// its right-hand side half of C^T b.
struct MirroredHalves {
  FreeUnknowns even;  ///< x components of mirror images are opposite, the others equal
  FreeUnknowns odd;
};

/// None when nodes or constraints are not their own mirror images, and for elements of degree 1,
/// whose cells are bent between their nodes. One process only.
std::optional<MirroredHalves> find_mirrored_halves(const ElasticProblem& problem);

}  // namespace rollfem::fem
