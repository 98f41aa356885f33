// Fields carried from one contact grid to another: first guesses from a coarser level.
#pragma once

#include "contact/base/grid.hpp"

namespace rollfem::contact {

/// Bilinear between element centres of `from`, zero beyond its outermost ones. With `weights` (one
/// per element of `from`) the average counts only elements of positive weight, so that values next
/// to the edge of a patch are not drawn to zero from outside.
Field interpolated(const ContactGrid& from, const Field& values, const ContactGrid& to,
                   const Field& weights = {});

}  // namespace rollfem::contact
