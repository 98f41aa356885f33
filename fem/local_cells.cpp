// Collects what the matrix-free operator needs from deal.II: local numbers, constraints, geometry.
#include "contact/errors.hpp"
#include "fem/elasticity_operator.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

using GlobalIndex = dealii::types::global_dof_index;

/// Position in deal.II's cell numbering of (component, lexicographic node).
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
      ConstrainedRow row;
      row.row = result->with_ghosts->global_to_local(dof);
      for (const auto& term : *constraints.get_constraint_entries(dof))
        row.terms.push_back({result->with_ghosts->global_to_local(term.first), term.second});
      result->constrained.push_back(std::move(row));
    }
  std::sort(result->constrained.begin(), result->constrained.end(),
            [](const auto& a, const auto& b) { return a.row < b.row; });
  const auto owned = result->with_ghosts->locally_owned_size();
  result->owned_constrained = std::count_if(result->constrained.begin(), result->constrained.end(),
                                            [&](const auto& row) { return row.row < owned; });
  return result;
}

std::vector<double> cell_geometry(const dealii::DoFHandler<3>& dofs,
                                  const dealii::Mapping<3>& mapping) {
  const dealii::QGauss<3> quadrature(dofs.get_fe().degree + 1);
  dealii::FEValues<3> values(mapping, dofs.get_fe(), quadrature,
                             dealii::update_inverse_jacobians | dealii::update_JxW_values);
  std::vector<double> geometry;
  bool valid = true;
  for (const auto& cell : dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    for (const auto q : values.quadrature_point_indices()) {
      valid = valid && values.JxW(q) > 0;
      const double root = std::sqrt(values.JxW(q));
      for (unsigned int e = 0; e < 3; ++e)
        for (unsigned int d = 0; d < 3; ++d)
          geometry.push_back(root * values.inverse_jacobian(q)[e][d]);
    }
  }
  // All processes throw or none does.
  if (dealii::Utilities::MPI::min(valid ? 1 : 0, dofs.get_communicator()) == 0)
    throw contact::InputError("the mesh has a cell that is inside out: refine or smooth it");
  return geometry;
}

}  // namespace

LocalCells make_local_cells(const dealii::DoFHandler<3>& dofs, const dealii::Mapping<3>& mapping,
                            const dealii::AffineConstraints<double>& constraints) {
  LocalCells cells;
  cells.degree = static_cast<int>(dofs.get_fe().degree);
  const auto of_cells = cell_dofs(dofs);
  cells.count = of_cells.size() / dofs.get_fe().dofs_per_cell;
  cells.dofs = make_local_dofs(dofs, of_cells, constraints);
  cells.indices.reserve(of_cells.size());
  for (const auto dof : of_cells)
    cells.indices.push_back(cells.dofs->with_ghosts->global_to_local(dof));
  cells.geometry = cell_geometry(dofs, mapping);
  return cells;
}

}  // namespace rollfem::fem
