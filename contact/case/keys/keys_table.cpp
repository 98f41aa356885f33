// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

/// A list instead of `points` and `largest`.
void add_list(Keys<TableOptions>& keys, const std::string& name, const std::string& symbol,
              const std::string& sentence, std::vector<double> TableOptions::*list) {
  keys.reals(name)
      .symbol(symbol)
      .zero_or(smallest, 1000.0)
      .otherwise("from points and largest")
      .says(sentence)
      .into(list);
}

}  // namespace

SectionWithKeys table_section() {
  Keys<TableOptions> keys("table", "Grid of `rollfem table`; other commands ignore it",
                          &Case::table);
  keys.reals("axis_ratio")
      .symbol("a/b")
      .between(0.02, 50.0)
      .otherwise("from the case's Hertzian ellipse")
      .says("Axis ratios a/b of the ellipse, a along rolling, in increasing order.")
      .into(&TableOptions::axis_ratio);
  keys.reals("lateral_shift")
      .unit("mm")
      .within(1e3)
      .otherwise("none: the table is over axis_ratio")
      .says(
          "Lateral shifts of the wheelset, in increasing order, for a table of a wheel with "
          "profiles.")
      .into(&TableOptions::lateral_shift);
  keys.real("lateral_shift_step")
      .unit("mm")
      .between(1e-3, 1e3)
      .otherwise("lateral_shift lists every shift")
      .says("Step between the first and the last shift; lateral_shift then holds only these two.")
      .into(&TableOptions::lateral_shift_step);
  keys.reals("load")
      .unit("N")
      .between(1e-6, largest_force)
      .otherwise("that of the case")
      .says(
          "Increasing loads, an axis in place of the force under [load]; of ellipses with a memory "
          "or a layer.")
      .into(&TableOptions::load);
  keys.reals("speed")
      .unit("mm/s")
      .between(1e-3, 1e8)
      .otherwise("rolling.speed")
      .says("Increasing speeds, an axis in place of rolling.speed under a falling law.")
      .into(&TableOptions::speed);
  keys.triple("points")
      .between(2, 200)
      .otherwise("16, 16, 31; over lateral shifts 8, 8, 15")
      .says(
          "Grid points along xi', eta' (from 0; over lateral shifts mirrored to negative values) "
          "and phi' (both signs; an odd number includes 0).")
      .into(&TableOptions::points);
  keys.triple("largest")
      .between(0.01, 1000.0)
      .says(
          "Largest xi', eta' and phi' of the grid; beyond it full sliding is assumed (refused "
          "with a falling law or a layer).")
      .into(&TableOptions::largest);
  add_list(keys, "longitudinal_values", "xi'",
           "Scaled longitudinal creepages (docs/tables.md) from 0 on, instead of the first entries "
           "of points and largest; over lateral shifts mirrored to negative values.",
           &TableOptions::longitudinal);
  add_list(keys, "lateral_values", "eta'",
           "Scaled lateral creepages from 0 on, instead of the second entries.",
           &TableOptions::lateral);
  add_list(keys, "spin_values", "phi'",
           "Scaled spins from 0 on, instead of the third entries; mirrored to negative values.",
           &TableOptions::spin);
  keys.integer("check_points")
      .between(0, 1e6)
      .says("Random points between grid points at which the interpolation error is evaluated.")
      .into(&TableOptions::check_points);
  return keys;
}

}  // namespace rollfem::contact
