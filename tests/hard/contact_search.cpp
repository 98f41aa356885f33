// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact search where it is hard: two points at the flange, the conformal gauge corner, worn
// treads; and wheels that have left the rail, profiles that end too early.
#include "track/search/contact_search.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"

namespace {

using track::WheelRailContact;

profiles::ProfileCurve cut(const profiles::ProfileCurve& curve, double first, double last) {
  std::vector<profiles::ProfileKnot> part;
  for (const profiles::ProfileKnot& knot : curve.knots())
    if (knot.y >= first && knot.y <= last) part.push_back(knot);
  return profiles::ProfileCurve(part);
}

/// S1002 with a hollow of 1 mm depth in the tread and a flange 0.5 mm thinner: a formula.
profiles::ProfileCurve worn_wheel() {
  auto knots = profiles::find_built_in_profile("S1002")->make().knots();
  for (profiles::ProfileKnot& knot : knots) {
    const double t = (knot.y - 2.0) / 14.0;
    const double hollow = std::exp(-t * t);
    const double slope = -2.0 * t / 14.0 * hollow;  // of exp(-t^2) by y
    knot.z -= hollow;
    knot.dz -= slope * knot.dy;
  }
  return profiles::ProfileCurve(knots);
}

/// The wheel of every contact that touches first stands on the rail, neither above nor in it.
void expect_touching(const contact::Case& input, const track::SearchScene& scene, bool left) {
  const auto found = find_contacts(input, scene, find_pose(input, scene, 1), 1, left);
  const auto axle = place_axle(found.at(0).pose, input, left);
  // On points 0.02 mm and 0.0005 rad apart the least distance is found to about 2e-5 mm.
  EXPECT_NEAR(
      track::VerticalGap(scene.wheel, input.wheel.rolling_radius, axle, scene.rail(left).head)
          .smallest(),
      0.0, 1e-8);
  const double brute = brute_force_distance(scene, input.wheel.rolling_radius, axle);
  EXPECT_GT(brute, -1e-7) << "shift " << input.wheelset.lateral_shift[0];
  EXPECT_LT(brute, 6e-5) << "shift " << input.wheelset.lateral_shift[0];
}

TEST(FlangeContact, OutlineOfAYawedWheelIsTheWheelItself) {
  for (const double shift : {-10.0, -7.0, -6.0, 3.0}) {
    const contact::Case input = manchester_case(shift, shift * 2.4e-3);
    const auto scene = track::make_search_scene(input, manchester_pair());
    expect_touching(input, scene, true);
  }
}

TEST(FlangeContact, AngleRisesTowardsThatOfTheFlange) {
  // Without yaw the flange of a wheelset pushed to the left climbs; its steepest angle is 70
  // degrees. Every position has its contacts.
  double last = 0.0, largest = 0.0;
  for (double shift = -5.0; shift >= -10.0; shift -= 0.25) {
    const contact::Case input = manchester_case(shift, 0.0);
    const auto found = contacts_of(input);
    ASSERT_GE(found.size(), 1u) << shift;
    const double angle = found[0].place.contact_angle;
    largest = std::max(largest, angle);
    EXPECT_LT(angle, 70.0 * 3.14159265 / 180.0) << shift;
    last = angle;
  }
  EXPECT_GT(largest, 60.0 * 3.14159265 / 180.0);
  EXPECT_GT(last, 0.5);
}

TEST(FlangeContact, PatchesWithDifferentNormalsStayApart) {
  // Tread and flange root touch together near 5 mm; their normals differ by 0.16 rad, and they are
  // 9 mm apart: one contact, unless less is taken for different.
  contact::Case input = manchester_case(-5.0, -0.012);
  EXPECT_EQ(contacts_of(input).at(0).place.patches, 1);
  track::SearchOptions options;
  options.merge_angle = 0.1;
  const auto found = contacts_of(input, true, options);
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found[0].place.patches, 2);
  EXPECT_GT(std::abs(found[0].place.contact_angle - found[1].place.contact_angle), 0.1);
  // The limits lie between them, seen from both sides.
  const WheelRailContact &a = found[0], &b = found[1];
  const double apart = std::abs(a.place.y_track - b.place.y_track);
  for (const WheelRailContact* contact : {&a, &b}) {
    const double nearest = std::min(std::abs(contact->limits[0]), std::abs(contact->limits[1]));
    EXPECT_GT(nearest, 0.1 * apart);
    EXPECT_LT(nearest, apart);
    EXPECT_GT(contact->reach[0], contact->limits[0]);
    EXPECT_LT(contact->reach[1], contact->limits[1]);
  }
}

