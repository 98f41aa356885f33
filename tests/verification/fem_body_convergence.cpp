// SPDX-License-Identifier: LGPL-2.1-or-later
// Manufactured solution on curved bodies: orders of displacement and stress, which the book judges.
#include "fem/linear/factorisation.hpp"

#include "support/fem_manufactured.hpp"
#include "support/recorded.hpp"

namespace {

struct Errors {
  double displacement;  ///< L2, relative
  double energy;        ///< energy norm, relative
};

Errors errors(const fem::SurfaceShape& shape, double cell_size, int degree) {
  fem::BodyOptions options;
  options.cell_size = cell_size;
  options.fine_half_length = options.fine_half_width = options.extent = manufactured_extent;
  options.fine_depth = manufactured_extent / cell_size;
  options.degree = degree;
  const fem::Body body(shape, manufactured_material, options, MPI_COMM_SELF);
  const Manufactured exact{shape};
  auto u = fem::make_vector(body.dofs());
  fem::make_factorisation(body.problem())->solve(u, manufactured_load(body, exact));
  const auto [error, whole] = energies(body, exact, u);
  return {displacement_error(body.problem(), u,
                             [&](const dealii::Point<3>& p) { return exact.displacement(p); }),
          std::sqrt(error / whole)};
}

void record_order(const fem::SurfaceShape& shape, double cell_size, int degree) {
  const auto coarse = errors(shape, cell_size, degree);
  const auto fine = errors(shape, 0.5 * cell_size, degree);
  record("order_of_displacement", std::log2(coarse.displacement / fine.displacement));
  record("order_of_energy", std::log2(coarse.energy / fine.energy));
  record("error", fine.displacement);
}

TEST(ManufacturedSolution, QuadraticElementsOnAConvexWheel) {
  record_order(wheel_shape(40, 30), 3.0, 2);
}

TEST(ManufacturedSolution, QuadraticElementsOnAConcaveWheel) {
  record_order(wheel_shape(60, -40), 3.0, 2);
}

TEST(ManufacturedSolution, QuadraticElementsOnARail) {
  record_order(rail_shape(20), 3.0, 2);
}

TEST(ManufacturedSolution, LinearElementsOnARail) {
  record_order(rail_shape(20), 1.5, 1);
}

}  // namespace
