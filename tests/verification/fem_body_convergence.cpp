// Manufactured solution on curved bodies: error of order degree + 1 in displacement and degree in
// stress.
#include "fem/chart.hpp"
#include "fem/factorisation.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "fem_test_support.hpp"
#include <array>
#include <cmath>

using namespace rollfem;
using namespace rollfem::test;

namespace {

constexpr double extent = 12.0;  // mm
constexpr contact::Material material{1000.0, 0.3};

/// A smooth displacement in chart coordinates that vanishes on the far boundary and is free on the
/// surface: u_c = amplitude_c cos(pi s / 2L) cos(pi t / 2L) cos(pi d / 2L) (1 + wave_c).
struct Manufactured {
  fem::SurfaceShape shape;

  void evaluate(const dealii::Point<3>& place, dealii::Tensor<1, 3>& u,
                dealii::Tensor<2, 3>& gradient) const {
    const auto chart = shape.coordinates(place);
    const fem::SurfaceManifold manifold(shape);
    const double k = dealii::numbers::PI / (2 * extent);
    std::array<double, 3> c{}, s{};
    for (unsigned int d = 0; d < 3; ++d) {
      c[d] = std::cos(k * chart[d]);
      s[d] = std::sin(k * chart[d]);
    }
    const double bump = c[0] * c[1] * c[2];
    const dealii::Tensor<1, 3> slope(
        {-k * s[0] * c[1] * c[2], -k * c[0] * s[1] * c[2], -k * c[0] * c[1] * s[2]});
    dealii::Tensor<2, 3> by_chart;
    for (unsigned int i = 0; i < 3; ++i) {
      const double phase = 0.3 * chart[i] + 0.2 * chart[(i + 1) % 3] + i;
      const double factor = 1 + 0.5 * std::sin(phase);
      u[i] = 1e-3 * bump * factor;
      by_chart[i] = 1e-3 * factor * slope;
      by_chart[i][i] += 1e-3 * bump * 0.5 * std::cos(phase) * 0.3;
      by_chart[i][(i + 1) % 3] += 1e-3 * bump * 0.5 * std::cos(phase) * 0.2;
    }
    const dealii::DerivativeForm<1, 3, 3> form = manifold.push_forward_gradient(chart);
    dealii::Tensor<2, 3> by_place;
    for (unsigned int i = 0; i < 3; ++i) by_place[i] = form[i];
    gradient = by_chart * invert(by_place);
  }
};

dealii::Tensor<2, 3> stress_of(const dealii::Tensor<2, 3>& gradient) {
  const double nu = material.poisson_ratio;
  const double mu = material.young_modulus / (2 * (1 + nu));
  dealii::Tensor<2, 3> stress = mu * (gradient + transpose(gradient));
  for (unsigned int d = 0; d < 3; ++d) stress[d][d] += 2 * mu * nu / (1 - 2 * nu) * trace(gradient);
  return stress;
}

struct Errors {
  double displacement;  ///< L2, relative
  double energy;        ///< energy norm, relative
};

/// The load is int sigma(u_exact) : grad N, so that surface tractions need not be written down.
Errors errors(const fem::SurfaceShape& shape, double cell_size, int degree) {
  fem::BodyOptions options;
  options.cell_size = cell_size;
  options.fine_half_length = options.fine_half_width = options.extent = extent;
  options.fine_depth = extent / cell_size;
  options.degree = degree;
  const fem::Body body(shape, material, options, MPI_COMM_SELF);
  const Manufactured exact{shape};
  const auto& element = body.dofs().get_fe();
  const dealii::FEValuesExtractors::Vector vector(0);
  dealii::FEValues<3> values(body.mapping(), element, dealii::QGauss<3>(degree + 2),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  auto b = fem::make_vector(body.dofs());
  auto u = fem::make_vector(body.dofs());
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  dealii::Tensor<1, 3> displacement;
  dealii::Tensor<2, 3> gradient;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    for (const unsigned int q : values.quadrature_point_indices()) {
      exact.evaluate(values.quadrature_point(q), displacement, gradient);
      const auto stress = stress_of(gradient) * values.JxW(q);
      for (unsigned int i = 0; i < indices.size(); ++i)
        b(indices[i]) +=
            stress[element.system_to_component_index(i).first] * values.shape_grad(i, q);
    }
  }
  fem::make_factorisation(body.problem())->solve(u, b);
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
