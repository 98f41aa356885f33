// SPDX-License-Identifier: LGPL-2.1-or-later
// Draws from a seed that are the same on every machine, for the makers of random contacts.
#pragma once

#include "base/material.hpp"

#include <cmath>
#include <random>

namespace rollfem::testing {

class RandomDraws {
 protected:
  explicit RandomDraws(unsigned seed) : seed_(seed) {}

  /// The stream of this number.
  void begin(unsigned number) { generator_.seed(seed_ * 1000003u + number); }

  double uniform(double from, double to) {
    // Of the generator's own bits: distributions of the library differ from one to another.
    return from + (to - from) * (static_cast<double>(generator_()) / 4294967296.0);
  }
  double log_uniform(double from, double to) {
    return std::exp(uniform(std::log(from), std::log(to)));
  }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

  contact::Material material(double shear_modulus) {
    const double nu = uniform(0.0, 0.49);
    return {2.0 * shear_modulus * (1.0 + nu), nu};
  }

 private:
  unsigned seed_;
  std::mt19937 generator_;
};

}  // namespace rollfem::testing
