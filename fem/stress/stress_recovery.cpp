// SPDX-License-Identifier: LGPL-2.1-or-later
// Superconvergent patch recovery, one patch of cells per cell rather than per vertex: cells at the
// surface then have the same rule as all others, and hanging nodes need no exception.
#include "fem/stress/stress_recovery.hpp"

#include "fem/discretisation/elastic_problem.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rollfem::fem {

namespace {

using contact::SymmetricTensor;
using dealii::Point;
using dealii::Tensor;
using GlobalIndex = dealii::types::global_dof_index;

/// Rounding tolerance of the distance from the symmetry plane y = 0, mm.
constexpr double on_plane = 1e-9;

/// Samples have the weight exp(-decay r^2), r their distance in cell lengths from the centre of the
/// cell.
constexpr double decay = 4.0;

/// Monomials of total degree <= degree.
class Polynomials {
 public:
  explicit Polynomials(unsigned int degree) {
    for (unsigned int i = 0; i <= degree; ++i)
      for (unsigned int j = 0; i + j <= degree; ++j)
        for (unsigned int k = 0; i + j + k <= degree; ++k) exponents_.push_back({i, j, k});
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(exponents_.size()); }
  Eigen::VectorXd at(const Point<3>& x) const {
    Eigen::VectorXd values(size());
    for (Eigen::Index m = 0; m < size(); ++m) {
      double value = 1.0;
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int n = 0; n < exponents_[m][d]; ++n) value *= x[d];
      values[m] = value;
    }
    return values;
  }

 private:
  std::vector<std::array<unsigned int, 3>> exponents_;
};

/// Affine coordinates in which a cell is approximately the cube [-1/2, 1/2]^3.
struct LocalFrame {
  Point<3> centre;
  Tensor<2, 3> inverse;
  Point<3> local(const Point<3>& place) const { return Point<3>(inverse * (place - centre)); }
};

template <class Cell>
LocalFrame local_frame(const Cell& cell) {
  LocalFrame frame;
  Tensor<2, 3> edges;
  for (unsigned int v = 0; v < 8; ++v) {
    frame.centre += cell->vertex(v) / 8.0;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int c = 0; c < 3; ++c)
        edges[c][d] += ((v >> d) % 2 == 1 ? 0.25 : -0.25) * cell->vertex(v)[c];
  }
  frame.inverse = dealii::invert(edges);
  return frame;
}

/// sigma : C^-1 : sigma, N/mm^2.
double energy_density(const contact::Material& material, const SymmetricTensor& s) {
  const double nu = material.poisson_ratio, trace = contact::trace(s);
  return ((1 + nu) * contact::product(s, s) - nu * trace * trace) / material.young_modulus;
}

}  // namespace

void add(double factor, const NodalStress& part, NodalStress& stress) {
  stress.direct.add(factor, part.direct);
  stress.shear.add(factor, part.shear);
  stress.direct.update_ghost_values();
  stress.shear.update_ghost_values();
}

struct StressRecovery::Implementation {
  /// A cell of this process or an adjacent one.
  struct CellData {
    dealii::DoFHandler<3>::active_cell_iterator cell;
    std::vector<GlobalIndex> dofs;
    std::vector<Point<3>> samples;      ///< positions of the superconvergent points
    std::vector<Tensor<2, 3>> inverse;  ///< d reference / d position there
    bool at_plane = false;              ///< has a face on the symmetry plane
  };
  /// A cell of this process: its nodes for the stress, and the cells of its patch.
  struct Patch {
    std::size_t cell;
    LocalFrame frame;
    std::vector<Point<3>> nodes;
    std::vector<std::size_t> cells;
  };

  explicit Implementation(const Body& the_body)
      : body(the_body),
        element(body.dofs().get_fe()),
        gauss(element.degree),
        polynomials(element.degree) {
    collect_cells();
    collect_patches();
    collect_shape_gradients();
    hanging.copy_from(make_constraints(body.dofs(), body.mapping(), {}));
    count_contributions();
  }

