// Fields carried from one contact grid to another: first guesses from a coarser level.
#pragma once

#include "contact/base/grid.hpp"

namespace rollfem::halfspace {

/// Bilinear between element centres of `from`, zero beyond its outermost ones. With `weights` (one
/// per element of `from`) the average counts only elements of positive weight, so that values next
/// to the edge of a patch are not drawn to zero from outside.
contact::Field interpolated(const contact::ContactGrid& from, const contact::Field& values,
                            const contact::ContactGrid& to, const contact::Field& weights = {});

}  // namespace rollfem::halfspace
