// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/cell_terms.hpp"

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace rollfem::fem {

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
