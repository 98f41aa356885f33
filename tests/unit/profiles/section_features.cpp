// SPDX-License-Identifier: LGPL-2.1-or-later
// Features of sections that are found, and parts of sections that begin or end within the list.
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

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double radius = 8.0, flank = 70.0 * contact::pi / 180.0;

/// A chain of straight lines and tangent arcs, walked by arc length with exact derivatives.
class Chain {
 public:
  Chain(double y, double z, double angle) : y_(y), z_(z), angle_(angle) { add(); }
  Chain& straight(double length) { return go(length, 0.0); }
  Chain& arc(double of_radius, double to) {
    return go(of_radius * std::abs(to - angle_), to - angle_);
  }
  profiles::ProfileCurve curve() const { return profiles::ProfileCurve(knots_); }

 private:
  void add() { knots_.push_back({length_, y_, z_, std::cos(angle_), std::sin(angle_)}); }
  Chain& go(double length, double turn) {
    const int steps = std::max(2, static_cast<int>(std::ceil(length / 0.2)));
    for (int k = 0; k < steps; ++k) {
      const double half = 0.5 * turn / steps, way = length / steps;
      const double chord = half == 0.0 ? way : way * std::sin(half) / half;
      y_ += chord * std::cos(angle_ + half);
      z_ += chord * std::sin(angle_ + half);
      angle_ += 2.0 * half;
      length_ += way;
      add();
    }
    return *this;
  }
  double y_, z_, angle_, length_ = 0.0;
  std::vector<profiles::ProfileKnot> knots_;
};

/// A level head from y = 0 to `width`, then its rounded edge and a flank.
Chain head(double width) {
  return Chain(0.0, 0.0, 0.0).straight(width).arc(radius, flank).straight(12.0);
}

/// Floor from y = 0 and another head beyond it, whose crown begins 40 mm on.
Chain& with_second_head(Chain& chain) {
  return chain.arc(radius, 0.0)
      .straight(20.0)
      .arc(radius, -flank)
      .straight(12.0)
      .arc(radius, 0.0)
      .straight(30.0);
}

std::vector<PlacedSection> placed(const std::vector<profiles::ProfileCurve>& curves) {
  std::vector<PlacedSection> sections;
  for (const auto& curve : curves)
    sections.push_back({10.0 * static_cast<double>(sections.size()), curve, {}});
  return sections;
}

TEST(SectionFeatures, AreTheMiddlesOfBendsAtWhichTheSurfaceStaysExact) {
  // The edge moves sideways by 1:5.
  std::vector<PlacedSection> sections =
      placed({head(30.0).curve(), head(32.0).curve(), head(34.0).curve(), head(36.0).curve()});
  profiles::find_features(sections);
  for (const PlacedSection& section : sections) {
    ASSERT_EQ(section.features.size(), 1u);
    // From 30 to 60 degrees of the arc.
    const double width = 30.0 + 0.2 * section.position;
    EXPECT_NEAR(section.features[0], width + radius * contact::pi / 4.0, 1e-5);
  }
  const SectionSurface surface(sections, SectionSpline::through);
  const profiles::ProfileCurve between = head(33.0).curve();
  for (const double y : {31.0, 34.0, 37.0, 40.0}) {
    SurfaceHeight found;
    ASSERT_TRUE(surface.height(15.0, y, 33.0, found)) << y;
    // The joints of the arc move in their parts by a little.
    EXPECT_NEAR(found.z, between.at(between.parameter_at(y)).z, 2e-3) << y;
  }
}

TEST(SectionFeatures, KinksAreFeatures) {
  // Of 27 degrees.
  std::vector<profiles::ProfileKnot> knots;
  for (double y = -20.0; y <= 20.0; y += 1.0)
    knots.push_back({y, y, std::max(0.0, 0.5 * (y - 3.0)), 1.0, y > 3.0 ? 0.5 : 0.0});
  std::vector<PlacedSection> sections =
      placed({profiles::ProfileCurve(knots), profiles::ProfileCurve(knots)});
  profiles::find_features(sections);
  EXPECT_EQ(sections[0].features, std::vector<double>{3.0});
}

