// SPDX-License-Identifier: LGPL-2.1-or-later
// The frame of a patch: heights of curves through knots, and the wheel as a surface of revolution
// about an axle that is tilted and turned against the patch.
#include "scene/patch_geometry.hpp"

#include "scene/geometry.hpp"

#include "support/test.hpp"

namespace {

/// z = c (y - y0)^3 + y: cubics are their own Hermite pieces.
HeightCurve cubic(double c, double y0) {
  std::vector<HeightKnot> knots;
  for (double at = -3.0; at < 3.1; at += 0.75)
    knots.push_back({at, c * std::pow(at - y0, 3) + at, 3.0 * c * std::pow(at - y0, 2) + 1.0});
  return HeightCurve(knots);
}

/// A rail that is flat across.
HeightCurve level(double half_width) {
  return HeightCurve({{-half_width, 0.0, 0.0}, {half_width, 0.0, 0.0}});
}

}  // namespace

TEST(HeightCurve, GivesCubicsAndTheirDerivativesExactly) {
  const HeightCurve curve = cubic(0.3, 0.4);
  for (const double y : {-3.0, -2.9, -1.01, 0.0, 1.3, 3.0}) {
    const CurveValue at = curve.at(y);
    EXPECT_NEAR(at.value, 0.3 * std::pow(y - 0.4, 3) + y, 1e-13);
    EXPECT_NEAR(at.slope, 0.9 * std::pow(y - 0.4, 2) + 1.0, 1e-12);
    EXPECT_NEAR(at.second, 1.8 * (y - 0.4), 1e-11);
  }
}

TEST(HeightCurve, TakesThePieceOfAPlaceHoweverUnevenlyItsKnotsLie) {
  // Three knots in a thousandth, a long piece, forty that crowd towards the end.
  std::vector<double> y{-40.0, -39.9995, -39.999}, z, slope;
  for (int k = 0; k < 40; ++k) y.push_back(10.0 - 45.0 * std::pow(0.7, k));
  for (std::size_t k = 0; k < y.size(); ++k) {
    z.push_back(std::sin(7.0 * static_cast<double>(k)));
    slope.push_back(std::cos(5.0 * static_cast<double>(k)));
  }
  std::vector<HeightKnot> knots;
  for (std::size_t k = 0; k < y.size(); ++k) knots.push_back({y[k], z[k], slope[k]});
  const HeightCurve curve(knots);
  const auto hermite = [&](std::size_t k, double t) {
    const double h = y[k + 1] - y[k];
    return (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) * z[k] +
           t * (1.0 - t) * (1.0 - t) * h * slope[k] + t * t * (3.0 - 2.0 * t) * z[k + 1] -
           t * t * (1.0 - t) * h * slope[k + 1];
  };
  for (std::size_t k = 0; k + 1 < y.size(); ++k) {
    EXPECT_EQ(curve.at(y[k]).value, z[k]) << k;
    for (const double t : {0.001, 0.3, 0.999}) {
      const double at = y[k] + t * (y[k + 1] - y[k]);
      const double part = (at - y[k]) / (y[k + 1] - y[k]);
      EXPECT_NEAR(curve.at(at).value, hermite(k, part), 1e-12 * (1.0 + y[k + 1] - y[k])) << k;
    }
    const double before = std::nextafter(y[k + 1], y[k]);
    EXPECT_NEAR(curve.at(before).value, z[k + 1], 1e-12) << k;
  }
}

TEST(HeightCurve, GoesOnAlongItsTangents) {
  const HeightCurve curve = cubic(0.3, 0.4);
  const CurveValue end = curve.at(curve.last());
  EXPECT_NEAR(curve.at(curve.last() + 2.0).value, end.value + 2.0 * end.slope, 1e-13);
  EXPECT_FALSE(curve.contains(curve.last() + 1e-9));
}

TEST(HeightCurve, MeanOfACubicIsItsIntegral) {
  const HeightCurve curve = cubic(0.3, 0.4);
  const auto integral = [](double y) { return 0.075 * std::pow(y - 0.4, 4) + 0.5 * y * y; };
  for (const auto& [from, to] : {std::pair{-2.9, 2.7}, {0.1, 0.2}, {-0.75, 0.75}, {-3.0, 3.0}})
    EXPECT_NEAR(curve.mean(from, to), (integral(to) - integral(from)) / (to - from), 1e-13);
  // Beyond the last knot the tangent goes on.
  const CurveValue end = curve.at(curve.last());
  EXPECT_NEAR(curve.mean(curve.last(), curve.last() + 2.0), end.value + end.slope, 1e-13);
}

TEST(HeightCurve, AveragingLeavesCubicsAlone) {
  const HeightCurve curve = cubic(0.3, 0.4);
  for (const double y : {-1.5, 0.0, 0.4, 1.2})
    EXPECT_NEAR(curve.averaging(y, 0.9), 0.0, 1e-13) << y;
}

/// Heights taken at one place of each element would be those of another, longer wave.
TEST(HeightCurve, AveragingOverAWaveLeavesItsMeanWhereverItIsTaken) {
  constexpr double length = 0.4, amplitude = 0.01;
  std::vector<HeightKnot> knots;
  for (int k = 0; k <= 1600; ++k) {
    const double y = -4.0 + 0.005 * k, phase = 2.0 * M_PI * y / length;
    knots.push_back(
        {y, amplitude * std::cos(phase), -amplitude * 2.0 * M_PI / length * std::sin(phase)});
  }
  const HeightCurve curve(knots);
  for (const double at : {-1.0, -0.93, 0.0, 0.1, 0.17, 2.05})
    EXPECT_NEAR(curve.at(at).value + curve.averaging(at, length), 0.0, 1e-6 * amplitude) << at;
}

