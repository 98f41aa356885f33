// SPDX-License-Identifier: LGPL-2.1-or-later
// The state that cycles of passes tend to, found by extrapolation from cycle to cycle. Internal to
// fem/plasticity.
#pragma once

#include "fem/plasticity/plastic_law.hpp"
#include "result/record.hpp"

#include <vector>

namespace rollfem::fem {

/// Anderson's method (1965) for the residual stress and the back stresses behind the load. These
/// decide how the next cycle goes: in ratchetting they repeat, while plastic strain grows by what
/// causes no stress. It only follows them.
class LimitState {
 public:
  /// Replaces the states that have left a cycle by those with which the next one begins;
  /// `residual`: stress deviator behind the load on every streamline, MPa.
  void approach(const std::vector<Deviator>& residual, std::vector<PlasticState>& states);
  void exchange(contact::Record& record) { record.values(cycles_); }

 private:
  std::vector<std::vector<double>> cycles_;  ///< state before and behind each, in turn
};

}  // namespace rollfem::fem