TEST(SectionFeatures, AHeadThatBeginsIsComparedByPlace) {
  Chain both = head(30.0);
  with_second_head(both);
  // Only the second one, from the middle of its groove on.
  Chain second = Chain(both.curve().at(30.0).y + 30.0, 12.0, 0.0);
  second.straight(12.0).arc(radius, -flank).straight(12.0).arc(radius, 0.0).straight(30.0);
  std::vector<PlacedSection> sections =
      placed({second.curve(), second.curve(), both.curve(), both.curve()});
  profiles::find_features(sections);
  ASSERT_EQ(sections[2].features.size(), 4u);
  for (const std::size_t k : {0u, 1u}) EXPECT_TRUE(std::isnan(sections[0].features[k]));
  for (const std::size_t k : {2u, 3u}) EXPECT_FALSE(std::isnan(sections[0].features[k]));
  const SectionSurface surface(sections, SectionSpline::through);
  EXPECT_TRUE(surface.exists(20.0, 10.0) && surface.exists(99.0, 10.0));
  EXPECT_FALSE(surface.exists(19.9, 10.0) || surface.exists(-5.0, 10.0));
}

TEST(SectionFeatures, WithoutACorrespondenceThereAreNone) {
  const Chain rise = Chain(0.0, 0.0, 0.0).straight(30.0).arc(radius, -flank).straight(12.0);
  std::vector<PlacedSection> sections = placed({head(30.0).curve(), rise.curve()});
  EXPECT_TRUE(says(profiles::find_features(sections),
                   "the 1 bends and kinks of the section at 10 do not correspond",
                   "give the arc lengths"));
  // Points correspond by the fraction of the arc length.
  const SectionSurface surface(sections, SectionSpline::through);
  const double length = sections[0].curve.last() - sections[0].curve.first();
  const profiles::ProfilePoint a = sections[0].curve.at(0.3 * length),
                               b = sections[1].curve.at(0.3 * rise.curve().last());
  EXPECT_NEAR(surface.at(5.0, 0.3 * length).z, 0.5 * (a.z + b.z), 0.02);
}

/// z = 1 - 0.02 u on y < 0, which begins at u = 20; 0.01 u beyond it.
std::vector<PlacedSection> beginning_head() {
  std::vector<PlacedSection> sections;
  for (const double u : {0.0, 10.0, 20.0, 30.0, 45.0}) {
    const auto height = [u](double y) { return y < 0.0 ? 1.0 - 0.02 * u : 0.01 * u; };
    std::vector<profiles::ProfileKnot> knots;
    for (double y = u < 20.0 ? 0.5 : -30.0; y <= 30.0; y += 0.5)
      knots.push_back({y, y, height(y), 1.0, 0.0});
    sections.push_back({u, profiles::ProfileCurve(knots), {u < 20.0 ? missing : 0.5, 10.0}});
  }
  return sections;
}

TEST(SectionParts, AHeadExistsFromTheFirstSectionThatHasIt) {
  const SectionSurface surface(beginning_head(), SectionSpline::through);
  SurfaceHeight found;
  for (const double u : {20.0, 22.0, 37.0, 45.0}) {
    ASSERT_TRUE(surface.height(u, -12.0, -12.0, found)) << u;
    // As straight as its sections: it does not know of those before it.
    EXPECT_NEAR(found.z, 1.0 - 0.02 * u, 1e-12) << u;
    EXPECT_NEAR(found.by_way, -0.02, 1e-12) << u;
  }
  EXPECT_TRUE(surface.height(90.0, -12.0, -12.0, found));
  EXPECT_FALSE(surface.height(19.9, -12.0, -12.0, found));
  EXPECT_FALSE(surface.height(-5.0, -12.0, -12.0, found));
  for (const double u : {-5.0, 5.0, 19.0, 33.0}) {
    ASSERT_TRUE(surface.height(u, 15.0, 15.0, found)) << u;
    EXPECT_NEAR(found.z, 0.01 * std::max(u, 0.0), 1e-12) << u;
  }
  EXPECT_NEAR(surface.section(5.0).at(surface.section(5.0).first()).y, 0.5, 2e-4);
  EXPECT_NEAR(surface.section(25.0).at(surface.section(25.0).first()).y, -30.0, 1e-9);
}

