// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of one material point that yields: plastic strain and hardening along a path of strain.
#pragma once

#include "case/body_plasticity.hpp"
#include "result/stress_measures.hpp"

#include <array>

namespace rollfem::fem {

/// A symmetric tensor without trace.
using Deviator = contact::SymmetricTensor;
using contact::norm;
using contact::product;
using contact::sum;

/// What a material point remembers.
struct PlasticState {
  Deviator strain{};                                                         ///< plastic strain
  std::array<Deviator, contact::BodyPlasticity::most_back_stresses> back{};  ///< MPa
  double accumulated = 0.0;  ///< plastic strain p = integral of sqrt(2/3) |d eps_p|
};

class PlasticLaw {
 public:
  PlasticLaw(const contact::BodyPlasticity& parameters, double shear_modulus);

  double shear_modulus() const { return shear_modulus_; }
  const contact::BodyPlasticity& parameters() const { return parameters_; }
  /// Stress deviator, MPa, of a state at a total deviatoric strain: 2 G (e - eps_p).
  Deviator stress(const PlasticState& state, const Deviator& strain) const;
  /// Von Mises stress relative to the yield surface of the state: 1 on it, above 1 outside. `hot`:
  /// see BodyPlasticity::yield_stress_at.
  double utilisation(const PlasticState& state, const Deviator& strain, double hot = 0.0) const;
  /// The state after the deviatoric strain has gone straight from `from` to `to` in `steps` equal
  /// steps, and the temperature through `hot`, of the implicit Euler rule. Each is exact for the
  /// direction of flow: the new stress lies on the new yield surface, and the plastic strain along
  /// its normal there (Kobayashi and Ohno 2002, Int. J. Numer. Meth. Engng 53, "Implementation of
  /// cyclic plasticity models based on a general form of kinematic hardening"). Of first order in
  /// the length of a step where the direction turns.
  void advance(PlasticState& state, const Deviator& from, const Deviator& to, int steps,
               const std::array<double, 2>& hot = {}) const;

 private:
  void step(PlasticState& state, const Deviator& strain, double hot) const;
  Deviator relative_stress(const PlasticState& state, const Deviator& strain) const;

  contact::BodyPlasticity parameters_;
  double shear_modulus_;
};

}  // namespace rollfem::fem