  void collect_cells() {
    dealii::FEValues<3> values(body.mapping(), element, gauss,
                               dealii::update_quadrature_points | dealii::update_inverse_jacobians);
    number.assign(body.dofs().get_triangulation().n_active_cells(), 0);
    for (const auto& cell : body.dofs().active_cell_iterators()) {
      if (cell->is_artificial()) continue;
      number[cell->active_cell_index()] = cells.size();
      CellData data;
      data.cell = cell;
      data.dofs.resize(element.dofs_per_cell);
      cell->get_dof_indices(data.dofs);
      values.reinit(cell);
      data.samples = values.get_quadrature_points();
      for (const unsigned int q : values.quadrature_point_indices()) {
        Tensor<2, 3> inverse;
        for (unsigned int i = 0; i < 3; ++i) inverse[i] = values.inverse_jacobian(q)[i];
        data.inverse.push_back(inverse);
      }
      if (body.options().half)
        for (const unsigned int v : cell->vertex_indices())
          data.at_plane = data.at_plane || std::abs(cell->vertex(v)[1]) < on_plane;
      cells.push_back(std::move(data));
    }
  }

  /// Cells that share a vertex, also those beyond a hanging face or edge.
  void collect_patches() {
    std::vector<std::vector<std::size_t>> around(body.dofs().get_triangulation().n_vertices());
    for (const auto& cell : body.dofs().active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          around[cell->vertex_index(v)].push_back(number[cell->active_cell_index()]);
    const dealii::Quadrature<3> at_nodes(element.base_element(0).get_unit_support_points());
    dealii::FEValues<3> values(body.mapping(), element, at_nodes, dealii::update_quadrature_points);
    for (const auto& cell : body.dofs().active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      values.reinit(cell);
      Patch patch{
          number[cell->active_cell_index()], local_frame(cell), values.get_quadrature_points(), {}};
      for (const unsigned int v : cell->vertex_indices()) {
        const auto& some = around[cell->vertex_index(v)];
        patch.cells.insert(patch.cells.end(), some.begin(), some.end());
      }
      std::sort(patch.cells.begin(), patch.cells.end());
      patch.cells.erase(std::unique(patch.cells.begin(), patch.cells.end()), patch.cells.end());
      patches.push_back(std::move(patch));
    }
  }

  void collect_shape_gradients() {
    for (unsigned int q = 0; q < gauss.size(); ++q)
      for (unsigned int i = 0; i < element.dofs_per_cell; ++i)
        shape_gradients.push_back(element.shape_grad(i, gauss.point(q)));
  }

  /// Stress at the superconvergent points of a cell: the Gauss points of the rule with degree^3
  /// points (Barlow 1976).
  std::vector<SymmetricTensor> sample(const CellData& cell, const Vector& displacement,
                                      CellStress& law) const {
    std::vector<SymmetricTensor> stress;
    law.reinit(cell.cell, displacement);
    std::vector<double> u(cell.dofs.size());
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = displacement(cell.dofs[i]);
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      Tensor<2, 3> by_reference;
      for (unsigned int i = 0; i < u.size(); ++i)
        by_reference[element.system_to_component_index(i).first] +=
            u[i] * shape_gradients[q * u.size() + i];
      stress.push_back(law.at(by_reference * cell.inverse[q], cell.samples[q]));
    }
    return stress;
  }

