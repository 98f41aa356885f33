// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws by which friction falls with the velocity s of the slip: mu_kin + mu_1 f_1(s) + mu_2
// f_2(s). A law is its word, its f_i, which are 1 at rest and 1/2 at s_hi, and the constants that
// it alone has; keys, checks, results and conversions take them from here.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace rollfem::contact {

struct FallShape {
  static constexpr std::size_t most_constants = 4;
  using Constants = std::array<double, most_constants>;
  /// A constant of this law alone, for both f_i; a key of [friction] with a name of its own. Those
  /// of a fall with slip have no unit, because f_i is a function of s / s_hi.
  struct Constant {
    const char* name = nullptr;  ///< null: none
    const char* symbol = "";
    double lower = 0.0, upper = 0.0;
    double otherwise = 0.0;  ///< without the key
    const char* sentence = "";
    const char* unit = "";
  };

  /// f_i and its derivative by s / s_hi.
  struct Left {
    double value = 0.0;
    double slope = 0.0;
  };

  const char* word = "";  ///< in case files and results
  Left (*left)(std::size_t i, double s_over_half, const Constants& own) = nullptr;
  /// The law may be given by Polach's A and B, with f_i = exp(-B s).
  bool polach = false;
  std::array<Constant, most_constants> constants{};
  /// mu follows the temperature of the surfaces instead of the slip: linear from
  /// friction.coefficient at the first constant (degC) to the third at the second; no f_i.
  bool by_temperature = false;

  static const FallShape none;         ///< Coulomb's law
  static const FallShape linear;       ///< max(0, 1 - s/(2 s_hi))
  static const FallShape rational;     ///< 1/(1 + s/s_h1), 1/(1 + (s/s_h2)^2)
  static const FallShape exponential;  ///< 2^(-s/s_hi)
  static const FallShape temperature;

  bool operator==(const FallShape& other) const { return std::string_view(word) == other.word; }
  bool operator!=(const FallShape& other) const { return !(*this == other); }
};

inline const char* word_of(const FallShape& shape) {
  return shape.word;
}

/// All laws, in the order of their numbers in the C interface. A program may add one of its own
/// before it reads its first case (examples/friction_law_in_cpp).
std::vector<FallShape>& fall_shapes();

/// The law of a known word.
const FallShape& fall_shape(std::string_view word);

}  // namespace rollfem::contact
