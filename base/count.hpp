// SPDX-License-Identifier: LGPL-2.1-or-later
// Converts a count of elements, steps or points that was computed from lengths to an int, with
// an error if it does not fit: lengths come from the user.
#pragma once

namespace rollfem::contact {

/// Larger counts are a mistake in the input; up to this one, sums of a few counts fit into an int.
inline constexpr double largest_count = 1e8;

/// A whole number as an int. Throws InputError where it is not finite or beyond `largest_count` in
/// magnitude; `what` names the items and the keys that determine their number.
int count_of(double number, const char* what);

}  // namespace rollfem::contact
