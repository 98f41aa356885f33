// Start of the search for the creepage or shift of a prescribed force: Kalker's linear theory
// and Mindlin's tangential stiffness on the computed patch.
#pragma once

#include "contact/result/patch_size.hpp"
#include "contact/scene/geometry.hpp"

#include <Eigen/Core>

namespace rollfem::halfspace {

/// -dF/d(creepage) of steady rolling without slip, N: G c^2 C11 and G c^2 C22.
Eigen::Vector2d rolling_stiffness(const contact::PatchSize& patch,
                                  const contact::CombinedMaterial& material);

/// -dF/d(shift) without slip, N/mm: 4 c G / (2 - nu) of a circle with c = sqrt(a b) (Johnson 1985,
/// eq. 7.43), a measure for other shapes.
Eigen::Vector2d shift_stiffness(const contact::PatchSize& patch,
                                const contact::CombinedMaterial& material);

/// Of a line contact: Carter's, and that of Hertz's distribution of tractions, whose displacement
/// in the middle is relative to the reference distance.
Eigen::Vector2d line_rolling_stiffness(const contact::PatchSize& patch,
                                       const contact::CombinedMaterial& material);
Eigen::Vector2d line_shift_stiffness(const contact::PatchSize& patch, double reference,
                                     const contact::CombinedMaterial& material);

}  // namespace rollfem::halfspace
