// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/fall_shape.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

const FallShape FallShape::none{"constant", [](std::size_t, double, const Constants&) {
                                  return Left{1.0, 0.0};
                                }};

const FallShape FallShape::linear{"linear", [](std::size_t, double s, const Constants&) {
                                    return s < 2.0 ? Left{1.0 - 0.5 * s, -0.5} : Left{};
                                  }};

const FallShape FallShape::rational{
    "rational", [](std::size_t i, double s, const Constants&) {
      const double part = i == 0 ? 1.0 / (1.0 + s) : 1.0 / (1.0 + s * s);
      return Left{part, i == 0 ? -part * part : -2.0 * s * part * part};
    }};

const FallShape FallShape::exponential{"exponential",
                                       [](std::size_t, double s, const Constants&) {
                                         const double rate = std::log(2.0);
                                         const double part = std::exp(-rate * s);
                                         return Left{part, -rate * part};
                                       },
                                       true};

const FallShape FallShape::temperature{
    "temperature",
    none.left,
    false,
    {{{"cold_temperature", "T_c", -273.0, 1e4, 20.0,
       "Surface temperature up to which friction is the coefficient.", "degC"},
      {"hot_temperature", "T_h", -273.0, 1e4, std::nan(""),
       "Temperature from which friction is the hot_coefficient; linear between.", "degC"},
      {"hot_coefficient", "mu_h", 1e-12, 1000.0, std::nan(""),
       "Coefficient of hot surfaces; may be the larger one."}}},
    true};

std::vector<FallShape>& fall_shapes() {
  static std::vector<FallShape> all{FallShape::none, FallShape::linear, FallShape::rational,
                                    FallShape::exponential, FallShape::temperature};
  return all;
}

const FallShape& fall_shape(std::string_view word) {
  const auto& all = fall_shapes();
  return *std::find_if(all.begin(), all.end(),
                       [&](const FallShape& one) { return word == one.word; });
}

}  // namespace rollfem::contact
