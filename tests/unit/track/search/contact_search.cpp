// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact search against closed forms: spheres on cylinders, humps of known height, mirror images.
#include "track/search/contact_search.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"

namespace {

using track::WheelRailContact;

constexpr double radius = 460.0, rail_radius = 80.0;

/// A load so small that the patch is a point.
contact::Case light_case(double shift, double yaw) {
  contact::Case input = manchester_case(shift, yaw);
  input.load = {};
  input.load.approach = 1e-7;
  input.track.inclination = 0.0;
  return input;
}

/// Middle of the rail's circle in the side frame: its face at 14 mm is 717.5 from the middle.
const double rail_middle =
    717.5 + std::sqrt(rail_radius * rail_radius - std::pow(rail_radius - 14.0, 2));

class SphereOnCylinder : public ::testing::TestWithParam<std::array<double, 3>> {
 protected:
  SphereOnCylinder() { input_.wheelset.roll = {roll_}; }

  const double shift_ = GetParam()[0], yaw_ = GetParam()[1], roll_ = GetParam()[2];
  contact::Case input_ = light_case(shift_, yaw_);
  const track::SearchScene scene_ =
      track::make_search_scene(input_, sphere_on_cylinder(radius, rail_radius));
};

TEST_P(SphereOnCylinder, TouchesOnTheLineBetweenTheCentres) {
  for (const bool left : {true, false}) {
    const auto found = contacts_of(input_, scene_, left);
    ASSERT_EQ(found.size(), 1u);
    const WheelRailContact& contact = found[0];
    // Centre of the sphere in the side frame.
    const double sign = left ? -1.0 : 1.0;
    const double centre = sign * shift_ + 750.0 * std::cos(yaw_) * std::cos(roll_);
    const double sine = (rail_middle - centre) / (radius + rail_radius);
    const double angle = std::asin(sine);
    EXPECT_NEAR(contact.place.contact_angle, angle, 1e-8);
    EXPECT_NEAR(contact.place.y_track, sign * (rail_middle - rail_radius * sine), 1e-5);
    EXPECT_NEAR(contact.place.y_rail, -rail_radius * sine, 1e-5);
    EXPECT_NEAR(contact.origin[0], -sign * 750.0 * std::sin(yaw_) * std::cos(roll_), 1e-4);
    // Distance of the contact from the axle, whose angle against the normal is known.
    const double along =
        std::cos(yaw_) * std::cos(roll_) * -sine - sign * std::sin(roll_) * std::cos(angle);
    EXPECT_NEAR(contact.place.rolling_radius, radius * std::sqrt(1.0 - along * along), 1e-5);
    EXPECT_NEAR(contact.place.separation, 0.0, 1e-9);
  }
}

TEST_P(SphereOnCylinder, AroundTheOverlapTheProfilesAreTheSame) {
  track::SearchOptions around;
  around.around_overlap = 12.0;
  for (const bool left : {true, false}) {
    const auto whole = contacts_of(input_, scene_, left),
               part = contacts_of(input_, scene_, left, around);
    ASSERT_EQ(part.size(), 1u);
    EXPECT_LT(part[0].geometry.rail().last() - part[0].geometry.rail().first(), 30.0);
    for (const double y : {-11.0, -3.0, 0.0, 5.0, 11.0}) {
      EXPECT_TRUE(part[0].geometry.known(y));
      EXPECT_EQ(part[0].geometry.distance(4.0, y), whole[0].geometry.distance(4.0, y));
    }
  }
}

TEST_P(SphereOnCylinder, DistanceInThePatchFrameIsThatOfSphereAndCylinder) {
  for (const bool left : {true, false}) {
    const auto found = contacts_of(input_, scene_, left);
    ASSERT_EQ(found.size(), 1u);
    for (const double x : {0.0, 6.0, -4.0})
      for (const double y : {-8.0, 0.0, 5.0}) {
        const double exact = radius - std::sqrt(radius * radius - x * x - y * y) + rail_radius -
                             std::sqrt(rail_radius * rail_radius - y * y);
        EXPECT_NEAR(found[0].geometry.distance(x, y), exact, 1e-6) << x << ' ' << y;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, SphereOnCylinder,
                         ::testing::Values(std::array{0.0, 0.0, 0.0}, std::array{3.0, 0.0, 0.0},
                                           std::array{-5.0, 0.02, 0.0},
                                           std::array{4.0, -0.05, 0.01}));

TEST(Roll, IsFoundSuchThatBothSpheresTouch) {
  // Spheres about the ends of the axle: the centres stand on circles about the rails' middles.
  const contact::Case input = light_case(6.0, 0.0);
  const auto scene = track::make_search_scene(input, sphere_on_cylinder(radius, rail_radius));
  const track::WheelsetPose pose = find_pose(input, scene, 1);
  const double reach = radius + rail_radius;
  const auto height = [&](double sign) {
    const double y = sign * 6.0 + 750.0 * std::cos(pose.roll) - rail_middle;
    return std::sqrt(reach * reach - y * y) - rail_radius + sign * 750.0 * std::sin(pose.roll);
  };
  EXPECT_GT(std::abs(pose.roll), 1e-5);
  EXPECT_NEAR(height(-1.0), height(1.0), 1e-8);
}

TEST(Origin, AWheelMeasuredFromTheBackOfItsFlangeIsPlacedTheSame) {
  // From the tread to the flange, and one that has climbed onto its tip.
  for (const double shift : {0.0, -6.0, 9.0, 24.0}) {
    const contact::Case given = manchester_case(shift, 0.01);
    contact::Case from_back = given;
    from_back.wheelset.flange_back_position = 0.0;
    track::ProfilePair pair = manchester_pair();
    const auto scene = track::make_search_scene(given, pair);
    pair.wheel = pair.wheel.moved(0.0, 70.0, 0.0);
    const auto scene_from_back = track::make_search_scene(from_back, pair);
    for (const bool left : {true, false}) {
      if (shift > 20.0 && !left) {
        const auto message = [](const contact::Case& input, const track::SearchScene& of) {
          return refusal<contact::SolveError>([&] {
            track::WheelsetPose pose{24.0, 0.0, 0.0, 0.0};
            touching_gap(input, of, pose, 1, false);
          });
        };
        EXPECT_TRUE(says(message(given, scene), "on the tip of its flange"));
        EXPECT_TRUE(says(message(from_back, scene_from_back), "on the tip of its flange"));
      }
      if (shift > 20.0) continue;
      const auto one = contacts_of(given, scene, left);
      const auto other = contacts_of(from_back, scene_from_back, left);
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_NEAR(other[k].place.y_wheel, one[k].place.y_wheel + 70.0, 1e-7);
        EXPECT_NEAR(other[k].place.y_track, one[k].place.y_track, 1e-7);
        EXPECT_NEAR(other[k].place.contact_angle, one[k].place.contact_angle, 1e-9);
        EXPECT_NEAR(other[k].place.rolling_radius, one[k].place.rolling_radius, 1e-7);
        EXPECT_NEAR(other[k].place.roll, one[k].place.roll, 1e-12);
      }
    }
  }
}

TEST(Mirror, RightWheelIsTheMirrorImageOfTheLeftOne) {
  const contact::Case input = manchester_case(3.3, 0.008);
  const contact::Case mirrored = manchester_case(-3.3, -0.008);
  const auto scene = track::make_search_scene(input, manchester_pair());
  const auto left = contacts_of(input, scene, true);
  const auto right = contacts_of(mirrored, scene, false);
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t k = 0; k < left.size(); ++k) {
    const auto &a = left[k].place, &b = right[k].place;
    EXPECT_NEAR(a.y_track, -b.y_track, 1e-7);
    EXPECT_NEAR(a.roll, -b.roll, 1e-12);
    EXPECT_NEAR(a.height, b.height, 1e-8);
    EXPECT_NEAR(a.contact_angle, b.contact_angle, 1e-9);
    EXPECT_NEAR(a.y_wheel, b.y_wheel, 1e-7);
    EXPECT_NEAR(left[k].reach[0], -right[k].reach[1], 1e-6);
    EXPECT_NEAR(left[k].origin[0], right[k].origin[0], 1e-7);
    for (const double x : {-5.0, 0.0, 3.0})
      for (const double y : {-6.0, 0.0, 2.0})
        EXPECT_NEAR(left[k].geometry.distance(x, y), right[k].geometry.distance(x, -y), 1e-8);
  }
}

/// A rail with two humps 10 mm apart and a valley of `depth` between, under a cylinder.
track::ProfilePair two_humps(double depth) {
  const auto z = [=](double y) { return depth * std::pow(y * y / 25.0 - 1.0, 2); };
  const auto slope = [=](double y) { return depth * 4.0 * y / 25.0 * (y * y / 25.0 - 1.0); };
  return {profile_of([](double) { return 0.0; }, [](double) { return 0.0; }, -70.0, 80.0),
          profile_of(z, slope, -40.0, 40.0)};
}

TEST(Patches, TwoHumpsAreOneContactWhetherTheyMeetOrNot) {
  constexpr double depth = 0.03;
  contact::Case input = light_case(0.0, 0.0);
  input.wheelset.roll = {0.0};
  const auto scene = track::make_search_scene(input, two_humps(depth));
  const double middle = scene.rail(true).place.shift_y;
  for (const double share : {0.5, 1.5}) {
    input.load.approach = share * depth;
    const auto found = contacts_of(input, scene, true);
    ASSERT_EQ(found.size(), 1u) << share;
    EXPECT_EQ(found[0].touching.size(), 2u);
    EXPECT_NEAR(std::abs(found[0].place.y_track), middle, 1e-6);
    EXPECT_NEAR(found[0].place.contact_angle, 0.0, 1e-7);
    // Where z = share depth: y^2 = 25 (1 +- sqrt(share)).
    EXPECT_NEAR(found[0].reach[1], 5.0 * std::sqrt(1.0 + std::sqrt(share)), 1e-4);
    EXPECT_NEAR(found[0].reach[0], -found[0].reach[1], 1e-6);
    EXPECT_NEAR(found[0].geometry.distance(0.0, 0.0), depth, 1e-9);
    EXPECT_NEAR(found[0].geometry.distance(0.0, 5.0), 0.0, 1e-9);
    EXPECT_TRUE(std::isinf(found[0].limits[0]) && std::isinf(found[0].limits[1]));
  }
}

TEST(Patches, HumpsOfOtherNormalsAreContactsWithLimits) {
  constexpr double depth = 0.03;
  contact::Case input = light_case(0.0, 0.0);
  input.wheelset.roll = {0.0};
  input.load.approach = 0.5 * depth;
  const auto scene = track::make_search_scene(input, two_humps(depth));
  track::SearchOptions options;
  options.merge_angle = -1.0;  // nothing is alike
  const auto found = contacts_of(input, scene, true, options);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place.patches, 2);
  const double middle = scene.rail(true).place.shift_y;
  EXPECT_NEAR(std::abs(-found[0].place.y_track + found[0].touching[0][0] - middle), 5.0, 1e-4);
  const double inner = 5.0 * std::sqrt(1.0 - std::sqrt(0.5));
  const double outer = 5.0 * std::sqrt(1.0 + std::sqrt(0.5));
  EXPECT_NEAR(found[0].reach[1] - found[0].reach[0], outer - inner, 1e-4);
  for (const WheelRailContact& contact : found) {
    EXPECT_TRUE(std::isinf(contact.limits[0]) != std::isinf(contact.limits[1]));
    const double limit = std::isinf(contact.limits[0]) ? contact.limits[1] : contact.limits[0];
    EXPECT_FALSE(contact.geometry.within_limits(limit + (limit > 0.0 ? 0.1 : -0.1)));
    EXPECT_TRUE(contact.geometry.within_limits(0.0));
    EXPECT_NEAR(std::abs(limit), 5.0, 0.2);  // half way to the other hump
  }
}

