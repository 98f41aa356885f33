// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/elasticity_operator.hpp"

#include "base/threads.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/discretisation/elasticity_kernel.hpp"
#include "fem/discretisation/local_cells.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

// The local vectors of the elasticity kernel with four entries per node: conversion from and to
// vectors with three, and hanging nodes.

/// Index of a local dof in the vectors of the kernel.
inline std::size_t entry(unsigned int dof) {
  return dof / 3 * entries_per_node + dof % 3;
}

template <typename Number, int count>
void move(const Number* in, Number* out) {
  std::memcpy(out, in, count * sizeof(Number));
}

/// Copies three entries per node to four; the fourth is padding, so whole nodes are moved.
template <typename Number>
void spread(const Number* in, std::size_t nodes, Number* out) {
  for (std::size_t k = 0; k + 1 < nodes; ++k)
    move<Number, entries_per_node>(in + 3 * k, out + entries_per_node * k);
  if (nodes > 0) move<Number, 3>(in + 3 * (nodes - 1), out + entries_per_node * (nodes - 1));
}

/// The reverse: the surplus entry is overwritten by the next node.
template <typename Number>
void collect(const Number* in, std::size_t nodes, Number* out) {
  for (std::size_t k = 0; k + 1 < nodes; ++k)
    move<Number, entries_per_node>(in + entries_per_node * k, out + 3 * k);
  if (nodes > 0) move<Number, 3>(in + entries_per_node * (nodes - 1), out + 3 * (nodes - 1));
}

/// u at constrained nodes from their masters.
template <typename Number>
void expand(const LocalDofs& dofs, Number* entries) {
  using Node = typename NodeEntries<Number>::type;
  for (const unsigned int dof : dofs.fixed) entries[entry(dof)] = 0;
  Node* const u = reinterpret_cast<Node*>(entries);
  for (const HangingNode& row : dofs.hanging) {
    Node value{};
    for (unsigned int k = row.first_term; k < row.end_of_terms; ++k)
      value += static_cast<Number>(dofs.terms[k].weight) * u[dofs.terms[k].master];
    u[row.node] = value;
  }
}

/// The transpose of expand() for the first `hanging` hanging nodes and `fixed` fixed dofs.
template <typename Number>
void contract(const LocalDofs& dofs, std::size_t hanging, std::size_t fixed, Number* entries) {
  using Node = typename NodeEntries<Number>::type;
  Node* const b = reinterpret_cast<Node*>(entries);
  for (std::size_t i = 0; i < hanging; ++i) {
    const HangingNode& row = dofs.hanging[i];
    const Node value = b[row.node];
    b[row.node] = Node{};
    for (unsigned int k = row.first_term; k < row.end_of_terms; ++k)
      b[dofs.terms[k].master] += static_cast<Number>(dofs.terms[k].weight) * value;
  }
  for (std::size_t i = 0; i < fixed; ++i) entries[entry(dofs.fixed[i])] = 0;
}

/// Consecutive blocks of nodes, small enough to stay in the fastest cache for the next operation;
/// sixteen of them follow each other on one thread.
template <typename F>
void for_each_part(std::size_t nodes, const F& f) {
  constexpr std::ptrdiff_t part = 512, of_a_thread = 16 * part;
  const auto some = [&](std::ptrdiff_t first, std::ptrdiff_t end) {
    for (; first < end; first += part)
      f(static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(first + part, end)));
  };
  contact::for_each_piece(static_cast<std::ptrdiff_t>(nodes), of_a_thread, some);
}

/// The unconstrained dofs on which each dof of a cell depends.
class CellConstraints {
 public:
  explicit CellConstraints(const LocalDofs& dofs)
      : dofs_(dofs), position_(dofs.nodes(), -1), fixed_(3 * dofs.nodes()) {
    for (std::size_t i = 0; i < dofs.hanging.size(); ++i)
      position_[dofs.hanging[i].node] = static_cast<int>(i);
    for (const unsigned int dof : dofs.fixed) fixed_[dof] = true;
  }
  /// Calls f(master, weight) for one local dof.
  template <typename F>
  void for_each_master(unsigned int dof, const F& f) const {
    const int position = position_[dof / 3];
    if (position < 0) {
      if (!fixed_[dof]) f(dof, 1.0);
      return;
    }
    const HangingNode& row = dofs_.hanging[position];
    for (unsigned int k = row.first_term; k < row.end_of_terms; ++k) {
      const unsigned int master = 3 * dofs_.terms[k].master + dof % 3;
      if (!fixed_[master]) f(master, dofs_.terms[k].weight);
    }
  }

