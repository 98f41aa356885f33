// SPDX-License-Identifier: LGPL-2.1-or-later
// The local vectors of the elasticity kernel with four entries per node: conversion from and to
// vectors with three, and hanging nodes.
#pragma once

#include "contact/base/threads.hpp"
#include "fem/discretisation/elasticity_kernel.hpp"
#include "fem/discretisation/local_cells.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace rollfem::fem {

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

}  // namespace rollfem::fem
