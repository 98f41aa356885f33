// SPDX-License-Identifier: LGPL-2.1-or-later
// The error statement of every value that leaves the program: its bar, that it is exact, or
// why it has none. Error bars are explained in docs/results.md.
#pragma once

#include "contact/result/quantities.hpp"
#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

#include <string>

namespace rollfem::contact {

/// Why a value has no bar, as PointResult::no_bar and all files have it.
namespace no_bar {
inline constexpr const char* exact = "exact";        ///< a closed form, computed to rounding
inline constexpr const char* given = "given";        ///< by the case
inline constexpr const char* counted = "counted";    ///< a number of things
inline constexpr const char* measured = "measured";  ///< of the computation, not of the contact
/// A closed form that is no exact solution: no grid, but a theory, whose error is model_error.
inline constexpr const char* theory = "theory";
inline constexpr const char* one_grid = "one grid";  ///< there is no second one to compare with
/// Found by the balance of a wheelset, of which there is no other on a coarser grid.
inline constexpr const char* balance = "balance";
/// Of a line contact: relative to geometry.reference_distance, and without a meaning of its own.
inline constexpr const char* relative = "relative";
inline constexpr const char* not_estimated = "not estimated";
}  // namespace no_bar

/// What a model says of values without a bar.
struct BarRules {
  /// Patch, pressure and approach are Hertz's closed form: exact where there are no true profiles,
  /// a theory of an ellipse where there are.
  bool hertzian = false;
  /// Of its other values: a word of no_bar.
  const char* otherwise = no_bar::not_estimated;
};

/// Bars that follow from others of the point: of the length and width of the patch from its
/// semi-axes, of the work of the creepages from forces and creepages. Leaves those that are there.
void derive_bars(PointResult& point);

/// Gives creepages that the balance of a wheelset has found their bars, and every value without a
/// bar its word in PointResult::no_bar, where the model has not. What the case gives (a force along
/// z, an approach) has no bar but the word "given".
void explain_bars(const Scene& scene, const BarRules& rules, ModelResult& result);

/// "+- 0.58", or the word in place of it; empty where the point has neither.
std::string bar_text(const PointResult& point, const std::string& quantity);

}  // namespace rollfem::contact
