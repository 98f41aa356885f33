// SPDX-License-Identifier: LGPL-2.1-or-later
// Random tractions, and the product of two fields.
#pragma once

#include "base/grid.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// Each component of each element from -1 to 1.
inline contact::SurfaceField random_field(const contact::ContactGrid& grid, unsigned int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  contact::SurfaceField field{contact::Field(grid.size()), contact::Field(grid.size()),
                              contact::Field(grid.size())};
  for (int e = 0; e < grid.size(); ++e) {
    field.x[e] = uniform(generator);
    field.y[e] = uniform(generator);
    field.n[e] = uniform(generator);
  }
  return field;
}

inline double dot(const contact::SurfaceField& a, const contact::SurfaceField& b) {
  return a.x.dot(b.x) + a.y.dot(b.y) + a.n.dot(b.n);
}

}  // namespace rollfem::testing
