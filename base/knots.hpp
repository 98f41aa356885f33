// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a place lies among increasing knots.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rollfem::contact {

struct KnotPiece {
  std::size_t first;  ///< its left knot
  double length;
  double part;  ///< of the length, left of the place; outside 0 to 1 beyond the ends
};

/// The piece of at least two knots that contains a place, beyond the ends the one there. `at`: the
/// place of a knot.
template <class Knot, class At>
KnotPiece piece_of(const std::vector<Knot>& knots, double place, const At& at) {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, place,
                                      [&](double y, const Knot& knot) { return y < at(knot); });
  const auto first = static_cast<std::size_t>(above - knots.begin()) - 1;
  const double length = at(knots[first + 1]) - at(knots[first]);
  return {first, length, (place - at(knots[first])) / length};
}

inline KnotPiece piece_of(const std::vector<double>& knots, double place) {
  return piece_of(knots, place, [](double knot) { return knot; });
}

}  // namespace rollfem::contact
