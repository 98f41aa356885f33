// Stress and displacement at requested places of a stored load point of the model hybrid.
#pragma once

#include "app/stress_request.hpp"
#include "postprocess/stress/stress_report.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::app {

struct HybridStress {
  std::vector<postprocess::StressSet> sets;    ///< one for each request
  std::vector<contact::StressMaximum> maxima;  ///< of both bodies
};

/// Lines of a depth profile go down along the normal of the surface under their place. Throws
/// contact::InputError for a place outside of its body.
HybridStress hybrid_stress(const contact::Case& input, const contact::ModelResult& model,
                           std::size_t point, const std::vector<NamedRequest>& requests);

}  // namespace rollfem::app
