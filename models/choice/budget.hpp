// SPDX-License-Identifier: LGPL-2.1-or-later
// The time budget of a run without a requested accuracy: shared by all scenes of a case and counted
// in predicted seconds, so that the same case leads to the same choices. Measured time counts only
// where a prediction was grossly wrong.
#pragma once

#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// Time limit of a run without a requested accuracy, s.
constexpr double seconds_by_default = 60.0;

class Budget {
 public:
  /// `needs`: predicted seconds of each scene in the order of solution; 0 if there is no
  /// prediction. `times`: seconds on this machine per predicted second.
  explicit Budget(std::vector<double> needs, double times = 1.0,
                  double seconds = seconds_by_default);

  /// Predicted time of all scenes together, s on this machine.
  double needed() const;

  /// Largest predicted time of a level of the current scene, in predicted seconds: the budget left
  /// after the needs of later scenes, but at least an equal share of the remaining budget.
  double allowed() const;

  /// Records the predicted and the measured time of a level of the current scene, both in s.
  /// Returns the factor by which its model is mispredicted: 1 if the prediction holds.
  double spend(double predicted, double taken);

  void next() { ++current_; }

 private:
  std::vector<double> needs_;
  double times_;
  double left_;
  std::size_t current_ = 0;
};

}  // namespace rollfem::modelling
