// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/local_cells.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/discretisation/elastic_problem.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rollfem::fem {

std::size_t LocalDofs::owned_nodes() const {
  return with_ghosts->locally_owned_size() / 3;
}

std::size_t LocalDofs::nodes() const {
  return owned_nodes() + with_ghosts->n_ghost_indices() / 3;
}

std::vector<unsigned int> LocalDofs::owned_constrained() const {
  std::vector<unsigned int> result(fixed.begin(),
                                   fixed.begin() + static_cast<std::ptrdiff_t>(owned_fixed));
  for (std::size_t k = 0; k < owned_hanging; ++k)
    for (unsigned int c = 0; c < 3; ++c) result.push_back(3 * hanging[k].node + c);
  return result;
}

std::vector<unsigned int> lexicographic_positions(const dealii::FiniteElement<3>& element) {
  const auto* base = dynamic_cast<const dealii::FE_Q<3>*>(&element.base_element(0));
  if (base == nullptr || element.n_components() != 3 || base->degree > 2)
    throw contact::InputError("the matrix-free solver takes FE_Q(degree)^3 of degree 1 or 2");
  std::vector<unsigned int> positions;
  for (unsigned int component = 0; component < 3; ++component)
    for (const auto node : base->get_poly_space_numbering_inverse())
      positions.push_back(element.component_to_system_index(component, node));
  return positions;
}

