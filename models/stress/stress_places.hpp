// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress and displacement at requested places of a stored load point: in the half-space
// from the tractions, in finite elements from the bodies.
#pragma once

#include "models/stress/stress_request.hpp"
#include "postprocess/stress/stress_report.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// Lines from the surface down under the centre of the patch, and under the most loaded element
/// unless the centre is in it. Throws contact::InputError for a depth that is none.
std::vector<NamedRequest> depth_profiles(const contact::ModelResult& model, std::size_t point,
                                         const StressRequest& request);

/// By the integrals over the tractions. `input`: materials of the case. Throws contact::InputError
/// for a place that is in no half-space.
std::vector<postprocess::StressSet> halfspace_sets(contact::Scene scene,
                                                   const contact::ModelResult& model,
                                                   std::size_t point,
                                                   const std::vector<NamedRequest>& requests);

/// By interpolation in the bodies, whose values the load point has. Throws contact::InputError for
/// a place outside of them.
std::vector<postprocess::StressSet> body_sets(const contact::ModelResult& model, std::size_t point,
                                              const std::vector<NamedRequest>& requests);

/// By the half-space's integrals and the smooth correction, whose largest stresses of both bodies
/// are `maxima`. Lines of a depth profile go down along the normal of the surface under their
/// place. Throws contact::InputError for a place outside of its body.
std::vector<postprocess::StressSet> hybrid_sets(const contact::Case& input,
                                                const contact::ModelResult& model,
                                                std::size_t point,
                                                const std::vector<NamedRequest>& requests,
                                                std::vector<contact::StressMaximum>& maxima);

}  // namespace rollfem::modelling