TEST(GaugeCorner, ConformalContactIsOnePatchOverManyAngles) {
  // Rail radius 13 under the wheel's 13 to 15: at 6 mm the patch is wide for its load.
  contact::Case input = manchester_case(-6.0, -0.0144);
  input.load.vertical_force = 50e3;
  const auto found = contacts_of(input);
  ASSERT_EQ(found[0].place.patches, 1);
  const auto& geometry = found[0].geometry;
  const double turned = std::atan(geometry.rail().at(found[0].reach[1]).slope) -
                        std::atan(geometry.rail().at(found[0].reach[0]).slope);
  EXPECT_GT(std::abs(turned), 0.15);
  // Overlap begins and ends where the distance along the normal is about the approach; on so
  // curved a patch vertical and normal differ.
  for (const double end : found[0].reach)
    EXPECT_NEAR(geometry.distance(0.0, end), found[0].approach, 0.25 * found[0].approach);
  for (double y = found[0].reach[0]; y < found[0].reach[1]; y += 0.05)
    EXPECT_GT(geometry.distance(0.0, y), -1e-6);
}

TEST(WornWheel, TouchesAtTheRimsOfItsHollow) {
  for (const double shift : {-3.0, 0.0, 2.0, 4.0}) {
    const contact::Case input = manchester_case(shift, 0.0);
    const auto scene = track::make_search_scene(input, {worn_wheel(), manchester_pair().rail});
    expect_touching(input, scene, true);
    expect_touching(input, scene, false);
  }
}

template <class Error>
void expect_refused(const contact::Case& input, const track::ProfilePair& pair, bool left,
                    const std::vector<std::string>& parts) {
  const std::string text = refusal<Error>([&] {
    const auto scene = track::make_search_scene(input, pair);
    find_contacts(input, scene, find_pose(input, scene, 1), 1, left);
  });
  EXPECT_TRUE(says(text, parts));
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(Refusal, WheelBesideItsRail) {
  contact::Case input = manchester_case(120.0, 0.0);
  input.wheelset.roll = {0.0};
  expect_refused<contact::SolveError>(
      input, manchester_pair(), true,
      {"lateral_shift = 120 (position 1), left wheel", "not above the rail", "do: check gauge"});
}

TEST(Refusal, WheelOnTheTipOfItsFlange) {
  contact::Case input = manchester_case(40.0, 0.0);
  input.wheelset.roll = {0.0};
  expect_refused<contact::SolveError>(input, manchester_pair(), false,
                                      {"right wheel", "tip of its flange", "do: check gauge"});
}

TEST(Refusal, WheelsetThatFallsBetweenTheRails) {
  contact::Case input = manchester_case(0.0, 0.0);
  input.wheelset.roll = {0.0};
  input.wheelset.flange_back_distance = 1190.0;
  expect_refused<contact::InputError>(input, manchester_pair(), true,
                                      {"field-side end of the wheel profile", "do: "});
}

TEST(Refusal, RailProfileThatEndsBeforeTheContact) {
  const auto pair = manchester_pair();
  contact::Case input = manchester_case(2.0, 0.0);
  input.wheelset.roll = {0.0};
  expect_refused<contact::InputError>(
      input, {pair.wheel, cut(pair.rail, -100.0, 1.0)}, true,
      {"first touch at the field-side end of the rail profile", "longer rail profile"});
}

TEST(Refusal, ProfileThatEndsWithinThePatch) {
  const auto pair = manchester_pair();
  contact::Case input = manchester_case(2.0, 0.0);
  input.wheelset.roll = {0.0};
  input.load.vertical_force = 100e3;
  expect_refused<contact::InputError>(
      input, {cut(pair.wheel, -100.0, 12.0), pair.rail}, true,
      {"under its load the patch reaches the field-side end of the wheel profile"});
}

TEST(Refusal, BothWheelsMustFindTheirRails) {
  contact::Case input = manchester_case(90.0, 0.0);
  EXPECT_TRUE(says(refusal<std::exception>([&] {
                     find_contacts(input, track::make_search_scene(input, manchester_pair()), 1);
                   }),
                   "do: "));
}

}  // namespace
