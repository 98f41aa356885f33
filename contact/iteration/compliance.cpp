// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/compliance.hpp"

namespace rollfem::contact {

namespace {

Field difference(const ContactGrid& grid, const Field& u, UpwindOrder order) {
  Field result = Field::Zero(grid.size());
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i + 1 < grid.nx; ++i) {
      const int k = grid.index(i, j);
      const bool second = order == UpwindOrder::second && i + 2 < grid.nx;
      result[k] = second ? (3.0 * u[k] - 4.0 * u[k + 1] + u[k + 2]) / (2.0 * grid.dx)
                         : (u[k] - u[k + 1]) / grid.dx;
    }
    if (grid.nx > 1) result[grid.index(grid.nx - 1, j)] = result[grid.index(grid.nx - 2, j)];
  }
  return result;
}

}  // namespace

TangentialField upwind_difference(const ContactGrid& grid, const TangentialField& displacement,
                                  UpwindOrder order) {
  return {difference(grid, displacement.x, order), difference(grid, displacement.y, order)};
}

double upstream_of_spin(UpwindOrder order, double step) {
  return order == UpwindOrder::first ? step / 6.0 : 0.0;
}

}  // namespace rollfem::contact
