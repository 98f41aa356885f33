// A smooth displacement on curved bodies whose load is known: for orders of convergence.
#pragma once

#include "fem/linear/linear_solver.hpp"
#include "fem/mesh/chart.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "support/fem_test_support.hpp"
#include <array>
#include <cmath>

namespace rollfem::testing {

inline constexpr double manufactured_extent = 12.0;  // mm
inline constexpr contact::Material manufactured_material{1000.0, 0.3};

/// A smooth displacement in chart coordinates that vanishes on the far boundary and is free on the
/// surface: u_c = amplitude_c cos(pi s / 2L) cos(pi t / 2L) cos(pi d / 2L) (1 + wave_c).
struct Manufactured {
  fem::SurfaceShape shape;

  void evaluate(const dealii::Point<3>& place, dealii::Tensor<1, 3>& u,
                dealii::Tensor<2, 3>& gradient) const {
    const auto chart = shape.coordinates(place);
    const fem::SurfaceManifold manifold(shape);
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
  const double nu = manufactured_material.poisson_ratio;
  const double mu = manufactured_material.young_modulus / (2 * (1 + nu));
  dealii::Tensor<2, 3> stress = mu * (gradient + transpose(gradient));
  for (unsigned int d = 0; d < 3; ++d) stress[d][d] += 2 * mu * nu / (1 - 2 * nu) * trace(gradient);
  return stress;
}

/// int sigma(u_exact) : grad N, so that surface tractions need not be written down.
inline fem::Vector manufactured_load(const fem::Body& body, const Manufactured& exact) {
  const auto& element = body.dofs().get_fe();
  dealii::FEValues<3> values(
      body.mapping(), element, dealii::QGauss<3>(element.degree + 2),
      dealii::update_gradients | dealii::update_quadrature_points | dealii::update_JxW_values);
  auto b = fem::make_vector(body.dofs());
  b.zero_out_ghost_values();
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  dealii::Tensor<1, 3> displacement;
  dealii::Tensor<2, 3> gradient;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
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
  b.compress(dealii::VectorOperation::add);
  return b;
}

}  // namespace rollfem::testing