  /// Stress at the nodes of a cell by least squares over its patch.
  Eigen::MatrixXd fit(const Patch& patch,
                      const std::vector<std::vector<SymmetricTensor>>& stress) const {
    const Eigen::Index terms = polynomials.size();
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(terms, terms);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(terms, 6);
    const auto add = [&](const Point<3>& place, const Eigen::Matrix<double, 1, 6>& value) {
      const Point<3> local = patch.frame.local(place);
      const double weight = std::exp(-decay * local.square());
      const Eigen::VectorXd basis = polynomials.at(local);
      normal.noalias() += weight * basis * basis.transpose();
      right.noalias() += weight * basis * value;
    };
    const bool mirrored = cells[patch.cell].at_plane;
    for (const std::size_t c : patch.cells)
      for (std::size_t q = 0; q < stress[c].size(); ++q) {
        const Point<3>& at = cells[c].samples[q];
        const SymmetricTensor& s = stress[c][q];
        Eigen::Matrix<double, 1, 6> value;
        value << s[0], s[1], s[2], s[3], s[4], s[5];
        add(at, value);
        if (!mirrored || !cells[c].at_plane) continue;
        value[3] = -value[3];
        value[4] = -value[4];
        add(Point<3>(at[0], -at[1], at[2]), value);
      }
    // Where a patch is too thin for all terms, the smallest coefficients that fit.
    normal.diagonal().array() += 1e-12 * normal(0, 0);
    const Eigen::MatrixXd coefficients = normal.ldlt().solve(right);
    Eigen::MatrixXd result(patch.nodes.size(), 6);
    for (std::size_t a = 0; a < patch.nodes.size(); ++a)
      result.row(static_cast<Eigen::Index>(a)) =
          polynomials.at(patch.frame.local(patch.nodes[a])).transpose() * coefficients;
    return result;
  }

  GlobalIndex dof(const Patch& patch, unsigned int node, unsigned int component) const {
    return cells[patch.cell].dofs[element.component_to_system_index(component, node)];
  }

  void count_contributions() {
    contributions = make_vector(body.dofs());
    contributions.zero_out_ghost_values();
    for (const Patch& patch : patches)
      for (unsigned int a = 0; a < patch.nodes.size(); ++a)
        for (unsigned int c = 0; c < 3; ++c) {
          contributions(dof(patch, a, c)) += 1.0;
          if (body.options().half && std::abs(patch.nodes[a][1]) < on_plane && c < 2)
            vanishing.push_back(dof(patch, a, c));
        }
    contributions.compress(dealii::VectorOperation::add);
  }

  void finish(Vector& field) const {
    field.compress(dealii::VectorOperation::add);
    for (unsigned int i = 0; i < field.locally_owned_size(); ++i)
      field.local_element(i) /= contributions.local_element(i);
    hanging.distribute(field);
  }

  NodalStress recover(const Vector& displacement) const {
    std::vector<std::vector<SymmetricTensor>> stress;
    stress.reserve(cells.size());
    CellStress law(body.problem());
    for (const CellData& cell : cells) stress.push_back(sample(cell, displacement, law));
    NodalStress result{make_vector(body.dofs()), make_vector(body.dofs())};
    result.direct.zero_out_ghost_values();
    result.shear.zero_out_ghost_values();
    for (const Patch& patch : patches) {
      const Eigen::MatrixXd values = fit(patch, stress);
      for (unsigned int a = 0; a < patch.nodes.size(); ++a)
        for (unsigned int c = 0; c < 3; ++c) {
          result.direct(dof(patch, a, c)) += values(a, c);
          result.shear(dof(patch, a, c)) += values(a, 3 + c);
        }
    }
    finish(result.direct);
    finish(result.shear);
    // The mean with the mirror image.
    for (const GlobalIndex i : vanishing)
      if (result.shear.in_local_range(i)) result.shear(i) = 0.0;
    result.direct.update_ghost_values();
    result.shear.update_ghost_values();
    return result;
  }

  SymmetricTensor at_node(const Patch& patch, unsigned int node, const NodalStress& stress) const {
    SymmetricTensor value{};
    for (unsigned int c = 0; c < 3; ++c) {
      value[c] = stress.direct(dof(patch, node, c));
      value[3 + c] = stress.shear(dof(patch, node, c));
    }
    return value;
  }

  const Body& body;
  const dealii::FiniteElement<3>& element;
  dealii::QGauss<3> gauss;
  Polynomials polynomials;
  std::vector<std::size_t> number;  ///< of active cells in `cells`
  std::vector<CellData> cells;
  std::vector<Patch> patches;
  std::vector<Tensor<1, 3>> shape_gradients;  ///< reference, by point and unknown
  dealii::AffineConstraints<double> hanging;
  Vector contributions;                ///< cells around every node
  std::vector<GlobalIndex> vanishing;  ///< xy and yz on the symmetry plane
};

