#include "fem/linear/level_transfer.hpp"

#include "fem/discretisation/elasticity_operator.hpp"

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace rollfem::fem {

namespace {

using FloatVector = LevelTransfer::VectorType;

/// Of several processes, whose coarse and fine cells may lie on different ones.
class SharedTransfer : public LevelTransfer {
 public:
  SharedTransfer(const ElasticProblem& fine, const ElasticProblem& coarse) {
    dealii::AffineConstraints<float> own, others;
    own.copy_from(fine.constraints);
    others.copy_from(coarse.constraints);
    transfer_.reinit_geometric_transfer(fine.dofs, coarse.dofs, own, others);
  }
  void prolongate_and_add(FloatVector& fine, const FloatVector& coarse) const override {
    transfer_.prolongate_and_add(fine, coarse);
  }
  void restrict_and_add(FloatVector& coarse, const FloatVector& fine) const override {
    transfer_.restrict_and_add(coarse, fine);
  }
  double memory_bytes() const override {
    return static_cast<double>(transfer_.memory_consumption());
  }

 private:
  dealii::MGTwoLevelTransfer<3, FloatVector> transfer_;
};

/// Values at lines of nodes from values at lines of others: `before` and `after` count the nodes in
/// the directions that run quicker and slower. Four lanes, three of which are the components.
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

/// From the nodes of a cell to those of its eight children, by the polynomials of the cell.
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

/// A dof that constraints give: the sum of weight * that of the master over its terms, none for a
/// boundary condition.
struct ConstrainedRow {
  unsigned int row;
  unsigned int first_term, end_of_terms;
};
struct ConstraintTerm {
  unsigned int master;
  double weight;
};

/// Of one process, coarse cell by coarse cell.
template <int degree>
class CellTransfer : public LevelTransfer {
 public:
  CellTransfer(const ElasticProblem& fine, const ElasticProblem& coarse);
  void prolongate_and_add(FloatVector& fine, const FloatVector& coarse) const override;
  void restrict_and_add(FloatVector& coarse, const FloatVector& fine) const override;
  double memory_bytes() const override {
    return static_cast<double>(sizeof(unsigned int) * (coarse_.size() + fine_.size()) +
                               sizeof(Same) * same_.size() + sizeof(ConstrainedRow) * rows_.size() +
                               sizeof(ConstraintTerm) * terms_.size() +
                               sizeof(float) * whole_.size());
  }

 private:
  using Cell = dealii::DoFHandler<3>::cell_iterator;
  using Indices = std::vector<dealii::types::global_dof_index>;
  static constexpr int coarse_nodes =
      Children<degree>::n * Children<degree>::n * Children<degree>::n;
  static constexpr int fine_nodes = Children<degree>::m * Children<degree>::m * Children<degree>::m;
  /// Of what another coarse cell has already or constraints give.
  static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
  struct Same {
    unsigned int fine, coarse;
  };

  void add_children(const Cell& cell, const Indices& of_cell,
                    const std::vector<unsigned int>& positions, std::vector<bool>& taken);
  void add_constraints(const ElasticProblem& coarse);

  Children<degree> children_;
  std::vector<unsigned int> coarse_;  ///< [refined cell][node][component]
  std::vector<unsigned int> fine_;    ///< the same of its children's nodes; none: not ours
  std::vector<Same> same_;            ///< unknowns of cells that both levels have
  std::vector<ConstrainedRow> rows_;  ///< of the coarse level
  std::vector<ConstraintTerm> terms_;
  mutable std::vector<float> whole_;  ///< coarse vector with its constrained unknowns
};

template <int degree>
CellTransfer<degree>::CellTransfer(const ElasticProblem& fine, const ElasticProblem& coarse)
    : whole_(coarse.dofs.n_dofs()) {
  const auto positions = lexicographic_positions(fine.dofs.get_fe());
  Indices of_cell(positions.size()), of_same(positions.size());
  std::vector<bool> taken(fine.dofs.n_dofs());
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = fine.constraints.is_constrained(i);
  const auto& mesh = fine.dofs.get_triangulation();
  for (const auto& cell : coarse.dofs.active_cell_iterators()) {
    cell->get_dof_indices(of_cell);
    const auto there = mesh.create_cell_iterator(cell->id());
    const Cell on_fine(&mesh, there->level(), there->index(), &fine.dofs);
    if (!on_fine->is_active()) {
      add_children(on_fine, of_cell, positions, taken);
      continue;
    }
    on_fine->get_dof_indices(of_same);
    for (std::size_t i = 0; i < of_same.size(); ++i)
      if (!taken[of_same[i]]) {
        same_.push_back(
            {static_cast<unsigned int>(of_same[i]), static_cast<unsigned int>(of_cell[i])});
        taken[of_same[i]] = true;
      }
  }
  add_constraints(coarse);
  coarse_.shrink_to_fit();
  fine_.shrink_to_fit();
  same_.shrink_to_fit();
}

template <int degree>
void CellTransfer<degree>::add_children(const Cell& cell, const Indices& of_cell,
                                        const std::vector<unsigned int>& positions,
                                        std::vector<bool>& taken) {
  constexpr int n = Children<degree>::n, m = Children<degree>::m;
  for (int node = 0; node < coarse_nodes; ++node)
    for (int c = 0; c < 3; ++c)
      coarse_.push_back(static_cast<unsigned int>(of_cell[positions[c * coarse_nodes + node]]));
  const std::size_t first = fine_.size();
  fine_.resize(first + 3 * fine_nodes, none);
  Indices of_child(of_cell.size());
  for (unsigned int child = 0; child < 8; ++child) {
    cell->child(child)->get_dof_indices(of_child);
    const int x = degree * (child & 1U), y = degree * ((child >> 1U) & 1U),
              z = degree * (child >> 2U);
    for (int node = 0; node < coarse_nodes; ++node) {
      const int i = x + node % n, j = y + node / n % n, k = z + node / (n * n);
      for (int c = 0; c < 3; ++c) {
        const auto unknown = of_child[positions[c * coarse_nodes + node]];
        if (taken[unknown]) continue;
        taken[unknown] = true;
        fine_[first + 3 * ((k * m + j) * m + i) + c] = static_cast<unsigned int>(unknown);
      }
    }
  }
}

template <int degree>
void CellTransfer<degree>::add_constraints(const ElasticProblem& coarse) {
  for (unsigned int i = 0; i < whole_.size(); ++i) {
    const auto* terms = coarse.constraints.get_constraint_entries(i);
    if (!coarse.constraints.is_constrained(i)) continue;
    const auto first = static_cast<unsigned int>(terms_.size());
    for (const auto& [master, weight] : *terms)
      terms_.push_back({static_cast<unsigned int>(master), weight});
    rows_.push_back({i, first, static_cast<unsigned int>(terms_.size())});
  }
}

template <int degree>
void CellTransfer<degree>::prolongate_and_add(FloatVector& fine, const FloatVector& coarse) const {
  std::copy_n(coarse.begin(), whole_.size(), whole_.begin());
  for (const ConstrainedRow& row : rows_) {
    double value = 0.0;
    for (auto k = row.first_term; k < row.end_of_terms; ++k)
      value += terms_[k].weight * whole_[terms_[k].master];
    whole_[row.row] = static_cast<float>(value);
  }
  float* const to = fine.begin();
  std::array<float, coarse_nodes * lanes> cell{};
  std::array<float, fine_nodes * lanes> inside;
  const unsigned int* from = coarse_.data();
  for (const unsigned int* unknown = fine_.data(); unknown != fine_.data() + fine_.size();
       unknown += 3 * fine_nodes, from += 3 * coarse_nodes) {
    for (int node = 0; node < coarse_nodes; ++node)
      for (int c = 0; c < 3; ++c) cell[node * lanes + c] = whole_[from[3 * node + c]];
    children_.prolongate(cell.data(), inside.data());
    for (int node = 0; node < fine_nodes; ++node)
      for (int c = 0; c < 3; ++c)
        if (unknown[3 * node + c] != none) to[unknown[3 * node + c]] += inside[node * lanes + c];
  }
  for (const Same& same : same_) to[same.fine] += whole_[same.coarse];
}

template <int degree>
void CellTransfer<degree>::restrict_and_add(FloatVector& coarse, const FloatVector& fine) const {
  std::fill(whole_.begin(), whole_.end(), 0.0F);
  const float* const of = fine.begin();
  std::array<float, coarse_nodes * lanes> cell;
  std::array<float, fine_nodes * lanes> inside{};
  const unsigned int* to = coarse_.data();
  for (const unsigned int* unknown = fine_.data(); unknown != fine_.data() + fine_.size();
       unknown += 3 * fine_nodes, to += 3 * coarse_nodes) {
    for (int node = 0; node < fine_nodes; ++node)
      for (int c = 0; c < 3; ++c)
        inside[node * lanes + c] = unknown[3 * node + c] == none ? 0.0F : of[unknown[3 * node + c]];
    children_.restrict(inside.data(), cell.data());
    for (int node = 0; node < coarse_nodes; ++node)
      for (int c = 0; c < 3; ++c) whole_[to[3 * node + c]] += cell[node * lanes + c];
  }
  for (const Same& same : same_) whole_[same.coarse] += of[same.fine];
  for (const ConstrainedRow& row : rows_) {
    const double value = whole_[row.row];
    for (auto k = row.first_term; k < row.end_of_terms; ++k)
      whole_[terms_[k].master] += static_cast<float>(terms_[k].weight * value);
    whole_[row.row] = 0.0F;
  }
  float* const sum = coarse.begin();
  for (std::size_t i = 0; i < whole_.size(); ++i) sum[i] += whole_[i];
}

}  // namespace

std::unique_ptr<LevelTransfer> make_level_transfer(const ElasticProblem& fine,
                                                   const ElasticProblem& coarse) {
  if (dealii::Utilities::MPI::n_mpi_processes(fine.dofs.get_communicator()) > 1)
    return std::make_unique<SharedTransfer>(fine, coarse);
  if (fine.dofs.get_fe().degree == 1) return std::make_unique<CellTransfer<1>>(fine, coarse);
  return std::make_unique<CellTransfer<2>>(fine, coarse);
}

}  // namespace rollfem::fem
