// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies symmetric about the plane x = 0, as segments of rails and wheels are: every displacement
// is the sum of an even and an odd one, each a separate problem on the half at x > 0. Two factors
// of half the size take half the work and four fifths of the memory.
#pragma once

#include "fem/discretisation/elasticity_assembly.hpp"

#include <optional>

namespace rollfem::fem {

/// u = C_even x_even + C_odd x_odd. Both matrices come from the cells at x > 0 (`cells`), with half
/// of C^T b as right-hand side.
struct MirroredHalves {
  FreeUnknowns even;  ///< x components of mirror images opposite, the others equal
  FreeUnknowns odd;
};

/// Empty when nodes or constraints are not mirror-symmetric, and for elements of degree 1, whose
/// cells are bent between their nodes. One process only.
std::optional<MirroredHalves> find_mirrored_halves(const ElasticProblem& problem);

}  // namespace rollfem::fem