StressRecovery::StressRecovery(const Body& body)
    : implementation_(std::make_unique<Implementation>(body)) {}

StressRecovery::~StressRecovery() = default;

NodalStress StressRecovery::recover(const Vector& displacement) const {
  // Copies lack ghost values. NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
  Vector ghosted(displacement);
  ghosted.update_ghost_values();
  return implementation_->recover(ghosted);
}

std::vector<StressRecovery::Node> StressRecovery::nodes(
    const std::function<bool(const std::array<double, 3>&)>& chosen) const {
  const dealii::IndexSet& own = implementation_->body.dofs().locally_owned_dofs();
  std::map<GlobalIndex, Node> found;  // by the first unknown
  for (const auto& patch : implementation_->patches)
    for (unsigned int a = 0; a < patch.nodes.size(); ++a) {
      const std::array<double, 3> place{patch.nodes[a][0], patch.nodes[a][1], patch.nodes[a][2]};
      const auto unknown = [&](unsigned int c) { return implementation_->dof(patch, a, c); };
      if (own.is_element(unknown(0)) && chosen(place))
        found.insert({unknown(0), {place, {unknown(0), unknown(1), unknown(2)}}});
    }
  std::vector<Node> result;
  for (const auto& [unknown, node] : found) result.push_back(node);
  return result;
}

void StressRecovery::replace(const std::vector<Node>& nodes,
                             const std::vector<SymmetricTensor>& known, NodalStress& stress) const {
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (unsigned int c = 0; c < 3; ++c) {
      stress.direct(nodes[k].unknowns[c]) = known[k][c];
      stress.shear(nodes[k].unknowns[c]) = known[k][3 + c];
    }
  for (Vector* field : {&stress.direct, &stress.shear}) {
    field->zero_out_ghost_values();
    implementation_->hanging.distribute(*field);
    field->update_ghost_values();
  }
}

void StressRecovery::for_each_node(
    const NodalStress& stress,
    const std::function<void(const std::array<double, 3>&, const SymmetricTensor&, double)>& f)
    const {
  for (const auto& patch : implementation_->patches) {
    const double size = 1.0 / std::cbrt(dealii::determinant(patch.frame.inverse));
    for (unsigned int a = 0; a < patch.nodes.size(); ++a) {
      const auto& p = patch.nodes[a];
      f({p[0], p[1], p[2]}, implementation_->at_node(patch, a, stress), size);
    }
  }
}

EnergyError energy_error(const Body& body, const Vector& displacement, const NodalStress& stress) {
  const auto& element = body.dofs().get_fe();
  dealii::FEValues<3> values(body.mapping(), element, dealii::QGauss<3>(element.degree + 1),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Vector vector(0);
  const unsigned int points = values.n_quadrature_points;
  std::vector<dealii::Tensor<2, 3>> gradients(points);
  std::vector<dealii::Tensor<1, 3>> direct(points), shear(points);
  // Copies lack ghost values. NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
  Vector ghosted(displacement);
  ghosted.update_ghost_values();
  CellStress law(body.problem());
  double error = 0, energy = 0;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    law.reinit(cell, ghosted);
    values[vector].get_function_gradients(ghosted, gradients);
    values[vector].get_function_values(stress.direct, direct);
    values[vector].get_function_values(stress.shear, shear);
    for (unsigned int q = 0; q < points; ++q) {
      const SymmetricTensor own = law.at(gradients[q], values.quadrature_point(q));
      const SymmetricTensor recovered{direct[q][0], direct[q][1], direct[q][2],
                                      shear[q][0],  shear[q][1],  shear[q][2]};
      error += energy_density(body.material(), contact::sum(recovered, -1.0, own)) * values.JxW(q);
      energy += energy_density(body.material(), own) * values.JxW(q);
    }
  }
  const MPI_Comm communicator = body.dofs().get_communicator();
  return {std::sqrt(dealii::Utilities::MPI::sum(error, communicator)),
          std::sqrt(dealii::Utilities::MPI::sum(energy, communicator))};
}

}  // namespace rollfem::fem
