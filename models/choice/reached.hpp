// SPDX-License-Identifier: LGPL-2.1-or-later
// The accuracy a result reached in the requested quantities, by its own error estimates.
#pragma once

#include "contact/base/accuracy.hpp"
#include "contact/result/result.hpp"

#include <string>

namespace rollfem::modelling {

/// Of the quantity and load point where both errors together are largest.
struct Reached {
  double discretisation = 0.0;  ///< its bar, as part of its whole (contact::whole_of)
  double model = 0.0;           ///< its model error, a part as well
  std::string quantity;         ///< empty: nothing that was asked for has an error
  int point = 0;                ///< counted from 1
  /// Largest of all quantities and load points, each by itself: what finer grids are expected from.
  double most_discretisation = 0.0;
  double most_model = 0.0;
  bool model_at_most = false;  ///< the model error is one that none exceeds, and not found
  /// Of all quantities.
  void set_largest_model(double part) {
    model = most_model = part;
    model_at_most = true;
  }
  double together() const { return discretisation + model; }
  /// "discretisation 0.6 %, model 0.2 % of mu (traction_coefficient at load point 2)"
  /// Where the model error is not known: "discretisation 0.6 % of mu (...), model unknown: WHY".
  std::string text(const std::string& why_unknown = "") const;
};

/// A quantity that should have a bar and has none counts as wholly unknown (infinity). Without
/// `model_error_known` model errors that are not there are unknown as well, else nothing.
Reached reached_by(const contact::ModelResult& result, const contact::AccuracyRequest& asked,
                   double friction_coefficient, bool model_error_known);

/// "0.63 %"
std::string percent(double part);

}  // namespace rollfem::modelling
