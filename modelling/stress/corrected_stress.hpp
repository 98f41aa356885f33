// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress below the surface of a stored load point whose model corrects half-spaces for true bodies.
#pragma once

#include "case/case.hpp"
#include "result/result.hpp"

#include <optional>
#include <vector>

namespace rollfem::modelling {

/// A request of a stored load point.
struct StoredRequest {
  contact::SubsurfaceRequest places;
  bool along_normal = false;  ///< a line that runs down along the local normal of the surface
};

/// Adds `subsurface` at the requests and `stress_maxima` to a load point on the grid, which has its
/// tractions and semi-axes: the half-space's integrals and the smooth correction. `place`: of the
/// patch, with profiles. Throws contact::InputError for a place outside its body.
void add_corrected_stress(const contact::Case& input,
                          const std::optional<contact::ContactPlace>& place,
                          const contact::ContactGrid& grid,
                          const std::vector<StoredRequest>& requests, contact::PointResult& point);

}  // namespace rollfem::modelling
