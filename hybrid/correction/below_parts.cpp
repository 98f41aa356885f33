// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/correction/below_parts.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "result/stress_measures.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace rollfem::hybrid {

using contact::BelowSurface;
using Eigen::Index;
using Eigen::MatrixXd;
using fem::Body;
using fem::Vector;
using halfspace::SubsurfacePoint;

namespace {

constexpr int components = smooth_components;
constexpr int depth_degree = 6;

/// Largest rounding distance between a node of the twin and the rolled-out node of the body, mm.
constexpr double same_place = 1e-5;

/// Signs of displacement and stress at -y under loads symmetric about y = 0.
constexpr std::array<double, components> mirror{1, -1, 1, 1, 1, 1, -1, -1, 1};

/// From global axes to the local axes.
void turn(const contact::Axes& axes, Eigen::Ref<Eigen::RowVectorXd> state) {
  const auto u = contact::into_axes(axes, contact::Vector3{state[0], state[1], state[2]});
  const auto s = contact::into_axes(
      axes, contact::SymmetricTensor{state[3], state[4], state[5], state[6], state[7], state[8]});
  state << u[0], u[1], u[2], s[0], s[1], s[2], s[3], s[4], s[5];
}

}  // namespace

GaussStates::GaussStates(const Body& body, const std::vector<unsigned int>& numbers) : body_(body) {
  const dealii::FiniteElement<3>& element = body.dofs().get_fe();
  dealii::FEValues<3> values(
      body.mapping(), element, dealii::QGauss<3>(std::max(2u, element.degree)),
      dealii::update_quadrature_points | dealii::update_gradients | dealii::update_values);
  std::size_t next = 0;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (next == numbers.size()) break;
    if (cell->active_cell_index() != numbers[next]) continue;
    ++next;
    values.reinit(cell);
    cells_.push_back(cell);
    for (const unsigned int q : values.quadrature_point_indices()) {
      places_.push_back(values.quadrature_point(q));
      gradients_.emplace_back();
      values_.emplace_back();
      for (unsigned int i = 0; i < element.dofs_per_cell; ++i) {
        gradients_.back().push_back(values.shape_grad(i, q));
        values_.back().push_back(values.shape_value(i, q));
      }
    }
  }
}

MatrixXd GaussStates::at(const Vector& displacement) const {
  const dealii::FiniteElement<3>& element = body_.dofs().get_fe();
  MatrixXd states(static_cast<Index>(places_.size()), components);
  fem::CellStress law(body_.problem());
  std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
  const std::size_t points = cells_.empty() ? 0 : places_.size() / cells_.size();
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    law.reinit(cells_[c], displacement);
    cells_[c]->get_dof_indices(dofs);
    for (std::size_t k = c * points; k < (c + 1) * points; ++k) {
      dealii::Tensor<2, 3> gradient;
      dealii::Tensor<1, 3> u;
      for (unsigned int i = 0; i < dofs.size(); ++i) {
        const unsigned int axis = element.system_to_component_index(i).first;
        gradient[axis] += displacement(dofs[i]) * gradients_[k][i];
        u[axis] += displacement(dofs[i]) * values_[k][i];
      }
      const auto s = law.at(gradient, places_[k]);
      states.row(static_cast<Index>(k)) << u[0], u[1], u[2], s[0], s[1], s[2], s[3], s[4], s[5];
    }
  }
  return states;
}

BelowParts::BelowParts(const BelowSurface& coordinates, const Body& body, const Body& twin,
                       const FlatLoads& loads, const SmoothBox& box, double depth)
    : coordinates_(coordinates),
      loads_(loads),
      box_(box),
      depth_(depth),
      material_(body.material()),
      wheel_(body.shape().is_wheel),
      half_(body.options().half) {
  std::vector<unsigned int> cells;
  auto other = twin.dofs().begin_active();
  const bool alike = body.triangulation().n_active_cells() == twin.triangulation().n_active_cells();
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!alike) break;
    const dealii::Point<3> middle = other->center();
    const double inwards = wheel_ ? middle[2] : -middle[2];
    if (std::abs(middle[0]) < 1.2 * box.half_length &&
        std::abs(middle[1] - box.middle) < 1.2 * box.half_width && inwards < 1.2 * depth) {
      cells.push_back(cell->active_cell_index());
      for (const unsigned int v : cell->vertex_indices())
        if (twin.shape()
                .coordinates(other->vertex(v))
                .distance(body.shape().coordinates(cell->vertex(v))) > same_place)
          throw contact::SolveError("the meshes of a body and its flattened twin differ");
    }
    ++other;
  }
  if (!alike) throw contact::SolveError("the meshes of a body and its flattened twin differ");
  body_ = std::make_unique<GaussStates>(body, cells);
  twin_ = std::make_unique<GaussStates>(twin, cells);
  choose_points();
  add_half_space();
  prepare_fit();
}

int BelowParts::degree() const {
  return depth_degree;
}

Index BelowParts::terms() const {
  return components * even_.cols();
}

