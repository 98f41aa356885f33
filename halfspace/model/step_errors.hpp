// SPDX-License-Identifier: LGPL-2.1-or-later
// Error of a transient from the length of its steps: the same history on coarse elements in shorter
// steps.
#pragma once

#include "result/result.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::halfspace {

/// A history whose steps are divided.
struct DividedSteps {
  contact::Scene scene;
  std::vector<std::size_t> ends;  ///< the point that ends each step of the original
};

/// Each step of a transient in two to sixteen equal ones of an eighth of the patch or less; before
/// the last two patch lengths, whose material has all entered within them, in one. Creepages are
/// constant over a step, loads and prescribed forces change linearly.
DividedSteps divided_steps(const contact::Scene& scene, double patch_length);

/// Adds to the error bars of `fine` a multiple of the change between steps as given (`whole`) and
/// others, both on the same coarse elements: of order 1, twice that of halved steps. `ends`: the
/// other point that ends each step.
void add_step_errors(const std::vector<contact::PointResult>& whole,
                     const std::vector<contact::PointResult>& others,
                     const std::vector<std::size_t>& ends, double factor,
                     std::vector<contact::PointResult>& fine);

/// The note where there is no solution in shorter steps.
inline constexpr const char* steps_left_out =
    "error bars leave out the length of the steps: no solution with other ones";

}  // namespace rollfem::halfspace
