// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws by which friction falls with the velocity s of the slip: mu_kin + mu_1 f_1(s) + mu_2
// f_2(s). A law is its word and its f_i, which are 1 at rest and 1/2 at s_hi; keys, checks, results
// and conversions take the laws from here.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace rollfem::contact {

struct FallShape {
  /// f_i and its derivative by s / s_hi.
  struct Left {
    double value = 0.0;
    double slope = 0.0;
  };

  const char* word = "";  ///< in case files and results
  Left (*left)(std::size_t i, double s_over_half) = nullptr;
  /// Its numbers may be given as Polach's A and B, which are of f_i = exp(-B s).
  bool polach = false;

  static const FallShape none;         ///< Coulomb's law
  static const FallShape linear;       ///< max(0, 1 - s/(2 s_hi))
  static const FallShape rational;     ///< 1/(1 + s/s_h1), 1/(1 + (s/s_h2)^2)
  static const FallShape exponential;  ///< 2^(-s/s_hi)

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
