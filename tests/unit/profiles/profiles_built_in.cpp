// SPDX-License-Identifier: LGPL-2.1-or-later
// The built-in profiles against their formulas, against points of the Manchester benchmark's lists
// and, where those files are at hand, against all of them.
#include "profiles/formula_profiles.hpp"
#include "profiles/profiles.hpp"

#include "support/reference_folder.hpp"

namespace rollfem::profiles {
namespace {

using PointList = std::vector<std::array<double, 2>>;

ProfileCurve built_in(const std::string& name) {
  return find_built_in_profile(name)->make();
}

double height_at(const ProfileCurve& curve, double y) {
  return curve.at(curve.parameter_at(y)).z;
}

/// Distance of a point from the curve, by minimising over the parameter near the nearest knot.
double distance_to(const ProfileCurve& curve, double y, double z) {
  const auto distance = [&](double p) {
    const ProfilePoint point = curve.at(p);
    return std::hypot(point.y - y, point.z - z);
  };
  const auto& knots = curve.knots().parameter;
  std::size_t best = 0;
  for (std::size_t k = 1; k < knots.size(); ++k)
    if (distance(knots[k]) < distance(knots[best])) best = k;
  double low = knots[best > 0 ? best - 1 : 0];
  double high = knots[std::min(best + 1, knots.size() - 1)];
  for (int step = 0; step < 100; ++step) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
  }
  return distance(0.5 * (low + high));
}

/// Points of one of the benchmark's files as listed; empty when the files are not here.
PointList reference_points(const std::string& file) {
  std::ifstream in(reference_folder() / file);
  PointList points;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find("point.end") != std::string::npos) inside = false;
    const std::size_t first = line.find_first_not_of(" \t");
    std::istringstream fields(line);
    std::array<double, 2> point{};
    if (inside && first != std::string::npos && line[first] != '!' &&
        fields >> point[0] >> point[1])
      points.push_back(point);
    if (line.find("point.begin") != std::string::npos) inside = true;
  }
  return points;
}

// The list prints eight digits; where the flank rises with 70 degrees, half a last digit of y is
// 1.4e-6 mm of z.
constexpr double list_tolerance_wheel = 2e-6;
constexpr double list_tolerance_rail = 5e-5;

TEST(BuiltInProfile, MirroredHasEveryHeightAndTheOppositeSlopeOnTheOtherSide) {
  for (const char* name : {"S1002", "60E1", "60E2", "54E1", "56E1"}) {
    SCOPED_TRACE(name);
    const bool wheel = std::string(name) == "S1002";
    contact::ProfileSource source;
    source.name = name;
    const ProfileCurve curve = make_profile(source, wheel, "");
    source.mirror = true;
    const ProfileCurve image = make_profile(source, wheel, "");
    const double lower = curve.at(curve.first()).y, upper = curve.at(curve.last()).y;
    EXPECT_NEAR(image.at(image.first()).y, -upper, 1e-12);
    EXPECT_NEAR(image.at(image.last()).y, -lower, 1e-12);
    for (const double y : {-25.0, -3.0, 0.5, 11.0, 30.0}) {
      const ProfilePoint there = curve.at(curve.parameter_at(y));
      const ProfilePoint here = image.at(image.parameter_at(-y));
      EXPECT_NEAR(here.z, there.z, 1e-9) << y;
      EXPECT_NEAR(here.tangent_z / here.tangent_y, -there.tangent_z / there.tangent_y, 1e-9) << y;
    }
  }
}

TEST(BuiltInProfiles, S1002MeetsPointsOfTheManchesterList) {
  // MBench_S1002_v3.prw, y mirrored as its header says.
  const PointList points{{-69.612628, 13.485642},
                         {-69.225256, 15.101756},
                         {-66.126280, 21.511624},
                         {-62.639932, 25.253725},
                         {-57.604097, 27.714038}};
  const ProfileCurve curve = built_in("S1002");
  for (const auto& [y, z] : points) EXPECT_NEAR(height_at(curve, y), z, list_tolerance_wheel);
}

