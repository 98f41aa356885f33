// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/level_transfer.hpp"

#include "base/spares.hpp"
#include "fem/discretisation/coloured_pieces.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/discretisation/elasticity_operator.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

namespace rollfem::fem {

namespace {

// The cells of a coarse multigrid level that contain the fine cells of a process, sent by their
// owners.

/// Data of the coarse cells that contain the fine cells of a process. Numbers are global.
struct CoarseCells {
  std::vector<unsigned int> cells;         ///< dealii::CellId::binary_type of each
  std::vector<unsigned int> unknowns;      ///< [cell][deal.II's order]
  std::vector<unsigned int> constrained;   ///< constrained ones, ascending
  std::vector<unsigned int> end_of_terms;  ///< of each
  std::vector<unsigned int> masters;       ///< of their terms
  std::vector<double> weights;

  template <class Archive>
  void serialize(Archive& archive, unsigned int /*version*/) {
    archive& cells& unknowns& constrained& end_of_terms& masters& weights;
  }
};

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

void add(const dealii::CellId& cell, const std::vector<unsigned int>& of_cell, CoarseCells& sent) {
  const auto binary = cell.to_binary<3>();
  sent.cells.insert(sent.cells.end(), binary.begin(), binary.end());
  sent.unknowns.insert(sent.unknowns.end(), of_cell.begin(), of_cell.end());
}

void add_constraints(const dealii::AffineConstraints<double>& constraints, CoarseCells& sent) {
  auto& [cells, unknowns, constrained, end_of_terms, masters, weights] = sent;
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

/// The coarse cells that contain the fine ones of this process, sent by their owners. Collective.
std::map<unsigned int, CoarseCells> coarse_cells(const ElasticProblem& fine,
                                                 const ElasticProblem& coarse) {
  // Owners of coarse cells send the data; otherwise they would have to be searched for.
  const Owners owners(dynamic_cast<const Mesh&>(fine.dofs.get_triangulation()));
  std::map<unsigned int, CoarseCells> sent;
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
    for (const unsigned int process : processes) add(id, of_cell, sent[process]);
  }
  for (auto& [process, cells] : sent) add_constraints(coarse.constraints, cells);
  return dealii::Utilities::MPI::some_to_some(coarse.dofs.get_communicator(), sent);
}

/// Values at lines of nodes from values at other lines: `before` and `after` count the nodes in the
/// faster and slower directions. Four lanes, three of them components.
constexpr int lanes = 4;
template <int to, int from, int before, int after>
void along_lines(const std::array<std::array<float, from>, to>& weight, const float* in,
                 float* out) {
  for (int a = 0; a < after; ++a)
    for (int t = 0; t < to; ++t)
      for (int b = 0; b < before; ++b) {
        std::array<float, lanes> sum{};
        for (int f = 0; f < from; ++f)
          for (int lane = 0; lane < lanes; ++lane)
            sum[lane] += weight[t][f] * in[((a * from + f) * before + b) * lanes + lane];
        std::copy(sum.begin(), sum.end(), out + ((a * to + t) * before + b) * lanes);
      }
}

/// From the nodes of a cell to the nodes of its eight children, by the polynomials of the cell.
template <int degree>
class Children {
 public:
  static constexpr int n = degree + 1, m = 2 * degree + 1;

  Children() {
    for (int t = 0; t < m; ++t)
      for (int f = 0; f < n; ++f) {
        double value = 1.0;
        for (int other = 0; other < n; ++other)
          if (other != f) value *= (0.5 * t - other) / (f - other);
        to_fine_[t][f] = to_coarse_[f][t] = static_cast<float>(value);
      }
  }
  void prolongate(const float* coarse, float* fine) const {
    std::array<float, m * n * n * lanes> first;
    std::array<float, m * m * n * lanes> second;
    along_lines<m, n, 1, n * n>(to_fine_, coarse, first.data());
    along_lines<m, n, m, n>(to_fine_, first.data(), second.data());
    along_lines<m, n, m * m, 1>(to_fine_, second.data(), fine);
  }
  void restrict(const float* fine, float* coarse) const {
    std::array<float, m * m * n * lanes> first;
    std::array<float, m * n * n * lanes> second;
    along_lines<n, m, m * m, 1>(to_coarse_, fine, first.data());
    along_lines<n, m, m, n>(to_coarse_, first.data(), second.data());
    along_lines<n, m, 1, n * n>(to_coarse_, second.data(), coarse);
  }

