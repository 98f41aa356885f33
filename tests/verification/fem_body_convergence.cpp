// SPDX-License-Identifier: LGPL-2.1-or-later
// Manufactured solution on curved bodies: error of order degree + 1 in displacement and degree in
// stress.
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

void expect_order(const fem::SurfaceShape& shape, double cell_size, int degree) {
  const auto coarse = errors(shape, cell_size, degree);
  const auto fine = errors(shape, 0.5 * cell_size, degree);
  const double order = std::log2(coarse.displacement / fine.displacement);
  const double energy_order = std::log2(coarse.energy / fine.energy);
  EXPECT_NEAR(order, degree + 1, 0.25) << coarse.displacement << " -> " << fine.displacement;
  EXPECT_NEAR(energy_order, degree, 0.2) << coarse.energy << " -> " << fine.energy;
  EXPECT_LT(fine.displacement, degree == 1 ? 0.05 : 2e-3);
  record("order_of_displacement", order);
  record("order_of_energy", energy_order);
  record("error", fine.displacement);
}

TEST(ManufacturedSolution, QuadraticElementsOnAConvexWheel) {
  expect_order(wheel_shape(40, 30), 3.0, 2);
}

TEST(ManufacturedSolution, QuadraticElementsOnAConcaveWheel) {
  expect_order(wheel_shape(60, -40), 3.0, 2);
}

TEST(ManufacturedSolution, QuadraticElementsOnARail) {
  expect_order(rail_shape(20), 3.0, 2);
}

TEST(ManufacturedSolution, LinearElementsOnARail) {
  expect_order(rail_shape(20), 1.5, 1);
}

}  // namespace