namespace {

using GlobalIndex = dealii::types::global_dof_index;

/// Global numbers of the nodes of every owned cell in the kernel's order.
std::vector<GlobalIndex> cell_nodes(const dealii::DoFHandler<3>& dofs) {
  const auto positions = lexicographic_positions(dofs.get_fe());
  const std::size_t count = positions.size() / 3;
  std::vector<GlobalIndex> nodes, of_cell(positions.size());
  for (const auto& cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned()) {
      cell->get_dof_indices(of_cell);
      for (std::size_t k = 0; k < count; ++k) {
        const GlobalIndex first = of_cell[positions[k]];
        if (first % 3 != 0 || of_cell[positions[count + k]] != first + 1 ||
            of_cell[positions[2 * count + k]] != first + 2)
          throw std::logic_error(
              "the matrix-free solver takes nodes whose components are numbered consecutively");
        nodes.push_back(first / 3);
      }
    }
  return nodes;
}

void make_unique(std::vector<GlobalIndex>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Constraint of a node from deal.II's constraints.
class NodeConstraints {
 public:
  struct Master {
    GlobalIndex node;
    double weight;
  };

  explicit NodeConstraints(const dealii::AffineConstraints<double>& constraints)
      : constraints_(constraints) {}

  bool is_fixed(GlobalIndex node, unsigned int component) const {
    const auto* terms = terms_of(node, component);
    return terms != nullptr && terms->empty();
  }
  /// Empty: not a hanging node, or fixed in all components. deal.II drops fixed masters separately
  /// for each component; here the list contains the masters of all components, with value 0 if
  /// fixed.
  std::vector<Master> masters(GlobalIndex node) const {
    std::vector<Master> result;
    for (unsigned int c = 0; c < 3; ++c) {
      const auto* terms = terms_of(node, c);
      if (terms == nullptr) continue;
      for (const auto& [dof, weight] : *terms)
        if (weight_of(dof / 3, result) == 0.0) result.push_back({dof / 3, weight});
    }
    for (unsigned int c = 0; c < 3 && !result.empty(); ++c) check(node, c, result);
    return result;
  }

 private:
  using Terms = std::vector<std::pair<GlobalIndex, double>>;

  const Terms* terms_of(GlobalIndex node, unsigned int component) const {
    const GlobalIndex dof = 3 * node + component;
    const auto& known = constraints_.get_local_lines();
    return known.size() > 0 && !known.is_element(dof) ? nullptr
                                                      : constraints_.get_constraint_entries(dof);
  }
  static double weight_of(GlobalIndex node, const std::vector<Master>& masters) {
    for (const Master& master : masters)
      if (master.node == node) return master.weight;
    return 0.0;
  }
  void check(GlobalIndex node, unsigned int component, const std::vector<Master>& masters) const {
    constexpr double rounding = 1e-12;
    const auto* terms = terms_of(node, component);
    bool same = terms != nullptr;
    for (const Master& master : masters) {
      if (!same) break;
      const auto here = std::find_if(terms->begin(), terms->end(), [&](const auto& term) {
        return term.first == 3 * master.node + component;
      });
      same = here == terms->end() ? is_fixed(master.node, component)
                                  : std::abs(here->second - master.weight) < rounding &&
                                        std::abs(here->second - float(here->second)) < rounding;
    }
    if (!same) throw std::logic_error("a node hangs with one component and not with another");
  }

  const dealii::AffineConstraints<double>& constraints_;
};

void add_constraints(const std::vector<GlobalIndex>& used, const std::vector<GlobalIndex>& active,
                     const NodeConstraints& constraints, LocalDofs& dofs) {
  const auto local = [&](GlobalIndex node) {
    return dofs.with_ghosts->global_to_local(3 * node) / 3;
  };
  for (const auto node : used) {
    const unsigned int number = local(node);
    const auto masters = std::binary_search(active.begin(), active.end(), node)
                             ? constraints.masters(node)
                             : std::vector<NodeConstraints::Master>();
    for (unsigned int c = 0; c < 3 && masters.empty(); ++c)
      if (constraints.is_fixed(node, c)) dofs.fixed.push_back(3 * number + c);
    if (masters.empty()) continue;
    const auto first = static_cast<unsigned int>(dofs.terms.size());
    for (const auto& [master, weight] : masters)
      dofs.terms.push_back({local(master), static_cast<float>(weight)});
    dofs.hanging.push_back({number, first, static_cast<unsigned int>(dofs.terms.size())});
  }
  std::sort(dofs.fixed.begin(), dofs.fixed.end());
  std::sort(dofs.hanging.begin(), dofs.hanging.end(),
            [](const auto& a, const auto& b) { return a.node < b.node; });
  dofs.fixed.shrink_to_fit();
  dofs.hanging.shrink_to_fit();
  dofs.terms.shrink_to_fit();
}

std::shared_ptr<const LocalDofs> make_local_dofs(
    const dealii::DoFHandler<3>& dofs, const std::vector<GlobalIndex>& of_cells,
    const dealii::AffineConstraints<double>& all_constraints) {
  const NodeConstraints constraints(all_constraints);
  std::vector<GlobalIndex> active = of_cells;
  make_unique(active);
  std::vector<GlobalIndex> used = active;
  for (const auto node : active)
    for (const auto& master : constraints.masters(node)) used.push_back(master.node);
  make_unique(used);

  using dealii::Utilities::MPI::Partitioner;
  const auto communicator = dofs.get_communicator();
  const auto& owned = dofs.locally_owned_dofs();
  dealii::IndexSet ghosts(dofs.n_dofs());
  for (const auto node : used)
    if (!owned.is_element(3 * node)) ghosts.add_range(3 * node, 3 * node + 3);
  auto result = std::make_shared<LocalDofs>();
  result->owned_only = std::make_shared<Partitioner>(owned, communicator);
  result->with_ghosts = std::make_shared<Partitioner>(owned, ghosts, communicator);
  add_constraints(used, active, constraints, *result);
  const auto end = result->owned_nodes();
  result->owned_hanging = std::count_if(result->hanging.begin(), result->hanging.end(),
                                        [&](const auto& row) { return row.node < end; });
  result->owned_fixed =
      std::lower_bound(result->fixed.begin(), result->fixed.end(), 3 * end) - result->fixed.begin();
  return result;
}

/// Kernel data at the quadrature points of a cell, whose points begin with number `point`.
void set_points(const ElasticProblem& problem, const dealii::FEValues<3>& values,
                DilatationSpace& space, std::size_t point, LocalCells& cells) {
  const bool flows = has_inertia(problem), projected = projects_dilatation(problem);
  if (projected) space.reinit(values.get_quadrature_points(), values.get_JxW_values());
  for (const auto q : values.quadrature_point_indices()) {
    const double root = std::sqrt(values.JxW(q));
    const auto& inverse = values.inverse_jacobian(q);
    const std::size_t at = point + q;
    for (unsigned int e = 0; e < 3; ++e)
      for (unsigned int d = 0; d < 3; ++d)
        cells.geometry[9 * at + 3 * e + d] = root * inverse[e][d];
    if (flows) {
      const auto velocity = problem.motion.at(values.quadrature_point(q));
      const double scale = root * std::sqrt(problem.material.density);
      for (unsigned int e = 0; e < 3; ++e)
        cells.flow[3 * at + e] = scale * (velocity * dealii::Tensor<1, 3>(inverse[e]));
    }
    if (projected) {
      const auto functions = space.values(values.quadrature_point(q));
      const auto size = static_cast<std::size_t>(space.size());
      for (std::size_t k = 0; k < size; ++k)
        cells.dilatation[size * at + k] = root * functions[static_cast<int>(k)];
    }
  }
}

void add_geometry(const ElasticProblem& problem, LocalCells& cells) {
  const auto& dofs = problem.dofs;
  const dealii::QGauss<3> quadrature(dofs.get_fe().degree + 1);
  const int functions = DilatationSpace::size_of_degree(cells.degree);
  const auto make_room = [&](dealii::AlignedVector<double>& data, int values_of_a_point) {
    // Large enough for whole batches of the widest kernel.
    constexpr std::size_t widest = 16;
    const std::size_t of_a_cell = values_of_a_point * quadrature.size();
    data.reserve((cells.count + widest) * of_a_cell);
    data.resize_fast(cells.count * of_a_cell);
  };
  make_room(cells.geometry, 9);
  if (has_inertia(problem)) make_room(cells.flow, 3);
  if (projects_dilatation(problem)) make_room(cells.dilatation, functions);
  std::vector<dealii::DoFHandler<3>::active_cell_iterator> owned;
  for (const auto& cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned()) owned.push_back(cell);
  std::atomic<bool> valid{true};
  constexpr std::ptrdiff_t worth_a_thread = 500;
  const auto size = static_cast<std::ptrdiff_t>(owned.size());
  contact::for_each_piece(size, worth_a_thread, [&](std::ptrdiff_t first, std::ptrdiff_t end) {
    dealii::FEValues<3> values(problem.mapping, dofs.get_fe(), quadrature,
                               dealii::update_inverse_jacobians | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    DilatationSpace space(cells.degree);
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
      values.reinit(owned[k]);
      const auto& weights = values.get_JxW_values();
      if (std::any_of(weights.begin(), weights.end(), [](double w) { return !(w > 0); }))
        valid = false;
      else
        set_points(problem, values, space, k * quadrature.size(), cells);
    }
  });
  // All processes throw or none does.
  const bool valid_everywhere =
      cells.dofs->owned_only->n_mpi_processes() == 1
          ? valid.load()
          : dealii::Utilities::MPI::min(valid ? 1 : 0, dofs.get_communicator()) == 1;
  if (!valid_everywhere)
    throw contact::InputError("the mesh has a cell that is inside out: refine or smooth it");
}

/// Whether sqrt(det J) d xi / d x, given at the points of a cell, is constant up to a relative
/// tolerance; `mean`: its mean. `roots`: of the weights of the points.
bool is_straight(const double* geometry, const std::vector<double>& roots, double tolerance,
                 double* mean) {
  double size = 0.0, largest = 0.0;
  for (int i = 0; i < 9; ++i) {
    mean[i] = 0.0;
    for (std::size_t q = 0; q < roots.size(); ++q) mean[i] += geometry[9 * q + i] / roots[q];
    mean[i] /= static_cast<double>(roots.size());
    size += mean[i] * mean[i];
  }
  for (std::size_t q = 0; q < roots.size(); ++q) {
    double change = 0.0;
    for (int i = 0; i < 9; ++i) change += std::pow(geometry[9 * q + i] / roots[q] - mean[i], 2);
    largest = std::max(largest, change);
  }
  return largest < tolerance * tolerance * size;
}

}  // namespace

StraightCells::StraightCells(const LocalCells& cells, double tolerance) {
  const bool plain = tolerance > 0 && cells.flow.empty() && cells.dilatation.empty();
  const dealii::QGauss<3> quadrature(static_cast<unsigned int>(cells.degree) + 1);
  std::vector<double> roots;
  for (const double weight : quadrature.get_weights()) roots.push_back(std::sqrt(weight));
  if (plain) matrix.resize(9 * cells.count);
  std::vector<char> same(cells.count, 0);
  for_each_cells(plain ? cells.count : 0, [&](std::size_t cell, std::size_t end) {
    for (; cell < end; ++cell)
      same[cell] = is_straight(cells.geometry.data() + cell * roots.size() * 9, roots, tolerance,
                               &matrix[9 * cell])
                       ? 1
                       : 0;
  });
  for (std::size_t cell = 0; cell < cells.count; ++cell)
    (same[cell] != 0 ? straight : bent).push_back(cell);
}

LocalCells make_local_cells(const ElasticProblem& problem) {
  const auto& element = problem.dofs.get_fe();
  LocalCells cells;
  cells.degree = static_cast<int>(element.degree);
  cells.material = problem.material;
  const auto of_cells = cell_nodes(problem.dofs);
  cells.count = 3 * of_cells.size() / element.dofs_per_cell;
  cells.dofs = make_local_dofs(problem.dofs, of_cells, problem.constraints);
  cells.nodes.reserve(of_cells.size());
  for (const auto node : of_cells)
    cells.nodes.push_back(cells.dofs->with_ghosts->global_to_local(3 * node) / 3);
  add_geometry(problem, cells);
  return cells;
}

}  // namespace rollfem::fem
