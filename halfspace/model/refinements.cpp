// SPDX-License-Identifier: LGPL-2.1-or-later
// Refinement levels of the half-space in a study.
#include "contact/result/validity.hpp"
#include "halfspace/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::ModelInput;
using contact::RefinedInput;
using contact::Refinement;

namespace {

RefinedInput grid_level(ModelInput input, int k, int /*n*/) {
  const double factor = std::exp2(k - 2);
  if (auto& cell = input.contact_grid.cell_size) {
    (*cell)[0] /= factor;
    if (!input.geometry.line) (*cell)[1] /= factor;
    const double side = (*cell)[0];
    return {fmt::format("{:.4g} mm", side), side, std::move(input)};
  }
  const int across = input.contact_grid.elements_across =
      std::max(contact::fewest_elements_across, input.contact_grid.elements_across / 4) << k;
  return {fmt::format("{} across", across), static_cast<double>(across), std::move(input)};
}

}  // namespace

Refinement contact_grid() {
  return {"grid", "", "contact grid", 2.0, 5, false, grid_level};
}

}  // namespace rollfem::halfspace
