// SPDX-License-Identifier: LGPL-2.1-or-later
// The data of the matrix-free operator on one process: unknowns and their constraints (hanging
// nodes, boundary conditions), indices and geometry of cells.
#pragma once

#include "base/threads.hpp"
#include "fem/discretisation/elastic_problem.hpp"

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/fe/fe.h>

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

/// Position in deal.II's numbering of a cell of (component, node), nodes lexicographic, x fastest.
/// Throws contact::InputError for elements other than FE_Q(1)^3 and FE_Q(2)^3.
std::vector<unsigned int> lexicographic_positions(const dealii::FiniteElement<3>& element);

/// Indices and geometry cell by cell, from which operators of either precision are packed.
struct LocalCells {
  int degree = 0;
  std::size_t count = 0;
  std::shared_ptr<const LocalDofs> dofs;
  std::vector<unsigned int> nodes;           ///< [cell][node], local numbers, lexicographic
  dealii::AlignedVector<double> geometry;    ///< [cell][point][e][d], as in CellBatches
  dealii::AlignedVector<double> flow;        ///< [cell][point][e], empty without inertia
  dealii::AlignedVector<double> dilatation;  ///< [cell][point][function], empty: not projected
  contact::Material material;
};

/// Collective. Throws contact::InputError for degrees other than 1 and 2 and for cells inverted by
/// the mapping.
LocalCells make_local_cells(const ElasticProblem& problem);

/// Mean of sqrt(det J) d xi / d x over the points of every cell, and the cells in which it is
/// constant up to a relative tolerance.
struct StraightCells {
  StraightCells(const LocalCells& cells, double tolerance);

  dealii::AlignedVector<double> matrix;  ///< [cell][e][d]
  std::vector<std::size_t> straight, bent;
};

/// Passes [begin, end) over cells in pieces of whole batches.
template <typename F>
void for_each_cells(std::size_t cells, const F& f) {
  contact::for_each_piece(static_cast<std::ptrdiff_t>(cells), 512,
                          [&](std::ptrdiff_t first, std::ptrdiff_t end) {
                            f(static_cast<std::size_t>(first), static_cast<std::size_t>(end));
                          });
}

}  // namespace rollfem::fem
