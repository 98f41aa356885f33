// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels on rollers and in rings, and poses without a gauge, against closed forms: spheres touch on
// the line between their centres, whatever their axles; a roller of endless radius is a rail.
#include "scene/geometry.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

using contact::Vector3;

constexpr double wheel_radius = 300.0, roller_radius = 500.0;

/// A wheel at a position on a rail at `lateral` from the middle of the track, with a load so small
/// that the patch is a point.
contact::Case light_case(double lateral, double yaw, double roll) {
  contact::Case input = manchester_case(0.0, yaw);
  input.load = {};
  input.load.approach = 1e-7;
  input.wheel.rolling_radius = wheel_radius;
  input.rail.rolling_radius = roller_radius;
  input.track.inclination = 0.0;
  input.track.rail_position = {750.0 + lateral, 0.0};
  input.wheelset.roll = {roll};
  input.wheelset.side = contact::WheelSide::both;
  return input;
}

/// Heights of a sphere about (0, 0), z down: of a wheel below its axle, or of a roller above it.
profiles::ProfileCurve sphere(double radius, bool wheel) {
  const double sign = wheel ? 1.0 : -1.0;
  return profile_of([=](double y) { return sign * (std::sqrt(radius * radius - y * y) - radius); },
                    [=](double y) { return -sign * y / std::sqrt(radius * radius - y * y); }, -70.0,
                    70.0);
}

track::ProfilePair two_spheres() {
  return {sphere(wheel_radius, true), sphere(roller_radius, false)};
}

class SphereOnRoller : public ::testing::TestWithParam<std::array<double, 3>> {
 protected:
  const double lateral_ = GetParam()[0], yaw_ = GetParam()[1], roll_ = GetParam()[2];
  contact::Case input_ = light_case(lateral_, yaw_, roll_);
  const track::SearchScene scene_ = track::make_search_scene(input_, two_spheres());
  void expect_on_the_line_between_the_centres(const track::SearchScene& scene);
};

void SphereOnRoller::expect_on_the_line_between_the_centres(const track::SearchScene& scene) {
  for (const bool left : {true, false}) {
    const auto found = contacts_of(input_, scene, left);
    ASSERT_EQ(found.size(), 1u);
    const track::WheelRailContact& contact = found[0];
    const double sign = left ? -1.0 : 1.0, middle = 750.0;
    // Centre of the wheel relative to that of the roller, x and y of the side frame.
    const double x = -sign * middle * std::sin(yaw_) * std::cos(roll_);
    const double y = middle * std::cos(yaw_) * std::cos(roll_) - (750.0 + lateral_);
    const double both = wheel_radius + roller_radius;
    const Vector3 up{x / both, sign * y / both, -std::sqrt(1.0 - (x * x + y * y) / both / both)};
    EXPECT_NEAR(contact.origin[0], roller_radius * up[0], 1e-5);
    EXPECT_NEAR(contact.origin[1], sign * (750.0 + lateral_) + roller_radius * up[1], 1e-5);
    EXPECT_NEAR(contact.origin[2], roller_radius * (1.0 + up[2]), 1e-5);
    // Sections are searched every 0.1 mm across.
    const double slopes = scene.varies() ? 2e-7 : 1e-8;
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(contact.normal[d], up[d], slopes);
    EXPECT_NEAR(contact::dot(contact.along, contact.normal), 0.0, 1e-14);
    EXPECT_NEAR(contact.along[1], 0.0, 1e-14);
    const contact::Curvatures curved =
        contact::relative_curvatures(make_scenes(input_, scene)[left ? 0 : 1].scene.geometry);
    const double expected = 0.5 / wheel_radius + 0.5 / roller_radius;
    // Of surfaces it is a difference over 1 mm.
    EXPECT_NEAR(curved.A, expected, (scene.varies() ? 3e-6 : 1e-7) * expected);
    EXPECT_NEAR(curved.B, expected, 1e-5 * expected);
    // The distance of two spheres along the normal at a place in the tangent plane.
    const double at = std::hypot(3.0, -2.0);
    const double gap = wheel_radius - std::sqrt(wheel_radius * wheel_radius - at * at) +
                       roller_radius - std::sqrt(roller_radius * roller_radius - at * at);
    EXPECT_NEAR(contact.geometry.distance(3.0, -2.0), gap, 1e-8);
  }
}

TEST_P(SphereOnRoller, TouchesOnTheLineBetweenTheCentres) {
  expect_on_the_line_between_the_centres(scene_);
}

