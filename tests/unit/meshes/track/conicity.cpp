// Equivalent conicity of radius differences whose waves are known in closed form.
#include "meshes/track/conicity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace rollfem;

namespace {

constexpr double distance = 1500.0;  // mm
constexpr double radius = 460.0;     // mm
constexpr double pi = 3.14159265358979323846;

meshes::RadiusDifference difference(const std::function<double(double)>& function,
                                    double step = 0.01, int count = 1000) {
  std::vector<double> shift, value;
  for (int k = 0; k <= count; ++k) {
    shift.push_back(step * k);
    value.push_back(k == 0 ? 0.0 : function(step * k));
  }
  return {shift, value};
}

}  // namespace

TEST(Conicity, OfConesIsTheirOwnAndTheirWaveIsKlingels) {
  const auto cones = difference([](double y) { return 2.0 * 0.05 * y; }, 0.5, 20);
  for (const double amplitude : {0.3, 3.0, 9.7}) {
    EXPECT_NEAR(cones.harmonic_conicity(amplitude), 0.05, 1e-14);
    EXPECT_NEAR(cones.wave_conicity(amplitude, distance, radius).value(), 0.05, 1e-7);
    // Klingel 1883: L = 2 pi sqrt(e r / (2 gamma)).
    EXPECT_NEAR(cones.wave_length(amplitude, distance, radius).value(),
                2.0 * pi * std::sqrt(distance * radius / 0.1), 0.01);
  }
}

TEST(Conicity, OfACubicIsThatOfDuffingsOscillator) {
  // y'' + k y^3 = 0 has the period sqrt(pi / 2) Gamma(1/4) / (Gamma(3/4) (k/2)^(1/2) A) 2 / 2 ...
  // = 7.4162987 / (sqrt(k) A); its describing function is 3/4 k A^2.
  const double c = 2e-4;
  const auto cubic = difference([&](double y) { return c * y * y * y; });
  for (const double amplitude : {1.0, 4.0, 8.0}) {
    EXPECT_NEAR(cubic.harmonic_conicity(amplitude), 0.375 * c * amplitude * amplitude,
                1e-4 * c * amplitude * amplitude);
    const double period = 7.416298709205487 * std::sqrt(distance * radius / c) / amplitude;
    EXPECT_NEAR(cubic.wave_length(amplitude, distance, radius).value(), period, 2e-4 * period);
  }
}

TEST(Conicity, OfAStepIsThatOfTwoParabolas) {
  // A difference of d beyond 0: each half wave is a parabola, a quarter takes sqrt(2 A e r / d).
  const double d = 0.3;
  const auto step = difference([&](double) { return d; }, 0.001, 10000);
  const double amplitude = 5.0;
  EXPECT_NEAR(step.wave_length(amplitude, distance, radius).value(),
              4.0 * std::sqrt(2.0 * amplitude * distance * radius / d), 5.0);
  EXPECT_NEAR(step.harmonic_conicity(amplitude), 2.0 * d / (pi * amplitude), 1e-5);
}

TEST(Conicity, NoWaveWhereTheWheelsetDoesNotComeBack) {
  const auto outward = difference([](double y) { return 0.02 * y * (y - 4.0); });
  EXPECT_FALSE(outward.wave_length(3.0, distance, radius).has_value());
  EXPECT_LT(outward.harmonic_conicity(3.0), 0.0);
  EXPECT_TRUE(outward.wave_length(8.0, distance, radius).has_value());
}
