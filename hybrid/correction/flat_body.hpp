// SPDX-License-Identifier: LGPL-2.1-or-later
// The correction of a flat body in the frame of the common surface, without a mesh: the
// body is a half-space itself, but loaded and evaluated along the local tangents and
// normals of a surface that is curved where the other body is.
#pragma once

#include "contact/scene/scene.hpp"
#include "hybrid/correction/flat_twin.hpp"

#include <Eigen/Core>

#include <array>

namespace rollfem::hybrid {

/// Whether a body has a plane surface and is so large that it has no far boundary.
bool is_half_space(const contact::Scene& scene, bool wheel);

/// Contribution of the body to u_wheel - u_rail, mm: the displacement of its plane less that of the
/// rolled-out half-space, under tractions on the wheel. `shapes`: a row for each element of the
/// grid (laid along the plane), a column for each traction, MPa. Returned for tractions along x, y
/// and n: a column for each shape, with u_x, then u_y, then u_n of all elements. `arc`: arc length
/// of the common surface, at least over the grid.
std::array<Eigen::MatrixXd, 3> beyond_flat_body(const contact::Scene& scene, bool wheel,
                                                const contact::ContactGrid& grid,
                                                const ArcLength& arc,
                                                const Eigen::MatrixXd& shapes);

}  // namespace rollfem::hybrid