 private:
  const LocalDofs& dofs_;
  std::vector<int> position_;  ///< of a node among those that hang
  std::vector<bool> fixed_;
};

/// Reorders data of the chosen cells from [cell][item] into [batch][item][lane]; absent lanes hold
/// zero.
template <typename Number, typename Out, typename Data>
dealii::AlignedVector<Out> pack(const Data& data, std::size_t items,
                                const std::vector<std::size_t>& chosen) {
  constexpr std::size_t width = lanes<Number>;
  if (data.empty()) return {};
  const std::size_t batches = (chosen.size() + width - 1) / width;
  dealii::AlignedVector<Out> packed(batches * items * width, Out(0));
  for_each_cells(chosen.size(), [&](std::size_t k, std::size_t end) {
    for (; k < end; ++k)
      for (std::size_t item = 0; item < items; ++item)
        packed[((k / width) * items + item) * width + k % width] =
            static_cast<Out>(data[chosen[k] * items + item]);
  });
  return packed;
}

/// The same for all cells, in place.
template <typename Number>
dealii::AlignedVector<double> pack_in_place(dealii::AlignedVector<double>& data, std::size_t items,
                                            std::size_t cells) {
  constexpr std::size_t width = lanes<Number>;
  if (data.empty()) return {};
  data.resize((cells + width - 1) / width * width * items, 0.0);
  for_each_cells(data.size() / items, [&](std::size_t cell, std::size_t end) {
    std::vector<double> batch(width * items);
    for (; cell < end; cell += width) {
      double* const first = data.begin() + cell * items;
      std::copy_n(first, batch.size(), batch.begin());
      for (std::size_t item = 0; item < items; ++item)
        for (std::size_t lane = 0; lane < width; ++lane)
          first[item * width + lane] = batch[lane * items + item];
    }
  });
  return std::move(data);
}

std::size_t nodes_of_cell(const LocalCells& cells) {
  return cells.count == 0 ? 0 : cells.nodes.size() / cells.count;
}

std::size_t functions_of_dilatation(const LocalCells& cells) {
  return static_cast<std::size_t>(DilatationSpace::size_of_degree(cells.degree));
}