void BelowParts::choose_points() {
  double deepest = 0.0;
  for (std::size_t k = 0; k < body_->points().size(); ++k) {
    const auto& place = body_->points()[k];
    const auto at = coordinates_.coordinates({place[0], place[1], place[2]});
    const bool inside = at.spread > BelowSurface::least_spread &&
                        std::abs(at.x) <= box_.half_length &&
                        std::abs(at.y - box_.middle) <= box_.half_width && at.depth <= depth_;
    if (!inside) continue;
    const auto& flat = twin_->points()[k];
    rows_.push_back(static_cast<Index>(k));
    at_.push_back(at);
    flat_.push_back({flat[0], flat[1], wheel_ ? flat[2] : -flat[2]});
    deepest = std::max(deepest, at.depth);
  }
  depth_ = deepest;
}

/// All loads at once: their potentials are sums of the potentials of the rectangles.
void BelowParts::add_half_space() {
  const Index count = loads_.shapes.cols();
  const double nu = material_.poisson_ratio;
  const double side = wheel_ ? 1.0 : -1.0;
  const double of_displacement = 1.0 / (4.0 * contact::pi * fem::lame_mu(material_));
  const double of_stress = 1.0 / (2.0 * contact::pi);
  for (MatrixXd& moved : moved_)
    moved = MatrixXd::Zero(components * static_cast<Index>(rows_.size()), count);
  MatrixXd potentials(halfspace::potential_count, static_cast<Index>(loads_.rectangles.size()));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(halfspace::potential_count);
  const auto add = [&](Index point, const SubsurfacePoint& at, double factor) {
    for (Index r = 0; r < potentials.cols(); ++r) {
      const auto& rectangle = loads_.rectangles[static_cast<std::size_t>(r)];
      potentials.col(r) = halfspace::rectangle_potentials(at.x - rectangle.x, at.y - rectangle.y,
                                                          at.depth, rectangle.dx, rectangle.dy);
    }
    const MatrixXd sums = potentials * loads_.shapes;
    for (Index k = 0; k < count; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double* p[] = {none.data(), none.data(), none.data()};
        p[axis] = sums.col(k).data();
        const auto s = halfspace::assemble_state<double>(p[0], p[1], p[2], nu, at.depth);
        // The rail is the mirror image of the wheel in z = 0 (halfspace/stress/subsurface.cpp).
        const double sign = factor * (axis < 2 ? side : 1.0);
        auto rows = moved_[axis].col(k).segment<components>(components * point);
        using namespace halfspace;
        rows.head<3>() += sign * of_displacement * Eigen::Vector3d(s[u_x], s[u_y], side * s[u_z]);
        Eigen::Matrix<double, 6, 1> stress;
        stress << s[s_xx], s[s_yy], s[s_zz], s[s_xy], side * s[s_yz], side * s[s_xz];
        rows.tail<6>() += sign * of_stress * stress;
      }
  };
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const SubsurfacePoint own{at_[k].x, at_[k].y, at_[k].depth};
    const double apart = std::abs(own.x - flat_[k].x) + std::abs(own.y - flat_[k].y) +
                         std::abs(own.depth - flat_[k].depth);
    if (apart < 1e-3 * same_place) continue;
    add(static_cast<Index>(k), flat_[k], 1.0);
    add(static_cast<Index>(k), own, -1.0);
  }
}

void BelowParts::prepare_fit() {
  const Index terms = depth_polynomial_count(depth_degree);
  MatrixXd own(static_cast<Index>(rows_.size()), terms);
  MatrixXd image = MatrixXd::Zero(own.rows(), terms);
  for (Index k = 0; k < own.rows(); ++k) {
    const auto& at = at_[static_cast<std::size_t>(k)];
    own.row(k) = depth_polynomials(box_, depth_, depth_degree, {at.x, at.y, at.depth});
    if (half_)
      image.row(k) = depth_polynomials(box_, depth_, depth_degree, {at.x, -at.y, at.depth});
  }
  if (own.rows() < 2 * terms)
    throw contact::SolveError("there are too few cells in the patch to find stresses below it");
  even_ = own + image;
  odd_ = own - image;
  normal_.compute(own.transpose() * own + image.transpose() * image);
}

MatrixXd BelowParts::beyond(int component, Index shape, const Vector& body,
                            const Vector& twin) const {
  const MatrixXd of_body = body_->at(body);
  const MatrixXd of_twin = twin_->at(twin);
  MatrixXd result(static_cast<Index>(rows_.size()), components);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Eigen::RowVectorXd state = of_body.row(rows_[k]);
    turn(at_[k].axes, state);
    result.row(static_cast<Index>(k)) = state - of_twin.row(rows_[k]) +
                                        moved_[static_cast<std::size_t>(component)]
                                            .col(shape)
                                            .segment<components>(components * static_cast<Index>(k))
                                            .transpose();
  }
  return result;
}

Eigen::VectorXd BelowParts::fitted(const MatrixXd& beyond) const {
  const Index terms = even_.cols();
  Eigen::VectorXd coefficients(components * terms);
  for (int c = 0; c < components; ++c)
    coefficients.segment(c * terms, terms) = normal_.solve(
        (mirror[static_cast<std::size_t>(c)] > 0.0 ? even_ : odd_).transpose() * beyond.col(c));
  return coefficients;
}

}  // namespace rollfem::hybrid
