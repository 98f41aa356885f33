// Error estimates of results.h5 of format version 1, which were relative.
#pragma once

#include "contact/result/result.hpp"

namespace rollfem::postprocess {

/// Makes them absolute. They were relative to the value, or to a hundredth of full sliding where
/// that was more; those of the largest stresses alike to a hundredth of the largest pressure, of
/// stresses at points to the largest pressure, of creepages found to a hundredth of both together.
void make_errors_absolute(contact::PointResult& point, double friction_coefficient);

}  // namespace rollfem::postprocess