TEST(Patches, PlaneIsThatOfTheWholeOverlap) {
  // A hump of one radius up to its top and of another beyond: the reference is off the top, and the
  // plane has the mean slope of the surfaces midway, here half of the rail's.
  const auto z = [](double y) { return y * y / (y < 0.0 ? 100.0 : 600.0); };
  const auto slope = [](double y) { return 2.0 * y / (y < 0.0 ? 100.0 : 600.0); };
  const track::ProfilePair pair{
      profile_of([](double) { return 0.0; }, [](double) { return 0.0; }, -70.0, 80.0),
      profile_of(z, slope, -45.0, 45.0)};
  contact::Case input = light_case(0.0, 0.0);
  input.wheelset.roll = {0.0};
  input.load.approach = 0.06;
  const auto scene = track::make_search_scene(input, pair);
  const auto found = contacts_of(input, scene, true);
  ASSERT_EQ(found.size(), 1u);
  // Depth^2.5 over 0.06 - z: mean place and slope of one side by Beta functions.
  const double left = std::sqrt(0.06 * 100.0), right = std::sqrt(0.06 * 600.0);
  const double zeroth = 0.5 * std::sqrt(3.14159265358979) * std::tgamma(3.5) / std::tgamma(4.0);
  const double first = 0.5 / 3.5;
  const double weight = (left + right) * zeroth;
  const double place = (right * right - left * left) * first / weight;
  const double mean_slope =
      0.5 * (2.0 / 600.0 * right * right - 2.0 / 100.0 * left * left) * first / weight;
  EXPECT_NEAR(-found[0].place.y_track - scene.rail(true).place.shift_y, place, 1e-3);
  EXPECT_NEAR(found[0].place.contact_angle, -std::atan(mean_slope), 1e-6);
}

