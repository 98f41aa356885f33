// SPDX-License-Identifier: LGPL-2.1-or-later
// The unknowns of one process and their constraints: hanging nodes, boundary conditions.
#pragma once

#include <deal.II/base/partitioner.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// A hanging node, on the face of a larger adjacent cell: its displacement is the sum over its
/// terms of weight * displacement of the master. A sixth of the nodes of a graded body hang, so the
/// terms of all are stored contiguously for fast access in every product.
struct HangingNode {
  unsigned int node;
  unsigned int first_term, end_of_terms;  ///< in LocalDofs::terms
};
struct HangingTerm {
  unsigned int master;  ///< a node
  float weight;         ///< exact for hanging nodes: an integer over a power of two
};

/// The unknowns of this process: owned ones first, then the ghosts referenced by its cells and
/// their constraints. Numbers are local; the components of node k are dofs 3 k, 3 k + 1, 3 k + 2.
struct LocalDofs {
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> with_ghosts;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> owned_only;
  std::vector<HangingNode> hanging;  ///< ascending nodes, owned ones first
  std::vector<HangingTerm> terms;
  std::vector<unsigned int> fixed;  ///< dofs fixed at 0 by a boundary condition, ascending
  std::size_t owned_hanging = 0, owned_fixed = 0;

  std::size_t nodes() const;
  std::size_t owned_nodes() const;
  /// Owned dofs that are not unknowns: dofs of hanging nodes, and fixed ones.
  std::vector<unsigned int> owned_constrained() const;
};

}  // namespace rollfem::fem