TEST(BuiltInProfiles, S1002MeetsAllPointsOfTheManchesterList) {
  const PointList points = reference_points("MBench_S1002_v3.prw");
  if (points.empty()) GTEST_SKIP() << "the benchmark's files are not here";
  ASSERT_EQ(points.size(), 399u);
  const ProfileCurve curve = built_in("S1002");
  const ProfileCurve smooth = built_in("S1002-smooth");
  double worst = 0.0;
  double worst_smooth_beside = 0.0;
  double worst_smooth_in_c = 0.0;
  for (const auto& [mirrored_y, z] : points) {
    const double y = -mirrored_y;
    worst = std::max(worst, std::abs(height_at(curve, y) - z));
    double& of_zone = y > -35.0 && y < -26.0 ? worst_smooth_in_c : worst_smooth_beside;
    of_zone = std::max(of_zone, std::abs(height_at(smooth, y) - z));
  }
  RecordProperty("worst", std::to_string(worst * 1e6));
  std::printf("S1002: %.3g mm; S1002-smooth: %.3g mm in zone C, %.3g mm elsewhere\n", worst,
              worst_smooth_in_c, worst_smooth_beside);
  EXPECT_LT(worst, list_tolerance_wheel);
  EXPECT_LT(worst_smooth_beside, list_tolerance_wheel);
  EXPECT_LT(worst_smooth_in_c, 1.3e-4);
}

TEST(BuiltInProfiles, RailOfTheBenchmarkMeetsItsList) {
  const PointList points = reference_points("MBench_UIC60_v3.prr");
  if (points.empty()) GTEST_SKIP() << "the benchmark's files are not here";
  // In the list the rail is inclined 1:40, its crown at (-7.49170, 0.09371).
  const ProfileCurve curve =
      built_in("UIC60-manchester").moved(-std::atan(1.0 / 40.0), -7.49170, 0.09371);
  double worst = 0.0;
  int compared = 0;
  for (const auto& [y, z] : points) {
    if (z >= 37.4) continue;
    worst = std::max(worst, distance_to(curve, y, z));
    ++compared;
  }
  std::printf("UIC60-manchester: %.3g mm at %d points\n", worst, compared);
  EXPECT_GE(compared, 450);
  EXPECT_LT(worst, list_tolerance_rail);
}

TEST(BuiltInProfiles, CurvatureOfS1002IsThatOfItsFormulas) {
  const ProfileCurve smooth = built_in("S1002-smooth");
  const ProfileCurve plain = built_in("S1002");
  const auto curvature = [](double y) {  // of the polynomials of zones B and C
    const double h = 0.02;
    const double second =
        (s1002_height(y + h) - 2.0 * s1002_height(y) + s1002_height(y - h)) / (h * h);
    const double first = (s1002_height(y + h) - s1002_height(y - h)) / (2.0 * h);
    return second / std::pow(1.0 + first * first, 1.5);
  };
  double worst = 0.0, worst_smooth = 0.0, blended = 0.0, blended_tread = 0.0;
  for (double y = -34.97; y < 32.1; y += 0.0137) {
    if (std::abs(y + 26.0) < 0.021) continue;
    const double true_value = curvature(y);
    const double off = std::abs(plain.at(plain.parameter_at(y)).curvature - true_value);
    const double off_smooth = std::abs(smooth.at(smooth.parameter_at(y)).curvature - true_value);
    worst_smooth = std::max(worst_smooth, off_smooth);
    if (y < -34.9)
      blended = std::max(blended, off / true_value);
    else if (std::abs(y + 26.05) < 0.2)
      blended_tread = std::max(blended_tread, off / true_value);
    else
      worst = std::max(worst, off);
  }
  std::printf("off: %.2g /mm outside, smooth %.2g /mm, blends %.2g %.2g relative\n", worst,
              worst_smooth, blended, blended_tread);
  EXPECT_LT(worst, 2e-6);
  EXPECT_LT(worst_smooth, 2e-5);
  EXPECT_LT(blended, 0.1);
}

}  // namespace
}  // namespace rollfem::profiles
