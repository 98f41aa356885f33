// SPDX-License-Identifier: LGPL-2.1-or-later
// How steel yields: von Mises' cylinder with kinematic and isotropic hardening, as a case gives it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// sqrt(3/2) |s - sum of alpha_k| <= yield stress at p, the accumulated plastic strain;
/// d alpha_k = 2/3 modulus d eps_p - recovery alpha_k dp (Armstrong and Frederick 1966; several of
/// them: Chaboche 1986; recovery 0: Prager).
struct BodyPlasticity {
  static constexpr std::size_t most_back_stresses = 3;
  struct BackStress {
    double modulus = 0.0;   ///< MPa
    double recovery = 0.0;  ///< 0: linear hardening
  };
  double yield_stress = 0.0;  ///< MPa, uniaxial, before plastic flow
  std::array<BackStress, most_back_stresses> back_stresses{};
  double rise = 0.0, rate = 0.0;  ///< constants of HardeningLaw
  /// degC, and MPa in place of yield_stress from there; linear from the temperature before contact.
  std::optional<double> hot_temperature, hot_yield_stress;
  /// Residual stress before the first pass, MPa, at depths in mm, ascending: linear between,
  /// constant outside; the same everywhere along and across. Empty: none.
  struct ResidualStress {
    std::vector<double> depth, along, across;
    std::string file{};  ///< that gives them, as named in the case
  } residual;

  /// Uniaxial yield stress after the plastic strain p, MPa. `hot`: from 0 before contact to 1 at
  /// the hot temperature, which lowers all of it by the same factor.
  double yield_stress_at(double p, double hot = 0.0) const;
  /// Yield stress in shear, MPa: the k of the shakedown map.
  double shear_yield_stress() const { return yield_stress / 1.7320508075688772; }
};

/// A law by which the yield surface grows or shrinks with the accumulated plastic strain p. Keys,
/// checks and the steel take it from here: a law is its constants among the members above, its row
/// in hardening_laws(), and its formula in docs/plasticity.md.
struct HardeningLaw {
  struct Constant {
    const char* key;
    double BodyPlasticity::*member;  ///< 0 without the key
    const char *symbol, *unit;
    bool may_be_negative;
    const char* sentence;
  };
  std::vector<Constant> constants;                        ///< without effect unless all are given
  double (*rise)(const BodyPlasticity& steel, double p);  ///< of the yield stress, MPa
};

inline const std::vector<HardeningLaw>& hardening_laws() {
  static const std::vector<HardeningLaw> all{
      // Voce 1955
      {{{"isotropic_rise", &BodyPlasticity::rise, "Q", "MPa", true,
         "Rise of the yield stress with the accumulated plastic strain p, Q (1 - exp(-b p)) "
         "(Voce); negative: the steel softens."},
        {"isotropic_rate", &BodyPlasticity::rate, "b", "", false, "Its rate over p."}},
       [](const BodyPlasticity& steel, double p) {
         return -steel.rise * std::expm1(-steel.rate * p);
       }}};
  return all;
}

inline double BodyPlasticity::yield_stress_at(double p, double hot) const {
  double stress = yield_stress;
  for (const HardeningLaw& law : hardening_laws()) stress += law.rise(*this, p);
  return stress * (1.0 + hot * (hot_yield_stress.value_or(yield_stress) / yield_stress - 1.0));
}

}  // namespace rollfem::contact
