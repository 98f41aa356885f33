// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a table solved in parts on all cores; finished parts survive an interrupted call.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/base/progress.hpp"
#include "contact/base/share.hpp"
#include "tables/files/creep_table.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rollfem::tables {

/// A solved point, scaled as in a CreepTable.
struct TablePoint {
  Scaled forces{};
  double along_normal = 0.0;
  std::array<double, 2> bars{};
  int elements_across = 0;
};

/// Points `begin` to `end` - 1 of a list.
struct TablePart {
  std::size_t begin = 0, end = 0;
};

/// A list of points, cut into parts of at most halfspace::longest_chain. No part crosses the border
/// between consecutive groups of `of_a_group` points. The division does not depend on resumed
/// parts, so that results are identical to the last bit.
struct TableParts {
  std::string name;        ///< of the records
  std::string stage;       ///< in progress events
  contact::Share share;    ///< parts to solve; others are only read if stored
  std::size_t points = 0;  ///< in the list
  std::size_t of_a_group = 1;
  /// Called by several threads at once.
  std::function<std::vector<TablePoint>(const TablePart&)> solve;
  /// Called for every solved or resumed part, by one thread at a time.
  std::function<void(const TablePart&, const std::vector<TablePoint>&)> done;
};

/// `checkpoint` may be null. An exception from solve, done or progress ends the work and is passed
/// on.
void solve_parts(const TableParts& table, const contact::Progress& progress,
                 contact::Checkpoint* checkpoint);

}  // namespace rollfem::tables
