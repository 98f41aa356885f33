// SPDX-License-Identifier: LGPL-2.1-or-later
// Converts a count of elements, steps or points that was computed from lengths to an int, with
// an error if it does not fit: lengths come from the user.
#pragma once

namespace rollfem::contact {

/// More of anything is a mistake in the input; below it, sums of a few counts still fit into an
/// int.
inline constexpr double largest_count = 1e8;

/// A whole number as an int. Throws InputError where it is not finite or beyond `largest_count` in
/// magnitude; `what` says of what there are so many, and names the keys that make them.
int count_of(double number, const char* what);

}  // namespace rollfem::contact
