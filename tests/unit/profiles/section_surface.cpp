// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections joined along the way: what is exact, the order of the rest, features, lists in files.
#include "base/errors.hpp"
#include "base/pi.hpp"
#include "profiles/section_list.hpp"

#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"

namespace {

using profiles::PlacedSection;
using profiles::SectionSpline;
using profiles::SectionSurface;
using profiles::SurfaceHeight;

/// z = height(u, y) with its slope by y, at these positions.
SectionSurface surface_of(const std::function<double(double, double)>& height,
                          const std::function<double(double, double)>& slope,
                          const std::vector<double>& positions,
                          SectionSpline spline = SectionSpline::through, double turn = 0.0) {
  std::vector<PlacedSection> sections;
  for (const double u : positions)
    sections.push_back({u,
                        profile_of([&, u](double y) { return height(u, y); },
                                   [&, u](double y) { return slope(u, y); }, -30.0, 30.0),
                        {}});
  return SectionSurface(std::move(sections), spline, turn);
}

std::vector<double> steps(double first, double step, int count) {
  std::vector<double> result;
  for (int k = 0; k < count; ++k) result.push_back(first + k * step);
  return result;
}

SurfaceHeight height_at(const SectionSurface& surface, double way, double y) {
  SurfaceHeight found;
  EXPECT_TRUE(surface.height(way, y, 0.0, found)) << way << " " << y;
  return found;
}

TEST(SectionSurface, LinearChangesAreExactWithAnySteps) {
  const auto height = [](double u, double y) { return 0.01 * y * y + 0.1 * u * (1.0 + 0.02 * y); };
  const auto slope = [](double u, double y) { return 0.02 * y + 0.002 * u; };
  for (const SectionSpline spline : {SectionSpline::through, SectionSpline::smooth}) {
    const SectionSurface surface = surface_of(height, slope, {-10.0, -4.0, 1.0, 2.0, 11.0}, spline);
    for (const double u : {-9.0, -3.3, 1.7, 6.0, 10.9})
      for (const double y : {-22.3, 0.0, 7.7}) {
        const SurfaceHeight found = height_at(surface, u, y);
        EXPECT_NEAR(found.z, height(u, y), 1e-12);
        EXPECT_NEAR(found.by_way, 0.1 * (1.0 + 0.02 * y), 1e-12);
        EXPECT_NEAR(found.by_y, slope(u, y), 1e-12);
      }
  }
}

TEST(SectionSurface, NothingChangesBeyondTheLastSection) {
  const SectionSurface surface = surface_of([](double u, double) { return 0.1 * u; },
                                            [](double, double) { return 0.0; }, {0.0, 5.0, 10.0});
  EXPECT_NEAR(height_at(surface, 40.0, 1.0).z, 1.0, 1e-12);
  EXPECT_EQ(height_at(surface, 40.0, 1.0).by_way, 0.0);
}

TEST(SectionSurface, SplinesAreOfFourthOrderInsideAndTwiceDifferentiable) {
  const auto height = [](double u, double) { return std::sin(0.3 * u); };
  const auto slope = [](double, double) { return 0.0; };
  std::vector<double> errors;
  for (const int pieces : {20, 40}) {
    const SectionSurface surface =
        surface_of(height, slope, steps(-20.0, 40.0 / pieces, pieces + 1));
    double error = 0.0;
    for (double u = -8.0; u < 8.0; u += 0.13)
      error = std::max(error, std::abs(height_at(surface, u, 0.0).z - height(u, 0.0)));
    errors.push_back(error);
    const auto bend = [&](double u) {
      constexpr double h = 1e-4;
      return (height_at(surface, u + h, 0.0).by_way - height_at(surface, u - h, 0.0).by_way) /
             (2.0 * h);
    };
    EXPECT_NEAR(bend(4.0 - 2e-4), bend(4.0 + 2e-4), 1e-4);  // at a section
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 3.5);
}

TEST(SectionSurface, RepeatsAfterAFullTurn) {
  const double turn = 2.0 * contact::pi;
  const SectionSurface surface = surface_of(
      [](double u, double) { return std::cos(6.0 * u); }, [](double, double) { return 0.0; },
      steps(0.0, turn / 180.0, 181), SectionSpline::through, turn);
  for (const double u : {-0.02, 0.01, 1.3, 6.27, 6.29, 13.0}) {
    EXPECT_NEAR(height_at(surface, u, 0.0).z, std::cos(6.0 * u), 1e-5);
    EXPECT_NEAR(height_at(surface, u, 0.0).by_way, -6.0 * std::sin(6.0 * u), 2e-3);
  }
}

TEST(SectionSurface, FeaturesLeadTheirPartsSideways) {
  // A joint of the curvature at y = 0.1 u: with the feature it stays sharp between the sections.
  const auto bent = [](double way, double y) { return std::pow(std::max(0.0, y - 0.1 * way), 2); };
  std::vector<PlacedSection> sections;
  for (const double u : {0.0, 20.0, 40.0}) {
    std::vector<profiles::ProfileKnot> knots;
    for (const double y : {-30.0, 0.1 * u, 30.0})
      knots.push_back({y, y, bent(u, y), 1.0, 2.0 * std::max(0.0, y - 0.1 * u)});
    sections.push_back({u, profiles::ProfileCurve(knots), {0.1 * u}});
  }
  const SectionSurface surface(sections, SectionSpline::through);
  for (const double y : {-5.0, 0.9, 1.1, 2.0})
    EXPECT_NEAR(height_at(surface, 20.0, y).z, bent(20.0, y), 1e-11) << y;
  EXPECT_NEAR(height_at(surface, 10.0, 0.5).z, 0.0, 1e-11);
}

TEST(SectionSurface, TurnsAndShiftsAsItsSections) {
  const SectionSurface surface =
      surface_of([](double u, double y) { return 0.01 * y * y + 0.02 * u; },
                 [](double, double y) { return 0.02 * y; }, {0.0, 10.0, 20.0});
  const SectionSurface moved = surface.moved(0.1, 3.0, -2.0);
  const profiles::ProfileCurve a = surface.section(7.0).moved(0.1, 3.0, -2.0),
                               b = moved.section(7.0);
  for (const double parameter : {-20.0, 1.3, 25.0}) {
    EXPECT_NEAR(a.at(parameter).y, b.at(parameter).y, 1e-12);
    EXPECT_NEAR(a.at(parameter).z, b.at(parameter).z, 1e-12);
  }
}

/// Sections written as files of two columns.
class SectionList : public ::testing::Test {
 protected:
  SectionList() {
    for (const int k : {1, 2, 3}) {
      std::string rows;
      for (double y = -36.0; y <= 36.0; y += 0.5)
        rows += std::to_string(y) + " " + std::to_string(300.0 - std::sqrt(9e4 - y * y) - 0.5 * k) +
                "\n";
      folder_.file("sections/" + std::to_string(k) + ".txt", rows);
    }
  }
  std::shared_ptr<const SectionSurface> read(const std::string& name, const std::string& text,
                                             bool wheel = false) {
    folder_.file(name, text);
    contact::ProfileSource source;
    source.name = name;
    source.for_track = false;
    return profiles::make_sections(source, wheel, folder_.path("case.toml"));
  }
  TemporaryFolder folder_;
};

TEST_F(SectionList, IsReadInBothForms) {
  const auto rows = read("a.sections",
                         "# position and file\n0 sections/1.txt\n50 sections/2.txt\n"
                         "100 'sections/3.txt'\n");
  const auto slices = read("a.slcs",
                           "% comment\n 0.0 1000.0  U_OFFSET, U_SCALE\n 3 NSLC\n 0 0 0 NFEAT\n"
                           " 1 U_INTPOL\n 0.00 'sections/1.txt'\n 0.05 'sections/2.txt'\n"
                           " 0.10 'sections/3.txt'\n");
  ASSERT_TRUE(rows && slices);
  EXPECT_EQ(rows->sections(), 3u);
  EXPECT_EQ(slices->last(), 100.0);
  EXPECT_NEAR(height_at(*rows, 70.0, 3.0).z, height_at(*slices, 70.0, 3.0).z, 1e-12);
  EXPECT_NEAR(height_at(*rows, 70.0, 0.0).z, -1.2, 1e-6);
}

TEST_F(SectionList, SectionsTooNearForTheirDifferenceAreRefused) {
  const auto refused = [&](const std::string& text) {
    return refusal<contact::InputError>([&] { read("a.sections", text); });
  };
  // 0.5 mm within 0.01 mm: a wall.
  EXPECT_TRUE(says(refused("0 sections/1.txt\n0.01 sections/2.txt\n"), "a.sections: from 0 to 0.01",
                   "0.5 mm", "farther apart"));
  // Measured twice within 0.2 mm, 0.5 mm apart: a natural spline bends by 2.5 mm/mm beside it.
  EXPECT_TRUE(says(refused("0 sections/1.txt\n50 sections/1.txt\n50.2 sections/2.txt\n"
                           "100 sections/2.txt\n"),
                   "from 0 to 50", "mm beyond"));
  // Over a gap of 25 m, before gentle changes, a spline swings by 100 mm, where no wheel is.
  EXPECT_TRUE(read("a.sections",
                   "-25000 sections/1.txt\n0 sections/1.txt\n10 sections/2.txt\n"
                   "20 sections/3.txt\n"));
  // Equal ones may be as near as wanted, and a step within its own length is a step.
  EXPECT_TRUE(read("a.sections", "0 sections/1.txt\n0.001 sections/1.txt\n50 sections/1.txt\n"));
  EXPECT_TRUE(read("a.sections",
                   "0 sections/1.txt\n2 sections/1.txt\n4 sections/2.txt\n"
                   "6 sections/2.txt\n"));
}

/// A wheel of 8 sections, of which every second one is 0.5 mm lower.
std::string octagon(double step = 0.25 * contact::pi) {
  std::string rows;
  for (int k = 0; k < 8; ++k)
    rows += std::to_string(k * step) + " sections/" + std::to_string(1 + k % 2) + ".txt\n";
  return rows;
}

TEST_F(SectionList, OfAWheelClosesIfOnlyAStepIsMissing) {
  const auto open = read("open.sections", octagon(), true);
  EXPECT_EQ(open->sections(), 9u);
  // The end as a user may round it.
  for (const std::string end : {"6.28318531", "6.2832", "6.28"}) {
    const auto closed = read("closed.sections", octagon() + end + " sections/1.txt\n", true);
    EXPECT_EQ(closed->sections(), 9u);
    for (const double angle : {-0.3, 0.0, 0.1, 5.7, 6.1, 6.28, 13.0}) {
      const SurfaceHeight here = height_at(*open, angle, 3.0);
      EXPECT_NEAR(height_at(*closed, angle, 3.0).z, here.z, 1e-12);
      EXPECT_NEAR(height_at(*open, angle - 2.0 * contact::pi, 3.0).z, here.z, 1e-9);
      EXPECT_NEAR(height_at(*open, -angle, 3.0).z, here.z, 1e-4);  // six digits of the angles
    }
    EXPECT_GT(std::abs(height_at(*open, -0.3, 3.0).by_way), 0.1);
  }
}

TEST_F(SectionList, OfPartOfAWheelIsRoundBeyondAndRepeatsAfterATurn) {
  const auto flat =
      read("flat.sections", "-0.1 sections/2.txt\n0 sections/1.txt\n0.1 sections/2.txt\n", true);
  const double round = height_at(*flat, 0.1, 3.0).z;
  for (const double angle : {-0.2, 0.2, 3.1, -3.1, 6.0}) {
    EXPECT_NEAR(height_at(*flat, angle, 3.0).z, round, 1e-12) << angle;
    EXPECT_EQ(height_at(*flat, angle, 3.0).by_way, 0.0);
  }
  for (const double angle : {-0.05, 0.0, 0.07})
    for (const double turns : {-1.0, 1.0, 2.0})
      EXPECT_NEAR(height_at(*flat, angle + 2.0 * contact::pi * turns, 3.0).z,
                  height_at(*flat, angle, 3.0).z, 1e-12);
  EXPECT_GT(height_at(*flat, 0.0, 3.0).z, round + 0.4);
}

}  // namespace
