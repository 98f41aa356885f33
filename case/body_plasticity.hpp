// SPDX-License-Identifier: LGPL-2.1-or-later
// How steel yields: von Mises' cylinder with kinematic and isotropic hardening, as a case gives it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::contact {

/// sqrt(3/2) |s - sum of alpha_k| <= yield_stress + rise (1 - exp(-rate p)), p the accumulated
/// plastic strain (Voce 1955); d alpha_k = 2/3 modulus d eps_p - recovery alpha_k dp (Armstrong and
/// Frederick 1966; several of them: Chaboche 1986; recovery 0: Prager).
struct BodyPlasticity {
  static constexpr std::size_t most_back_stresses = 3;
  struct BackStress {
    double modulus = 0.0;   ///< MPa
    double recovery = 0.0;  ///< 0: linear hardening
  };
  double yield_stress = 0.0;  ///< MPa, uniaxial
  std::array<BackStress, most_back_stresses> back_stresses{};
  double rise = 0.0;  ///< MPa, negative: cyclic softening
  double rate = 0.0;
  /// Residual stress before the first pass, MPa, at depths in mm, ascending: linear between,
  /// constant outside; the same everywhere along and across. Empty: none.
  struct ResidualStress {
    std::vector<double> depth, along, across;
    std::string file{};  ///< that gives them, as named in the case
  } residual;

  /// Yield stress in shear, MPa: the k of the shakedown map.
  double shear_yield_stress() const { return yield_stress / 1.7320508075688772; }
};

}  // namespace rollfem::contact