TEST(Patches, HumpThatDoesNotTouchIsANearMissWithItsSeparation) {
  contact::Case input = light_case(0.0, 0.0);
  constexpr double roll = 2e-3;  // lifts the humps' common tangent by 10 roll across them
  input.wheelset.roll = {roll};
  input.load.approach = 0.005;
  const auto scene = track::make_search_scene(input, two_humps(0.03));
  const auto found = contacts_of(input, scene, true);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place.patch, 1);
  EXPECT_EQ(found[0].place.patches, 1);
  EXPECT_EQ(found[1].place.patch, 0);
  // Humps are stationary: their heights change by roll * 5 each, and by half the square of the
  // change of slope over the curvature, which is the same for both.
  EXPECT_NEAR(found[1].place.separation, 10.0 * roll, 1e-4);
  EXPECT_EQ(found[1].normal_force, 0.0);
  track::SearchOptions options;
  options.near_miss = 0.01;
  EXPECT_EQ(contacts_of(input, scene, true, options).size(), 1u);
}

TEST(Load, EstimateIsCloseToHertzForASphereOnACylinder) {
  // Equal radii 460: a sphere of radius 460 on a plane has R = 460 both ways.
  contact::Case input = light_case(0.0, 0.0);
  const auto flat = track::ProfilePair{
      sphere_on_cylinder(radius, rail_radius).wheel,
      profile_of([](double y) { return 2e-7 * std::pow(y, 5) * y / 40.0; },
                 [](double y) { return 12e-7 * std::pow(y, 5) / 40.0; }, -45.0, 45.0)};
  const auto scene = track::make_search_scene(input, flat);
  input.load = {};
  input.load.vertical_force = 10e3;
  const auto found = contacts_of(input, scene, true);
  ASSERT_FALSE(found.empty());
  const double modulus = 2.0 * 1.28 * 82000.0 / (2.0 * (1.0 - 0.28 * 0.28));
  const double hertz = std::cbrt(9.0 * 1e8 / (16.0 * radius * modulus * modulus));
  EXPECT_NEAR(found[0].approach, hertz, 0.05 * hertz);
  EXPECT_NEAR(found[0].normal_force, 10e3, 1e-3);
}

}  // namespace
