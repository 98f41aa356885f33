// SPDX-License-Identifier: LGPL-2.1-or-later
// The error statement of every reported value: its error bar, or why it has none (exact,
// prescribed, ...). Error bars are explained in docs/results.md.
#pragma once

#include "result/quantities.hpp"
#include "result/result.hpp"
#include "scene/scene.hpp"

#include <string>

namespace rollfem::contact {

/// A model's reasons for values without error bar.
struct BarRules {
  /// Patch, pressure and approach are Hertz's closed form: exact where there are no true profiles,
  /// a theory of an ellipse where there are.
  bool hertzian = false;
  NoBar otherwise = NoBar::not_estimated;  ///< for all other values
};

/// Sets the error bars of creepages found by the balance of a wheelset, and the reason in
/// PointResult::no_bar for every value without bar, unless the model has set it. Prescribed values
/// (a force along z, an approach) have no bar but the word "given".
void explain_bars(const Scene& scene, const BarRules& rules, ModelResult& result);

/// "+- 0.58", over `scale`, or the reason instead; empty if the point has neither.
std::string bar_text(const PointResult& point, const std::string& quantity, double scale = 1.0);

}  // namespace rollfem::contact
