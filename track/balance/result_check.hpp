// Checks of the results of one wheel: patches must not overlap, each on a grid that holds its
// reference point, with positive approaches and shares that add up to the load.
#pragma once

#include "contact/case/case.hpp"
#include "contact/result/result.hpp"

#include <vector>

namespace rollfem::track {

/// `results`: of one model, all contacts of all wheels at all positions; results without a place
/// are not looked at. Throws contact::SolveError with what is wrong.
void check_results(const contact::Case& input, const std::vector<contact::ModelResult>& results);

}  // namespace rollfem::track
