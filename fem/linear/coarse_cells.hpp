// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of a coarse multigrid level that contain the fine cells of a process, sent by their
// owners.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"

#include <map>
#include <vector>

namespace rollfem::fem {

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

/// The coarse cells that contain the fine ones of this process, sent by their owners. Collective.
std::map<unsigned int, CoarseCells> coarse_cells(const ElasticProblem& fine,
                                                 const ElasticProblem& coarse);

}  // namespace rollfem::fem
