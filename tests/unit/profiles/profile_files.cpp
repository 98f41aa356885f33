// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of profiles: every format read, steps bridged and noise smoothed.
#include "base/errors.hpp"
#include "profiles/formula_profiles.hpp"
#include "profiles/profile_curve.hpp"
#include "profiles/profiles.hpp"

#include "support/profile_texts.hpp"
#include "support/reference_folder.hpp"

namespace rollfem::profiles {
namespace {

namespace fs = std::filesystem;

TEST(ProfileFiles, ReadColumnsWithAnySeparatorHeaderAndComments) {
  const Points points = points_of("60E1");
  for (const char* separator : {" ", "\t", ",", ";", " ; ", ", "})
    EXPECT_LT(off(read(columns(points, separator), false), "60E1"), spline_tolerance) << separator;
  EXPECT_LT(off(read("# measured\n% so\n! or so\ny,z\n\n" + columns(points, ","), false), "60E1"),
            spline_tolerance);
  std::string text = columns(points, ";");
  std::replace(text.begin(), text.end(), '.', ',');
  EXPECT_LT(off(read("y [mm]; z [mm]\r\n" + text, false), "60E1"), spline_tolerance);
}

TEST(ProfileFiles, ReadNamedColumns) {
  std::ostringstream text;
  text.precision(12);
  text << "s [mm],z [mm],y [mm]\n";
  for (const auto& [y, z] : points_of("60E1")) text << "0.0," << z << ',' << y << '\n';
  EXPECT_LT(off(read(text.str(), false), "60E1"), spline_tolerance);
  const std::string message = refusal("1 2 3\n4 5 6\n", false);
  EXPECT_TRUE(says(message, "profile.txt:1: has 3 numbers"));
}

/// As SIMPACK writes it, with lengths in m, mirrored, turned upside down and shifted.
TEST(ProfileFiles, ReadSimpackWithWhatItsHeaderSays) {
  Points points = points_of("S1002");
  for (auto& [y, z] : points) {
    y = -1e-3 * y - 0.25;  // shift.y = 0.25 brings it back
    z = -1e-3 * z + 0.125;
  }
  const std::string header =
      "! comment\nheader.begin\n  version = 1\n  type = 1 ! wheel\nheader.end\nspline.begin\n"
      "  approx.smooth = 0.0\n  comment = 'none'\n  shift.y = 0.25\n  shift.z = -0.125\n"
      "  mirror.y = 1 ! yes\n  mirror.z = 1\n  inversion = 1\n!  units.len = 'm'\n"
      "  units.len.f = +1.0E+00\n  point.begin\n! y z weight\n";
  const std::string text = header + columns(points) + "  point.end\nspline.end\n";
  EXPECT_LT(off(read(text, true, {}, "wheel.prw"), "S1002"), spline_tolerance);
  EXPECT_TRUE(says(refusal(text, false, {}, "wheel.prw"), "profile of a wheel"));
  EXPECT_TRUE(says(refusal("1 2\n3 4\n", true, {}, "wheel.prw"), "point.begin"));
}

TEST(ProfileFiles, SimpackRotationIsFromYToZ) {
  // A rail turned by -1/40 in the file, which `rotate` turns back; angles in degrees.
  const double angle = std::atan(1.0 / 40.0);
  Points points;
  for (const auto& [y, z] : points_of("60E1"))
    points.push_back(
        {std::cos(angle) * y + std::sin(angle) * z, -std::sin(angle) * y + std::cos(angle) * z});
  std::ostringstream header;
  header.precision(15);
  header << "header.begin\ntype = 0\nheader.end\nspline.begin\nunits.len.f = 1000\n"
         << "units.ang.f = 57.29577951308232\nrotate = " << angle * 57.29577951308232
         << "\npoint.begin\n";
  EXPECT_LT(
      off(read(header.str() + columns(points) + "point.end\nspline.end\n", false, {}, "rail.prr"),
          "60E1"),
      spline_tolerance);
}

TEST(ProfileFiles, ReadTheBenchmarksListsWhereTheyAreAtHand) {
  const std::string folder = reference_folder().string();
  if (!fs::exists(folder + "/MBench_S1002_v3.prw")) GTEST_SKIP() << "the files are not here";
  ProfileSource source;
  source.name = "MBench_S1002_v3.prw";
  ProfileReport report;
  const ProfileCurve curve = make_profile(source, true, folder + "/case.toml", &report);
  EXPECT_EQ(report.points, 399u);
  EXPECT_LT(off(curve, "S1002"), 1e-4);
  source.name = "MBench_UIC60_v3.prr";
  // Its sides end in points that lie a thousandth of a millimetre from each other.
  EXPECT_NEAR(make_profile(source, false, folder + "/case.toml", &report).at(60.0).curvature,
              1.0 / 80.0, 1.0);
  EXPECT_GT(report.points, 450u);
}

TEST(ProfileFiles, ReadMiniprofWithColumnsInAnyOrder) {
  std::ostringstream text;
  text.precision(12);
  text << "ProgramName=MiniProf\nDate=01-02-2020\nColumnDef=Y,X,A,C\nElevation=0\n\n";
  for (const auto& [y, z] : points_of("60E1")) text << -z << ' ' << y << " 0.1 0.2\n";
  ProfileSource source;
  EXPECT_TRUE(says(refusal(text.str(), false, source, "rail.ban"), "flip = true"));
  source.flip = true;
  EXPECT_LT(off(read(text.str(), false, source, "rail.ban"), "60E1"), spline_tolerance);
}

TEST(ProfileFiles, RoundingBridgesAStepWithinTheStatedLength) {
  const std::string text = changed("60E1", [](Points& p) {
    for (auto& q : p) q[1] += q[0] > 5.0 ? 0.1 : 0.0;
  });
  ProfileSource source;
  source.rounding = 3.0;
  const ProfileCurve curve = read(text, false, source);
  const ProfileCurve truth = find_built_in_profile("60E1")->make();
  for (const double y : {-20.0, 0.0, 1.0, 9.0, 20.0}) {
    const double step = y > 5.0 ? 0.1 : 0.0;
    EXPECT_NEAR(curve.at(curve.parameter_at(y)).z, truth.at(truth.parameter_at(y)).z + step, 1e-3);
  }
  // A cubic over 6 mm that rises by 0.1 mm bends by 6 * 0.1 / 36 at its ends.
  for (double y = 1.0; y < 9.0; y += 0.1)
    EXPECT_LT(std::abs(curve.at(curve.parameter_at(y)).curvature), 2.0 * 6.0 * 0.1 / 36.0);
}

/// A file of a million points of S1002, with normal noise (mm) along z; returns its curve.
ProfileCurve read_million(double noise, ProfileSource source) {
  const TemporaryFolder folder;
  const ProfileCurve truth = find_built_in_profile("S1002")->make();
  constexpr int count = 1000000;
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::string text;
  text.reserve(36u * count);
  char line[64];
  for (int k = 0; k < count; ++k) {
    const ProfilePoint place =
        truth.at(truth.first() + (truth.last() - truth.first()) * k / (count - 1));
    text.append(line,
                static_cast<std::size_t>(std::snprintf(line, sizeof line, "%.12f %.12f\n", place.y,
                                                       place.z + noise * normal(generator))));
  }
  folder.file("many.txt", text);
  source.name = "many.txt";
  return make_profile(source, true, folder.path("case.toml"));
}

/// Noise that makes kinks of 40 degrees at this spacing is none when it is stated; a step is.
TEST(ProfileFiles, StatedScatterIsNoKinkButAStepIs) {
  const TemporaryFolder folder;
  const ProfileCurve truth = find_built_in_profile("60E1")->make();
  for (const double step : {0.0, 0.4}) {
    std::mt19937 generator(5);
    std::normal_distribution<double> normal(0.0, 0.01);
    std::string text;
    for (double p = truth.first(); p < truth.last(); p += 0.1) {
      const ProfilePoint place = truth.at(p);
      const double off = normal(generator) + (place.y > 5.0 ? step : 0.0);
      text += std::to_string(place.y - off * place.tangent_z) + ' ' +
              std::to_string(place.z + off * place.tangent_y) + '\n';
    }
    folder.file("noisy.txt", text);
    ProfileSource source;
    source.name = "noisy.txt";
    EXPECT_THROW(make_profile(source, false, folder.path("case.toml")), contact::InputError);
    source.smoothing = 0.01;
    if (step == 0.0)
      EXPECT_NO_THROW(make_profile(source, false, folder.path("case.toml")));
    else
      EXPECT_THROW(make_profile(source, false, folder.path("case.toml")), contact::InputError);
  }
}

TEST(ProfileFiles, AMillionPointsAreKeptExactly) {
  EXPECT_LT(off(read_million(0.0, {}), "S1002"), 1e-9);
}

TEST(ProfileFiles, AMillionNoisyPointsAreThinnedAndSmoothed) {
  ProfileSource source;
  source.smoothing = 0.01;
  EXPECT_THROW(read_million(0.01, source), contact::InputError);
  // Means of some 650 points each have noise of 0.01 / sqrt(650) mm.
  source.thinning = 0.1;
  source.smoothing = 4e-4;
  const ProfileCurve curve = read_million(0.01, source);
  EXPECT_LT(off(curve, "S1002"), 2e-3);
  const ProfileCurve truth = find_built_in_profile("S1002")->make();
  for (double y = -15.0; y < 25.0; y += 0.3)
    EXPECT_NEAR(curve.at(curve.parameter_at(y)).curvature,
                truth.at(truth.parameter_at(y)).curvature, 1e-3);
}

}  // namespace
}  // namespace rollfem::profiles
