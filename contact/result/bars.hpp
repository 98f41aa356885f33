// SPDX-License-Identifier: LGPL-2.1-or-later
// The error statement of every reported value: its error bar, or why it has none (exact,
// prescribed, ...). Error bars are explained in docs/results.md.
#pragma once

#include "contact/result/quantities.hpp"
#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

#include <string>

namespace rollfem::contact {

/// Reason why a value has no error bar, as in PointResult::no_bar and all files.
namespace no_bar {
inline constexpr const char* exact = "exact";        ///< a closed form, computed to rounding
inline constexpr const char* given = "given";        ///< prescribed by the case
inline constexpr const char* counted = "counted";    ///< a count
inline constexpr const char* measured = "measured";  ///< a figure of the computation
/// A closed form of an approximate theory: no discretisation error; see model_error.
inline constexpr const char* theory = "theory";
inline constexpr const char* one_grid = "one grid";  ///< no second solution to compare
/// Found by the balance of a wheelset, for which there is no balance on a coarser grid.
inline constexpr const char* balance = "balance";
/// Depends on geometry.reference_distance (line contact), so it has no absolute meaning.
inline constexpr const char* relative = "relative";
inline constexpr const char* not_estimated = "not estimated";
/// The largest stress lies on the surface, or so near it that the coarser grid does not tell.
inline constexpr const char* near_surface = "near surface";
/// Grows without bound on finer grids: the pressure at a sharp end of a body.
inline constexpr const char* no_limit = "no limit";
}  // namespace no_bar

/// A model's reasons for values without error bar.
struct BarRules {
  /// Patch, pressure and approach are Hertz's closed form: exact where there are no true profiles,
  /// a theory of an ellipse where there are.
  bool hertzian = false;
  /// Reason for all other values, a word of no_bar.
  const char* otherwise = no_bar::not_estimated;
};

/// Sets the error bars of creepages found by the balance of a wheelset, and the reason in
/// PointResult::no_bar for every value without bar, unless the model has set it. Prescribed values
/// (a force along z, an approach) have no bar but the word "given".
void explain_bars(const Scene& scene, const BarRules& rules, ModelResult& result);

/// "+- 0.58", over `scale`, or the reason instead; empty if the point has neither.
std::string bar_text(const PointResult& point, const std::string& quantity, double scale = 1.0);

}  // namespace rollfem::contact
