// SPDX-License-Identifier: LGPL-2.1-or-later
// The accuracy a result reached in the requested quantities, by its own error estimates.
#pragma once

#include "contact/base/accuracy.hpp"
#include "contact/result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

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