TEST_P(SphereOnRoller, OfSectionsTouchesThereToo) {
  input_.wheelset.track_position = {3.0};
  input_.wheelset.wheel_angle = {1.0};
  for (const auto& [rail, wheel] : {std::pair{true, false}, {false, true}, {true, true}}) {
    SCOPED_TRACE(::testing::Message() << rail << wheel);
    track::ProfilePair pair = two_spheres();
    const auto equal = [](const profiles::ProfileCurve& curve) {
      return std::make_shared<const profiles::SectionSurface>(
          std::vector<profiles::PlacedSection>{{-2.0, curve, {}}, {2.0, curve, {}}},
          profiles::SectionSpline::through);
    };
    if (rail) pair.rail_sections = equal(pair.rail);
    if (wheel) pair.wheel_sections = equal(pair.wheel);
    expect_on_the_line_between_the_centres(track::make_search_scene(input_, pair));
  }
}

// Lateral distance in mm, yaw and roll in rad.
INSTANTIATE_TEST_SUITE_P(Poses, SphereOnRoller,
                         ::testing::Values(std::array{0.0, 0.0, 0.0}, std::array{8.0, 0.0, 0.0},
                                           std::array{8.0, 0.02, 0.0},
                                           std::array{-5.0, -0.05, 0.03},
                                           std::array{0.0, 0.1, -0.02}),
                         [](const auto& pose) { return "Pose" + std::to_string(pose.index); });

TEST(Roller, ASphereInARingTouchesBeyondItsCentre) {
  contact::Case input = light_case(6.0, 0.02, 0.0);
  input.rail.rolling_radius = -roller_radius;
  // A hollow sphere about the axle above.
  const auto scene =
      track::make_search_scene(input, {sphere(wheel_radius, true), sphere(roller_radius, true)});
  const track::WheelRailContact contact = contacts_of(input, scene, false).at(0);
  const double x = -750.0 * std::sin(0.02), y = 750.0 * std::cos(0.02) - 756.0;
  const double apart = roller_radius - wheel_radius;
  const Vector3 down{x / apart, y / apart, std::sqrt(1.0 - (x * x + y * y) / apart / apart)};
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(contact.normal[d], -down[d], 1e-8);
  EXPECT_NEAR(contact.origin[0], roller_radius * down[0], 1e-5);
  EXPECT_NEAR(contact.origin[2], roller_radius * (down[2] - 1.0), 1e-5);
  const auto curved = contact::relative_curvatures(make_scenes(input, scene).at(0).scene.geometry);
  const double expected = 0.5 / wheel_radius - 0.5 / roller_radius;
  EXPECT_NEAR(curved.A, expected, 1e-7 * expected);
  EXPECT_NEAR(curved.B, expected, 1e-5 * expected);
}

/// What the comparison of rails and rollers looks at.
std::vector<double> numbers_of(const track::PlacedScene& placed) {
  const contact::ContactPlace& at = *placed.scene.place;
  const contact::Creepage& creepage = placed.scene.points[0].creepage;
  return {at.y_rail,
          at.contact_angle,
          creepage.longitudinal,
          creepage.lateral,
          creepage.spin,
          placed.scene.geometry.surface.profiles->distance(4.0, 1.5)};
}

TEST(Roller, OfEndlessRadiusIsARail) {
  for (const double shift : {0.0, 4.0, 6.5}) {
    contact::Case input = manchester_case(shift, 0.012);
    input.wheelset.side = contact::WheelSide::both;
    const auto at_radius = [&](double radius) {
      input.rail.rolling_radius = radius;
      return make_scenes(input, track::make_search_scene(input, manchester_pair()));
    };
    const auto rail = at_radius(contact::infinity), large = at_radius(1e6), larger = at_radius(2e6);
    ASSERT_EQ(rail.size(), large.size());
    ASSERT_EQ(rail.size(), larger.size());
    for (std::size_t k = 0; k < rail.size(); ++k) {
      const auto a = numbers_of(rail[k]), b = numbers_of(large[k]), c = numbers_of(larger[k]);
      for (std::size_t n = 0; n < a.size(); ++n) {
        EXPECT_NEAR(b[n], a[n], 1e-3) << n;
        EXPECT_NEAR(2.0 * c[n] - b[n], a[n], 1e-6) << n;  // what goes as 1/R is left out
      }
    }
  }
}