/// Every cell.
std::vector<std::size_t> all_of(const LocalCells& cells) {
  std::vector<std::size_t> all(cells.count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::atomic<std::uint64_t> products_so_far{0};

}  // namespace

std::uint64_t cell_products() {
  return products_so_far;
}

/// All data except the groups of cells.
template <typename Number>
ElasticityOperator<Number>::ElasticityOperator(const LocalCells* cells)
    : dofs_(cells->dofs),
      kernel_(elasticity_kernel<Number>(cells->degree)),
      cell_nodes_((cells->degree + 1) * (cells->degree + 1) * (cells->degree + 1)) {
  material_.lambda = static_cast<Number>(lame_lambda(cells->material));
  material_.mu = static_cast<Number>(lame_mu(cells->material));
}

template <typename Number>
ElasticityOperator<Number>::ElasticityOperator(const LocalCells& cells, double straightened)
    : ElasticityOperator(&cells) {
  const StraightCells shapes(cells, straightened);
  groups_.push_back(make_group(cells, shapes.straight, shapes.matrix));
  groups_.push_back(make_group(cells, shapes.bent, {}));
}

template <typename Number>
ElasticityOperator<Number>::ElasticityOperator(LocalCells&& cells) : ElasticityOperator(&cells) {
  groups_.push_back(make_group(std::move(cells)));
}

template <typename Number>
typename ElasticityOperator<Number>::Group ElasticityOperator<Number>::make_group(
    const LocalCells& cells, const std::vector<std::size_t>& chosen,
    const dealii::AlignedVector<double>& one_matrix) const {
  const std::size_t points = nodes_of_cell(cells);
  Group group;
  group.nodes = pack<Number, unsigned int>(cells.nodes, points, chosen);
  group.batches.parallelepipeds = !one_matrix.empty();
  group.geometry = group.batches.parallelepipeds
                       ? pack<Number, Number>(one_matrix, 9, chosen)
                       : pack<Number, Number>(cells.geometry, 9 * points, chosen);
  group.flow = pack<Number, Number>(cells.flow, 3 * points, chosen);
  group.dilatation =
      pack<Number, Number>(cells.dilatation, functions_of_dilatation(cells) * points, chosen);
  refer(group, chosen.size());
  return group;
}

template <typename Number>
typename ElasticityOperator<Number>::Group ElasticityOperator<Number>::make_group(
    LocalCells&& cells) const {
  if constexpr (std::is_same_v<Number, double>) {
    const std::size_t points = nodes_of_cell(cells);
    Group group;
    group.nodes = pack<Number, unsigned int>(cells.nodes, points, all_of(cells));
    group.geometry = pack_in_place<Number>(cells.geometry, 9 * points, cells.count);
    group.flow = pack_in_place<Number>(cells.flow, 3 * points, cells.count);
    group.dilatation = pack_in_place<Number>(cells.dilatation,
                                             functions_of_dilatation(cells) * points, cells.count);
    refer(group, cells.count);
    return group;
  } else {
    return make_group(cells, all_of(cells), {});
  }
}

/// Replaces local node numbers by the kernel's indices, and sets the remaining pointers.
template <typename Number>
void ElasticityOperator<Number>::refer(Group& group, std::size_t cells) const {
  group.cells = cells;
  group.batches.count = (cells + lanes<Number> - 1) / lanes<Number>;
  group.pieces = ColouredPieces(group.nodes.data(), lanes<Number> * cell_nodes_,
                                group.batches.count, dofs_->nodes());
  for (unsigned int& node : group.nodes) node *= entries_per_node;
  group.batches.nodes = group.nodes.data();
  group.batches.geometry = group.geometry.data();
  group.batches.flow = group.flow.empty() ? nullptr : group.flow.data();
  group.batches.dilatation = group.dilatation.empty() ? nullptr : group.dilatation.data();
}

template <typename Number>
CellBatches<Number> ElasticityOperator<Number>::Group::part(std::size_t first,
                                                            std::size_t end) const {
  CellBatches<Number> some = batches;
  some.count = end - first;
  some.nodes += first * (nodes.size() / batches.count);
  some.geometry += first * (geometry.size() / batches.count);
  if (some.flow != nullptr) some.flow += first * (flow.size() / batches.count);
  if (some.dilatation != nullptr) some.dilatation += first * (dilatation.size() / batches.count);
  return some;
}

template <typename Number>
typename ElasticityOperator<Number>::VectorType ElasticityOperator<Number>::make_vector() const {
  return VectorType(dofs_->owned_only);
}

template <typename Number>
std::unique_ptr<typename ElasticityOperator<Number>::Scratch>
ElasticityOperator<Number>::new_scratch() const {
  auto made = std::make_unique<Scratch>();
  made->source.resize(entries_per_node * dofs_->nodes());
  made->result.resize(entries_per_node * dofs_->nodes());
  if (dofs_->owned_only->n_mpi_processes() > 1) made->exchange.reinit(dofs_->with_ghosts);
  return made;
}

/// scratch.source = C x with its ghosts.
template <typename Number>
void ElasticityOperator<Number>::load(const VectorType& x, const Work& before,
                                      Scratch& scratch) const {
  Number* const source = scratch.source.data();
  for_each_part(dofs_->owned_nodes(), [&](std::size_t first, std::size_t end) {
    if (before) before(static_cast<unsigned int>(3 * first), static_cast<unsigned int>(3 * end));
    spread(x.begin() + 3 * first, end - first, source + entries_per_node * first);
  });
  VectorType& exchange = scratch.exchange;
  if (exchange.size() > 0) {
    exchange.zero_out_ghost_values();
    std::copy(x.begin(), x.end(), exchange.begin());
    exchange.update_ghost_values();
    spread(exchange.begin(), dofs_->nodes(), source);
  }
  expand(*dofs_, source);
}

/// Adds the contributions of other processes to the owned part of scratch.result.
template <typename Number>
void ElasticityOperator<Number>::add_of_ghosts(Scratch& scratch) const {
  VectorType& exchange = scratch.exchange;
  if (exchange.size() == 0) return;
  exchange.zero_out_ghost_values();
  collect(scratch.result.data(), dofs_->nodes(), exchange.begin());
  exchange.compress(dealii::VectorOperation::add);
  spread(exchange.begin(), dofs_->owned_nodes(), scratch.result.data());
}

template <typename Number>
void ElasticityOperator<Number>::vmult(VectorType& product, const VectorType& x, const Work& before,
                                       const Work& after) const {
  const auto work = scratch();
  load(x, before, *work);
  const Number* const source = work->source.data();
  Number* const result = work->result.data();
  for_each_part(dofs_->nodes(), [&](std::size_t first, std::size_t end) {
    std::fill(result + entries_per_node * first, result + entries_per_node * end, Number(0));
  });
  for (const Group& group : groups_) {
    group.pieces.for_each([&](std::size_t first, std::size_t end) {
      kernel_.add_product(group.part(first, end), material_, source, result);
    });
    products_so_far += group.cells;
  }
  contract(*dofs_, dofs_->hanging.size(), dofs_->fixed.size(), result);
  for (std::size_t i = 0; i < dofs_->owned_hanging; ++i) {
    const auto node = dofs_->hanging[i].node;
    move<Number, 3>(x.begin() + 3 * node, result + entries_per_node * node);
  }
  for (std::size_t i = 0; i < dofs_->owned_fixed; ++i)
    result[entry(dofs_->fixed[i])] = x.local_element(dofs_->fixed[i]);
  add_of_ghosts(*work);
  for_each_part(dofs_->owned_nodes(), [&](std::size_t first, std::size_t end) {
    collect(result + entries_per_node * first, end - first, product.begin() + 3 * first);
    if (after) after(static_cast<unsigned int>(3 * first), static_cast<unsigned int>(3 * end));
  });
}

template <typename Number>
void ElasticityOperator<Number>::vmult(VectorType& product, const VectorType& x) const {
  vmult(product, x, {}, {});
}

template <typename Number>
void ElasticityOperator<Number>::residual(VectorType& residual, const VectorType& b,
                                          const VectorType& x) const {
  const Number* const given = b.begin();
  Number* const left = residual.begin();
  vmult(residual, x, {}, [=](unsigned int i, unsigned int end) {
    for (; i < end; ++i) left[i] = given[i] - left[i];
  });
}

/// Calls f(masters, matrix) for every cell: the unconstrained dofs on which its dofs depend, and
/// matrix(i, j), its element matrix.
template <typename Number>
template <typename F>
void ElasticityOperator<Number>::for_each_cell(const F& f) const {
  const CellConstraints constraints(*dofs_);
  constexpr std::size_t width = lanes<Number>;
  const int cell_dofs = 3 * cell_nodes_;
  // Matrices of some batches at a time, computed side by side, before they are added one by one.
  constexpr std::size_t at_once = 32;
  const std::size_t of_batch = width * static_cast<std::size_t>(cell_dofs * cell_dofs);
  dealii::AlignedVector<Number> computed(at_once * of_batch);
  std::vector<CellMaster> masters;
  for (const Group& group : groups_)
    for (std::size_t cell = 0; cell < group.cells; ++cell) {
      const std::size_t batch = cell / width, lane = cell % width;
      if (cell % (at_once * width) == 0)
        contact::for_each_index(std::min(at_once, group.batches.count - batch), [&](std::size_t k) {
          kernel_.element_matrices(group.batches, material_, batch + k, &computed[k * of_batch]);
        });
      const Number* const matrices = &computed[batch % at_once * of_batch];
      const unsigned int* offset = group.nodes.data() + batch * cell_nodes_ * width + lane;
      masters.clear();
      for (int i = 0; i < cell_dofs; ++i) {
        const unsigned int node = offset[i % cell_nodes_ * width] / entries_per_node;
        constraints.for_each_master(3 * node + static_cast<unsigned int>(i / cell_nodes_),
                                    [&](unsigned int master, double weight) {
                                      masters.push_back({master, i, weight});
                                    });
      }
      f(masters,
        [&](int i, int j) -> double { return matrices[(i * cell_dofs + j) * width + lane]; });
    }
}

template <typename Number>
typename ElasticityOperator<Number>::VectorType ElasticityOperator<Number>::inverse_diagonal()
    const {
  const auto work = scratch();
  auto& result = work->result;
  result.fill(Number(0));
  for_each_cell([&](std::vector<CellMaster>& masters, const auto& matrix) {
    std::sort(masters.begin(), masters.end(),
              [](const auto& a, const auto& b) { return a.master < b.master; });
    for (auto first = masters.begin(); first != masters.end();) {
      const auto last = std::find_if(first, masters.end(),
                                     [&](const auto& m) { return m.master != first->master; });
      double sum = 0;
      for (auto a = first; a != last; ++a)
        for (auto b = first; b != last; ++b) sum += a->weight * b->weight * matrix(a->dof, b->dof);
      result[entry(first->master)] += static_cast<Number>(sum);
      first = last;
    }
  });
  VectorType diagonal = make_vector();
  add_of_ghosts(*work);
  collect(result.data(), dofs_->owned_nodes(), diagonal.begin());
  for (const unsigned int row : dofs_->owned_constrained()) diagonal.local_element(row) = 1;
  for (auto& value : diagonal) value = 1 / value;
  return diagonal;
}

template <typename Number>
std::vector<MatrixEntry> ElasticityOperator<Number>::assemble() const {
  const auto& numbers = *dofs_->with_ghosts;
  const auto global = [&](unsigned int local) {
    return static_cast<unsigned int>(numbers.local_to_global(local));
  };
  std::vector<std::vector<MatrixEntry>> rows(numbers.locally_owned_size() +
                                             numbers.n_ghost_indices());
  for_each_cell([&](const std::vector<CellMaster>& masters, const auto& matrix) {
    for (const auto& a : masters)
      for (const auto& b : masters)
        if (global(b.master) <= global(a.master))
          rows[a.master].push_back(
              {global(a.master), global(b.master), a.weight * b.weight * matrix(a.dof, b.dof)});
  });
  for (const unsigned int row : dofs_->owned_constrained())
    rows[row].push_back({global(row), global(row), 1.0});
  std::vector<MatrixEntry> entries;
  for (auto& row : rows) {
    std::stable_sort(row.begin(), row.end(),
                     [](const auto& a, const auto& b) { return a.column < b.column; });
    for (std::size_t i = 0; i < row.size(); ++i)
      if (i > 0 && row[i].column == row[i - 1].column)
        entries.back().value += row[i].value;
      else
        entries.push_back(row[i]);
    std::vector<MatrixEntry>().swap(row);
  }
  return entries;
}

template <typename Number>
void ElasticityOperator<Number>::condense(VectorType& b) const {
  const auto work = scratch();
  auto& result = work->result;
  result.fill(Number(0));
  spread(b.begin(), dofs_->owned_nodes(), result.data());
  // b is complete at its owner: ghosts are empty, only owned rows are moved.
  contract(*dofs_, dofs_->owned_hanging, dofs_->owned_fixed, result.data());
  add_of_ghosts(*work);
  collect(result.data(), dofs_->owned_nodes(), b.begin());
}

template <typename Number>
void ElasticityOperator<Number>::distribute(VectorType& u) const {
  const auto work = scratch();
  load(u, {}, *work);
  collect(work->source.data(), dofs_->owned_nodes(), u.begin());
}

template <typename Number>
double ElasticityOperator<Number>::memory_bytes() const {
  const auto rows = static_cast<double>(dofs_->hanging.size() * sizeof(HangingNode) +
                                        dofs_->terms.size() * sizeof(HangingTerm) +
                                        dofs_->fixed.size() * sizeof(unsigned int));
  double packed = 0;
  for (const Group& group : groups_)
    packed += static_cast<double>(
        group.nodes.memory_consumption() + group.geometry.memory_consumption() +
        group.flow.memory_consumption() + group.dilatation.memory_consumption());
  const auto work = scratch();
  return packed + rows +
         static_cast<double>(work->source.memory_consumption() + work->result.memory_consumption() +
                             work->exchange.memory_consumption());
}

template class ElasticityOperator<float>;
template class ElasticityOperator<double>;

}  // namespace rollfem::fem
