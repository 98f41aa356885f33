// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/friction_state.hpp"

#include "contact/iteration/leading_edge.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// exp(-t), (1 - exp(-t))/t and its derivative.
struct Decay {
  double left, mean, mean_by_t;
};

Decay decay(double t) {
  const double left = std::exp(-t);
  if (t < 1e-4) return {left, 1.0 - 0.5 * t, -0.5 + t / 3.0};
  const double mean = -std::expm1(-t) / t;
  return {left, mean, (left - mean) / t};
}

}  // namespace

void FrictionState::begin(const FrictionProblem& problem, const std::vector<Index>& places) {
  problem_ = &problem;
  places_ = &places;
  count_ = static_cast<Index>(places.size());
  rows_.clear();
  if (problem.law.varies())
    for (int j = 0; j < problem.grid.ny; ++j)
      rows_.push_back(problem.law.of_row(problem.grid.y(j)));
  if (!feels_slip()) return;
  memory_ = problem.law.memory();
  for (Eigen::VectorXd* values : {&coefficient_, &by_own_, &by_ahead_, &carried_})
    values->resize(count_);
  direction_.resize(2 * count_);
  if (memory_) find_ways();
}

void FrictionState::find_ways() {
  const ContactGrid& grid = problem_->grid;
  ways_.resize(count_);
  leads_.assign(static_cast<std::size_t>(count_), 1);
  if (problem_->past != nullptr) {
    ways_.setConstant(problem_->past->length);
    return;
  }
  const Field edges = leading_edges(grid, problem_->pressure);
  for (Index e = 0; e < count_; ++e) {
    const Index k = (*places_)[static_cast<std::size_t>(e)];
    const bool follows = e + 1 < count_ && (*places_)[static_cast<std::size_t>(e) + 1] == k + 1 &&
                         (k + 1) % grid.nx != 0;
    leads_[static_cast<std::size_t>(e)] = !follows;
    ways_[e] = follows ? grid.dx : std::max(0.0, 0.5 + edges[k]) * grid.dx;
  }
}

double FrictionState::slip_at(const Given& slip, Index e) const {
  return problem_->slip_factor * std::hypot(slip[e], slip[count_ + e]);
}

double steepness(const FrictionLaw& law, double pressure, double compliance, double way) {
  constexpr double slowest = 1e-12, fastest = 1e3, ratio = 1.5;
  const std::optional<FrictionMemory> memory = law.memory();
  double largest = 0.0;
  for (double slip = slowest; slip < fastest; slip *= ratio) {
    double fall = -law.at(slip).by_slip;
    if (memory)
      fall *= 1.0 - decay(way * std::max(slip, memory->least_slip) / memory->distance).left;
    largest = std::max(largest, fall);
  }
  return largest * pressure * compliance;
}

double FrictionState::steepness(double compliance) const {
  const auto of = [&](const FrictionLaw& one) {
    return contact::steepness(
        one, problem_->pressure.maxCoeff(), problem_->slip_factor * compliance,
        problem_->past != nullptr ? problem_->past->length : problem_->grid.dx);
  };
  if (rows_.empty()) return of(problem_->law);
  double largest = 0.0;
  for (Index e = 0; e < count_; ++e)
    if (e == 0 || &law(e) != &law(e - 1)) largest = std::max(largest, of(law(e)));
  return largest;
}

void FrictionState::set_rest(Vector bound) const {
  const double mu = problem_->law.coefficient();
  for (Index e = 0; e < count_; ++e)
    bound[e] = (rows_.empty() ? mu : law(e).coefficient()) *
               problem_->pressure[(*places_)[static_cast<std::size_t>(e)]];
}

void FrictionState::set_bound(const Given& slip, Vector bound) {
  follow(slip);
  for (Index e = 0; e < count_; ++e)
    bound[e] = coefficient_[e] * problem_->pressure[(*places_)[static_cast<std::size_t>(e)]];
}

/// With dt = h (r + r')/2, r the rate max(|w|, s_0)/d_c here and r' that of the element ahead, and
/// mu_s linear in t between both, dmu/dt = mu_s - mu has the solution
/// mu = e^-dt mu' + (1 - m) mu_s + (m - e^-dt) mu_s', m = (1 - e^-dt)/dt:
/// second order, a mean with positive weights however long the step, and mu_s for dt to infinity.
void FrictionState::follow(const Given& slip) {
  FrictionLaw::Coefficient ahead;
  double rate_ahead = 0.0, rate_ahead_by_slip = 0.0;
  for (Index e = count_; e-- > 0;) {
    const double size = slip_at(slip, e);
    const FrictionLaw::Coefficient own = law(e).at(size);
    coefficient_[e] = own.value;
    by_own_[e] = own.by_slip;
    by_ahead_[e] = carried_[e] = 0.0;
    if (!memory_) continue;
    const double rate = std::max(size, memory_->least_slip) / memory_->distance;
    const double rate_by_slip = size > memory_->least_slip ? 1.0 / memory_->distance : 0.0;
    if (leads_[static_cast<std::size_t>(e)]) {
      const Index k = (*places_)[static_cast<std::size_t>(e)];
      const double before =
          problem_->past != nullptr ? problem_->past->coefficient[k] : law(e).coefficient();
      const double left = std::exp(-ways_[e] * rate);
      coefficient_[e] = own.value + left * (before - own.value);
      by_own_[e] =
          (1.0 - left) * own.by_slip - left * (before - own.value) * ways_[e] * rate_by_slip;
    } else {
      const auto [left, mean, mean_by_t] = decay(0.5 * ways_[e] * (rate + rate_ahead));
      const double before = coefficient_[e + 1];
      coefficient_[e] = left * before + (1.0 - mean) * own.value + (mean - left) * ahead.value;
      const double by_t = left * (ahead.value - before) + mean_by_t * (ahead.value - own.value);
      by_own_[e] = (1.0 - mean) * own.by_slip + 0.5 * ways_[e] * rate_by_slip * by_t;
      by_ahead_[e] = (mean - left) * ahead.by_slip + 0.5 * ways_[e] * rate_ahead_by_slip * by_t;
      carried_[e] = left;
    }
    ahead = own;
    rate_ahead = rate;
    rate_ahead_by_slip = rate_by_slip;
  }
}

void FrictionState::linearise(const Given& slip) {
  follow(slip);
  for (Index e = 0; e < count_; ++e) {
    const double size = std::hypot(slip[e], slip[count_ + e]);
    const double factor = size > 0.0 ? problem_->slip_factor / size : 0.0;
    direction_[e] = factor * slip[e];
    direction_[count_ + e] = factor * slip[count_ + e];
  }
}

void FrictionState::change(const Given& slip_change, Vector bound_change) const {
  double ahead = 0.0, coefficient_ahead = 0.0;
  for (Index e = count_; e-- > 0;) {
    const double size =
        direction_[e] * slip_change[e] + direction_[count_ + e] * slip_change[count_ + e];
    const double coefficient =
        by_own_[e] * size + by_ahead_[e] * ahead + carried_[e] * coefficient_ahead;
    bound_change[e] = coefficient * problem_->pressure[(*places_)[static_cast<std::size_t>(e)]];
    ahead = size;
    coefficient_ahead = coefficient;
  }
}

}  // namespace rollfem::contact
