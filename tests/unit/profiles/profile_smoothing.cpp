// SPDX-License-Identifier: LGPL-2.1-or-later
// The smoothing spline: through points, near points with noise, and the remaining noise of the
// curvature.
#include "profiles/formula_profiles.hpp"
#include "profiles/smoothing_spline.hpp"

#include "support/test.hpp"

namespace rollfem::profiles {
namespace {

/// PointRow of a profile at equal distances, each moved across it by normally distributed noise.
PointRow measured(const ProfileCurve& curve, double spacing, double noise, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  PointRow points;
  for (double p = curve.first(); p <= curve.last(); p += spacing) {
    const ProfilePoint place = curve.at(p);
    const double off = noise * normal(generator);
    points.y.push_back(place.y - off * place.tangent_z);
    points.z.push_back(place.z + off * place.tangent_y);
  }
  return points;
}

struct Errors {
  double height = 0.0, slope = 0.0, curvature = 0.0;  ///< rms
};

Errors compare(const ProfileCurve& truth, const ProfileCurve& curve, double from, double to) {
  Errors sum;
  int count = 0;
  for (double y = from; y <= to; y += 0.1, ++count) {
    const ProfilePoint a = truth.at(truth.parameter_at(y));
    const ProfilePoint b = curve.at(curve.parameter_at(y));
    sum.height += std::pow(a.z - b.z, 2);
    sum.slope += std::pow(a.tangent_z - b.tangent_z, 2);
    sum.curvature += std::pow(a.curvature - b.curvature, 2);
  }
  return {std::sqrt(sum.height / count), std::sqrt(sum.slope / count),
          std::sqrt(sum.curvature / count)};
}

TEST(SmoothingSpline, WithoutToleranceGoesThroughThePoints) {
  const PointRow points = measured(find_built_in_profile("S1002")->make(), 0.5, 0.01, 1);
  const ProfileCurve curve = smoothing_spline(points, 0.0);
  for (std::size_t k = 0; k < points.y.size(); ++k) {
    const ProfilePoint place = curve.at(curve.knots()[k].parameter);
    EXPECT_NEAR(place.y, points.y[k], 1e-12);
    EXPECT_NEAR(place.z, points.z[k], 1e-12);
  }
}

TEST(SmoothingSpline, MeetsACircleAndItsCurvature) {
  PointRow points;
  const double radius = 20.0;
  for (double angle = -1.0; angle < 1.0; angle += 0.02) {
    points.y.push_back(radius * std::sin(angle));
    points.z.push_back(-radius * std::cos(angle));
  }
  const ProfileCurve curve = smoothing_spline(points, 0.0);
  // Away from the ends, where the natural spline has no curvature.
  for (double y = -8.0; y < 8.0; y += 0.37) {
    const ProfilePoint place = curve.at(curve.parameter_at(y));
    EXPECT_NEAR(std::hypot(place.y, place.z), radius, 1e-7);
    EXPECT_NEAR(place.curvature * radius, 1.0, 2e-4);
  }
}

/// What is taken out is the noise: also when it is stated up to three times too large.
TEST(SmoothingSpline, LeavesTheNoiseBetweenPointsAndCurve) {
  const PointRow points = measured(find_built_in_profile("60E1")->make(), 0.3, 0.01, 2);
  for (const double scatter : {0.01, 0.02, 0.03}) {
    SmoothingReport report;
    const ProfileCurve curve = smoothing_spline(points, scatter, &report);
    // 560 points: the rms of the noise itself is known to 3 %.
    EXPECT_NEAR(report.rms, 0.01, 6e-4);
    EXPECT_GT(report.largest, report.rms);
    double sum = 0.0;
    for (std::size_t k = 0; k < points.y.size(); ++k) {
      const ProfilePoint place = curve.at(curve.knots()[k].parameter);
      sum += std::pow(
          (points.z[k] - place.z) * place.tangent_y - (points.y[k] - place.y) * place.tangent_z, 2);
    }
    EXPECT_NEAR(std::sqrt(sum / static_cast<double>(points.y.size())), report.rms,
                1e-3 * report.rms);
  }
}

TEST(SmoothingSpline, DoesNotBendAStraightLine) {
  PointRow points;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> step(0.1, 0.5);
  for (double y = 0.0; y < 60.0; y += step(generator)) {
    points.y.push_back(y);
    points.z.push_back(0.4 * y - 3.0);
  }
  // The line is in the null space of the penalty: no rms distance is ever reached.
  EXPECT_THROW(smoothing_spline(points, 0.01), std::invalid_argument);
  const ProfileCurve curve = smoothing_spline(points, 0.0);
  for (double p = 0.0; p < 60.0; p += 0.7) EXPECT_NEAR(curve.at(p).curvature, 0.0, 1e-10);
}

TEST(SmoothingSpline, TellsTheScatterOfTheMeasurement) {
  for (const double noise : {0.003, 0.01, 0.03}) {
    const PointRow points = measured(find_built_in_profile("60E1")->make(), 0.3, noise, 4);
    SmoothingReport report;
    smoothing_spline(points, noise, &report);
    // The median of 500 dependent values: some 6 %; three of those.
    EXPECT_NEAR(report.scatter, noise, 0.18 * noise);
  }
}

/// What is left of noise of 0.01 mm on the running surfaces after smoothing by as much: through the
/// points, the curvature would be off by some 0.1 to 1 /mm.
TEST(SmoothingSpline, TakesNoiseOfAHundredthOutOfTheRunningSurfaces) {
  struct Surface {
    const char* name;
    double from, to;
    double height, slope, curvature;  ///< allowed, rms
  };
  for (const Surface& surface : {Surface{"S1002", -15.0, 25.0, 5e-3, 1.5e-3, 1.2e-3},
                                 Surface{"60E1", -9.0, 9.0, 7e-3, 2e-3, 1.5e-3}})
    for (const double spacing : {0.2, 0.5}) {
      const ProfileCurve truth = find_built_in_profile(surface.name)->make();
      Errors worst, through;
      for (unsigned seed = 0; seed < 5; ++seed) {
        const PointRow points = measured(truth, spacing, 0.01, seed);
        const ProfileCurve curve = smoothing_spline(points, 0.01);
        const Errors here = compare(truth, curve, surface.from, surface.to);
        worst.height = std::max(worst.height, here.height);
        worst.slope = std::max(worst.slope, here.slope);
        worst.curvature = std::max(worst.curvature, here.curvature);
        through = compare(truth, smoothing_spline(points, 0.0), surface.from, surface.to);
      }
      std::printf(
          "%s every %.1f mm: height %.2g mm, slope %.2g, curvature %.2g /mm (unsmoothed %.2g)\n",
          surface.name, spacing, worst.height, worst.slope, worst.curvature, through.curvature);
      EXPECT_LT(worst.height, surface.height);
      EXPECT_LT(worst.slope, surface.slope);
      EXPECT_LT(worst.curvature, surface.curvature);
      EXPECT_GT(through.curvature, 0.05);
    }
}

}  // namespace
}  // namespace rollfem::profiles
