// SPDX-License-Identifier: LGPL-2.1-or-later
// The elimination order of the unknowns of a stiffness: nested dissection of the nodes,
// whose graph has a ninth of the entries of the matrix.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace rollfem::fem {

/// Consecutive unknowns with the same neighbours: the components of one node.
struct Nodes {
  std::vector<int> first{0};  ///< unknown of each node, and the number of unknowns
  std::vector<int> of;        ///< node of each unknown

  /// Adds the next unknown; `with_last`: it belongs to the node of the previous one.
  void add(bool with_last) {
    if (!with_last || of.empty()) first.push_back(first.back());
    of.push_back(static_cast<int>(first.size()) - 2);
    ++first.back();
  }
  std::size_t count() const { return first.size() - 1; }
  /// The unknowns of a sequence of nodes.
  std::vector<int> unknowns(const std::vector<int>& sequence) const;
};

/// Graph of coupled nodes: lower triangle with the diagonal, in compressed columns.
struct NodeGraph {
  std::vector<int> start{0}, row;

  /// `each_reached(c, f)` calls f for every unknown coupled to unknown c, the first of its node.
  template <class EachReached>
  NodeGraph(const Nodes& nodes, const EachReached& each_reached) {
    std::vector<int> seen(nodes.count(), -1);
    for (std::size_t node = 0; node < nodes.count(); ++node) {
      const int self = static_cast<int>(node);
      each_reached(nodes.first[node], [&](int unknown) {
        const int other = nodes.of[unknown];
        if (other >= self && std::exchange(seen[other], self) != self) row.push_back(other);
      });
      start.push_back(static_cast<int>(row.size()));
    }
  }
};

/// Elimination order of the nodes, with children of the elimination tree immediately before their
/// parents. The orders of the last two graphs are cached, because both parities of a mirrored body,
/// often both bodies of a contact, and a body and its flattened twin have the same graph. Throws
/// contact::SolveError when memory runs out.
std::vector<int> order_of_elimination(const NodeGraph& graph);

}  // namespace rollfem::fem
