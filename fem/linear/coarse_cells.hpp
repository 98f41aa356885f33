// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of a coarse multigrid level that the fine cells of a process lie in, told by the
// processes that own them.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"

#include <map>
#include <vector>

namespace rollfem::fem {

/// What a process must know of the coarse cells that contain its fine ones. Numbers are global.
struct CoarseCells {
  std::vector<unsigned int> cells;         ///< dealii::CellId::binary_type of each
  std::vector<unsigned int> unknowns;      ///< [cell][deal.II's order]
  std::vector<unsigned int> constrained;   ///< those that constraints give, ascending
  std::vector<unsigned int> end_of_terms;  ///< of each
  std::vector<unsigned int> masters;       ///< of their terms
  std::vector<double> weights;

  template <class Archive>
  void serialize(Archive& archive, unsigned int /*version*/) {
    archive& cells& unknowns& constrained& end_of_terms& masters& weights;
  }
};

/// The coarse cells that contain the fine ones of this process, by the processes that own them.
/// Collective.
std::map<unsigned int, CoarseCells> coarse_cells(const ElasticProblem& fine,
                                                 const ElasticProblem& coarse);

}  // namespace rollfem::fem
