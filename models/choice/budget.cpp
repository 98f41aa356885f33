// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/choice/budget.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rollfem::modelling {

namespace {

/// A prediction counts as wrong if the level took this many times as long, and longer than this
/// noise, s.
constexpr double gross = 3.0, least_gross = 2.0;

}  // namespace

Budget::Budget(std::vector<double> needs, double times, double seconds)
    : needs_(std::move(needs)), times_(times), left_(seconds) {}

double Budget::needed() const {
  return times_ * std::accumulate(needs_.begin(), needs_.end(), 0.0);
}

double Budget::allowed() const {
  const double times = times_ / had_of_gross_;
  if (current_ + 1 >= needs_.size()) return std::max(0.0, left_) / times;
  const auto later = needs_.begin() + static_cast<std::ptrdiff_t>(current_ + 1);
  const double kept = times * std::accumulate(later, needs_.end(), 0.0);
  const double share = left_ / static_cast<double>(needs_.size() - current_);
  return std::max({0.0, left_ - kept, share}) / times;
}

double Budget::spend(double predicted, double taken, double had) {
  if (had > 0.0) had_ = had;
  const double expected = times_ * predicted;
  const bool wrong = taken > least_gross && taken > gross * expected;
  left_ -= wrong ? taken : expected;
  if (!wrong) return 1.0;
  had_of_gross_ = had_;
  return expected > 0.0 ? std::max(1.0, had_ * taken / expected) : 1.0;
}

}  // namespace rollfem::modelling
