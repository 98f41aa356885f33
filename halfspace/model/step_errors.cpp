// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/step_errors.hpp"

#include "result/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::halfspace {

using contact::LoadPoint;
using contact::PointResult;
using contact::Scene;

namespace {

void move_towards(std::optional<double>& value, const std::optional<double>& before, double part) {
  if (value && before) value = *before + part * (*value - *before);
}

/// The end of a piece of `step`, at this part of its length.
LoadPoint piece_of(LoadPoint step, const LoadPoint* before, double part, double length) {
  step.step_length = length;
  if (before == nullptr) return step;
  move_towards(step.load.force, before->load.force, part);
  move_towards(step.load.approach, before->load.approach, part);
  move_towards(step.force.longitudinal, before->force.longitudinal, part);
  move_towards(step.force.lateral, before->force.lateral, part);
  return step;
}

}  // namespace

DividedSteps divided_steps(const Scene& scene, double patch_length) {
  DividedSteps divided{scene, {}};
  divided.scene.points.clear();
  for (std::size_t k = 0; k < scene.points.size(); ++k) {
    const LoadPoint& step = scene.points[k];
    const LoadPoint* before = k > 0 ? &scene.points[k - 1] : nullptr;
    int pieces = 1;
    double each = step.step_length;
    if (scene.problem_of(k) == contact::Problem::transient) {
      const double last = std::min(step.step_length, 2.0 * patch_length);
      pieces = std::max(2, static_cast<int>(std::ceil(8.0 * last / patch_length)));
      each = last / pieces;
    }
    double rolled = step.step_length - pieces * each;
    for (int piece = 0; piece < pieces; ++piece) {
      const double begin = piece == 0 ? 0.0 : rolled;
      rolled += each;
      const double part = piece + 1 < pieces ? rolled / step.step_length : 1.0;
      divided.scene.points.push_back(piece_of(step, before, part, rolled - begin));
    }
    divided.ends.push_back(divided.scene.points.size() - 1);
  }
  return divided;
}

void add_step_errors(const std::vector<PointResult>& whole, const std::vector<PointResult>& others,
                     const std::vector<std::size_t>& ends, double factor,
                     std::vector<PointResult>& fine) {
  for (std::size_t k = 0; k < fine.size(); ++k)
    for (auto& [name, bar] : fine[k].error_estimate) {
      const contact::Quantity& quantity = contact::quantity_named(name);
      const auto a = quantity.value(whole[k]), b = quantity.value(others[ends[k]]);
      if (a && b) bar = std::hypot(bar, factor * (*a - *b));
    }
}

}  // namespace rollfem::halfspace
