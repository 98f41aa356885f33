// Violation of the contact conditions by the fields of a load point, computed from the reported
// fields alone and independent of the iteration that found them.
#pragma once

#include "contact/result/result.hpp"

namespace rollfem::contact {

/// 0 each where they hold exactly, and where a model does not give the fields.
struct ContactResidual {
  /// Largest |gap| under pressure and largest penetration elsewhere, over the largest normal
  /// displacement difference.
  double gap = 0.0;
  /// By how much |p_t| exceeds its bound at most, over the largest bound.
  double excess = 0.0;
};

/// What iterations may leave: half-spaces leave less than 1e-6 of either, finite elements too
/// unless unlike materials couple friction with the gap, whose outer iteration ends at 1e-4.
inline constexpr ContactResidual largest_residual{2e-3, 1e-4};

ContactResidual contact_residual(const ContactFields& fields);

}  // namespace rollfem::contact
