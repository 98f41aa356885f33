// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/plastic_law.hpp"

#include "base/root.hpp"

#include <cmath>
#include <cstddef>

namespace rollfem::fem {

namespace {

const double root_of_3_2 = std::sqrt(1.5);

}  // namespace

PlasticLaw::PlasticLaw(const contact::BodyPlasticity& parameters, double shear_modulus)
    : parameters_(parameters), shear_modulus_(shear_modulus) {}

Deviator PlasticLaw::stress(const PlasticState& state, const Deviator& strain) const {
  Deviator s = sum(strain, -1.0, state.strain);
  for (double& component : s) component *= 2.0 * shear_modulus_;
  return s;
}

Deviator PlasticLaw::relative_stress(const PlasticState& state, const Deviator& strain) const {
  Deviator s = stress(state, strain);
  for (const Deviator& back : state.back) s = sum(s, -1.0, back);
  return s;
}

double PlasticLaw::utilisation(const PlasticState& state, const Deviator& strain,
                               double hot) const {
  return root_of_3_2 * norm(relative_stress(state, strain)) /
         parameters_.yield_stress_at(state.accumulated, hot);
}

void PlasticLaw::advance(PlasticState& state, const Deviator& from, const Deviator& to, int steps,
                         const std::array<double, 2>& hot) const {
  const Deviator path = sum(to, -1.0, from);
  for (int k = 1; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    step(state, k == steps ? to : sum(from, part, path), hot[0] + part * (hot[1] - hot[0]));
  }
}

void PlasticLaw::step(PlasticState& state, const Deviator& strain, double hot) const {
  // The elastic range is left by more than rounding only.
  constexpr double rounding = 1e-14;
  if (utilisation(state, strain, hot) <= 1.0 + rounding) return;
  const auto& laws = parameters_.back_stresses;
  const Deviator trial = stress(state, strain);
  // With theta_k = 1/(1 + recovery_k dp) the relative stress is parallel to
  // trial - sum theta_k back_k, so that one equation for dp remains:
  // sqrt(3/2) |trial - sum theta_k back_k| = yield_stress(p + dp) + (3 G + sum theta_k modulus_k)
  // dp.
  Deviator direction{};
  const auto excess = [&](double dp) {
    direction = trial;
    double stiffness = 3.0 * shear_modulus_;
    for (std::size_t k = 0; k < laws.size(); ++k) {
      const double theta = 1.0 / (1.0 + laws[k].recovery * dp);
      direction = sum(direction, -theta, state.back[k]);
      stiffness += theta * laws[k].modulus;
    }
    return root_of_3_2 * norm(direction) -
           parameters_.yield_stress_at(state.accumulated + dp, hot) - stiffness * dp;
  };
  // The elastic strain alone bounds dp from above, unless the yield stress falls.
  const double at_rest = excess(0.0);
  double upper = at_rest / (3.0 * shear_modulus_), at_upper = excess(upper);
  while (at_upper > 0.0) at_upper = excess(upper *= 2.0);
  const double enough = 1e-13 * parameters_.yield_stress / (3.0 * shear_modulus_);
  const double dp =
      contact::root_between(excess, 0.0, at_rest, upper, at_upper, enough, "plastic strain");
  excess(dp);
  const double scale = root_of_3_2 * dp / norm(direction);
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const double theta = 1.0 / (1.0 + laws[k].recovery * dp);
    for (std::size_t i = 0; i < 6; ++i)
      state.back[k][i] =
          theta * (state.back[k][i] + 2.0 / 3.0 * laws[k].modulus * scale * direction[i]);
  }
  state.strain = sum(state.strain, scale, direction);
  state.accumulated += dp;
}

}  // namespace rollfem::fem
