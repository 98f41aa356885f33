#include "postprocess/table/table_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace rollfem::postprocess {

namespace {

/// Columns that both tables begin with.
const std::string place_and_forces =
    "axis_ratio [-],longitudinal_scaled [-],lateral_scaled [-],spin_scaled [-],"
    "longitudinal_force [mu F_n],lateral_force [mu F_n],spin_moment [mu F_n c]";

}  // namespace

std::string table_csv(const CreepTable& table) {
  std::string text =
      place_and_forces + ",force_bar [mu F_n],moment_bar [mu F_n c],elements_across [-]\n";
  const auto& [xi, eta, phi] = table.creepage;
  std::size_t at = 0;
  for (const double ratio : table.axis_ratio)
    for (const double x : xi)
      for (const double y : eta)
        for (const double z : phi) {
          const Scaled& force = table.forces[at];
          fmt::format_to(std::back_inserter(text),
                         "{},{},{},{},{:.7g},{:.7g},{:.7g},{:.2g},{:.2g},{}\n", ratio, x, y, z,
                         force[0], force[1], force[2], table.bars[at][0], table.bars[at][1],
                         table.elements_across[at]);
          ++at;
        }
  return text;
}

std::string interpolation_csv(const CreepTable& table) {
  std::string text = place_and_forces + ",force_error [mu F_n],moment_error [mu F_n c]\n";
  for (const CheckedPoint& point : table.checked) {
    const auto& [x, y, z] = point.creepage;
    const Scaled& found = point.interpolated;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.7g},{:.7g},{:.7g},{:.3g},{:.3g}\n",
                   point.axis_ratio, x, y, z, point.solved[0], point.solved[1], point.solved[2],
                   std::hypot(found[0] - point.solved[0], found[1] - point.solved[1]),
                   found[2] - point.solved[2]);
  }
  return text;
}

}  // namespace rollfem::postprocess