 private:
  std::array<std::array<float, n>, m> to_fine_;
  std::array<std::array<float, m>, n> to_coarse_;
};

/// A constrained dof: the sum over its terms of weight * value of the master; no terms for a
/// boundary condition.
struct ConstrainedRow {
  unsigned int row;
  unsigned int first_term, end_of_terms;
};
struct ConstraintTerm {
  unsigned int master;
  double weight;
};

/// Coarse cell by coarse cell, each on the processes that own fine cells in it. Unknowns of the
/// fine level are set by their owners, so that only unknowns of the coarse level are exchanged.
template <int degree>
class CellTransfer : public LevelTransfer {
 public:
  CellTransfer(const ElasticProblem& fine, const ElasticProblem& coarse);
  void prolongate_and_add(FloatVector& fine, const FloatVector& coarse) const override;
  void restrict_and_add(FloatVector& coarse, const FloatVector& fine) const override;

 private:
  using Cell = dealii::DoFHandler<3>::cell_iterator;
  using Indices = std::vector<unsigned int>;
  static constexpr int coarse_nodes =
      Children<degree>::n * Children<degree>::n * Children<degree>::n;
  static constexpr int fine_nodes = Children<degree>::m * Children<degree>::m * Children<degree>::m;
  /// Marks unknowns already in another coarse cell, owned by another process, or constrained.
  static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
  struct Same {
    unsigned int fine, coarse;
  };

  /// Numbers of the unknowns of this process on the fine level, each assigned once.
  class Untaken {
   public:
    explicit Untaken(const ElasticProblem& problem)
        : owned_(problem.dofs.locally_owned_dofs()), taken_(owned_.n_elements()) {
      for (std::size_t i = 0; i < taken_.size(); ++i)
        taken_[i] = problem.constraints.is_constrained(owned_.nth_index_in_set(i));
    }
    /// The local number of `unknown`, or `none`.
    unsigned int take(unsigned int unknown) {
      if (!owned_.is_element(unknown)) return none;
      const auto local = static_cast<unsigned int>(owned_.index_within_set(unknown));
      if (taken_[local]) return none;
      taken_[local] = true;
      return local;
    }
    bool empty() const { return std::find(taken_.begin(), taken_.end(), false) == taken_.end(); }

   private:
    const dealii::IndexSet& owned_;
    std::vector<bool> taken_;
  };

  void make_room(const dealii::DoFHandler<3>& dofs,
                 const std::map<unsigned int, CoarseCells>& received);
  void add_cells(const CoarseCells& received, const dealii::DoFHandler<3>& dofs, Untaken& untaken);
  void add_children(const Cell& cell, const unsigned int* of_cell, const Indices& positions,
                    Untaken& untaken);
  void add_constraints(const CoarseCells& received);
  auto borrow() const {
    return whole_.borrow([&] { return std::make_unique<FloatVector>(with_others_); });
  }
  unsigned int local(unsigned int coarse_unknown) const {
    return with_others_->global_to_local(coarse_unknown);
  }

