// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress and displacement at requested places of a stored load point: in the half-space
// from the tractions, in finite elements from the bodies.
#pragma once

#include "models/stress/stored_stress.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// A request with its name in all files: point_1, line_1, plane_1, ...
struct NamedRequest {
  std::string name;
  std::string call;  ///< for messages
  contact::SubsurfaceRequest request;
  bool depth_profile = false;  ///< depth is relative to the surface at the first place
};

/// The requests of the file with [[subsurface.*]], as in a case, in its order. Throws
/// contact::InputError for invalid content.
std::vector<NamedRequest> named_requests(const StressRequest& request);

/// Lines from the surface down below the centre of the patch, and below the most loaded element
/// unless it contains the centre. Throws contact::InputError for an invalid depth.
std::vector<NamedRequest> depth_profiles(const contact::ModelResult& model, std::size_t point,
                                         const StressRequest& request);

/// Stresses from integrals over the tractions. `input`: materials of the case. Throws
/// contact::InputError for a place outside its half-space.
std::vector<postprocess::StressSet> halfspace_sets(contact::Scene scene,
                                                   const contact::ModelResult& model,
                                                   std::size_t point,
                                                   const std::vector<NamedRequest>& requests);

/// Stresses by interpolation in the stored bodies of the load point. Throws contact::InputError for
/// a place outside the bodies.
std::vector<postprocess::StressSet> body_sets(const contact::ModelResult& model, std::size_t point,
                                              const std::vector<NamedRequest>& requests);

/// Stresses from the half-space's integrals and the smooth correction; `maxima`: the largest
/// stresses of both bodies. Lines of a depth profile run down along the local surface normal.
/// Throws contact::InputError for a place outside its body.
std::vector<postprocess::StressSet> hybrid_sets(const contact::Case& input,
                                                const contact::ModelResult& model,
                                                std::size_t point,
                                                const std::vector<NamedRequest>& requests,
                                                std::vector<contact::StressMaximum>& maxima);

}  // namespace rollfem::modelling
