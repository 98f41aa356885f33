// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolates fields from one contact grid to another: first guesses from a coarser level.
#pragma once

#include "contact/base/grid.hpp"

namespace rollfem::contact {

/// Bilinear between element centres of `from`, zero beyond its outermost ones. With `weights` (one
/// per element of `from`) the average counts only elements of positive weight, so that values next
/// to the edge of a patch are not drawn to zero from outside.
Field interpolated(const ContactGrid& from, const Field& values, const ContactGrid& to,
                   const Field& weights = {});

/// Tractions over their bounds, between -1 and 1; 0 where the bound is 0.
TangentialField relative_to_bound(const TangentialField& traction, const Field& bound);

/// Initial tractions of a finer grid: `relative` (tractions over bounds of the coarser grid under
/// `pressure`) times the bounds of the finer grid.
TangentialField finer_tractions(const ContactGrid& coarse, const Field& pressure,
                                const TangentialField& relative, const ContactGrid& fine,
                                const Field& bound);

}  // namespace rollfem::contact
