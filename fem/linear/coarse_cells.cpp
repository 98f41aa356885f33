// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/coarse_cells.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>

namespace rollfem::fem {

namespace {

using Mesh = dealii::parallel::distributed::Triangulation<3>;

/// Position of a cell on the curve along which p4est distributes cells to processes: its tree
/// (deal.II's name of the coarsest cell), then the children on the way down, three bits each from
/// the highest on. A cell has the position of its first child.
using Place = std::array<std::uint64_t, 2>;
constexpr unsigned int first_shift = 60;

unsigned int shift_below(const dealii::CellId& cell) {
  return first_shift - 3 * static_cast<unsigned int>(cell.get_child_indices().size());
}

Place place_of(const dealii::CellId& cell) {
  Place place{cell.get_coarse_cell_id(), 0};
  unsigned int shift = first_shift;
  for (const std::uint64_t child : cell.get_child_indices()) {
    place[1] |= child << shift;
    shift -= 3;
  }
  return place;
}

/// Owner process of the active cell of a mesh at a position.
class Owners {
 public:
  explicit Owners(const Mesh& mesh) {
    Place first = nowhere;
    for (const auto& cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned()) first = std::min(first, place_of(cell->id()));
    const MPI_Comm communicator = mesh.get_communicator();
    first_ = dealii::Utilities::MPI::n_mpi_processes(communicator) == 1
                 ? std::vector{first}
                 : dealii::Utilities::MPI::all_gather(communicator, first);
    // A process without cells is skipped: it begins where the next one does.
    for (std::size_t k = first_.size(); k-- > 1;)
      first_[k - 1] = std::min(first_[k - 1], first_[k]);
  }
  unsigned int of(const Place& place) const {
    const auto next = std::upper_bound(first_.begin(), first_.end(), place);
    return static_cast<unsigned int>(next - first_.begin()) - 1;
  }

 private:
  static constexpr Place nowhere{std::numeric_limits<std::uint64_t>::max(), 0};
  std::vector<Place> first_;
};

void add(const dealii::CellId& cell, const std::vector<unsigned int>& of_cell, CoarseCells& told) {
  const auto binary = cell.to_binary<3>();
  told.cells.insert(told.cells.end(), binary.begin(), binary.end());
  told.unknowns.insert(told.unknowns.end(), of_cell.begin(), of_cell.end());
}

void add_constraints(const dealii::AffineConstraints<double>& constraints, CoarseCells& told) {
  auto& [cells, unknowns, constrained, end_of_terms, masters, weights] = told;
  for (const unsigned int unknown : unknowns)
    if (constraints.is_constrained(unknown)) constrained.push_back(unknown);
  std::sort(constrained.begin(), constrained.end());
  constrained.erase(std::unique(constrained.begin(), constrained.end()), constrained.end());
  for (const unsigned int unknown : constrained) {
    for (const auto& [master, weight] : *constraints.get_constraint_entries(unknown)) {
      masters.push_back(master);
      weights.push_back(weight);
    }
    end_of_terms.push_back(static_cast<unsigned int>(masters.size()));
  }
}

}  // namespace

std::map<unsigned int, CoarseCells> coarse_cells(const ElasticProblem& fine,
                                                 const ElasticProblem& coarse) {
  // Owners of coarse cells send the data; otherwise they would have to be searched for.
  const Owners owners(dynamic_cast<const Mesh&>(fine.dofs.get_triangulation()));
  std::map<unsigned int, CoarseCells> told;
  std::vector<unsigned int> of_cell(coarse.dofs.get_fe().dofs_per_cell);
  for (const auto& cell : coarse.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(of_cell);
    const dealii::CellId id = cell->id();
    std::set<unsigned int> processes;
    for (std::uint64_t child = 0; child < 8; ++child) {
      Place place = place_of(id);
      place[1] |= child << shift_below(id);
      processes.insert(owners.of(place));
    }
    for (const unsigned int process : processes) add(id, of_cell, told[process]);
  }
  for (auto& [process, cells] : told) add_constraints(coarse.constraints, cells);
  return dealii::Utilities::MPI::some_to_some(coarse.dofs.get_communicator(), told);
}

}  // namespace rollfem::fem