TEST(SectionParts, WrongOnesAreRefused) {
  const auto refused = [](std::vector<PlacedSection> sections, double turn = 0.0) {
    return refusal<std::invalid_argument>(
        [&] { SectionSurface(std::move(sections), SectionSpline::through, turn); });
  };
  std::vector<PlacedSection> again = beginning_head();
  again[3].features = {missing, 10.0};
  EXPECT_TRUE(says(refused(again), "begins again"));
  std::vector<PlacedSection> apart = beginning_head();
  for (PlacedSection& section : apart)
    section.features = section.position < 20.0 ? std::vector{missing, missing, 10.0}
                                               : std::vector{-10.0, missing, missing};
  EXPECT_TRUE(says(refused(apart), "no part in common"));
  for (PlacedSection& section : apart) section.features = {5.0, missing, 10.0};
  EXPECT_TRUE(says(refused(apart), "no section has two neighbouring features"));
  EXPECT_TRUE(says(refused(beginning_head(), 45.0), "around a wheel"));
}

TEST(SectionParts, AHyphenStandsForAFeatureThatASectionLacks) {
  TemporaryFolder folder;
  for (const int k : {1, 2, 3}) {
    std::string rows;
    for (double y = k == 1 ? 0.0 : -36.0; y <= 36.0; y += 0.5)
      rows += std::to_string(y) + " " + std::to_string(0.002 * y * y) + "\n";
    folder.file(std::to_string(k) + ".txt", rows);
  }
  folder.file("a.sections", "0 1.txt - 20\n10 2.txt 36 56.5\n20 3.txt 36 56.5\n");
  contact::ProfileSource source;
  source.name = "a.sections";
  source.for_track = false;
  const auto surface = profiles::make_sections(source, false, folder.path("case.toml"));
  SurfaceHeight found;
  EXPECT_FALSE(surface->height(5.0, -20.0, 10.0, found));
  ASSERT_TRUE(surface->height(5.0, 10.0, 45.0, found));
  EXPECT_NEAR(found.z, 0.2, 1e-2);
  ASSERT_TRUE(surface->height(15.0, -20.0, 10.0, found));
  EXPECT_NEAR(found.z, 0.8, 1e-6);
}

/// Slices of CONTACT whose first section begins where the second one has its second feature.
std::shared_ptr<const SectionSurface> sliced(const std::string& first, const std::string& second) {
  TemporaryFolder folder;
  for (const int k : {1, 2}) {
    std::string rows;
    for (double y = k == 1 ? 0.0 : -36.0; y <= 36.0; y += 0.5) rows += std::to_string(y) + " 0.0\n";
    folder.file(std::to_string(k) + ".txt", rows);
  }
  folder.file("a.slcs", "0.0 1.0\n 2\n 4 0 0\n 1\n 0.0 '1.txt'\n 10.0 '2.txt'\n 0.0 " + first +
                            "\n 10.0 " + second + "\n");
  contact::ProfileSource source;
  source.name = "a.slcs";
  source.for_track = false;
  return profiles::make_sections(source, false, folder.path("case.toml"));
}

TEST(SectionParts, SlicesMarkWhatIsMissingAndTheEnd) {
  // Features of the second: its start, y = 0, y = 20 and its end.
  for (const char* first : {"-1 0.0 20.0 36.0", "-1 0.0 20.0 999.", "-1 -1 20.0 999."}) {
    const auto surface = sliced(first, "0.0 36.0 56.0 999.");
    SurfaceHeight found;
    EXPECT_FALSE(surface->height(5.0, -20.0, 10.0, found)) << first;
    ASSERT_TRUE(surface->height(5.0, 10.0, 45.0, found)) << first;
    // The part from y = 0 to 20 is straight along the way.
    EXPECT_NEAR(surface->at(0.0, 46.0).y, surface->at(10.0, 46.0).y, 1e-6) << first;
  }
}

TEST(SectionParts, FeaturesMustIncrease) {
  for (const char* wrong : {"0.0 20.0 10.0 36.0", "0.0 -3.0 10.0 36.0", "0.0 20.0 20.0 36.0"})
    EXPECT_TRUE(says(refusal<contact::InputError>([&] { sliced(wrong, "0.0 36.0 56.0 72.0"); }),
                     "a.slcs:7: the features of a section must lie within it and increase"))
        << wrong;
}

}  // namespace
