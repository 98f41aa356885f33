// SPDX-License-Identifier: LGPL-2.1-or-later
// Solvers for the points of a table: ellipses, or a shifted wheel.
#pragma once

#include "base/progress.hpp"
#include "case/case.hpp"
#include "tables/files/table_reader.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rollfem::tables {

/// A solved point, scaled as in a CreepTable.
struct TablePoint {
  Scaled forces{};
  double along_normal = 0.0;
  std::array<double, 2> bars{};
  int elements_across = 0;
  double rise = 0.0;
};

class TableSource {
 public:
  virtual ~TableSource() = default;
  /// Called before the grid: fills the data of every load and place of the first axis.
  virtual void prepare(CreepTable& table, const contact::Progress& progress) = 0;
  /// Solves points at a node of the axes other than the creepages (CreepTable::node).
  virtual std::vector<TablePoint> at_node(std::size_t node,
                                          const std::vector<Scaled>& creepages) const = 0;
  /// Solves points at an intermediate place, with scales interpolated from the table.
  virtual std::vector<TablePoint> between(const CreepTableReader& reader, const TablePlace& place,
                                          const std::vector<Scaled>& creepages) const = 0;
};

std::unique_ptr<TableSource> ellipse_source(const CreepTable& table, const contact::Case& input);
/// Throws the errors of the case's profiles.
std::unique_ptr<TableSource> wheel_source(const contact::Case& input);

}  // namespace rollfem::tables