TEST(Roller, RigidSlipIsThatOfTwoTurningBodies) {
  contact::Case input = manchester_case(3.0, 0.01);
  input.rail.rolling_radius = 700.0;
  input.wheelset.rotation_change = {0.002};
  input.wheelset.side = contact::WheelSide::both;
  for (const auto& placed :
       make_scenes(input, track::make_search_scene(input, manchester_pair()))) {
    const track::Motion motion = track::motion_of(input, 0.002);
    const contact::ChartedGeometry geometry(placed.scene.geometry, contact::Chart::plane);
    const contact::ContactGrid grid = contact::ContactGrid::centred(3, 5, 2.0, 2.0);
    const contact::TangentialField slip =
        geometry.rigid_slip(placed.scene.points[0].creepage, grid);
    const contact::PatchGeometry& bodies = placed.contact.geometry;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        // Velocity of the wheel's surface less that of the roller's at one place, in first order:
        // each on its own section, half of what the rotation does at the other.
        const double x = grid.x(i), y = grid.y(j);
        const Vector3 wheel =
            track::slip_at(placed.contact, motion, {x, y, bodies.wheel().at(y).value});
        const Vector3 rail =
            track::slip_at(placed.contact, motion, {x, y, bodies.rail().at(y).value});
        const double apart = bodies.wheel().at(y).value - bodies.rail().at(y).value;
        const double turning_of_wheel = 1.002 / 460.0;
        const double along =
            wheel[0] - apart / 700.0;  // the roller's surface is nearer to its axle
        EXPECT_NEAR(slip.x[grid.index(i, j)], along, 1e-6);
        EXPECT_NEAR(slip.x[grid.index(i, j)], rail[0] + apart * turning_of_wheel, 1e-6);
        EXPECT_NEAR(slip.y[grid.index(i, j)], wheel[1], 3e-6);
      }
  }
}

TEST(Displacement, OfTheRailIsTheOppositeOneOfTheWheel) {
  const contact::Case plain = manchester_case(2.0, 0.005);
  contact::Case rail = plain, wheelset = plain;
  for (contact::Case* input : {&rail, &wheelset}) input->wheelset.roll = {0.0003};
  rail.rail_displacement.lateral = {1.5, 1.5};
  rail.rail_displacement.vertical = {-2.0, -2.0};
  wheelset.wheelset.lateral_shift = {0.5};
  for (const bool left : {true, false}) {
    const auto a = contacts_of(rail, left).at(0), b = contacts_of(wheelset, left).at(0);
    EXPECT_NEAR(a.place.y_rail, b.place.y_rail, 1e-9);
    EXPECT_NEAR(a.place.y_wheel, b.place.y_wheel, 1e-9);
    EXPECT_NEAR(a.place.height, b.place.height - 2.0, 1e-10);
    EXPECT_NEAR(a.place.y_track, b.place.y_track + 1.5, 1e-9);
  }
}

TEST(Placement, OfAWheelIsThatOfItsWheelset) {
  for (const double shift : {-7.0, 0.0, 3.0, 6.3})
    for (const bool left : {true, false}) {
      contact::Case input = manchester_case(shift, 0.0);
      const auto scene = track::make_search_scene(input, manchester_pair());
      const auto found = contacts_of(input, scene, left);
      const double sign = left ? -1.0 : 1.0;
      const contact::Axle axle = place_axle(found.at(0).pose, input, left);
      // The same bodies in the frame of a rail profile that is placed as by the gauge.
      track::ProfilePair pair = manchester_pair();
      pair.rail = place_rail(pair.rail, scene.rail(left).place);
      contact::Case alone = input;
      alone.wheelset.on_rail = true;
      alone.wheelset.side = left ? contact::WheelSide::left : contact::WheelSide::right;
      alone.wheelset.lateral_shift = {axle.point[1]};
      alone.wheelset.roll = {sign * found[0].pose.roll};
      const auto placed = contacts_of(alone, track::make_search_scene(alone, pair), left);
      ASSERT_EQ(placed.size(), found.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(placed[k].place.y_wheel, found[k].place.y_wheel, 1e-9);
        EXPECT_NEAR(placed[k].place.contact_angle, found[k].place.contact_angle, 1e-11);
        EXPECT_NEAR(placed[k].normal_force, found[k].normal_force, 1e-6);
        const track::Motion motion = track::motion_of(alone, 0.0);
        const auto a = track::creepage_of(found[k], motion);
        const auto b = track::creepage_of(placed[k], motion);
        EXPECT_NEAR(a.longitudinal, b.longitudinal, 1e-13);
        EXPECT_NEAR(a.lateral, b.lateral, 1e-13);
        EXPECT_NEAR(a.spin, b.spin, 1e-15);
      }
    }
}

}  // namespace
