// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of finite elements. The error of their contact grid equals that of half-spaces on the
// same grid, which are cheap to solve on finer grids; the error of the cells follows from the
// change of the difference between finite elements and half-spaces from level to level.
#pragma once

#include "result/result.hpp"
#include "scene/scene.hpp"

#include <array>
#include <vector>

namespace rollfem::fem {

/// One number of a load point: by finite elements on two or more levels, the finest last, and by
/// half-spaces on the same contact grids.
struct NumberOnLevels {
  std::vector<double> finite;
  std::vector<double> half;
  double half_bar = 0.0;   ///< bar of the last of `half`, by the rules of the model halfspace
  double half_fine = 0.0;  ///< half-space on a grid four times finer (twice for large ones)
};
/// The error bar of the last of `finite`.
double bar_beside_half_spaces(const NumberOnLevels& number);

/// Quantities of a pass over bodies that yield.
inline constexpr std::array<const char*, 7> pass_quantities{
    "plastic_strain", "plastic_increment", "net_plastic_increment", "residual_stress",
    "groove_depth",   "forward_flow",      "plastic_work"};

/// Sets the bars of these quantities from the same passes on cells of twice the size. Plastic
/// strain has kinks, so that two meshes may agree by chance and show no order: the bar is a
/// multiple of the largest relative change so far, at least of a part of that of the plastic
/// strain and of (cell / smaller semi-axis)^2: a peak as wide as the patch loses that much as a
/// mean over cells. The residual stress of a surface that flows depends on where cells lie along
/// rolling: at least cell / smaller semi-axis. Where it exceeds 60 %, there is none. `cell`: mm.
void set_pass_bars(const std::vector<contact::PointResult>& coarse, double cell, bool surface_flows,
                   std::vector<contact::PointResult>& fine);

/// Sets the error bars of the last level; at least two levels, each with half the cell size of the
/// previous one. Adds to existing bars of its points (approach of finite segments). False if
/// half-spaces have no solution on these grids: the bars then follow from the levels by the rules
/// of the model halfspace.
bool set_error_bars(const contact::Scene& scene, std::vector<contact::ModelResult>& levels);

}  // namespace rollfem::fem
