// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles of arcs and polynomials, and profiles from a case.
#include "base/errors.hpp"
#include "profiles/profiles.hpp"

#include "support/profile_texts.hpp"

namespace rollfem::profiles {
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
    const std::string message =
        refusal<contact::InputError>([&] { make_profile(source, false, "case.toml"); });
    return says(message, "[rail_profile]", "do: ");
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
  EXPECT_NO_THROW(make_profile(source, false, "case.toml"));
  source.name = "polynomial";
  EXPECT_TRUE(refused());
}

TEST(Profiles, NamesThatAreNotKnownAndBodiesThatDoNotFitAreRefused) {
  ProfileSource source;
  for (const char* name : {"S1003", "no/such/file.txt", "60E1"}) {
    source.name = name;
    EXPECT_TRUE(says(refusal<contact::InputError>([&] { make_profile(source, true, "case.toml"); }),
                     "S1002"))
        << name;
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

TEST(Profiles, FreeEndsAreWhereThePointsEndAndSideFacesGoInwards) {
  ProfileSource source;
  source.name = "arcs";
  source.radii = {400.0};
  source.ends = {-8.0, 12.0};
  source.shift = {1.0, 2.0};
  for (const bool wheel : {true, false}) {
    source.free_ends = false;
    const ProfileCurve open = make_profile(source, wheel, "case.toml");
    source.free_ends = true;
    const ProfileCurve whole = make_profile(source, wheel, "case.toml");
    const auto [first, last] = free_ends_of(whole);
    EXPECT_EQ(first.y, open.at(open.first()).y);
    EXPECT_EQ(last.z, open.at(open.last()).z);
    EXPECT_NEAR(last.tangent_z, open.at(open.last()).tangent_z, 1e-12);
    // A face as high as 0.3 times the width of 20 mm, up of a wheel and down of a rail.
    const ProfilePoint end = whole.at(whole.last()), start = whole.at(whole.first());
    const double inwards = wheel ? -1.0 : 1.0;
    EXPECT_NEAR(inwards * (end.z - last.z), 6.0, 0.02);
    EXPECT_NEAR(end.y - last.y, 2.0, 0.02);
    EXPECT_NEAR(inwards * (start.z - first.z), 6.0, 0.02);
    EXPECT_NEAR(end.tangent_z / end.tangent_y, 3.0 * inwards, 1e-9);
    EXPECT_NEAR(start.tangent_z / start.tangent_y, -3.0 * inwards, 1e-9);
    for (const double y : {-6.9, 1.0, 12.9})
      EXPECT_NEAR(whole.at(whole.parameter_at(y)).z, open.at(open.parameter_at(y)).z, 1e-12);
  }
}
}  // namespace rollfem::profiles
