// SPDX-License-Identifier: LGPL-2.1-or-later
// The time of a run: how long predicted seconds last on this machine, and without a requested
// accuracy the limit that all scenes of a case share. The limit is counted in predicted seconds, so
// that the same case leads to the same choices. Measured time counts only where a prediction was
// grossly wrong.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// Time limit of a run without a requested accuracy, s.
constexpr double seconds_by_default = 60.0;

class Budget {
 public:
  /// `needs`: predicted seconds of each scene in the order of solution; 0 if there is no
  /// prediction. `times`: seconds on this machine, if it is quiet, per predicted second. `seconds`:
  /// infinity without limit.
  explicit Budget(std::vector<double> needs, double times = 1.0,
                  double seconds = seconds_by_default);

  bool limited() const { return std::isfinite(left_); }

  /// Seconds per predicted second, for a level that has as much of a processor as the last one.
  double times() const { return times_ / had_; }

  /// Predicted time of all scenes together, s on this machine.
  double needed() const;

  /// Largest predicted time of a level of the current scene, in predicted seconds: the budget left
  /// after the needs of later scenes, but at least an equal share of the remaining budget.
  double allowed() const;

  /// Records the predicted and the measured time of a level of the current scene, both in s, and
  /// the part of a processor that it had (0: unknown). Returns the factor by which its model is
  /// mispredicted: 1 if the prediction holds for that part.
  double spend(double predicted, double taken, double had = 0.0);

  void next() { ++current_; }

 private:
  std::vector<double> needs_;
  double times_;
  double left_;
  double had_ = 1.0;           ///< part of a processor that the last level had
  double had_of_gross_ = 1.0;  ///< the same when a prediction was last grossly wrong
  std::size_t current_ = 0;
};

}  // namespace rollfem::modelling
