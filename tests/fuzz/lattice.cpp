// SPDX-License-Identifier: LGPL-2.1-or-later
// A lattice of points: undeformed distance, or, when the first byte is `2`, the two columns of
// slip.
#include "case/lattice.hpp"

#include "base/errors.hpp"

#include "fuzz/target.hpp"

using namespace rollfem;

std::string outcome_of(const std::string& input) {
  const int columns = !input.empty() && input[0] == '2' ? 2 : 1;
  try {
    const contact::Lattice lattice =
        contact::parse_lattice(input.substr(input.empty() ? 0 : 1), "points.csv", columns);
    for (const double share : {0.0, 0.3, 1.0})
      static_cast<void>(contact::lattice_value(
          lattice, columns - 1, lattice.x_first + share * (lattice.nx - 1) * lattice.dx,
          lattice.y_first + share * (lattice.ny - 1) * lattice.dy));
  } catch (const contact::InputError& error) {
    return error.what();
  }
  return "";
}
