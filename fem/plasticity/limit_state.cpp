// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/limit_state.hpp"

#include "contact/iteration/anderson.hpp"

#include <algorithm>

namespace rollfem::fem {

namespace {

/// So little that least squares do not see what only follows.
constexpr double following = 1e-3;  ///< MPa

/// Calls visit(number, weight) for every number of a state, that of the vector being weight times
/// the number of the state.
template <class Visit>
void for_each_number(PlasticState& state, const Visit& visit) {
  for (Deviator& back : state.back)
    for (double& component : back) visit(component, 1.0);
  for (double& component : state.strain) visit(component, following);
  visit(state.accumulated, following);
}

}  // namespace

void LimitState::approach(const std::vector<Deviator>& residual,
                          std::vector<PlasticState>& states) {
  std::vector<double> end;
  for (std::size_t k = 0; k < states.size(); ++k) {
    end.insert(end.end(), residual[k].begin(), residual[k].end());
    for_each_number(states[k],
                    [&](double number, double weight) { end.push_back(weight * number); });
  }
  if (cycles_.empty()) cycles_.emplace_back(end.size(), 0.0);
  cycles_.push_back(end);
  constexpr int depth = 5;
  if (cycles_.size() > 2 * (depth + 1)) cycles_.erase(cycles_.begin(), cycles_.begin() + 2);
  contact::Anderson anderson(depth);
  Eigen::VectorXd next;
  const auto vector = [](std::vector<double>& of) {
    return Eigen::Map<Eigen::VectorXd>(of.data(), static_cast<Eigen::Index>(of.size()));
  };
  for (std::size_t k = 0; k < cycles_.size(); k += 2)
    next = anderson.next(vector(cycles_[k]), vector(cycles_[k + 1]));
  cycles_.emplace_back(next.begin(), next.end());
  const double* from = next.data();
  for (PlasticState& state : states) {
    from += residual.front().size();
    for_each_number(state, [&](double& number, double weight) { number = *from++ / weight; });
    state.accumulated = std::max(state.accumulated, 0.0);
  }
}

}  // namespace rollfem::fem
