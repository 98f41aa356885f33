// SPDX-License-Identifier: LGPL-2.1-or-later
// The accuracy of results in the requested quantities: errors from a sequence of levels, whether
// cells are to be halved again, and what was reached.
#pragma once

#include "base/accuracy.hpp"
#include "result/result.hpp"

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

/// Errors at the quantity and load point where their sum is largest.
struct Reached {
  double discretisation = 0.0;  ///< its bar, as part of its whole (whole_of)
  double model = 0.0;           ///< its model error, relative as well
  std::string quantity;         ///< empty: no requested quantity has an error
  int point = 0;                ///< counted from 1
  /// Largest discretisation error of all quantities and load points; the forecasts of finer grids
  /// start from it.
  double most_discretisation = 0.0;
  double most_model = 0.0;
  double together() const { return discretisation + model; }
  /// "discretisation 0.6 %, model 0.2 % of mu (traction_coefficient at load point 2)" If the model
  /// error is not known: "discretisation 0.6 % of mu (...), model unknown: WHY".
  std::string text(const std::string& why_unknown = "") const;
};

/// A quantity whose required bar is missing counts as unknown (infinity). A missing model error
/// counts as unknown too, unless `model_error_known`: it is then 0.
Reached reached_by(const ModelResult& result, const AccuracyRequest& asked,
                   double friction_coefficient, bool model_error_known);

/// Default of `auto` if the case requests no accuracy.
constexpr double default_accuracy = 0.01;

/// Which results miss the accuracy, and the worst errors: "40 of 42 contacts miss 1 %: worst 1.7 %
/// (b), 1.3 % of mu (-F_x/F_z)". Empty if none does. Results chosen by `auto` miss it with error
/// bar and model error together, others if they have a shortfall.
std::string missed_text(const std::vector<ModelResult>& results, const AccuracyRequest& asked,
                        double friction_coefficient);

/// "0.63 %"
std::string percent(double part);

}  // namespace rollfem::contact
