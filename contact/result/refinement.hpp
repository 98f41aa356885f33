// SPDX-License-Identifier: LGPL-2.1-or-later
// Decides when to stop halving cells: estimates the error of the
// requested quantities from the sequence of levels.
#pragma once

#include "contact/base/accuracy.hpp"
#include "contact/result/result.hpp"

#include <map>
#include <string>
#include <vector>

namespace rollfem::contact {

/// The change between two grids is taken times this where the order is 1 on the whole but no two
/// grids are even, as is usual for two grids (Roache 1994).
constexpr double uneven_safety = 1.5;

/// Error of the last of the values, which belong to cells of h, h/2, h/4, ... (coarsest first; two
/// at least), absolute. The order is that which the last three show, within [`least_order`, 2];
/// `assumed_order` when there are only two or the changes have opposite signs. Two grids may agree
/// by chance: a change is believed to be no less than a fourth of the one before, a sixteenth when
/// they have opposite signs.
double estimated_error(const std::vector<double>& values, double assumed_order,
                       double least_order = 1.0);

/// The largest error of what is asked for.
struct WorstError {
  std::string quantity;
  int point = 0;       ///< counted from 1
  double error = 0.0;  ///< as part of whole_of()
  /// "0.3 % of mu F_z (traction_coefficient at load point 2)".
  std::string text() const;
};

/// From the error estimates that the points carry.
WorstError worst_error(const AccuracyRequest& asked, double friction_coefficient,
                       const std::vector<PointResult>& points);

/// "accuracy 0.001 was asked for, ...": for ModelResult::shortfall.
std::string shortfall_text(const AccuracyRequest& asked, const WorstError& worst,
                           const std::string& reason);

/// The finest level of a ladder of ever finer ones, with its error bars.
struct Rung {
  std::string cells;     ///< "40 elements across"
  std::string no_finer;  ///< why it is the finest that can be had, and what to do; empty: it is not
  bool enough_levels = true;  ///< for its bars to be believed
};

/// Whether the accuracy of the case wants another level; says in the notes or as the shortfall of
/// the result what has come of it when it does not, or cannot have one. Of a case without: false.
bool refine_further(const AccuracyRequest& asked, double friction_coefficient, const Rung& rung,
                    const std::vector<PointResult>& points, ModelResult& result);

}  // namespace rollfem::contact
