// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of finite elements. The error of their contact grid is that of half-spaces on the same
// grid, which are cheap to solve on finer ones; the error of the cells shows in how the difference
// between finite elements and half-spaces changes from level to level.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

#include <vector>

namespace rollfem::fem {

/// One number of a load point: by finite elements on two or more levels, the finest last, and by
/// half-spaces on the same contact grids.
struct NumberOnLevels {
  std::vector<double> finite;
  std::vector<double> half;
  double half_bar = 0.0;   ///< of the last of `half`, by the rules of the model halfspace
  double half_fine = 0.0;  ///< half-spaces on a grid four times finer (large: twice)
};
/// The bar of the last of `finite`.
double bar_beside_half_spaces(const NumberOnLevels& number);

/// Fills the bars of the last of the levels, each of half the cells of the one before, two at
/// least; adds to what its points have already (of the approach, by finite segments). False where
/// half-spaces have no solution on these grids: the bars are then those that the model halfspace
/// would take from the levels.
bool set_error_bars(const contact::Scene& scene, std::vector<contact::ModelResult>& levels);

}  // namespace rollfem::fem
