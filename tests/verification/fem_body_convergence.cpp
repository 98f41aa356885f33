// Manufactured solution on curved bodies: error of order degree + 1 in displacement and degree in
// stress.
#include "fem/linear/factorisation.hpp"

#include "support/fem_manufactured.hpp"
#include "support/recorded.hpp"
#include <cmath>

using namespace rollfem;
using namespace rollfem::testing;

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
  const auto& element = body.dofs().get_fe();
  const dealii::FEValuesExtractors::Vector vector(0);
  dealii::FEValues<3> values(body.mapping(), element, dealii::QGauss<3>(degree + 2),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  auto u = fem::make_vector(body.dofs());
  dealii::Tensor<1, 3> displacement;
  dealii::Tensor<2, 3> gradient;
  fem::make_factorisation(body.problem())->solve(u, manufactured_load(body, exact));
  double l2 = 0, l2_exact = 0, energy = 0, energy_exact = 0;
  std::vector<dealii::Tensor<1, 3>> fe_values(values.n_quadrature_points);
  std::vector<dealii::Tensor<2, 3>> fe_gradients(values.n_quadrature_points);
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    values.reinit(cell);
    values[vector].get_function_values(u, fe_values);
    values[vector].get_function_gradients(u, fe_gradients);
    for (const unsigned int q : values.quadrature_point_indices()) {
      exact.evaluate(values.quadrature_point(q), displacement, gradient);
      const dealii::Tensor<2, 3> difference = fe_gradients[q] - gradient;
      l2 += (fe_values[q] - displacement).norm_square() * values.JxW(q);
      l2_exact += displacement.norm_square() * values.JxW(q);
      energy += scalar_product(stress_of(difference), difference) * values.JxW(q);
      energy_exact += scalar_product(stress_of(gradient), gradient) * values.JxW(q);
    }
  }
  return {std::sqrt(l2 / l2_exact), std::sqrt(energy / energy_exact)};
}

void expect_order(const fem::SurfaceShape& shape, double cell_size, int degree) {
  const auto coarse = errors(shape, cell_size, degree);
  const auto fine = errors(shape, 0.5 * cell_size, degree);
  const double order = std::log2(coarse.displacement / fine.displacement);
  const double energy_order = std::log2(coarse.energy / fine.energy);
  EXPECT_NEAR(order, degree + 1, 0.25) << coarse.displacement << " -> " << fine.displacement;
  EXPECT_NEAR(energy_order, degree, 0.2) << coarse.energy << " -> " << fine.energy;
  EXPECT_LT(fine.displacement, degree == 1 ? 0.05 : 2e-3);
  rollfem::testing::record("order_of_displacement", order);
  rollfem::testing::record("order_of_energy", energy_order);
  rollfem::testing::record("error", fine.displacement);
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
