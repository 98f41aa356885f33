// SPDX-License-Identifier: LGPL-2.1-or-later
// The time that a run takes where nobody has named an accuracy: shared by all scenes of a case,
// counted in predicted seconds, so that the same case makes the same choices. The clock counts
// only where a prediction was grossly wrong.
#pragma once

#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// A run without an accuracy answers within this, s.
constexpr double seconds_by_default = 60.0;

class Budget {
 public:
  /// `needs`: predicted seconds of each scene in the order in which they are solved; 0 where
  /// nothing can be predicted. `times`: this machine's seconds for a predicted one.
  explicit Budget(std::vector<double> needs, double times = 1.0,
                  double seconds = seconds_by_default);

  /// What all scenes need together where that can be predicted, s on this machine.
  double needed() const;

  /// What a level of the current scene may be predicted to take, s of a prediction: what is left
  /// when later scenes get what they need, but no less than an equal share of what is left.
  double allowed() const;

  /// A level of the current scene was predicted to take so long and took so long, both in s.
  /// Returns by how much its model is mispredicted: 1 where the prediction holds.
  double spend(double predicted, double taken);

  /// The current scene is done.
  void next() { ++current_; }

 private:
  std::vector<double> needs_;
  double times_;
  double left_;
  std::size_t current_ = 0;
};

}  // namespace rollfem::modelling