TEST(HeightCurve, RefusesKnotsThatDoNotRise) {
  EXPECT_THROW(HeightCurve(std::vector<HeightKnot>(2)), std::invalid_argument);
  EXPECT_THROW(HeightCurve(std::vector<HeightKnot>(1)), std::invalid_argument);
}

TEST(PatchGeometry, ConeUnderATiltedAxleIsFlatAcross) {
  // A cone of half angle a about an axle that is tilted by a touches a plane along a line.
  const double angle = 0.3, radius = 400.0;
  const double slope = std::tan(angle);
  const HeightCurve wheel(
      {{-80.0, radius + 80.0 * slope, -slope}, {80.0, radius - 80.0 * slope, -slope}});
  const Axle axle{{0.0, radius * std::sin(angle), radius * std::cos(angle)},
                  {0.0, std::cos(angle), -std::sin(angle)}};
  const PatchGeometry patch(level(50.0), wheel, axle, -20.0, 20.0);
  for (const double y : {-15.0, 0.0, 15.0}) {
    EXPECT_NEAR(patch.distance(0.0, y), 0.0, 1e-10);
    // Normal curvature of a cone across its generator: cos(a) / radius there.
    const double local = patch.local_rolling_radius(y) / std::cos(angle);
    EXPECT_NEAR(patch.distance(0.1, y), 0.005 / local, 1e-9);
  }
}

/// Of both bodies, under a yaw of 5 mrad that moves the wheel's waves by a twentieth of their
/// length.
TEST(UndeformedDistance, OfWavesAsShortAsTheElementsIsThatOfTheirMean) {
  constexpr double length = 0.6, amplitude = 0.002, radius = 460.0;
  const auto curve = [&](double height, double of_wave) {
    std::vector<HeightKnot> knots;
    for (int k = 0; k <= 8000; ++k) {
      const double y = -10.0 + 0.0025 * k, number = 2.0 * M_PI / length;
      knots.push_back(
          {y, height + of_wave * std::cos(number * y), -of_wave * number * std::sin(number * y)});
    }
    return HeightCurve(knots);
  };
  const Axle axle{{0.0, 0.0, radius}, {std::sin(0.005), std::cos(0.005), 0.0}};
  const auto distance = [&](double of_rail, double of_wheel,
                            const rollfem::contact::ContactGrid& grid) {
    rollfem::contact::Geometry geometry;
    geometry.surface = rollfem::contact::ContactSurface::of(std::make_shared<PatchGeometry>(
        curve(0.0, of_rail), curve(radius, of_wheel), axle, -8.0, 8.0));
    return rollfem::contact::ChartedGeometry(geometry, rollfem::contact::Chart::plane)
        .undeformed_distance(grid);
  };
  for (const double middle : {0.0, 0.07, 0.1}) {
    const auto grid = rollfem::contact::ContactGrid::centred(5, 9, 3.0, length, 0.0, middle);
    const rollfem::contact::Field waves = distance(amplitude, -0.7 * amplitude, grid);
    const rollfem::contact::Field smooth = distance(0.0, 0.0, grid);
    EXPECT_LT((waves - smooth).cwiseAbs().maxCoeff(), 2e-3 * amplitude) << middle;
  }
}

TEST(PatchGeometry, UnderLoadIsThatOfAWheelWhoseAxleHasMoved) {
  // A wheel with a wavy tread that sinks by 0.1 mm along z and moves as much as a vertical 0.3 rad
  // beside z says; distances are counted from first touch.
  std::vector<HeightKnot> wavy;
  for (double at = -20.0; at < 20.05; at += 0.1)
    wavy.push_back({at, 400.0 + 0.2 * std::sin(0.4 * at), 0.08 * std::cos(0.4 * at)});
  const HeightCurve rail = level(20.0), wheel(wavy);
  constexpr double approach = 0.1, angle = 0.3;
  const std::array<double, 2> up{std::sin(angle), std::cos(angle)};
  const auto placed = [&](double y, double z) {
    return PatchGeometry(rail, wheel, Axle{{0.0, y, 400.0 + z}, {0.0, 1.0, 0.0}}, -15.0, 15.0);
  };
  const PatchGeometry touching = placed(0.0, 0.0);
  const PatchGeometry moved = placed(-approach * std::tan(angle), -approach);
  const PatchGeometry loaded = touching.under_load(approach, up, {0.0, 1.0});
  double largest = 0.0;
  for (const double x : {-3.0, 0.0, 2.0})
    for (double y = -10.0; y < 10.5; y += 0.7) {
      EXPECT_NEAR(loaded.distance(x, y), moved.distance(x, y) + approach, 1e-9);
      largest = std::max(largest, std::abs(loaded.distance(x, y) - touching.distance(x, y)));
    }
  EXPECT_NEAR(largest, approach * std::tan(angle) * 0.08, 1e-4);
  EXPECT_EQ(loaded.under_load(0.0, up, up).distance(1.0, 2.0), touching.distance(1.0, 2.0));
}
