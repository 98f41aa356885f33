// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/elastic_problem.hpp"

#include "fem/mesh/surface_shape.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/component_mask.h>
#include <deal.II/fe/fe.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <cmath>

namespace rollfem::fem {

dealii::IndexSet relevant_dofs(const dealii::DoFHandler<3>& dofs) {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
  return relevant;
}

dealii::AffineConstraints<double> make_constraints(const dealii::DoFHandler<3>& dofs,
                                                   const dealii::Mapping<3>& mapping,
                                                   const BoundaryConditions& boundary) {
  dealii::AffineConstraints<double> constraints(relevant_dofs(dofs));
  dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
  const dealii::Functions::ZeroFunction<3> zero(3);
  for (const auto id : boundary.clamped)
    dealii::VectorTools::interpolate_boundary_values(mapping, dofs, id, zero, constraints);
  for (const auto& [id, component] : boundary.vanishing_component) {
    dealii::ComponentMask mask(3, false);
    mask.set(component, true);
    dealii::VectorTools::interpolate_boundary_values(mapping, dofs, id, zero, constraints, mask);
  }
  constraints.close();
  return constraints;
}

Vector make_vector(const dealii::DoFHandler<3>& dofs) {
  return Vector(dofs.locally_owned_dofs(), relevant_dofs(dofs), dofs.get_communicator());
}

MaterialMotion material_motion(const SurfaceShape& shape, double speed) {
  MaterialMotion motion;
  if (!shape.is_revolved()) {
    motion.velocity[0] = -speed;
    return motion;
  }
  const meshes::AxleTrace axle = shape.axle();
  const double rotation = speed / shape.rolling_radius;
  motion.centre = {0, 0, axle.height};
  motion.rotation = dealii::Tensor<1, 3>({0, rotation * axle.cosine, rotation * axle.sine});
  return motion;
}

double lame_lambda(const contact::Material& material) {
  const double nu = material.poisson_ratio;
  return material.young_modulus * nu / ((1 + nu) * (1 - 2 * nu));
}

double lame_mu(const contact::Material& material) {
  return material.young_modulus / (2 * (1 + material.poisson_ratio));
}

bool projects_dilatation(const ElasticProblem& problem) {
  if (problem.dofs.get_fe().degree > 2) return false;
  return problem.project_dilatation.value_or(problem.material.poisson_ratio >
                                             largest_plain_poisson_ratio);
}

bool has_inertia(const ElasticProblem& problem) {
  return !problem.motion.at_rest() && problem.material.density > 0;
}

std::array<double, DilatationSpace::largest_size> DilatationSpace::monomials(
    const dealii::Point<3>& place) const {
  std::array<double, largest_size> m{1, 0, 0, 0};
  for (int d = 0; d + 1 < size_; ++d) m[d + 1] = (place[d] - centre_[d]) / length_;
  return m;
}

void DilatationSpace::reinit(const std::vector<dealii::Point<3>>& places,
                             const std::vector<double>& weights) {
  double volume = 0;
  centre_ = dealii::Point<3>();
  for (std::size_t q = 0; q < places.size(); ++q) {
    volume += weights[q];
    centre_ += weights[q] * places[q];
  }
  centre_ /= volume;
  length_ = std::cbrt(volume);
  std::array<std::array<double, largest_size>, largest_size> gram{};
  for (std::size_t q = 0; q < places.size(); ++q) {
    const auto m = monomials(places[q]);
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j <= i; ++j) gram[i][j] += weights[q] * m[i] * m[j];
  }
  for (int i = 0; i < size_; ++i)
    for (int j = 0; j <= i; ++j) {
      double rest = gram[i][j];
      for (int k = 0; k < j; ++k) rest -= factor_[i][k] * factor_[j][k];
      factor_[i][j] = i == j ? std::sqrt(rest) : rest / factor_[j][j];
    }
}

std::array<double, DilatationSpace::largest_size> DilatationSpace::values(
    const dealii::Point<3>& place) const {
  auto v = monomials(place);
  for (int i = 0; i < size_; ++i) {
    for (int k = 0; k < i; ++k) v[i] -= factor_[i][k] * v[k];
    v[i] /= factor_[i][i];
  }
  return v;
}

dealii::Tensor<2, 3> tensor_of(const contact::SymmetricTensor& components) {
  dealii::Tensor<2, 3> tensor;
  for (unsigned int c = 0; c < 3; ++c) tensor[c][c] = components[c];
  tensor[0][1] = tensor[1][0] = components[3];
  tensor[1][2] = tensor[2][1] = components[4];
  tensor[0][2] = tensor[2][0] = components[5];
  return tensor;
}

contact::SymmetricTensor components_of(const dealii::Tensor<2, 3>& t) {
  return {t[0][0], t[1][1], t[2][2], t[0][1], t[1][2], t[0][2]};
}

CellStress::CellStress(const ElasticProblem& problem)
    : lambda_(lame_lambda(problem.material)),
      mu_(lame_mu(problem.material)),
      space_(static_cast<int>(problem.dofs.get_fe().degree)) {
  if (!projects_dilatation(problem)) return;
  const auto& element = problem.dofs.get_fe();
  values_ = std::make_unique<dealii::FEValues<3>>(
      problem.mapping, element, dealii::QGauss<3>(element.degree + 1),
      dealii::update_gradients | dealii::update_quadrature_points | dealii::update_JxW_values);
  divergences_.resize(values_->n_quadrature_points);
}

void CellStress::reinit(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                        const Vector& displacement) {
  if (!values_) return;
  values_->reinit(cell);
  space_.reinit(values_->get_quadrature_points(), values_->get_JxW_values());
  (*values_)[dealii::FEValuesExtractors::Vector(0)].get_function_divergences(displacement,
                                                                             divergences_);
  coefficients_ = {};
  for (const auto q : values_->quadrature_point_indices()) {
    const auto functions = space_.values(values_->quadrature_point(q));
    for (int k = 0; k < space_.size(); ++k)
      coefficients_[k] += values_->JxW(q) * functions[k] * divergences_[q];
  }
}

contact::SymmetricTensor CellStress::at(const dealii::Tensor<2, 3>& g,
                                        const dealii::Point<3>& place) const {
  double dilatation = dealii::trace(g);
  if (values_) {
    const auto functions = space_.values(place);
    dilatation = 0;
    for (int k = 0; k < space_.size(); ++k) dilatation += coefficients_[k] * functions[k];
  }
  const double spherical = lambda_ * dilatation;
  return {spherical + 2 * mu_ * g[0][0], spherical + 2 * mu_ * g[1][1],
          spherical + 2 * mu_ * g[2][2], mu_ * (g[0][1] + g[1][0]),
          mu_ * (g[1][2] + g[2][1]),     mu_ * (g[0][2] + g[2][0])};
}

}  // namespace rollfem::fem