  Children<degree> children_;
  Indices coarse_;                    ///< [refined cell][node][component]
  Indices fine_;                      ///< the same for its children's nodes; none: not owned
  ColouredPieces cells_;              ///< of `coarse_`
  std::vector<Same> same_;            ///< unknowns of cells common to both levels
  std::vector<ConstrainedRow> rows_;  ///< of the coarse level
  std::vector<ConstraintTerm> terms_;
  /// Coarse vectors with constrained unknowns and others' unknowns.
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> with_others_;
  contact::Spares<FloatVector> whole_;
};

template <int degree>
CellTransfer<degree>::CellTransfer(const ElasticProblem& fine, const ElasticProblem& coarse) {
  const auto received = coarse_cells(fine, coarse);
  make_room(coarse.dofs, received);
  Untaken untaken(fine);
  for (const auto& [process, cells] : received) {
    add_cells(cells, fine.dofs, untaken);
    add_constraints(cells);
  }
  if (!untaken.empty()) throw std::logic_error("a fine cell has no coarse cell");
  coarse_.shrink_to_fit();
  fine_.shrink_to_fit();
  same_.shrink_to_fit();
  cells_ = ColouredPieces(coarse_.data(), 3 * coarse_nodes, coarse_.size() / (3 * coarse_nodes),
                          with_others_->locally_owned_size() + with_others_->n_ghost_indices());
}

template <int degree>
void CellTransfer<degree>::make_room(const dealii::DoFHandler<3>& dofs,
                                     const std::map<unsigned int, CoarseCells>& received) {
  Indices others;
  for (const auto& [process, cells] : received)
    for (const auto* unknowns : {&cells.unknowns, &cells.masters})
      std::copy_if(unknowns->begin(), unknowns->end(), std::back_inserter(others),
                   [&](unsigned int k) { return !dofs.locally_owned_dofs().is_element(k); });
  std::sort(others.begin(), others.end());
  dealii::IndexSet ghosts(dofs.n_dofs());
  ghosts.add_indices(others.begin(), std::unique(others.begin(), others.end()));
  with_others_ = std::make_shared<dealii::Utilities::MPI::Partitioner>(
      dofs.locally_owned_dofs(), ghosts, dofs.get_communicator());
}

template <int degree>
void CellTransfer<degree>::add_cells(const CoarseCells& received, const dealii::DoFHandler<3>& dofs,
                                     Untaken& untaken) {
  const auto positions = lexicographic_positions(dofs.get_fe());
  const auto& mesh = dofs.get_triangulation();
  Indices of_same(positions.size());
  const unsigned int* of_cell = received.unknowns.data();
  for (auto id = received.cells.begin(); id != received.cells.end();
       id += 4, of_cell += positions.size()) {
    const auto there = mesh.create_cell_iterator(
        dealii::CellId(dealii::CellId::binary_type{id[0], id[1], id[2], id[3]}));
    const Cell on_fine(&mesh, there->level(), there->index(), &dofs);
    if (!on_fine->is_active()) {
      add_children(on_fine, of_cell, positions, untaken);
      continue;
    }
    on_fine->get_dof_indices(of_same);
    for (std::size_t i = 0; i < of_same.size(); ++i)
      if (const auto number = untaken.take(of_same[i]); number != none)
        same_.push_back({number, local(of_cell[i])});
  }
}

template <int degree>
void CellTransfer<degree>::add_children(const Cell& cell, const unsigned int* of_cell,
                                        const Indices& positions, Untaken& untaken) {
  constexpr int n = Children<degree>::n, m = Children<degree>::m;
  for (int node = 0; node < coarse_nodes; ++node)
    for (int c = 0; c < 3; ++c)
      coarse_.push_back(local(of_cell[positions[c * coarse_nodes + node]]));
  const std::size_t first = fine_.size();
  fine_.resize(first + 3 * fine_nodes, none);
  Indices of_child(positions.size());
  for (unsigned int child = 0; child < 8; ++child) {
    if (!cell->child(child)->is_locally_owned()) continue;
    cell->child(child)->get_dof_indices(of_child);
    const int x = degree * (child & 1U), y = degree * ((child >> 1U) & 1U),
              z = degree * (child >> 2U);
    for (int node = 0; node < coarse_nodes; ++node) {
      const int i = x + node % n, j = y + node / n % n, k = z + node / (n * n);
      for (int c = 0; c < 3; ++c)
        if (const auto number = untaken.take(of_child[positions[c * coarse_nodes + node]]);
            number != none)
          fine_[first + 3 * ((k * m + j) * m + i) + c] = number;
    }
  }
}

template <int degree>
void CellTransfer<degree>::add_constraints(const CoarseCells& received) {
  for (std::size_t k = 0, term = 0; k < received.constrained.size(); ++k) {
    const auto first = static_cast<unsigned int>(terms_.size());
    for (; term < received.end_of_terms[k]; ++term)
      terms_.push_back({local(received.masters[term]), received.weights[term]});
    rows_.push_back(
        {local(received.constrained[k]), first, static_cast<unsigned int>(terms_.size())});
  }
}

template <int degree>
void CellTransfer<degree>::prolongate_and_add(FloatVector& fine, const FloatVector& coarse) const {
  const auto borrowed = borrow();
  borrowed->zero_out_ghost_values();
  std::copy(coarse.begin(), coarse.end(), borrowed->begin());
  borrowed->update_ghost_values();
  float* const whole = borrowed->begin();
  for (const ConstrainedRow& row : rows_) {
    double value = 0.0;
    for (auto k = row.first_term; k < row.end_of_terms; ++k)
      value += terms_[k].weight * whole[terms_[k].master];
    whole[row.row] = static_cast<float>(value);
  }
  float* const to = fine.begin();
  // Every unknown of the fine level belongs to one cell.
  cells_.for_each([&](std::size_t first, std::size_t end) {
    std::array<float, coarse_nodes * lanes> cell{};
    std::array<float, fine_nodes * lanes> inside;
    for (std::size_t k = first; k < end; ++k) {
      const unsigned int* const from = coarse_.data() + 3 * coarse_nodes * k;
      const unsigned int* const unknown = fine_.data() + 3 * fine_nodes * k;
      for (int node = 0; node < coarse_nodes; ++node)
        for (int c = 0; c < 3; ++c) cell[node * lanes + c] = whole[from[3 * node + c]];
      children_.prolongate(cell.data(), inside.data());
      for (int node = 0; node < fine_nodes; ++node)
        for (int c = 0; c < 3; ++c)
          if (unknown[3 * node + c] != none) to[unknown[3 * node + c]] += inside[node * lanes + c];
    }
  });
  for (const Same& same : same_) to[same.fine] += whole[same.coarse];
}

template <int degree>
void CellTransfer<degree>::restrict_and_add(FloatVector& coarse, const FloatVector& fine) const {
  const auto borrowed = borrow();
  float* const whole = borrowed->begin();
  borrowed->zero_out_ghost_values();
  std::fill(whole, whole + with_others_->locally_owned_size(), 0.0F);
  const float* const of = fine.begin();
  cells_.for_each([&](std::size_t first, std::size_t end) {
    std::array<float, coarse_nodes * lanes> cell;
    std::array<float, fine_nodes * lanes> inside{};
    for (std::size_t k = first; k < end; ++k) {
      const unsigned int* const to = coarse_.data() + 3 * coarse_nodes * k;
      const unsigned int* const unknown = fine_.data() + 3 * fine_nodes * k;
      for (int node = 0; node < fine_nodes; ++node)
        for (int c = 0; c < 3; ++c)
          inside[node * lanes + c] =
              unknown[3 * node + c] == none ? 0.0F : of[unknown[3 * node + c]];
      children_.restrict(inside.data(), cell.data());
      for (int node = 0; node < coarse_nodes; ++node)
        for (int c = 0; c < 3; ++c) whole[to[3 * node + c]] += cell[node * lanes + c];
    }
  });
  for (const Same& same : same_) whole[same.coarse] += of[same.fine];
  for (const ConstrainedRow& row : rows_) {
    const double value = whole[row.row];
    for (auto k = row.first_term; k < row.end_of_terms; ++k)
      whole[terms_[k].master] += static_cast<float>(terms_[k].weight * value);
    whole[row.row] = 0.0F;
  }
  borrowed->compress(dealii::VectorOperation::add);
  std::transform(coarse.begin(), coarse.end(), whole, coarse.begin(), std::plus<float>());
}

}  // namespace

std::unique_ptr<LevelTransfer> make_level_transfer(const ElasticProblem& fine,
                                                   const ElasticProblem& coarse) {
  if (fine.dofs.get_fe().degree == 1) return std::make_unique<CellTransfer<1>>(fine, coarse);
  return std::make_unique<CellTransfer<2>>(fine, coarse);
}

}  // namespace rollfem::fem
