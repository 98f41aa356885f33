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

/// Safety factor on the change between two grids, where the order is 1 on average but irregular
/// from grid to grid, as usual for two grids (Roache 1994).
constexpr double uneven_safety = 1.5;

/// Error of the last of the values, which belong to cells of h, h/2, h/4, ... (coarsest first; two
/// at least), absolute. The order is the observed order of the last three, within [`least_order`,
/// 2]; `assumed_order` with only two values or changes of opposite signs. Because two grids may
/// agree by chance, a change counts at least as a fourth of the previous one, a sixteenth for
/// opposite signs.
double estimated_error(const std::vector<double>& values, double assumed_order,
                       double least_order = 1.0);

/// The largest error of the requested quantities.
struct WorstError {
  std::string quantity;
  int point = 0;       ///< counted from 1
  double error = 0.0;  ///< as a fraction of whole_of()
  /// "0.3 % of mu F_z (traction_coefficient at load point 2)".
  std::string text() const;
};

/// From the error estimates of the points.
WorstError worst_error(const AccuracyRequest& asked, double friction_coefficient,
                       const std::vector<PointResult>& points);

/// "accuracy 0.001 was asked for, ...": for ModelResult::shortfall.
std::string shortfall_text(const AccuracyRequest& asked, const WorstError& worst,
                           const std::string& reason);

/// The finest of a sequence of levels, with its error bars.
struct Rung {
  std::string cells;          ///< "40 elements across"
  std::string no_finer;       ///< why it is the finest possible, and remedy; empty: it is not
  bool enough_levels = true;  ///< for reliable error bars
};

/// Whether the accuracy of the case needs another level. Otherwise, or if none is possible, records
/// the outcome in the notes or as the shortfall of the result. False for a case without accuracy.
bool refine_further(const AccuracyRequest& asked, double friction_coefficient, const Rung& rung,
                    const std::vector<PointResult>& points, ModelResult& result);

}  // namespace rollfem::contact
