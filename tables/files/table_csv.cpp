// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/table_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace rollfem::tables {

namespace {

const char* const creepage_columns =
    ",longitudinal_scaled [-],lateral_scaled [-],spin_scaled [-],longitudinal_force [mu "
    "F_n],lateral_force [mu F_n],spin_moment [mu F_n c],";

/// Names of the axes other than the creepages.
std::string first_columns(const CreepTable& table) {
  return std::string(table.load.size() > 1 ? "load [N]," : "") +
         (table.speed.size() > 1 ? "speed [mm/s]," : "") +
         (table.over_shifts() ? "lateral_shift [mm]" : "axis_ratio [-]");
}

std::string values_of(const CreepTable& table, const TablePlace& place) {
  return (table.load.size() > 1 ? fmt::format("{},", place.load) : "") +
         (table.speed.size() > 1 ? fmt::format("{},", place.speed) : "") +
         fmt::format("{}", place.first);
}

}  // namespace

std::string table_csv(const CreepTable& table) {
  std::string text = first_columns(table) + creepage_columns +
                     "force_bar [mu F_n],moment_bar [mu F_n c],elements_across [-]" +
                     (table.over_shifts() ? ",force_along_normal [mu F_n]\n" : "\n");
  const auto& [xi, eta, phi] = table.creepage;
  std::size_t at = 0;
  for (std::size_t node = 0; node < table.nodes(); ++node) {
    const std::string place = values_of(table, table.node(node));
    for (const double x : xi)
      for (const double y : eta)
        for (const double z : phi) {
          const Scaled& force = table.forces[at];
          fmt::format_to(std::back_inserter(text),
                         "{},{},{},{},{:.7g},{:.7g},{:.7g},{:.2g},{:.2g},{}", place, x, y, z,
                         force[0], force[1], force[2], table.bars[at][0], table.bars[at][1],
                         table.elements_across[at]);
          if (table.over_shifts())
            fmt::format_to(std::back_inserter(text), ",{:.7g}", table.along_normal[at]);
          text += '\n';
          ++at;
        }
  }
  return text;
}

std::string interpolation_csv(const CreepTable& table) {
  std::string text =
      first_columns(table) + creepage_columns + "force_error [mu F_n],moment_error [mu F_n c]\n";
  for (const InterpolatedPoint& point : table.checked) {
    const auto& [x, y, z] = point.creepage;
    const Scaled& found = point.interpolated;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.7g},{:.7g},{:.7g},{:.3g},{:.3g}\n",
                   values_of(table, point.place), x, y, z, point.solved[0], point.solved[1],
                   point.solved[2],
                   std::hypot(found[0] - point.solved[0], found[1] - point.solved[1]),
                   found[2] - point.solved[2]);
  }
  return text;
}

std::string shifts_csv(const CreepTable& table) {
  const bool loads = table.load.size() > 1;
  std::string text = loads ? "load [N],lateral_shift [mm]" : "lateral_shift [mm]";
  for (const WheelColumn& column : wheel_columns())
    text +=
        fmt::format(",{} [{}]", column.name, column.unit == std::string("1") ? "-" : column.unit);
  text += '\n';
  for (std::size_t k = 0; k < table.wheels.size(); ++k) {
    const std::size_t shifts = table.lateral_shift.size();
    if (loads) fmt::format_to(std::back_inserter(text), "{},", table.load[k / shifts]);
    fmt::format_to(std::back_inserter(text), "{}", table.lateral_shift[k % shifts]);
    for (const WheelColumn& column : wheel_columns())
      fmt::format_to(std::back_inserter(text), ",{:.9g}", table.wheels[k].*column.member);
    text += '\n';
  }
  return text;
}

}  // namespace rollfem::tables
