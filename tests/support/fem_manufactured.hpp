// SPDX-License-Identifier: LGPL-2.1-or-later
// A smooth displacement on curved bodies whose load is known: for orders of convergence.
#pragma once

#include "fem/linear/linear_solver.hpp"
#include "fem/mesh/surface_shape.hpp"

#include "support/fem_fields.hpp"
#include "support/fem_test_support.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline constexpr double manufactured_extent = 12.0;  // mm
inline constexpr contact::Material manufactured_material{1000.0, 0.3};

/// A smooth displacement in chart coordinates that vanishes on the far boundary and is free on the
/// surface: u_c = amplitude_c cos(pi s / 2L) cos(pi t / 2L) cos(pi d / 2L) (1 + wave_c).
struct Manufactured {
  fem::SurfaceShape shape;

  dealii::Tensor<1, 3> displacement(const dealii::Point<3>& place) const {
    dealii::Tensor<1, 3> u;
    dealii::Tensor<2, 3> gradient;
    evaluate(place, u, gradient);
    return u;
  }
  dealii::Tensor<2, 3> gradient(const dealii::Point<3>& place) const {
    dealii::Tensor<1, 3> u;
    dealii::Tensor<2, 3> gradient;
    evaluate(place, u, gradient);
    return gradient;
  }

 private:
  void evaluate(const dealii::Point<3>& place, dealii::Tensor<1, 3>& u,
                dealii::Tensor<2, 3>& gradient) const {
    const auto chart = shape.coordinates(place);
    const fem::MeansInChart manifold = fem::surface_manifold(shape);
    const double k = dealii::numbers::PI / (2 * manufactured_extent);
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

inline dealii::Tensor<2, 3> stress_of(const dealii::Tensor<2, 3>& gradient) {
  return stress_of(gradient, manufactured_material);
}

inline fem::Vector manufactured_load(const fem::Body& body, const Manufactured& exact) {
  return load_of_stress(body.problem(), [&](const dealii::Point<3>& place) {
    return stress_of(exact.gradient(place));
  });
}

/// Squares in the energy norm: of the error of a displacement, and of the exact one.
inline std::array<double, 2> energies(const fem::Body& body, const Manufactured& exact,
                                      const fem::Vector& u) {
  std::array<double, 2> squares{};
  std::vector<dealii::Tensor<2, 3>> gradients;
  for_each_cell(
      body.problem(), body.dofs().get_fe().degree + 2, [&](const auto&, const auto& values) {
        gradients.resize(values.n_quadrature_points);
        values[dealii::FEValuesExtractors::Vector(0)].get_function_gradients(u, gradients);
        for (const unsigned int q : values.quadrature_point_indices()) {
          const auto gradient = exact.gradient(values.quadrature_point(q));
          const dealii::Tensor<2, 3> difference = gradients[q] - gradient;
          const double weight = values.JxW(q);
          squares[0] += scalar_product(stress_of(difference), difference) * weight;
          squares[1] += scalar_product(stress_of(gradient), gradient) * weight;
        }
      });
  for (double& square : squares) square = dealii::Utilities::MPI::sum(square, MPI_COMM_WORLD);
  return squares;
}

}  // namespace rollfem::testing
