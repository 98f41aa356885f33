// Collects what the matrix-free operator needs from deal.II: local numbers, constraints, geometry.
#include "contact/base/errors.hpp"
#include "fem/solver/cell_terms.hpp"
#include "fem/solver/elasticity_operator.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

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

/// Global dofs of every owned cell in the kernel's order.
std::vector<GlobalIndex> cell_dofs(const dealii::DoFHandler<3>& dofs) {
  const auto positions = lexicographic_positions(dofs.get_fe());
  std::vector<GlobalIndex> indices, of_cell(positions.size());
  for (const auto& cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned()) {
      cell->get_dof_indices(of_cell);
      for (const auto position : positions) indices.push_back(of_cell[position]);
    }
  return indices;
}

std::shared_ptr<const LocalDofs> make_local_dofs(
    const dealii::DoFHandler<3>& dofs, const std::vector<GlobalIndex>& of_cells,
    const dealii::AffineConstraints<double>& constraints) {
  std::vector<GlobalIndex> active = of_cells;
  std::sort(active.begin(), active.end());
  active.erase(std::unique(active.begin(), active.end()), active.end());
  std::vector<GlobalIndex> used = active;
  for (const auto dof : active)
    if (const auto* terms = constraints.get_constraint_entries(dof))
      for (const auto& term : *terms) used.push_back(term.first);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  using dealii::Utilities::MPI::Partitioner;
  const auto communicator = dofs.get_communicator();
  dealii::IndexSet ghosts(dofs.n_dofs());
  ghosts.add_indices(used.begin(), used.end());
  auto result = std::make_shared<LocalDofs>();
  result->owned_only = std::make_shared<Partitioner>(dofs.locally_owned_dofs(), communicator);
  result->with_ghosts =
      std::make_shared<Partitioner>(dofs.locally_owned_dofs(), ghosts, communicator);
  for (const auto dof : active)
    if (constraints.is_constrained(dof)) {
      ConstrainedRow row{};
      row.row = result->with_ghosts->global_to_local(dof);
      row.first_term = static_cast<unsigned int>(result->terms.size());
      for (const auto& term : *constraints.get_constraint_entries(dof))
        result->terms.push_back({result->with_ghosts->global_to_local(term.first), term.second});
      row.end_of_terms = static_cast<unsigned int>(result->terms.size());
      result->constrained.push_back(row);
    }
  std::sort(result->constrained.begin(), result->constrained.end(),
            [](const auto& a, const auto& b) { return a.row < b.row; });
  const auto owned = result->with_ghosts->locally_owned_size();
  result->owned_constrained = std::count_if(result->constrained.begin(), result->constrained.end(),
                                            [&](const auto& row) { return row.row < owned; });
  return result;
}

/// What the kernel reads at the quadrature points of one cell.
void add_points(const ElasticProblem& problem, const dealii::FEValues<3>& values,
                DilatationSpace& space, LocalCells& cells) {
  const bool flows = has_inertia(problem), projected = projects_dilatation(problem);
  if (projected) space.reinit(values.get_quadrature_points(), values.get_JxW_values());
  for (const auto q : values.quadrature_point_indices()) {
    const double root = std::sqrt(values.JxW(q));
    const auto& inverse = values.inverse_jacobian(q);
    for (unsigned int e = 0; e < 3; ++e)
      for (unsigned int d = 0; d < 3; ++d) cells.geometry.push_back(root * inverse[e][d]);
    if (flows) {
      const auto velocity = problem.motion.at(values.quadrature_point(q));
      const double scale = root * std::sqrt(problem.material.density);
      for (unsigned int e = 0; e < 3; ++e)
        cells.flow.push_back(scale * (velocity * dealii::Tensor<1, 3>(inverse[e])));
    }
    if (projected) {
      const auto functions = space.values(values.quadrature_point(q));
      for (int k = 0; k < space.size(); ++k) cells.dilatation.push_back(root * functions[k]);
    }
  }
}

void add_geometry(const ElasticProblem& problem, LocalCells& cells) {
  const auto& dofs = problem.dofs;
  dealii::FEValues<3> values(problem.mapping, dofs.get_fe(),
                             dealii::QGauss<3>(dofs.get_fe().degree + 1),
                             dealii::update_inverse_jacobians | dealii::update_JxW_values |
                                 dealii::update_quadrature_points);
  DilatationSpace space(cells.degree);
  bool valid = true;
  for (const auto& cell : dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    const auto& weights = values.get_JxW_values();
    valid = valid && std::all_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
    if (valid) add_points(problem, values, space, cells);
  }
  // All processes throw or none does.
  if (dealii::Utilities::MPI::min(valid ? 1 : 0, dofs.get_communicator()) == 0)
    throw contact::InputError("the mesh has a cell that is inside out: refine or smooth it");
}

}  // namespace

LocalCells make_local_cells(const ElasticProblem& problem) {
  const auto& element = problem.dofs.get_fe();
  LocalCells cells;
  cells.degree = static_cast<int>(element.degree);
  cells.material = problem.material;
  const auto of_cells = cell_dofs(problem.dofs);
  cells.count = of_cells.size() / element.dofs_per_cell;
  cells.dofs = make_local_dofs(problem.dofs, of_cells, problem.constraints);
  cells.indices.reserve(of_cells.size());
  for (const auto dof : of_cells)
    cells.indices.push_back(cells.dofs->with_ghosts->global_to_local(dof));
  add_geometry(problem, cells);
  return cells;
}

}  // namespace rollfem::fem
