// Files of profiles: every format read, every fault refused with one message that names the line
// and the key that mends it, and mended when told.
#include "contact/base/errors.hpp"
#include "meshes/profiles/built_in_profiles.hpp"
#include "meshes/profiles/profile_features.hpp"
#include "meshes/profiles/profiles.hpp"

#include <gtest/gtest.h>

#include "support/reference_folder.hpp"
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace rollfem::meshes {
namespace {

namespace fs = std::filesystem;
using contact::ProfileSource;

/// A folder with a case file's name in it, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "rollfem_profiles_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  std::string case_file() const { return (path_ / "case.toml").string(); }

 private:
  fs::path path_;
};

using Points = std::vector<std::array<double, 2>>;

Points points_of(const std::string& name, double spacing = 0.5) {
  const ProfileCurve curve = find_built_in_profile(name)->make();
  Points points;
  for (double p = curve.first(); p <= curve.last(); p += spacing) {
    const ProfilePoint place = curve.at(p);
    points.push_back({place.y, place.z});
  }
  return points;
}

std::string columns(const Points& points, const std::string& separator = " ", double unit = 1.0) {
  std::ostringstream text;
  text.precision(12);
  for (const auto& [y, z] : points) text << y / unit << separator << z / unit << '\n';
  return text.str();
}

ProfileCurve read(const std::string& text, bool wheel, ProfileSource source = {},
                  const std::string& name = "profile.txt") {
  const Folder folder;
  folder.write(name, text);
  source.name = name;
  return make_profile(source, wheel, folder.case_file());
}

std::string refusal(const std::string& text, bool wheel, ProfileSource source = {},
                    const std::string& name = "profile.txt") {
  try {
    read(text, wheel, std::move(source), name);
  } catch (const contact::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Largest distance in z between a curve and a built-in profile where that is not steep.
double off(const ProfileCurve& curve, const std::string& name) {
  const ProfileCurve truth = find_built_in_profile(name)->make();
  const bool wheel = find_built_in_profile(name)->wheel;
  double worst = 0.0;
  for (double y = wheel ? -35.0 : -30.0; y <= (wheel ? 55.0 : 30.0); y += 0.7)
    worst = std::max(
        worst, std::abs(curve.at(curve.parameter_at(y)).z - truth.at(truth.parameter_at(y)).z));
  return worst;
}

// A spline through points 0.5 mm apart, where the radius jumps from 13 to 80 mm.
constexpr double spline_tolerance = 5e-4;

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
  EXPECT_NE(message.find("profile.txt:1: has 3 numbers"), std::string::npos) << message;
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
  EXPECT_NE(refusal(text, false, {}, "wheel.prw").find("profile of a wheel"), std::string::npos);
  EXPECT_NE(refusal("1 2\n3 4\n", true, {}, "wheel.prw").find("point.begin"), std::string::npos);
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
  const std::string folder = rollfem::testing::reference_folder().string();
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
  EXPECT_NE(refusal(text.str(), false, source, "rail.ban").find("flip = true"), std::string::npos);
  source.flip = true;
  EXPECT_LT(off(read(text.str(), false, source, "rail.ban"), "60E1"), spline_tolerance);
}

struct Fault {
  const char* name;
  bool wheel;
  std::string text;
  std::vector<std::string> parts;            ///< of the message
  std::function<void(ProfileSource&)> mend;  ///< empty: cannot be mended
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.name;
}

std::string changed(const std::string& name, const std::function<void(Points&)>& change,
                    double unit = 1.0) {
  Points points = points_of(name);
  change(points);
  return columns(points, " ", unit);
}

std::vector<Fault> faults() {
  const auto same = [](Points&) {};
  return {
      {"Empty", true, "", {"is empty"}, {}},
      {"OnlyComments", true, "# nothing\n\n", {"is empty"}, {}},
      {"NoProfile", true, "Dear Sir,\nplease find\n", {"profile.txt:2:", "no number"}, {}},
      {"BadNumber", true, "1 2\n3 x4\n", {"profile.txt:2:", "`x4`"}, {}},
      {"OneColumn", false, "1\n2\n", {"profile.txt:1:", "two columns"}, {}},
      {"NotFinite", false, "1 2\n3 nan\n", {"profile.txt:2:", "`nan`"}, {}},
      {"TooFewPoints", false, "-20 2\n0 0\n20 2\n", {"has 3 points"}, {}},
      {"Binary", false, std::string("1 2\0 3", 6), {"binary"}, {}},
      {"Metres",
       true,
       changed("S1002", same, 1000.0),
       {"in m?", "unit = \"m\""},
       [](ProfileSource& s) { s.unit = contact::LengthUnit::m; }},
      {"Inches",
       false,
       changed("60E1", same, 25.4),
       {"inches", "unit = \"inch\""},
       [](ProfileSource& s) { s.unit = contact::LengthUnit::inch; }},
      {"MirroredWheel",
       true,
       changed("S1002",
               [](Points& p) {
                 for (auto& q : p) q[0] = -q[0];
               }),
       {"flange is on the wrong side", "mirror = true"},
       [](ProfileSource& s) { s.mirror = true; }},
      {"UpwardWheel",
       true,
       changed("S1002",
               [](Points& p) {
                 for (auto& q : p) q[1] = -q[1];
               }),
       {"upward", "flip = true"},
       [](ProfileSource& s) { s.flip = true; }},
      {"UpwardRail",
       false,
       changed("60E1",
               [](Points& p) {
                 for (auto& q : p) q[1] = -q[1];
               }),
       {"upward", "flip = true"},
       [](ProfileSource& s) { s.flip = true; }},
      {"ReversedWheel",
       true,
       changed("S1002", [](Points& p) { std::reverse(p.begin(), p.end()); }),
       {"profile.txt:1:", "large to small y", "reverse = true"},
       [](ProfileSource& s) { s.reverse = true; }},
      {"Unordered",
       false,
       changed("60E1",
               [](Points& p) {
                 for (std::size_t k = 3; k + 8 < p.size(); k += 9) std::swap(p[k], p[k + 6]);
               }),
       {"in no order", "sort = true"},
       [](ProfileSource& s) { s.sort = true; }},
      {"Duplicate",
       false,
       changed("60E1", [](Points& p) { p.insert(p.begin() + 100, p[100]); }),
       {"profile.txt:102:", "line 101", "drop_duplicates = true"},
       [](ProfileSource& s) { s.drop_duplicates = true; }},
      {"Zigzag",
       false,
       changed("60E1",
               [](Points& p) {
                 p.insert(p.begin() + 131, {p[128][0], p[128][1]});
               }),
       {"profile.txt:132:", "zig-zag", "drop_zigzag = true"},
       [](ProfileSource& s) { s.drop_zigzag = true; }},
      {"Gap",
       false,
       changed("60E1", [](Points& p) { p.erase(p.begin() + 125, p.begin() + 139); }),
       {"profile.txt:126:", "gap of 7.5", "longest_gap = 8"},
       [](ProfileSource& s) { s.longest_gap = 8.0; }},
      {"Kink",
       false,
       changed("60E1",
               [](Points& p) {
                 for (auto& q : p) q[1] += 0.5 * std::max(0.0, q[0] - 5.0);
               }),
       {"kink of 26", "rounding = 2.0", "largest_kink"},
       {}},
      {"Step",
       false,
       changed("60E1",
               [](Points& p) {
                 for (auto& q : p) q[1] += q[0] > 5.0 ? 0.1 : 0.0;
               }),
       {"step of 0.1 mm", "y = 4.8", "rounding = 2.0"},
       {}},
  };
}

class FaultyFile : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultyFile, IsRefusedWithOneMessageAndReadWhenMended) {
  const Fault& fault = GetParam();
  const std::string message = refusal(fault.text, fault.wheel);
  for (const std::string& part : fault.parts)
    EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
  EXPECT_NE(message.find("do: "), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  if (!fault.mend) return;
  ProfileSource source;
  fault.mend(source);
  EXPECT_LT(off(read(fault.text, fault.wheel, source), fault.wheel ? "S1002" : "60E1"), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Profile, FaultyFile, ::testing::ValuesIn(faults()),
                         [](const auto& test) { return std::string(test.param.name); });

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
ProfileCurve read_million(double noise, ProfileSource source, double& seconds) {
  const Folder folder;
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
  folder.write("many.txt", text);
  source.name = "many.txt";
  const auto begin = std::chrono::steady_clock::now();
  ProfileCurve curve = make_profile(source, true, folder.case_file());
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return curve;
}

/// Noise that makes kinks of 40 degrees at this spacing is none when it is stated; a step is.
TEST(ProfileFiles, StatedScatterIsNoKinkButAStepIs) {
  const Folder folder;
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
    folder.write("noisy.txt", text);
    ProfileSource source;
    source.name = "noisy.txt";
    EXPECT_THROW(make_profile(source, false, folder.case_file()), contact::InputError);
    source.smoothing = 0.01;
    if (step == 0.0)
      EXPECT_NO_THROW(make_profile(source, false, folder.case_file()));
    else
      EXPECT_THROW(make_profile(source, false, folder.case_file()), contact::InputError);
  }
}

TEST(ProfileFiles, AMillionPointsTakeLessThanTwoSeconds) {
  double seconds = 0.0;
  const ProfileCurve curve = read_million(0.0, {}, seconds);
  EXPECT_LT(seconds, 2.0);
  EXPECT_LT(off(curve, "S1002"), 1e-9);
}

TEST(ProfileFiles, AMillionNoisyPointsAreThinnedAndSmoothed) {
  double seconds = 0.0;
  ProfileSource source;
  source.smoothing = 0.01;
  EXPECT_THROW(read_million(0.01, source, seconds), contact::InputError);
  // Means of some 650 points each have noise of 0.01 / sqrt(650) mm.
  source.thinning = 0.1;
  source.smoothing = 4e-4;
  const ProfileCurve curve = read_million(0.01, source, seconds);
  EXPECT_LT(seconds, 2.0);
  EXPECT_LT(off(curve, "S1002"), 2e-3);
  const ProfileCurve truth = find_built_in_profile("S1002")->make();
  for (double y = -15.0; y < 25.0; y += 0.3)
    EXPECT_NEAR(curve.at(curve.parameter_at(y)).curvature,
                truth.at(truth.parameter_at(y)).curvature, 1e-3);
}

TEST(FormulaProfiles, ArcsMakeTheHeadOf60E1) {
  ProfileSource source;
  source.name = "arcs";
  source.radii = {300.0, 80.0, 13.0};
  source.ends = {10.228, 26.0265, 35.99};
  source.symmetric = true;
  EXPECT_LT(off(make_profile(source, false, "case.toml"), "60E1"), 1e-9);
  // The same written out, and as a wheel, whose convex side is the other one.
  source.symmetric = false;
  source.radii = {13.0, 80.0, 300.0, 80.0, 13.0};
  source.ends = {-35.99, -26.0265, -10.228, 10.228, 26.0265, 35.99};
  const ProfileCurve rail = make_profile(source, false, "case.toml");
  EXPECT_LT(off(rail, "60E1"), 1e-9);
  const ProfileCurve wheel = make_profile(source, true, "case.toml");
  EXPECT_NEAR(wheel.at(wheel.parameter_at(20.0)).z, -rail.at(rail.parameter_at(20.0)).z, 1e-12);
  EXPECT_NEAR(wheel.at(wheel.parameter_at(20.0)).curvature, -1.0 / 80.0, 1e-6);
}

TEST(FormulaProfiles, ConeIsAStraightArcWithASlope) {
  ProfileSource source;
  source.name = "arcs";
  source.radii = {contact::infinity};
  source.ends = {-30.0, 50.0};
  source.slope = -0.05;
  const ProfileCurve cone = make_profile(source, true, "case.toml");
  for (const double y : {-30.0, -7.0, 0.0, 50.0})
    EXPECT_NEAR(cone.at(cone.parameter_at(y)).z, -0.05 * y, 1e-12);
}

TEST(FormulaProfiles, PolynomialsAreTheirFormula) {
  ProfileSource source;
  source.name = "polynomial";
  // y^2 / 600 up to 12, then the tangent there.
  source.coefficients = {0.0, 0.0, 1.0 / 600.0, -144.0 / 600.0, 24.0 / 600.0, 0.0};
  source.limits = {-30.0, 12.0, 40.0};
  const ProfileCurve curve = make_profile(source, false, "case.toml");
  for (double y = -29.0; y < 40.0; y += 1.7) {
    const ProfilePoint place = curve.at(curve.parameter_at(y));
    const bool parabola = y < 12.0;
    EXPECT_NEAR(place.z, parabola ? y * y / 600.0 : (24.0 * y - 144.0) / 600.0, 1e-10);
    EXPECT_NEAR(place.curvature, parabola ? std::pow(1.0 + y * y / 9e4, -1.5) / 300.0 : 0.0, 1e-8);
  }
  source.coefficients[3] += 0.01;
  EXPECT_THROW(make_profile(source, false, "case.toml"), contact::InputError);
}

TEST(FormulaProfiles, WrongListsAreRefused) {
  ProfileSource source;
  source.name = "arcs";
  const auto refused = [&] {
    try {
      make_profile(source, false, "case.toml");
    } catch (const contact::InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("[rail_profile]"), std::string::npos) << message;
      return message.find("do: ") != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused());  // no radii
  source.radii = {300.0, 80.0};
  source.ends = {-10.0, 10.0};
  EXPECT_TRUE(refused());  // one end too few
  source.ends = {-10.0, 10.0, 5.0};
  EXPECT_TRUE(refused());  // not rising
  source.ends = {-10.0, 10.0, 95.0};
  EXPECT_TRUE(refused());  // beyond the vertical tangent
  source.ends = {-10.0, 10.0, 60.0};
  EXPECT_FALSE(refused());
  source.name = "polynomial";
  EXPECT_TRUE(refused());
}

TEST(Profiles, NamesThatAreNotKnownAndBodiesThatDoNotFitAreRefused) {
  ProfileSource source;
  for (const char* name : {"S1003", "no/such/file.txt", "60E1"}) {
    source.name = name;
    try {
      make_profile(source, true, "case.toml");
      ADD_FAILURE() << name;
    } catch (const contact::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("S1002"), std::string::npos) << error.what();
    }
  }
}

TEST(Profiles, RotationAndShiftAreAppliedInThisOrder) {
  ProfileSource source;
  source.name = "60E1";
  source.rotation = 0.025;
  source.shift = {3.0, -2.0};
  const ProfileCurve moved = make_profile(source, false, "case.toml");
  // The crown is at the shift, and its tangent rises by the rotation from y to z.
  const ProfilePoint crown = moved.at(moved.parameter_at(3.0));
  EXPECT_NEAR(crown.z, -2.0, 1e-9);
  EXPECT_NEAR(crown.tangent_z / crown.tangent_y, std::tan(0.025), 1e-9);
}

TEST(Profiles, ARadiusIsAnArc) {
  contact::Case input;
  input.wheel.transverse_radius = contact::infinity;
  input.rail.transverse_radius = 300.0;
  const ProfileCurve wheel = profile_of_case(input, true);
  const ProfileCurve rail = profile_of_case(input, false);
  EXPECT_EQ(wheel.at(wheel.parameter_at(20.0)).z, 0.0);
  EXPECT_NEAR(rail.at(rail.parameter_at(20.0)).z, 300.0 - std::sqrt(9e4 - 400.0), 1e-10);
}

}  // namespace
}  // namespace rollfem::meshes
