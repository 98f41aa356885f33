// SPDX-License-Identifier: LGPL-2.1-or-later
// What solves the points of a table: ellipses, or a wheel that is shifted.
#pragma once

#include "contact/case/case.hpp"
#include "tables/files/creep_table.hpp"
#include "tables/filling/table_parts.hpp"

#include <memory>
#include <vector>

namespace rollfem::tables {

class TableSource {
 public:
  virtual ~TableSource() = default;
  /// Before the grid: what a table has of every place of its first axis.
  virtual void prepare(CreepTable& table, const contact::Progress& progress) = 0;
  /// At place `place` of the first axis: number `first` of the table.
  virtual std::vector<TablePoint> at_node(std::size_t first,
                                          const std::vector<Scaled>& creepages) const = 0;
  /// At a place between, with what the table says there of scales.
  virtual std::vector<TablePoint> between(const CreepTableReader& reader, double place,
                                          const std::vector<Scaled>& creepages) const = 0;
};

std::unique_ptr<TableSource> ellipse_source(const CreepTable& table);
/// Throws what the profiles of the case do.
std::unique_ptr<TableSource> wheel_source(const contact::Case& input);

}  // namespace rollfem::tables
