// SPDX-License-Identifier: LGPL-2.1-or-later
// The unknowns of one process and what holds them: hanging nodes, boundary conditions.
#pragma once

#include <deal.II/base/partitioner.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// A node between those of a larger cell beside it: its displacement is the sum of weight * that of
/// the master over its terms. A sixth of the nodes of a graded body are such: the terms of all lie
/// one after the other, since they are read in every product.
struct HangingNode {
  unsigned int node;
  unsigned int first_term, end_of_terms;  ///< in LocalDofs::terms
};
struct HangingTerm {
  unsigned int master;  ///< a node
  float weight;         ///< of hanging nodes exact: a whole number over a power of two
};

/// The unknowns of this process: owned ones first, then the ghosts that its cells and the
/// constraints on them refer to. Numbers are local ones; the components of node k are dofs 3 k, 3 k
/// + 1, 3 k + 2.
struct LocalDofs {
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> with_ghosts;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> owned_only;
  std::vector<HangingNode> hanging;  ///< ascending nodes, so the owned ones come first
  std::vector<HangingTerm> terms;
  std::vector<unsigned int> fixed;  ///< dofs that a boundary condition holds at 0, ascending
  std::size_t owned_hanging = 0, owned_fixed = 0;

  std::size_t nodes() const;
  std::size_t owned_nodes() const;
  /// Owned dofs that are not unknowns: of hanging nodes, and fixed ones.
  std::vector<unsigned int> owned_constrained() const;
};

}  // namespace rollfem::fem
